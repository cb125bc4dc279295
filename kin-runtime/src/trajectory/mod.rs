//! Trajectories: joints that start together, keep their limits on velocity and acceleration, and arrive together.
//!
//! * [`Trajectory`]: from one joint vector to another, at rest at both ends. [`Profile`] says what one joint does.
//! * [`Route`]: through several joint vectors, at rest at each of them.
//! * [`ToolPath`]: straight lines and circular arcs of the tool, with their own limits; a [`track`](crate::track) follows them.
//!
//! Times are in seconds, angles in radians, lengths in the arm's declared unit.
//!
//! ```
//! use kin_runtime::joints;
//! use kin_runtime::trajectory::{RateLimits, Shape, Shared, Trajectory};
//!
//! let limits = RateLimits { velocity: joints![1.0, 2.0], acceleration: joints![2.0, 4.0] };
//! let trajectory = Trajectory::new(&joints![0.0, 0.5], &joints![1.0, 0.0], &limits, Shared::Duration)?;
//! // 1/1 + 1/2 seconds for the first joint, which has farther to go; the second takes as long.
//! assert_eq!(trajectory.duration(), 1.5);
//! assert_eq!(trajectory.profile(0).map(|profile| profile.shape()), Some(Shape::Trapezoidal));
//!
//! // At 20 Hz: 0, 0.05, …, 1.45, and exactly the end.
//! let samples = trajectory.samples(20.0)?;
//! assert_eq!(samples.clone().count(), 31);
//! assert_eq!(samples.last().map(|state| state.q), Some(joints![1.0, 0.0]));
//! # Ok::<(), kin_runtime::trajectory::TrajectoryError<f64>>(())
//! ```
//!
//! # What holds
//!
//! At every instant no velocity and no acceleration passes its limit by more than round-off; the end is reached exactly. No
//! motion of the same kind is shorter: with [`Shared::Duration`] no motion at all that is at rest at both ends, because the
//! slowest joint is as fast as its limits let it; with [`Shared::Phases`] none whose joints are in proportion all the time.

mod profile;
mod route;
mod sampling;
#[cfg(feature = "serde")]
mod stored;
#[cfg(test)]
mod tests;
mod tool;

pub use profile::{Profile, Shape};
pub use route::{Leg, Route, RouteSamples};
pub use sampling::{Samples, Ticks};
pub use tool::{ToolLimits, ToolMotion, ToolPath, ToolPoses, ToolState};

use crate::math::{self, Float};
use crate::pose::{self, Joints};
use core::fmt;
use profile::Need;

/// The largest velocity and acceleration of each joint, in either direction: per second and per second squared.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct RateLimits<T, const N: usize> {
    /// Radians, or the declared unit of length, per second; positive.
    pub velocity: Joints<T, N>,
    /// The same per second squared; positive.
    pub acceleration: Joints<T, N>,
}

impl<T: Float, const N: usize> RateLimits<T, N> {
    /// The same limits for every joint.
    pub fn uniform(velocity: T, acceleration: T) -> Self {
        Self { velocity: pose::column([velocity; N]), acceleration: pose::column([acceleration; N]) }
    }
}

/// What the joints of a trajectory have in common.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shared {
    /// They start together and end together; each has its full acceleration, and cruises as slowly as it can afford.
    Duration,
    /// They also speed up and slow down together: the joints move along a straight line, in proportion all the time.
    Phases,
}

/// Why there is no trajectory.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TrajectoryError<T> {
    /// The start or the end of a joint, counted from 0, is not a finite number, or their distance is not.
    NotFinite {
        /// The joint.
        joint: usize,
    },
    /// A limit of a joint, counted from 0, is not a positive, finite number (subnormal numbers do not count as positive).
    BadLimit {
        /// The joint.
        joint: usize,
    },
    /// The numbers are so far apart that the duration is beyond what the number type holds.
    OutOfRange,
    /// The duration asked for is less than the limits allow.
    TooShort {
        /// The shortest that they allow.
        shortest: T,
    },
    /// A rate or a duration asked for is not a positive, finite number.
    BadTime,
    /// A route needs at least two stops.
    NoStops,
    /// A pose of a tool path is not finite, or its orientation is not a rotation; or the radius of its arc is not finite.
    BadPose,
}

/// From one joint vector to another, at rest at both ends, all joints in the same time. See the [module](self).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Trajectory<T, const N: usize> {
    from: Joints<T, N>,
    to: Joints<T, N>,
    /// Of each joint; 0 where it does not move.
    ramp: Joints<T, N>,
    duration: T,
}

