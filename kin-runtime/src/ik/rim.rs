//! An oblique wrist at the rim of its cone that the rounding of the base has put beyond it.
//!
//! A wrist whose axes are not at right angles reaches the directions between two cones about axis 4. At a rim its three axes lie
//! in one plane, and joints 1 to 3 may miss theirs by more than the window of that figure: near a stretched elbow, or where the
//! shoulders meet, their round-off is magnified, up to √ε where branches touch. The direction is then out of reach by as much,
//! though the pose is not. From the nearest way, on the rim, the joints [settle](crate::ik::settle) on the pose, if they can. The
//! same where a joint of the base is free, and only values between those that were tried lead to the rim. (Of an arm whose first
//! three axes meet, all this seen from its tool.)

use crate::arm::Arm;
use crate::ik::base::{Placed, Placements};
use crate::ik::given_out;
use crate::ik::settle::settle;
use crate::ik::sphere::{Plan, Task, View};
use crate::ik::straight::{may_be_round_off, together};
use crate::ik::{DOUBTFUL, SETTLED};
use crate::math::{self, Float};
use crate::pose;
use crate::singularity::units;
use crate::solutions::{ArmPosture, Bend, Branch};

/// How far joints may settle from where they are, in radians and reaches, in units of the square root of what is missing: the wrist is
/// bent by as much if the direction is inside by that.
const NEAR: f64 = 64.0;

/// How much of what is missing may be round-off that the base has magnified, in units of ε times what the base makes of it. Much more
/// than for a bend that may be nothing: what the joints settle on reaches the pose, and no family is claimed.
const MAGNIFIED: f64 = 1024.0;

/// The most that the best of the values tried for a free joint may be beyond the rim, if one between them is not.
const BETWEEN: f64 = 0.25;

/// Tries each plan whose wrist is beyond its rim by no more than round-off of the base; of several that stand together, only the
/// one that misses least.
pub(super) fn reached<T: Float, V: View>(
    task: &Task<'_, T, V>,
    placements: &Placements<T>,
    plans: &mut [[Plan<T, V::Branch>; 2]; 4],
) {
    if !plans.iter().any(|both| matches!(both, [Plan::Rim(..), _])) {
        return;
    }
    let before = *plans;
    for (count, (posture, both)) in ArmPosture::ALL.iter().zip(plans.iter_mut()).enumerate() {
        let ([Plan::Rim(start, by, _), _], Ok(placed)) = (*both, posture.of(placements)) else { continue };
        let (here, _) = V::apart(start);
        let nearer = |(place, [other, _]): (usize, &[Plan<T, V::Branch>; 2])| match other {
            Plan::Rim(rows, least, _) => {
                let (there, _) = V::apart(*rows);
                (*least < by || (*least == by && place < count)) && together(task.view, here, there)
            }
            Plan::Try(..) | Plan::Again(_) | Plan::Empty(_) => false,
        };
        let doubtful = if task.at_will(placed) == [false; 2] {
            may_be_round_off(by, T::lit(MAGNIFIED), placed, &task.view.base())
        } else {
            by <= T::lit(BETWEEN)
        };
        if doubtful && !before.iter().enumerate().any(nearer) {
            *both = settled(task, *posture, placed, (start, by)).unwrap_or(*both);
        }
    }
    let is_tried = |both: &[Plan<T, V::Branch>; 2]| both.iter().any(|plan| matches!(plan, Plan::Try(..)));
    if !plans.iter().any(is_tried) {
        between(task, placements, plans);
    }
}

/// Where two joints of the base are all but free, its round-off is more than is known of it, and two ways that are one come out apart,
/// both beyond the rim. If nothing else reaches the pose, they and what is halfway between them are tried.
fn between<T: Float, V: View>(
    task: &Task<'_, T, V>,
    placements: &Placements<T>,
    plans: &mut [[Plan<T, V::Branch>; 2]; 4],
) {
    let rim = |[plan, _]: &[Plan<T, V::Branch>; 2]| match plan {
        Plan::Rim(rows, by, _) if *by <= math::sqrt(T::EPS) => Some((*rows, *by)),
        Plan::Rim(..) | Plan::Try(..) | Plan::Again(_) | Plan::Empty(_) => None,
    };
    let rims = plans.each_ref().map(rim);
    for (count, (posture, both)) in ArmPosture::ALL.iter().zip(plans).enumerate() {
        let (Some((here, by)), Ok(placed)) = (rim(both), posture.of(placements)) else { continue };
        for (there, more) in rims.iter().skip(count).flatten() {
            let start = pose::column(here);
            let way = given_out(pose::entries(&(pose::column(*there) - start)), &V::Arm::JOINTS);
            let middle = pose::entries(&(start + way * T::lit(0.5)));
            if let Some(found) = settled(task, *posture, placed, (middle, math::max(by, *more))) {
                *both = found;
                return;
            }
        }
    }
}

/// The two slots of a wrist at its rim, which are one.
fn settled<T: Float, V: View>(
    task: &Task<'_, T, V>,
    posture: ArmPosture,
    placed: &Placed<T>,
    (start, by): ([T; 6], T),
) -> Option<[Plan<T, V::Branch>; 2]> {
    let (_, [_, straight, _]) = V::apart(start);
    let start = pose::entries(&given_out(task.view.command(start), &V::Arm::JOINTS));
    let (q, residual) = settle(task.view.arm(), &task.target.pose, &pose::column(start))?;
    let near = T::lit(NEAR) * math::sqrt(by + T::lit(DOUBTFUL) * T::EPS);
    let units = units(&V::Arm::JOINTS, T::lit(task.view.arm().reach()));
    let mut ways = pose::entries(&q).into_iter().zip(start).zip(units);
    if residual > T::lit(SETTLED) * T::EPS || ways.any(|((a, b), unit)| math::abs(a - b) > near * unit) {
        return None;
    }
    let rows = task.view.rows(pose::entries(&q));
    let (base, sphere @ [_, bend, _]) = V::apart(rows);
    let placed = Placed { rows: base, ..*placed };
    let margins = V::margins(placed.shoulder, placed.elbow, math::abs(math::wrap(bend - straight)));
    let same = Plan::Again(V::branch(posture, Bend::NoFlip));
    Some([Plan::Try(rows, margins, task.free(&placed, sphere, None)), same])
}
