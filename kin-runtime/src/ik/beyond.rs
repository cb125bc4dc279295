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
use crate::pose::{self, Jacobian};
use crate::solutions::{ArmPosture, Bend, Branch, Near, Slot, Solution, Solutions};

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
    /// Whether that is so little that two ways of the wrist, which become one at an edge before this one, are as good as one.
    one: bool,
}

/// How loose a joint of a placement is.
#[derive(Clone, Copy, PartialEq)]
struct Loose<T> {
    /// By what angle it may be off with nothing to show for it.
    own: T,
    /// By what angle, if the joint before it is off too.
    carried: T,
}

/// How loose joints 1 and 2 of a placement are. Nothing where that is none.
fn loose<T: Float, V: View>(
    task: &Task<'_, T, V>,
    base: &Base<T>,
    placed: &Placed<T>,
    centre: [T; 3],
) -> [Option<Loose<T>>; 2] {
    let size = task.target.scale;
    let [first, second] = base.beside_axes(placed, centre, math::sqrt(T::EPS) * size);
    let own = |distance: Option<T>, is_free: bool| {
        distance.filter(|_| !is_free).map(|distance| T::lit(SETTLED) * T::EPS * size / distance)
    };
    let first = own(first, placed.shoulder_free).map(|own| Loose { own, carried: own });
    let second = own(second, placed.elbow_free).map(|own| {
        // What joint 1 is off by, up to the root of round-off where shoulders touch, puts the point off as joint 2 sees it.
        let apart = math::max(placed.shoulder, math::sqrt(T::EPS) * size);
        Loose { own, carried: own * (T::lit(1.0) + size / apart) }
    });
    [first, second]
}

/// The rims of the wrist, if there may be something beyond them: nearly all poses have no joint that is loose, and most wrists take any
/// angle.
pub(super) fn rims<T: Float, V: View>(
    task: &Task<'_, T, V>,
    base: &Base<T>,
    placements: &Placements<T>,
    plans: &[[Plan<T, V::Branch>; 2]; 4],
) -> Option<Rims<T>> {
    let centre = task.view.centre(&task.target.pose);
    let is_loose = |posture: &ArmPosture| {
        let placed = posture.of(placements).as_ref();
        placed.is_ok_and(|placed| loose(task, base, placed, centre) != [None; 2])
    };
    if ArmPosture::ALL.iter().any(is_loose) { Rims::of(task, plans) } else { None }
}

/// Where the figure says a value that the wrist does not take the slots of that placement take the nearest that it does.
#[inline(never)]
pub(super) fn replaced<T: Float, V: View>(
    task: &Task<'_, T, V>,
    (base, rims): (&Base<T>, &Rims<T>),
    placements: &Placements<T>,
    plans: &mut [[Plan<T, V::Branch>; 2]; 4],
) {
    for (posture, both) in ArmPosture::ALL.iter().zip(plans) {
        let (Ok(placed), [Plan::Rim(..), _]) = (posture.of(placements), *both) else { continue };
        let mut own = nearest(task, (base, rims), *posture, placed).into_iter().flatten();
        if let Some(solution) = own.find_map(|edge| settled(task, placed, edge)) {
            let rows = task.view.rows(pose::entries(&solution.q));
            let same = Plan::Again(V::branch(*posture, Bend::NoFlip));
            *both = [Plan::Try(rows, solution.margins, solution.free), same];
        }
    }
}

/// Adds what is beyond values that the wrist does not take, the nearest first: where there is no room, in the place of a solution that is
/// as good as one with another.
#[inline(never)]
pub(super) fn added<T: Float, V: View>(
    task: &Task<'_, T, V>,
    (base, rims): (&Base<T>, &Rims<T>),
    placements: &Placements<T>,
    plans: &[[Plan<T, V::Branch>; 2]; 4],
    solutions: &mut Solutions<T, 6, V::Branch>,
) {
    let mut all = [None; KEPT];
    for (posture, both) in ArmPosture::ALL.iter().zip(plans) {
        let (Ok(placed), [Plan::Try(..), second]) = (posture.of(placements), both) else { continue };
        let has_two = matches!(second, Plan::Try(..));
        for edge in nearest(task, (base, rims), *posture, placed).into_iter().flatten() {
            keep(&mut all, Edge { one: edge.one && has_two, ..edge });
        }
    }
    let near = Near::of(T::lit(SLACK) * math::sqrt(T::EPS), base.reach());
    for edge in all.into_iter().flatten() {
        let Ok(placed) = edge.posture.of(placements) else { continue };
        if let Some(solution) = settled(task, placed, edge)
            && !solutions.add(solution, near)
            && edge.one
        {
            solutions.put(solution.branch, Slot::Solved(solution));
        }
    }
}

/// The edges of one placement that its joints may be off by, in their order.
fn nearest<T: Float, V: View>(
    task: &Task<'_, T, V>,
    (base, rims): (&Base<T>, &Rims<T>),
    posture: ArmPosture,
    placed: &Placed<T>,
) -> [Option<Edge<T>>; KEPT] {
    let mut own = [None; KEPT];
    let centre = task.view.centre(&task.target.pose);
    for (joint, loose) in loose(task, base, placed, centre).into_iter().enumerate() {
        let Some(loose) = loose else { continue };
        let edges = edges(task, rims, placed, joint).into_iter().flatten();
        // Halfway between two shoulders that are all but one their place changes with the square of the turn only.
        let is_within = |by: &T| {
            let (sine, _) = math::sin_cos(*by * T::lit(0.5));
            T::lit(2.0) * sine * sine <= loose.carried
        };
        for by in edges.filter(is_within) {
            keep(&mut own, Edge { posture, joint, by, one: math::abs(by) <= T::lit(ONE) * loose.own });
        }
    }
    own
}

