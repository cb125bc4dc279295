//! Who is tried: the declared arms that have an inverse, from a pose or from a position, in one language.

use kin_runtime::private::{SolvePosition, SolveWrist};
use kin_runtime::{Base, Dexterity, JointKind, Wrist, dexterity, position_dexterity};
use nalgebra::RealField;

use kin_runtime::prelude::*;

use super::aim::Sights;

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

/// An arm and what its inverse takes.
pub trait Subject<const N: usize>: Arm<N> + Sized {
    /// The labels of its slots.
    type Branch: Branch;
    /// The constants of its first three joints.
    fn figures(&self) -> Base<f64>;
    /// Where to aim.
    fn sights(&self) -> Sights;
    /// From row values to what is commanded.
    fn commanded(&self, rows: [f64; 6]) -> [f64; N];
    /// All solutions.
    fn solve<T: Float>(&self, target: &Pose<T>) -> Solutions<T, N, Self::Branch>;
    /// All solutions, free coordinates kept.
    fn solve_holding<T: Float>(&self, target: &Pose<T>, hold: &Joints<T, N>)
    -> Solutions<T, N, Self::Branch>;
    /// The singular values of what the inverse takes, linear rows divided by the reach.
    fn dexterity<T: Float>(&self, q: &Joints<T, N>) -> Dexterity<T, N>;
    /// Whether orientations count.
    const TURNS: bool;
}

/// A six-joint arm, solved from a pose.
pub struct ByPose;

/// A three-joint arm, solved from a position.
pub struct ByPoint;

/// The arm `A` as a subject of kind `K`.
pub struct Tried<A, K>(pub A, pub K);

macro_rules! forward {
    ($N:literal) => {
        const NAME: &'static str = A::NAME;
        const LENGTH_UNIT: kin_runtime::LengthUnit = A::LENGTH_UNIT;
        const TABLE: &'static str = A::TABLE;
        const JOINTS: [kin_runtime::Joint; $N] = A::JOINTS;
        fn reach(&self) -> f64 {
            self.0.reach()
        }
        fn limits(&self) -> Limits<$N> {
            self.0.limits()
        }
        fn fk<T: Real>(&self, q: &Joints<T, $N>) -> Pose<T> {
            self.0.fk(q)
        }
        fn frames<T: Real>(&self, q: &Joints<T, $N>) -> [Pose<T>; $N] {
            self.0.frames(q)
        }
        fn jacobian<T: Real>(&self, q: &Joints<T, $N>) -> Jacobian<T, $N> {
            self.0.jacobian(q)
        }
        fn fk_jacobian<T: Real>(&self, q: &Joints<T, $N>) -> (Pose<T>, Jacobian<T, $N>) {
            self.0.fk_jacobian(q)
        }
    };
}

impl<A: Arm<6>> Arm<6> for Tried<A, ByPose> {
    forward!(6);
}

impl<A: Arm<3>> Arm<3> for Tried<A, ByPoint> {
    forward!(3);
}

/// Any angle for a turning joint; for a sliding one its range, or half the reach to either side.
fn ranges<const N: usize>(arm: &impl Arm<N>, kinds: &[JointKind]) -> [(f64, f64); 6] {
    let half = 0.5 * arm.reach();
    std::array::from_fn(|joint| match kinds.get(joint) {
        Some(JointKind::Prismatic) => arm.limits().range(joint).unwrap_or((-half, half)),
        _ => (-std::f64::consts::PI, std::f64::consts::PI),
    })
}

impl<A: SolveWrist<6> + InverseKinematics<6>> Subject<6> for Tried<A, ByPose> {
    type Branch = A::Branch;
    const TURNS: bool = true;

    fn figures(&self) -> Base<f64> {
        self.0.base()
    }

    fn sights(&self) -> Sights {
        // The two solutions of any bend lie to both sides of where the wrist is straight.
        let straight = match self.0.wrist_angles(&self.0.r36(0.25, 1.0, 0.5)) {
            Wrist::Two { noflip: [_, a, _], flip: [_, b, _], .. } => Some(0.5 * (a + b)),
            Wrist::Family(_) | Wrist::OutOfReach { .. } => None,
        };
        Sights::new(self.figures(), straight, ranges(&self.0, &A::JOINTS.map(|joint| joint.kind)))
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

    fn dexterity<T: Float>(&self, q: &Joints<T, 6>) -> Dexterity<T, 6> {
        dexterity(&self.0, q)
    }
}

impl<A: SolvePosition<3> + PositionInverse<3>> Subject<3> for Tried<A, ByPoint> {
    type Branch = A::Branch;
    const TURNS: bool = false;

    fn figures(&self) -> Base<f64> {
        self.0.base()
    }

    fn sights(&self) -> Sights {
        Sights::new(self.figures(), None, ranges(&self.0, &A::JOINTS.map(|joint| joint.kind)))
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

    fn dexterity<T: Float>(&self, q: &Joints<T, 3>) -> Dexterity<T, 3> {
        position_dexterity(&self.0, q)
    }
}
