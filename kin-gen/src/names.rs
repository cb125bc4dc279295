//! Textbook names for the steps of a program: `s23`, `c23`, `a2`, `r13`, never a number alone.
//!
//! A sine is named after its joints, a constant after its lengths, an output after itself. A value that is used more
//! than once takes the label that the derivation suggested, else the product of its operands' names (`c4c6`), else a
//! dense `k1`, `k2`, …. Names are unique; a clash gets a letter.

use std::collections::BTreeSet;

use crate::algebra::expr::Turn;
use crate::algebra::ring::{Poly, Ring};
use crate::program::{Op, Program, Value};

/// Names that mean something else in the code around a program.
const TAKEN: [&str; 12] = ["self", "q", "pose", "rows", "as", "fn", "if", "in", "do", "let", "mod", "mut"];

/// The longest name made of operands' names.
const LONGEST_PRODUCT: usize = 10;

/// Gives names to one program.
pub struct Namer<'a> {
    ring: &'a Ring,
    labels: Vec<Option<String>>,
    taken: BTreeSet<String>,
    fresh: usize,
}

impl<'a> Namer<'a> {
    /// With the derivation's suggestion for each step.
    pub fn new(ring: &'a Ring, labels: Vec<Option<String>>) -> Namer<'a> {
        Namer { ring, labels, taken: TAKEN.iter().map(|s| (*s).to_owned()).collect(), fresh: 0 }
    }

    /// Names every step that needs a name.
    pub fn name(mut self, program: &mut Program) {
        let uses = program.uses();
        let mut turn_names: Vec<Option<String>> = vec![None; program.turns.len()];
        let outputs = output_names(program);
        for index in 0..program.steps.len() {
            let name = match &program.steps[index].op {
                Op::Cos(turn) | Op::Sin(turn) => {
                    let suffix = match &turn_names[*turn] {
                        Some(suffix) => suffix.clone(),
                        None => {
                            let suffix = self.turn_suffix(&program.turns[*turn]);
                            turn_names[*turn] = Some(suffix.clone());
                            suffix
                        }
                    };
                    let letter = if matches!(program.steps[index].op, Op::Cos(_)) { 'c' } else { 's' };
                    Some(format!("{letter}{suffix}"))
                }
                Op::Constant(meaning, _) => {
                    let wanted = constant_name(self.ring, meaning);
                    Some(self.unique(wanted))
                }
                Op::Param(_) | Op::Slide(_) | Op::Entry(_) => None,
                Op::Add(..) | Op::Sub(..) | Op::Mul(..) => {
                    if let Some(output) = &outputs[index] {
                        Some(self.unique(output.clone()))
                    } else if uses[index] > 1 {
                        let wanted = self.value_name(program, index);
                        Some(self.unique(wanted))
                    } else {
                        None
                    }
                }
            };
            program.steps[index].name = name;
        }
    }

    fn unique(&mut self, wanted: String) -> String {
        let mut name = wanted.clone();
        let mut letters = 'b'..='z';
        while !self.taken.insert(name.clone()) {
            name = match letters.next() {
                Some(letter) => format!("{wanted}{letter}"),
                None => format!("{name}_"),
            };
        }
        name
    }

    /// `23` for q2 + q3, `2m3` for q2 - q3; made unique together with its `s` and `c`.
    fn turn_suffix(&mut self, turn: &Turn) -> String {
        let mut wanted = String::new();
        for (position, (coefficient, joint)) in turn.joints.iter().enumerate() {
            if *coefficient < 0 {
                wanted.push('m');
            } else if position > 0 && wanted.contains('m') {
                wanted.push('p');
            }
            if coefficient.abs() > 1 {
                wanted.push_str(&format!("{}x", coefficient.abs()));
            }
            wanted.push_str(&(joint + 1).to_string());
        }
        if wanted.is_empty() {
            wanted.push_str("_phi");
        }
        let mut suffix = wanted.clone();
        let mut letters = 'b'..='z';
        while self.taken.contains(&format!("s{suffix}")) || self.taken.contains(&format!("c{suffix}")) {
            suffix = match letters.next() {
                Some(letter) => format!("{wanted}{letter}"),
                None => format!("{suffix}_"),
            };
        }
        self.taken.insert(format!("s{suffix}"));
        self.taken.insert(format!("c{suffix}"));
        suffix
    }

    fn value_name(&mut self, program: &Program, index: usize) -> String {
        if let Some(Some(label)) = self.labels.get(index) {
            return label.clone();
        }
        if let Op::Mul(a, b) = program.steps[index].op {
            if let (Some(a), Some(b)) = (&program.steps[a].name, &program.steps[b].name) {
                if a.len() + b.len() <= LONGEST_PRODUCT {
                    return format!("{a}{b}");
                }
            }
        }
        self.fresh += 1;
        format!("k{}", self.fresh)
    }
}

/// For each step, the output that it is, if it is one without a change of sign (else with).
fn output_names(program: &Program) -> Vec<Option<String>> {
    let mut names = vec![None; program.steps.len()];
    for wanted in [false, true] {
        for output in &program.outputs {
            if let Value::Step { index, negative } = output.value {
                if negative == wanted && names[index].is_none() {
                    names[index] = Some(if negative { format!("{}_neg", output.name) } else { output.name.clone() });
                }
            }
        }
    }
    names
}

/// `a2`, `d1_d2` for a sum, else `k`.
fn constant_name(ring: &Ring, meaning: &Poly) -> String {
    let text = ring.show(meaning).to_string();
    let simple = text.replace(" + ", "_").replace('·', "").replace('φ', "");
    let ascii = simple.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let starts = simple.chars().next().is_some_and(|c| c.is_ascii_alphabetic());
    if ascii && starts && simple.len() <= 16 { simple } else { "k".to_owned() }
}
