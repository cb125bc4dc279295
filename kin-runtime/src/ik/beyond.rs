//! A joint of the base that is all but free, and an oblique wrist that does not take all of its values.
//!
//! Where the wrist centre is a few ε from the axis of joint 1 or 2, its place says next to nothing of that joint: all values within
//! a large angle reach the pose as well. An oblique wrist takes those at which the angle between its outer axes is between the rims
//! of its cone. What the figure of the joint says, which is round-off, may lie on one side of the values that the wrist does not
//! take, and the joints that the pose came from on the other: where these values end there is then another solution, no worse. (Of
//! an arm whose first three axes meet, all this seen from its tool.)

use crate::arm::Arm;
use crate::ik::base::{Base, Placed, Placements};
use crate::ik::general::{SLACK, cross, length};
use crate::ik::settle::settle;
use crate::ik::sphere::{Plan, Task, View, motion};
use crate::ik::wave::Wave;
use crate::ik::wrist::Wrist;
use crate::ik::{SETTLED, given_out};
use crate::math::{self, Float};
use crate::pose;
use crate::solutions::{ArmPosture, Bend, Branch, Free, Solution};

/// Values of the joint that are tried for one that the wrist takes.
const TRIED: i32 = 16;

/// How many edges are looked at.
const KEPT: usize = 8;

/// Within this part of what a joint is loose by, two ways of the wrist that become one there are one but for an ε.
const ONE: f64 = 1.0 / 16.0;

/// Where values of a joint begin that the wrist takes, after others that it does not.
#[derive(Clone, Copy)]
struct Edge<T> {
    posture: ArmPosture,
    joint: usize,
    /// How far that is from where the joint is placed.
    by: T,
    /// Whether both ways of the wrist there are as good as one, that at another edge before this one.
    one: bool,
}

/// A solution beyond values that the wrist does not take.
#[derive(Clone, Copy)]
pub(super) struct Beyond<T, B> {
    pub(super) solution: Solution<T, 6, B>,
    /// Whether it may have the slot of its label, whose solution is as good as one with another.
    pub(super) instead: bool,
}

/// What is beyond values that the wrist does not take, the nearest first. Where the figure says such a value the slots of that
/// placement take the nearest that the wrist does.
pub(super) fn found<T: Float, V: View>(
    task: &Task<'_, T, V>,
    base: &Base<T>,
    placements: &Placements<T>,
    plans: &mut [[Plan<T, V::Branch>; 2]; 4],
) -> [Option<Beyond<T, V::Branch>>; KEPT] {
    let (near, centre) = (math::sqrt(T::EPS) * task.target.scale, task.view.centre(&task.target.pose));
    let mut nearest = [None; KEPT];
    for (posture, both) in ArmPosture::ALL.iter().zip(plans) {
        let Ok(placed) = posture.of(placements) else { continue };
        let free = [placed.shoulder_free, placed.elbow_free];
        let mut own = [None; KEPT];
        for (joint, (distance, is_free)) in
            base.axis_distances(placed, centre).into_iter().zip(free).enumerate()
        {
            if is_free || distance > near {
                continue;
            }
            let loose = T::lit(SETTLED) * T::EPS * task.target.scale / distance;
            for by in edges(task, placed, joint).into_iter().flatten().filter(|by| math::abs(*by) <= loose) {
                let one = matches!(both, [Plan::Try(..), _]) && math::abs(by) <= T::lit(ONE) * loose;
                keep(&mut own, Edge { posture: *posture, joint, by, one });
            }
        }
        let mut own = own.into_iter().flatten();
        match both {
            [Plan::Rim(..), _] => {
                let Some(solution) = own.find_map(|edge| settled(task, placed, edge)) else { continue };
                let rows = task.view.rows(pose::entries(&solution.q));
                let same = Plan::Again(V::branch(*posture, Bend::NoFlip));
                *both = [Plan::Try(rows, solution.margins, solution.free), same];
            }
            [Plan::Try(..), _] => {}
            [Plan::Again(_) | Plan::Empty(_), _] => continue,
        }
        own.for_each(|edge| keep(&mut nearest, edge));
    }
    nearest.map(|edge| {
        let edge = edge?;
        let solution = settled(task, edge.posture.of(placements).as_ref().ok()?, edge)?;
        Some(Beyond { solution, instead: edge.one })
    })
}

/// Keeps an edge among the nearest, in their order.
fn keep<T: Float>(nearest: &mut [Option<Edge<T>>], mut edge: Edge<T>) {
    for slot in nearest {
        match slot {
            Some(held) if math::abs(held.by) <= math::abs(edge.by) => {}
            Some(held) => core::mem::swap(held, &mut edge),
            None => {
                *slot = Some(edge);
                return;
            }
        }
    }
}

