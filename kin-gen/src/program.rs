//! A program: straight-line code in single assignment, the one thing that every backend prints.
//!
//! A program stands for itself. It knows what its constants mean exactly, so it can be expanded into polynomials and
//! proved ([`Program::expand`]), interpreted ([`crate::eval`]) and printed, without the chain it came from.
//!
//! After [`Program::flatten`]: operands stand before their uses, no step is dead, no two steps are the same operation
//! on the same operands, and each step that is used more than once has a name.

use std::collections::BTreeMap;
use std::fmt;

use crate::algebra::expr::{Exprs, Id, Node, Term, Turn};
use crate::algebra::ring::{Poly, Ring};
use crate::chain::AngleSum;
use crate::names::{Label, Namer};
use crate::signs;
use crate::truth::Symbols;

/// What one step does. Operands are indices of earlier steps.
#[derive(Clone, PartialEq, Debug)]
pub enum Op {
    /// A constant: its exact meaning, and the nearest double.
    Constant(Poly, f64),
    /// A length parameter of the arm.
    Param(usize),
    /// The value of a prismatic joint.
    Slide(usize),
    /// An entry of the given pose.
    Entry(usize),
    /// The cosine of a turn: an index into [`Program::turns`].
    Cos(usize),
    /// The sine of a turn.
    Sin(usize),
    /// The sum.
    Add(usize, usize),
    /// The difference.
    Sub(usize, usize),
    /// The product.
    Mul(usize, usize),
}

/// One step, and its name if it has one: a step without is printed inside its only use.
#[derive(Clone, PartialEq, Debug)]
pub struct Step {
    /// The textbook name, or nothing.
    pub name: Option<String>,
    /// What it does.
    pub op: Op,
}

/// One value that the program gives back.
#[derive(Clone, PartialEq, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Where it comes from.
    pub value: Value,
}

/// Where an output comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Value {
    /// An exact 0, 1 or -1.
    Unit(i8),
    /// A step, or its negative.
    Step {
        /// The step.
        index: usize,
        /// Whether its negative is meant.
        negative: bool,
    },
}

/// What a program costs. Negations, copies, constants, and outputs that are 0 or ±1 are free.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Cost {
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions, those inside sums of angles included.
    pub add: usize,
    /// Sines and cosines, each counted by itself.
    pub trig: usize,
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} multiplications, {} additions, {} sines and cosines", self.mul, self.add, self.trig)
    }
}

/// Straight-line code.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    /// What it computes, as a word: `fk`, `jacobian`, ….
    pub name: &'static str,
    /// The arguments of its sines and cosines.
    pub turns: Vec<Turn>,
    /// The steps, operands first.
    pub steps: Vec<Step>,
    /// The results.
    pub outputs: Vec<Output>,
}

impl Program {
    /// The part of the graph that the outputs need, in order, named.
    pub fn flatten(name: &'static str, exprs: &Exprs, outputs: &[(String, Term)]) -> Program {
        let order = reachable(exprs, outputs);
        let position: BTreeMap<Id, usize> = order.iter().enumerate().map(|(i, id)| (*id, i)).collect();
        // What is not there gets an index that no program has, so that `validate` refuses it.
        let at = |id: Id| position.get(&id).copied().unwrap_or(usize::MAX);
        let mut turn_index: Vec<usize> = Vec::new();
        let mut turn_at = |index: usize| {
            turn_index.iter().position(|t| *t == index).unwrap_or_else(|| {
                turn_index.push(index);
                turn_index.len() - 1
            })
        };
        let steps: Vec<Step> = order
            .iter()
            .map(|id| {
                let op = match exprs.node(*id) {
                    Node::Constant(index) => {
                        let meaning = exprs.constant_meaning(index).clone();
                        let value = exprs.ring.value(&meaning).to_f64();
                        Op::Constant(meaning, value)
                    }
                    Node::Param(index) => Op::Param(index),
                    Node::Slide(joint) => Op::Slide(joint),
                    Node::Entry(index) => Op::Entry(index),
                    Node::Cos(turn) => Op::Cos(turn_at(turn)),
                    Node::Sin(turn) => Op::Sin(turn_at(turn)),
                    Node::Add(a, b) => Op::Add(at(a), at(b)),
                    Node::Sub(a, b) => Op::Sub(at(a), at(b)),
                    Node::Zero => Op::Constant(Poly::zero(), 0.0),
                    Node::One => Op::Constant(Poly::integer(1), 1.0),
                    Node::Mul(a, b) => Op::Mul(at(a), at(b)),
                };
                Step { name: None, op }
            })
            .collect();
        let turns = turn_index.iter().map(|t| exprs.turn(*t).clone()).collect();
        let outputs = outputs
            .iter()
            .map(|(name, term)| Output {
                name: name.clone(),
                value: match exprs.node(term.id) {
                    Node::Zero => Value::Unit(0),
                    Node::One => Value::Unit(if term.negative { -1 } else { 1 }),
                    _ => Value::Step { index: at(term.id), negative: term.negative },
                },
            })
            .collect();
        let mut program = Program { name, turns, steps, outputs };
        let called: Vec<Option<bool>> =
            order.iter().map(|id| exprs.label_of(*id).and_then(|(_, negative)| negative)).collect();
        let flipped = signs::settle(&mut program, &called);
        let label = |(id, flipped): (&Id, bool)| {
            exprs.label_of(*id).map(|(name, negative)| Label {
                name: name.to_owned(),
                negative: negative.is_some_and(|n| n != flipped),
            })
        };
        let labels = order.iter().zip(flipped).map(label).collect();
        Namer::new(&exprs.ring, labels).name(&mut program);
        program
    }