/// Where the joints are at one time, and how they move.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct State<T, const N: usize> {
    /// Seconds from the start.
    pub time: T,
    /// The joint values.
    pub q: Joints<T, N>,
    /// Their velocities.
    pub velocity: Joints<T, N>,
    /// Their accelerations; where one jumps, the value that follows.
    pub acceleration: Joints<T, N>,
}

impl<T: Float, const N: usize> Trajectory<T, N> {
    /// The shortest trajectory from one joint vector to another. A joint without a way to go rests; if no joint has, the
    /// duration is 0.
    ///
    /// # Errors
    /// [`NotFinite`](TrajectoryError::NotFinite), [`BadLimit`](TrajectoryError::BadLimit) or
    /// [`OutOfRange`](TrajectoryError::OutOfRange).
    pub fn new(
        from: &Joints<T, N>,
        to: &Joints<T, N>,
        limits: &RateLimits<T, N>,
        sync: Shared,
    ) -> Result<Self, TrajectoryError<T>> {
        Self::timed(from, to, limits, sync, None)
    }

    /// The same in a given time, in seconds: a whole number of controller periods, say.
    ///
    /// # Errors
    /// As [`new`](Trajectory::new); [`TooShort`](TrajectoryError::TooShort) or [`BadTime`](TrajectoryError::BadTime).
    pub fn lasting(
        from: &Joints<T, N>,
        to: &Joints<T, N>,
        limits: &RateLimits<T, N>,
        sync: Shared,
        duration: T,
    ) -> Result<Self, TrajectoryError<T>> {
        Self::timed(from, to, limits, sync, Some(duration))
    }

    fn timed(
        from: &Joints<T, N>,
        to: &Joints<T, N>,
        limits: &RateLimits<T, N>,
        sync: Shared,
        wished: Option<T>,
    ) -> Result<Self, TrajectoryError<T>> {
        let (needs, shared) = needs(from, to, limits)?;
        let shortest = match sync {
            Shared::Phases => shared.duration(),
            Shared::Duration => {
                needs.iter().flatten().fold(T::lit(0.0), |most, need| math::max(need.duration(), most))
            }
        };
        if !sound(shortest) {
            return Err(TrajectoryError::OutOfRange);
        }
        let duration = match wished {
            None => shortest,
            Some(wished) if !(sound(wished) && wished >= T::lit(0.0)) => {
                return Err(TrajectoryError::BadTime);
            }
            Some(wished) if wished < shortest => return Err(TrajectoryError::TooShort { shortest }),
            Some(wished) => wished,
        };
        let moving = needs.iter().any(Option::is_some);
        if moving && duration <= T::lit(0.0) {
            return Err(TrajectoryError::OutOfRange);
        }
        let ramp = needs.map(|need| {
            let need = need.map(|own| if sync == Shared::Phases { shared } else { own });
            need.map_or(T::lit(0.0), |need| need.ramp(duration))
        });
        Ok(Self { from: *from, to: *to, ramp: pose::column(ramp), duration })
    }

    /// How long it takes, in seconds.
    pub fn duration(&self) -> T {
        self.duration
    }

    /// Where it starts.
    pub fn from(&self) -> &Joints<T, N> {
        &self.from
    }

    /// Where it ends.
    pub fn to(&self) -> &Joints<T, N> {
        &self.to
    }

    /// What one joint does, counted from 0; `None` if there is no such joint.
    pub fn profile(&self, joint: usize) -> Option<Profile<T>> {
        self.profiles().nth(joint)
    }

    /// What each joint does, in order.
    pub fn profiles(&self) -> impl Iterator<Item = Profile<T>> + use<T, N> {
        let duration = self.duration;
        let ends = pose::entries(&self.from).into_iter().zip(pose::entries(&self.to));
        ends.zip(pose::entries(&self.ramp)).map(move |((from, to), ramp)| Profile {
            from,
            to,
            ramp,
            duration,
        })
    }

    /// Where the joints are at a time, in seconds from the start, and how they move. Before the start they rest there, after
    /// the end they rest at the end, exactly; a time that is not a number is the start.
    pub fn at(&self, time: T) -> State<T, N> {
        let mut state = State {
            time: if time > T::lit(0.0) { math::min(time, self.duration) } else { T::lit(0.0) },
            q: self.to,
            velocity: pose::column([T::lit(0.0); N]),
            acceleration: pose::column([T::lit(0.0); N]),
        };
        let rates =
            state.velocity.data.0.iter_mut().flatten().zip(state.acceleration.data.0.iter_mut().flatten());
        for ((q, (velocity, acceleration)), profile) in
            state.q.data.0.iter_mut().flatten().zip(rates).zip(self.profiles())
        {
            (*q, *velocity, *acceleration) = profile.at(time);
        }
        state
    }

