//! Poses abreast: the branches of a batch's poses, in loops over the poses.
//!
//! What they do is what [`side`](crate::ik::side) does for one pose, with the same bits: there the lanes are its placements, here
//! each placement has the poses for its lanes.
//!
//! Everything is inlined into the loop over a batch that is compiled for an instruction set. Poses of which some figure is near
//! a singular one, and what is no pose at all, are left to the solver of a single one.

use crate::ik::elbow::{Seen, Side};
use crate::ik::placements::{Elbowed, Placements, far, set};
use crate::ik::side::slots;
use crate::ik::target::{self, unless};
use crate::ik::{Base, ElbowBase, ROUND_OFF, sliding};
use crate::math::{Float, Lanes};
use crate::pose::{self, Pose};
use crate::private::SolveWrist;
use crate::solutions::{Posture, Reason, Solutions};

/// Room for what is known of poses abreast. Where a cache line begins, so that no vector lies across two.
#[repr(align(64))]
pub(super) struct Abreast<T, const L: usize> {
    poses: Pose<Lanes<T, L>>,
    /// The sizes against which the poses are judged, and one over them.
    scale: Lanes<T, L>,
    per_scale: Lanes<T, L>,
    /// The wrist centre seen from axis 1: [`Seen`].
    x: Lanes<T, L>,
    y: Lanes<T, L>,
    across: Lanes<T, L>,
    half: Lanes<T, L>,
    v: Lanes<T, L>,
    per: Lanes<T, L>,
    /// 0 for a pose that stands for itself, and whose shoulders are far apart.
    doubt: Lanes<T, L>,
    /// With the right shoulder and the left one, each with the elbow up and down.
    placed: [[Placements<T, L>; 2]; 2],
}

/// Which side of axis 1 the right shoulder is on, and the left one.
const SIDES: [f64; 2] = [1.0, -1.0];

impl<T: Float, const L: usize> Abreast<T, L> {
    /// Room that is to be filled.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = Lanes::splat(T::lit(0.0));
        Abreast {
            poses: pose::from_rows([[zero; 3]; 3], [zero; 3]),
            scale: zero,
            per_scale: zero,
            x: zero,
            y: zero,
            across: zero,
            half: zero,
            v: zero,
            per: zero,
            doubt: zero,
            placed: [[Placements::new(); 2]; 2],
        }
    }

    /// All solutions of as many poses as there are lanes, where every figure is [`far`] from a singular one; nothing in the
    /// other places.
    #[inline(always)]
    pub(super) fn solve<A: SolveWrist<6>>(
        &mut self,
        elbowed: &Elbowed<'_, A, T>,
        poses: &[Pose<T>; L],
        places: &mut [Option<Solutions<T, 6, Posture>>; L],
    ) {
        // By itself: where a pose's numbers stand one after the other no vector is to be had.
        self.poses = pose::gathered(poses);
        for lane in 0..L {
            self.see(lane, elbowed);
        }
        let one = T::lit(1.0);
        for ([up, down], side) in self.placed.iter_mut().zip(SIDES) {
            let side = T::lit(side);
            for lane in 0..L {
                let seen = Seen {
                    x: self.x.lane(lane),
                    y: self.y.lane(lane),
                    across: self.across.lane(lane),
                    half: self.half.lane(lane),
                    v: self.v.lane(lane),
                    per: self.per.lane(lane),
                };
                let pose = pose::one(&self.poses, lane);
                let window = T::lit(ROUND_OFF) * T::EPS * self.scale.lane(lane);
                let side = Side::new(elbowed.base, &seen, side, window);
                // Both before their wrists, so that a processor has them at once.
                let rows = [side.rows(elbowed.base, one), side.rows(elbowed.base, -one)];
                up.solve(lane, elbowed, &pose, &side, &rows[0], self.per_scale.lane(lane));
                down.solve(lane, elbowed, &pose, &side, &rows[1], self.per_scale.lane(lane));
            }
        }
        for (lane, place) in places.iter_mut().enumerate() {
            self.give(lane, elbowed.arm, place);
        }
    }

    /// The first figure of the base, and whether the pose is one.
    #[inline(always)]
    fn see<A: SolveWrist<6>>(&mut self, lane: usize, elbowed: &Elbowed<'_, A, T>) {
        let (pose, one) = (&pose::one(&self.poses, lane), T::lit(1.0));
        let (scale, refused) = target::judged(pose, elbowed.base.reach);
        let Seen { x, y, across, half, v, per } = Seen::new(elbowed.base, elbowed.arm.wrist_centre(pose));
        set! { lane:
            self.scale, scale;
            self.per_scale, one / scale;
            self.x, x;
            self.y, y;
            self.across, across;
            self.half, half;
            self.v, v;
            self.per, per;
            self.doubt, refused + unless(half > far::<T>() * scale);
        }
    }

    /// Puts the solutions of one of the poses into its place, if it is regular; else nothing.
    #[inline(always)]
    fn give<A: SolveWrist<6>>(&self, lane: usize, arm: &A, place: &mut Option<Solutions<T, 6, Posture>>) {
        let ([[up, down], [over, under]], zero) = (&self.placed, T::lit(0.0));
        let doubt = (up.doubt(lane) + down.doubt(lane)) + (over.doubt(lane) + under.doubt(lane));
        if (self.doubt.lane(lane) + doubt <= zero) & up.closes(lane) & over.closes(lane) {
            self.fill(lane, arm, [None; 2], place);
        } else {
            self.give_half(lane, arm, place);
        }
    }

    /// The same of a pose that not both shoulders reach.
    #[inline(never)]
    fn give_half<A: SolveWrist<6>>(
        &self,
        lane: usize,
        arm: &A,
        place: &mut Option<Solutions<T, 6, Posture>>,
    ) {
        let ([right, left], zero) = (&self.placed, T::lit(0.0));
        let side = |[up, down]: &[Placements<T, L>; 2], base: &ElbowBase<T>| match up.closes(lane) {
            true => (up.doubt(lane) + down.doubt(lane) <= zero).then_some(None),
            false => up.open(lane, base, self.scale.lane(lane)).map(Some),
        };
        *place = None;
        if self.doubt.lane(lane) <= zero
            && let Base::Elbow(base) = &arm.base()
            && let (Some(right), Some(left)) = (side(right, base), side(left, base))
        {
            self.fill(lane, arm, [right, left], place);
        }
    }

    /// Puts the solutions of one of the poses into its place; `open` says why a shoulder is empty.
    #[inline(always)]
    fn fill<A: SolveWrist<6>>(
        &self,
        lane: usize,
        arm: &A,
        open: [Option<Reason<T>>; 2],
        place: &mut Option<Solutions<T, 6, Posture>>,
    ) {
        let [[up, down], [over, under]] = &self.placed;
        let solution = |placement, bend| {
            let placed = match placement {
                0 => up,
                1 => over,
                2 => down,
                _ => under,
            };
            placed.solution(lane, arm, bend)
        };
        let elbows = [up.elbow(lane), over.elbow(lane)];
        place.get_or_insert_with(|| Solutions::none(sliding(&A::JOINTS), Reason::NotFinite)).fill(slots(
            solution,
            self.half.lane(lane),
            elbows,
            open,
        ));
    }
}
