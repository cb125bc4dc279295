//! An arm from text, at run time: its programs interpreted, its geometry built from its quantities.
//!
//! Lets the shared solver be tried on thousands of arms that nobody declared. The programs are those that generated
//! code prints; what stands between them and the runtime, and only that, is repeated here.

use kin_gen::algebra::expr::Turn;
use kin_gen::family::base::{Base as GenBase, Figure, Shape};
use kin_gen::family::wrist::{Wrist as GenWrist, WristForm};
use kin_gen::model::{Arm as Derived, PoseSolver, Solver};
use kin_gen::program::{Op, Program, Value};
use kin_gen::quantity::{Linear, Quantity};
use kin_runtime::ik::{Axis, Base, ElbowBase, GeneralBase, TelescopeBase, Wrist};
use kin_runtime::{
    Arm, Float, InverseKinematics, Jacobian, Joint, JointKind, Joints, LengthUnit, Limits, Matrix3, Point3,
    Pose, Posture, Real, Solutions, SphericalWrist, private,
};

/// A derived arm with six joints and an inverse; joint i slides if bit i of `SLIDES` is set.
pub struct Interpreted<const SLIDES: u8> {
    derived: Derived,
    /// The values of the parameters.
    pub params: Vec<f64>,
}

impl<const SLIDES: u8> Interpreted<SLIDES> {
    /// `None` if the arm has no spherical wrist.
    pub fn new(derived: Derived) -> Option<Self> {
        matches!(derived.solver, Solver::Pose(_)).then(|| Interpreted::nominal(derived))
    }

    /// With the nominal values of its parameters.
    pub(crate) fn nominal(derived: Derived) -> Self {
        let params = derived.params.iter().map(|p| p.nominal).collect();
        Interpreted { derived, params }
    }

    pub(crate) fn derived(&self) -> &Derived {
        &self.derived
    }

    fn solver(&self) -> &PoseSolver {
        match &self.derived.solver {
            Solver::Pose(solver) => solver,
            other => unreachable!("`new` lets only pose solvers through: {other:?}"),
        }
    }

    pub(crate) fn run<T: Real>(&self, program: &Program, joints: &[T], entries: &[T]) -> Vec<T> {
        interpret(program, joints, &self.params, entries)
    }

    fn linear<T: Float>(&self, linear: &Linear) -> T {
        let terms = linear.params.iter().map(|(c, i)| c.to_f64() * self.params[*i]);
        T::lit(terms.sum::<f64>() + linear.constant.to_f64())
    }

    fn quantity<T: Float>(&self, quantity: &Quantity) -> T {
        match quantity {
            Quantity::Linear(linear) => self.linear(linear),
            Quantity::Length(x, y) => private::hypot(self.linear(x), self.linear(y)),
            Quantity::Angle(rest, directions) => {
                directions.iter().fold(self.linear(rest), |sum, (negative, x, y)| {
                    let angle: T = private::atan2(self.linear(y), self.linear(x));
                    if *negative { sum - angle } else { sum + angle }
                })
            }
            Quantity::SumOfAbsolutes(constant, forms) => {
                let forms = forms.iter().map(|f| self.linear::<f64>(f).abs());
                T::lit(constant.to_f64() + forms.sum::<f64>())
            }
        }
    }

    pub(crate) fn base_of<T: Float>(&self, base: &GenBase) -> Base<T> {
        let [o1, o2, o3] = &base.offsets;
        let offset = [self.quantity(o1), self.quantity(o2), self.quantity(o3)];
        let reach = T::lit(self.reach());
        let stand = match &base.shape {
            Shape::Stand(stand) => stand,
            Shape::General(general) => {
                let point = |v: &[Linear; 3]| v.each_ref().map(|l| self.linear(l));
                let axes = general.axes.each_ref().map(|axis| Axis {
                    slides: axis.slides,
                    direction: axis.direction.map(|d| T::lit(d.to_f64())),
                    point: point(&axis.point),
                });
                let carried = point(&general.carried);
                return Base::General(GeneralBase { axes, carried, offset, reach });
            }
        };
        let a1 = self.linear(&stand.shoulder);
        let twist = (T::lit(stand.twist.0.to_f64()), T::lit(stand.twist.1.to_f64()));
        let (lateral, reversed) = (self.linear(&stand.lateral), stand.reversed);
        match &stand.figure {
            Figure::Elbow { upper, fore } => {
                let (upper, fore) = (self.quantity(upper), self.quantity(fore));
                Base::Elbow(ElbowBase { a1, twist, lateral, upper, fore, offset, reversed, reach })
            }
            Figure::Telescope { arm } => {
                let arm = self.linear(arm);
                Base::Telescope(TelescopeBase { a1, twist, lateral, arm, offset, reversed, reach })
            }
        }
    }
}