    /// The states at 0, 1/rate, 2/rate, … seconds and at the end itself, which comes once.
    ///
    /// # Errors
    /// [`BadTime`](TrajectoryError::BadTime) for a rate (in Hz) that is not positive and finite.
    pub fn samples(&self, rate: T) -> Result<Samples<T, N>, TrajectoryError<T>> {
        Ok(Samples { trajectory: *self, ticks: Ticks::new(rate, self.duration)? })
    }

    /// The same way with every rate divided by a factor of at least 1, and as much longer.
    ///
    /// # Errors
    /// [`BadTime`](TrajectoryError::BadTime) for a factor below 1 or not finite, [`OutOfRange`](TrajectoryError::OutOfRange).
    pub fn slowed(&self, factor: T) -> Result<Self, TrajectoryError<T>> {
        if !(factor >= T::lit(1.0) && math::is_finite(factor)) {
            return Err(TrajectoryError::BadTime);
        }
        let duration = self.duration * factor;
        if !sound(duration) {
            return Err(TrajectoryError::OutOfRange);
        }
        let ramp = pose::entries(&self.ramp).map(|ramp| ramp * factor);
        Ok(Self { ramp: pose::column(ramp), duration, ..*self })
    }
}

/// What each joint needs, `None` if it has no way to go, and what all of them need together.
#[expect(clippy::type_complexity, reason = "a pair that one function reads")]
fn needs<T: Float, const N: usize>(
    from: &Joints<T, N>,
    to: &Joints<T, N>,
    limits: &RateLimits<T, N>,
) -> Result<([Option<Need<T>>; N], Need<T>), TrajectoryError<T>> {
    let (mut needs, mut shared) = ([None; N], Need::nothing(T::lit(0.0)));
    let ends = pose::entries(from).into_iter().zip(pose::entries(to));
    let rates = pose::entries(&limits.velocity).into_iter().zip(pose::entries(&limits.acceleration));
    for (joint, ((need, (from, to)), (velocity, acceleration))) in
        needs.iter_mut().zip(ends).zip(rates).enumerate()
    {
        let way = math::abs(to - from);
        if !math::is_finite(way) {
            return Err(TrajectoryError::NotFinite { joint });
        }
        if !(positive(velocity) && positive(acceleration)) {
            return Err(TrajectoryError::BadLimit { joint });
        }
        if way > T::lit(0.0) {
            let own = Need::of(way, velocity, acceleration);
            (*need, shared) = (Some(own), shared.with(own));
        }
    }
    Ok((needs, shared))
}

/// Whether a number is positive, finite, and has all of its digits.
fn positive<T: Float>(x: T) -> bool {
    x > T::lit(0.0) && math::is_finite(x) && x * T::EPS * T::EPS > T::lit(0.0)
}

/// Whether a number can be a duration: none at all, or one that has all of its digits.
fn sound<T: Float>(duration: T) -> bool {
    duration.partial_cmp(&T::lit(0.0)) == Some(core::cmp::Ordering::Equal) || positive(duration)
}

impl<T: Float> fmt::Display for TrajectoryError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TrajectoryError::NotFinite { joint } => {
                write!(f, "the way of joint {} is not a finite number", joint + 1)
            }
            TrajectoryError::BadLimit { joint } => {
                write!(
                    f,
                    "the velocity and acceleration limits of joint {} must be positive and finite",
                    joint + 1
                )
            }
            TrajectoryError::OutOfRange => {
                f.write_str("ways and limits are so far apart that no number holds the duration")
            }
            TrajectoryError::TooShort { shortest } => {
                write!(f, "the limits ask for at least {shortest:.6e} s")
            }
            TrajectoryError::BadTime => f.write_str("a rate or a duration must be positive and finite"),
            TrajectoryError::NoStops => f.write_str("a route needs at least two stops"),
            TrajectoryError::BadPose => f.write_str("a pose of the path is not finite or not a rotation"),
        }
    }
}

impl<T: Float> core::error::Error for TrajectoryError<T> {}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Shape::Still => "still",
            Shape::Triangular => "triangular",
            Shape::Trapezoidal => "trapezoidal",
        })
    }
}
