//! Arms without their type: lists of robots, tools that take an arm by name.

use crate::arm::{Arm, InverseKinematics, Joint, LengthUnit, PositionInverse};
use crate::math::Float;
use crate::pose::{Joints, Pose};
use crate::solutions::{Branch, Reason, Slot, Solution, Solutions};
use core::fmt;

/// What an arm can be asked for joint values from.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Inverse {
    /// Nothing: forward kinematics and Jacobian only.
    None,
    /// The pose of its tool.
    Pose,
    /// The position of its tool point.
    Position,
    /// Either: the position of its tool point, or a pose, of which it reaches few.
    PoseOrPosition,
}

/// Why a request to a [`DynArm`] has no answer.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum DynError {
    /// The slice has another length than the arm has joints.
    Joints {
        /// How many the arm has.
        wanted: usize,
        /// How many were given.
        given: usize,
    },
    /// The arm has no inverse kinematics of this kind.
    NoInverse,
}

impl fmt::Display for DynError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DynError::Joints { wanted, given } => {
                write!(f, "the arm has {wanted} joints, {given} were given")
            }
            DynError::NoInverse => f.write_str("the arm has no inverse kinematics of this kind"),
        }
    }
}

impl core::error::Error for DynError {}

/// What became of one branch, without the arm's type.
#[derive(Clone, Copy)]
pub struct DynSlot<'a> {
    /// The branch's label.
    pub branch: &'a dyn fmt::Display,
    /// Solved, merged or empty.
    pub outcome: DynOutcome<'a>,
}

/// Solved, merged or empty, without the arm's type.
#[derive(Clone, Copy)]
pub enum DynOutcome<'a> {
    /// It has a solution of its own.
    Solved {
        /// The joint values.
        q: &'a [f64],
        /// As in [`Solution::residual`].
        residual: f64,
        /// Whether it stands alone; otherwise it is a member of a family.
        isolated: bool,
        /// The families in words, separated by semicolons; nothing for an isolated solution.
        families: &'a dyn fmt::Display,
    },
    /// Its solution is that of another branch.
    Merged {
        /// The label of that branch.
        with: &'a dyn fmt::Display,
    },
    /// It has none.
    Empty {
        /// Why.
        reason: &'a Reason<f64>,
    },
}

/// An arm behind a reference: every arm that `dh!` declares is one. Joint values come and go as slices of
/// [`DynArm::joints`]`.len()` numbers: radians, and lengths in [`DynArm::length_unit`].
///
/// The methods are not called as those of [`Arm`] are, so that both traits can be in scope.
pub trait DynArm {
    /// The declared name.
    fn name(&self) -> &'static str;
    /// The joints, in order.
    fn joints(&self) -> &'static [Joint];
    /// The unit of every length.
    fn length_unit(&self) -> LengthUnit;
    /// The declaration's own text.
    fn table(&self) -> &'static str;
    /// As [`Arm::reach`].
    fn size(&self) -> f64;
    /// The declared range of a joint, counted from 0.
    fn limit(&self, joint: usize) -> Option<(f64, f64)>;

    /// The pose of the tool in the base frame.
    ///
    /// # Errors
    /// [`DynError::Joints`] if `q` has the wrong length.
    fn pose_at(&self, q: &[f64]) -> Result<Pose<f64>, DynError>;

    /// Writes the pose of each joint's frame into `frames`.
    ///
    /// # Errors
    /// [`DynError::Joints`] if `q` or `frames` has the wrong length.
    fn frames_at(&self, q: &[f64], frames: &mut [Pose<f64>]) -> Result<(), DynError>;

    /// Writes the columns (vx, vy, vz, ωx, ωy, ωz) of the Jacobian into `columns`.
    ///
    /// # Errors
    /// [`DynError::Joints`] if `q` or `columns` has the wrong length.
    fn jacobian_at(&self, q: &[f64], columns: &mut [[f64; 6]]) -> Result<(), DynError>;

    /// What the arm can be asked for joint values from.
    fn inverse(&self) -> Inverse;

