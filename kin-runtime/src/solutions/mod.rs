//! What inverse kinematics gives back: one slot for each branch, solved, merged, or empty with its reason.
//!
//! No slot is ever silently empty and no number ever stands for "none". The order of the slots never changes, so
//! that a branch can be followed from pose to pose.

mod branch;
mod crossings;
mod display;
mod family;
mod members;
mod mirrored;
mod ranges;
mod reason;
#[cfg(feature = "serde")]
mod stored;
#[cfg(test)]
mod tests;
mod windings;

pub use branch::{ArmPosture, Bend, Branch, Elbow, Posture, Shoulder};
pub use family::{Constraint, Family, Singularity};
pub(crate) use family::{Free, Loose};
pub use mirrored::{Hand, ShoulderPosture};
pub use ranges::Ranges;
pub use reason::{Boundary, Reason};
pub use windings::{Winding, Windings};

use crate::arm::JointKind;
use crate::limits::Limits;
use crate::math::{self, Float};
use crate::pose::Joints;
use core::{fmt, iter, slice};

/// Joint values that bring the tool to the pose: checked by forward kinematics.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize, B: serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>, B: serde::Deserialize<'de>"
    ))
)]
pub struct Solution<T, const N: usize, B> {
    /// The branch it belongs to.
    pub branch: B,
    /// The joint values: what the caller commands, angles in (-π, π].
    pub q: Joints<T, N>,
    /// How far forward kinematics of `q` misses the pose: the largest entry of the position error divided by the
    /// arm's reach (or by the pose's own distance, if that is larger), or of the rotation error.
    pub residual: T,
    /// How far it is from each kind of singular pose.
    pub margins: Margins<T>,
    pub(crate) free: Free<N>,
}

/// How far a solution is from each kind of singular pose, in the arm's own terms. The Jacobian of six joints, or of a tool point
/// that three joints carry, loses a rank where, and only where, one of them is zero; of shorter arms what the joints do to the
/// point that they carry.
///
/// With a spherical shoulder they are those of the arm seen from its tool: `shoulder` is the angle of the shoulder's bend from
/// where its three axes lie in one plane, and `wrist` the distance, a length, of the shoulder's centre from the plane through
/// axis 6 in which both hands are one. Of two joints that carry a point `shoulder` is the point's distance from axis 1 (the reach
/// where joint 1 slides), `elbow` the angle between the two motions.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Margins<T> {
    /// The distance, a length, of the wrist centre from the plane through axis 1 in which both shoulders are one. On a
    /// [general base](crate::ik::general): its distance from axis 1 seen along the motion of joint 2; where joint 1 slides, the sine
    /// of the angle between the two motions times the reach (or times the pose's own distance, if that is larger).
    pub shoulder: T,
    /// The angle of the elbow from stretched or folded, whichever is nearer; a length, the extension, for a slide.
    /// On a [general base](crate::ik::general): the angle between joint 3's motion and the plane of the other two, or the distance of
    /// the wrist centre from axis 2 in reaches, whichever is less: on that axis joint 2 is free.
    pub elbow: T,
    /// The angle of the wrist's bend from where its three axes lie in one plane; `None` for an arm without a wrist.
    pub wrist: Option<T>,
}

/// What became of one branch.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize, B: serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>, B: serde::Deserialize<'de>"
    ))
)]
pub enum Slot<T, const N: usize, B> {
    /// It has a solution of its own.
    Solved(Solution<T, N, B>),
    /// Its solution is the one that another slot holds: two branches meet here.
    Merged {
        /// The branch that holds the solution.
        with: B,
    },
    /// It has none, and this is why.
    Empty(Reason<T>),
}

/// All solutions of one pose: a fixed slot for each branch, in the order of [`Branch::ALL`].
pub struct Solutions<T, const N: usize, B: Branch> {
    slots: B::Slots<Slot<T, N, B>>,
    /// Joints whose values are lengths: not to be compared modulo a turn.
    sliding: JointSet,
}

/// A set of joints, counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointSet(u32);

impl JointSet {
    /// The set without joints.
    pub const EMPTY: Self = Self(0);

    /// With one joint more; joints from the 33rd on are not kept.
    #[must_use]
    pub const fn with(self, joint: usize) -> Self {
        if joint < 32 { Self(self.0 | 1 << joint) } else { self }
    }

    /// Whether the joint belongs to it.
    pub const fn contains(self, joint: usize) -> bool {
        joint < 32 && self.0 >> joint & 1 == 1
    }

    /// How many joints it has.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Whether it has none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Its joints, in order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..32).filter(move |&joint| self.contains(joint))
    }
}

impl<T: Float, const N: usize, B: Branch> Solutions<T, N, B> {
    /// Every slot empty for the same reason.
    pub(crate) fn none(sliding: JointSet, reason: Reason<T>) -> Self {
        Self { slots: B::slots(|_| Slot::Empty(reason)), sliding }
    }

