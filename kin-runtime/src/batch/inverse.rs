//! From poses to solutions.

use super::Found;
use super::run::Work;
use crate::arm::InverseKinematics;
use crate::math::Float;
use crate::pose::Pose;
use crate::widths::Instructions;

/// Poses, and the places for their solutions.
pub(super) struct Backward<'a, A: InverseKinematics<N>, T: Float, const N: usize> {
    pub(super) arm: &'a A,
    pub(super) poses: &'a [Pose<T>],
    pub(super) solutions: &'a mut [Found<T, N, A>],
}

impl<A: InverseKinematics<N> + Sync, T: Float, const N: usize> Work for Backward<'_, A, T, N>
where
    Found<T, N, A>: Send,
{
    fn len(&self) -> usize {
        self.poses.len()
    }

    fn split_at(self, at: usize) -> (Self, Self) {
        let Backward { arm, poses, solutions } = self;
        let at = at.min(poses.len());
        let (first, rest) = poses.split_at(at);
        let (places, others) = solutions.split_at_mut(at.min(solutions.len()));
        (Backward { arm, poses: first, solutions: places }, Backward { arm, poses: rest, solutions: others })
    }

    #[inline(always)]
    fn run(self, _: Instructions) {
        self.arm.ik_each(self.poses, self.solutions);
    }
}
