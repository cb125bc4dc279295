//! How a batch is run: on one thread or on all, with somebody told of progress or nobody.

use super::forward::{Forward, Jacobians, Poses};
use super::inverse::Backward;
use super::{BatchError, Found};
use crate::arm::{Arm, InverseKinematics};
use crate::math::Float;
use crate::pose::{Jacobian, Joints, Pose};
use crate::widths::{self, Instructions};
use core::ops::ControlFlow;

/// So many elements, tens of microseconds of forward kinematics, are the least that is worth a thread's while.
const CHUNK: usize = 1024;

/// What a batch consists of: elements of which any can be done on their own.
pub(super) trait Work: Sized + Send {
    /// How many elements there are.
    fn len(&self) -> usize;
    /// The first so many, or all, and the rest.
    fn split_at(self, at: usize) -> (Self, Self);
    /// Does them with these instructions. To be inlined, so that it can be compiled for each of them.
    fn run(self, with: Instructions);
}

/// How far a batch has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    /// The elements that are done: the first so many.
    pub done: usize,
    /// All elements.
    pub total: usize,
}

/// How a batch is run.
///
/// ```
/// use core::ops::ControlFlow;
/// use kin_runtime::batch::{BatchError, Run};
/// use kin_runtime::prelude::*;
///
/// /// Poses until the time is up; how many there are.
/// fn in_time<const N: usize>(
///     arm: &(impl Arm<N> + Sync),
///     q: &[Joints<f64, N>],
///     poses: &mut [Pose<f64>],
///     time_is_up: impl Fn() -> bool,
/// ) -> Result<usize, BatchError> {
///     let mut told = |_| if time_is_up() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
///     match Run::new().with_progress(&mut told).fk(arm, q, poses) {
///         Ok(()) => Ok(q.len()),
///         Err(BatchError::Stopped(progress)) => Ok(progress.done),
///         Err(error) => Err(error),
///     }
/// }
/// ```
pub struct Run<'a> {
    at_most: Instructions,
    threads: Threads,
    told: Option<&'a mut dyn FnMut(Progress) -> ControlFlow<()>>,
}

/// Where the elements are done.
#[derive(Clone, Copy)]
enum Threads {
    /// Where the batch was asked for.
    Here,
    /// On rayon's.
    #[cfg(feature = "rayon")]
    All,
}