impl<const SLIDES: u8> Interpreted<SLIDES> {
    /// Three angles read from a rotation.
    pub(crate) fn angles_of<T: Float>(
        &self,
        wrist: &GenWrist,
        program: &Program,
        rotation: &Matrix3<T>,
    ) -> Wrist<T> {
        let entries = [0, 1, 2].map(|i| [0, 1, 2].map(|j| rotation[(i, j)]));
        let m = rows(&self.run(program, &[], entries.as_flattened()));
        let [o4, o5, o6] = &wrist.offsets;
        let offsets = [self.quantity(o4), self.quantity(o5), self.quantity(o6)];
        match &wrist.form {
            WristForm::Orthogonal => private::zyz(m, offsets, [false; 3]),
            WristForm::Oblique(between) => {
                let [k4, k5] = [0, 1].map(|k| between[k].map(|row| row.map(|x| T::lit(x.to_f64()))));
                private::oblique(m, k4, k5, offsets, [false; 3])
            }
        }
    }
}

/// A program's outputs, in any kind of number, each operation in the order in which generated code does it.
pub fn interpret<T: Real>(program: &Program, joints: &[T], params: &[f64], entries: &[T]) -> Vec<T> {
    let turns: Vec<(T, T)> = program.turns.iter().map(|t| argument(t, joints, params).sin_cos()).collect();
    let mut values: Vec<T> = Vec::with_capacity(program.steps.len());
    for step in &program.steps {
        let value = match step.op {
            Op::Constant(_, value) => T::lit(value),
            Op::Param(index) => T::lit(params[index]),
            Op::Slide(joint) => joints[joint],
            Op::Entry(index) => entries[index],
            Op::Sin(turn) => turns[turn].0,
            Op::Cos(turn) => turns[turn].1,
            Op::Add(a, b) => values[a] + values[b],
            Op::Sub(a, b) => values[a] - values[b],
            Op::Mul(a, b) => values[a] * values[b],
        };
        values.push(value);
    }
    let output = |value: Value| match value {
        Value::Unit(unit) => T::lit(f64::from(unit)),
        Value::Step { index, negative: false } => values[index],
        Value::Step { index, negative: true } => -values[index],
    };
    program.outputs.iter().map(|o| output(o.value)).collect()
}

fn argument<T: Real>(turn: &Turn, joints: &[T], params: &[f64]) -> T {
    let scaled = |coefficient: i64, value: T| match coefficient {
        1 => value,
        -1 => -value,
        other => T::lit(other as f64) * value,
    };
    let joints = turn.joints.iter().map(|(c, j)| scaled(*c, joints[*j]));
    let params = turn.rest.params.iter().map(|(c, p)| scaled(*c, T::lit(params[*p])));
    let constant = (!turn.rest.constant.is_zero()).then(|| T::lit(turn.rest.constant.to_f64()));
    joints.chain(params).chain(constant).reduce(|a, b| a + b).unwrap_or_else(|| T::lit(0.0))
}

pub(crate) fn rows<T: Real>(values: &[T]) -> [[T; 3]; 3] {
    [0, 3, 6].map(|i| [values[i], values[i + 1], values[i + 2]])
}

fn pose<T: Real>(values: &[T]) -> Pose<T> {
    private::pose(rows(values), [values[9], values[10], values[11]])
}

pub(crate) fn entries<T: Real>(pose: &Pose<T>) -> Vec<T> {
    let (rotation, position) = private::entries(pose);
    rotation.into_iter().flatten().chain(position).collect()
}

fn columns<T: Real>(values: &[T]) -> [[T; 6]; 6] {
    std::array::from_fn(|j| std::array::from_fn(|i| values[6 * j + i]))
}

