//! The members of a family: which of them keep limits, and which is nearest.

use super::{Branch, Constraint, Family, Move, Ranges, Slot, Solution};
use crate::arm::{InverseKinematics, Joint, JointKind, PositionInverse};
use crate::limits::{Limits, Standing};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use nalgebra::Point3;

/// Values of a free joint that are looked at, where its family is no straight line; between two of them an edge is
/// found to the last bits, and what begins and ends between two of them is not seen.
pub(super) const SAMPLES: u32 = 64;

/// The same of each, where two joints are free.
const PAIRED: u32 = 32;

/// Steps of the search from the best of them.
const SEARCHED: u32 = 512;

/// Each in another direction: the golden angle further, so that no valley is missed for long.
const GOLDEN: f64 = 2.399_963_229_728_653;

/// What is left of a step that has come no nearer.
const SHORTER: f64 = 0.97;

/// Halvings of the way between two samples.
pub(super) const HALVINGS: u32 = 48;

impl<T: Float, const N: usize, B: Branch> Family<'_, T, N, B> {
    /// The values of the free joint for which a member keeps the limits: `pose` is the one that the solution was found for.
    ///
    /// For a wrist, or a spherical shoulder, the ranges are exact: its joints move along a straight line. Other members
    /// are looked at one by one, 64 for each range of the free joint itself, and the edges between them found by
    /// halving: what is shorter than a 64th of that range may be missed, nothing that passes a limit at an edge is
    /// given out. Members count by their branch.
    ///
    /// Where such a family meets a straight one ([`crossings`](Family::crossings)), a value counts if any of the members there keeps
    /// the limits, so that a range may be a single value; [`member_within`](Family::member_within) gives that member. A further
    /// joint of the base that is free keeps its value, or takes the nearest to it in its own range.
    pub fn ranges<A>(&self, arm: &A, pose: &Pose<T>, limits: &Limits<N>) -> Ranges<T>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.ranges_of((&A::JOINTS, limits), &|hold| self.resolved(&arm.ik_holding(pose, hold)))
    }

    /// As [`ranges`](Family::ranges), for an arm that is solved from a position.
    pub fn ranges_at<A>(&self, arm: &A, point: &Point3<T>, limits: &Limits<N>) -> Ranges<T>
    where
        A: PositionInverse<N, Branch = B>,
    {
        self.ranges_of((&A::JOINTS, limits), &|hold| self.resolved(&arm.ik_position_holding(point, hold)))
    }

    /// The member whose free joint has the given value, if one with it keeps the limits: `value` is out of
    /// [`ranges`](Family::ranges). Where a straight family begins at that value, it is the one of its members whose free joint moves
    /// least from where the solution has it.
    pub fn member_within<A>(
        &self,
        arm: &A,
        pose: &Pose<T>,
        value: T,
        limits: &Limits<N>,
    ) -> Option<Solution<T, N, B>>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        let solve = |hold: &Joints<T, N>| self.resolved(&arm.ik_holding(pose, hold));
        self.kept((&A::JOINTS, limits), &solve, (value, &self.solution().q))
    }

    /// The member nearest to `q`: the one whose largest joint move is smallest, angles compared modulo 2π and slides in the arm's unit
    /// against radians. Where the family meets a straight one, the members of that are among them. Limits are not asked.
    ///
    /// For a wrist, or a spherical shoulder, this is exact. Else it is the best of 64 members and of what a search between
    /// the neighbours of the best finds; where a further joint of the base is free, of 32 times 32, both joints moving.
    pub fn nearest<A>(&self, arm: &A, pose: &Pose<T>, q: &Joints<T, N>) -> Slot<T, N, B>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.nearest_of(&A::JOINTS, q, &|hold| self.resolved(&arm.ik_holding(pose, hold)))
    }

    /// As [`nearest`](Family::nearest), for an arm that is solved from a position.
    pub fn nearest_at<A>(&self, arm: &A, point: &Point3<T>, q: &Joints<T, N>) -> Slot<T, N, B>
    where
        A: PositionInverse<N, Branch = B>,
    {
        self.nearest_of(&A::JOINTS, q, &|hold| self.resolved(&arm.ik_position_holding(point, hold)))
    }

    /// How many units of each joint go with one of the free joint, if the family is a straight line of whole numbers.
    fn slopes(&self) -> Option<[T; N]> {
        let [line] = self.line()?.data.0;
        let unit = *line.get(self.free())?;
        matches!(unit, 1 | -1).then(|| line.map(|k| T::lit(f64::from(k) * f64::from(unit))))
    }

    pub(crate) fn ranges_of(
        &self,
        within: (&[Joint; N], &Limits<N>),
        solve: &impl Fn(&Joints<T, N>) -> Slot<T, N, B>,
    ) -> Ranges<T> {
        let (joints, limits) = within;
        if let Some(ranges) = self.straight_ranges(joints, limits) {
            return ranges;
        }
        let keeps_with = |line: Family<'_, T, N, B>| {
            line.straight_ranges(joints, limits).is_some_and(|ranges| !ranges.is_empty())
        };
        let inside = |value: T| {
            let Slot::Solved(member) = solve(&self.hold_within(value, limits)) else { return false };
            member.keeps(joints, limits) || member.lines().any(keeps_with)
        };
        let mut ranges = self.sampled_ranges(limits, &inside);
        for (value, end) in self.crossings_of(solve).iter() {
            if value == end && !ranges.contains(value) && inside(value) {
                ranges.push(value, value);
            }
        }
        ranges
    }

    /// Each joint cuts arcs out of the circle of the free one.
    pub(super) fn straight_ranges(&self, joints: &[Joint; N], limits: &Limits<N>) -> Option<Ranges<T>> {
        let (slopes, q) = (self.slopes()?, pose::entries(&self.solution().q));
        let now = q.get(self.free()).copied()?;
        let mut ranges = Ranges::all();
        for (joint, ((value, slope), about)) in q.into_iter().zip(slopes).zip(joints).enumerate() {
            if slope == T::lit(0.0) {
                if limits.standing(joint, about.kind, value) != Standing::Within {
                    return Some(Ranges::none());
                }
                continue;
            }
            let Some((low, high)) = limits.range(joint) else { continue };
            let (low, high) = (T::lit(low), T::lit(high));
            if is_empty(low, high) {
                return Some(Ranges::none());
            }
            if high - low >= T::TURN.0 {
                continue;
            }
            let (mut arcs, mut turn) = (Ranges::none(), T::lit(0.0));
            while turn < math::abs(slope) {
                let end = |end: T| now + ((end - value) + turn * T::TURN.0) / slope;
                arcs.push(math::min(end(low), end(high)), math::max(end(low), end(high)));
                turn += T::lit(1.0);
            }
            ranges = ranges.and(&arcs);
        }
        Some(ranges)
    }

    fn sampled_ranges(&self, limits: &Limits<N>, inside: &impl Fn(T) -> bool) -> Ranges<T> {
        let half = math::half_turn::<T>();
        let own = match limits.range(self.free()) {
            Some((low, high)) if is_empty(low, high) => return Ranges::none(),
            Some((low, high)) if T::lit(high - low) < T::TURN.0 => (T::lit(low), T::lit(high)),
            _ => (-half, half),
        };
        let step = (own.1 - own.0) / T::lit(f64::from(SAMPLES));
        let mut ranges = Ranges::none();
        let (mut before, mut start) = (own.0, inside(own.0).then_some(own.0));
        for sample in 1..=SAMPLES {
            let value = if sample == SAMPLES { own.1 } else { own.0 + step * T::lit(f64::from(sample)) };
            match (start, inside(value)) {
                (None, true) => start = Some(edge(value, before, inside)),
                (Some(low), false) => {
                    ranges.push(low, edge(before, value, inside));
                    start = None;
                }
                _ => {}
            }
            before = value;
        }
        if let Some(low) = start {
            ranges.push(low, own.1);
        }
        ranges
    }

    fn nearest_of(
        &self,
        joints: &[Joint; N],
        q: &Joints<T, N>,
        solve: &impl Fn(&Joints<T, N>) -> Slot<T, N, B>,
    ) -> Slot<T, N, B> {
        if let Some(value) = self.straight_nearest(q) {
            return solve(&self.hold(value));
        }
        let (at, companion) = (pose::entries(q), self.companion());
        let start = [Some(self.free()), companion].map(|joint| at.get(joint?).copied());
        let [first, second] = start.map(|value| value.unwrap_or(T::lit(0.0)));
        let with = |[value, other]: [T; 2]| {
            let mut hold = pose::entries(&self.hold(value));
            if let Some(joint) = companion.and_then(|joint| hold.get_mut(joint)) {
                *joint = other;
            }
            ([value, other], self.nearest_with(joints, solve, (pose::column(hold), q)))
        };
        let nearer = |best: ([T; 2], (T, Joints<T, N>)), values: [T; 2]| {
            let other = with(values);
            if other.1.0 < best.1.0 { other } else { best }
        };
        let mut best = with([first, second]);
        let (samples, others) = if companion.is_some() { (PAIRED, PAIRED) } else { (SAMPLES, 1) };
        let mut step = T::TURN.0 / T::lit(f64::from(samples));
        let on = |value: T, count: u32| math::wrap(value + step * T::lit(f64::from(count)));
        for other in 0..others {
            for sample in 0..samples {
                best = nearer(best, [on(first, sample), on(second, other)]);
            }
        }
        if companion.is_some() {
            for count in 0..SEARCHED {
                let ([value, other], (off, _)) = best;
                let (y, x) = math::sin_cos(T::lit(GOLDEN * f64::from(count)));
                best = nearer(best, [value + x * step, other + y * step]);
                step *= T::lit(if best.1.0 < off { 1.0 } else { SHORTER });
            }
        } else {
            for _ in 0..HALVINGS {
                let [value, other] = best.0;
                best = nearer(nearer(best, [value - step, other]), [value + step, other]);
                step *= T::lit(0.5);
            }
        }
        for (value, end) in self.crossings_of(solve).iter() {
            if value == end {
                best = nearer(best, [value, second]);
            }
        }
        let (_, (_, hold)) = best;
        solve(&hold)
    }

    /// The largest of some moves |x + slope·t| is least where one of them vanishes or two are equal.
    pub(super) fn straight_nearest(&self, q: &Joints<T, N>) -> Option<T> {
        let slopes = self.slopes()?;
        let own = pose::entries(&self.solution().q);
        let now = own.get(self.free()).copied().unwrap_or(T::lit(0.0));
        let ways = || own.iter().zip(pose::entries(q)).map(|(a, b)| math::wrap(*a - b)).zip(slopes);
        let cost = |t: T| {
            let mut step = Move { largest: T::lit(0.0), sum: T::lit(0.0) };
            for (way, slope) in ways().filter(|(_, slope)| *slope != T::lit(0.0)) {
                let way = math::abs(math::wrap(way + slope * t));
                step.largest = math::max(step.largest, way);
                step.sum += way;
            }
            step
        };
        let mut best = (T::lit(0.0), cost(T::lit(0.0)));
        for (i, (a, k)) in ways().enumerate() {
            for (b, l) in ways().skip(i) {
                // a + k t = ±(b + l t), but for whole turns; for one and the same joint, a + k t = 0.
                for (rest, rate) in [(b - a, k - l), (-a - b, k + l)] {
                    let mut turn = T::lit(0.0);
                    while turn < math::abs(rate) {
                        let t = (rest + turn * T::TURN.0) / rate;
                        let step = cost(t);
                        if step.is_smaller_than(&best.1) {
                            best = (t, step);
                        }
                        turn += T::lit(1.0);
                    }
                }
            }
        }
        Some(math::wrap(now + best.0))
    }
}

