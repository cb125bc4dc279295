//! Methods whose body is a program: what they are given, what they give back, and the steps between.

use std::fmt::Write;
use std::ops::Range;

use super::{Printer, line};
use crate::back::infix;
use crate::program::{Op, Output, Program, Value};
use crate::truth::entry_name;

/// What a program starts from: the arguments of its method, and where its variables come from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Given {
    /// All commanded values, as a vector.
    Joints,
    /// The row values of three joints, each an argument of its own; the first of them, counted from 0.
    Rows(usize),
    /// A pose.
    Pose,
    /// The row values of some joints, together, and a pose: the first of them, counted from 0, and how many.
    RowsAndPose(usize, usize),
    /// A point.
    Point,
    /// A rotation, by its name: `r36`.
    Rotation(&'static str),
}

/// What a program's outputs are put into.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Gives {
    /// One pose.
    Pose,
    /// One pose for each joint.
    Frames,
    /// A Jacobian.
    Jacobian,
    /// A pose, then a Jacobian.
    PoseAndJacobian,
    /// A 3×3 matrix.
    Matrix,
    /// The rows of a 3×3 matrix.
    Rows,
    /// A 3×3 matrix, then a point.
    MatrixAndPoint,
    /// Three coordinates.
    Coordinates,
}

/// Where a program has the sines and cosines of its turns from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Turns {
    /// It takes them itself.
    Taken,
    /// They are arguments.
    Given,
}

