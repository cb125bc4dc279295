//! Why a slot is empty.

/// Why a branch has no solution.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Reason<T> {
    /// An entry of the pose, or of the joint values to be near, is infinite or not a number.
    NotFinite,
    /// The arm's own numbers, which its parameters may have made so: one is not finite, or the lengths come to nothing,
    /// or to so much that their squares would overflow.
    NotAnArm,
    /// The orientation is not a rotation.
    NotARotation {
        /// The largest entry of RᵀR - 1.
        defect: T,
    },
    /// The orientation is a rotation and a reflection: its determinant is -1.
    LeftHanded,
    /// The pose is too far away, or too near. The nearest one that the arm reaches is what
    /// [`ClosestPose::closest`](crate::ClosestPose::closest) gives for six joints, for a position
    /// [`ClosestPoint::closest_point`](crate::ClosestPoint::closest_point).
    OutOfReach {
        /// The distance to the nearest point that this figure reaches, with the joints before it as they are: a length, or
        /// radians for [`Boundary::WristCone`] and [`Boundary::ShoulderCone`]. With all joints at liberty the arm may come
        /// nearer, never less near.
        by: T,
        /// Which boundary lies between.
        towards: Boundary,
        /// The value of the first joint as the table has it, before `couple:`, where that was found and only the rest fails: an
        /// angle, or a length where it slides. With a spherical shoulder joint 6 is found first, and nothing stands here.
        theta1: Option<T>,
    },
    /// The arm has fewer ways than branches where the pose is, and no other begins nearby: three joints of which two slide have two
    /// of four, and a [general base](crate::ik::general) may have two of four anywhere. Of a pose that is reached by no branch
    /// at least one tells its distance.
    NoSuchBranch,
    /// The tool cannot be turned like that where the pose has it: an arm of fewer than six joints.
    Orientation {
        /// The angle, in radians, between the orientation and the one that the joints come to; others may be nearer.
        by: T,
    },
    /// A joint would leave its range.
    Limit {
        /// The joint, counted from 0.
        joint: usize,
        /// By how much.
        by: T,
    },
    /// The joint values found miss the pose by more than round-off explains, so they are not given out.
    Inaccurate {
        /// As in [`Solution::residual`](crate::Solution::residual).
        residual: T,
    },
}

/// The edge of what a figure reaches.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Boundary {
    /// The cylinder about axis 1 inside which the arm's lateral offset keeps the wrist centre from coming.
    Cylinder,
    /// The circle of the stretched arm about axis 2; about axis 5 with a spherical shoulder.
    OuterCircle,
    /// The circle of the folded arm about axis 2, or of a slide at its nearest; about axis 5 with a spherical shoulder.
    InnerCircle,
    /// The surface at which two ways of a [general base](crate::ik::general) meet and end. The distance that comes with it is
    /// to a point that is reached, near the nearest: an upper bound.
    Envelope,
    /// The surface on which two joints carry a point, of an arm that has no more to do it with. The distance that comes with it
    /// is, of a position that two joints do not reach at all, the least there is, as
    /// [`ClosestPoint::closest_point`](crate::ClosestPoint::closest_point) has it; else it is to a point that is reached, near
    /// the nearest: an upper bound.
    Surface,
    /// The reach of the arm as a whole: the pose is so far away that the arm is round-off of the distance, and no figure
    /// was looked at. A slide counts with the travel that its limits allow.
    Reach,
    /// The cone that an oblique wrist can point into, or must point out of.
    WristCone,
    /// The cylinder about axis 6 inside which the lateral offset of the other joints keeps the centre of a spherical shoulder
    /// from coming.
    HandCylinder,
    /// The cone that an oblique spherical shoulder can point into, or must point out of.
    ShoulderCone,
}