/// The row values with one joint moved on.
fn turned<T: Float>(mut rows: [T; 3], joint: usize, by: T) -> [T; 3] {
    if let Some(row) = rows.get_mut(joint) {
        *row = math::wrap(*row + by);
    }
    rows
}

/// How far a joint is from where values begin that the wrist takes, after others that it does not: on either side at most two.
fn edges<T: Float, V: View>(task: &Task<'_, T, V>, placed: &Placed<T>, joint: usize) -> [Option<T>; 4] {
    let nothing = [None; 4];
    let Some((from, [near, far])) = cosine(task, placed, joint) else { return nothing };
    let is_taken = |angle| (far..=near).contains(&from.at(angle));
    let mut all = nothing;
    for (pair, rim) in all.chunks_mut(2).zip([near, far]) {
        let wave = from.less(rim);
        if wave.crosses() {
            pair.iter_mut().zip([false, true]).for_each(|(edge, side)| *edge = Some(wave.zero(side)));
        }
    }
    all.map(|edge| {
        // Halfway from the edge before it, on the way from where the joint is.
        let edge = edge?;
        let on_the_way =
            |other: &T| (*other > T::lit(0.0)) == (edge > T::lit(0.0)) && math::abs(*other) < math::abs(edge);
        let before = all.iter().flatten().filter(|other| on_the_way(other));
        let before = before
            .fold(T::lit(0.0), |last, other| if math::abs(*other) > math::abs(last) { *other } else { last });
        (!is_taken((before + edge) * T::lit(0.5))).then_some(edge)
    })
}

/// The cosine of the angle between the outer axes of the wrist, by how far a joint of the base is from where it is placed, and the
/// values of it at the rims, the larger first; none for a wrist that takes any angle, and where it takes none of those that are
/// tried.
fn cosine<T: Float, V: View>(
    task: &Task<'_, T, V>,
    placed: &Placed<T>,
    joint: usize,
) -> Option<(Wave<T>, [T; 2])> {
    let (zero, one, view) = (T::lit(0.0), T::lit(1.0), task.view);
    let step = math::half_turn::<T>() * T::lit(2.0 / f64::from(TRIED));
    let (by, rows) = (0..TRIED).find_map(|turn| {
        let by = math::wrap(step * T::lit(f64::from(turn)));
        let rows = turned(placed.rows, joint, by);
        let Wrist::Two { noflip, .. } = task.wrist(rows) else { return None };
        Some((by, V::joined(rows, noflip)))
    })?;
    let q = given_out(view.command(rows), &V::Arm::JOINTS);
    let jacobian = view.arm().jacobian(&q);
    let axis = |base, sphere| {
        let [_, _, _, x, y, z] = motion(view, &jacobian, V::joined(base, sphere));
        [x, y, z]
    };
    let still = [zero; 3];
    let outer =
        [axis(still, [one, zero, zero]), axis(still, [zero, one, zero]), axis(still, [zero, zero, one])];
    let [first, middle, last] = outer;
    let (product, twists) = (
        pose::dot(&first, &middle) * pose::dot(&middle, &last),
        length(cross(first, middle)) * length(cross(middle, last)),
    );
    let rims = [product + twists, product - twists];
    let [near, far] = rims;
    let slack = T::lit(SLACK) * T::EPS;
    if near >= one - slack && far <= slack - one {
        return None;
    }
    // The joint turns the first axis, which the base carries, or the last one the other way, where the base is the tool's.
    let about = axis(turned(still, joint, one), still);
    let mean = pose::dot(&about, &first) * pose::dot(&about, &last);
    let (cosine, sine) = (pose::dot(&first, &last) - mean, pose::dot(&cross(about, first), &last));
    // Told from where the joint is, not from where it was tried.
    Some((Wave { mean, cosine, sine }.delayed(by), rims))
}

/// The solution at an edge.
fn settled<T: Float, V: View>(
    task: &Task<'_, T, V>,
    placed: &Placed<T>,
    Edge { posture, joint, by, .. }: Edge<T>,
) -> Option<Solution<T, 6, V::Branch>> {
    let base = turned(placed.rows, joint, by);
    let sphere = match task.wrist(base) {
        Wrist::Two { noflip, .. } => noflip,
        Wrist::OutOfReach { rim, .. } => rim,
        Wrist::Family(_) => return None,
    };
    let start = given_out(task.view.command(V::joined(base, sphere)), &V::Arm::JOINTS);
    let (q, residual) = settle(task.view.arm(), &task.target.pose, &start)?;
    (residual <= T::lit(SETTLED) * T::EPS).then(|| Solution {
        branch: V::branch(posture, Bend::Flip),
        q: given_out(pose::entries(&q), &V::Arm::JOINTS),
        residual,
        margins: V::margins(placed.shoulder, placed.elbow, T::lit(0.0)),
        free: Free::NOTHING,
    })
}
