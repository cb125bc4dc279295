//! Textbook names for the steps of a program: `s23`, `c23`, `a2`, `r13`, never a number alone.
//!
//! A sine is named after its joints, a constant after its lengths, an output after itself. A value that is used more
//! than once takes the label that the derivation suggested (`_neg` if it holds the negative of that), else the product of
//! its operands' names (`c4c6`), else a dense `k1`, `k2`, …. Names are unique; a clash gets a letter.

use std::collections::BTreeSet;

use crate::algebra::expr::Turn;
use crate::algebra::ring::{Poly, Ring};
use crate::program::{Op, Program, Value};

/// Names that mean something else in the code around a program.
const TAKEN: [&str; 16] = [
    "self", "q", "pose", "rows", "point", "r36", "zero", "one", "as", "fn", "if", "in", "do", "let", "mod",
    "mut",
];

/// The longest name made of operands' names.
const LONGEST_PRODUCT: usize = 10;

/// A name that the derivation suggested for a step.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The name.
    pub name: String,
    /// Whether the step holds the negative of what the name says.
    pub negative: bool,
}

/// Gives names to one program.
pub struct Namer<'a> {
    ring: &'a Ring,
    labels: Vec<Option<Label>>,
    taken: BTreeSet<String>,
    fresh: usize,
}

impl<'a> Namer<'a> {
    /// With the derivation's suggestion for each step.
    pub fn new(ring: &'a Ring, labels: Vec<Option<Label>>) -> Namer<'a> {
        Namer { ring, labels, taken: TAKEN.iter().map(|s| (*s).to_owned()).collect(), fresh: 0 }
    }

    /// Names every step that needs a name.
    ///
    /// A step that is only the negative of one output stays without: it is printed as that output.
    pub fn name(mut self, program: &mut Program) {
        let uses = program.uses();
        if program.steps.iter().any(|s| matches!(s.op, Op::Entry(_))) {
            self.taken.extend((0..12).map(crate::truth::entry_name));
        }
        self.name_outputs(program);
        let mut turn_names: Vec<Option<String>> = vec![None; program.turns.len()];
        for (index, count) in uses.into_iter().enumerate() {
            if program.steps[index].name.is_some() {
                continue;
            }
            let name = match &program.steps[index].op {
                Op::Cos(turn) | Op::Sin(turn) => {
                    let known = turn_names[*turn].take();
                    let suffix = known.unwrap_or_else(|| self.turn_suffix(&program.turns[*turn]));
                    let letter = if matches!(program.steps[index].op, Op::Cos(_)) { 'c' } else { 's' };
                    turn_names[*turn] = Some(suffix.clone());
                    Some(format!("{letter}{suffix}"))
                }
                Op::Constant(meaning, _) if meaning.as_unit().is_some() => None,
                Op::Constant(meaning, _) => Some(self.unique(constant_name(self.ring, meaning))),
                Op::Param(param) => Some(self.unique(self.ring.param_name(*param))),
                Op::Slide(_) | Op::Entry(_) => None,
                Op::Add(..) | Op::Sub(..) | Op::Mul(..) if count > 1 => {
                    let wanted = self.value_name(program, index);
                    Some(self.unique(wanted))
                }
                Op::Add(..) | Op::Sub(..) | Op::Mul(..) => None,
            };
            program.steps[index].name = name;
        }
    }

    /// An output gives its name to the step that it is.
    fn name_outputs(&mut self, program: &mut Program) {
        for output in &program.outputs {
            if let Value::Step { index, negative } = output.value {
                let step = &mut program.steps[index];
                let computed = matches!(step.op, Op::Add(..) | Op::Sub(..) | Op::Mul(..));
                if !computed || (step.name.is_some() && !negative) {
                    continue;
                }
                let free = self.taken.insert(output.name.clone());
                if free && !negative {
                    step.name = Some(output.name.clone());
                }
            }
        }
    }

    fn unique(&mut self, wanted: String) -> String {
        let mut name = wanted.clone();
        let mut letters = 'b'..='z';
        while is_joint_value(&name) || !self.taken.insert(name.clone()) {
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
        let label = self.labels.get(index).and_then(Option::as_ref);
        if let Some(Label { name, negative: false }) = label {
            return name.clone();
        }
        if let Op::Mul(a, b) = program.steps[index].op
            && let (Some(a), Some(b)) = (&program.steps[a].name, &program.steps[b].name)
            && a.len() + b.len() <= LONGEST_PRODUCT
        {
            return format!("{a}{b}");
        }
        if let Some(Label { name, .. }) = label {
            return format!("{name}_neg");
        }
        self.fresh += 1;
        format!("k{}", self.fresh)
    }
}

/// `a2`, `d1_d2` for a sum, else `k`.
fn constant_name(ring: &Ring, meaning: &Poly) -> String {
    let text = ring.show(meaning).to_string();
    let simple = text.replace(" + ", "_").replace(['·', 'φ'], "");
    let ascii = simple.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let starts = simple.chars().next().is_some_and(|c| c.is_ascii_alphabetic());
    if ascii && starts && simple.len() <= 16 { simple } else { "k".to_owned() }
}

/// `q1`, `q2`, …: bound by the code around a program.
fn is_joint_value(name: &str) -> bool {
    name.strip_prefix('q').is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
}
