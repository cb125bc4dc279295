//! A route: through several joint vectors, at rest at each of them, each leg the shortest trajectory.

use super::{RateLimits, Shared, State, Ticks, Trajectory, TrajectoryError};
use crate::math::Float;
use crate::pose::Joints;

/// A way through stops, borrowed: nothing is allocated, and a leg is computed when it is asked for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Route<'a, T, const N: usize> {
    stops: &'a [Joints<T, N>],
    limits: RateLimits<T, N>,
    sync: Shared,
    duration: T,
}

/// One leg of a route.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Leg<T, const N: usize> {
    /// When it starts, in seconds from the start of the route.
    pub start: T,
    /// When it ends.
    pub end: T,
    /// What happens between, counted from its own start.
    pub trajectory: Trajectory<T, N>,
}

impl<'a, T: Float, const N: usize> Route<'a, T, N> {
    /// Through the stops, in order; two of them in a row may be the same.
    ///
    /// # Errors
    /// [`NoStops`](TrajectoryError::NoStops) for fewer than two; that of the first leg which has one; and
    /// [`OutOfRange`](TrajectoryError::OutOfRange) for a sum of durations that no number holds.
    pub fn new(
        stops: &'a [Joints<T, N>],
        limits: &RateLimits<T, N>,
        sync: Shared,
    ) -> Result<Self, TrajectoryError<T>> {
        if stops.len() < 2 {
            return Err(TrajectoryError::NoStops);
        }
        let (mut route, mut duration) =
            (Self { stops, limits: *limits, sync, duration: T::lit(0.0) }, T::lit(0.0));
        for (from, to) in route.pairs() {
            duration += Trajectory::new(from, to, limits, sync)?.duration();
        }
        if !crate::math::is_finite(duration) {
            return Err(TrajectoryError::OutOfRange);
        }
        route.duration = duration;
        Ok(route)
    }

    fn pairs(&self) -> impl Iterator<Item = (&'a Joints<T, N>, &'a Joints<T, N>)> + Clone + use<'a, T, N> {
        self.stops.iter().zip(self.stops.iter().skip(1))
    }

    /// The legs, in order.
    pub fn legs(&self) -> impl Iterator<Item = Leg<T, N>> + Clone + use<'a, T, N> {
        let (limits, sync, mut start) = (self.limits, self.sync, T::lit(0.0));
        // `new` has made each of them once: none is skipped.
        self.pairs().filter_map(move |(from, to)| Trajectory::new(from, to, &limits, sync).ok()).map(
            move |trajectory| {
                let leg = Leg { start, end: start + trajectory.duration(), trajectory };
                start = leg.end;
                leg
            },
        )
    }

    /// How long it takes, in seconds.
    pub fn duration(&self) -> T {
        self.duration
    }

    /// The states at 0, 1/rate, 2/rate, … seconds and at the end itself. Stops between are passed where no tick falls on them.
    ///
    /// # Errors
    /// [`BadTime`](TrajectoryError::BadTime) for a rate (in Hz) that is not positive and finite.
    pub fn samples(&self, rate: T) -> Result<RouteSamples<'a, T, N>, TrajectoryError<T>> {
        let first = self.legs().next().ok_or(TrajectoryError::NoStops)?;
        let (stops, limits, sync) = (self.stops, self.limits, self.sync);
        Ok(RouteSamples { stops, limits, sync, leg: first, ticks: Ticks::new(rate, self.duration)? })
    }
}

impl<T: Float, const N: usize> Leg<T, N> {
    /// The state at a time of the route.
    pub fn at(&self, time: T) -> State<T, N> {
        let state =
            self.trajectory.at(if time >= self.end { self.trajectory.duration() } else { time - self.start });
        State { time, ..state }
    }
}

/// The states of a route at a steady rate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RouteSamples<'a, T, const N: usize> {
    /// The stops from the start of the leg on.
    stops: &'a [Joints<T, N>],
    limits: RateLimits<T, N>,
    sync: Shared,
    leg: Leg<T, N>,
    ticks: Ticks<T>,
}

impl<T: Float, const N: usize> Iterator for RouteSamples<'_, T, N> {
    type Item = State<T, N>;

    fn next(&mut self) -> Option<Self::Item> {
        let time = self.ticks.next()?;
        while time >= self.leg.end {
            let [_, rest @ ..] = self.stops else { break };
            let [from, to, ..] = rest else { break };
            let Ok(trajectory) = Trajectory::new(from, to, &self.limits, self.sync) else { break };
            let start = self.leg.end;
            self.leg = Leg { start, end: start + trajectory.duration(), trajectory };
            self.stops = rest;
        }
        Some(self.leg.at(time))
    }
}
