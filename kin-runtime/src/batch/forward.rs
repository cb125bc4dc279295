//! From joints to poses and Jacobians, as many configurations side by side as a program takes.
//!
//! Everything here is inlined into the loop that is compiled for an instruction set: a call would leave it.

use super::run::Work;
use crate::arm::Arm;
use crate::math::{Float, Lanes};
use crate::pose::{self, Jacobian, Joints, Pose};
use crate::widths::Instructions;

/// Configurations side by side, where one of two programs is asked for: two of the widest registers, so that one computes
/// while the other waits for its results. With AVX2 nothing is lost by it (measured: 8 takes up to a third longer).
const LANES: usize = 16;
/// Where both are asked for together: of more, registers could not hold the results (measured: 16 takes a quarter longer).
const LANES_OF_BOTH: usize = 8;

/// Configurations, and the places for what is asked of them.
pub(super) struct Forward<'a, A, T, P, const N: usize> {
    pub(super) arm: &'a A,
    pub(super) q: &'a [Joints<T, N>],
    pub(super) answers: P,
}

/// What is asked of an arm, and where it goes: one place for each configuration.
pub(super) trait Answers<T, const N: usize>: Sized + Send {
    /// The first so many places, or all, and the rest.
    fn split_at(self, at: usize) -> (Self, Self);
    /// Fills all places, with as many configurations side by side as are best.
    fn fill<A: Arm<N>>(self, arm: &A, q: &[Joints<T, N>], with: Instructions);
    /// Fills one place.
    fn one<A: Arm<N>>(self, arm: &A, q: &Joints<T, N>);
    /// Fills `L` places.
    fn side_by_side<A: Arm<N>, const L: usize>(self, arm: &A, q: &Joints<Lanes<T, L>, N>);
}

impl<A: Arm<N> + Sync, T: Float, P: Answers<T, N>, const N: usize> Work for Forward<'_, A, T, P, N> {
    fn len(&self) -> usize {
        self.q.len()
    }

    fn split_at(self, at: usize) -> (Self, Self) {
        let Forward { arm, q, answers } = self;
        let (first, rest) = q.split_at(at.min(q.len()));
        let (places, others) = answers.split_at(at);
        (Forward { arm, q: first, answers: places }, Forward { arm, q: rest, answers: others })
    }

    #[inline(always)]
    fn run(self, with: Instructions) {
        self.answers.fill(self.arm, self.q, with);
    }
}

/// Fills all places: `L` at a time, the rest of them one by one; all so where registers are narrow, for two doubles side by side
/// are not worth the way into lanes and back (measured: up to a third longer with SSE2).
#[inline(always)]
fn in_chunks<A: Arm<N>, T: Float, P: Answers<T, N>, const N: usize, const L: usize>(
    mut answers: P,
    arm: &A,
    q: &[Joints<T, N>],
    with: Instructions,
) {
    let (chunks, rest) = if with.are_wide() { q.as_chunks::<L>() } else { (&[] as &[_], q) };
    for chunk in chunks {
        let (places, others) = answers.split_at(L);
        places.side_by_side(arm, &gathered(chunk));
        answers = others;
    }
    for q in rest {
        let (place, others) = answers.split_at(1);
        place.one(arm, q);
        answers = others;
    }
}

/// Configurations as one whose values are lanes.
#[inline(always)]
fn gathered<T: Float, const N: usize, const L: usize>(chunk: &[Joints<T, N>; L]) -> Joints<Lanes<T, L>, N> {
    let mut joints = [Lanes::splat(T::lit(0.0)); N];
    for (lane, q) in chunk.iter().enumerate() {
        for (lanes, value) in joints.iter_mut().zip(pose::entries(q)) {
            lanes.put(lane, value);
        }
    }
    pose::column(joints)
}

/// Poses are asked for.
pub(super) struct Poses<'a, T>(pub(super) &'a mut [Pose<T>]);

impl<T: Float, const N: usize> Answers<T, N> for Poses<'_, T> {
    #[inline(always)]
    fn split_at(self, at: usize) -> (Self, Self) {
        let (first, rest) = self.0.split_at_mut(at.min(self.0.len()));
        (Poses(first), Poses(rest))
    }

    #[inline(always)]
    fn fill<A: Arm<N>>(self, arm: &A, q: &[Joints<T, N>], with: Instructions) {
        in_chunks::<A, T, Self, N, LANES>(self, arm, q, with);
    }

    #[inline(always)]
    fn one<A: Arm<N>>(self, arm: &A, q: &Joints<T, N>) {
        self.0.fill(arm.fk_inlined(q));
    }

    #[inline(always)]
    fn side_by_side<A: Arm<N>, const L: usize>(self, arm: &A, q: &Joints<Lanes<T, L>, N>) {
        self.scatter(&arm.fk_inlined(q));
    }
}

