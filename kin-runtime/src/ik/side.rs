//! The branches of one pose side by side: its four placements as lanes.

use crate::arm::Joint;
use crate::ik::elbow::{self, Seen, Side};
use crate::ik::target::Target;
use crate::ik::wrist::Rows;
use crate::ik::wrists::{Wrists, three};
use crate::ik::{ElbowBase, ROUND_OFF, sliding};
use crate::math::{Float, Lanes};
use crate::pose;
use crate::private::SolveWrist;
use crate::solutions::{
    Bend, Elbow, Free, Margins, Posture, Reason, Shoulder, Slot, Solution, Solutions, tolerance,
};

/// A figure larger than this is far from a singular one: an angle or its sine, or a length over the size.
#[inline(always)]
pub(super) fn far<T: Float>() -> T {
    T::lit(64.0) * tolerance::<T>()
}

/// All solutions of an arm with an elbow and an orthogonal wrist, if no figure is near a singular one: so far from it that no
/// two solutions can be one, nothing is free, and nothing is in doubt.
#[inline(always)]
pub(crate) fn regular<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    base: &ElbowBase<T>,
    offsets: &Rows<T>,
) -> Option<Solutions<T, 6, Posture>> {
    let (pose, scale, far) = (&target.pose, target.scale, far());
    let seen = Seen::new(base, arm.wrist_centre(pose));
    let placed = Placements::new(base, &seen, scale)?;
    let mut wrists = Wrists::<T, 4>::new();
    let mut doubt = Lanes([T::lit(0.0); 4]);
    for lane in 0..4 {
        doubt.put(lane, wrists.aim(lane, arm, pose, placed.rows(lane), placed.first(lane), far));
    }
    for lane in 0..4 {
        wrists.turn(lane, offsets);
    }
    let per_scale = T::lit(1.0) / scale;
    for lane in 0..4 {
        let missed = wrists.check(lane, arm, pose, per_scale, placed.rows(lane));
        doubt.put(lane, doubt.lane(lane) + missed);
    }
    let [a, b, c, d] = doubt.0;
    // Without `&&`, which is a branch for each.
    if (a + b) + (c + d) > T::lit(0.0) {
        return None;
    }
    let solved = |placement, bend| wrists.solution(arm, placed.rows(placement), bend, placement);
    Some(slots(&A::JOINTS, solved, seen.half, placed.elbows, placed.open(base, scale)?))
}

/// The placements of a base: right and left with the elbow up, then with the elbow down. Where a shoulder does not close stands
/// the other one.
struct Placements<T> {
    rows: [Lanes<T, 4>; 3],
    /// Sine and cosine of the row value of joint 1.
    first: [Lanes<T, 4>; 2],
    /// Of the right shoulder and the left one: how far the elbow is from stretched or folded, whether the links close, the
    /// square of the distance over which they do not, and the row value of joint 1.
    elbows: [T; 2],
    closes: [bool; 2],
    squares: [T; 2],
    turned: [T; 2],
}

impl<T: Float> Placements<T> {
    /// Those of the wrist centre, if no figure is near a singular one.
    #[inline(always)]
    fn new(base: &ElbowBase<T>, seen: &Seen<T>, scale: T) -> Option<Self> {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let (far, window) = (far::<T>(), T::lit(ROUND_OFF) * T::EPS * scale);
        let (right, left) = (Side::new(base, seen, one, window), Side::new(base, seen, -one, window));
        let ([a, b, c, d], [e, f, g, h]) = (right.directions(), left.directions());
        // Four angles and then four more: a loop over vectors.
        let (mut angles, mut others) = ([a, e, b, f], [c, g, d, h]);
        for (angle, other) in angles.iter_mut().zip(&mut others) {
            let ([y, x], [v, u]) = (*angle, *other);
            *angle = [T::atan2_straight(y, x), x];
            *other = [T::atan2_straight(v, u), u];
        }
        let ([[a, _], [e, _], [b, _], [f, _]], [[c, _], [g, _], [d, _], [h, _]]) = (angles, others);
        let (near, away) = (right.elbows(base, [a, b, c, d]), left.elbows(base, [e, f, g, h]));
        let closes = [right.spare > zero, left.spare > zero];
        let [on_right, on_left] = closes;
        let apart = ((near.margin > far) | !on_right) & ((away.margin > far) | !on_left);
        if !(apart & (on_right | on_left) & (seen.half > far * scale)) {
            return None;
        }
        let pick = |a: T, b: T| [if on_right { a } else { b }, if on_left { b } else { a }];
        let four = |[a, b]: [T; 2], [c, d]: [T; 2]| Lanes([a, b, c, d]);
        let ([[t1, a2, a3], [_, b2, b3]], [[s1, c2, c3], [_, d2, d3]]) = (near.rows, away.rows);
        let [k, l] = pick(t1, s1);
        let ((sk, ck), (sl, cl)) = (T::sin_cos_straight(k), T::sin_cos_straight(l));
        Some(Placements {
            rows: [Lanes([k, l, k, l]), four(pick(a2, c2), pick(b2, d2)), four(pick(a3, c3), pick(b3, d3))],
            first: [Lanes([sk, sl, sk, sl]), Lanes([ck, cl, ck, cl])],
            elbows: [near.margin, away.margin],
            closes,
            squares: [right.square, left.square],
            turned: [t1, s1],
        })
    }

    /// The row values of a placement.
    #[inline(always)]
    fn rows(&self, lane: usize) -> [T; 3] {
        three(&self.rows, lane)
    }

    /// Sine and cosine of the first of them.
    #[inline(always)]
    fn first(&self, lane: usize) -> [T; 2] {
        let [sine, cosine] = &self.first;
        [sine.lane(lane), cosine.lane(lane)]
    }

    /// Why shoulders are empty; nothing at all where one may be at its boundary but for round-off.
    #[inline(always)]
    fn open(&self, base: &ElbowBase<T>, scale: T) -> Option<[Option<Reason<T>>; 2]> {
        let ([right, left], [a, b], [t1, s1]) = (self.closes, self.squares, self.turned);
        if !right {
            return Some([Some(elbow::open(base, a, t1, scale)?), None]);
        }
        if !left {
            return Some([None, Some(elbow::open(base, b, s1, scale)?)]);
        }
        Some([None; 2])
    }
}

/// The slots of four placements, right and left with the elbow up, then with the elbow down. `solved` gives the joint values of
/// one of them with one of the bends, their residual, and the bend's distance from straight; `open` says why a shoulder is empty.
#[inline(always)]
pub(super) fn slots<T: Float>(
    joints: &[Joint; 6],
    solved: impl Fn(usize, Bend) -> ([T; 6], T, T),
    shoulder: T,
    [elbow, bow]: [T; 2],
    [right, left]: [Option<Reason<T>>; 2],
) -> Solutions<T, 6, Posture> {
    Solutions::new(
        sliding(joints),
        #[inline(always)]
        |branch: Posture| {
            let (open, elbow) = if branch.shoulder == Shoulder::Right { (right, elbow) } else { (left, bow) };
            if let Some(reason) = open {
                return Slot::Empty(reason);
            }
            let placement =
                usize::from(branch.shoulder == Shoulder::Left) + 2 * usize::from(branch.elbow == Elbow::Down);
            let (q, residual, wrist) = solved(placement, branch.wrist);
            let margins = Margins { shoulder, elbow, wrist: Some(wrist) };
            Slot::Solved(Solution { branch, q: pose::column(q), residual, margins, free: Free::NOTHING })
        },
    )
}
