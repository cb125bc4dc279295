//! Many configurations, or many poses, at once: slices in, slices out.
//!
//! ```
//! use kin_runtime::prelude::*;
//!
//! /// The heights of the tool over a list of configurations.
//! fn heights<const N: usize>(arm: &(impl Arm<N> + Sync), q: &[Joints<f64, N>]) -> Vec<f64> {
//!     let mut poses = vec![Pose::identity(); q.len()];
//!     arm.fk_batch(q, &mut poses).expect("a place for each configuration");
//!     poses.iter().map(|pose| pose.translation.z).collect()
//! }
//! ```
//!
//! What comes out has the bits that [`fk`](Arm::fk), [`jacobian`](Arm::jacobian) and [`ik`](InverseKinematics::ik) give one
//! by one, whatever the length of the slices and the machine; where they give NaN, NaN. Where a register holds four doubles or
//! more, configurations go through the arm's program side by side, as structures of arrays; with the feature `std` that program
//! is compiled for several instruction sets, and the widest that the machine has is found while it runs ([`Instructions`]).
//! Without it the same loops are compiled for what the whole program is compiled for. Poses of arms with an elbow and an
//! orthogonal wrist are solved side by side too with the feature `std`; other inverses, and poses near a singular one, go one by
//! one. Nothing is allocated.
//!
//! The methods of [`Batch`] run where they are called, to the end. A [`Run`] can do it on all threads (feature `rayon`), tell
//! of progress, stop early, or keep to narrower instructions.
//!
//! ```text
//! run        how: threads, progress, early ends
//! forward    from joints to poses and Jacobians
//! inverse    from poses to solutions
//! ```

mod forward;
mod inverse;
mod run;
#[cfg(test)]
mod tests;

pub use crate::widths::Instructions;
pub use run::{Progress, Run};

use crate::arm::{Arm, InverseKinematics};
use crate::math::Float;
use crate::pose::{Jacobian, Joints, Pose};
use crate::solutions::Solutions;
use core::fmt;

/// Batches of every arm: [`Run::new`] with its defaults. Slices of different lengths are refused, nothing is written then.
pub trait Batch<const N: usize>: Arm<N> + Sync + Sized {
    /// The pose of the tool for each configuration: [`fk`](Arm::fk).
    ///
    /// # Errors
    /// [`BatchError::Lengths`].
    fn fk_batch<T: Float>(&self, q: &[Joints<T, N>], poses: &mut [Pose<T>]) -> Result<(), BatchError> {
        Run::new().fk(self, q, poses)
    }

    /// The Jacobian for each configuration: [`jacobian`](Arm::jacobian).
    ///
    /// # Errors
    /// [`BatchError::Lengths`].
    fn jacobian_batch<T: Float>(
        &self,
        q: &[Joints<T, N>],
        jacobians: &mut [Jacobian<T, N>],
    ) -> Result<(), BatchError> {
        Run::new().jacobian(self, q, jacobians)
    }

    /// Pose and Jacobian for each configuration: [`fk_jacobian`](Arm::fk_jacobian).
    ///
    /// # Errors
    /// [`BatchError::Lengths`].
    fn fk_jacobian_batch<T: Float>(
        &self,
        q: &[Joints<T, N>],
        poses: &mut [Pose<T>],
        jacobians: &mut [Jacobian<T, N>],
    ) -> Result<(), BatchError> {
        Run::new().fk_jacobian(self, q, poses, jacobians)
    }

    /// All solutions for each pose: [`ik`](InverseKinematics::ik). See [`Run::ik`].
    ///
    /// # Errors
    /// [`BatchError::Lengths`].
    fn ik_batch<T: Float>(
        &self,
        poses: &[Pose<T>],
        solutions: &mut [Found<T, N, Self>],
    ) -> Result<(), BatchError>
    where
        Self: InverseKinematics<N>,
        Found<T, N, Self>: Send,
    {
        Run::new().ik(self, poses, solutions)
    }
}

impl<A: Arm<N> + Sync, const N: usize> Batch<N> for A {}

/// A place for the solutions of one pose: `None` until they are found.
pub type Found<T, const N: usize, A> = Option<Solutions<T, N, <A as InverseKinematics<N>>::Branch>>;

/// Why a batch did not come to its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BatchError {
    /// There are not as many places as there are configurations or poses. Nothing was written.
    Lengths {
        /// How many configurations or poses there are.
        given: usize,
        /// How many places there are for what comes out.
        places: usize,
    },
    /// Whoever was told of the [`Progress`] ended the run. All that was done by then is in its place; the other places are as
    /// they were.
    Stopped(Progress),
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BatchError::Lengths { given, places } => write!(f, "{places} places for the results of {given}"),
            BatchError::Stopped(Progress { done, total }) => write!(f, "stopped after {done} of {total}"),
        }
    }
}

impl core::error::Error for BatchError {}
