//! Rust: the trait implementations that `dh!` emits, as text with absolute paths.
//!
//! The code is written to be read: one `let` a step, the table's own names, the cost in the doc comment.

use std::fmt::Write;

use super::infix::{self, Leaves};
use crate::chain::{JointKind, LengthUnit, ParamKind};
use crate::family::base::{Base, Figure, Shape, Stand};
use crate::family::general::General;
use crate::family::spherical_wrist::{Wrist, WristForm};
use crate::model::{Arm, JointFacts, PoseSolver, PositionSolver, Solver};
use crate::number::Real;
use crate::program::{Op, Output, Program, Value};
use crate::quantity::{Linear, Quantity};

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
        let q = format!("q: &{krate}::Joints<T, {n}>");
        let pose = format!("{krate}::Pose<T>");
        let jacobian = format!("{krate}::Jacobian<T, {n}>");
        self.method(text, "The pose of the tool", &programs.fk, &q, &pose, |p| self.pose_value(p, 0));
        let each = |p: &Program| (0..n).map(|i| self.pose_value(p, 12 * i)).collect::<Vec<_>>().join(",\n");
        let frames = format!("[{pose}; {n}]");
        self.method(text, "The frame of each joint", &programs.frames, &q, &frames, |p| {
            format!("[{}]", each(p))
        });
        self.method(text, "The geometric Jacobian", &programs.jacobian, &q, &jacobian, |p| {
            self.jacobian_value(p, 0)
        });
        let both = format!("({pose}, {jacobian})");
        self.method(text, "Pose and Jacobian together", &programs.fk_jacobian, &q, &both, |p| {
            format!("({},\n{})", self.pose_value(p, 0), self.jacobian_value(p, 12))
        });
        line!(text, "}}");
    }

    fn joint(&self, joint: &JointFacts) -> String {
        let kind = match joint.kind {
            JointKind::Revolute => "Revolute",
            JointKind::Prismatic => "Prismatic",
        };
        format!("{0}::Joint {{ name: {1:?}, kind: {0}::JointKind::{kind} }}", self.krate, joint.name)
    }

    fn reach(&self) -> String {
        let krate = self.krate;
        match &self.arm.reach {
            Quantity::SumOfAbsolutes(constant, forms) => {
                let mut text = format!("{:?}", constant.to_f64());
                for form in forms {
                    let linear = self.linear(form, &|v| format!("{v:?}"), &|name| format!("self.{name}"));
                    let _ = write!(text, " + {krate}::private::abs({linear})");
                }
                text
            }
            other => self.quantity(other),
        }
    }

    /// A method whose body is a program.
    fn method(
        &self,
        text: &mut String,
        what: &str,
        program: &Program,
        arguments: &str,
        result: &str,
        value: impl Fn(&Program) -> String,
    ) {
        let krate = self.krate;
        line!(text, "/// {what}: {}.", program.cost());
        line!(text, "fn {}<T: {krate}::Real>(&self, {arguments}) -> {result} {{", program.name);
        self.joints(text, program, arguments);
        self.steps(text, program);
        line!(text, "{}\n}}", value(program));
    }

    /// Binds the joint values and pose entries that the program uses.
    fn joints(&self, text: &mut String, program: &Program, arguments: &str) {
        let slides =
            program.steps.iter().filter_map(|s| if let Op::Slide(j) = s.op { Some(j) } else { None });
        let turned = program.turns.iter().flat_map(|t| t.joints.iter().map(|(_, j)| *j));
        let used: Vec<usize> = slides.chain(turned).collect();
        let bind = |count: usize| {
            let names =
                (0..count).map(|j| if used.contains(&j) { format!("q{}", j + 1) } else { "_".to_owned() });
            names.collect::<Vec<_>>().join(", ")
        };
        if arguments.starts_with("q: &") && !used.is_empty() {
            line!(text, "let [[{}]] = q.data.0;", bind(self.count()));
        }
        if arguments.starts_with("rows: [T; 3]") && !used.is_empty() {
            line!(text, "let [{}] = rows;", bind(3));
        }
        let entries: Vec<usize> = program
            .steps
            .iter()
            .filter_map(|s| if let Op::Entry(e) = s.op { Some(e) } else { None })
            .collect();
        let entry =
            |e: usize| if entries.contains(&e) { crate::truth::entry_name(e) } else { "_".to_owned() };
        let columns: Vec<String> =
            (0..3).map(|j| format!("[{}, {}, {}]", entry(j), entry(3 + j), entry(6 + j))).collect();
        if entries.iter().any(|e| *e < 9) {
            let source = if arguments.starts_with("r36") { "r36" } else { "pose.rotation.matrix()" };
            line!(text, "let [{}] = {source}.data.0;", columns.join(", "));
        }
        if entries.iter().any(|e| *e >= 9) {
            let source =
                if arguments.starts_with("point") { "point.coords" } else { "pose.translation.vector" };
            line!(text, "let [[{}, {}, {}]] = {source}.data.0;", entry(9), entry(10), entry(11));
        }
    }

    fn steps(&self, text: &mut String, program: &Program) {
        self.turns(text, program);
        for (index, step) in program.steps.iter().enumerate() {
            let given = matches!(step.op, Op::Cos(_) | Op::Sin(_) | Op::Slide(_) | Op::Entry(_));
            if let (Some(name), false) = (&step.name, given) {
                line!(text, "let {name} = {};", infix::step(program, index, self));
            }
        }
        for output in &program.outputs {
            if let Some(name) = negated(program, output) {
                line!(text, "let {name} = {};", infix::output(program, output.value, self));
            }
        }
        for (value, name) in [(0, "zero"), (1, "one")] {
            let wanted = |v: Value| matches!(v, Value::Unit(unit) if unit.abs() == value);
            if program.outputs.iter().any(|o| wanted(o.value)) {
                line!(text, "let {name} = T::lit({:?});", f64::from(value));
            }
        }
    }

    /// The sines and cosines of all turns in one call, which has them side by side.
    fn turns(&self, text: &mut String, program: &Program) {
        let named = |wanted: Op| {
            let step = program.steps.iter().find(|s| s.op == wanted);
            step.and_then(|s| s.name.clone()).unwrap_or_else(|| "_".to_owned())
        };
        let list = |item: &dyn Fn(usize) -> String| {
            (0..program.turns.len()).map(item).collect::<Vec<_>>().join(", ")
        };
        let sines = list(&|turn| named(Op::Sin(turn)));
        let cosines = list(&|turn| named(Op::Cos(turn)));
        let angles = list(&|turn| infix::turn(&program.turns[turn], self));
        let krate = self.krate;
        match program.turns.len() {
            0 => {}
            1 => line!(text, "let ({sines}, {cosines}) = {krate}::Real::sin_cos({angles});"),
            _ => line!(text, "let ([{sines}], [{cosines}]) = {krate}::Real::sin_cos_all([{angles}]);"),
        }
    }

    fn output(&self, program: &Program, index: usize) -> String {
        let Some(output) = program.outputs.get(index) else { return String::new() };
        match output.value {
            Value::Unit(0) => "zero".to_owned(),
            Value::Unit(1) => "one".to_owned(),
            Value::Unit(_) => "-one".to_owned(),
            Value::Step { .. } if negated(program, output).is_some() => output.name.clone(),
            value => infix::output(program, value, self),
        }
    }

    fn list(&self, program: &Program, indices: impl Iterator<Item = usize>) -> String {
        let values: Vec<String> = indices.map(|i| self.output(program, i)).collect();
        format!("[{}]", values.join(", "))
    }

    fn rows(&self, program: &Program, start: usize) -> String {
        let rows: Vec<String> =
            (0..3).map(|i| self.list(program, start + 3 * i..start + 3 * i + 3)).collect();
        format!("[{}]", rows.join(",\n"))
    }

    fn pose_value(&self, program: &Program, start: usize) -> String {
        let position = self.list(program, start + 9..start + 12);
        format!("{}::private::pose({}, {position})", self.krate, self.rows(program, start))
    }

    fn jacobian_value(&self, program: &Program, start: usize) -> String {
        let column = |j: usize| self.list(program, start + 6 * j..start + 6 * j + 6);
        let columns: Vec<String> = (0..self.count()).map(column).collect();
        format!("{}::private::jacobian([{}])", self.krate, columns.join(",\n"))
    }

    fn matrix_value(&self, program: &Program) -> String {
        format!("{}::private::matrix({})", self.krate, self.rows(program, 0))
    }

    fn wrist(&self, text: &mut String, solver: &PoseSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let matrix = format!("{krate}::Matrix3<T>");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::SphericalWrist<{n}> for {name} {{");
        let r36 = "q4: T, q5: T, q6: T";
        self.method(text, "³R₆ from the last three row values", &solver.r36, r36, &matrix, |p| {
            self.matrix_value(p)
        });
        let centre = format!("({matrix}, {krate}::Point3<T>)");
        let what = "⁰R₃ and the wrist centre, from the first three row values";
        self.method(text, what, &solver.r03, "q1: T, q2: T, q3: T", &centre, |p| {
            let position = self.list(p, 9..12);
            format!("({}, {krate}::private::point({position}))", self.matrix_value(p))
        });
        let program = &solver.wrist_matrix;
        line!(text, "/// The last three row values from ³R₆, by look-up of its entries.");
        line!(text, "fn wrist_angles<T: {krate}::Float>(&self, r36: &{matrix}) -> {krate}::Wrist<T> {{");
        self.joints(text, program, "r36");
        self.steps(text, program);
        line!(text, "{}\n}}\n}}", self.wrist_value(&solver.geometry.wrist, program));
    }

    fn wrist_value(&self, wrist: &Wrist, program: &Program) -> String {
        let krate = self.krate;
        let m = self.rows(program, 0);
        let offsets: Vec<String> = wrist.offsets.iter().map(|o| self.quantity(o)).collect();
        let offsets = offsets.join(", ");
        match &wrist.form {
            WristForm::Orthogonal => format!("{krate}::private::zyz({m}, [{offsets}], [false; 3])"),
            WristForm::Oblique(between) => {
                let [k4, k5] = [&between[0], &between[1]].map(|k| self.numbers(k));
                format!("{krate}::private::oblique({m}, {k4}, {k5}, [{offsets}], [false; 3])")
            }
        }
    }

    fn numbers(&self, m: &[[Real; 3]; 3]) -> String {
        let row = |r: &[Real; 3]| format!("[{}]", r.map(|v| self.literal(v.to_f64())).join(", "));
        format!("[{}]", m.iter().map(row).collect::<Vec<_>>().join(", "))
    }

    fn pose_inverse(&self, text: &mut String, solver: &PoseSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let pose = format!("pose: &{krate}::Pose<T>");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::SolveWrist<{n}> for {name} {{");
        self.base(text, &solver.geometry.base);
        let what = "The wrist centre of a pose, in the shoulder frame";
        self.method(text, what, &solver.wrist_centre, &pose, "[T; 3]", |p| self.list(p, 0..3));
        let what = "³R₆ of a pose, from the first three row values";
        let matrix = format!("{krate}::Matrix3<T>");
        let arguments = format!("rows: [T; 3], {pose}");
        self.method(text, what, &solver.wrist_rotation, &arguments, &matrix, |p| self.matrix_value(p));
        self.command(text);
        line!(text, "}}");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::InverseKinematics<{n}> for {name} {{");
        line!(text, "type Branch = {krate}::Posture;");
        let solutions = format!("{krate}::Solutions<T, {n}, {krate}::Posture>");
        line!(text, "fn ik<T: {krate}::Float>(&self, {pose}) -> {solutions} {{");
        line!(text, "{krate}::ik::spherical_wrist::solve(self, pose)\n}}");
        let hold = format!("hold: &{krate}::Joints<T, {n}>");
        line!(text, "fn ik_holding<T: {krate}::Float>(&self, {pose}, {hold}) -> {solutions} {{");
        line!(text, "{krate}::ik::spherical_wrist::solve_holding(self, pose, hold)\n}}\n}}");
    }

    fn position_inverse(&self, text: &mut String, solver: &PositionSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let point = format!("point: &{krate}::Point3<T>");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::SolvePosition<{n}> for {name} {{");
        self.base(text, &solver.geometry.base);
        let what = "A point in the shoulder frame";
        self.method(text, what, &solver.tool_point, &point, "[T; 3]", |p| self.list(p, 0..3));
        self.command(text);
        line!(text, "}}");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::PositionInverse<{n}> for {name} {{");
        line!(text, "type Branch = {krate}::ArmPosture;");
        let solutions = format!("{krate}::Solutions<T, {n}, {krate}::ArmPosture>");
        line!(text, "fn ik_position<T: {krate}::Float>(&self, {point}) -> {solutions} {{");
        line!(text, "{krate}::ik::position::solve(self, point)\n}}");
        let hold = format!("hold: &{krate}::Joints<T, {n}>");
        line!(text, "fn ik_position_holding<T: {krate}::Float>(&self, {point}, {hold}) -> {solutions} {{");
        line!(text, "{krate}::ik::position::solve_holding(self, point, hold)\n}}\n}}");
    }

    fn base(&self, text: &mut String, base: &Base) {
        let krate = self.krate;
        line!(text, "/// The base's geometry, measured in the shoulder frame.");
        line!(text, "fn base<T: {krate}::Float>(&self) -> {krate}::Base<T> {{");
        let kind = match &base.shape {
            Shape::General(_) => "General",
            Shape::Stand(stand) => match &stand.figure {
                Figure::Elbow { .. } => "Elbow",
                Figure::Telescope { .. } => "Telescope",
            },
        };
        line!(text, "{krate}::Base::{kind}({krate}::{kind}Base {{");
        match &base.shape {
            Shape::Stand(stand) => self.stand(text, stand),
            Shape::General(general) => self.general(text, general),
        }
        let offsets: Vec<String> = base.offsets.iter().map(|o| self.quantity(o)).collect();
        line!(text, "offset: [{}],", offsets.join(", "));
        if let Shape::Stand(stand) = &base.shape {
            line!(text, "reversed: {:?},", stand.reversed);
        }
        let reach = match self.arm.reach.as_f64() {
            Some(value) => self.literal(value),
            None => format!("T::lit({krate}::Arm::reach(self))"),
        };
        line!(text, "reach: {reach},\n}})\n}}");
    }

    fn stand(&self, text: &mut String, stand: &Stand) {
        let field = |value: &Linear| self.linear_in_t(value);
        line!(text, "a1: {},", field(&stand.shoulder));
        let (sin, cos) = (self.literal(stand.twist.0.to_f64()), self.literal(stand.twist.1.to_f64()));
        line!(text, "twist: ({sin}, {cos}),");
        line!(text, "lateral: {},", field(&stand.lateral));
        match &stand.figure {
            Figure::Elbow { upper, fore } => {
                line!(text, "upper: {},", self.quantity(upper));
                line!(text, "fore: {},", self.quantity(fore));
            }
            Figure::Telescope { arm } => line!(text, "arm: {},", field(arm)),
        }
    }

    fn general(&self, text: &mut String, general: &General) {
        let krate = self.krate;
        let point = |v: &[Linear; 3]| v.each_ref().map(|l| self.linear_in_t(l)).join(", ");
        line!(text, "axes: [");
        for axis in &general.axes {
            let direction = axis.direction.map(|d| self.literal(d.to_f64())).join(", ");
            line!(text, "{krate}::Axis {{ slides: {}, direction: [{direction}],", axis.slides);
            line!(text, "point: [{}] }},", point(&axis.point));
        }
        line!(text, "],\ncarried: [{}],", point(&general.carried));
    }

    /// The way from row values to what the caller commands, and back.
    fn command(&self, text: &mut String) {
        let doc = "What the caller commands, from the rows' own values; linear, without offsets.";
        self.linear_map(text, doc, "command", "rows", &self.arm.uncouple);
        let doc = "The rows' own values, from what the caller commands; linear, without offsets.";
        self.linear_map(text, doc, "rows", "q", &self.arm.couple);
    }

    fn linear_map(&self, text: &mut String, doc: &str, name: &str, argument: &str, matrix: &[Vec<i64>]) {
        let (krate, n) = (self.krate, self.count());
        let identity =
            |(i, row): (usize, &Vec<i64>)| row.iter().enumerate().all(|(j, c)| *c == i64::from(i == j));
        line!(text, "/// {doc}");
        line!(text, "fn {name}<T: {krate}::Real>(&self, {argument}: [T; {n}]) -> [T; {n}] {{");
        if matrix.iter().enumerate().all(identity) {
            line!(text, "{argument}\n}}");
            return;
        }
        let names: Vec<String> = (0..n).map(|j| format!("q{}", j + 1)).collect();
        line!(text, "let [{}] = {argument};", names.join(", "));
        let sums: Vec<String> = matrix.iter().map(|row| self.integer_sum(row)).collect();
        line!(text, "[{}]\n}}", sums.join(", "));
    }

    fn dynamic(&self, text: &mut String) {
        let kind = match self.arm.solver {
            Solver::Pose(_) => "pose",
            Solver::Position(_) => "position",
            Solver::None { .. } => "plain",
        };
        line!(text, "{}::private::dyn_arm! {{ {}, {}, {kind} }}", self.krate, self.arm.name, self.count());
    }

    fn integer_sum(&self, coefficients: &[i64]) -> String {
        let mut text = String::new();
        for (j, coefficient) in coefficients.iter().enumerate().filter(|(_, c)| **c != 0) {
            let factor = match coefficient.unsigned_abs() {
                1 => format!("q{}", j + 1),
                many => format!("{} * q{}", self.literal(many as f64), j + 1),
            };
            infix::append(&mut text, *coefficient < 0, &factor);
        }
        text
    }

    fn no_inverse(&self, text: &mut String, reason: &str) {
        let (name, krate) = (&self.arm.name, self.krate);
        let sentence = format!("`{name}` has no inverse kinematics: {reason}");
        let sentence = format!("{:?}", sentence.replace('{', "(").replace('}', ")"));
        line!(text, "const _: () = {{");
        line!(text, "/// No number is one: it carries the sentence that says why.");
        line!(
            text,
            "#[diagnostic::on_unimplemented(message = {sentence}, label = \"not derived for this arm\")]"
        );
        line!(text, "pub trait NoInverse {{}}");
        // With one implementation that is not to be spoken of, rustc does not propose to write the first one.
        line!(text, "#[diagnostic::do_not_recommend]\nimpl NoInverse for {name} {{}}");
        line!(text, "{ATTRIBUTES}\nimpl {name} {{");
        for (method, argument, branch) in [("ik", "Pose", "Posture"), ("ik_position", "Point3", "ArmPosture")]
        {
            // Its result is what the loop over the solutions expects, so that the sentence stands alone.
            line!(text, "/// Not derived for this arm: {reason}.");
            line!(text, "pub fn {method}<T: {krate}::Float + NoInverse>(&self, _: &{krate}::{argument}<T>)");
            line!(text, "-> {krate}::Solutions<T, {}, {krate}::{branch}> {{ loop {{}} }}", self.count());
        }
        line!(text, "}}\n}};");
    }

    fn quantity(&self, quantity: &Quantity) -> String {
        let krate = self.krate;
        match quantity {
            Quantity::Linear(linear) => self.linear_in_t(linear),
            Quantity::Length(x, y) => {
                format!("{krate}::private::hypot({}, {})", self.linear_in_t(x), self.linear_in_t(y))
            }
            Quantity::Angle(rest, directions) => {
                let mut text = String::new();
                for (negative, x, y) in directions {
                    let (x, y) = (self.linear_in_t(x), self.linear_in_t(y));
                    infix::append(&mut text, *negative, &format!("{krate}::private::atan2({y}, {x})"));
                }
                if !(rest.params.is_empty() && rest.constant.is_zero()) {
                    infix::append(&mut text, false, &format!("({})", self.linear_in_t(rest)));
                }
                text
            }
            Quantity::SumOfAbsolutes(..) => "T::lit(0.0)".to_owned(),
        }
    }

    fn linear_in_t(&self, linear: &Linear) -> String {
        self.linear(linear, &|v| self.literal(v), &|name| format!("T::lit(self.{name})"))
    }

    fn linear(
        &self,
        linear: &Linear,
        literal: &dyn Fn(f64) -> String,
        param: &dyn Fn(&str) -> String,
    ) -> String {
        let mut text = String::new();
        for (coefficient, index) in &linear.params {
            let Some(facts) = self.arm.params.get(*index) else { continue };
            debug_assert!(matches!(facts.kind, ParamKind::Length | ParamKind::Angle));
            let value = coefficient.to_f64();
            let name = param(&facts.name);
            let factor = if value.abs() == 1.0 { name } else { format!("{} * {name}", literal(value.abs())) };
            infix::append(&mut text, value < 0.0, &factor);
        }
        let constant = linear.constant.to_f64();
        if text.is_empty() {
            return literal(constant);
        }
        if constant != 0.0 {
            infix::append(&mut text, constant < 0.0, &literal(constant.abs()));
        }
        text
    }
}

/// The name of an output that is the negative of a step without a name.
fn negated<'a>(program: &Program, output: &'a Output) -> Option<&'a str> {
    match output.value {
        Value::Step { index, negative: true } if program.steps[index].name.is_none() => Some(&output.name),
        _ => None,
    }
}

fn limits(joint: &JointFacts) -> String {
    match joint.limits {
        Some((low, high)) => format!("::core::option::Option::Some(({low:?}, {high:?}))"),
        None => "::core::option::Option::None".to_owned(),
    }
}