    /// Calls `visit` for each branch of the inverse kinematics of a pose.
    ///
    /// # Errors
    /// [`DynError::NoInverse`] unless [`DynArm::inverse`] is [`Inverse::Pose`] or [`Inverse::PoseOrPosition`].
    fn solve_pose(&self, pose: &Pose<f64>, visit: &mut dyn FnMut(DynSlot<'_>)) -> Result<(), DynError>;

    /// Calls `visit` for each branch of the inverse kinematics of a position.
    ///
    /// # Errors
    /// [`DynError::NoInverse`] unless [`DynArm::inverse`] is [`Inverse::Position`] or [`Inverse::PoseOrPosition`].
    fn solve_position(&self, point: [f64; 3], visit: &mut dyn FnMut(DynSlot<'_>)) -> Result<(), DynError>;
}

/// The joint vector of a slice.
///
/// # Errors
/// [`DynError::Joints`] if it has another length.
pub fn joints_of<const N: usize>(q: &[f64]) -> Result<Joints<f64, N>, DynError> {
    let values: [f64; N] = q.try_into().map_err(|_| DynError::Joints { wanted: N, given: q.len() })?;
    Ok(crate::private::joints(values))
}

/// Copies a result into the caller's slice.
///
/// # Errors
/// [`DynError::Joints`] if it has another length.
pub fn write<X: Copy, const N: usize>(from: &[X; N], to: &mut [X]) -> Result<(), DynError> {
    let given = to.len();
    let to: &mut [X; N] = to.try_into().map_err(|_| DynError::Joints { wanted: N, given })?;
    *to = *from;
    Ok(())
}

/// [`DynArm::solve_pose`] of an arm that has it.
pub fn visit_ik<const N: usize, A: InverseKinematics<N>>(
    arm: &A,
    pose: &Pose<f64>,
    visit: &mut dyn FnMut(DynSlot<'_>),
) {
    visit_slots(&arm.ik(pose), visit);
}

/// [`DynArm::solve_position`] of an arm that has it.
pub fn visit_ik_position<const N: usize, A: PositionInverse<N>>(
    arm: &A,
    point: [f64; 3],
    visit: &mut dyn FnMut(DynSlot<'_>),
) {
    visit_slots(&arm.ik_position(&crate::private::point(point)), visit);
}

fn visit_slots<const N: usize, B: Branch>(
    solutions: &Solutions<f64, N, B>,
    visit: &mut dyn FnMut(DynSlot<'_>),
) {
    for (branch, slot) in solutions.branches() {
        let families = slot.solution().map(Families);
        let outcome = match (slot, &families) {
            (Slot::Solved(solution), Some(families)) => DynOutcome::Solved {
                q: solution.q.as_slice(),
                residual: solution.residual,
                isolated: solution.is_isolated(),
                families,
            },
            (Slot::Merged { with }, _) => DynOutcome::Merged { with },
            (Slot::Empty(reason), _) => DynOutcome::Empty { reason },
            // `families` is there for every solved slot.
            (Slot::Solved(_), None) => continue,
        };
        visit(DynSlot { branch: &branch, outcome });
    }
}

/// The families of a solution, in words.
struct Families<'a, T, const N: usize, B>(&'a Solution<T, N, B>);

impl<T: Float, const N: usize, B: Branch> fmt::Display for Families<'_, T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (count, family) in self.0.families().enumerate() {
            write!(f, "{}{family}", if count == 0 { "" } else { "; " })?;
        }
        Ok(())
    }
}

/// The columns of a Jacobian.
pub fn columns<const N: usize, A: Arm<N>>(arm: &A, q: &Joints<f64, N>) -> [[f64; 6]; N] {
    arm.jacobian(q).data.0
}

/// Implements [`DynArm`] for an arm: `dyn_arm!(Puma560, 6, pose)`, with `pose`, `position`, `both` or `plain` for what its
/// inverse kinematics starts from.
#[doc(hidden)]
#[macro_export]
macro_rules! __dyn_arm {
    ($arm:ty, $joints:literal, $inverse:ident) => {
        impl $crate::DynArm for $arm {
            fn name(&self) -> &'static str {
                <$arm as $crate::Arm<$joints>>::NAME
            }
            fn joints(&self) -> &'static [$crate::Joint] {
                const JOINTS: [$crate::Joint; $joints] = <$arm as $crate::Arm<$joints>>::JOINTS;
                &JOINTS
            }
            fn length_unit(&self) -> $crate::LengthUnit {
                <$arm as $crate::Arm<$joints>>::LENGTH_UNIT
            }
            fn table(&self) -> &'static str {
                <$arm as $crate::Arm<$joints>>::TABLE
            }
            fn size(&self) -> f64 {
                $crate::Arm::<$joints>::reach(self)
            }
            fn limit(&self, joint: usize) -> ::core::option::Option<(f64, f64)> {
                $crate::Arm::<$joints>::limits(self).range(joint)
            }
            fn pose_at(&self, q: &[f64]) -> ::core::result::Result<$crate::Pose<f64>, $crate::DynError> {
                let q = $crate::dynamic::joints_of::<$joints>(q)?;
                ::core::result::Result::Ok($crate::Arm::fk(self, &q))
            }
            fn frames_at(
                &self,
                q: &[f64],
                frames: &mut [$crate::Pose<f64>],
            ) -> ::core::result::Result<(), $crate::DynError> {
                let q = $crate::dynamic::joints_of::<$joints>(q)?;
                $crate::dynamic::write(&$crate::Arm::frames(self, &q), frames)
            }
            fn jacobian_at(
                &self,
                q: &[f64],
                columns: &mut [[f64; 6]],
            ) -> ::core::result::Result<(), $crate::DynError> {
                let q = $crate::dynamic::joints_of::<$joints>(q)?;
                $crate::dynamic::write(&$crate::dynamic::columns(self, &q), columns)
            }
            $crate::__dyn_arm! { @ $inverse $joints }
        }
    };
    (@ pose $joints:literal) => {
        fn inverse(&self) -> $crate::Inverse {
            $crate::Inverse::Pose
        }
        $crate::__dyn_arm! { @ from_pose $joints }
        $crate::__dyn_arm! { @ no_position }
    };
    (@ position $joints:literal) => {
        fn inverse(&self) -> $crate::Inverse {
            $crate::Inverse::Position
        }
        $crate::__dyn_arm! { @ no_pose }
        $crate::__dyn_arm! { @ from_position $joints }
    };
    (@ both $joints:literal) => {
        fn inverse(&self) -> $crate::Inverse {
            $crate::Inverse::PoseOrPosition
        }
        $crate::__dyn_arm! { @ from_pose $joints }
        $crate::__dyn_arm! { @ from_position $joints }
    };
    (@ from_pose $joints:literal) => {
        fn solve_pose(
            &self,
            pose: &$crate::Pose<f64>,
            visit: &mut dyn ::core::ops::FnMut($crate::DynSlot<'_>),
        ) -> ::core::result::Result<(), $crate::DynError> {
            $crate::dynamic::visit_ik::<$joints, Self>(self, pose, visit);
            ::core::result::Result::Ok(())
        }
    };
    (@ from_position $joints:literal) => {
        fn solve_position(
            &self,
            point: [f64; 3],
            visit: &mut dyn ::core::ops::FnMut($crate::DynSlot<'_>),
        ) -> ::core::result::Result<(), $crate::DynError> {
            $crate::dynamic::visit_ik_position::<$joints, Self>(self, point, visit);
            ::core::result::Result::Ok(())
        }
    };
    (@ plain $joints:literal) => {
        fn inverse(&self) -> $crate::Inverse {
            $crate::Inverse::None
        }
        $crate::__dyn_arm! { @ no_pose }
        $crate::__dyn_arm! { @ no_position }
    };
    (@ no_pose) => {
        fn solve_pose(
            &self,
            _: &$crate::Pose<f64>,
            _: &mut dyn ::core::ops::FnMut($crate::DynSlot<'_>),
        ) -> ::core::result::Result<(), $crate::DynError> {
            ::core::result::Result::Err($crate::DynError::NoInverse)
        }
    };
    (@ no_position) => {
        fn solve_position(
            &self,
            _: [f64; 3],
            _: &mut dyn ::core::ops::FnMut($crate::DynSlot<'_>),
        ) -> ::core::result::Result<(), $crate::DynError> {
            ::core::result::Result::Err($crate::DynError::NoInverse)
        }
    };
}

#[cfg(test)]
mod tests;
