//! What a path asks for at each of its points: a pose of the tool, or only a place for it.

use crate::arm::{Arm, InverseKinematics, Joint, LengthUnit, PositionInverse};
use crate::ik::settle::settle;
use crate::limits::Limits;
use crate::math::{Float, Real};
use crate::pose::{self, Jacobian, Joints, Pose};
use crate::singularity::linear;
use crate::solutions::{Branch, Solutions};
use nalgebra::Point3;

/// What a path asks for: [`ByPose`] or [`ByPoint`], nothing else.
pub trait Goal<A: Arm<N>, const N: usize>: sealed::Sealed {
    /// One point of the path.
    type Target<T: Float>;
    /// The labels of the solution slots.
    type Branch: Branch;

    /// It as a pose; a place is not turned.
    fn pose<T: Float>(target: &Self::Target<T>) -> Pose<T>;
    /// What joint values reach of it.
    fn reached<T: Float>(arm: &A, q: &Joints<T, N>) -> Pose<T>;
    /// All solutions, free coordinates kept.
    fn solutions<T: Float>(arm: &A, pose: &Pose<T>, hold: &Joints<T, N>) -> Solutions<T, N, Self::Branch>;
    /// Joint values near others that reach it, and how far they miss it.
    fn settled<T: Float>(arm: &A, pose: &Pose<T>, q: &Joints<T, N>) -> Option<(Joints<T, N>, T)>;
}

/// A path of poses: [`InverseKinematics::track`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ByPose {}

/// A path of places for the tool point: [`PositionInverse::track_position`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ByPoint {}

mod sealed {
    /// Closed: how a path is followed rests on what these two say.
    pub trait Sealed {}
    impl Sealed for super::ByPose {}
    impl Sealed for super::ByPoint {}
}

impl<A: InverseKinematics<N>, const N: usize> Goal<A, N> for ByPose {
    type Target<T: Float> = Pose<T>;
    type Branch = A::Branch;

    fn pose<T: Float>(target: &Pose<T>) -> Pose<T> {
        *target
    }

    fn reached<T: Float>(arm: &A, q: &Joints<T, N>) -> Pose<T> {
        arm.fk(q)
    }

    fn solutions<T: Float>(arm: &A, pose: &Pose<T>, hold: &Joints<T, N>) -> Solutions<T, N, A::Branch> {
        arm.ik_holding(pose, hold)
    }

    fn settled<T: Float>(arm: &A, pose: &Pose<T>, q: &Joints<T, N>) -> Option<(Joints<T, N>, T)> {
        settle(arm, pose, q)
    }
}

impl<A: PositionInverse<N>, const N: usize> Goal<A, N> for ByPoint {
    type Target<T: Float> = Point3<T>;
    type Branch = A::Branch;

    fn pose<T: Float>(target: &Point3<T>) -> Pose<T> {
        unturned(pose::entries(&target.coords))
    }

    fn reached<T: Float>(arm: &A, q: &Joints<T, N>) -> Pose<T> {
        Tip(arm).fk(q)
    }

    fn solutions<T: Float>(arm: &A, pose: &Pose<T>, hold: &Joints<T, N>) -> Solutions<T, N, A::Branch> {
        let (_, p) = pose::rows(pose);
        arm.ik_position_holding(&Point3::from(p), hold)
    }

    fn settled<T: Float>(arm: &A, pose: &Pose<T>, q: &Joints<T, N>) -> Option<(Joints<T, N>, T)> {
        settle(&Tip(arm), pose, q)
    }
}

/// A place as a pose.
fn unturned<T: Real>(place: [T; 3]) -> Pose<T> {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    pose::from_rows([[one, zero, zero], [zero, one, zero], [zero, zero, one]], place)
}

/// An arm of which nothing counts but where its tool point is.
struct Tip<'a, A>(&'a A);

impl<A: Arm<N>, const N: usize> Arm<N> for Tip<'_, A> {
    const NAME: &'static str = A::NAME;
    const LENGTH_UNIT: LengthUnit = A::LENGTH_UNIT;
    const TABLE: &'static str = A::TABLE;
    const JOINTS: [Joint; N] = A::JOINTS;

    fn reach(&self) -> f64 {
        self.0.reach()
    }

    fn limits(&self) -> Limits<N> {
        self.0.limits()
    }

    fn fk<T: Real>(&self, q: &Joints<T, N>) -> Pose<T> {
        let (_, place) = pose::rows(&self.0.fk(q));
        unturned(place)
    }

    fn frames<T: Real>(&self, q: &Joints<T, N>) -> [Pose<T>; N] {
        self.0.frames(q)
    }

    fn jacobian<T: Real>(&self, q: &Joints<T, N>) -> Jacobian<T, N> {
        linear(&self.0.jacobian(q))
    }

    fn fk_jacobian<T: Real>(&self, q: &Joints<T, N>) -> (Pose<T>, Jacobian<T, N>) {
        let (at, jacobian) = self.0.fk_jacobian(q);
        let (_, place) = pose::rows(&at);
        (unturned(place), linear(&jacobian))
    }
}
