//! Poses abreast: the branches of a batch's poses, in loops over the poses.
//!
//! The loops have no branch and no call, so that compilers make vectors of them, as wide as the machine has them. What they do
//! is the program for branches side by side ([`elbow`](crate::ik::elbow), [`bends`](crate::ik::bends)) with a single lane,
//! step by step: each loop is as short as what a processor looks ahead, and many of its passes go on at once. Between two
//! steps the numbers stand in memory, pose beside pose.
//!
//! Everything is inlined into the loop over a batch that is compiled for an instruction set. Poses of which some figure is near
//! a singular one, and what is no pose at all, are left to the solver of a single one.

use crate::ik::bends::{Aimed, Angles, Bent, Turned, joint_values};
use crate::ik::elbow::{self, Elbows, Seen, Side};
use crate::ik::side::{self, slots};
use crate::ik::target::{self, is_accepted};
use crate::ik::wrist::Rows;
use crate::ik::{ElbowBase, ROUND_OFF};
use crate::math::{Float, Lanes};
use crate::pose::{self, Pose};
use crate::private::SolveWrist;
use crate::solutions::{Bend, Posture, Reason, Solutions};

/// How many angles the rotation of a wrist may have here: those of the first three joints.
pub(super) const TURNS: usize = 4;

/// Room for what is known of poses abreast: as the base is solved, then the wrist. Where a cache line begins, so that no vector
/// lies across two.
#[repr(align(64))]
pub(super) struct Abreast<T, const L: usize> {
    poses: Pose<Lanes<T, L>>,
    /// The sizes against which the poses are judged, and one over them.
    scale: Lanes<T, L>,
    per_scale: Lanes<T, L>,
    /// The distance of the wrist centre from the plane in which both shoulders are one, and how far is far away from it.
    half: Lanes<T, L>,
    far_away: Lanes<T, L>,
    /// The right shoulder and the left one.
    shoulders: [Shoulder<T, L>; 2],
}

/// A shoulder, and its placements with the elbow up and down.
#[derive(Clone, Copy)]
struct Shoulder<T, const L: usize> {
    side: Side<T, L>,
    elbows: Elbows<T, L>,
    /// Sine and cosine of the row value of joint 1.
    first: [Lanes<T, L>; 2],
    /// 0 where no figure is near a singular one, if the links close.
    doubt: Lanes<T, L>,
    wrists: [Wrist<T, L>; 2],
}

/// The wrist over a placement, step by step.
#[derive(Clone, Copy)]
struct Wrist<T, const L: usize> {
    sines: [Lanes<T, L>; TURNS],
    cosines: [Lanes<T, L>; TURNS],
    matrix: [[Lanes<T, L>; 3]; 3],
    sine: Lanes<T, L>,
    angles: Angles<T, L>,
    /// How far forward kinematics of both bends misses the pose.
    residual: [Lanes<T, L>; 2],
}

/// Sets a lane of many places to the only lane of as many values.
macro_rules! set {
    ($lane:ident: $($place:expr, $value:expr;)*) => { $($place.put($lane, $value.lane(0));)* };
}

/// The three of one lane.
macro_rules! three {
    ($lanes:expr, $lane:expr) => {
        [$lanes[0].one($lane), $lanes[1].one($lane), $lanes[2].one($lane)]
    };
}