    /// What became of each branch.
    pub(crate) fn new(sliding: JointSet, make: impl FnMut(B) -> Slot<T, N, B>) -> Self {
        Self { slots: B::slots(make), sliding }
    }

    /// Puts what became of each branch into its slot, one after the other: of a value that is made as a whole a compiler holds
    /// everything before it writes the first number.
    #[inline(always)]
    pub(crate) fn fill(&mut self, make: impl Fn(B) -> Slot<T, N, B>) {
        B::slots(
            #[inline(always)]
            |branch| self.put(branch, make(branch)),
        );
    }

    /// A slot that is merged with an empty one has that one's reason, one that is merged with a merged one goes with it.
    pub(crate) fn settle_mergers(&mut self) {
        for branch in B::ALL {
            if let Slot::Merged { with } = *self.get(*branch) {
                let holder = if let Slot::Merged { with } = *self.get(with) { with } else { with };
                let slot = match *self.get(holder) {
                    Slot::Empty(reason) => Slot::Empty(reason),
                    _ => Slot::Merged { with: holder },
                };
                self.put(*branch, slot);
            }
        }
    }

    /// Puts what became of one branch into its slot.
    #[inline(always)]
    pub(crate) fn put(&mut self, branch: B, slot: Slot<T, N, B>) {
        *branch.of_mut(&mut self.slots) = slot;
    }

    /// The solutions proper: solved slots, in the order of the branches.
    pub fn iter(&self) -> impl Iterator<Item = &Solution<T, N, B>> {
        self.slots().iter().filter_map(Slot::solution)
    }

    /// What became of a branch.
    pub fn get(&self, branch: B) -> &Slot<T, N, B> {
        branch.of(&self.slots)
    }

    /// The solution of a branch, its own or the one it is merged with.
    pub fn solution(&self, branch: B) -> Option<&Solution<T, N, B>> {
        match self.get(branch) {
            Slot::Merged { with } => self.get(*with).solution(),
            slot => slot.solution(),
        }
    }

    /// All slots, in the order of [`Branch::ALL`].
    pub fn slots(&self) -> &[Slot<T, N, B>] {
        self.slots.as_ref()
    }

    /// The branches and what became of them.
    pub fn branches(&self) -> impl Iterator<Item = (B, &Slot<T, N, B>)> {
        B::ALL.iter().copied().zip(self.slots())
    }

    /// How many solutions there are; a family counts once.
    pub fn len(&self) -> usize {
        self.iter().count()
    }

    /// Whether there is no solution.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The solution nearest to `q`: the one whose largest joint move is smallest, among equals the one whose moves
    /// have the smallest sum. Angles are compared modulo 2π. Slides count in the arm's unit against radians, of which solutions alone
    /// know no better; [`ik_near`](crate::InverseKinematics::ik_near) counts them in reaches.
    pub fn nearest(&self, q: &Joints<T, N>) -> Option<&Solution<T, N, B>> {
        let mut best: Option<(&Solution<T, N, B>, Move<T>)> = None;
        for solution in self.iter() {
            let step = self.step(&solution.q, q);
            if best.is_none_or(|(_, least)| step.is_smaller_than(&least)) {
                best = Some((solution, step));
            }
        }
        best.map(|(solution, _)| solution)
    }

    /// The same solutions, those outside the limits replaced by the joint that passes its range most and by how much.
    /// An angle is inside if it is with some whole number of turns; the solutions keep their own in (-π, π]. A family
    /// is judged by the member it holds; [`Family::ranges`] tells which of the others keep the limits.
    #[must_use]
    pub fn within(&self, limits: &Limits<N>) -> Self {
        let mut kept = self.clone();
        for branch in B::ALL {
            if let Slot::Solved(solution) = self.get(*branch)
                && let Some(reason) = self.passed(limits, &solution.q)
            {
                kept.put(*branch, Slot::Empty(reason));
            }
        }
        kept.settle_mergers();
        kept
    }

    pub(crate) fn kind(&self, joint: usize) -> JointKind {
        if self.sliding.contains(joint) { JointKind::Prismatic } else { JointKind::Revolute }
    }

    /// Whether no joint of two vectors differs by more than the tolerance; most differ in the first.
    fn same(&self, a: &Joints<T, N>, b: &Joints<T, N>, near: Near<T>) -> bool {
        let ([a], [b]) = (&a.data.0, &b.data.0);
        // Most pairs are told apart without taking whole turns off.
        let turn = T::TURN.0 - (near.angle + near.angle);
        a.iter().zip(b).enumerate().all(|(joint, (a, b))| {
            let gap = math::abs(*a - *b);
            let near = if self.sliding.contains(joint) { near.length } else { near.angle };
            gap <= near || (gap >= turn && math::abs(self.difference(joint, *a, *b)) <= near)
        })
    }

    /// The way of one joint from `b` to `a`: the short way round for an angle.
    fn difference(&self, joint: usize, a: T, b: T) -> T {
        match self.kind(joint) {
            JointKind::Prismatic => a - b,
            JointKind::Revolute => math::wrap(a - b),
        }
    }