impl<T: Float> Poses<'_, T> {
    /// Each lane to its place.
    #[inline(always)]
    fn scatter<const L: usize>(self, lanes: &Pose<Lanes<T, L>>) {
        let Ok(places) = <&mut [Pose<T>; L]>::try_from(self.0) else { return };
        let ([[r11, r12, r13], [r21, r22, r23], [r31, r32, r33]], [x, y, z]) = pose::rows(lanes);
        for (lane, place) in places.iter_mut().enumerate() {
            let of = |value: &Lanes<T, L>| value.lane(lane);
            let rows = [
                [of(&r11), of(&r12), of(&r13)],
                [of(&r21), of(&r22), of(&r23)],
                [of(&r31), of(&r32), of(&r33)],
            ];
            *place = pose::from_rows(rows, [of(&x), of(&y), of(&z)]);
        }
    }
}

/// Jacobians are asked for.
pub(super) struct Jacobians<'a, T, const N: usize>(pub(super) &'a mut [Jacobian<T, N>]);

impl<T: Float, const N: usize> Answers<T, N> for Jacobians<'_, T, N> {
    #[inline(always)]
    fn split_at(self, at: usize) -> (Self, Self) {
        let (first, rest) = self.0.split_at_mut(at.min(self.0.len()));
        (Jacobians(first), Jacobians(rest))
    }

    #[inline(always)]
    fn fill<A: Arm<N>>(self, arm: &A, q: &[Joints<T, N>], with: Instructions) {
        in_chunks::<A, T, Self, N, LANES>(self, arm, q, with);
    }

    #[inline(always)]
    fn one<A: Arm<N>>(self, arm: &A, q: &Joints<T, N>) {
        self.0.fill(arm.jacobian_inlined(q));
    }

    #[inline(always)]
    fn side_by_side<A: Arm<N>, const L: usize>(self, arm: &A, q: &Joints<Lanes<T, L>, N>) {
        self.scatter(&arm.jacobian_inlined(q));
    }
}

impl<T: Float, const N: usize> Jacobians<'_, T, N> {
    /// Each lane to its place.
    #[inline(always)]
    fn scatter<const L: usize>(self, lanes: &Jacobian<Lanes<T, L>, N>) {
        let Ok(places) = <&mut [Jacobian<T, N>; L]>::try_from(self.0) else { return };
        for (lane, place) in places.iter_mut().enumerate() {
            for (column, lanes) in place.data.0.iter_mut().zip(&lanes.data.0) {
                for (entry, lanes) in column.iter_mut().zip(lanes) {
                    *entry = lanes.lane(lane);
                }
            }
        }
    }
}

/// Poses and Jacobians are asked for.
impl<T: Float, const N: usize> Answers<T, N> for (Poses<'_, T>, Jacobians<'_, T, N>) {
    #[inline(always)]
    fn split_at(self, at: usize) -> (Self, Self) {
        let (pose, poses) = Answers::<T, N>::split_at(self.0, at);
        let (jacobian, jacobians) = self.1.split_at(at);
        ((pose, jacobian), (poses, jacobians))
    }

    #[inline(always)]
    fn fill<A: Arm<N>>(self, arm: &A, q: &[Joints<T, N>], with: Instructions) {
        in_chunks::<A, T, Self, N, LANES_OF_BOTH>(self, arm, q, with);
    }

    #[inline(always)]
    fn one<A: Arm<N>>(self, arm: &A, q: &Joints<T, N>) {
        let (pose, jacobian) = arm.fk_jacobian_inlined(q);
        self.0.0.fill(pose);
        self.1.0.fill(jacobian);
    }

    #[inline(always)]
    fn side_by_side<A: Arm<N>, const L: usize>(self, arm: &A, q: &Joints<Lanes<T, L>, N>) {
        let (pose, jacobian) = arm.fk_jacobian_inlined(q);
        self.0.scatter(&pose);
        self.1.scatter(&jacobian);
    }
}