/// The cosines of the angles between the outer axes of an oblique wrist at the rims of its cone.
pub(super) struct Rims<T> {
    near: T,
    far: T,
}

impl<T: Float> Rims<T> {
    /// From the axes wherever they are; none for a wrist that takes any angle.
    fn of<V: View>(task: &Task<'_, T, V>, plans: &[[Plan<T, V::Branch>; 2]; 4]) -> Option<Self> {
        let rows = plans.iter().flatten().find_map(|plan| match plan {
            Plan::Try(rows, ..) | Plan::Rim(rows, ..) => Some(*rows),
            Plan::Again(_) | Plan::Empty(_) => None,
        })?;
        let [first, middle, last] = Axes::at(task, rows).wrist();
        let product = pose::dot(&first, &middle) * pose::dot(&middle, &last);
        let twists = length(cross(first, middle)) * length(cross(middle, last));
        let (near, far, slack) = (product + twists, product - twists, T::lit(SLACK) * T::EPS);
        (near < T::lit(1.0) - slack || far > slack - T::lit(1.0)).then_some(Rims { near, far })
    }
}

/// The axes that rows turn about, somewhere.
struct Axes<'a, T: Float, V> {
    view: &'a V,
    jacobian: Jacobian<T, 6>,
}

impl<'a, T: Float, V: View> Axes<'a, T, V> {
    /// Where the rows have these values.
    fn at(task: &Task<'a, T, V>, rows: [T; 6]) -> Self {
        let q = given_out(task.view.command(rows), &V::Arm::JOINTS);
        Axes { view: task.view, jacobian: task.view.arm().jacobian(&q) }
    }

    fn axis(&self, base: [T; 3], sphere: [T; 3]) -> [T; 3] {
        let [_, _, _, x, y, z] = motion(self.view, &self.jacobian, V::joined(base, sphere));
        [x, y, z]
    }

    /// Those of the wrist.
    fn wrist(&self) -> [[T; 3]; 3] {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|turn| self.axis([zero; 3], turn))
    }
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
fn edges<T: Float, V: View>(
    task: &Task<'_, T, V>,
    Rims { near, far }: &Rims<T>,
    placed: &Placed<T>,
    joint: usize,
) -> [Option<T>; 4] {
    let mut all = [None; 4];
    let Some(from) = cosine(task, placed, joint) else { return all };
    for (pair, rim) in all.chunks_mut(2).zip([near, far]) {
        let wave = from.less(*rim);
        if wave.crosses() {
            pair.iter_mut().zip([false, true]).for_each(|(edge, side)| *edge = Some(wave.zero(side)));
        }
    }
    all.map(|edge| {
        let edge = edge?;
        let ahead =
            |other: &T| (*other > T::lit(0.0)) == (edge > T::lit(0.0)) && math::abs(*other) < math::abs(edge);
        let farther = |a: T, b: &T| if math::abs(*b) > math::abs(a) { *b } else { a };
        // Halfway from the edge before it, or from where the joint is.
        let before = all.iter().flatten().filter(|other| ahead(other)).fold(T::lit(0.0), farther);
        let cosine = from.at((before + edge) * T::lit(0.5));
        (cosine > *near || cosine < *far).then_some(edge)
    })
}

/// The cosine of the angle between the outer axes of the wrist, by how far a joint of the base is from where it is placed; none where the
/// wrist takes none of the values that are tried.
fn cosine<T: Float, V: View>(task: &Task<'_, T, V>, placed: &Placed<T>, joint: usize) -> Option<Wave<T>> {
    let step = math::half_turn::<T>() * T::lit(2.0 / f64::from(TRIED));
    let (by, rows) = (0..TRIED).find_map(|turn| {
        let by = math::wrap(step * T::lit(f64::from(turn)));
        let rows = turned(placed.rows, joint, by);
        let Wrist::Two { noflip, .. } = task.wrist(rows) else { return None };
        Some((by, V::joined(rows, noflip)))
    })?;
    let axes = Axes::at(task, rows);
    let [first, _, last] = axes.wrist();
    let still = [T::lit(0.0); 3];
    // The joint turns the first axis, which the base carries, or the last one the other way, where the base is the tool's.
    let about = axes.axis(turned(still, joint, T::lit(1.0)), still);
    let mean = pose::dot(&about, &first) * pose::dot(&about, &last);
    let (cosine, sine) = (pose::dot(&first, &last) - mean, pose::dot(&cross(about, first), &last));
    // Told from where the joint is, not from where it was tried.
    Some(Wave { mean, cosine, sine }.delayed(by))
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
    let q = given_out(pose::entries(&q), &V::Arm::JOINTS);
    (residual <= T::lit(SETTLED) * T::EPS).then(|| {
        let (rows, sphere) = V::apart(task.view.rows(pose::entries(&q)));
        Solution {
            branch: V::branch(posture, Bend::Flip),
            q,
            residual,
            margins: V::margins(placed.shoulder, placed.elbow, T::lit(0.0)),
            free: task.free(&Placed { rows, ..*placed }, sphere, None),
        }
    })
}
