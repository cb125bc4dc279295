//! An arm with a spherical shoulder from text, at run time: see [`interpreted`](crate::interpreted).

use kin_gen::model::{Arm as Derived, ShoulderSolver, Solver};
use kin_runtime::ik::{Base, Wrist, spherical_shoulder};
use kin_runtime::{
    Arm, Float, InverseKinematics, Jacobian, Joint, Joints, LengthUnit, Limits, Matrix3, Pose, Real,
    ShoulderPosture, Solutions, private,
};

use crate::interpreted::{Interpreted, entries, integer_map, rows};

/// A derived arm with a spherical shoulder; joint i slides if bit i of `SLIDES` is set.
pub struct Mirrored<const SLIDES: u8>(pub Interpreted<SLIDES>);

impl<const SLIDES: u8> Mirrored<SLIDES> {
    /// `None` if the arm is solved in another way, or not at all.
    pub fn new(derived: Derived) -> Option<Self> {
        matches!(derived.solver, Solver::Shoulder(_)).then(|| Mirrored(Interpreted::nominal(derived)))
    }

    fn solver(&self) -> &ShoulderSolver {
        match &self.0.derived().solver {
            Solver::Shoulder(solver) => solver,
            other => unreachable!("`new` lets only shoulders through: {other:?}"),
        }
    }
}

impl<const SLIDES: u8> Arm<6> for Mirrored<SLIDES> {
    const NAME: &'static str = "mirrored";
    const LENGTH_UNIT: LengthUnit = LengthUnit::Metre;
    const TABLE: &'static str = "";
    const JOINTS: [Joint; 6] = Interpreted::<SLIDES>::JOINTS;

    fn reach(&self) -> f64 {
        self.0.reach()
    }

    fn limits(&self) -> Limits<6> {
        self.0.limits()
    }

    fn fk<T: Real>(&self, q: &Joints<T, 6>) -> Pose<T> {
        self.0.fk(q)
    }

    fn frames<T: Real>(&self, q: &Joints<T, 6>) -> [Pose<T>; 6] {
        self.0.frames(q)
    }

    fn jacobian<T: Real>(&self, q: &Joints<T, 6>) -> Jacobian<T, 6> {
        self.0.jacobian(q)
    }

    fn fk_jacobian<T: Real>(&self, q: &Joints<T, 6>) -> (Pose<T>, Jacobian<T, 6>) {
        self.0.fk_jacobian(q)
    }
}

impl<const SLIDES: u8> private::SolveShoulder<6> for Mirrored<SLIDES> {
    fn base<T: Float>(&self) -> Base<T> {
        self.0.base_of(&self.solver().geometry.base)
    }

    fn shoulder_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3] {
        let values = self.0.run(&self.solver().shoulder_centre, &[], &entries(pose));
        [values[0], values[1], values[2]]
    }

    fn shoulder_rotation<T: Real>(&self, [t4, t5, t6]: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        let zero = T::lit(0.0);
        let joints = [zero, zero, zero, t4, t5, t6];
        private::matrix(rows(&self.0.run(&self.solver().shoulder_rotation, &joints, &entries(pose))))
    }

    fn shoulder_angles<T: Float>(&self, r03: &Matrix3<T>) -> Wrist<T> {
        let solver = self.solver();
        self.0.angles_of(&solver.geometry.shoulder, &solver.shoulder_matrix, r03)
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        integer_map(&self.0.derived().uncouple, rows)
    }

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        integer_map(&self.0.derived().couple, q)
    }
}

impl<const SLIDES: u8> InverseKinematics<6> for Mirrored<SLIDES> {
    type Branch = ShoulderPosture;

    fn ik<T: Float>(&self, pose: &Pose<T>) -> Solutions<T, 6, ShoulderPosture> {
        spherical_shoulder::solve(self, pose)
    }

    fn ik_holding<T: Float>(&self, pose: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, ShoulderPosture> {
        spherical_shoulder::solve_holding(self, pose, hold)
    }
}
