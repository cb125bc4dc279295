//! Wrists side by side: over the placements of one pose ([`side`](crate::ik::side)) or over those of a batch's poses
//! ([`abreast`](crate::ik::abreast)), in loops with the program for one of them ([`bends`](crate::ik::bends)).
//!
//! The loops have no branch and no call, so that compilers make vectors of them, as wide as the machine has them. Each is as
//! short as what a processor looks ahead, so that many of its passes go on at once. Between two steps the numbers stand in
//! memory, lane beside lane; a lane has the same bits whatever stands beside it.

use crate::ik::bends::{self, Aimed, Angles, Turned, joint_values};
use crate::ik::target::{is_accepted, unless};
use crate::ik::wrist::Rows;
use crate::math::{Float, Lanes};
use crate::pose::{self, Pose};
use crate::private::SolveWrist;
use crate::solutions::Bend;

/// How many angles the rotation of a wrist may have here: those of the first three joints.
pub(super) const TURNS: usize = 4;

/// Wrists over placements, step by step.
#[derive(Clone, Copy)]
pub(super) struct Wrists<T, const L: usize> {
    sines: [Lanes<T, L>; TURNS],
    cosines: [Lanes<T, L>; TURNS],
    matrix: [[Lanes<T, L>; 3]; 3],
    sine: Lanes<T, L>,
    noflip: [Lanes<T, L>; 3],
    flip: [Lanes<T, L>; 3],
    margin: Lanes<T, L>,
    /// How far forward kinematics of both bends misses the pose.
    residuals: [Lanes<T, L>; 2],
}

/// Sets a lane of many places to values.
macro_rules! set {
    ($lane:ident: $($place:expr, $value:expr;)*) => { $($place.put($lane, $value);)* };
}
pub(super) use set;

/// One lane of three.
#[inline(always)]
pub(super) fn three<T: Float, const L: usize>([a, b, c]: &[Lanes<T, L>; 3], lane: usize) -> [T; 3] {
    [a.lane(lane), b.lane(lane), c.lane(lane)]
}

impl<T: Float, const L: usize> Wrists<T, L> {
    /// Room that is to be filled.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = Lanes::splat(T::lit(0.0));
        Wrists {
            sines: [zero; TURNS],
            cosines: [zero; TURNS],
            matrix: [[zero; 3]; 3],
            sine: zero,
            noflip: [zero; 3],
            flip: [zero; 3],
            margin: zero,
            residuals: [zero; 2],
        }
    }

    /// What the wrist must turn over one lane's placement; 0 if it is far from straight.
    #[inline(always)]
    pub(super) fn aim<A: SolveWrist<6>>(
        &mut self,
        lane: usize,
        arm: &A,
        pose: &Pose<T>,
        rows: [T; 3],
        first: [T; 2],
        far: T,
    ) -> T {
        let aimed = Aimed::new(arm, pose, rows, first);
        let Turned { sines, cosines } = &aimed.turned;
        set! { lane:
            self.matrix[0][0], aimed.matrix[0][0];
            self.matrix[0][1], aimed.matrix[0][1];
            self.matrix[0][2], aimed.matrix[0][2];
            self.matrix[1][0], aimed.matrix[1][0];
            self.matrix[1][1], aimed.matrix[1][1];
            self.matrix[1][2], aimed.matrix[1][2];
            self.matrix[2][2], aimed.matrix[2][2];
            self.sine, aimed.sine;
        }
        if A::WRIST_TURNS > 0 {
            set! { lane: self.sines[0], sines[0]; self.cosines[0], cosines[0]; }
        }
        if A::WRIST_TURNS > 1 {
            set! { lane: self.sines[1], sines[1]; self.cosines[1], cosines[1]; }
        }
        if A::WRIST_TURNS > 2 {
            set! { lane: self.sines[2], sines[2]; self.cosines[2], cosines[2]; }
        }
        if A::WRIST_TURNS > 3 {
            set! { lane: self.sines[3], sines[3]; self.cosines[3], cosines[3]; }
        }
        unless(aimed.sine > far)
    }

    /// One lane of what the wrist must turn.
    #[inline(always)]
    fn aimed(&self, lane: usize) -> Aimed<T> {
        let zero = T::lit(-0.0);
        let eight = |[a, b, c, d]: &[Lanes<T, L>; TURNS]| {
            [a.lane(lane), b.lane(lane), c.lane(lane), d.lane(lane), zero, zero, zero, zero]
        };
        let [x, y, z] = &self.matrix;
        Aimed {
            turned: Turned { sines: eight(&self.sines), cosines: eight(&self.cosines) },
            matrix: [three(x, lane), three(y, lane), three(z, lane)],
            sine: self.sine.lane(lane),
        }
    }

    /// The angles of one lane.
    #[inline(always)]
    pub(super) fn turn(&mut self, lane: usize, offsets: &Rows<T>) {
        let Angles { noflip, flip, margin } = Angles::new(&self.aimed(lane), offsets);
        set! { lane:
            self.noflip[0], noflip[0];
            self.noflip[1], noflip[1];
            self.noflip[2], noflip[2];
            self.flip[0], flip[0];
            self.flip[1], flip[1];
            self.flip[2], flip[2];
            self.margin, margin;
        }
    }

    /// Forward kinematics of one lane; 0 if it comes back to the pose.
    #[inline(always)]
    pub(super) fn check<A: SolveWrist<6>>(
        &mut self,
        lane: usize,
        arm: &A,
        pose: &Pose<T>,
        per_scale: T,
        rows: [T; 3],
    ) -> T {
        let angles = Angles {
            noflip: three(&self.noflip, lane),
            flip: three(&self.flip, lane),
            margin: self.margin.lane(lane),
        };
        let [noflip, flip] = bends::residuals(arm, pose, per_scale, rows, &self.aimed(lane), &angles);
        set! { lane:
            self.residuals[0], noflip;
            self.residuals[1], flip;
        }
        unless::<T>(is_accepted(noflip)) + unless(is_accepted(flip))
    }

    /// The joint values of one lane with one of the bends, their residual, and the bend's distance from straight.
    #[inline(always)]
    pub(super) fn solution<A: SolveWrist<6>>(
        &self,
        arm: &A,
        [t1, t2, t3]: [T; 3],
        bend: Bend,
        lane: usize,
    ) -> ([T; 6], T, T) {
        let [noflip, flip] = &self.residuals;
        let (wrist, residual) =
            if bend == Bend::NoFlip { (&self.noflip, noflip) } else { (&self.flip, flip) };
        let [t4, t5, t6] = three(wrist, lane);
        let q = pose::entries(&joint_values(arm, [t1, t2, t3, t4, t5, t6]));
        (q, residual.lane(lane), self.margin.lane(lane))
    }
}