impl<T: Float, const L: usize> Abreast<T, L> {
    /// Room that is to be filled.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let zero = Lanes::splat(T::lit(0.0));
        let wrist = Wrist {
            sines: [zero; TURNS],
            cosines: [zero; TURNS],
            matrix: [[zero; 3]; 3],
            sine: zero,
            angles: Angles { noflip: [zero; 3], flip: [zero; 3], margin: zero },
            residual: [zero; 2],
        };
        let side = Side {
            spare: zero,
            square: zero,
            centre: [zero; 2],
            plane: [zero; 2],
            bend: [zero; 2],
            lean: [zero; 2],
            sign: zero,
        };
        let elbows = Elbows { rows: [[zero; 3]; 2], margin: zero };
        let shoulder = Shoulder { side, elbows, first: [zero; 2], doubt: zero, wrists: [wrist; 2] };
        let poses = pose::from_rows([[zero; 3]; 3], [zero; 3]);
        Abreast { poses, scale: zero, per_scale: zero, half: zero, far_away: zero, shoulders: [shoulder; 2] }
    }

    /// All solutions of as many poses as there are lanes, where every figure is far from a singular one as in
    /// [`side::regular`](crate::ik::side::regular); nothing in the other places.
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
        for shoulder in &mut self.shoulders {
            for lane in 0..L {
                shoulder.close(lane, base, self.far_away.one(lane));
            }
        }
        for shoulder in &mut self.shoulders {
            for (wrist, rows) in shoulder.wrists.iter_mut().zip(&shoulder.elbows.rows) {
                for lane in 0..L {
                    let pose = pose::one(&self.poses, lane);
                    let first = [shoulder.first[0].one(lane), shoulder.first[1].one(lane)];
                    let doubt = wrist.aim(lane, arm, &pose, three!(rows, lane), first, far);
                    shoulder.doubt.put(lane, shoulder.doubt.lane(lane) + doubt.lane(0));
                }
            }
        }
        for shoulder in &mut self.shoulders {
            for wrist in &mut shoulder.wrists {
                for lane in 0..L {
                    wrist.turn(lane, offsets);
                }
            }
        }
        for shoulder in &mut self.shoulders {
            for (wrist, rows) in shoulder.wrists.iter_mut().zip(&shoulder.elbows.rows) {
                for lane in 0..L {
                    let (pose, per_scale) = (pose::one(&self.poses, lane), self.per_scale.one(lane));
                    let doubt = wrist.check(lane, arm, &pose, per_scale, three!(rows, lane));
                    shoulder.doubt.put(lane, shoulder.doubt.lane(lane) + doubt.lane(0));
                }
            }
        }
        for (lane, place) in places.iter_mut().enumerate() {
            self.give(arm, base, lane, place);
        }
    }

    /// The figures of the base, up to where angles are taken.
    #[inline(always)]
    fn see<A: SolveWrist<6>>(&mut self, lane: usize, arm: &A, base: &ElbowBase<T>, far: T) {
        let pose = &pose::one(&self.poses, lane);
        let one = Lanes([T::lit(1.0)]);
        let (scale, refused) = target::judged(pose, base.reach);
        let far_away = Lanes([far]) * scale.greatest(one);
        let window = Lanes([T::lit(ROUND_OFF) * T::EPS]) * scale;
        let seen = Seen::new(base, arm.wrist_centre(pose));
        let doubt = refused + (seen.half - far_away).unless(|spare| spare > T::lit(0.0));
        let [right, left] = &mut self.shoulders;
        right.put(lane, &Side::new(base, &seen, one, window), doubt);
        left.put(lane, &Side::new(base, &seen, -one, window), doubt);
        set! { lane:
            self.scale, scale;
            self.per_scale, (one / scale);
            self.half, seen.half;
            self.far_away, far_away;
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
        let zero = T::lit(0.0);
        let [right, left] = &self.shoulders;
        let closes = |shoulder: &Shoulder<T, L>| shoulder.side.spare.lane(lane) > zero;
        let is_sure = |shoulder: &Shoulder<T, L>| shoulder.doubt.lane(lane) <= zero;
        let open = |shoulder: &Shoulder<T, L>| {
            let [[first, ..], _] = &shoulder.elbows.rows;
            elbow::open(base, shoulder.side.square.lane(lane), first.lane(lane), self.scale.lane(lane))
        };
        *place = None;
        // Each by itself, so that numbers go straight to their places.
        if closes(right) & closes(left) {
            if is_sure(right) & is_sure(left) {
                *place = Some(self.slots(arm, lane, [None; 2]));
            }
        } else if closes(right) & is_sure(right)
            && let Some(reason) = open(left)
        {
            *place = Some(self.slots(arm, lane, [None, Some(reason)]));
        } else if closes(left) & is_sure(left)
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
        let [right, left] = &self.shoulders;
        let solved = |placement, bend| {
            let (shoulder, elbow) = match placement {
                0 => (right, 0),
                1 => (left, 0),
                2 => (right, 1),
                _ => (left, 1),
            };
            let ([up, down], [over, under]) = (&shoulder.wrists, &shoulder.elbows.rows);
            let (wrist, rows) = if elbow == 0 { (up, over) } else { (down, under) };
            wrist.solution(arm, rows, bend, lane)
        };
        let elbow = [right.elbows.margin.lane(lane), left.elbows.margin.lane(lane)];
        slots(&A::JOINTS, solved, self.half.lane(lane), elbow, open)
    }
}

impl<T: Float, const L: usize> Shoulder<T, L> {
    /// Sets what is known of one lane before angles are taken.
    #[inline(always)]
    fn put(&mut self, lane: usize, side: &Side<T, 1>, doubt: Lanes<T, 1>) {
        set! { lane:
            self.side.spare, side.spare;
            self.side.square, side.square;
            self.side.centre[0], side.centre[0];
            self.side.centre[1], side.centre[1];
            self.side.plane[0], side.plane[0];
            self.side.plane[1], side.plane[1];
            self.side.bend[0], side.bend[0];
            self.side.bend[1], side.bend[1];
            self.side.lean[0], side.lean[0];
            self.side.lean[1], side.lean[1];
            self.side.sign, side.sign;
            self.doubt, doubt;
        }
    }

