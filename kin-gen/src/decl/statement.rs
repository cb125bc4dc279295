//! The statements of a declaration, apart from its table.

use super::cursor::Cursor;
use super::grammar::last_expr;
use super::lex::{Kind, Token};
use super::nearest::nearest;
use super::{Axis, Binding, Check, Couple, Decl, Expr, Factor, MAX_ROWS, MAX_STATEMENTS, expr};
use crate::report::{Place, Report, Spanned};

const KEYWORDS: [&str; 7] = ["let", "param", "base", "tool", "couple", "check", "ik"];

/// Reads one statement into `decl`, without its `;`. `None` after a mistake that was reported.
pub(super) fn statement(decl: &mut Decl, body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    let place = body.place();
    let word = body.peek().filter(|t| t.kind == Kind::Word).map_or("", |t| t.text.as_str());
    match word {
        "let" | "param" => binding(decl, body, report),
        "base" | "tool" => {
            colon(body, report)?;
            // A lost transform here takes no joint with it.
            let list = factors(body, &mut true, report);
            let known = if word == "base" { &mut decl.base } else { &mut decl.tool };
            if list.is_empty() {
                report.error_help(
                    place,
                    format!("`{word}:` is empty"),
                    "write transforms, such as `Rx(180) Tz(0.5)`",
                );
            } else if !known.is_empty() {
                report.error_help(
                    place,
                    format!("`{word}:` is given twice"),
                    "write all of it in one statement",
                );
            } else {
                *known = list;
            }
            Some(())
        }
        "couple" => couple(decl, body, report),
        "check" => check(decl, body, report),
        "ik" => {
            colon(body, report)?;
            let place = body.place();
            let Some(family) = body.word() else {
                report.error_help(place, "the family is missing after `ik:`", "write `ik: spherical_wrist;`");
                return None;
            };
            let family = Spanned { value: family.text.clone(), place: family.at.into() };
            if decl.demanded.replace(family).is_some() {
                report.error(place, "`ik:` is given twice");
            }
            Some(())
        }
        _ if factor_word(body).is_some() => {
            decl.factors.extend(factors(body, &mut decl.whole, report));
            if decl.factors.len() > MAX_ROWS {
                report.error(place, format!("the chain has more than {MAX_ROWS} factors"));
                decl.factors.truncate(MAX_ROWS);
                decl.whole = false;
            }
            Some(())
        }
        _ => unknown(decl, body, report),
    }
}

fn unknown(decl: &mut Decl, body: &Cursor<'_>, report: &mut Report) -> Option<()> {
    let place = body.place();
    let text = body.peek().map_or("", |t| t.text.as_str());
    let call =
        body.peek().is_some_and(|t| t.kind == Kind::Word) && body.rest().get(1).is_some_and(|t| t.is("("));
    if call {
        decl.whole = false;
        report.error_help(place, format!("`{text}` is not an elementary transform"), TRANSFORMS);
    } else {
        let help = match nearest(text, KEYWORDS) {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                "write a table, transforms, `let`, `param`, `base:`, `tool:`, `couple:`, `check` or `ik:`"
                    .into()
            }
        };
        report.error_help(place, format!("`{text}` does not begin a statement"), help);
    }
    None
}

/// Walks over the keyword and its colon.
fn colon(body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    let word = body.next().map_or("", |t| t.text.as_str());
    let place = body.place();
    if body.eat(":") {
        return Some(());
    }
    report.error(place, format!("a `:` is missing after `{word}`"));
    None
}

fn binding(decl: &mut Decl, body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    let keyword = body.next()?;
    let place = body.place();
    let Some(name) = body.word() else {
        report.error(place, format!("a name is missing after `{}`", keyword.text));
        return None;
    };
    if decl.bindings.len() >= MAX_STATEMENTS {
        report.error(place, format!("there are more than {MAX_STATEMENTS} names"));
        return None;
    }
    let place = body.place();
    let value = if body.eat("=") {
        last_expr(body, report)
    } else {
        report.error(place, format!("a `=` is missing after `{}`", name.text));
        None
    };
    let failed = value.is_none();
    let name = Spanned { value: name.text.clone(), place: name.at.into() };
    decl.bindings.push(Binding { param: keyword.text == "param", name, value });
    if failed { None } else { Some(()) }
}

const TRANSFORMS: &str =
    "the transforms are Rx, Ry, Rz (rotations) and Tx, Ty, Tz (translations), such as `Rz(q)`";

/// The transform that starts here, if one does.
pub(super) fn factor_word<'a>(cursor: &Cursor<'a>) -> Option<(bool, Axis, &'a Token)> {
    let token = cursor.peek().filter(|t| t.kind == Kind::Word)?;
    if !cursor.rest().get(1).is_some_and(|t| t.is("(")) {
        return None;
    }
    let (turn, axis) = match token.text.as_str() {
        "Rx" => (true, Axis::X),
        "Ry" => (true, Axis::Y),
        "Rz" => (true, Axis::Z),
        "Tx" => (false, Axis::X),
        "Ty" => (false, Axis::Y),
        "Tz" => (false, Axis::Z),
        _ => return None,
    };
    Some((turn, axis, token))
}

