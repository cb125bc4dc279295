//! Who is tried: the declared arms that have an inverse, of whatever family, in one language.

use kin_runtime::ik::{Carrier, PairBase};
use kin_runtime::private::{SolvePair, SolvePosition, SolveShort, SolveShoulder, SolveWrist};
use kin_runtime::{Base, Wrist};
use nalgebra::RealField;

use kin_runtime::prelude::*;

use super::aim::{Figures, Sights};
use super::lines::Lines;

/// Numbers that the tests can make of bits and show as bits.
pub trait Bits: Float + RealField {
    /// The name of the format.
    const NAME: &'static str;
    /// The number nearest to a double.
    fn rounded(x: f64) -> Self;
    /// The same number as a double.
    fn wide(self) -> f64;
    /// The number with these low bits.
    fn of_bits(bits: u64) -> Self;
    /// The bits of a number.
    fn bits(self) -> u64;
}

impl Bits for f64 {
    const NAME: &'static str = "f64";
    fn rounded(x: f64) -> f64 {
        x
    }
    fn wide(self) -> f64 {
        self
    }
    fn of_bits(bits: u64) -> f64 {
        f64::from_bits(bits)
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl Bits for f32 {
    const NAME: &'static str = "f32";
    fn rounded(x: f64) -> f32 {
        x as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn of_bits(bits: u64) -> f32 {
        f32::from_bits((bits >> 32) as u32)
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

/// What arms of one structure share.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// Its name.
    pub name: &'static str,
    /// The worst residual that is promised, in ε of the reach.
    pub promised: f64,
    /// How many solutions there can be, singular families counted once; of one arm, not of all with the same name.
    pub most: usize,
}

/// An arm and what its inverse takes.
pub trait Subject<const N: usize>: Arm<N> + Sized {
    /// The labels of its slots.
    type Branch: Branch;
    /// The family that it belongs to.
    fn family(&self) -> Family;
    /// Where to aim.
    fn sights(&self) -> Sights;
    /// From row values to what is commanded.
    fn commanded(&self, rows: [f64; 6]) -> [f64; N];
    /// All solutions.
    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, N, Self::Branch>;
    /// All solutions, free coordinates kept.
    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, N>)
    -> Solutions<T, N, Self::Branch>;
    /// Whether orientations count.
    const TURNS: bool;
}

/// A six-joint arm with a spherical wrist, solved from a pose.
pub struct ByPose;

/// A six-joint arm with a spherical shoulder, solved from a pose.
pub struct ByTool;

/// An arm of two to five joints, solved from a pose.
pub struct Few;

/// A three-joint arm, solved from a position.
pub struct ByPoint;

/// A two-joint arm, solved from a position.
pub struct Two;

/// The arm `A` as a subject of kind `K`.
pub struct Tried<A, K>(pub A, pub K);

impl<const N: usize, A: Arm<N>, K> Arm<N> for Tried<A, K> {
    const NAME: &'static str = A::NAME;
    const LENGTH_UNIT: kin_runtime::LengthUnit = A::LENGTH_UNIT;
    const TABLE: &'static str = A::TABLE;
    const JOINTS: [kin_runtime::Joint; N] = A::JOINTS;
    fn reach(&self) -> f64 {
        self.0.reach()
    }
    fn limits(&self) -> Limits<N> {
        self.0.limits()
    }
    fn fk<T: Real>(&self, q: &Joints<T, N>) -> Pose<T> {
        self.0.fk(q)
    }
    fn frames<T: Real>(&self, q: &Joints<T, N>) -> [Pose<T>; N] {
        self.0.frames(q)
    }
    fn jacobian<T: Real>(&self, q: &Joints<T, N>) -> Jacobian<T, N> {
        self.0.jacobian(q)
    }
    fn fk_jacobian<T: Real>(&self, q: &Joints<T, N>) -> (Pose<T>, Jacobian<T, N>) {
        self.0.fk_jacobian(q)
    }
}

/// The worst residual that is promised of figures in a plane.
const PLANAR: f64 = 16.0;

/// The same of a general base: its joint values are refined by steps, and not read from figures.
const GENERAL: f64 = 64.0;

impl Family {
    /// Of three joints that carry a point, and one or two ways for what follows them. They put it in its place in four ways, but
    /// for two slides, which leave two conics of which one is a line, and three, which leave lines.
    fn of(base: &Base<f64>, ways: usize) -> Family {
        let (name, promised, most) = match base {
            Base::Elbow(_) => ("elbow", PLANAR, 4),
            Base::Telescope(_) => ("telescope", PLANAR, 4),
            Base::General(base) => {
                let slides = base.axes.iter().filter(|axis| axis.slides).count();
                (Lines::structure(base), GENERAL, [4, 4, 2, 1][slides])
            }
        };
        Family { name, promised, most: most * ways }
    }

    /// Of two joints that carry a point.
    fn of_two() -> Family {
        Family { name: "", promised: GENERAL, most: 2 }
    }

    /// Called by another name, where the figures are planar and where they are not.
    fn named(self, planar: &'static str, general: &'static str) -> Family {
        Family { name: if self.promised == PLANAR { planar } else { general }, ..self }
    }
}

/// The two solutions of any bend lie to both sides of where the three axes are in one plane.
fn straight(angles: Wrist<f64>) -> Option<f64> {
    match angles {
        Wrist::Two { noflip: [_, a, _], flip: [_, b, _], .. } => Some(0.5 * (a + b)),
        Wrist::Family(_) | Wrist::OutOfReach { .. } => None,
    }
}

impl<A: SolveWrist<6> + InverseKinematics<6>> Subject<6> for Tried<A, ByPose> {
    type Branch = A::Branch;
    const TURNS: bool = true;

    fn family(&self) -> Family {
        Family::of(&self.0.base(), 2)
    }

    fn sights(&self) -> Sights {
        let straight = straight(self.0.wrist_angles(&self.0.r36(0.25, 1.0, 0.5)));
        let straight = straight.map(|straight| (4, straight));
        Sights::new(Figures::of(self.0.base()), [0, 1, 2], straight, &self.0)
    }

    fn commanded(&self, rows: [f64; 6]) -> [f64; 6] {
        self.0.command(rows)
    }

    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, 6, A::Branch> {
        self.0.ik(target)
    }

    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, A::Branch> {
        self.0.ik_holding(target, hold)
    }
}

impl<A: SolveShoulder<6> + InverseKinematics<6>> Subject<6> for Tried<A, ByTool> {
    type Branch = A::Branch;
    const TURNS: bool = true;

    fn family(&self) -> Family {
        Family::of(&self.0.base(), 2).named("shoulder", "shoulder-general")
    }

    fn sights(&self) -> Sights {
        let any = self.0.fk(&Joints::from(self.0.command([0.25, 1.0, 0.5, 0.0, 0.0, 0.0])));
        let straight = straight(self.0.shoulder_angles(&self.0.shoulder_rotation([0.0; 3], &any)));
        let straight = straight.map(|straight| (1, straight));
        Sights::new(Figures::of(self.0.base()), [5, 4, 3], straight, &self.0)
    }

    fn commanded(&self, rows: [f64; 6]) -> [f64; 6] {
        self.0.command(rows)
    }

    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, 6, A::Branch> {
        self.0.ik(target)
    }

    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, A::Branch> {
        self.0.ik_holding(target, hold)
    }
}

/// The figures of two joints, which stand in the places of a base's second and third.
fn pair(base: &PairBase<f64>, [first, second]: [usize; 2]) -> (Figures, [usize; 3]) {
    (Figures::Lines(Lines::of_two(base)), [first, first, second])
}

impl<const N: usize, A: SolveShort<N> + InverseKinematics<N>> Subject<N> for Tried<A, Few> {
    type Branch = A::Branch;
    const TURNS: bool = true;

    fn family(&self) -> Family {
        let family = match self.0.carrier() {
            Carrier::Three(base) => Family::of(&base, 1),
            Carrier::Two(_) => Family::of_two(),
        };
        family.named("short", "short-general")
    }

    fn sights(&self) -> Sights {
        let order = |place: usize| A::ORDER.get(place).copied().unwrap_or(0);
        let (figures, base) = match self.0.carrier() {
            Carrier::Three(base) => (Figures::of(base), [order(0), order(1), order(2)]),
            Carrier::Two(base) => pair(&base, [order(0), order(1)]),
        };
        Sights::new(figures, base, None, &self.0)
    }

    fn commanded(&self, rows: [f64; 6]) -> [f64; N] {
        self.0.command(std::array::from_fn(|joint| rows[joint]))
    }

    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, N, A::Branch> {
        self.0.ik(target)
    }

    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, N>) -> Solutions<T, N, A::Branch> {
        self.0.ik_holding(target, hold)
    }
}

impl<A: SolvePosition<3> + PositionInverse<3>> Subject<3> for Tried<A, ByPoint> {
    type Branch = A::Branch;
    const TURNS: bool = false;

    fn family(&self) -> Family {
        Family::of(&self.0.base(), 1).named("position", "position-general")
    }

    fn sights(&self) -> Sights {
        Sights::new(Figures::of(self.0.base()), [0, 1, 2], None, &self.0)
    }

    fn commanded(&self, [t1, t2, t3, ..]: [f64; 6]) -> [f64; 3] {
        self.0.command([t1, t2, t3])
    }

    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, 3, A::Branch> {
        self.0.ik_position(&Point3::from(target.translation.vector))
    }

    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, 3>) -> Solutions<T, 3, A::Branch> {
        self.0.ik_position_holding(&Point3::from(target.translation.vector), hold)
    }
}

impl<A: SolvePair<2> + PositionInverse<2>> Subject<2> for Tried<A, Two> {
    type Branch = A::Branch;
    const TURNS: bool = false;

    fn family(&self) -> Family {
        Family::of_two().named("position", "position-general")
    }

    fn sights(&self) -> Sights {
        let (figures, base) = pair(&self.0.base(), [0, 1]);
        Sights::new(figures, base, None, &self.0)
    }

    fn commanded(&self, [t1, t2, ..]: [f64; 6]) -> [f64; 2] {
        self.0.command([t1, t2])
    }

    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, 2, A::Branch> {
        self.0.ik_position(&Point3::from(target.translation.vector))
    }

    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, 2>) -> Solutions<T, 2, A::Branch> {
        self.0.ik_position_holding(&Point3::from(target.translation.vector), hold)
    }
}
