//! MathML: programs and polynomials as mathematics that every browser sets, without a script.
//!
//! Names are read as reports write them: `c23` is c with the index 23; multiplication is not shown.
//! What is printed can be read back and computed: a test does, and compares with the interpreter.

use std::fmt::Write;

use super::listing;
use crate::algebra::Part;
use crate::algebra::expr::Turn;
use crate::algebra::ring::{Poly, Ring};
use crate::model::Arm;
use crate::program::{Op, Program, Value};

/// All programs of an arm, one block each.
pub fn print(arm: &Arm) -> String {
    let blocks = listing::programs(arm).into_iter();
    blocks.map(|p| format!("<!-- {}: {} -->\n{}\n", p.name, p.cost(), program(arm, p))).collect()
}

/// A formula of its own, not inside a sentence.
pub fn block(content: &str) -> String {
    format!("<math display=\"block\"><mrow>{content}</mrow></math>")
}

/// A formula inside a sentence.
pub fn inline(content: &str) -> String {
    format!("<math><mrow>{content}</mrow></math>")
}

/// A name with its index: `c23`, `theta1`, `q2`, `r11`. Greek names become letters.
pub fn name(text: &str) -> String {
    let split = text.find(|c: char| c.is_ascii_digit() || c == '_').unwrap_or(text.len());
    let (letter, index) = text.split_at(split);
    // A constant pair is named `cφ1`: the cosine of the angle φ₁.
    if let (Some(function @ ('c' | 's')), Some(angle)) = (letter.chars().next(), letter.get(1..))
        && angle.starts_with('φ')
    {
        let angle = format!("<mrow>{}</mrow>", indexed(angle, index));
        return format!("<msub><mi>{function}</mi>{angle}</msub>");
    }
    indexed(letter, index)
}

fn indexed(letter: &str, index: &str) -> String {
    let letter = match letter {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "theta" => "θ",
        "phi" => "φ",
        other => other,
    };
    let letter = format!("<mi>{}</mi>", escaped(letter));
    let index = index.trim_start_matches('_');
    if index.is_empty() { letter } else { format!("<msub>{letter}{}</msub>", self::index(index)) }
}