impl<const SLIDES: u8> Arm<6> for Interpreted<SLIDES> {
    const NAME: &'static str = "interpreted";
    const LENGTH_UNIT: LengthUnit = LengthUnit::Metre;
    const TABLE: &'static str = "";
    const JOINTS: [Joint; 6] = {
        let mut joints = [Joint { name: "", kind: JointKind::Revolute }; 6];
        let mut joint = 0;
        while joint < 6 {
            if SLIDES >> joint & 1 == 1 {
                joints[joint].kind = JointKind::Prismatic;
            }
            joint += 1;
        }
        joints
    };

    fn reach(&self) -> f64 {
        self.quantity(&self.derived.reach)
    }

    fn limits(&self) -> Limits<6> {
        Limits::new([None; 6])
    }

    fn fk<T: Real>(&self, q: &Joints<T, 6>) -> Pose<T> {
        pose(&self.run(&self.derived.forward.fk, q.as_slice(), &[]))
    }

    fn frames<T: Real>(&self, q: &Joints<T, 6>) -> [Pose<T>; 6] {
        let values = self.run(&self.derived.forward.frames, q.as_slice(), &[]);
        std::array::from_fn(|i| pose(&values[12 * i..]))
    }

    fn jacobian<T: Real>(&self, q: &Joints<T, 6>) -> Jacobian<T, 6> {
        private::jacobian(columns(&self.run(&self.derived.forward.jacobian, q.as_slice(), &[])))
    }

    fn fk_jacobian<T: Real>(&self, q: &Joints<T, 6>) -> (Pose<T>, Jacobian<T, 6>) {
        let values = self.run(&self.derived.forward.fk_jacobian, q.as_slice(), &[]);
        (pose(&values), private::jacobian(columns(&values[12..])))
    }
}

impl<const SLIDES: u8> SphericalWrist<6> for Interpreted<SLIDES> {
    fn r36<T: Real>(&self, q4: T, q5: T, q6: T) -> Matrix3<T> {
        let zero = T::lit(0.0);
        private::matrix(rows(&self.run(&self.solver().r36, &[zero, zero, zero, q4, q5, q6], &[])))
    }

    fn r03<T: Real>(&self, q1: T, q2: T, q3: T) -> (Matrix3<T>, Point3<T>) {
        let values = self.run(&self.solver().r03, &[q1, q2, q3], &[]);
        (private::matrix(rows(&values)), private::point([values[9], values[10], values[11]]))
    }

    fn wrist_angles<T: Float>(&self, r36: &Matrix3<T>) -> Wrist<T> {
        let solver = self.solver();
        self.angles_of(&solver.geometry.wrist, &solver.wrist_matrix, r36)
    }
}

impl<const SLIDES: u8> private::SolveWrist<6> for Interpreted<SLIDES> {
    fn base<T: Float>(&self) -> Base<T> {
        self.base_of(&self.solver().geometry.base)
    }

    fn wrist_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3] {
        let values = self.run(&self.solver().wrist_centre, &[], &entries(pose));
        [values[0], values[1], values[2]]
    }

    fn wrist_rotation<T: Real>(&self, three: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        private::matrix(rows(&self.run(&self.solver().wrist_rotation, &three, &entries(pose))))
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        integer_map(&self.derived.uncouple, rows)
    }

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        integer_map(&self.derived.couple, q)
    }
}

pub(crate) fn integer_map<T: Real>(matrix: &[Vec<i64>], v: [T; 6]) -> [T; 6] {
    std::array::from_fn(|i| {
        let terms = matrix[i].iter().zip(v).filter(|(c, _)| **c != 0).map(|(c, x)| T::lit(*c as f64) * x);
        terms.reduce(|a, b| a + b).unwrap_or_else(|| T::lit(0.0))
    })
}

impl<const SLIDES: u8> InverseKinematics<6> for Interpreted<SLIDES> {
    type Branch = Posture;

    fn ik<T: Float>(&self, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
        kin_runtime::ik::spherical_wrist::solve(self, pose)
    }

    fn ik_holding<T: Float>(&self, pose: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, Posture> {
        kin_runtime::ik::spherical_wrist::solve_holding(self, pose, hold)
    }
}
