//! Where the minus signs go.
//!
//! Signs move outwards while the graph is built, so that equal values meet whatever their sign; what is left of them
//! stands at the outputs. A difference can be stored either way round at no cost: this pass chooses, for each, the way
//! that leaves the fewest outputs negated. No operation is added, none changes its rounding.

use crate::program::{Op, Program, Value};

/// Chooses the order of each difference.
pub fn settle(program: &mut Program) {
    let mut flips = vec![false; program.steps.len()];
    let mut best = negated(program, &flips);
    // Two rounds: a flip early in the program can make one later on worthwhile.
    for _ in 0..2 {
        for index in (0..flips.len()).rev() {
            if best == 0 {
                break;
            }
            if matches!(program.steps[index].op, Op::Add(..) | Op::Sub(..)) {
                flips[index] = !flips[index];
                let count = negated(program, &flips);
                if count < best {
                    best = count;
                } else {
                    flips[index] = !flips[index];
                }
            }
        }
    }
    let (ops, negative) = with_flips(program, &flips);
    for (step, op) in program.steps.iter_mut().zip(ops) {
        if let Some(op) = op {
            step.op = op;
        }
    }
    for output in &mut program.outputs {
        if let Value::Step { index, negative: sign } = &mut output.value {
            *sign ^= negative[*index];
        }
    }
}

/// How many outputs would be negated.
fn negated(program: &Program, flips: &[bool]) -> usize {
    let (_, negative) = with_flips(program, flips);
    let is = |value: Value| matches!(value, Value::Step { index, negative: sign } if sign != negative[index]);
    program.outputs.iter().filter(|o| is(o.value)).count()
}

/// The operations with the given differences stored the other way round, and which steps now hold their negative.
fn with_flips(program: &Program, flips: &[bool]) -> (Vec<Option<Op>>, Vec<bool>) {
    let mut negative = vec![false; program.steps.len()];
    let mut ops = vec![None; program.steps.len()];
    for (index, step) in program.steps.iter().enumerate() {
        let (op, sign) = match step.op {
            Op::Mul(a, b) => (None, negative[a] != negative[b]),
            Op::Add(a, b) => sum(a, negative[a], b, negative[b], flips[index]),
            Op::Sub(a, b) => sum(a, negative[a], b, !negative[b], flips[index]),
            _ => (None, false),
        };
        ops[index] = op;
        negative[index] = sign;
    }
    (ops, negative)
}

/// ±a ± b as one operation, and whether it holds the negative of that.
fn sum(a: usize, minus_a: bool, b: usize, minus_b: bool, flip: bool) -> (Option<Op>, bool) {
    match (minus_a, minus_b, flip) {
        (false, false, _) => (Some(Op::Add(a, b)), false),
        (true, true, _) => (Some(Op::Add(a, b)), true),
        (false, true, false) => (Some(Op::Sub(a, b)), false),
        (false, true, true) => (Some(Op::Sub(b, a)), true),
        (true, false, false) => (Some(Op::Sub(b, a)), false),
        (true, false, true) => (Some(Op::Sub(a, b)), true),
    }
}
