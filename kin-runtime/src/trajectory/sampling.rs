//! Times at a steady rate, the end included.

use super::{State, Trajectory, TrajectoryError, positive};
use crate::math::Float;

/// A period's part by which the last regular tick must precede the end to be a tick of its own.
const APART: f64 = 1e-6;

/// The times 0, 1/rate, 2/rate, … and the duration itself, each once, rising.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ticks<T> {
    rate: T,
    duration: T,
    /// The next tick; none once the end has been given.
    next: Option<u64>,
}

impl<T: Float> Ticks<T> {
    /// At so many ticks per second, over a duration in seconds.
    ///
    /// # Errors
    /// [`TrajectoryError::BadTime`] for a rate that is not positive and finite, or a duration that is negative or not finite.
    pub fn new(rate: T, duration: T) -> Result<Self, TrajectoryError<T>> {
        let timed = duration >= T::lit(0.0) && crate::math::is_finite(duration);
        if !(positive(rate) && timed) {
            return Err(TrajectoryError::BadTime);
        }
        Ok(Self { rate, duration, next: Some(0) })
    }
}

impl<T: Float> Iterator for Ticks<T> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        let count = self.next?;
        // Each tick is a quotient of its own: no sum of periods, which would drift.
        let (here, there) = (T::lit(count as f64), T::lit(count as f64 + APART));
        if there / self.rate < self.duration {
            self.next = Some(count.saturating_add(1));
            Some(here / self.rate)
        } else {
            self.next = None;
            Some(self.duration)
        }
    }
}

/// The states of a trajectory at a steady rate, the end included.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Samples<T, const N: usize> {
    pub(super) trajectory: Trajectory<T, N>,
    pub(super) ticks: Ticks<T>,
}

impl<T: Float, const N: usize> Iterator for Samples<T, N> {
    type Item = State<T, N>;

    fn next(&mut self) -> Option<Self::Item> {
        self.ticks.next().map(|time| self.trajectory.at(time))
    }
}
