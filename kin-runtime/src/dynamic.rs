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
    /// [`DynError::NoInverse`] unless [`DynArm::inverse`] is [`Inverse::Pose`].
    fn solve_pose(&self, pose: &Pose<f64>, visit: &mut dyn FnMut(DynSlot<'_>)) -> Result<(), DynError>;

    /// Calls `visit` for each branch of the inverse kinematics of a position.
    ///
    /// # Errors
    /// [`DynError::NoInverse`] unless [`DynArm::inverse`] is [`Inverse::Position`].
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

/// Implements [`DynArm`] for an arm: `dyn_arm!(Puma560, 6, pose)`, with `pose`, `position` or `plain` for what its
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
        fn solve_pose(
            &self,
            pose: &$crate::Pose<f64>,
            visit: &mut dyn ::core::ops::FnMut($crate::DynSlot<'_>),
        ) -> ::core::result::Result<(), $crate::DynError> {
            $crate::dynamic::visit_ik::<$joints, Self>(self, pose, visit);
            ::core::result::Result::Ok(())
        }
        $crate::__dyn_arm! { @ no_position }
    };
    (@ position $joints:literal) => {
        fn inverse(&self) -> $crate::Inverse {
            $crate::Inverse::Position
        }
        $crate::__dyn_arm! { @ no_pose }
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
mod tests {
    use super::*;
    use crate::sample::{LAB_ARM, LabRrr, Text};

    /// An arm that can only go forward.
    struct Bare;
    impl Arm<3> for Bare {
        const NAME: &'static str = "Bare";
        const LENGTH_UNIT: LengthUnit = LengthUnit::Inch;
        const TABLE: &'static str = "| J1 |";
        const JOINTS: [Joint; 3] = LabRrr::JOINTS;
        fn reach(&self) -> f64 {
            LabRrr.reach()
        }
        fn limits(&self) -> crate::Limits<3> {
            crate::Limits::new([Some((-1.0, 2.0)), None, None])
        }
        fn fk<T: crate::Real>(&self, q: &Joints<T, 3>) -> Pose<T> {
            LabRrr.fk(q)
        }
        fn frames<T: crate::Real>(&self, q: &Joints<T, 3>) -> [Pose<T>; 3] {
            LabRrr.frames(q)
        }
        fn jacobian<T: crate::Real>(&self, q: &Joints<T, 3>) -> crate::Jacobian<T, 3> {
            LabRrr.jacobian(q)
        }
        fn fk_jacobian<T: crate::Real>(&self, q: &Joints<T, 3>) -> (Pose<T>, crate::Jacobian<T, 3>) {
            LabRrr.fk_jacobian(q)
        }
    }

    type Lab = crate::sample::Table<'l'>;
    crate::private::dyn_arm!(Lab, 6, pose);
    crate::private::dyn_arm!(LabRrr, 3, position);
    crate::private::dyn_arm!(Bare, 3, plain);

    #[test]
    fn one_list_holds_every_kind_of_arm() {
        let arms: [&dyn DynArm; 3] = [&LAB_ARM, &LabRrr, &Bare];
        let inverses = [Inverse::Pose, Inverse::Position, Inverse::None];
        let zeros = [0.0; 6];
        for (arm, inverse) in arms.into_iter().zip(inverses) {
            assert_eq!(arm.inverse(), inverse);
            let q = &zeros[..arm.joints().len()];
            let pose = arm.pose_at(q).unwrap();
            let mut branches = 0;
            let from_pose = arm.solve_pose(&pose, &mut |_| branches += 1);
            assert_eq!(from_pose.is_ok(), inverse == Inverse::Pose);
            let [point] = pose.translation.vector.data.0;
            let from_point = arm.solve_position(point, &mut |_| branches += 1);
            assert_eq!(from_point.is_ok(), inverse == Inverse::Position);
            assert_eq!(
                branches,
                if inverse == Inverse::Pose { 8 } else { 4 * usize::from(inverse != Inverse::None) }
            );
        }
        assert_eq!(
            (arms[2].name(), arms[2].table(), arms[2].length_unit()),
            ("Bare", "| J1 |", LengthUnit::Inch)
        );
        assert_eq!((arms[2].limit(0), arms[2].limit(1), arms[2].limit(9)), (Some((-1.0, 2.0)), None, None));
        assert_eq!(arms[2].size(), LabRrr.reach());
    }

    #[test]
    fn slots_come_out_as_they_are() {
        let arm: &dyn DynArm = &LAB_ARM;
        let pose = arm.pose_at(&[0.0; 6]).unwrap();
        let (mut solved, mut merged) = (0, 0);
        arm.solve_pose(&pose, &mut |slot| match slot.outcome {
            DynOutcome::Solved { q, residual, isolated, families } => {
                solved += 1;
                assert!(q.len() == 6 && residual < 1e-14);
                assert_eq!(Text::of(families).as_str().is_empty(), isolated);
            }
            DynOutcome::Merged { with } => {
                merged += 1;
                let (own, other) = (Text::of(slot.branch), Text::of(with));
                assert_eq!((own.as_str(), other.as_str()), ("right/up/flip", "right/up/noflip"));
            }
            DynOutcome::Empty { reason } => panic!("{reason}"),
        })
        .unwrap();
        assert_eq!((solved, merged), (7, 1));
        let mut empty = 0;
        let far = crate::pose::from_rows(crate::pose::rows(&pose).0, [1e4, 0.0, 0.0]);
        arm.solve_pose(&far, &mut |slot| {
            empty += usize::from(matches!(slot.outcome, DynOutcome::Empty { .. }))
        })
        .unwrap();
        assert_eq!(empty, 8);
    }

    #[test]
    fn slices_of_the_wrong_length_are_errors() {
        let arm: &dyn DynArm = &LabRrr;
        let wrong = DynError::Joints { wanted: 3, given: 2 };
        assert_eq!(arm.pose_at(&[0.0; 2]).unwrap_err(), wrong);
        assert_eq!(arm.jacobian_at(&[0.0; 3], &mut [[0.0; 6]; 2]), Err(wrong));
        assert_eq!(arm.frames_at(&[0.0; 2], &mut []), Err(wrong));
        let mut columns = [[0.0; 6]; 3];
        arm.jacobian_at(&[0.0; 3], &mut columns).unwrap();
        assert!((columns[0][5] - 1.0).abs() < 1e-15);
        assert_eq!(Text::of(&wrong).as_str(), "the arm has 3 joints, 2 were given");
        assert!(Text::of(&DynError::NoInverse).as_str().contains("no inverse kinematics"));
    }
}
