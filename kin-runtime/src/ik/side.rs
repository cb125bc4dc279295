//! The branches of one pose side by side: its four placements as lanes.

use crate::ik::elbow::{Seen, Side};
use crate::ik::placements::{Elbowed, Placements, far};
use crate::ik::target::{Target, unless};
use crate::ik::{ROUND_OFF, sliding};
use crate::math::Float;
use crate::pose;
use crate::private::SolveWrist;
use crate::solutions::{Bend, Elbow, Free, Margins, Posture, Reason, Shoulder, Slot, Solution, Solutions};

/// The placements, right and left with the elbow up, then with the elbow down: which side of axis 1 the shoulder is on, and
/// which way the elbow bends.
const SIDES: [f64; 4] = [1.0, -1.0, 1.0, -1.0];
const ELBOWS: [f64; 4] = [1.0, 1.0, -1.0, -1.0];

/// All solutions of an arm with an elbow and an orthogonal wrist, if every figure is [`far`] from a singular one.
#[inline(always)]
pub(crate) fn regular<T: Float, A: SolveWrist<6>>(
    elbowed: &Elbowed<'_, A, T>,
    target: &Target<T>,
) -> Option<Solutions<T, 6, Posture>> {
    let (pose, scale, zero) = (&target.pose, target.scale, T::lit(0.0));
    let (window, per_scale) = (T::lit(ROUND_OFF) * T::EPS * scale, T::lit(1.0) / scale);
    let seen = Seen::new(elbowed.base, elbowed.arm.wrist_centre(pose));
    let mut placed = Placements::<T, 4>::new();
    for (lane, (side, elbow)) in SIDES.into_iter().zip(ELBOWS).enumerate() {
        let side = Side::new(elbowed.base, &seen, T::lit(side), window);
        placed.solve(lane, elbowed, pose, &side, &side.rows(elbowed.base, T::lit(elbow)), per_scale);
    }
    let doubt = |lane| if placed.closes(lane) { placed.doubt(lane) } else { zero };
    let near = unless::<T>(seen.half > far::<T>() * scale);
    // Without `&&`, which is a branch for each.
    if near + ((doubt(0) + doubt(1)) + (doubt(2) + doubt(3))) > zero {
        return None;
    }
    let open = |lane| placed.open(lane, elbowed.base, scale);
    let open = match [placed.closes(0), placed.closes(1)] {
        [true, true] => [None; 2],
        [true, false] => [None, Some(open(1)?)],
        [false, true] => [Some(open(0)?), None],
        [false, false] => [Some(open(0)?), Some(open(1)?)],
    };
    let solution = |placement, bend| placed.solution(placement, elbowed.arm, bend);
    let elbows = [placed.elbow(0), placed.elbow(1)];
    Some(Solutions::new(sliding(&A::JOINTS), slots(solution, seen.half, elbows, open)))
}

/// What becomes of each branch of four placements. `solution` gives the joint values of one of them with one of the bends, their
/// residual, and the bend's distance from straight; `open` says why a shoulder, the right one or the left one, is empty.
#[inline(always)]
pub(super) fn slots<T: Float>(
    solution: impl Fn(usize, Bend) -> ([T; 6], T, T),
    shoulder: T,
    [elbow, bow]: [T; 2],
    [right, left]: [Option<Reason<T>>; 2],
) -> impl Fn(Posture) -> Slot<T, 6, Posture> {
    #[inline(always)]
    move |branch| {
        let (open, elbow) = if branch.shoulder == Shoulder::Right { (right, elbow) } else { (left, bow) };
        if let Some(reason) = open {
            return Slot::Empty(reason);
        }
        let placement =
            usize::from(branch.shoulder == Shoulder::Left) + 2 * usize::from(branch.elbow == Elbow::Down);
        let (q, residual, wrist) = solution(placement, branch.wrist);
        let margins = Margins { shoulder, elbow, wrist: Some(wrist) };
        Slot::Solved(Solution { branch, q: pose::column(q), residual, margins, free: Free::NOTHING })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solutions::{ArmPosture, Branch};

    #[test]
    fn placements_stand_in_the_order_of_their_names() {
        assert_eq!(ArmPosture::ALL.len(), SIDES.len());
        for posture in ArmPosture::ALL {
            let lane = usize::from(posture.shoulder == Shoulder::Left)
                + 2 * usize::from(posture.elbow == Elbow::Down);
            let wanted = (posture.shoulder == Shoulder::Right, posture.elbow == Elbow::Up);
            assert_eq!((SIDES[lane] > 0.0, ELBOWS[lane] > 0.0), wanted, "{posture}");
        }
    }
}
