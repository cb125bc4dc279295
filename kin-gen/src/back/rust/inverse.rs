//! What the shared solvers ask of an arm, and the traits through which its user asks them.

use std::fmt::Write;

use super::method::{Given, Gives, Turns};
use super::{ATTRIBUTES, Printer, line};
use crate::algebra::expr::Turn;
use crate::back::infix::{self, Leaves};
use crate::family::short::Carrier;
use crate::family::wrist::{Wrist, WristForm};
use crate::model::{PoseSolver, PositionSolver, ShortSolver, ShoulderSolver};
use crate::program::Program;

/// As many turns as the runtime has places for.
const MOST_TURNS: usize = 8;

/// A trait of the runtime through which an inverse is called.
struct Entry {
    name: &'static str,
    branch: &'static str,
    method: &'static str,
    given: Given,
    /// The runtime's module that solves it.
    solver: &'static str,
}

impl Printer<'_> {
    /// The wrist by itself.
    pub(super) fn wrist(&self, text: &mut String, solver: &PoseSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        line!(text, "{ATTRIBUTES}\nimpl {krate}::SphericalWrist<{n}> for {name} {{");
        let what = "³R₆ from the last three row values";
        self.method(text, what, &solver.r36, Given::Rows(3), Gives::Matrix);
        let what = "⁰R₃ and the wrist centre, from the first three row values";
        self.method(text, what, &solver.r03, Given::Rows(0), Gives::MatrixAndPoint);
        let program = &solver.wrist_matrix;
        line!(text, "/// The last three row values from ³R₆, by look-up of its entries.");
        self.angles(text, "wrist_angles", &solver.geometry.wrist, program, Given::Rotation("r36"));
        line!(text, "}}");
    }

    /// The method that reads three angles from a rotation.
    fn angles(&self, text: &mut String, name: &str, wrist: &Wrist, program: &Program, given: Given) {
        let (krate, argument) = (self.krate, self.arguments(given));
        line!(text, "fn {name}<T: {krate}::Float>(&self, {argument}) -> {krate}::Wrist<T> {{");
        self.steps(text, program, given, Turns::Taken);
        line!(text, "{}\n}}", self.wrist_value(wrist, program));
    }

    /// The inverse of an arm with a spherical wrist.
    pub(super) fn pose_inverse(&self, text: &mut String, solver: &PoseSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::SolveWrist<{n}> for {name} {{");
        self.base(text, &solver.geometry.base);
        let what = "The wrist centre of a pose, in the shoulder frame";
        line!(text, "#[inline(always)]");
        self.method(text, what, &solver.wrist_centre, Given::Pose, Gives::Coordinates);
        let what = "³R₆ of a pose, from the first three row values";
        self.method(text, what, &solver.wrist_rotation, Given::RowsAndPose(0, 3), Gives::Matrix);
        self.side_by_side(text, solver);
        self.command(text);
        line!(text, "}}");
        self.entry(
            text,
            &Entry {
                name: "InverseKinematics",
                branch: "Posture",
                method: "ik",
                given: Given::Pose,
                solver: "spherical_wrist",
            },
        );
    }

    /// What the solver needs to have the branches of an orthogonal wrist side by side.
    fn side_by_side(&self, text: &mut String, solver: &PoseSolver) {
        let (krate, wrist, fk) = (self.krate, &solver.geometry.wrist, &self.arm.forward.fk);
        // More turns than any arm is known to have, or another wrist: its branches come one by one.
        let many = solver.wrist_rotation.turns.len().max(fk.turns.len()) > MOST_TURNS;
        if many || !matches!(wrist.form, WristForm::Orthogonal) {
            return;
        }
        line!(text, "#[inline(always)]");
        line!(text, "fn orthogonal_wrist<T: {krate}::Float>(&self)");
        line!(text, "-> ::core::option::Option<{krate}::private::Rows<T>> {{");
        let offset = self.offsets(&wrist.offsets);
        line!(text, "::core::option::Option::Some({krate}::private::Rows {{");
        line!(text, "offset: [{offset}], reversed: [false; 3] }})\n}}");
        let what = "The matrix of the figure angles, from ³R₆";
        line!(text, "#[inline(always)]");
        self.method(text, what, &solver.wrist_matrix, Given::Rotation("r36"), Gives::Rows);
        self.turned(text, "WRIST", &solver.wrist_rotation, Given::RowsAndPose(0, 3), Gives::Matrix);
        self.turned(text, "FK", fk, Given::Joints, Gives::Pose);
        let coupled = !is_identity(&self.arm.couple);
        line!(text, "const COUPLED: bool = {coupled};");
        let wrist = &solver.wrist_rotation.turns;
        self.known(text, "WRIST", wrist.iter().map(of_rows).collect());
        let known = |turn: &Turn| match wrist.iter().position(|known| known == turn) {
            // Forward kinematics turns by what is commanded, the wrist by row values.
            _ if coupled => "Nothing".to_owned(),
            Some(known) => format!("Wrist({known})"),
            None => of_rows(turn),
        };
        self.known(text, "FK", fk.turns.iter().map(known).collect());
    }

    /// What is known of the turns of a program.
    fn known(&self, text: &mut String, name: &str, mut known: Vec<String>) {
        let krate = self.krate;
        known.resize(MOST_TURNS, "Nothing".to_owned());
        let known: Vec<String> =
            known.iter().map(|known| format!("{krate}::private::Known::{known}")).collect();
        line!(text, "const {name}_KNOWN: [{krate}::private::Known; {MOST_TURNS}] = [{}];", known.join(", "));
    }

    /// A program in two parts: its turns, and the rest of it, which takes their sines and cosines.
    fn turned(&self, text: &mut String, name: &str, program: &Program, given: Given, gives: Gives) {
        let (krate, turns) = (self.krate, program.turns.len());
        let (method, result) = (name.to_lowercase(), self.result(gives));
        let arguments = self.arguments(given);
        let values = arguments.split(", pose").next().unwrap_or_default();
        line!(text, "const {name}_TURNS: usize = {turns};");
        line!(text, "#[inline(always)]");
        line!(text, "fn {method}_turns<T: {krate}::Real>(&self, {values}) -> [T; {MOST_TURNS}] {{");
        self.bind_joints(text, program, given, Turns::Taken);
        let angles = program.turns.iter().map(|turn| infix::turn(turn, self));
        let filled = angles.chain((turns..MOST_TURNS).map(|_| "T::lit(0.0)".to_owned()));
        line!(text, "[{}]\n}}", filled.collect::<Vec<_>>().join(", "));
        line!(text, "#[inline(always)]");
        line!(text, "fn {method}_turned<T: {krate}::Real>(&self, {arguments},");
        line!(text, "sines: &[T; {MOST_TURNS}], cosines: &[T; {MOST_TURNS}]) -> {result} {{");
        self.steps(text, program, given, Turns::Given);
        line!(text, "{}\n}}", self.value(program, gives));
    }

    /// The inverse of an arm with a spherical shoulder.
    pub(super) fn shoulder_inverse(&self, text: &mut String, solver: &ShoulderSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::SolveShoulder<{n}> for {name} {{");
        self.base(text, &solver.geometry.base);
        let what =
            "The centre of the shoulder as the tool of a pose sees it, in the frame of joints 6, 5 and 4";
        self.method(text, what, &solver.shoulder_centre, Given::Pose, Gives::Coordinates);
        let what = "⁰R₃ of a pose, from the last three row values";
        self.method(text, what, &solver.shoulder_rotation, Given::RowsAndPose(3, 3), Gives::Matrix);
        let (shoulder, program) = (&solver.geometry.shoulder, &solver.shoulder_matrix);
        line!(text, "/// The first three row values from ⁰R₃, by look-up of its entries.");
        self.angles(text, "shoulder_angles", shoulder, program, Given::Rotation("r03"));
        self.command(text);
        line!(text, "}}");
        self.entry(
            text,
            &Entry {
                name: "InverseKinematics",
                branch: "ShoulderPosture",
                method: "ik",
                given: Given::Pose,
                solver: "spherical_shoulder",
            },
        );
    }

    /// The inverse of an arm that puts a point in its place.
    pub(super) fn position_inverse(&self, text: &mut String, solver: &PositionSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let (branch, asked, page) = match &solver.geometry.carrier {
            Carrier::Three(_) => ("ArmPosture", "SolvePosition", "position"),
            Carrier::Two(_) => ("Elbow", "SolvePair", "pair"),
        };
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::{asked}<{n}> for {name} {{");
        match &solver.geometry.carrier {
            Carrier::Three(base) => self.base(text, base),
            Carrier::Two(pair) => self.pair(text, pair),
        }
        let what = "A point in the shoulder frame";
        self.method(text, what, &solver.tool_point, Given::Point, Gives::Coordinates);
        self.command(text);
        line!(text, "}}");
        self.entry(
            text,
            &Entry {
                name: "PositionInverse",
                branch,
                method: "ik_position",
                given: Given::Point,
                solver: page,
            },
        );
        if let Some(pose) = &solver.pose {
            self.short_inverse(text, pose);
        }
    }

    /// The inverse of an arm with two to five joints from a pose.
    pub(super) fn short_inverse(&self, text: &mut String, solver: &ShortSolver) {
        let (name, krate, n) = (&self.arm.name, self.krate, self.count());
        let short = &solver.geometry;
        line!(text, "{ATTRIBUTES}\nimpl {krate}::private::SolveShort<{n}> for {name} {{");
        line!(text, "const CARRIERS: usize = {};", short.carriers);
        line!(text, "const ORDER: [usize; {n}] = {:?};", short.order);
        self.carrier(text, &short.carrier);
        self.turns_of(text, &short.turns);
        let what = "The carried point of a pose, in the frame of the joints that carry it";
        self.method(text, what, &solver.carried_point, Given::Pose, Gives::Coordinates);
        let what = "What is left of a pose's rotation for the last joints";
        self.method(text, what, &solver.rest, Given::RowsAndPose(0, n), Gives::Matrix);
        self.command(text);
        line!(text, "}}");
        let branch = match &short.carrier {
            Carrier::Three(_) => "ArmPosture",
            Carrier::Two(_) => "Elbow",
        };
        let entry =
            Entry { name: "InverseKinematics", branch, method: "ik", given: Given::Pose, solver: "short" };
        self.entry(text, &entry);
    }

    /// The trait through which an inverse is called.
    fn entry(&self, text: &mut String, entry: &Entry) {
        let (arm, krate, n) = (&self.arm.name, self.krate, self.count());
        let Entry { name, branch, method, given, solver } = *entry;
        let argument = self.arguments(given);
        let asked = argument.split(':').next().unwrap_or_default();
        let solutions = format!("{krate}::Solutions<T, {n}, {krate}::{branch}>");
        let hold = format!("hold: &{krate}::Joints<T, {n}>");
        line!(text, "{ATTRIBUTES}\nimpl {krate}::{name}<{n}> for {arm} {{");
        line!(text, "type Branch = {krate}::{branch};");
        line!(text, "fn {method}<T: {krate}::Float>(&self, {argument}) -> {solutions} {{");
        line!(text, "{krate}::ik::{solver}::solve(self, {asked})\n}}");
        line!(text, "fn {method}_holding<T: {krate}::Float>(&self, {argument}, {hold}) -> {solutions} {{");
        line!(text, "{krate}::ik::{solver}::solve_holding(self, {asked}, hold)\n}}");
        if solver == "spherical_wrist" {
            line!(text, "#[doc(hidden)]\n#[inline(always)]");
            line!(text, "fn {method}_each<T: {krate}::Float>(&self, poses: &[{krate}::Pose<T>],");
            line!(text, "places: &mut [::core::option::Option<{solutions}>]) {{");
            line!(text, "{krate}::ik::{solver}::solve_each(self, poses, places)\n}}");
        }
        line!(text, "}}");
    }

    /// The sentence for whoever asks an arm that has no inverse.
    pub(super) fn no_inverse(&self, text: &mut String, reason: &str) {
        let methods = [("ik", "Pose", "Posture"), ("ik_position", "Point3", "ArmPosture")];
        self.refuse(text, "inverse kinematics", reason, &methods);
    }

    /// The sentence for whoever asks an arm for a position that would leave joints free.
    pub(super) fn no_position(&self, text: &mut String) {
        let reason = "a position alone would leave joints free in every solution; `ik` takes a pose";
        self.refuse(
            text,
            "inverse kinematics from a position",
            reason,
            &[("ik_position", "Point3", "ArmPosture")],
        );
    }

    /// Methods, each with its argument and its labels, that cannot be called, and why.
    fn refuse(&self, text: &mut String, what: &str, reason: &str, methods: &[(&str, &str, &str)]) {
        let (name, krate) = (&self.arm.name, self.krate);
        let sentence = format!("`{name}` has no {what}: {reason}");
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
        for (method, argument, branch) in methods {
            // Its result is what the loop over the solutions expects, so that the sentence stands alone.
            line!(text, "/// Not derived for this arm: {reason}.");
            line!(text, "pub fn {method}<T: {krate}::Float + NoInverse>(&self, _: &{krate}::{argument}<T>)");
            line!(text, "-> {krate}::Solutions<T, {}, {krate}::{branch}> {{ loop {{}} }}", self.count());
        }
        line!(text, "}}\n}};");
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
        line!(text, "/// {doc}");
        line!(text, "#[inline(always)]");
        line!(text, "fn {name}<T: {krate}::Real>(&self, {argument}: [T; {n}]) -> [T; {n}] {{");
        if is_identity(matrix) {
            line!(text, "{argument}\n}}");
            return;
        }
        let names: Vec<String> = (0..n).map(|j| format!("q{}", j + 1)).collect();
        line!(text, "let [{}] = {argument};", names.join(", "));
        let sums: Vec<String> = matrix.iter().map(|row| self.integer_sum(row)).collect();
        line!(text, "[{}]\n}}", sums.join(", "));
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
}

/// What row values tell of a turn by them.
fn of_rows(turn: &Turn) -> String {
    match turn.joints.as_slice() {
        _ if turn.rest != Turn::default().rest => "Nothing".to_owned(),
        [(1, joint)] => format!("Row({joint})"),
        [(1, joint), (1, other)] => format!("Sum({joint}, {other})"),
        [(1, joint), (-1, other)] | [(-1, other), (1, joint)] => format!("Difference({joint}, {other})"),
        _ => "Nothing".to_owned(),
    }
}

/// Whether a matrix leaves every vector as it is.
fn is_identity(matrix: &[Vec<i64>]) -> bool {
    let row = |(i, row): (usize, &Vec<i64>)| row.iter().enumerate().all(|(j, c)| *c == i64::from(i == j));
    matrix.iter().enumerate().all(row)
}
