//! The meaning of a program: its steps, carried out one after the other in doubles.
//!
//! Every backend is judged by it.

use crate::algebra::expr::Turn;
use crate::model::Arm;
use crate::program::{Op, Program, Value};

/// What a program is given.
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<'a> {
    /// The joint values: commanded ones, or row values where the program speaks of rows.
    pub joints: &'a [f64],
    /// The parameters: declared lengths, radians.
    pub params: &'a [f64],
    /// The entries of a pose: the rotation by rows, then the position.
    pub entries: &'a [f64],
}

/// The outputs of a program; what is not given counts as 0.
pub fn eval(program: &Program, inputs: Inputs<'_>) -> Vec<f64> {
    let given = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(0.0);
    let mut values: Vec<f64> = Vec::with_capacity(program.steps.len());
    for step in &program.steps {
        let value = match step.op {
            Op::Constant(_, value) => value,
            Op::Param(index) => given(inputs.params, index),
            Op::Slide(joint) => given(inputs.joints, joint),
            Op::Entry(index) => given(inputs.entries, index),
            Op::Cos(turn) => argument(&program.turns[turn], inputs).cos(),
            Op::Sin(turn) => argument(&program.turns[turn], inputs).sin(),
            Op::Add(a, b) => values[a] + values[b],
            Op::Sub(a, b) => values[a] - values[b],
            Op::Mul(a, b) => values[a] * values[b],
        };
        values.push(value);
    }
    let output = |value: Value| match value {
        Value::Unit(unit) => f64::from(unit),
        Value::Step { index, negative: false } => values[index],
        Value::Step { index, negative: true } => -values[index],
    };
    program.outputs.iter().map(|o| output(o.value)).collect()
}

impl Arm {
    /// The tool's pose (rotation and position, by rows) at the nominal parameters.
    pub fn eval_fk(&self, q: &[f64]) -> [[f64; 4]; 3] {
        let values = self.eval_nominal(&self.forward.fk, q);
        let at = |index: usize| values.get(index).copied().unwrap_or(0.0);
        [0, 1, 2].map(|i| [at(3 * i), at(3 * i + 1), at(3 * i + 2), at(9 + i)])
    }

    /// The columns of the Jacobian at the nominal parameters.
    pub fn eval_jacobian(&self, q: &[f64]) -> Vec<[f64; 6]> {
        let values = self.eval_nominal(&self.forward.jacobian, q);
        values.chunks_exact(6).map(|c| [c[0], c[1], c[2], c[3], c[4], c[5]]).collect()
    }

    fn eval_nominal(&self, program: &Program, q: &[f64]) -> Vec<f64> {
        let params: Vec<f64> = self.params.iter().map(|p| p.nominal).collect();
        eval(program, Inputs { joints: q, params: &params, entries: &[] })
    }
}

/// A sum of angles, in the order in which the code adds them: joints, parameters, the constant.
fn argument(turn: &Turn, inputs: Inputs<'_>) -> f64 {
    let term = |values: &[f64], (coefficient, index): &(i64, usize)| {
        let value = values.get(*index).copied().unwrap_or(0.0);
        match *coefficient {
            1 => value,
            -1 => -value,
            other => other as f64 * value,
        }
    };
    let joints = turn.joints.iter().map(|t| term(inputs.joints, t));
    let params = turn.rest.params.iter().map(|t| term(inputs.params, t));
    let constant = (!turn.rest.constant.is_zero()).then(|| turn.rest.constant.to_f64());
    joints.chain(params).chain(constant).reduce(|a, b| a + b).unwrap_or(0.0)
}
