//! Expressions: sums of products of signed atoms, parsed with a fixed bound on nesting.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = { "+" | "-" } atom
//! atom    = number [unit] | "pi" | name | ("sqrt" | "sin" | "cos") "(" sum ")" | "(" sum ")"
//! ```
//!
//! Sums and products are flat lists, so that the depth of the tree is bounded by the nesting of parentheses, never by
//! the length of the text.

use super::cursor::Cursor;
use super::lex::{Kind, Token};
use super::{AngleUnit, LengthUnit, MAX_NESTING};
use crate::report::{Place, Report};

/// An expression and its place.
#[derive(Clone, PartialEq, Debug)]
pub struct Expr {
    /// What it is.
    pub node: Node,
    /// Where it stands.
    pub place: Place,
}

/// The kinds of expression.
#[derive(Clone, PartialEq, Debug)]
pub enum Node {
    /// A decimal number as written, without its unit.
    Number(String, Option<Unit>),
    /// The angle π.
    Pi,
    /// The joint variable, a `let` or a `param`.
    Name(String),
    /// A function of a constant.
    Call(Function, Box<Expr>),
    /// The negative.
    Neg(Box<Expr>),
    /// Terms and their signs.
    Sum(Vec<(Sign, Expr)>),
    /// Factors; `true` for a divisor.
    Product(Vec<(bool, Expr)>),
}

/// The sign of a term.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sign {
    /// Added.
    Plus,
    /// Subtracted.
    Minus,
}

/// The functions of constants.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    /// The square root.
    Sqrt,
    /// The sine of an angle.
    Sin,
    /// The cosine of an angle.
    Cos,
}

impl Function {
    /// The name.
    pub fn word(self) -> &'static str {
        match self {
            Function::Sqrt => "sqrt",
            Function::Sin => "sin",
            Function::Cos => "cos",
        }
    }
}

/// The unit of a literal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unit {
    /// Of length.
    Length(LengthUnit),
    /// Of angle.
    Angle(AngleUnit),
}

impl Unit {
    /// The unit a word stands for.
    pub fn from_word(word: &str) -> Option<Unit> {
        Some(match word {
            "m" => Unit::Length(LengthUnit::Metre),
            "cm" => Unit::Length(LengthUnit::Centimetre),
            "mm" => Unit::Length(LengthUnit::Millimetre),
            "in" => Unit::Length(LengthUnit::Inch),
            "deg" => Unit::Angle(AngleUnit::Degree),
            "rad" => Unit::Angle(AngleUnit::Radian),
            _ => return None,
        })
    }

    /// The suffix.
    pub fn word(self) -> &'static str {
        match self {
            Unit::Length(unit) => unit.word(),
            Unit::Angle(unit) => unit.word(),
        }
    }
}

impl Expr {
    /// Whether a name that satisfies `wanted` occurs.
    pub fn mentions(&self, wanted: &dyn Fn(&str) -> bool) -> bool {
        match &self.node {
            Node::Number(..) | Node::Pi => false,
            Node::Name(name) => wanted(name),
            Node::Call(_, inner) | Node::Neg(inner) => inner.mentions(wanted),
            Node::Sum(terms) => terms.iter().any(|(_, e)| e.mentions(wanted)),
            Node::Product(factors) => factors.iter().any(|(_, e)| e.mentions(wanted)),
        }
    }
}

/// Reads an expression that takes up the whole cursor; `None` after exactly one message.
pub(super) fn whole(mut cursor: Cursor<'_>, report: &mut Report) -> Option<Expr> {
    let expr = sum(&mut cursor, 0, report)?;
    if cursor.is_empty() {
        return Some(expr);
    }
    leftover(&expr, &cursor, report);
    None
}

/// Reads an expression and leaves what follows it.
pub(super) fn prefix(cursor: &mut Cursor<'_>, report: &mut Report) -> Option<Expr> {
    sum(cursor, 0, report)
}

