//! The arm: what every declared robot can do, and what only some can.

use crate::choice;
use crate::ik::Wrist;
use crate::limits::Limits;
use crate::math::{Float, Real};
use crate::pose::{Jacobian, Joints, Pose};
use crate::solutions::{Branch, Reason, Solutions, Winding};
use crate::track::{ByPoint, Track};
use core::fmt;
use nalgebra::{Matrix3, Point3};

/// The two kinds of joint.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum JointKind {
    /// Turns; values in radians.
    Revolute,
    /// Slides; values in the declared unit of length.
    Prismatic,
}

/// A joint: its name in the table and its kind.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Joint {
    /// As the table names it.
    pub name: &'static str,
    /// Whether it turns or slides.
    pub kind: JointKind,
}

/// The unit of every length of an arm, at run time too.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LengthUnit {
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
    /// Inches of 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// How many metres one unit is.
    pub const fn metres(self) -> f64 {
        match self {
            LengthUnit::Metre => 1.0,
            LengthUnit::Centimetre => 0.01,
            LengthUnit::Millimetre => 0.001,
            LengthUnit::Inch => 0.0254,
        }
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            LengthUnit::Metre => "m",
            LengthUnit::Centimetre => "cm",
            LengthUnit::Millimetre => "mm",
            LengthUnit::Inch => "in",
        })
    }
}

/// An arm of `N` joints, as `dh!` declares it. Joint values are what the caller commands; angles are in radians,
/// lengths in [`Arm::LENGTH_UNIT`]. `&self`: an arm with `param`s has fields.
pub trait Arm<const N: usize> {
    /// The declared name.
    const NAME: &'static str;
    /// The declared unit of every length.
    const LENGTH_UNIT: LengthUnit;
    /// The declaration's own text.
    const TABLE: &'static str;
    /// The joints, in order.
    const JOINTS: [Joint; N];

    /// The size against which lengths are compared: the sum of |a| + |d| over all rows and the tool, plus the
    /// travel of prismatic joints; one unit of length for an arm of slides that has neither lengths nor limits. No point of the arm is farther from its first row's frame.
    fn reach(&self) -> f64;

    /// The declared joint limits, in radians or the declared unit of length.
    fn limits(&self) -> Limits<N>;

    /// The pose of the tool in the base frame.
    fn fk<T: Real>(&self, q: &Joints<T, N>) -> Pose<T>;

    /// The pose of each joint's frame in the base frame. In a table, frame i is the end of joint i's own row; in a
    /// chain it is just before joint i + 1. The tool belongs to none of them.
    fn frames<T: Real>(&self, q: &Joints<T, N>) -> [Pose<T>; N];

    /// The geometric Jacobian with respect to q: linear velocity of the tool point, then angular velocity, both in
    /// base axes.
    fn jacobian<T: Real>(&self, q: &Joints<T, N>) -> Jacobian<T, N>;

    /// Pose and Jacobian together, for less than the two apart.
    fn fk_jacobian<T: Real>(&self, q: &Joints<T, N>) -> (Pose<T>, Jacobian<T, N>);

    /// [`fk`](Arm::fk) as part of its caller, compiled for the instructions that the caller has: for batches. Generated
    /// arms have their program here.
    #[doc(hidden)]
    #[inline(always)]
    fn fk_inlined<T: Real>(&self, q: &Joints<T, N>) -> Pose<T> {
        self.fk(q)
    }

    /// [`jacobian`](Arm::jacobian) as part of its caller.
    #[doc(hidden)]
    #[inline(always)]
    fn jacobian_inlined<T: Real>(&self, q: &Joints<T, N>) -> Jacobian<T, N> {
        self.jacobian(q)
    }

    /// [`fk_jacobian`](Arm::fk_jacobian) as part of its caller.
    #[doc(hidden)]
    #[inline(always)]
    fn fk_jacobian_inlined<T: Real>(&self, q: &Joints<T, N>) -> (Pose<T>, Jacobian<T, N>) {
        self.fk_jacobian(q)
    }
}

/// An arm whose last three axes meet in one point, the wrist centre.
#[diagnostic::on_unimplemented(
    message = "the last three axes of `{Self}` do not meet in one point",
    label = "not an arm with a spherical wrist",
    note = "`dh!` implements `SphericalWrist` for arms whose axes 4, 5 and 6 have a common point in every position"
)]
pub trait SphericalWrist<const N: usize>: Arm<N> {
    /// The rotation from frame 3 to frame 6, from the last three row values (equal to q4, q5, q6 unless `couple:`
    /// touches them).
    fn r36<T: Real>(&self, q4: T, q5: T, q6: T) -> Matrix3<T>;

    /// The rotation of frame 3 and the position of the wrist centre, both in the base frame, from the first three
    /// row values.
    fn r03<T: Real>(&self, q1: T, q2: T, q3: T) -> (Matrix3<T>, Point3<T>);

    /// The last three row values from the rotation between frames 3 and 6: two solutions, or the family.
    fn wrist_angles<T: Float>(&self, r36: &Matrix3<T>) -> Wrist<T>;
}

/// An arm whose joint values follow from the pose of its tool in closed form, all solutions of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no closed-form inverse kinematics from a pose",
    label = "no `ik` for this arm",
    note = "`dh!` derives `ik` for arms of six joints whose last, or first, three axes meet and whose other three \
            joints, of any kind, move that point through space, and for arms of two to five joints two or three of which carry \
            a point that the others leave in its place; every arm has `fk` and `jacobian`"
)]
pub trait InverseKinematics<const N: usize>: Arm<N> {
    /// The labels of the solution slots.
    type Branch: Branch;

