//! Tokens to [`Decl`]: the item's shell, its header, and the statements one after the other.
//!
//! ```text
//! item      = { attribute } [visibility] "struct" name "(" convention "," length "," angle ")" ";" { statement }
//! statement = ("let" | "param") name "=" expr ";"          table = row { row }      (no ";": it ends by itself)
//!           | factor { factor } ";"                        row   = "|" { cell "|" }
//!           | ("base" | "tool") ":" factor { factor } ";"  factor = ("R" | "T") axis "(" expr ")"
//!           | "couple" ":" coupling { "," coupling } ";"
//!                                                          coupling = joint ("+" | "-") "=" expr
//!           | "check" "[" exprs "]" "=" ">" "(" exprs ")" ["zyx" "(" exprs ")"] ["within" expr] ";"
//!           | "ik" ":" family ";"
//! ```

use super::cursor::Cursor;
use super::lex::{Kind, Token};
use super::nearest::nearest;
use super::{AngleUnit, Decl, Form, LengthUnit, MAX_TOKENS, Unit, expr, statement, table};
use crate::report::{At, Place, Report, Spanned};

/// After so many mistakes more messages help nobody.
const MAX_FAILURES: usize = 100;

const SHELL: &str = "write `struct Name(modified, mm, deg);` with your convention and units";

/// Reads one declaration. `None` only if it has no name; every mistake is in the report, and what could be read is in
/// the [`Decl`] all the same.
pub fn parse(tokens: &[Token], report: &mut Report) -> Option<Decl> {
    let last = tokens.last().map_or(At(0), |t| t.at);
    if tokens.len() > MAX_TOKENS {
        let over = tokens.get(MAX_TOKENS).map_or(last, |t| t.at);
        report.error(over, format!("the declaration is longer than {MAX_TOKENS} tokens"));
        return None;
    }
    let mut cursor = Cursor::new(tokens, last.into());
    let name = shell(&mut cursor, report);
    let mut decl = Decl {
        name: name.clone().unwrap_or(Spanned { value: String::new(), place: last.into() }),
        form: None,
        length_unit: None,
        angle_unit: None,
        bindings: Vec::new(),
        table: None,
        factors: Vec::new(),
        base: Vec::new(),
        tool: Vec::new(),
        couples: Vec::new(),
        checks: Vec::new(),
        demanded: None,
        whole: true,
    };
    if name.is_some() {
        header(&mut decl, &mut cursor, report);
    } else if !starts_statement(&cursor) {
        // Whatever this was, it was meant as the header.
        cursor.until(|t| t.is(";") || t.is("|"));
    }
    statements(&mut decl, &mut cursor, report);
    name.map(|_| decl)
}

/// Attributes, visibility, `struct` and the name.
fn shell(cursor: &mut Cursor<'_>, report: &mut Report) -> Option<Spanned<String>> {
    skip_attributes(cursor, report);
    if cursor.eat("pub")
        && (cursor.are(&["(", "crate"])
            || cursor.are(&["(", "super"])
            || cursor.are(&["(", "self"])
            || cursor.are(&["(", "in"]))
    {
        cursor.group("(", report);
    }
    let place = cursor.place();
    if !cursor.eat("struct") {
        report.error_help(place, "a declaration begins with `struct` and its name", SHELL);
        return None;
    }
    let place = cursor.place();
    let Some(token) = cursor.word() else {
        report.error_help(place, "the name is missing after `struct`", SHELL);
        return None;
    };
    Some(Spanned { value: token.text.clone(), place: token.at.into() })
}

/// Walks over `#[…]` and `#![…]`; a documentation comment arrives as one of these.
fn skip_attributes(cursor: &mut Cursor<'_>, report: &mut Report) {
    while cursor.are(&["#", "["]) || cursor.are(&["#", "!", "["]) {
        cursor.next();
        cursor.eat("!");
        if cursor.group("[", report).is_none() {
            return;
        }
    }
}

/// `(convention, length unit, angle unit);`.
fn header(decl: &mut Decl, cursor: &mut Cursor<'_>, report: &mut Report) {
    let name_place = decl.name.place;
    let mut end = name_place;
    if !cursor.is("(") {
        let message = "the convention and the units are missing after the name";
        report.error_help(name_place, message, SHELL);
    } else if let Some((inside, place)) = cursor.group("(", report) {
        for part in inside.commas() {
            header_word(decl, part, report);
        }
        header_complete(decl, place, report);
        end = place.last.into();
    }
    if !cursor.eat(";") {
        report.error(end, "a `;` is missing after the header");
    }
}

fn header_word(decl: &mut Decl, mut part: Cursor<'_>, report: &mut Report) {
    let place = part.all();
    let word = part.word().map(|t| t.text.as_str()).filter(|_| part.is_empty());
    let form =
        word.and_then(|w| [Form::Standard, Form::Modified, Form::Chain].into_iter().find(|f| f.word() == w));
    let twice = match (form, word.and_then(Unit::from_word)) {
        (Some(form), _) => decl.form.replace(form).is_some().then_some("convention"),
        (_, Some(Unit::Length(unit))) => decl.length_unit.replace(unit).is_some().then_some("unit of length"),
        (_, Some(Unit::Angle(unit))) => decl.angle_unit.replace(unit).is_some().then_some("unit of angle"),
        _ => return unknown_header_word(decl, word, place, report),
    };
    if let Some(what) = twice {
        report.error(place, format!("the {what} is given twice"));
    }
}

