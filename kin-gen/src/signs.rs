//! Where the minus signs go.
//!
//! Signs move outwards while the graph is built, so that equal values meet whatever their sign; what is left of them
//! stands at the outputs. A difference can be stored either way round at no cost: this pass chooses, for each, the way
//! that leaves the fewest outputs negated, and among these the way that leaves the fewest steps with the negative of
//! what they would be called. No operation is added, none changes its rounding.

use crate::program::{Op, Program, Value};

/// The most outputs that are flipped in pairs.
const MOST_PAIRED: usize = 12;

/// Chooses the order of each difference; says which steps now hold the negative of what they held. `called` says for
/// each step whether its name would be that of its negative, if it would have one.
pub fn settle(program: &mut Program, called: &[Option<bool>]) -> Vec<bool> {
    let mut flips = vec![false; program.steps.len()];
    let mut best = negated(program, &flips, called);
    // Columns of a rotation hang together through the product that completes them: pairs find what single flips miss.
    let candidates: Vec<usize> = flippable_outputs(program);
    let pairs = candidates.iter().flat_map(|a| candidates.iter().map(move |b| [*a, *b]));
    let singles = (0..program.steps.len()).rev().map(|index| [index, index]);
    for pair in singles.chain(pairs) {
        if best == (0, 0) {
            break;
        }
        flip(&mut flips, pair);
        let count = negated(program, &flips, called);
        if count < best {
            best = count;
        } else {
            flip(&mut flips, pair);
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
    negative
}

/// Flips one step, or two different ones.
fn flip(flips: &mut [bool], [a, b]: [usize; 2]) {
    flips[a] = !flips[a];
    if a != b {
        flips[b] = !flips[b];
    }
}

/// The outputs that are sums or differences, at most as many as keep the number of pairs small.
fn flippable_outputs(program: &Program) -> Vec<usize> {
    let mut found = Vec::new();
    for output in &program.outputs {
        if let Value::Step { index, .. } = output.value
            && matches!(program.steps[index].op, Op::Add(..) | Op::Sub(..))
            && !found.contains(&index)
            && found.len() < MOST_PAIRED
        {
            found.push(index);
        }
    }
    found
}

/// How many outputs would be negated, and how many steps would hold the negative of what they are called.
fn negated(program: &Program, flips: &[bool], called: &[Option<bool>]) -> (usize, usize) {
    let (_, negative) = with_flips(program, flips);
    let is = |value: Value| matches!(value, Value::Step { index, negative: sign } if sign != negative[index]);
    let outputs = program.outputs.iter().filter(|o| is(o.value)).count();
    let miscalled = called.iter().zip(&negative).filter(|(called, negative)| **called == Some(!**negative));
    (outputs, miscalled.count())
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
