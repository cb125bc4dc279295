//! The branches of one pose side by side: the four placements of a base as lanes.

use crate::arm::Joint;
use crate::ik::bends::{Aimed, Angles, Bent, all};
use crate::ik::elbow::{Seen, Side};
use crate::ik::target::{Target, accepted};
use crate::ik::{ElbowBase, ROUND_OFF, sliding};
use crate::math::{self, Float, Lanes};
use crate::pose;
use crate::private::SolveWrist;
use crate::solutions::{
    Bend, Elbow, Free, Margins, Posture, Reason, Shoulder, Slot, Solution, Solutions, tolerance,
};

/// A value for each of four placements.
pub(crate) type Four<T> = Lanes<T, 4>;

/// Sine and cosine of an angle of the placements: that of the first joint alone comes twice.
#[inline(always)]
fn of_placements<T: Float>(&Lanes([a, b, c, d]): &Four<T>) -> Option<[Four<T>; 2]> {
    if !((a == c) & (b == d)) {
        return None;
    }
    let ([s, t], [c, d]) = T::sin_cos_all([a, b]);
    Some([Lanes([s, t, s, t]), Lanes([c, d, c, d])])
}

/// Joint by joint what came placement by placement.
pub(crate) fn transposed<T>([a, b, c, d]: [[T; 6]; 4]) -> [Four<T>; 6] {
    let ([a1, a2, a3, a4, a5, a6], [b1, b2, b3, b4, b5, b6]) = (a, b);
    let ([c1, c2, c3, c4, c5, c6], [d1, d2, d3, d4, d5, d6]) = (c, d);
    [
        Lanes([a1, b1, c1, d1]),
        Lanes([a2, b2, c2, d2]),
        Lanes([a3, b3, c3, d3]),
        Lanes([a4, b4, c4, d4]),
        Lanes([a5, b5, c5, d5]),
        Lanes([a6, b6, c6, d6]),
    ]
}

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
) -> Option<Solutions<T, 6, Posture>> {
    let (one, far) = (T::lit(1.0), far());
    let far_away = far * math::max(target.scale, one);
    let centre = arm.wrist_centre(&target.pose);
    let seen = Seen::new(base, centre.map(|x| Lanes([x; 2])));
    let [half, _] = seen.half.0;
    if half <= far_away {
        return None;
    }
    let window = T::lit(ROUND_OFF) * T::EPS * target.scale;
    let side = Side::new(base, &seen, Lanes([one, -one]), Lanes::splat(window));
    let ([right, left], elbows) = (side.closes(), side.elbows(base));
    let [elbow, bow] = elbows.margin.0;
    let apart = ((elbow > far_away) | !right) & ((bow > far_away) | !left);
    if !(apart & (right | left)) {
        return None;
    }
    // Where a shoulder does not close stands the other one.
    let pick = |Lanes([a, b]): Lanes<T, 2>| [if right { a } else { b }, if left { b } else { a }];
    let four = |up: Lanes<T, 2>, down: Lanes<T, 2>| {
        let ([a, b], [c, d]) = (pick(up), pick(down));
        Lanes([a, b, c, d])
    };
    let [[first, up2, up3], [_, down2, down3]] = elbows.rows;
    let rows = [four(first, first), four(up2, down2), four(up3, down3)];
    let (offsets, pose) = (arm.orthogonal_wrist::<T>()?, pose::side_by_side(&target.pose));
    let aimed = Aimed::new(arm, &pose, rows, |_, angle| of_placements(angle));
    // No angle is taken where the wrist is straight.
    if !all(aimed.sine, aimed.sine, |sine, _| sine > far) {
        return None;
    }
    let angles = Angles::new(&aimed, &offsets);
    let bent = Bent::new(arm, &pose, Lanes::splat(one / target.scale), rows, &aimed, &angles);
    let [noflip, flip] = bent.residual;
    if !all(noflip, flip, |a, b| accepted(a).is_ok() & accepted(b).is_ok()) {
        return None;
    }
    let [t1, t1_left] = first.0;
    let mut open = [None; 2];
    if !right {
        open = [Some(side.open(base, 0, t1, target.scale)?), None];
    }
    if !left {
        open = [None, Some(side.open(base, 1, t1_left, target.scale)?)];
    }
    let solved = |placement, bend| {
        let ([q, flipped], [noflip, flip]) = (&bent.q, &bent.residual);
        let (q, residual) = if bend == Bend::NoFlip { (q, noflip) } else { (flipped, flip) };
        let [a, b, c, d, e, f] = q;
        let lane = |lanes: &Four<T>| lanes.lane(placement);
        ([lane(a), lane(b), lane(c), lane(d), lane(e), lane(f)], lane(residual), lane(&angles.margin))
    };
    Some(slots(&A::JOINTS, solved, half, [elbow, bow], open))
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