impl Default for Run<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl Run<'_> {
    /// On the thread that asks for it, with the widest instructions that the machine has, to the end.
    pub const fn new() -> Self {
        Run { at_most: Instructions::WIDEST, threads: Threads::Here, told: None }
    }

    /// On all threads of the [rayon](https://docs.rs/rayon) pool that the caller is in, the global one by default.
    #[cfg(feature = "rayon")]
    #[must_use]
    pub const fn on_threads(mut self) -> Self {
        self.threads = Threads::All;
        self
    }

    /// With no wider instructions than these, in the loops of the batch. A pose that is solved by itself is solved as
    /// [`InverseKinematics::ik`] does.
    #[must_use]
    pub const fn at_most(mut self, instructions: Instructions) -> Self {
        self.at_most = instructions;
        self
    }

    /// Somebody is told how far the batch has come, on the thread that asks for it: after every thousand elements or so for
    /// each thread, the last time when all is done. [`ControlFlow::Break`] ends the run.
    #[must_use]
    pub fn with_progress(self, told: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> Run<'_> {
        Run { at_most: self.at_most, threads: self.threads, told: Some(told) }
    }

    /// The pose of the tool for each configuration, in the base frame: [`Arm::fk`].
    ///
    /// # Errors
    /// [`BatchError`]: slices of different lengths, or an early end.
    pub fn fk<T: Float, A: Arm<N> + Sync, const N: usize>(
        &mut self,
        arm: &A,
        q: &[Joints<T, N>],
        poses: &mut [Pose<T>],
    ) -> Result<(), BatchError> {
        fits(q.len(), poses.len())?;
        self.go(Forward { arm, q, answers: Poses(poses) })
    }

    /// The Jacobian for each configuration: [`Arm::jacobian`].
    ///
    /// # Errors
    /// [`BatchError`]: slices of different lengths, or an early end.
    pub fn jacobian<T: Float, A: Arm<N> + Sync, const N: usize>(
        &mut self,
        arm: &A,
        q: &[Joints<T, N>],
        jacobians: &mut [Jacobian<T, N>],
    ) -> Result<(), BatchError> {
        fits(q.len(), jacobians.len())?;
        self.go(Forward { arm, q, answers: Jacobians(jacobians) })
    }

    /// Pose and Jacobian for each configuration: [`Arm::fk_jacobian`].
    ///
    /// # Errors
    /// [`BatchError`]: slices of different lengths, or an early end.
    pub fn fk_jacobian<T: Float, A: Arm<N> + Sync, const N: usize>(
        &mut self,
        arm: &A,
        q: &[Joints<T, N>],
        poses: &mut [Pose<T>],
        jacobians: &mut [Jacobian<T, N>],
    ) -> Result<(), BatchError> {
        fits(q.len(), poses.len())?;
        fits(q.len(), jacobians.len())?;
        self.go(Forward { arm, q, answers: (Poses(poses), Jacobians(jacobians)) })
    }

    /// All solutions for each pose: [`InverseKinematics::ik`]. Places hold `None` until then, afterwards none of them does.
    /// The solutions of a pose are a kilobyte: whoever needs them once takes a thousand poses at a time through the same
    /// places, which stay in the cache.
    ///
    /// # Errors
    /// [`BatchError`]: slices of different lengths, or an early end.
    pub fn ik<T: Float, A: InverseKinematics<N> + Sync, const N: usize>(
        &mut self,
        arm: &A,
        poses: &[Pose<T>],
        solutions: &mut [Found<T, N, A>],
    ) -> Result<(), BatchError>
    where
        Found<T, N, A>: Send,
    {
        fits(poses.len(), solutions.len())?;
        self.go(Backward { arm, poses, solutions })
    }

    /// Everything, in parts if somebody wants to hear of them.
    fn go(&mut self, work: impl Work) -> Result<(), BatchError> {
        let (threads, at_most) = (self.threads, self.at_most);
        let Some(told) = &mut self.told else {
            threads.run(work, at_most);
            return Ok(());
        };
        let (total, mut done, mut left) = (work.len(), 0, work);
        while done < total {
            let (now, later) = left.split_at(threads.part());
            done += now.len();
            left = later;
            threads.run(now, at_most);
            let progress = Progress { done, total };
            if told(progress).is_break() && done < total {
                return Err(BatchError::Stopped(progress));
            }
        }
        Ok(())
    }
}

impl Threads {
    /// How many elements are done between two words of progress.
    fn part(self) -> usize {
        match self {
            Threads::Here => CHUNK,
            // Several chunks for each, so that none waits long for the last.
            #[cfg(feature = "rayon")]
            Threads::All => 8 * CHUNK * rayon::current_num_threads(),
        }
    }

    fn run(self, work: impl Work, at_most: Instructions) {
        match self {
            Threads::Here => done(work, at_most),
            #[cfg(feature = "rayon")]
            Threads::All => halved(work, at_most),
        }
    }
}

/// With the widest instructions that are here and allowed.
fn done(work: impl Work, at_most: Instructions) {
    widths::run(
        #[inline(always)]
        |with| work.run(with),
        at_most,
    );
}

/// In halves, each of which any thread may take, down to chunks.
#[cfg(feature = "rayon")]
fn halved(work: impl Work, at_most: Instructions) {
    if work.len() <= CHUNK {
        return done(work, at_most);
    }
    let chunks = work.len() / CHUNK;
    let (one, other) = work.split_at(chunks.div_ceil(2) * CHUNK);
    rayon::join(|| halved(one, at_most), || halved(other, at_most));
}

fn fits(given: usize, places: usize) -> Result<(), BatchError> {
    if given == places { Ok(()) } else { Err(BatchError::Lengths { given, places }) }
}
