//! Expressions in infix notation: what the backends share.
//!
//! Parentheses are written wherever the order of evaluation would otherwise change, so that every language adds and
//! multiplies in the same order as the interpreter.

use crate::algebra::expr::Turn;
use crate::program::{Op, Program, Value};

/// How a language writes leaves.
pub trait Leaves {
    /// A literal double.
    fn literal(&self, value: f64) -> String;
    /// A parameter of the arm.
    fn param(&self, index: usize) -> String;
}

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// The expression of one step, its unnamed operands printed in place.
pub fn step(program: &Program, index: usize, leaves: &dyn Leaves) -> String {
    spelled(program, index, leaves).0
}

fn spelled(program: &Program, index: usize, leaves: &dyn Leaves) -> (String, Binding) {
    let operand = |index: usize, at_least: Binding| {
        let (text, binding) = match &program.steps[index].name {
            Some(name) => (name.clone(), Binding::Atom),
            None => spelled(program, index, leaves),
        };
        if binding < at_least { format!("({text})") } else { text }
    };
    match program.steps[index].op {
        Op::Constant(_, value) => (leaves.literal(value), Binding::Atom),
        Op::Param(param) => (leaves.param(param), Binding::Atom),
        Op::Slide(joint) => (format!("q{}", joint + 1), Binding::Atom),
        Op::Entry(entry) => (crate::truth::entry_name(entry), Binding::Atom),
        Op::Cos(turn) => (format!("cos({})", self::turn(&program.turns[turn], leaves)), Binding::Atom),
        Op::Sin(turn) => (format!("sin({})", self::turn(&program.turns[turn], leaves)), Binding::Atom),
        Op::Add(a, b) => {
            let text = format!("{} + {}", operand(a, Binding::Sum), operand(b, Binding::Product));
            (text, Binding::Sum)
        }
        Op::Sub(a, b) => {
            let text = format!("{} - {}", operand(a, Binding::Sum), operand(b, Binding::Product));
            (text, Binding::Sum)
        }
        Op::Mul(a, b) => {
            let text = format!("{} * {}", operand(a, Binding::Product), operand(b, Binding::Atom));
            (text, Binding::Product)
        }
    }
}

/// A sum of joint values, parameters and a constant, in that order.
pub fn turn(turn: &Turn, leaves: &dyn Leaves) -> String {
    turn_from(String::new(), turn, leaves)
}

/// The same, added to what is already there.
pub fn turn_from(begun: String, turn: &Turn, leaves: &dyn Leaves) -> String {
    let joints = turn.joints.iter().map(|(c, j)| (*c, format!("q{}", j + 1)));
    let params = turn.rest.params.iter().map(|(c, p)| (*c, leaves.param(*p)));
    let mut text = begun;
    for (coefficient, name) in joints.chain(params) {
        let factor = match coefficient.unsigned_abs() {
            1 => name,
            many => format!("{} * {name}", leaves.literal(many as f64)),
        };
        append(&mut text, coefficient < 0, &factor);
    }
    if !turn.rest.constant.is_zero() {
        let value = turn.rest.constant.to_f64();
        append(&mut text, value < 0.0, &leaves.literal(value.abs()));
    }
    text
}

/// Adds a signed term to a sum.
pub fn append(text: &mut String, negative: bool, term: &str) {
    match (text.is_empty(), negative) {
        (true, false) => {}
        (true, true) => text.push('-'),
        (false, false) => text.push_str(" + "),
        (false, true) => text.push_str(" - "),
    }
    text.push_str(term);
}

/// An output: `zero`, `one`, a step or its negative.
pub fn output(program: &Program, value: Value, leaves: &dyn Leaves) -> String {
    match value {
        Value::Unit(0) => leaves.literal(0.0),
        Value::Unit(unit) => leaves.literal(f64::from(unit)),
        Value::Step { index, negative } => {
            let text = match &program.steps[index].name {
                Some(name) => name.clone(),
                None => {
                    let (text, binding) = spelled(program, index, leaves);
                    if negative && binding < Binding::Atom { format!("({text})") } else { text }
                }
            };
            if negative { format!("-{text}") } else { text }
        }
    }
}