    /// How far the joints move from one vector to another, angles the short way round.
    fn step(&self, from: &Joints<T, N>, to: &Joints<T, N>) -> Move<T> {
        Move::between(from, to, |joint, way| self.difference(joint, way, T::lit(0.0)))
    }

    /// Empties each slot whose joints are those of an earlier one, and says so.
    pub(crate) fn merge(&mut self, reach: T) {
        self.merge_within(Near::of(tolerance::<T>(), reach));
    }

    fn merge_within(&mut self, near: Near<T>) {
        for (count, branch) in B::ALL.iter().enumerate() {
            let (before, rest) = self.slots().split_at(count.min(self.slots().len()));
            let Some(later) = rest.first().and_then(Slot::solution) else { continue };
            let is_same = |earlier: &Slot<T, N, B>| {
                earlier.solution().is_some_and(|first| self.same(&first.q, &later.q, near))
            };
            if let Some(with) = before.iter().position(is_same).and_then(|place| B::ALL.get(place)) {
                self.put(*branch, Slot::Merged { with: *with });
            }
        }
        // A slot that others were merged with may have been merged itself. Mergers point to earlier slots, so that one
        // pass in the order of the branches takes each to the slot that holds the solution.
        for branch in B::ALL {
            if let Slot::Merged { with } = *self.get(*branch)
                && let Slot::Merged { with: holder } = *self.get(with)
            {
                self.put(*branch, Slot::Merged { with: holder });
            }
        }
    }

    /// Puts a solution that no slot holds, nor one within `near` of it, where another branch's was merged or where none is; if all slots
    /// are taken, where two are as near each other. Not beside a family, which may hold it. Tells whether there was room.
    pub(crate) fn add(&mut self, solution: Solution<T, N, B>, near: Near<T>) -> bool {
        if self.iter().any(|other| !other.is_isolated() || self.same(&other.q, &solution.q, near)) {
            return true;
        }
        if self.slots().iter().all(|slot| slot.solution().is_some()) {
            self.merge_within(near);
        }
        let is_merged = |branch: &&B| matches!(self.get(**branch), Slot::Merged { .. });
        let is_empty = |branch: &&B| matches!(self.get(**branch), Slot::Empty(_));
        let room = B::ALL.iter().find(is_merged).or_else(|| B::ALL.iter().find(is_empty));
        if let Some(branch) = room {
            self.put(*branch, Slot::Solved(Solution { branch: *branch, ..solution }));
        }
        room.is_some()
    }
}

/// How near the joints of one solution are to those of the same one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near<T> {
    angle: T,
    length: T,
}

impl<T: Float> Near<T> {
    /// So many radians, and as much of the reach.
    pub(crate) fn of(radians: T, reach: T) -> Self {
        Near { angle: radians, length: radians * reach }
    }
}

/// Joint vectors closer than this, in radians and reaches, are the same solution: 1e-7 in `f64`, 7√ε in `f32`.
pub(crate) fn tolerance<T: Float>() -> T {
    T::lit(6.710_886_4) * math::sqrt(T::EPS)
}

/// How far the joints move, the largest first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Move<T> {
    pub(crate) largest: T,
    pub(crate) sum: T,
}

impl<T: Float> Move<T> {
    pub(crate) fn is_smaller_than(&self, other: &Self) -> bool {
        self.largest < other.largest || (self.largest == other.largest && self.sum < other.sum)
    }
}

impl<T, const N: usize, B> Slot<T, N, B> {
    /// The solution it holds.
    pub fn solution(&self) -> Option<&Solution<T, N, B>> {
        match self {
            Slot::Solved(solution) => Some(solution),
            Slot::Merged { .. } | Slot::Empty(_) => None,
        }
    }
}

impl<'a, T: Float, const N: usize, B: Branch> IntoIterator for &'a Solutions<T, N, B> {
    type Item = &'a Solution<T, N, B>;
    type IntoIter = iter::FilterMap<slice::Iter<'a, Slot<T, N, B>>, Held<'a, T, N, B>>;

    fn into_iter(self) -> Self::IntoIter {
        self.slots().iter().filter_map(Slot::solution)
    }
}

/// The solution that a slot holds.
type Held<'a, T, const N: usize, B> = fn(&'a Slot<T, N, B>) -> Option<&'a Solution<T, N, B>>;

impl<T: Float, const N: usize, B: Branch> Clone for Solutions<T, N, B> {
    fn clone(&self) -> Self {
        Self { slots: B::slots(|branch| *branch.of(&self.slots)), sliding: self.sliding }
    }
}

impl<T: Float, const N: usize, B: Branch> Copy for Solutions<T, N, B> where B::Slots<Slot<T, N, B>>: Copy {}

impl<T: Float, const N: usize, B: Branch> PartialEq for Solutions<T, N, B> {
    fn eq(&self, other: &Self) -> bool {
        self.sliding == other.sliding && self.slots() == other.slots()
    }
}

impl<T: Float, const N: usize, B: Branch> fmt::Debug for Solutions<T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.slots()).finish()
    }
}