/// Whether a range holds nothing: reversed, or with an end that is not a number.
fn is_empty<T: Float>(low: T, high: T) -> bool {
    low > high || math::is_nan(low) || math::is_nan(high)
}

impl<T: Float, const N: usize, B: Branch> Solution<T, N, B> {
    /// Whether all joints keep the limits.
    pub(super) fn keeps(&self, joints: &[Joint; N], limits: &Limits<N>) -> bool {
        let values = pose::entries(&self.q).into_iter().zip(joints).enumerate();
        let mut standings = values.map(|(joint, (value, about))| limits.standing(joint, about.kind, value));
        standings.all(|standing| standing == Standing::Within)
    }
}

/// How far two joint vectors are apart, angles the short way round.
pub(super) fn apart<T: Float, const N: usize>(
    a: &Joints<T, N>,
    b: &Joints<T, N>,
    joints: &[Joint; N],
) -> Move<T> {
    Move::between(a, b, |joint, way| match joints.get(joint) {
        Some(Joint { kind: JointKind::Revolute, .. }) => math::wrap(way),
        _ => way,
    })
}

/// The last value on the way from one that is inside to one that is not.
fn edge<T: Float>(mut inside: T, mut outside: T, is_inside: &impl Fn(T) -> bool) -> T {
    for _ in 0..HALVINGS {
        let middle = (inside + outside) * T::lit(0.5);
        if is_inside(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}

impl<T: Float, const N: usize> Constraint<T, N> {
    /// By how much a joint vector misses the constraint, an angle in [0, π]. `None` for [`Constraint::Line`] and
    /// [`Constraint::Follow`], which say nothing of single values: whether joints are a member of such a family, forward
    /// kinematics tells.
    pub fn missed_by(&self, q: &Joints<T, N>) -> Option<T> {
        let Constraint::Sum { joints: [i, j], difference, equals } = self else { return None };
        let q = pose::entries(q);
        let (a, b) = (*q.get(*i)?, *q.get(*j)?);
        Some(math::abs(math::wrap(if *difference { a - b } else { a + b } - *equals)))
    }
}
