//! Singular solutions: infinitely many joint vectors for one pose, as a value.

use super::{Branch, JointSet, Slot, Solution, Solutions};
use crate::arm::{InverseKinematics, PositionInverse};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use core::iter;
use nalgebra::{Point3, SVector};

/// Which figure has collapsed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Singularity {
    /// The wrist centre lies on axis 1: joint 1 is free, the wrist follows. Of a spherical shoulder: axes 1 and 3
    /// coincide, only the sum or the difference of their angles is known.
    Shoulder,
    /// The wrist centre lies on axis 2, the arm folded onto it: joint 2 is free, the wrist follows. With a spherical shoulder:
    /// its centre lies on axis 5, joint 5 is free, the shoulder follows.
    Elbow,
    /// Axes 4 and 6 coincide: only the sum or the difference of their angles is known. With a spherical shoulder: its centre
    /// lies on axis 6, joint 6 is free, the shoulder follows.
    Wrist,
}

/// How a collapsed figure lets the joints move without moving the tool.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Loose<const N: usize> {
    /// One joint may take any value.
    Follow {
        /// That joint.
        joint: u8,
        /// It and those that move with it.
        moving: JointSet,
    },
    /// The joint vector may go in a direction of whole numbers.
    Line(SVector<i8, N>),
}

/// What the pose leaves free, as a solution stores it.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Free<const N: usize> {
    pub(crate) shoulder: Option<Loose<N>>,
    pub(crate) elbow: Option<Loose<N>>,
    pub(crate) wrist: Option<Loose<N>>,
}

impl<const N: usize> Free<N> {
    /// An isolated solution.
    pub(crate) const NOTHING: Self = Self { shoulder: None, elbow: None, wrist: None };
}

/// What holds between the joints of a family.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Constraint<T, const N: usize> {
    /// The sum of two joint angles, or the first less the second, is constant.
    Sum {
        /// The two joints, counted from 0.
        joints: [usize; 2],
        /// Whether the second is subtracted.
        difference: bool,
        /// The constant, in (-π, π].
        equals: T,
    },
    /// The joints move along a straight line: any multiple of this vector may be added. So it is where `couple:` ties
    /// further joints to the two that are free.
    Line(SVector<i8, N>),
    /// One joint may take any value; the others follow from the pose.
    Follow,
}

/// One way in which a solution may be moved without moving the tool.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a, T, const N: usize, B> {
    solution: &'a Solution<T, N, B>,
    singularity: Singularity,
    loose: Loose<N>,
}

impl<T: Float, const N: usize, B: Branch> Solution<T, N, B> {
    /// The families it belongs to: none for an isolated solution; several where singularities come together.
    pub fn families(&self) -> impl Iterator<Item = Family<'_, T, N, B>> {
        let of = |singularity, loose| Family { solution: self, singularity, loose };
        let shoulder = self.free.shoulder.map(|loose| of(Singularity::Shoulder, loose));
        let elbow = self.free.elbow.map(|loose| of(Singularity::Elbow, loose));
        let wrist = self.free.wrist.map(|loose| of(Singularity::Wrist, loose));
        iter::empty().chain(shoulder).chain(elbow).chain(wrist)
    }

    /// The family of the joint nearest to the base, if the solution is not isolated.
    pub fn family(&self) -> Option<Family<'_, T, N, B>> {
        self.families().next()
    }

    /// Whether it stands alone, so that no joint can move without moving the tool.
    pub fn is_isolated(&self) -> bool {
        self.free == Free::NOTHING
    }
}

impl<'a, T: Float, const N: usize, B: Branch> Family<'a, T, N, B> {
    /// Which figure has collapsed.
    pub fn singularity(&self) -> Singularity {
        self.singularity
    }

    /// The member of the family that the solution holds.
    pub fn solution(&self) -> &'a Solution<T, N, B> {
        self.solution
    }

    /// The joint, counted from 0, whose value the caller may choose.
    pub fn free(&self) -> usize {
        match self.loose {
            Loose::Follow { joint, .. } => usize::from(joint),
            Loose::Line(_) => self.moving().iter().next().unwrap_or(0),
        }
    }

    /// The joints that are not the same in all members, the free one among them.
    pub fn moving(&self) -> JointSet {
        match self.loose {
            Loose::Follow { moving, .. } => moving,
            Loose::Line(line) => {
                let steps = line.iter().enumerate().filter(|(_, step)| **step != 0);
                steps.fold(JointSet::EMPTY, |set, (joint, _)| set.with(joint))
            }
        }
    }

    /// The direction of a straight family.
    pub(crate) fn line(&self) -> Option<SVector<i8, N>> {
        match self.loose {
            Loose::Follow { .. } => None,
            Loose::Line(line) => Some(line),
        }
    }

    /// What holds between the joints of all members.
    pub fn constraint(&self) -> Constraint<T, N> {
        let Some(direction) = self.line() else { return Constraint::Follow };
        let [line] = direction.data.0;
        let [q] = self.solution.q.data.0;
        let mut moving = line.iter().zip(q).enumerate().filter(|(_, (step, _))| **step != 0);
        match (moving.next(), moving.next(), moving.next()) {
            (Some((i, (a @ (1 | -1), x))), Some((j, (b @ (1 | -1), y))), None) => {
                let difference = a == b;
                let equals = math::wrap(if difference { x - y } else { x + y });
                Constraint::Sum { joints: [i, j], difference, equals }
            }
            _ => Constraint::Line(direction),
        }
    }

    /// The joint vector to hold on to so that the free joint takes a value.
    pub(crate) fn hold(&self, value: T) -> Joints<T, N> {
        let chosen = self.free();
        let mut q = pose::entries(&self.solution.q);
        let Some(step) = q.get(chosen).map(|now| value - *now) else { return self.solution.q };
        if let Some(direction) = self.line() {
            // The free joint comes first on the line, with a coefficient that `couple:` keeps at ±1 in practice.
            let [line] = direction.data.0;
            let per_step = line.get(chosen).map_or(T::lit(1.0), |k| T::lit(f64::from(*k)));
            for (joint, k) in q.iter_mut().zip(line) {
                *joint += T::lit(f64::from(k)) * (step / per_step);
            }
        } else if let Some(joint) = q.get_mut(chosen) {
            *joint = value;
        }
        pose::column(q)
    }

    /// The member whose free joint has the given value: `pose` is the one that the solution was found for.
    pub fn member<A>(&self, arm: &A, pose: &Pose<T>, value: T) -> Slot<T, N, B>
    where
        A: InverseKinematics<N, Branch = B>,
    {
        self.resolved(&arm.ik_holding(pose, &self.hold(value)))
    }

    /// The member whose free joint has the given value, for an arm that is solved from a position.
    pub fn member_at<A>(&self, arm: &A, point: &Point3<T>, value: T) -> Slot<T, N, B>
    where
        A: PositionInverse<N, Branch = B>,
    {
        self.resolved(&arm.ik_position_holding(point, &self.hold(value)))
    }

    /// What became of the family's branch, a merger followed to the slot that holds the solution.
    pub(crate) fn resolved(&self, solutions: &Solutions<T, N, B>) -> Slot<T, N, B> {
        match *solutions.get(self.solution.branch) {
            Slot::Merged { with } => *solutions.get(with),
            slot => slot,
        }
    }
}
