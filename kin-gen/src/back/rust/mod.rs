//! Rust: the trait implementations that `dh!` emits, as text with absolute paths.
//!
//! The code is written to be read: one `let` a step, the table's own names, the cost in the doc comment. `method` prints
//! programs, `geometry` what the shared solvers are told, `inverse` the traits through which they are asked.

mod geometry;
mod inverse;
mod method;

use std::fmt::Write;

use super::infix::Leaves;
use crate::chain::{JointKind, LengthUnit};
use crate::model::{Arm, JointFacts, Solver};
use method::{Given, Gives};

/// All items of an arm except its struct.
pub fn items(arm: &Arm, krate: &str) -> String {
    let printer = Printer { arm, krate };
    let mut text = String::new();
    printer.inherent(&mut text);
    printer.forward(&mut text);
    match &arm.solver {
        Solver::Pose(solver) => {
            printer.wrist(&mut text, solver);
            printer.pose_inverse(&mut text, solver);
        }
        Solver::Shoulder(solver) => printer.shoulder_inverse(&mut text, solver),
        Solver::Short(solver) => {
            printer.short_inverse(&mut text, solver);
            printer.no_position(&mut text);
        }
        Solver::Position(solver) => printer.position_inverse(&mut text, solver),
        Solver::None { reason, .. } => printer.no_inverse(&mut text, reason),
    }
    printer.dynamic(&mut text);
    text
}

struct Printer<'a> {
    arm: &'a Arm,
    krate: &'a str,
}

impl Leaves for Printer<'_> {
    fn literal(&self, value: f64) -> String {
        format!("T::lit({value:?})")
    }

    fn param(&self, index: usize) -> String {
        self.arm.params.get(index).map_or_else(String::new, |p| format!("T::lit(self.{})", p.name))
    }
}

/// Appends one line; writing to a string cannot fail.
macro_rules! line {
    ($text:expr, $($arguments:tt)*) => {{ let _ = writeln!($text, $($arguments)*); }};
}
use line;

/// Attributes of every generated implementation.
const ATTRIBUTES: &str = "#[automatically_derived]\n#[allow(clippy::all, clippy::pedantic, clippy::nursery)]";

impl Printer<'_> {
    fn count(&self) -> usize {
        self.arm.joints.len()
    }

    fn inherent(&self, text: &mut String) {
        let name = &self.arm.name;
        let fields: Vec<String> =
            self.arm.params.iter().map(|p| format!("{}: {:?}", p.name, p.nominal)).collect();
        let value =
            if fields.is_empty() { "Self".to_owned() } else { format!("Self {{ {} }}", fields.join(", ")) };
        line!(text, "{ATTRIBUTES}\nimpl {name} {{");
        line!(text, "/// The arm with the declared values of its parameters.");
        line!(text, "pub const NOMINAL: Self = {value};\n}}");
        line!(text, "{ATTRIBUTES}\nimpl ::core::default::Default for {name} {{");
        line!(text, "fn default() -> Self {{ Self::NOMINAL }}\n}}");
    }

    fn forward(&self, text: &mut String) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let unit = match self.arm.length_unit {
            LengthUnit::Metre => "Metre",
            LengthUnit::Centimetre => "Centimetre",
            LengthUnit::Millimetre => "Millimetre",
            LengthUnit::Inch => "Inch",
        };
        let joints: Vec<String> = self.arm.joints.iter().map(|j| self.joint(j)).collect();
        line!(text, "{ATTRIBUTES}\nimpl {krate}::Arm<{n}> for {name} {{");
        line!(text, "const NAME: &'static str = {name:?};");
        line!(text, "const LENGTH_UNIT: {krate}::LengthUnit = {krate}::LengthUnit::{unit};");
        line!(text, "const TABLE: &'static str = {:?};", self.arm.text);
        line!(text, "const JOINTS: [{krate}::Joint; {n}] = [{}];", joints.join(", "));
        line!(text, "fn reach(&self) -> f64 {{ {} }}", self.reach());
        line!(text, "fn limits(&self) -> {krate}::Limits<{n}> {{");
        let limits: Vec<String> = self.arm.joints.iter().map(limits).collect();
        line!(text, "{krate}::Limits::new([{}])\n}}", limits.join(", "));
        let programs = &self.arm.forward;
        self.method_and_inlined(text, "The pose of the tool", &programs.fk, Gives::Pose);
        self.method(text, "The frame of each joint", &programs.frames, Given::Joints, Gives::Frames);
        self.method_and_inlined(text, "The geometric Jacobian", &programs.jacobian, Gives::Jacobian);
        let what = "Pose and Jacobian together";
        self.method_and_inlined(text, what, &programs.fk_jacobian, Gives::PoseAndJacobian);
        line!(text, "}}");
    }

    fn joint(&self, joint: &JointFacts) -> String {
        let kind = match joint.kind {
            JointKind::Revolute => "Revolute",
            JointKind::Prismatic => "Prismatic",
        };
        format!("{0}::Joint {{ name: {1:?}, kind: {0}::JointKind::{kind} }}", self.krate, joint.name)
    }

    fn dynamic(&self, text: &mut String) {
        let kind = match &self.arm.solver {
            Solver::Pose(_) | Solver::Shoulder(_) | Solver::Short(_) => "pose",
            Solver::Position(solver) if solver.pose.is_some() => "both",
            Solver::Position(_) => "position",
            Solver::None { .. } => "plain",
        };
        line!(text, "{}::private::dyn_arm! {{ {}, {}, {kind} }}", self.krate, self.arm.name, self.count());
    }
}

fn limits(joint: &JointFacts) -> String {
    match joint.limits {
        Some((low, high)) => format!("::core::option::Option::Some(({low:?}, {high:?}))"),
        None => "::core::option::Option::None".to_owned(),
    }
}