    /// All joint values that bring the tool to `pose` (in the base frame, declared unit of length): one slot for each
    /// branch, solved, merged with another, or empty with its reason. Angles are in (-π, π]; limits are not applied.
    ///
    /// Coordinates that a singular pose leaves free take these values: joints 1 and 2 the value 0, joints 4 and 6 an equal share of
    /// their sum or difference. Of an arm whose first three axes meet: joints 6 and 5 the value 0, joints 1 and 3 an equal share.
    fn ik<T: Float>(&self, pose: &Pose<T>) -> Solutions<T, N, Self::Branch>;

    /// As [`ik`](InverseKinematics::ik), but a coordinate that the pose leaves free keeps its value in `hold`.
    fn ik_holding<T: Float>(&self, pose: &Pose<T>, hold: &Joints<T, N>) -> Solutions<T, N, Self::Branch>;

    /// [`ik`](InverseKinematics::ik) of each pose, compiled for the instructions that the caller has: for batches. Generated
    /// arms have several side by side here.
    #[doc(hidden)]
    #[inline(always)]
    fn ik_each<T: Float>(&self, poses: &[Pose<T>], places: &mut [Option<Solutions<T, N, Self::Branch>>]) {
        for (pose, place) in poses.iter().zip(places) {
            *place = Some(self.ik(pose));
        }
    }

    /// The joint values nearest to `q` that bring the tool to `pose`: see
    /// [`ik_near_within`](InverseKinematics::ik_near_within), without limits.
    ///
    /// # Errors
    /// Why there are none.
    fn ik_near<T: Float>(
        &self,
        pose: &Pose<T>,
        q: &Joints<T, N>,
    ) -> Result<Winding<T, N, Self::Branch>, Reason<T>> {
        self.ik_near_within(pose, q, &Limits::NONE)
    }

    /// The joint values within the limits nearest to `q` that bring the tool to `pose`: of all solutions, each wound as
    /// near to `q` as the limits let it, the one with the smallest largest joint move, among equals the one with the
    /// smallest sum of moves; moves of a slide are divided by the arm's reach. A coordinate that a singular pose leaves
    /// free keeps its value in `q`, or takes the nearest value that the limits allow (to the resolution of
    /// [`Family::ranges`](crate::Family::ranges)): a joint that need not move stands still, though the member with the smallest
    /// largest move, [`Family::nearest`](crate::Family::nearest), may share the move with it.
    ///
    /// # Errors
    /// Why there are none: the least passed limit if it is for the limits, else the least missing distance, else what is
    /// wrong with the pose; [`Reason::NotFinite`] also for `q`.
    fn ik_near_within<T: Float>(
        &self,
        pose: &Pose<T>,
        q: &Joints<T, N>,
        limits: &Limits<N>,
    ) -> Result<Winding<T, N, Self::Branch>, Reason<T>> {
        choice::nearest(&|hold: &_| self.ik_holding(pose, hold), &Self::JOINTS, self.reach(), q, limits)
    }

    /// Follows a path of poses from the joint values `start`, one step for each pose: see [`Track`].
    fn track<T: Float, I>(&self, start: &Joints<T, N>, path: I) -> Track<'_, Self, T, N, I::IntoIter>
    where
        Self: Sized,
        I: IntoIterator<Item = Pose<T>>,
        I::IntoIter: Clone,
    {
        Track::new(self, start, path.into_iter())
    }
}

/// An arm whose joint values follow from the position of its tool point alone, all solutions of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no closed-form inverse kinematics from a position",
    label = "no `ik_position` for this arm",
    note = "`dh!` derives `ik_position` for arms of two or three joints all of which are needed to move the tool point; \
            arms of two to six joints have `ik`, from a pose"
)]
pub trait PositionInverse<const N: usize>: Arm<N> {
    /// The labels of the solution slots.
    type Branch: Branch;

    /// All joint values that bring the tool point to `p` (in the base frame, declared unit of length).
    fn ik_position<T: Float>(&self, p: &Point3<T>) -> Solutions<T, N, Self::Branch>;

    /// As [`ik_position`](PositionInverse::ik_position), but a coordinate that the point leaves free keeps its value
    /// in `hold`.
    fn ik_position_holding<T: Float>(
        &self,
        p: &Point3<T>,
        hold: &Joints<T, N>,
    ) -> Solutions<T, N, Self::Branch>;

    /// As [`InverseKinematics::ik_near`], from a position.
    ///
    /// # Errors
    /// Why there are no joint values.
    fn ik_position_near<T: Float>(
        &self,
        p: &Point3<T>,
        q: &Joints<T, N>,
    ) -> Result<Winding<T, N, Self::Branch>, Reason<T>> {
        self.ik_position_near_within(p, q, &Limits::NONE)
    }

    /// As [`InverseKinematics::ik_near_within`], from a position.
    ///
    /// # Errors
    /// Why there are no joint values.
    fn ik_position_near_within<T: Float>(
        &self,
        p: &Point3<T>,
        q: &Joints<T, N>,
        limits: &Limits<N>,
    ) -> Result<Winding<T, N, Self::Branch>, Reason<T>> {
        choice::nearest(&|hold: &_| self.ik_position_holding(p, hold), &Self::JOINTS, self.reach(), q, limits)
    }

    /// Follows a path of points (in the base frame, declared unit of length) from the joint values `start`, one step for each
    /// point: see [`Track`].
    fn track_position<T: Float, I>(
        &self,
        start: &Joints<T, N>,
        path: I,
    ) -> Track<'_, Self, T, N, I::IntoIter, ByPoint>
    where
        Self: Sized,
        I: IntoIterator<Item = Point3<T>>,
        I::IntoIter: Clone,
    {
        Track::new(self, start, path.into_iter())
    }
}
