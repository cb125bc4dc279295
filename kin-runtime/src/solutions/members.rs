//! The members of a family: which of them keep limits, and which is nearest.

use super::{Branch, Constraint, Family, Move, Ranges, Slot, Solution};
use crate::arm::{InverseKinematics, Joint, JointKind, PositionInverse};
use crate::limits::{Limits, Standing};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use nalgebra::Point3;

/// Values of a free joint that are looked at, where its family is no straight line; between two of them an edge is
/// found to the last bits, and what begins and ends between two of them is not seen.
const SAMPLES: u32 = 64;

/// Halvings of the way between two samples.
const HALVINGS: u32 = 48;

impl<T: Float, const N: usize, B: Branch> Family<'_, T, N, B> {
    /// The values of the free joint for which the member keeps the limits: `pose` is the one that the solution was found
    /// for. Of a solution with several families the other free joints keep their values.
    ///
    /// For a wrist, or a spherical shoulder, the ranges are exact: its joints move along a straight line. Other members
    /// are looked at one by one, 64 for each range of the free joint itself, and the edges between them found by
    /// halving: what is shorter than a 64th of that range may be missed, nothing that passes a limit at an edge is
    /// given out. Members count by their branch.
    pub fn ranges<A>(&self, arm: &A, pose: &Pose<T>, limits: &Limits<N>) -> Ranges<T>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.ranges_of(&A::JOINTS, limits, |value| self.member(arm, pose, value))
    }

    /// As [`ranges`](Family::ranges), for an arm that is solved from a position.
    pub fn ranges_at<A>(&self, arm: &A, point: &Point3<T>, limits: &Limits<N>) -> Ranges<T>
    where
        A: PositionInverse<N, Branch = B>,
    {
        self.ranges_of(&A::JOINTS, limits, |value| self.member_at(arm, point, value))
    }

    /// The member nearest to `q`: the one whose largest joint move is smallest, angles compared modulo 2π.
    ///
    /// For a wrist, or a spherical shoulder, this is exact. Else it is the best of 64 members and of what a search between
    /// the neighbours of the best finds.
    pub fn nearest<A>(&self, arm: &A, pose: &Pose<T>, q: &Joints<T, N>) -> Slot<T, N, B>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.nearest_of(&A::JOINTS, q, |value| self.member(arm, pose, value))
    }

    /// As [`nearest`](Family::nearest), for an arm that is solved from a position.
    pub fn nearest_at<A>(&self, arm: &A, point: &Point3<T>, q: &Joints<T, N>) -> Slot<T, N, B>
    where
        A: PositionInverse<N, Branch = B>,
    {
        self.nearest_of(&A::JOINTS, q, |value| self.member_at(arm, point, value))
    }

    /// How many units of each joint go with one of the free joint, if the family is a straight line of whole numbers.
    fn slopes(&self) -> Option<[T; N]> {
        let [line] = self.line()?.data.0;
        let unit = *line.get(self.free())?;
        matches!(unit, 1 | -1).then(|| line.map(|k| T::lit(f64::from(k) * f64::from(unit))))
    }

    pub(crate) fn ranges_of(
        &self,
        joints: &[Joint; N],
        limits: &Limits<N>,
        member: impl Fn(T) -> Slot<T, N, B>,
    ) -> Ranges<T> {
        match self.slopes() {
            Some(slopes) => self.straight_ranges(joints, limits, slopes),
            None => self.sampled_ranges(joints, limits, member),
        }
    }

    /// Each joint cuts arcs out of the circle of the free one.
    fn straight_ranges(&self, joints: &[Joint; N], limits: &Limits<N>, slopes: [T; N]) -> Ranges<T> {
        let q = pose::entries(&self.solution().q);
        let Some(now) = q.get(self.free()).copied() else { return Ranges::none() };
        let mut ranges = Ranges::all();
        for (joint, ((value, slope), about)) in q.into_iter().zip(slopes).zip(joints).enumerate() {
            if slope == T::lit(0.0) {
                if limits.standing(joint, about.kind, value) != Standing::Within {
                    return Ranges::none();
                }
                continue;
            }
            let Some((low, high)) = limits.range(joint) else { continue };
            let (low, high) = (T::lit(low), T::lit(high));
            if is_empty(low, high) {
                return Ranges::none();
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
        ranges
    }

    fn sampled_ranges(
        &self,
        joints: &[Joint; N],
        limits: &Limits<N>,
        member: impl Fn(T) -> Slot<T, N, B>,
    ) -> Ranges<T> {
        let inside = |value: T| member(value).solution().is_some_and(|s| keeps(s, joints, limits));
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
                (None, true) => start = Some(edge(value, before, &inside)),
                (Some(low), false) => {
                    ranges.push(low, edge(before, value, &inside));
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
        member: impl Fn(T) -> Slot<T, N, B>,
    ) -> Slot<T, N, B> {
        if let Some(slopes) = self.slopes() {
            return member(self.straight_nearest(q, slopes));
        }
        let cost = |value: T| match member(value) {
            Slot::Solved(s) => apart(&s.q, q, joints).largest,
            _ => T::lit(f64::INFINITY),
        };
        let step = T::TURN.0 / T::lit(f64::from(SAMPLES));
        let held = pose::entries(q).get(self.free()).copied().unwrap_or(T::lit(0.0));
        let mut best = (held, cost(held));
        for sample in 0..SAMPLES {
            let value = math::wrap(held + step * T::lit(f64::from(sample)));
            let off = cost(value);
            if off < best.1 {
                best = (value, off);
            }
        }
        let mut reach = step;
        for _ in 0..HALVINGS {
            for value in [best.0 - reach, best.0 + reach] {
                let off = cost(value);
                if off < best.1 {
                    best = (value, off);
                }
            }
            reach *= T::lit(0.5);
        }
        member(best.0)
    }

    /// The largest of some moves |x + slope·t| is least where one of them vanishes or two are equal.
    fn straight_nearest(&self, q: &Joints<T, N>, slopes: [T; N]) -> T {
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
        math::wrap(now + best.0)
    }
}

/// Whether a range holds nothing: reversed, or with an end that is not a number.
fn is_empty<T: Float>(low: T, high: T) -> bool {
    low > high || math::is_nan(low) || math::is_nan(high)
}

/// Whether a solution keeps the limits.
fn keeps<T: Float, const N: usize, B: Branch>(
    solution: &Solution<T, N, B>,
    joints: &[Joint; N],
    limits: &Limits<N>,
) -> bool {
    let values = pose::entries(&solution.q).into_iter().zip(joints).enumerate();
    let mut standings = values.map(|(joint, (value, about))| limits.standing(joint, about.kind, value));
    standings.all(|standing| standing == Standing::Within)
}

/// How far two joint vectors are apart, angles the short way round.
fn apart<T: Float, const N: usize>(a: &Joints<T, N>, b: &Joints<T, N>, joints: &[Joint; N]) -> Move<T> {
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
    /// By how much a joint vector misses the constraint; nothing for [`Constraint::Line`] and [`Constraint::Follow`],
    /// which say nothing of single values.
    pub fn missed_by(&self, q: &Joints<T, N>) -> T {
        let q = pose::entries(q);
        match self {
            Constraint::Sum { joints: [i, j], difference, equals } => match (q.get(*i), q.get(*j)) {
                (Some(a), Some(b)) => {
                    math::abs(math::wrap(if *difference { *a - *b } else { *a + *b } - *equals))
                }
                _ => T::lit(0.0),
            },
            Constraint::Line(_) | Constraint::Follow => T::lit(0.0),
        }
    }
}
