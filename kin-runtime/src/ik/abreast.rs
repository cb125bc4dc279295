//! Poses abreast: the branches of a batch's poses, in loops over the poses.
//!
//! What they do is what [`side`](crate::ik::side) does for one pose, with the same bits: there the lanes are its placements, here
//! each shoulder and each placement has the poses for its lanes.
//!
//! Everything is inlined into the loop over a batch that is compiled for an instruction set. Poses of which some figure is near
//! a singular one, and what is no pose at all, are left to the solver of a single one.

use crate::ik::elbow::{self, Elbows, Seen, Side};
use crate::ik::side::{self, slots};
use crate::ik::target::{self, unless};
use crate::ik::wrist::Rows;
use crate::ik::wrists::{Wrists, set, three};
use crate::ik::{ElbowBase, ROUND_OFF};
use crate::math::{Float, Lanes};
use crate::pose::{self, Pose};
use crate::private::SolveWrist;
use crate::solutions::{Posture, Reason, Solutions};

/// Room for what is known of poses abreast: as the base is solved, then the wrist. Where a cache line begins, so that no vector
/// lies across two.
#[repr(align(64))]
pub(super) struct Abreast<T, const L: usize> {
    poses: Pose<Lanes<T, L>>,
    /// The sizes against which the poses are judged, and one over them.
    scale: Lanes<T, L>,
    per_scale: Lanes<T, L>,
    /// The wrist centre seen from axis 1.
    x: Lanes<T, L>,
    y: Lanes<T, L>,
    across: Lanes<T, L>,
    half: Lanes<T, L>,
    v: Lanes<T, L>,
    /// 0 for a pose that stands for itself, and whose shoulders are far apart.
    doubt: Lanes<T, L>,
    /// The right ones and the left ones, and the wrists over them with the elbow up and down.
    shoulders: [Shoulders<T, L>; 2],
    wrists: [[Wrists<T, L>; 2]; 2],
}

/// Which side of axis 1 the right shoulder is on, and the left one.
const SIGNS: [f64; 2] = [1.0, -1.0];

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
            doubt: zero,
            shoulders: [Shoulders::new(); 2],
            wrists: [[Wrists::new(); 2]; 2],
        }
    }

    /// All solutions of as many poses as there are lanes, where every figure is far from a singular one as in
    /// [`side::regular`]; nothing in the other places.
    #[inline(always)]
    pub(super) fn solve<A: SolveWrist<6>>(
        &mut self,
        arm: &A,
        base: &ElbowBase<T>,
        offsets: &Rows<T>,
        poses: &[Pose<T>; L],
        places: &mut [Option<Solutions<T, 6, Posture>>; L],
    ) {
        let far = side::far();
        // By itself: where a pose's numbers stand one after the other no vector is to be had.
        self.poses = pose::gathered(poses);
        for lane in 0..L {
            self.see(lane, arm, base, far);
        }
        for (shoulders, sign) in self.shoulders.iter_mut().zip(SIGNS) {
            for lane in 0..L {
                let seen = Seen {
                    x: self.x.lane(lane),
                    y: self.y.lane(lane),
                    across: self.across.lane(lane),
                    half: self.half.lane(lane),
                    v: self.v.lane(lane),
                };
                let window = T::lit(ROUND_OFF) * T::EPS * self.scale.lane(lane);
                shoulders.close(lane, base, &seen, T::lit(sign), [window, far]);
            }
        }
        for (shoulders, wrists) in self.shoulders.iter_mut().zip(&mut self.wrists) {
            for (elbow, wrists) in wrists.iter_mut().enumerate() {
                for lane in 0..L {
                    let (pose, rows) = (pose::one(&self.poses, lane), shoulders.rows(elbow, lane));
                    let doubt = wrists.aim(lane, arm, &pose, rows, shoulders.first(lane), far);
                    shoulders.doubt.put(lane, shoulders.doubt.lane(lane) + doubt);
                }
            }
        }
        for wrists in self.wrists.as_flattened_mut() {
            for lane in 0..L {
                wrists.turn(lane, offsets);
            }
        }
        for (shoulders, wrists) in self.shoulders.iter_mut().zip(&mut self.wrists) {
            for (elbow, wrists) in wrists.iter_mut().enumerate() {
                for lane in 0..L {
                    let (pose, rows) = (pose::one(&self.poses, lane), shoulders.rows(elbow, lane));
                    let doubt = wrists.check(lane, arm, &pose, self.per_scale.lane(lane), rows);
                    shoulders.doubt.put(lane, shoulders.doubt.lane(lane) + doubt);
                }
            }
        }
        for (lane, place) in places.iter_mut().enumerate() {
            self.give(arm, base, lane, place);
        }
    }

    /// The first figure of the base, and whether the pose is one.
    #[inline(always)]
    fn see<A: SolveWrist<6>>(&mut self, lane: usize, arm: &A, base: &ElbowBase<T>, far: T) {
        let (pose, one) = (&pose::one(&self.poses, lane), T::lit(1.0));
        let (scale, refused) = target::judged(pose, base.reach);
        let Seen { x, y, across, half, v } = Seen::new(base, arm.wrist_centre(pose));
        set! { lane:
            self.scale, scale;
            self.per_scale, one / scale;
            self.x, x;
            self.y, y;
            self.across, across;
            self.half, half;
            self.v, v;
            self.doubt, refused + unless(half > far * scale);
        }
    }

    /// Puts the solutions of one of the poses into its place, if it is regular; else nothing.
    #[inline(always)]
    fn give<A: SolveWrist<6>>(
        &self,
        arm: &A,
        base: &ElbowBase<T>,
        lane: usize,
        place: &mut Option<Solutions<T, 6, Posture>>,
    ) {
        let [right, left] = &self.shoulders;
        let is_sure =
            |shoulder: &Shoulders<T, L>| self.doubt.lane(lane) + shoulder.doubt.lane(lane) <= T::lit(0.0);
        let open = |shoulder: &Shoulders<T, L>| shoulder.open(base, lane, self.scale.lane(lane));
        *place = None;
        // Each by itself, so that numbers go straight to their places.
        if right.closes(lane) & left.closes(lane) {
            if is_sure(right) & is_sure(left) {
                *place = Some(self.slots(arm, lane, [None; 2]));
            }
        } else if right.closes(lane) & is_sure(right)
            && let Some(reason) = open(left)
        {
            *place = Some(self.slots(arm, lane, [None, Some(reason)]));
        } else if left.closes(lane) & is_sure(left)
            && let Some(reason) = open(right)
        {
            *place = Some(self.slots(arm, lane, [Some(reason), None]));
        }
    }

    /// The slots of one of the poses; `open` says why a shoulder is empty.
    #[inline(always)]
    fn slots<A: SolveWrist<6>>(
        &self,
        arm: &A,
        lane: usize,
        open: [Option<Reason<T>>; 2],
    ) -> Solutions<T, 6, Posture> {
        let ([right, left], [rights, lefts]) = (&self.shoulders, &self.wrists);
        let solved = |placement, bend| {
            let (shoulder, [up, down]) = if placement % 2 == 0 { (right, rights) } else { (left, lefts) };
            let wrist = if placement < 2 { up } else { down };
            wrist.solution(arm, shoulder.rows(placement / 2, lane), bend, lane)
        };
        let elbow = [right.margin.lane(lane), left.margin.lane(lane)];
        slots(&A::JOINTS, solved, self.half.lane(lane), elbow, open)
    }
}

