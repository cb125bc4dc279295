//! Placements of the base side by side, each with the two bends of the wrist over it: of one pose
//! ([`side`](crate::ik::side)), or each for the poses of a batch ([`abreast`](crate::ik::abreast)).
//!
//! Loops over lanes have no branch and no call, so that compilers make vectors of them, as wide as the machine has them; a lane
//! has the same bits whatever stands beside it. All of a placement is in one loop: what stands in memory between two is read and
//! written once for nothing.

use crate::ik::ElbowBase;
use crate::ik::bends::{self, Aimed, Angles, joint_values};
use crate::ik::elbow::{self, Side};
use crate::ik::figure::{Row, values};
use crate::ik::target::{is_accepted, unless};
use crate::ik::wrist::Rows;
use crate::math::{Float, Lanes};
use crate::pose::{self, Pose};
use crate::private::SolveWrist;
use crate::solutions::{Bend, Reason, tolerance};

/// An arm with an elbow and an orthogonal wrist.
pub(super) struct Elbowed<'a, A, T> {
    pub(super) arm: &'a A,
    pub(super) base: &'a ElbowBase<T>,
    /// The wrist's figure angles where its row values are 0.
    pub(super) wrist: &'a Rows<T>,
}

/// Placements, and what came of them.
#[derive(Clone, Copy)]
pub(super) struct Placements<T, const L: usize> {
    /// The row values of the base, and of both bends of the wrist.
    base: [Lanes<T, L>; 3],
    noflip: [Lanes<T, L>; 3],
    flip: [Lanes<T, L>; 3],
    /// By how much the links close, and the square of the distance over which they do or do not: [`Side`].
    spare: Lanes<T, L>,
    square: Lanes<T, L>,
    /// How far the elbow and the wrist are from stretched or folded, and from straight.
    elbow: Lanes<T, L>,
    wrist: Lanes<T, L>,
    /// How far forward kinematics of both bends misses the pose.
    residuals: [Lanes<T, L>; 2],
    /// 0 where neither is near a singular figure and both come back to the pose, if the links close.
    doubt: Lanes<T, L>,
}

/// Sets a lane of many places to values.
macro_rules! set {
    ($lane:ident: $($place:expr, $value:expr;)*) => { $($place.put($lane, $value);)* };
}
pub(super) use set;

/// A figure larger than this is far from a singular one: an angle or its sine, or a length over the size. So far that no two
/// solutions can be one, nothing is free, and nothing is in doubt.
#[inline(always)]
pub(super) fn far<T: Float>() -> T {
    T::lit(64.0) * tolerance::<T>()
}

impl<T: Float, const L: usize> Placements<T, L> {
    /// Room that is to be filled.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let (zero, three) = (Lanes::splat(T::lit(0.0)), [Lanes::splat(T::lit(0.0)); 3]);
        Placements {
            base: three,
            noflip: three,
            flip: three,
            spare: zero,
            square: zero,
            elbow: zero,
            wrist: zero,
            residuals: [zero; 2],
            doubt: zero,
        }
    }

    /// Solves one of them: over this shoulder, with these row values. `per_scale` is one over what the pose is judged against.
    #[inline(always)]
    pub(super) fn solve<A: SolveWrist<6>>(
        &mut self,
        lane: usize,
        Elbowed { arm, wrist, .. }: &Elbowed<'_, A, T>,
        pose: &Pose<T>,
        side: &Side<T>,
        rows: &[Row<T>; 3],
        per_scale: T,
    ) {
        let far = far();
        let aimed = Aimed::new(*arm, pose, rows);
        let angles = Angles::new(&aimed, wrist);
        let [noflip, flip] = bends::residuals(*arm, pose, per_scale, rows, &aimed.turned, &angles);
        let near = unless::<T>(side.margin > far) + unless(aimed.sine > far);
        let missed = unless::<T>(is_accepted(noflip)) + unless(is_accepted(flip));
        let ([t1, t2, t3], [n4, n5, n6]) = (values(rows), values(&angles.noflip));
        let [f4, f5, f6] = values(&angles.flip);
        set! { lane:
            self.base[0], t1;
            self.base[1], t2;
            self.base[2], t3;
            self.noflip[0], n4;
            self.noflip[1], n5;
            self.noflip[2], n6;
            self.flip[0], f4;
            self.flip[1], f5;
            self.flip[2], f6;
            self.spare, side.spare;
            self.square, side.square;
            self.elbow, side.margin;
            self.wrist, angles.margin;
            self.residuals[0], noflip;
            self.residuals[1], flip;
            self.doubt, near + missed;
        }
    }

    /// Whether the links of a lane close, by more than round-off.
    #[inline(always)]
    pub(super) fn closes(&self, lane: usize) -> bool {
        self.spare.lane(lane) > T::lit(0.0)
    }

    /// Whether something is in doubt: 0 where nothing is.
    #[inline(always)]
    pub(super) fn doubt(&self, lane: usize) -> T {
        self.doubt.lane(lane)
    }

    /// How far the elbow is from stretched or folded.
    #[inline(always)]
    pub(super) fn elbow(&self, lane: usize) -> T {
        self.elbow.lane(lane)
    }

    /// Why the links of a lane do not close: see [`elbow::open`].
    #[inline(always)]
    pub(super) fn open(&self, lane: usize, base: &ElbowBase<T>, scale: T) -> Option<Reason<T>> {
        let [first, ..] = &self.base;
        elbow::open(base, self.square.lane(lane), first.lane(lane), scale)
    }

    /// The joint values of a lane with one of the bends, their residual, and the bend's distance from straight.
    #[inline(always)]
    pub(super) fn solution<A: SolveWrist<6>>(&self, lane: usize, arm: &A, bend: Bend) -> ([T; 6], T, T) {
        let [noflip, flip] = &self.residuals;
        let (wrist, residual) =
            if bend == Bend::NoFlip { (&self.noflip, noflip) } else { (&self.flip, flip) };
        let ([t1, t2, t3], [t4, t5, t6]) = (three(&self.base, lane), three(wrist, lane));
        let q = pose::entries(&joint_values(arm, [t1, t2, t3, t4, t5, t6]));
        (q, residual.lane(lane), self.wrist.lane(lane))
    }
}

/// One lane of three.
#[inline(always)]
fn three<T: Float, const L: usize>([a, b, c]: &[Lanes<T, L>; 3], lane: usize) -> [T; 3] {
    [a.lane(lane), b.lane(lane), c.lane(lane)]
}