    /// How often each step is used, by other steps and by outputs.
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.steps.len()];
        for step in &self.steps {
            for operand in step.op.operands() {
                uses[operand] += 1;
            }
        }
        for output in &self.outputs {
            if let Value::Step { index, .. } = output.value {
                uses[index] += 1;
            }
        }
        uses
    }

    /// What it costs.
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for step in &self.steps {
            match step.op {
                Op::Add(..) | Op::Sub(..) => cost.add += 1,
                Op::Mul(..) => cost.mul += 1,
                Op::Cos(_) | Op::Sin(_) => cost.trig += 1,
                Op::Constant(..) | Op::Param(_) | Op::Slide(_) | Op::Entry(_) => {}
            }
        }
        for (index, turn) in self.turns.iter().enumerate() {
            // What another sum has already added up is not added again.
            let known = self.begun_by(index).map_or(0, |begun| self.turns[begun].joints.len());
            let coefficients = turn.joints.iter().skip(known).chain(&turn.rest.params);
            let scaled = coefficients.clone().filter(|(c, _)| c.abs() != 1).count();
            let terms = coefficients.count() + usize::from(!turn.rest.constant.is_zero());
            cost.mul += scaled;
            cost.add += if known > 0 { terms } else { terms.saturating_sub(1) };
        }
        cost
    }

    /// The longest of the earlier sums of two joint values or more with which a sum begins: q2 + q3 of q2 + q3 + q4.
    /// Sums are added from the left, so that it is the same number.
    pub fn begun_by(&self, turn: usize) -> Option<usize> {
        let joints = &self.turns[turn].joints;
        let begins = |other: &Turn| {
            other.joints.len() > 1
                && other.rest == AngleSum::default()
                && joints.len() >= other.joints.len()
                && joints[..other.joints.len()] == other.joints
        };
        let earlier = (0..turn).filter(|index| begins(&self.turns[*index]));
        earlier.max_by_key(|index| self.turns[*index].joints.len())
    }

    /// What each output means, as a polynomial.
    pub fn expand(&self, ring: &mut Ring, symbols: &Symbols) -> Vec<Poly> {
        let turns: Vec<(Poly, Poly)> = self.turns.iter().map(|t| symbols.cos_sin(ring, t)).collect();
        let mut values: Vec<Poly> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let value = match &step.op {
                Op::Constant(meaning, _) => meaning.clone(),
                Op::Param(index) => symbols.param(ring, *index),
                Op::Slide(joint) => symbols.slide(ring, *joint),
                Op::Entry(index) => symbols.entry(ring, *index),
                Op::Cos(turn) => turns[*turn].0.clone(),
                Op::Sin(turn) => turns[*turn].1.clone(),
                Op::Add(a, b) => ring.add(&values[*a], &values[*b]),
                Op::Sub(a, b) => ring.sub(&values[*a], &values[*b]),
                Op::Mul(a, b) => ring.mul(&values[*a], &values[*b]),
            };
            values.push(value);
        }
        self.outputs
            .iter()
            .map(|output| match output.value {
                Value::Unit(unit) => Poly::integer(i64::from(unit)),
                Value::Step { index, negative: false } => values[index].clone(),
                Value::Step { index, negative: true } => values[index].neg(),
            })
            .collect()
    }

    /// Proves that the outputs are these functions, and that each constant's double is the nearest to its meaning.
    pub fn prove(&self, ring: &mut Ring, symbols: &Symbols, truth: &[Poly]) -> Result<(), Mismatch> {
        self.validate()?;
        for (index, step) in self.steps.iter().enumerate() {
            if let Op::Constant(meaning, value) = &step.op
                && (!ring.is_constant(meaning) || ring.value(meaning).to_f64().to_bits() != value.to_bits())
            {
                return Err(Mismatch::Constant { step: index });
            }
        }
        if self.outputs.len() != truth.len() {
            return Err(Mismatch::Shape);
        }
        let expanded = self.expand(ring, symbols);
        for ((output, got), want) in self.outputs.iter().zip(&expanded).zip(truth) {
            let difference = ring.sub(got, want);
            // Asked first: nothing that an exhausted ring says means anything.
            if ring.exhausted() {
                return Err(Mismatch::TooLarge);
            }
            if !ring.vanishes(&difference) {
                return Err(Mismatch::Output { name: output.name.clone() });
            }
        }
        Ok(())
    }

    /// Checks that operands precede their uses and that every index exists.
    pub fn validate(&self) -> Result<(), Mismatch> {
        for (index, step) in self.steps.iter().enumerate() {
            let turn_exists = match step.op {
                Op::Cos(turn) | Op::Sin(turn) => turn < self.turns.len(),
                _ => true,
            };
            if !turn_exists || step.op.operands().any(|operand| operand >= index) {
                return Err(Mismatch::Shape);
            }
        }
        let steps = self.steps.len();
        let ends = |o: &Output| matches!(o.value, Value::Step { index, .. } if index >= steps);
        if self.outputs.iter().any(ends) { Err(Mismatch::Shape) } else { Ok(()) }
    }
}