impl Printer<'_> {
    /// The arguments after `&self`.
    pub(super) fn arguments(&self, given: Given) -> String {
        let (krate, n) = (self.krate, self.count());
        match given {
            Given::Joints => format!("q: &{krate}::Joints<T, {n}>"),
            Given::Rows(first) => {
                (1..=3).map(|j| format!("q{}: T", first + j)).collect::<Vec<_>>().join(", ")
            }
            Given::Pose => format!("pose: &{krate}::Pose<T>"),
            Given::RowsAndPose(_, count) => format!("rows: [T; {count}], pose: &{krate}::Pose<T>"),
            Given::Point => format!("point: &{krate}::Point3<T>"),
            Given::Rotation(name) => format!("{name}: &{krate}::Matrix3<T>"),
        }
    }

    pub(super) fn result(&self, gives: Gives) -> String {
        let (krate, n) = (self.krate, self.count());
        let (pose, jacobian) = (format!("{krate}::Pose<T>"), format!("{krate}::Jacobian<T, {n}>"));
        match gives {
            Gives::Pose => pose,
            Gives::Frames => format!("[{pose}; {n}]"),
            Gives::Jacobian => jacobian,
            Gives::PoseAndJacobian => format!("({pose}, {jacobian})"),
            Gives::Matrix => format!("{krate}::Matrix3<T>"),
            Gives::Rows => "[[T; 3]; 3]".to_owned(),
            Gives::MatrixAndPoint => format!("({krate}::Matrix3<T>, {krate}::Point3<T>)"),
            Gives::Coordinates => "[T; 3]".to_owned(),
        }
    }

    /// A method whose body is a program.
    pub(super) fn method(
        &self,
        text: &mut String,
        what: &str,
        program: &Program,
        given: Given,
        gives: Gives,
    ) {
        let (krate, arguments, result) = (self.krate, self.arguments(given), self.result(gives));
        line!(text, "/// {what}: {}.", program.cost());
        line!(text, "fn {}<T: {krate}::Real>(&self, {arguments}) -> {result} {{", program.name);
        self.steps(text, program, given, Turns::Taken);
        line!(text, "{}\n}}", self.value(program, gives));
    }

    /// Two methods with one program: one to be called, and one that is inlined wherever it is called, so that it can be
    /// compiled for other instructions than the rest of the program.
    pub(super) fn method_and_inlined(&self, text: &mut String, what: &str, program: &Program, gives: Gives) {
        let (krate, name, result) = (self.krate, &program.name, self.result(gives));
        let arguments = self.arguments(Given::Joints);
        line!(text, "/// {what}: {}.", program.cost());
        line!(
            text,
            "fn {name}<T: {krate}::Real>(&self, {arguments}) -> {result} {{ self.{name}_inlined(q) }}"
        );
        line!(text, "#[inline(always)]");
        line!(text, "fn {name}_inlined<T: {krate}::Real>(&self, {arguments}) -> {result} {{");
        self.steps(text, program, Given::Joints, Turns::Taken);
        line!(text, "{}\n}}", self.value(program, gives));
    }

    /// The body of a method but for its value.
    pub(super) fn steps(&self, text: &mut String, program: &Program, given: Given, turns: Turns) {
        self.bind_joints(text, program, given, turns);
        bind_entries(text, program, given);
        self.turns(text, program, turns);
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

    /// Binds the joint values that the program uses, those of its turns too if it takes them itself, where they come as a
    /// vector.
    pub(super) fn bind_joints(&self, text: &mut String, program: &Program, given: Given, turns: Turns) {
        let slides =
            program.steps.iter().filter_map(|s| if let Op::Slide(j) = s.op { Some(j) } else { None });
        let turns = program.turns.iter().filter(|_| turns == Turns::Taken);
        let turned = turns.flat_map(|t| t.joints.iter().map(|(_, j)| *j));
        let used: Vec<usize> = slides.chain(turned).collect();
        if used.is_empty() {
            return;
        }
        let name = |j: usize| if used.contains(&j) { format!("q{}", j + 1) } else { "_".to_owned() };
        let bind = |joints: Range<usize>| joints.map(name).collect::<Vec<_>>().join(", ");
        match given {
            Given::Joints => line!(text, "let [[{}]] = q.data.0;", bind(0..self.count())),
            Given::RowsAndPose(first, count) => {
                line!(text, "let [{}] = rows;", bind(first..first + count));
            }
            Given::Rows(_) | Given::Pose | Given::Point | Given::Rotation(_) => {}
        }
    }

    /// The sines and cosines of all turns in one call, which has them side by side.
    fn turns(&self, text: &mut String, program: &Program, turns: Turns) {
        let named = |wanted: Op| {
            let step = program.steps.iter().find(|s| s.op == wanted);
            step.and_then(|s| s.name.clone()).unwrap_or_else(|| "_".to_owned())
        };
        let list = |item: &dyn Fn(usize) -> String| {
            (0..program.turns.len()).map(item).collect::<Vec<_>>().join(", ")
        };
        let sines = list(&|turn| named(Op::Sin(turn)));
        let cosines = list(&|turn| named(Op::Cos(turn)));
        let taken = (0..program.turns.len()).filter(|_| turns == Turns::Taken);
        for turn in taken.filter(|turn| begins_another(program, *turn)) {
            line!(text, "let {} = {};", self.sum_name(program, turn), self.angle(program, turn));
        }
        let angles = list(&|turn| match begins_another(program, turn) {
            true => self.sum_name(program, turn),
            false => self.angle(program, turn),
        });
        let krate = self.krate;
        match program.turns.len() {
            0 => {}
            _ if turns == Turns::Given => {
                line!(text, "let ([{sines}, ..], [{cosines}, ..]) = (*sines, *cosines);")
            }
            1 => line!(text, "let ({sines}, {cosines}) = {krate}::Real::sin_cos({angles});"),
            _ => line!(text, "let ([{sines}], [{cosines}]) = {krate}::Real::sin_cos_all([{angles}]);"),
        }
    }

    /// A sum of angles, from the sum that it begins with if there is one.
    fn angle(&self, program: &Program, turn: usize) -> String {
        let Some(begun) = program.begun_by(turn) else { return infix::turn(&program.turns[turn], self) };
        let mut rest = program.turns[turn].clone();
        rest.joints.drain(..program.turns[begun].joints.len());
        infix::turn_from(self.sum_name(program, begun), &rest, self)
    }

    /// `q23` for q2 + q3; `q_23` where that could be a joint's own name.
    fn sum_name(&self, program: &Program, turn: usize) -> String {
        let is_of = |op: &Op| *op == Op::Sin(turn) || *op == Op::Cos(turn);
        let name = program.steps.iter().find(|s| is_of(&s.op)).and_then(|s| s.name.as_deref());
        let suffix = name.and_then(|name| name.get(1..)).unwrap_or_default();
        format!("{}{suffix}", if self.arm.joints.len() < 10 { "q" } else { "q_" })
    }

    pub(super) fn value(&self, program: &Program, gives: Gives) -> String {
        let krate = self.krate;
        let matrix = || format!("{krate}::private::matrix({})", self.rows(program));
        match gives {
            Gives::Pose => self.pose(program, 0),
            Gives::Frames => {
                let frames = (0..self.count()).map(|i| self.pose(program, 12 * i));
                format!("[{}]", frames.collect::<Vec<_>>().join(",\n"))
            }
            Gives::Jacobian => self.jacobian(program, 0),
            Gives::PoseAndJacobian => {
                format!("({},\n{})", self.pose(program, 0), self.jacobian(program, 12))
            }
            Gives::Matrix => matrix(),
            Gives::Rows => self.rows(program),
            Gives::MatrixAndPoint => {
                format!("({}, {krate}::private::point({}))", matrix(), self.list(program, 9, 3))
            }
            Gives::Coordinates => self.list(program, 0, 3),
        }
    }

    /// The first nine outputs, by rows.
    pub(super) fn rows(&self, program: &Program) -> String {
        self.rows_from(program, 0)
    }

    fn rows_from(&self, program: &Program, start: usize) -> String {
        let rows: Vec<String> = (0..3).map(|i| self.list(program, start + 3 * i, 3)).collect();
        format!("[{}]", rows.join(",\n"))
    }

    fn pose(&self, program: &Program, start: usize) -> String {
        let position = self.list(program, start + 9, 3);
        format!("{}::private::pose({}, {position})", self.krate, self.rows_from(program, start))
    }

    fn jacobian(&self, program: &Program, start: usize) -> String {
        let columns: Vec<String> = (0..self.count()).map(|j| self.list(program, start + 6 * j, 6)).collect();
        format!("{}::private::jacobian([{}])", self.krate, columns.join(",\n"))
    }

    fn list(&self, program: &Program, start: usize, count: usize) -> String {
        let values: Vec<String> = (start..start + count).map(|i| self.output(program, i)).collect();
        format!("[{}]", values.join(", "))
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
}

/// Binds the entries of the given pose, point or rotation that the program uses.
fn bind_entries(text: &mut String, program: &Program, given: Given) {
    let used = |e: usize| program.steps.iter().any(|s| s.op == Op::Entry(e));
    let entry = |e: usize| if used(e) { entry_name(e) } else { "_".to_owned() };
    let (rotation, position) = match given {
        Given::Pose | Given::RowsAndPose(..) => ("pose.rotation.matrix()", "pose.translation.vector"),
        Given::Rotation(name) => (name, ""),
        Given::Point => ("", "point.coords"),
        Given::Joints | Given::Rows(_) => return,
    };
    if (0..9).any(used) {
        let columns: Vec<String> =
            (0..3).map(|j| format!("[{}, {}, {}]", entry(j), entry(3 + j), entry(6 + j))).collect();
        line!(text, "let [{}] = {rotation}.data.0;", columns.join(", "));
    }
    if (9..12).any(used) {
        line!(text, "let [[{}, {}, {}]] = {position}.data.0;", entry(9), entry(10), entry(11));
    }
}

/// The name of an output that is the negative of a step without a name.
fn negated<'a>(program: &Program, output: &'a Output) -> Option<&'a str> {
    match output.value {
        Value::Step { index, negative: true } if program.steps[index].name.is_none() => Some(&output.name),
        _ => None,
    }
}

/// Whether a later sum of angles begins with this one.
fn begins_another(program: &Program, turn: usize) -> bool {
    (turn + 1..program.turns.len()).any(|later| program.begun_by(later) == Some(turn))
}
