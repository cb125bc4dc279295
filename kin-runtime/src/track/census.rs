//! How many solutions there are along a path: what is to be chosen from, next to what [`Track`] chooses.
//!
//! A course's task asks for this: "track the number of solutions along the way and choose the correct one and
//! closest to the previous (current) configuration", and in a singular pose "revert back to the previous non-singular solution
//! for this joint". [`Stop::count`] is the number, [`Stop::step`] the choice, [`Stop::held`] the joints of which the pose says
//! nothing.

use super::{ByPose, Goal, Step, Track};
use crate::arm::Arm;
use crate::math::Float;
use crate::solutions::{Branch, JointSet, Slot, Solutions};
use core::fmt;

/// How many solutions a pose has.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Census {
    /// Solutions that stand alone.
    pub isolated: usize,
    /// Families of infinitely many.
    pub families: usize,
    /// Slots whose solution is that of another.
    pub merged: usize,
}

/// One pose of a path: how many solutions it has, and which was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stop<T, const N: usize, B> {
    /// How many there are; limits are not applied.
    pub count: Census,
    /// What was taken.
    pub step: Step<T, N, B>,
    /// The joints that the pose leaves free, together with those that follow them; empty where the solution stands alone.
    pub held: JointSet,
}

/// A [`Track`] that also counts: an iterator over [`Stop`]s.
#[derive(Clone, Debug)]
pub struct Counted<'a, A: Arm<N>, T: Float, const N: usize, I, G: Goal<A, N> = ByPose>(
    pub(super) Track<'a, A, T, N, I, G>,
);

impl Census {
    /// All of them, a family counted once.
    pub fn total(&self) -> usize {
        self.isolated + self.families
    }
}

impl<T: Float, const N: usize, B: Branch> Solutions<T, N, B> {
    /// How many solutions there are, and of what kind.
    pub fn census(&self) -> Census {
        let mut census = Census::default();
        for slot in self.slots() {
            match slot {
                Slot::Solved(solution) if solution.is_isolated() => census.isolated += 1,
                Slot::Solved(_) => census.families += 1,
                Slot::Merged { .. } => census.merged += 1,
                Slot::Empty(_) => {}
            }
        }
        census
    }
}

impl<A: Arm<N>, T: Float, const N: usize, I: Iterator<Item = G::Target<T>> + Clone, G: Goal<A, N>> Iterator
    for Counted<'_, A, T, N, I, G>
{
    type Item = Stop<T, N, G::Branch>;

    fn next(&mut self) -> Option<Self::Item> {
        let Counted(track) = self;
        let pose = G::pose(&track.path.clone().next()?);
        let count = G::solutions(track.arm, &pose, track.q()).census();
        let step = track.next()?;
        let held = match &step {
            Step::Continuous(to) | Step::Flip { to, .. } => to
                .solution
                .families()
                .flat_map(|family| family.moving().iter())
                .fold(JointSet::EMPTY, JointSet::with),
            Step::Blocked(_) => JointSet::EMPTY,
        };
        Some(Stop { count, step, held })
    }
}

/// `8 solutions`, `6 solutions and 1 family`, `no solution`.
impl fmt::Display for Census {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural =
            |count: usize, one: &'static str, more: &'static str| if count == 1 { one } else { more };
        match (self.isolated, self.families) {
            (0, 0) => f.write_str("no solution"),
            (0, m) => write!(f, "{m} {}", plural(m, "family", "families")),
            (n, 0) => write!(f, "{n} {}", plural(n, "solution", "solutions")),
            (n, m) => {
                let (solutions, families) =
                    (plural(n, "solution", "solutions"), plural(m, "family", "families"));
                write!(f, "{n} {solutions} and {m} {families}")
            }
        }
    }
}