/// An unknown word fills the first gap, so that nobody also complains that something is missing.
fn unknown_header_word(decl: &mut Decl, word: Option<&str>, place: Place, report: &mut Report) {
    let shown = word.unwrap_or("this");
    let known = ["standard", "modified", "chain", "m", "cm", "mm", "in", "deg", "rad"];
    let lower = shown.to_lowercase();
    let meant = match lower.as_str() {
        "craig" | "mdh" | "proximal" => Some("modified"),
        "dh" | "sdh" | "classic" | "classical" | "paul" | "spong" | "distal" => Some("standard"),
        "metre" | "meter" | "metres" | "meters" => Some("m"),
        "inch" | "inches" => Some("in"),
        "degree" | "degrees" => Some("deg"),
        "radian" | "radians" => Some("rad"),
        other => nearest(other, known),
    };
    let rest = "the header is a convention (standard, modified or chain), a length unit (m, cm, mm or in) and an angle \
                unit (deg or rad)";
    let help = match meant {
        Some(meant) => format!("did you mean `{meant}`? {rest}"),
        None => rest.to_string(),
    };
    report.error_help(place, format!("`{shown}` is neither a convention nor a unit"), help);
    if decl.form.is_none() {
        decl.form = Some(Form::Modified);
    } else if decl.length_unit.is_none() {
        decl.length_unit = Some(LengthUnit::Metre);
    } else {
        decl.angle_unit = decl.angle_unit.or(Some(AngleUnit::Degree));
    }
}

fn header_complete(decl: &Decl, place: Place, report: &mut Report) {
    if decl.form.is_none() {
        let help = "write `standard` (Denavit and Hartenberg, Paul), `modified` (Craig) or `chain` first: they give different arms";
        report.error_help(place, "the convention is missing", help);
    }
    if decl.length_unit.is_none() {
        report.error_help(place, "the unit of length is missing", "add `m`, `cm`, `mm` or `in`");
    }
    if decl.angle_unit.is_none() {
        report.error_help(place, "the unit of angle is missing", "add `deg` or `rad`");
    }
}

fn statements(decl: &mut Decl, cursor: &mut Cursor<'_>, report: &mut Report) {
    let mut failed = 0;
    loop {
        skip_attributes(cursor, report);
        if cursor.is_empty() {
            return;
        }
        if cursor.eat(";") {
            continue;
        }
        failed += usize::from(!one_statement(decl, cursor, report));
        if failed >= MAX_FAILURES {
            let message = format!("{failed} statements could not be read; the rest is not looked at");
            return report.error(cursor.place(), message);
        }
    }
}

/// Reads one statement and its `;`, or the table. `false` after a mistake, at the next place that looks right.
fn one_statement(decl: &mut Decl, cursor: &mut Cursor<'_>, report: &mut Report) -> bool {
    if cursor.is("|") {
        let place = cursor.place();
        let read = table::table(cursor, report);
        decl.whole &= read.whole;
        if decl.table.is_some() {
            report.error(place, "this is the second table; an arm has one");
            return false;
        }
        decl.table = Some(read.table);
        return true;
    }
    let from = *cursor;
    let mut body = cursor.until(|t| t.is(";"));
    let length = body.len();
    let read = statement::statement(decl, &mut body, report);
    if read.is_none() {
        resume_inside(&mut body, length, report, false);
    } else if !body.is_empty() {
        resume_inside(&mut body, length, report, true);
    } else if cursor.is_empty() {
        report.error(cursor.place(), "a `;` is missing at the end");
    } else {
        return true;
    }
    // What is left of the body starts with a statement, or nothing is left of it.
    *cursor = from;
    for _ in 0..length - body.len() {
        cursor.next();
    }
    false
}

/// Says what is wrong with the next token and moves to the next keyword that starts a statement.
fn resume_inside(body: &mut Cursor<'_>, length: usize, report: &mut Report, complain: bool) {
    if complain {
        if starts_statement(body) {
            let text = body.peek().map_or("", |t| &t.text);
            return report.error(body.place(), format!("a `;` is missing before `{text}`"));
        }
        expr::meaningless(body, report);
    }
    // At least one token must go, or the same statement would be read again.
    if body.len() == length {
        body.next();
    }
    while !body.is_empty() && !starts_with_keyword(body) {
        body.next();
    }
}

fn starts_with_keyword(cursor: &Cursor<'_>) -> bool {
    let second_is_word = cursor.rest().get(1).is_some_and(|t| t.kind == Kind::Word);
    ((cursor.is("let") || cursor.is("param")) && second_is_word)
        || ["base", "tool", "couple", "ik"].iter().any(|word| cursor.are(&[word, ":"]))
        || cursor.are(&["check", "["])
        || cursor.is("|")
}

fn starts_statement(cursor: &Cursor<'_>) -> bool {
    starts_with_keyword(cursor) || statement::factor_word(cursor).is_some()
}

/// Reads an expression and, if neither a statement nor a comma follows it, says so.
pub(super) fn last_expr(cursor: &mut Cursor<'_>, report: &mut Report) -> Option<super::Expr> {
    let value = expr::prefix(cursor, report)?;
    if !cursor.is_empty() && !cursor.is(",") && !starts_statement(cursor) {
        expr::leftover(&value, cursor, report);
        return None;
    }
    Some(value)
}