/// Says what is wrong with the token that follows a complete expression.
pub(super) fn leftover(before: &Expr, cursor: &Cursor<'_>, report: &mut Report) {
    let Some(next) = cursor.peek() else { return };
    let (place, text) = (Place::from(next.at), &next.text);
    let starts_value = matches!(next.kind, Kind::Word | Kind::Number) || next.is("(");
    if next.is("^") {
        report.error_help(place, "there is no power here", "write a product, such as `a*a`");
    } else if starts_value && is_shown_short(before) {
        let after = if text == "(" { "(…)" } else { text };
        let help = format!("write `{before}*{after}` if a product is meant");
        report.error_help(place, format!("`{text}` follows `{before}` without an operator"), help);
    } else if starts_value {
        report.error_help(
            place,
            format!("there is no operator before `{text}`"),
            "write `*` if a product is meant",
        );
    } else if next.is(")") || next.is("]") || next.is("}") {
        report.error(place, format!("this `{text}` was never opened"));
    } else {
        meaningless(cursor, report);
    }
}

/// Says that the next token has no meaning where it stands, and what may have been meant by it.
pub(super) fn meaningless(cursor: &Cursor<'_>, report: &mut Report) {
    let Some(token) = cursor.peek() else { return };
    let message = format!("`{}` has no meaning here", token.text);
    if is_quoted(token) {
        report.error_help(token.at, message, WITHOUT_QUOTES);
    } else if token.is(".") {
        let help =
            "a decimal point stands between digits, such as `0.5`; a range `-90 .. 90` belongs in limits";
        report.error_help(token.at, message, help);
    } else {
        report.error(token.at, message);
    }
}

const WITHOUT_QUOTES: &str = "write names and numbers without quotes";

/// A text or a character, or the mark that begins one.
fn is_quoted(token: &Token) -> bool {
    token.kind == Kind::Punct && token.text.contains(['"', '\''])
}

fn is_shown_short(expr: &Expr) -> bool {
    matches!(expr.node, Node::Number(..) | Node::Name(_) | Node::Pi)
}

fn sum(cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let first = product(cursor, depth, report)?;
    let mut place = first.place;
    let mut terms = vec![(Sign::Plus, first)];
    while cursor.is("+") || cursor.is("-") {
        let sign = if cursor.eat("+") { Sign::Plus } else { Sign::Minus };
        if sign == Sign::Minus {
            cursor.next();
        }
        let term = product(cursor, depth, report)?;
        place = place.to(term.place);
        terms.push((sign, term));
    }
    match terms.pop() {
        Some((_, only)) if terms.is_empty() => Some(only),
        last => {
            terms.extend(last);
            Some(Expr { node: Node::Sum(terms), place })
        }
    }
}

fn product(cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let first = signed(cursor, depth, report)?;
    let mut place = first.place;
    let mut factors = vec![(false, first)];
    while cursor.is("*") || cursor.is("/") {
        let divide = !cursor.eat("*");
        if divide {
            cursor.next();
        }
        let factor = signed(cursor, depth, report)?;
        place = place.to(factor.place);
        factors.push((divide, factor));
    }
    match factors.pop() {
        Some((_, only)) if factors.is_empty() => Some(only),
        last => {
            factors.extend(last);
            Some(Expr { node: Node::Product(factors), place })
        }
    }
}

fn signed(cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let start = cursor.place();
    let mut negative = false;
    while cursor.is("-") || cursor.is("+") {
        negative ^= cursor.is("-");
        cursor.next();
    }
    let inner = atom(cursor, depth, report)?;
    if !negative {
        return Some(inner);
    }
    let place = start.to(inner.place);
    Some(Expr { node: Node::Neg(Box::new(inner)), place })
}

