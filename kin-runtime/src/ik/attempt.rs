//! What small steps have made of joint values that were read from figures: for arms of [two to five joints](super::short).

use crate::ik::given_out;
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use crate::private::SolveShort;
use crate::singularity::units;
use crate::solutions::Free;

/// Joint values of one placement, and what was made of them.
#[derive(Clone, Copy)]
pub(super) struct Attempt<T, const N: usize> {
    pub(super) q: Joints<T, N>,
    pub(super) missed: T,
    /// Whether that is what a solution may miss.
    pub(super) reached: bool,
    pub(super) free: Free<N>,
    /// As they were read from the figures.
    pub(super) read: Joints<T, N>,
    /// Whether they are farther from there than the rounding of regular figures explains.
    pub(super) strayed: bool,
}

impl<T: Float, const N: usize> Attempt<T, N> {
    pub(super) fn reaches(&self) -> bool {
        self.reached
    }

    /// The way from the values that were read to these.
    pub(super) fn way<A: SolveShort<N>>(&self) -> Joints<T, N> {
        given_out(pose::entries(&(self.q - self.read)), &A::JOINTS)
    }

    /// How far that is, in radians and reaches.
    pub(super) fn moved<A: SolveShort<N>>(&self, arm: &A) -> T {
        let ways = pose::entries(&self.way::<A>()).into_iter().zip(units(&A::JOINTS, T::lit(arm.reach())));
        ways.fold(T::lit(0.0), |most, (way, unit)| math::max(most, math::abs(way) / unit))
    }
}
