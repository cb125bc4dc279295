//! The choice of one solution: the one nearest to where the joints are, wound as they are.
//!
//! Each solution is wound as near to the joints as the limits let it; a coordinate that the pose leaves free keeps its
//! value. Where the limits forbid that, the members of the families are asked: [`Family::ranges`](crate::Family::ranges)
//! says how finely. Of what is left, that with the smallest largest joint move is nearest, among equals that with the
//! smallest sum of moves. Moves of a slide are divided by the arm's reach, so that mm and m choose alike.
//!
//! Beside another singular set the rounding of its figure may bend a straight wrist by more than round-off: it is then an
//! isolated solution, chosen as such. A [`track`](crate::track) knows where the joints were heading and settles there.

use crate::arm::Joint;
use crate::limits::Limits;
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use crate::solutions::{Branch, JointSet, Move, Reason, Slot, Solution, Solutions, Winding};

/// How an arm's joint moves are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Metric<T> {
    sliding: JointSet,
    reach: T,
}

impl<T: Float> Metric<T> {
    pub(crate) fn new<const N: usize>(joints: &[Joint; N], reach: f64) -> Self {
        Self { sliding: crate::ik::sliding(joints), reach: T::lit(reach) }
    }

    /// The size of one joint's way.
    pub(crate) fn weigh(&self, joint: usize, way: T) -> T {
        if self.sliding.contains(joint) { way / self.reach } else { way }
    }

    /// The size of the way that joints go, the joint that goes farthest counting.
    pub(crate) fn size<const N: usize>(&self, way: &Joints<T, N>) -> T {
        let ways = pose::entries(way).into_iter().enumerate();
        ways.fold(T::lit(0.0), |most, (joint, way)| math::max(most, math::abs(self.weigh(joint, way))))
    }

    pub(crate) fn between<const N: usize>(&self, from: &Joints<T, N>, to: &Joints<T, N>) -> Move<T> {
        Move::between(from, to, |joint, way| self.weigh(joint, way))
    }
}

/// An arm and a pose, as a question: all solutions, free coordinates as in the joint vector.
pub(crate) trait Holding<T: Float, const N: usize, B: Branch>:
    Fn(&Joints<T, N>) -> Solutions<T, N, B>
{
}
impl<T: Float, const N: usize, B: Branch, F: Fn(&Joints<T, N>) -> Solutions<T, N, B>> Holding<T, N, B> for F {}

/// What each branch offers: nothing if it is merged with another.
pub(crate) type Offers<T, const N: usize, B> =
    <B as Branch>::Slots<Option<Result<Winding<T, N, B>, Reason<T>>>>;

/// What each branch offers within the limits to an arm that stands at `q`. Free coordinates are those of `hold`.
pub(crate) fn offers<T: Float, const N: usize, B: Branch>(
    solve: &impl Holding<T, N, B>,
    joints: &[Joint; N],
    (q, hold): (&Joints<T, N>, &Joints<T, N>),
    limits: &Limits<N>,
) -> Offers<T, N, B> {
    let solutions = solve(hold);
    B::slots(|branch| match solutions.get(branch) {
        Slot::Merged { .. } => None,
        Slot::Empty(reason) => Some(Err(*reason)),
        Slot::Solved(solution) => Some(solutions.wound(solution, q, limits).or_else(|reason| {
            let member = member_inside(solve, joints, solution, q, limits).ok_or(reason)?;
            solutions.wound(&member, q, limits)
        })),
    })
}

/// A member of the solution's families that keeps the limits: that whose free joint is nearest to its value in `q`,
/// looked for in the straight families first.
fn member_inside<T: Float, const N: usize, B: Branch>(
    solve: &impl Holding<T, N, B>,
    joints: &[Joint; N],
    solution: &Solution<T, N, B>,
    q: &Joints<T, N>,
    limits: &Limits<N>,
) -> Option<Solution<T, N, B>> {
    let straight = |family: &crate::Family<'_, T, N, B>| family.line().is_some();
    let families = || solution.families();
    for family in families().filter(straight).chain(families().filter(|family| !straight(family))) {
        let solve = |hold: &Joints<T, N>| family.resolved(&solve(hold));
        let wished = pose::entries(q).get(family.free()).copied();
        let value = wished.and_then(|wished| family.ranges_of((joints, limits), &solve).nearest(wished));
        let found = value.and_then(|value| family.kept((joints, limits), &solve, (value, q)));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// The nearest of all offers: see [`InverseKinematics::ik_near_within`](crate::InverseKinematics::ik_near_within).
pub(crate) fn nearest<T: Float, const N: usize, B: Branch>(
    solve: &impl Holding<T, N, B>,
    joints: &[Joint; N],
    reach: f64,
    q: &Joints<T, N>,
    limits: &Limits<N>,
) -> Result<Winding<T, N, B>, Reason<T>> {
    if !pose::entries(q).iter().all(|value| math::is_finite(*value)) {
        return Err(Reason::NotFinite);
    }
    let (metric, offers) = (Metric::new(joints, reach), offers(solve, joints, (q, q), limits));
    let mut best: Option<(Winding<T, N, B>, Move<T>)> = None;
    for winding in offers.as_ref().iter().flatten().flatten() {
        let step = metric.between(q, &winding.q);
        if best.as_ref().is_none_or(|(_, least)| step.is_smaller_than(least)) {
            best = Some((*winding, step));
        }
    }
    best.map(|(winding, _)| winding).ok_or_else(|| refusal::<T, N, B>(&offers))
}

/// Of the reasons of all branches the one that is nearest to being met: a limit, then a distance, then any other.
pub(crate) fn refusal<T: Float, const N: usize, B: Branch>(offers: &Offers<T, N, B>) -> Reason<T> {
    let rank = |reason: &Reason<T>| match reason {
        Reason::Limit { by, .. } => (0, *by),
        Reason::OutOfReach { by, .. } => (1, *by),
        Reason::Orientation { by } => (2, *by),
        _ => (3, T::lit(0.0)),
    };
    let mut best: Option<Reason<T>> = None;
    for reason in offers.as_ref().iter().flatten().filter_map(|offer| offer.as_ref().err()) {
        let nearer = |least: Reason<T>| {
            let ((kind, by), (least_kind, least_by)) = (rank(reason), rank(&least));
            kind < least_kind || (kind == least_kind && by < least_by)
        };
        if best.is_none_or(nearer) {
            best = Some(*reason);
        }
    }
    best.unwrap_or(Reason::NotFinite)
}