    /// The placements of one lane.
    #[inline(always)]
    fn close(&mut self, lane: usize, base: &ElbowBase<T>, far_away: Lanes<T, 1>) {
        let Side { spare, square, centre, plane, bend, lean, sign } = &self.side;
        let two = |lanes: &[Lanes<T, L>; 2]| [lanes[0].one(lane), lanes[1].one(lane)];
        let side = Side {
            spare: spare.one(lane),
            square: square.one(lane),
            centre: two(centre),
            plane: two(plane),
            bend: two(bend),
            lean: two(lean),
            sign: sign.one(lane),
        };
        let Elbows { rows: [up, down], margin } = side.elbows(base);
        let turned = up[0].turned();
        let doubt = (margin - far_away).unless(|spare| spare > T::lit(0.0));
        set! { lane:
            self.elbows.rows[0][0], up[0];
            self.elbows.rows[0][1], up[1];
            self.elbows.rows[0][2], up[2];
            self.elbows.rows[1][0], down[0];
            self.elbows.rows[1][1], down[1];
            self.elbows.rows[1][2], down[2];
            self.elbows.margin, margin;
            self.first[0], turned[0];
            self.first[1], turned[1];
            self.doubt, (self.doubt.one(lane) + doubt);
        }
    }
}

impl<T: Float, const L: usize> Wrist<T, L> {
    /// What the wrist must turn over one lane's placement; 0 if it is far from straight.
    #[inline(always)]
    fn aim<A: SolveWrist<6>>(
        &mut self,
        lane: usize,
        arm: &A,
        pose: &Pose<Lanes<T, 1>>,
        rows: [Lanes<T, 1>; 3],
        first: [Lanes<T, 1>; 2],
        far: T,
    ) -> Lanes<T, 1> {
        let aimed =
            Aimed::new(arm, pose, rows, |index, angle| (index == 0 && angle.is(rows[0])).then_some(first));
        let Turned { sines, cosines, .. } = &aimed.turned;
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
        aimed.sine.unless(|sine| sine > far)
    }

    /// One lane of what the wrist must turn.
    #[inline(always)]
    fn aimed(&self, lane: usize) -> Aimed<T, 1> {
        let zero = Lanes([T::lit(-0.0)]);
        let eight = |lanes: &[Lanes<T, L>; TURNS]| {
            let [a, b, c, d] = lanes;
            [a.one(lane), b.one(lane), c.one(lane), d.one(lane), zero, zero, zero, zero]
        };
        let [x, y, z] = &self.matrix;
        Aimed {
            turned: Turned::of_unknown(eight(&self.sines), eight(&self.cosines)),
            matrix: [three!(x, lane), three!(y, lane), three!(z, lane)],
            sine: self.sine.one(lane),
        }
    }

    /// The angles of one lane.
    #[inline(always)]
    fn turn(&mut self, lane: usize, offsets: &Rows<T>) {
        let new = Angles::new(&self.aimed(lane), offsets);
        set! { lane:
            self.angles.noflip[0], new.noflip[0];
            self.angles.noflip[1], new.noflip[1];
            self.angles.noflip[2], new.noflip[2];
            self.angles.flip[0], new.flip[0];
            self.angles.flip[1], new.flip[1];
            self.angles.flip[2], new.flip[2];
            self.angles.margin, new.margin;
        }
    }

    /// Forward kinematics of one lane; 0 if it comes back to the pose.
    #[inline(always)]
    fn check<A: SolveWrist<6>>(
        &mut self,
        lane: usize,
        arm: &A,
        pose: &Pose<Lanes<T, 1>>,
        per_scale: Lanes<T, 1>,
        rows: [Lanes<T, 1>; 3],
    ) -> Lanes<T, 1> {
        let Angles { noflip, flip, margin } = &self.angles;
        let angles =
            Angles { noflip: three!(noflip, lane), flip: three!(flip, lane), margin: margin.one(lane) };
        let Bent { residual: [noflip, flip], .. } =
            Bent::new(arm, pose, per_scale, rows, &self.aimed(lane), &angles);
        set! { lane:
            self.residual[0], noflip;
            self.residual[1], flip;
        }
        noflip.unless(is_accepted) + flip.unless(is_accepted)
    }

    /// The joint values of one lane with one of the bends, their residual, and the bend's distance from straight.
    #[inline(always)]
    fn solution<A: SolveWrist<6>>(
        &self,
        arm: &A,
        rows: &[Lanes<T, L>; 3],
        bend: Bend,
        lane: usize,
    ) -> ([T; 6], T, T) {
        let (angles, [noflip, flip]) = (&self.angles, &self.residual);
        let (wrist, residual) =
            if bend == Bend::NoFlip { (&angles.noflip, noflip) } else { (&angles.flip, flip) };
        let ([t1, t2, t3], [t4, t5, t6]) = (three!(rows, lane), three!(wrist, lane));
        let [a, b, c, d, e, f] = pose::entries(&joint_values(arm, [t1, t2, t3, t4, t5, t6]));
        let q = [a.lane(0), b.lane(0), c.lane(0), d.lane(0), e.lane(0), f.lane(0)];
        (q, residual.lane(lane), angles.margin.lane(lane))
    }
}