/// An index: a number, or a word, or both.
fn index(text: &str) -> String {
    if text.bytes().all(|b| b.is_ascii_digit()) {
        format!("<mn>{text}</mn>")
    } else {
        format!("<mi>{}</mi>", escaped(text))
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// An operator between its operands.
pub fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", escaped(sign))
}

/// Multiplication, which is not shown, but takes a little room: indices stand between letters.
const TIMES: &str = "<mo lspace=\"0.06em\" rspace=\"0.06em\">&#x2062;</mo>";
/// The application of a function.
const APPLY: &str = "<mo>&#x2061;</mo>";
const MINUS: &str = "<mo>−</mo>";

/// A polynomial, its terms in order.
pub fn poly(ring: &Ring, poly: &Poly) -> String {
    let parts = ring.parts(poly);
    if parts.is_empty() {
        return "<mn>0</mn>".to_owned();
    }
    let mut text = String::new();
    for (position, part) in parts.iter().enumerate() {
        match (position, part.coefficient < 0) {
            (0, false) => {}
            (_, true) => text.push_str(MINUS),
            (_, false) => text.push_str("<mo>+</mo>"),
        }
        text.push_str(&term(part));
    }
    text
}

/// A polynomial as a factor: in parentheses if it has several terms or a sign.
pub fn factor(ring: &Ring, poly: &Poly) -> String {
    let text = self::poly(ring, poly);
    let plain = matches!(ring.parts(poly).as_slice(), [part] if part.coefficient > 0);
    if plain { text } else { parenthesised(&text) }
}

/// Factors one after the other.
pub fn product(factors: &[String]) -> String {
    factors.join(TIMES)
}

fn parenthesised(text: &str) -> String {
    format!("<mrow><mo>(</mo>{text}<mo>)</mo></mrow>")
}

fn term(part: &Part<'_>) -> String {
    let mut factors = Vec::new();
    if part.coefficient.unsigned_abs() != 1 || part.factors.is_empty() {
        factors.push(format!("<mn>{}</mn>", part.coefficient.unsigned_abs()));
    }
    for (variable, exponent) in &part.factors {
        let base = name(variable);
        factors.push(match exponent {
            1 => base,
            many => format!("<msup><mrow>{base}</mrow><mn>{many}</mn></msup>"),
        });
    }
    product(&factors)
}

/// Cells by rows between parentheses.
pub fn matrix(rows: &[Vec<String>]) -> String {
    let mut text = "<mrow><mo>(</mo><mtable>".to_owned();
    for row in rows {
        text.push_str("<mtr>");
        for cell in row {
            // Writing to a string cannot fail.
            let _ = write!(text, "<mtd><mrow>{cell}</mrow></mtd>");
        }
        text.push_str("</mtr>");
    }
    text + "</mtable><mo>)</mo></mrow>"
}

/// Equations one under the other, aligned at their equals signs: what stands left and right of each.
pub fn equations(lines: &[(String, String)]) -> String {
    let mut text =
        "<math display=\"block\"><mtable class=\"equations\" columnalign=\"right left\">\n".to_owned();
    for (left, right) in lines {
        let _ = writeln!(
            text,
            "<mtr><mtd class=\"left\"><mrow>{left}</mrow></mtd><mtd class=\"right\"><mrow><mo>=</mo>{right}</mrow></mtd></mtr>"
        );
    }
    text + "</mtable></math>"
}

/// A program: each named step, then each output that is not one of them.
pub fn program(arm: &Arm, program: &Program) -> String {
    let mut lines = Vec::new();
    for (index, step) in program.steps.iter().enumerate() {
        let given = matches!(step.op, Op::Slide(_) | Op::Entry(_));
        if let (Some(own), false) = (&step.name, given) {
            lines.push((name(own), spelled(arm, program, index).0));
        }
    }
    for output in &program.outputs {
        let value = self::output(arm, program, output.value);
        if value != name(&output.name) {
            lines.push((name(&output.name), value));
        }
    }
    equations(&lines)
}

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// The expression of one step, its unnamed operands in place.
fn spelled(arm: &Arm, program: &Program, step: usize) -> (String, Binding) {
    let operand = |index: usize, at_least: Binding| {
        let (text, binding) = match &program.steps[index].name {
            Some(own) => (name(own), Binding::Atom),
            None => spelled(arm, program, index),
        };
        if binding < at_least { parenthesised(&text) } else { text }
    };
    match &program.steps[step].op {
        Op::Constant(meaning, _) => {
            let binding = if meaning.len() > 1 { Binding::Sum } else { Binding::Product };
            (poly(&arm.ring, meaning), binding)
        }
        Op::Param(index) => (name(&param(arm, *index)), Binding::Atom),
        Op::Slide(joint) => (name(&format!("q{}", joint + 1)), Binding::Atom),
        Op::Entry(entry) => (name(&crate::truth::entry_name(*entry)), Binding::Atom),
        Op::Cos(turn) => (function("cos", arm, &program.turns[*turn]), Binding::Atom),
        Op::Sin(turn) => (function("sin", arm, &program.turns[*turn]), Binding::Atom),
        Op::Add(a, b) => {
            (operand(*a, Binding::Sum) + "<mo>+</mo>" + &operand(*b, Binding::Product), Binding::Sum)
        }
        Op::Sub(a, b) => (operand(*a, Binding::Sum) + MINUS + &operand(*b, Binding::Product), Binding::Sum),
        Op::Mul(a, b) => {
            (operand(*a, Binding::Product) + TIMES + &operand(*b, Binding::Atom), Binding::Product)
        }
    }
}

fn output(arm: &Arm, program: &Program, value: Value) -> String {
    match value {
        Value::Unit(unit) if unit < 0 => format!("{MINUS}<mn>{}</mn>", unit.unsigned_abs()),
        Value::Unit(unit) => format!("<mn>{unit}</mn>"),
        Value::Step { index, negative } => {
            let (text, binding) = match &program.steps[index].name {
                Some(own) => (name(own), Binding::Atom),
                None => spelled(arm, program, index),
            };
            match (negative, binding) {
                (false, _) => text,
                (true, Binding::Sum) => MINUS.to_owned() + &parenthesised(&text),
                (true, _) => MINUS.to_owned() + &text,
            }
        }
    }
}

fn function(function: &str, arm: &Arm, turn: &Turn) -> String {
    let mut sum = String::new();
    let joints = turn.joints.iter().map(|(c, j)| (*c, format!("q{}", j + 1)));
    let params = turn.rest.params.iter().map(|(c, p)| (*c, param(arm, *p)));
    for (coefficient, variable) in joints.chain(params) {
        let factor = match coefficient.unsigned_abs() {
            1 => name(&variable),
            many => format!("<mn>{many}</mn>{TIMES}{}", name(&variable)),
        };
        append(&mut sum, coefficient < 0, &factor);
    }
    if !turn.rest.constant.is_zero() {
        let value = turn.rest.constant.to_f64();
        append(&mut sum, value < 0.0, &format!("<mn>{}</mn>", value.abs()));
    }
    format!("<mi>{function}</mi>{APPLY}{}", parenthesised(&sum))
}

fn append(sum: &mut String, negative: bool, term: &str) {
    if negative {
        sum.push_str(MINUS);
    } else if !sum.is_empty() {
        sum.push_str("<mo>+</mo>");
    }
    sum.push_str(term);
}

/// The name of a parameter.
fn param(arm: &Arm, index: usize) -> String {
    arm.params.get(index).map_or_else(String::new, |p| p.name.clone())
}