fn atom(cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let place = cursor.place();
    let Some(token) = cursor.peek() else {
        report.error(place, "a value is missing here");
        return None;
    };
    match token.kind {
        Kind::Number => {
            cursor.next();
            number(token, cursor, report)
        }
        Kind::Word => {
            cursor.next();
            name(token, cursor, depth, report)
        }
        Kind::Open if token.text == "(" => parenthesis(cursor, depth, report),
        _ if token.is(".") => {
            report.error_help(
                place,
                "a number cannot begin with a point",
                "write a 0 before it, such as `0.5`",
            );
            None
        }
        _ if is_quoted(token) => {
            report.error_help(place, format!("`{}` is not a value", token.text), WITHOUT_QUOTES);
            None
        }
        _ => {
            report.error(place, format!("a value is missing before `{}`", token.text));
            None
        }
    }
}

/// The inside of parentheses, with the place of the parentheses.
fn parenthesis(cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let at = cursor.place();
    if depth >= MAX_NESTING {
        report.error_help(
            at,
            format!("more than {MAX_NESTING} parentheses stand inside each other"),
            "name a part with `let`",
        );
        return None;
    }
    let (mut inside, place) = cursor.group("(", report)?;
    let expr = sum(&mut inside, depth + 1, report)?;
    if !inside.is_empty() {
        leftover(&expr, &inside, report);
        return None;
    }
    Some(Expr { node: expr.node, place })
}

fn name(token: &Token, cursor: &mut Cursor<'_>, depth: usize, report: &mut Report) -> Option<Expr> {
    let place = Place::from(token.at);
    let function = match token.text.as_str() {
        "pi" => return Some(Expr { node: Node::Pi, place }),
        "sqrt" => Function::Sqrt,
        "sin" => Function::Sin,
        "cos" => Function::Cos,
        _ if cursor.is("(") => {
            let help = "the functions are `sqrt`, `sin` and `cos`; write `*` if a product is meant";
            report.error_help(place, format!("`{}` is not a function here", token.text), help);
            return None;
        }
        _ => return Some(Expr { node: Node::Name(token.text.clone()), place }),
    };
    if !cursor.is("(") {
        let word = function.word();
        report.error_help(
            place,
            format!("`{word}` needs its argument in parentheses"),
            format!("write `{word}(…)`"),
        );
        return None;
    }
    let argument = parenthesis(cursor, depth, report)?;
    let place = place.to(argument.place);
    Some(Expr { node: Node::Call(function, Box::new(argument)), place })
}

/// A literal and its unit, which may be a suffix or the next word.
fn number(token: &Token, cursor: &mut Cursor<'_>, report: &mut Report) -> Option<Expr> {
    let place = Place::from(token.at);
    let (digits, suffix) = split_suffix(&token.text);
    if !suffix.is_empty() {
        let Some(unit) = Unit::from_word(suffix) else {
            let help = "the units are m, cm, mm, in, deg and rad; numbers are decimal";
            report.error_help(place, format!("`{suffix}` in `{}` is not a unit", token.text), help);
            return None;
        };
        return Some(Expr { node: Node::Number(digits.to_string(), Some(unit)), place });
    }
    let following = cursor.peek().filter(|t| t.kind == Kind::Word);
    if let Some((word, unit)) = following.and_then(|t| Some((t, Unit::from_word(&t.text)?))) {
        cursor.next();
        return Some(Expr {
            node: Node::Number(digits.to_string(), Some(unit)),
            place: place.to(word.at.into()),
        });
    }
    Some(Expr { node: Node::Number(digits.to_string(), None), place })
}

/// Splits `1e-3mm` into `1e-3` and `mm`; an underscore between them belongs to neither digits nor unit, and goes with
/// the unit, which is then unknown.
fn split_suffix(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let sign = |i: usize| matches!(bytes.get(i), Some(b'+' | b'-'));
    let letter = bytes.iter().enumerate().position(|(i, byte)| {
        let exponent = matches!(byte, b'e' | b'E') && (digit(i + 1) || (sign(i + 1) && digit(i + 2)));
        byte.is_ascii_alphabetic() && !exponent
    });
    let digits = text.get(..letter.unwrap_or(text.len())).unwrap_or(text).trim_end_matches('_');
    (digits, text.get(digits.len()..).unwrap_or(""))
}