/// Reads transforms, with or without `*` between them, as far as they go.
fn factors(body: &mut Cursor<'_>, whole: &mut bool, report: &mut Report) -> Vec<Factor> {
    let mut list = Vec::new();
    loop {
        if !list.is_empty() {
            body.eat("*");
        }
        if let Some((turn, axis, token)) = factor_word(body) {
            body.next();
            let Some((inside, place)) = body.group("(", report) else {
                *whole = false;
                return list;
            };
            let argument = expr::whole(inside, report);
            list.push(Factor { turn, axis, argument, place: Place::from(token.at).to(place) });
            continue;
        }
        let unknown =
            body.peek().filter(|t| t.kind == Kind::Word && body.rest().get(1).is_some_and(|t| t.is("(")));
        let Some(token) = unknown else { return list };
        report.error_help(token.at, format!("`{}` is not an elementary transform", token.text), TRANSFORMS);
        *whole = false;
        body.next();
        body.group("(", report);
    }
}

/// `couple: J3 -= J2, J4 += 2*J3`.
fn couple(decl: &mut Decl, body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    colon(body, report)?;
    loop {
        coupling(decl, body, report)?;
        if !body.eat(",") {
            return Some(());
        }
    }
}

fn coupling(decl: &mut Decl, body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    let start = body.place();
    let help = "write it like `couple: J3 -= J2;`";
    let Some(target) = body.word() else {
        report.error_help(start, "the coupled joint is missing", help);
        return None;
    };
    let place = body.place();
    let subtract = body.is("-");
    if !(body.are(&["-", "="]) || body.are(&["+", "="])) {
        report.error_help(place, "`-=` or `+=` is missing here", help);
        return None;
    }
    body.next();
    body.next();
    let value = last_expr(body, report)?;
    if decl.couples.len() >= MAX_STATEMENTS {
        report.error(start, format!("there are more than {MAX_STATEMENTS} couplings"));
        return None;
    }
    let place = start.to(value.place);
    let target = Spanned { value: target.text.clone(), place: target.at.into() };
    decl.couples.push(Couple { target, subtract, value, place });
    Some(())
}

const CHECK: &str = "write it like `check [0, 0] => (x, y, z) zyx(0, 0, 90) within 1e-6;`";

fn check(decl: &mut Decl, body: &mut Cursor<'_>, report: &mut Report) -> Option<()> {
    let start = body.all();
    body.next();
    let place = body.place();
    if !body.is("[") {
        report.error_help(place, "the joint values are missing after `check`", CHECK);
        return None;
    }
    let (inside, joints_place) = body.group("[", report)?;
    let joints: Vec<Option<Expr>> =
        inside.commas().into_iter().map(|part| expr::whole(part, report)).collect();
    let place = body.place();
    if !body.are(&["=", ">"]) {
        report.error_help(place, "`=>` and the expected position are missing here", CHECK);
        return None;
    }
    body.next();
    body.next();
    let position = triple(body, "the position (x, y, z)", report);
    let zyx =
        if body.eat("zyx") { Some(triple(body, "the orientation zyx(α, β, γ)", report)) } else { None };
    let within = if body.eat("within") { Some(last_expr(body, report)) } else { None };
    let joints = joints.into_iter().collect::<Option<Vec<Expr>>>()?;
    let (position, zyx, within) = (position?, transpose(zyx)?, transpose(within)?);
    if decl.checks.len() >= MAX_STATEMENTS {
        report.error(start, format!("there are more than {MAX_STATEMENTS} checks"));
        return None;
    }
    decl.checks.push(Check { joints, position, zyx, within, joints_place, place: start });
    Some(())
}

/// `None` only where something is there and could not be read.
fn transpose<T>(value: Option<Option<T>>) -> Option<Option<T>> {
    match value {
        None => Some(None),
        Some(inner) => inner.map(Some),
    }
}

fn triple(body: &mut Cursor<'_>, what: &str, report: &mut Report) -> Option<[Expr; 3]> {
    let place = body.place();
    if !body.is("(") {
        report.error_help(place, format!("{what} is missing here"), CHECK);
        return None;
    }
    let (inside, place) = body.group("(", report)?;
    let read: Vec<Option<Expr>> = inside.commas().into_iter().map(|part| expr::whole(part, report)).collect();
    let count = read.len();
    let values = read.into_iter().collect::<Option<Vec<Expr>>>()?;
    let triple = <[Expr; 3]>::try_from(values).ok();
    if triple.is_none() {
        report.error_help(place, format!("{what} has {count} values instead of 3"), CHECK);
    }
    triple
}
