//! Where families meet: members of one at which another begins.
//!
//! While a joint of the base is free, the tool keeps its place and the wrist turns along; at single values of that joint it is
//! straight as a rule, and its outer joints are free there too. A sample never falls on such a value. The bend does tell that it
//! is near, since it goes down to nothing on either side: what is sampled is the bend, and its lowest values are followed.
//! (Of an arm whose first three axes meet, the same of its shoulder.)

use super::members::{HALVINGS, SAMPLES, apart};
use super::{Branch, Family, Ranges, Slot, Solution};
use crate::arm::{InverseKinematics, Joint};
use crate::limits::Limits;
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};

/// How far the end of a range may be from the limit that makes it, in units of ε.
const ROUNDED: f64 = 8.0;

impl<T: Float, const N: usize, B: Branch> Family<'_, T, N, B> {
    /// The values of the free joint whose members belong to a straight family too, of the wrist or of a spherical shoulder: `pose` is
    /// the one that the solution was found for. Of a family that is straight itself there are none.
    ///
    /// They are single values as a rule, at most two of them, or the whole circle, where the arm stands so that all members
    /// do. [`member`](Family::member) there has both families; no other member has those joint values.
    pub fn crossings<A>(&self, arm: &A, pose: &Pose<T>) -> Ranges<T>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.crossings_of(&|hold| self.resolved(&arm.ik_holding(pose, hold)))
    }

    pub(super) fn crossings_of(&self, solve: &impl Fn(&Joints<T, N>) -> Slot<T, N, B>) -> Ranges<T> {
        let (zero, nothing) = (T::lit(0.0), T::lit(f64::INFINITY));
        if self.line().is_some() || self.solution().bend().is_none() {
            return Ranges::none();
        }
        let bend = |value: T| match solve(&self.hold(value)) {
            Slot::Solved(member) if member.lines().next().is_some() => zero,
            Slot::Solved(member) => member.bend().unwrap_or(nothing),
            Slot::Merged { .. } | Slot::Empty(_) => nothing,
        };
        let step = T::TURN.0 / T::lit(f64::from(SAMPLES));
        let start = pose::entries(&self.solution().q).get(self.free()).copied().unwrap_or(zero);
        let at = |sample: u32| math::wrap(start + step * T::lit(f64::from(sample)));
        let (mut before, mut here) = (bend(at(SAMPLES - 1)), bend(start));
        let (mut ranges, mut straight) = (Ranges::none(), 0);
        for sample in 0..SAMPLES {
            let after = bend(at(sample + 1));
            straight += u32::from(here == zero);
            if here < nothing && here <= before && here <= after {
                let (value, least) = lowest((at(sample), here), step, &bend);
                if least == zero && !ranges.contains(value) {
                    ranges.push(value, value);
                }
            }
            (before, here) = (here, after);
        }
        if straight == SAMPLES { Ranges::all() } else { ranges }
    }

    /// A member whose free joint has this value and that keeps the limits; of a straight family that begins there, the one whose free
    /// joint is nearest to its value in `q`.
    pub(crate) fn kept(
        &self,
        (joints, limits): (&[Joint; N], &Limits<N>),
        solve: &impl Fn(&Joints<T, N>) -> Slot<T, N, B>,
        (value, q): (T, &Joints<T, N>),
    ) -> Option<Solution<T, N, B>> {
        // The ends of ranges are rounded, to one side of the limit or the other; beside an elbow that is stretched by more.
        let (least, most) = (T::lit(ROUNDED) * T::EPS, math::sqrt(T::EPS));
        let about = |value: T| [T::lit(0.0), least, -least, most, -most].map(|by| value + by);
        let within = |hold: Joints<T, N>| match solve(&hold) {
            Slot::Solved(found) if found.keeps(joints, limits) => Some(found),
            _ => None,
        };
        let own = about(value).into_iter().find_map(|value| within(self.hold_within(value, limits)));
        own.or_else(|| {
            let Slot::Solved(member) = solve(&self.hold_within(value, limits)) else { return None };
            member.lines().find_map(|line| {
                let wished = *pose::entries(q).get(line.free())?;
                let there = line.straight_ranges(joints, limits)?.nearest(wished)?;
                about(there).into_iter().find_map(|there| within(self.also(line.hold(there), value)))
            })
        })
    }

    /// How far the nearest of the members that these joint values lead to is from `q`, and what to hold on to for it.
    pub(super) fn nearest_with(
        &self,
        joints: &[Joint; N],
        solve: &impl Fn(&Joints<T, N>) -> Slot<T, N, B>,
        (hold, q): (Joints<T, N>, &Joints<T, N>),
    ) -> (T, Joints<T, N>) {
        let Slot::Solved(member) = solve(&hold) else { return (T::lit(f64::INFINITY), hold) };
        let mut best = (apart(&member.q, q, joints).largest, hold);
        let value = pose::entries(&hold).get(self.free()).copied();
        for line in member.lines() {
            let (Some(there), Some(value)) = (line.straight_nearest(q), value) else { continue };
            let other = self.also(line.hold(there), value);
            let off = apart(&other, q, joints).largest;
            if off < best.0 {
                best = (off, other);
            }
        }
        best
    }

    /// Another joint that the solution leaves free and that moves on no straight line.
    pub(super) fn companion(&self) -> Option<usize> {
        let mut others = self.solution().families().filter(|family| family.line().is_none());
        others.find(|family| family.free() != self.free()).map(|family| family.free())
    }

    /// The joint vector to hold on to so that the free joint takes a value and its companion keeps its own range.
    pub(super) fn hold_within(&self, value: T, limits: &Limits<N>) -> Joints<T, N> {
        let mut hold = pose::entries(&self.hold(value));
        if let Some(companion) = self.companion()
            && let Some((low, high)) = limits.range(companion)
            && low <= high
            && let Some(joint) = hold.get_mut(companion)
        {
            *joint = Ranges::one(T::lit(low), T::lit(high)).nearest(*joint).unwrap_or(*joint);
        }
        pose::column(hold)
    }

    /// Joint values to hold on to, and the value of the free joint that a member was found with, to the last bit.
    fn also(&self, hold: Joints<T, N>, value: T) -> Joints<T, N> {
        let mut hold = pose::entries(&hold);
        if let Some(joint) = hold.get_mut(self.free()) {
            *joint = value;
        }
        pose::column(hold)
    }
}

/// The value near a first one at which a figure is lowest, if it rises to both sides, and how low it is there.
fn lowest<T: Float>((mut value, mut least): (T, T), mut step: T, figure: &impl Fn(T) -> T) -> (T, T) {
    for _ in 0..HALVINGS {
        if least == T::lit(0.0) {
            break;
        }
        for other in [value - step, value + step] {
            let there = figure(other);
            if there < least {
                (value, least) = (other, there);
            }
        }
        step *= T::lit(0.5);
    }
    (math::wrap(value), least)
}

impl<T: Float, const N: usize, B: Branch> Solution<T, N, B> {
    /// The straight ones among its families.
    pub(crate) fn lines(&self) -> impl Iterator<Item = Family<'_, T, N, B>> {
        self.families().filter(|family| family.line().is_some())
    }

    /// How far the three axes that meet are from lying in one plane.
    fn bend(&self) -> Option<T> {
        if B::MIRRORED { Some(self.margins.shoulder) } else { self.margins.wrist }
    }
}