/// Shoulders, and their placements with the elbow up and down.
#[derive(Clone, Copy)]
struct Shoulders<T, const L: usize> {
    spare: Lanes<T, L>,
    square: Lanes<T, L>,
    /// Row values with the elbow up and with the elbow down.
    rows: [[Lanes<T, L>; 3]; 2],
    /// The elbow's angle from stretched or folded.
    margin: Lanes<T, L>,
    /// Sine and cosine of the row value of joint 1.
    first: [Lanes<T, L>; 2],
    /// 0 where no figure is near a singular one, if the links close.
    doubt: Lanes<T, L>,
}

impl<T: Float, const L: usize> Shoulders<T, L> {
    /// Room that is to be filled.
    #[inline(always)]
    fn new() -> Self {
        let zero = Lanes::splat(T::lit(0.0));
        Shoulders {
            spare: zero,
            square: zero,
            rows: [[zero; 3]; 2],
            margin: zero,
            first: [zero; 2],
            doubt: zero,
        }
    }

    /// The placements of one lane, on the side of this sign, for an elbow that is `far` from stretched or folded if its angle is so
    /// large.
    #[inline(always)]
    fn close(&mut self, lane: usize, base: &ElbowBase<T>, seen: &Seen<T>, sign: T, [window, far]: [T; 2]) {
        let side = Side::new(base, seen, sign, window);
        let Elbows { rows: [up, down], margin } = side.elbows(base, elbow::angles(side.directions()));
        let (sine, cosine) = T::sin_cos_straight(up[0]);
        set! { lane:
            self.spare, side.spare;
            self.square, side.square;
            self.rows[0][0], up[0];
            self.rows[0][1], up[1];
            self.rows[0][2], up[2];
            self.rows[1][0], down[0];
            self.rows[1][1], down[1];
            self.rows[1][2], down[2];
            self.margin, margin;
            self.first[0], sine;
            self.first[1], cosine;
            self.doubt, unless(margin > far);
        }
    }

    /// Sine and cosine of the row value of joint 1.
    #[inline(always)]
    fn first(&self, lane: usize) -> [T; 2] {
        let [sine, cosine] = &self.first;
        [sine.lane(lane), cosine.lane(lane)]
    }

    /// The row values of one lane, with the elbow up (0) or down (1).
    #[inline(always)]
    fn rows(&self, elbow: usize, lane: usize) -> [T; 3] {
        let [up, down] = &self.rows;
        if elbow == 0 { three(up, lane) } else { three(down, lane) }
    }

    /// Whether the links close over the distance, and by more than the window.
    #[inline(always)]
    fn closes(&self, lane: usize) -> bool {
        self.spare.lane(lane) > T::lit(0.0)
    }

    /// Why they do not: see [`elbow::open`].
    #[inline(always)]
    fn open(&self, base: &ElbowBase<T>, lane: usize, scale: T) -> Option<Reason<T>> {
        let [[first, ..], _] = &self.rows;
        elbow::open(base, self.square.lane(lane), first.lane(lane), scale)
    }
}
