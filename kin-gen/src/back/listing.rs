//! The listing: every program as it is, one step a line, for people and for golden tests.

use std::fmt::Write;

use super::infix::{self, Leaves};
use crate::model::{Arm, Solver};
use crate::program::{Op, Program};

struct Plain<'a>(&'a Arm);

impl Leaves for Plain<'_> {
    fn literal(&self, value: f64) -> String {
        format!("{value}")
    }

    fn param(&self, index: usize) -> String {
        self.0.params.get(index).map_or_else(String::new, |p| p.name.clone())
    }
}

/// All programs of an arm.
pub fn print(arm: &Arm) -> String {
    let mut text = String::new();
    for program in programs(arm) {
        text.push_str(&listing(arm, program));
        text.push('\n');
    }
    text
}

/// The programs of an arm, in a fixed order.
pub fn programs(arm: &Arm) -> Vec<&Program> {
    let forward = &arm.forward;
    let mut programs = vec![&forward.fk, &forward.frames, &forward.jacobian, &forward.fk_jacobian];
    match &arm.solver {
        Solver::Pose(s) => {
            programs.extend([&s.r36, &s.r03, &s.wrist_centre, &s.wrist_rotation, &s.wrist_matrix])
        }
        Solver::Shoulder(s) => {
            programs.extend([&s.shoulder_centre, &s.shoulder_rotation, &s.shoulder_matrix])
        }
        Solver::Short(s) => programs.extend([&s.carried_point, &s.rest]),
        Solver::Position(s) => {
            programs.push(&s.tool_point);
            programs.extend(s.pose.iter().flat_map(|s| [&s.carried_point, &s.rest]));
        }
        Solver::None { .. } => {}
    }
    programs
}

/// One program.
pub fn listing(arm: &Arm, program: &Program) -> String {
    let leaves = Plain(arm);
    let mut text = format!("{}: {}\n", program.name, program.cost());
    // Writing to a string cannot fail.
    for (index, step) in program.steps.iter().enumerate() {
        let given = matches!(step.op, Op::Slide(_) | Op::Entry(_));
        if let (Some(name), false) = (&step.name, given) {
            let _ = writeln!(text, "    {name} = {}", infix::step(program, index, &leaves));
        }
    }
    for output in &program.outputs {
        let value = infix::output(program, output.value, &leaves);
        if value != output.name {
            let _ = writeln!(text, "    out {} = {value}", output.name);
        } else {
            let _ = writeln!(text, "    out {value}");
        }
    }
    text
}