impl Op {
    /// The steps it uses.
    pub fn operands(&self) -> impl Iterator<Item = usize> + use<> {
        let (a, b) = match *self {
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) => (Some(a), Some(b)),
            _ => (None, None),
        };
        a.into_iter().chain(b)
    }
}

/// Why a program is not what it should be.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Mismatch {
    /// An output is not the function it should be.
    Output {
        /// Which.
        name: String,
    },
    /// A constant's double is not the nearest to its exact value.
    Constant {
        /// Which step.
        step: usize,
    },
    /// An operand does not precede its use, or the number of outputs is wrong.
    Shape,
    /// The polynomials exceed what can be represented.
    TooLarge,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mismatch::Output { name } => write!(f, "output {name} differs from the matrix product"),
            Mismatch::Constant { step } => write!(f, "the constant of step {step} is not its nearest double"),
            Mismatch::Shape => f.write_str("the program is malformed"),
            Mismatch::TooLarge => f.write_str("the polynomials are too large to be proved equal"),
        }
    }
}

impl std::error::Error for Mismatch {}

/// The nodes that the outputs need: sines and cosines first, then constants, then the rest, each by age. 0 and 1 are
/// among them only as operands; as outputs they stand for themselves.
fn reachable(exprs: &Exprs, outputs: &[(String, Term)]) -> Vec<Id> {
    let mut wanted = vec![false; exprs.nodes().len()];
    for (_, term) in outputs {
        wanted[term.id.0 as usize] = !matches!(exprs.node(term.id), Node::Zero | Node::One);
    }
    for index in (0..wanted.len()).rev() {
        if wanted[index]
            && let Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) = exprs.node(Id(index as u32))
        {
            wanted[a.0 as usize] = true;
            wanted[b.0 as usize] = true;
        }
    }
    let rank = |id: &Id| match exprs.node(*id) {
        Node::Cos(turn) | Node::Sin(turn) => {
            let turn = exprs.turn(turn);
            (0, turn.joints.first().map_or(usize::MAX, |(_, j)| *j), turn.joints.len())
        }
        Node::Param(_) | Node::Slide(_) | Node::Entry(_) => (1, 0, 0),
        Node::Constant(_) | Node::Zero | Node::One => (2, 0, 0),
        _ => (3, 0, 0),
    };
    let mut order: Vec<Id> = (0..wanted.len()).filter(|i| wanted[*i]).map(|i| Id(i as u32)).collect();
    order.sort_by_key(rank);
    order
}
