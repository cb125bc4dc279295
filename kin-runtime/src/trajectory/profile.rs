//! One joint from rest to rest: it speeds up evenly, goes on evenly, and slows down as it sped up.
//!
//! With the way Δ, the velocity limit v and the acceleration limit a the shortest duration D and its ramp τ are
//!
//! * triangular, where √(Δ·a) ≤ v: τ = √(Δ/a), D = 2τ, and the peak is √(Δ·a);
//! * trapezoidal otherwise: τ = v/a, D = Δ/v + τ.
//!
//! (K. Lynch and F. Park, "Modern Robotics", Cambridge 2017, section 9.2.2.) With h = √(Δ/a) and s = Δ/v, both of them times,
//! these are D = 2h where s ≤ h, and D = s + h²/s otherwise, so that joints of any units compare. A joint that is given more
//! time than it needs keeps its acceleration and lowers its cruise: τ·(D - τ) = h² has the root below.

use crate::math::{self, Float};

/// The figure of a joint's velocity over time.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape {
    /// The joint does not move.
    Still,
    /// It speeds up for half of the time and slows down for the other half.
    Triangular,
    /// Between the two ramps it goes on evenly.
    Trapezoidal,
}

/// The motion of one joint, in radians or the declared unit of length, and seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Profile<T> {
    pub(super) from: T,
    pub(super) to: T,
    pub(super) ramp: T,
    pub(super) duration: T,
}

/// What a way needs at least, for its limits: h = √(Δ/a) and s = Δ/v.
#[derive(Clone, Copy, Debug)]
pub(super) struct Need<T> {
    pub(super) rise: T,
    pub(super) cruise: T,
}

impl<T: Float> Need<T> {
    pub(super) const fn nothing(zero: T) -> Self {
        Self { rise: zero, cruise: zero }
    }

    /// Of a way within limits on velocity and acceleration. The roots are taken one by one: no product overflows.
    pub(super) fn of(way: T, velocity: T, acceleration: T) -> Self {
        Self { rise: math::sqrt(way) / math::sqrt(acceleration), cruise: way / velocity }
    }

    /// What both need together, if they share their phases.
    pub(super) fn with(self, other: Self) -> Self {
        Self { rise: math::max(self.rise, other.rise), cruise: math::max(self.cruise, other.cruise) }
    }

    /// The shortest duration.
    pub(super) fn duration(self) -> T {
        if self.cruise <= self.rise {
            self.rise + self.rise
        } else {
            self.cruise + self.rise * (self.rise / self.cruise)
        }
    }

    /// The ramp in a duration that is long enough.
    ///
    /// Next to the triangle the root loses half of its digits. There the cruise decides where it asks for a shorter ramp: the
    /// acceleration hardly depends on the ramp, the velocity does. A ramp shorter than the resolution of time is lengthened to it.
    pub(super) fn ramp(self, duration: T) -> T {
        let (one, four) = (T::lit(1.0), T::lit(4.0));
        let share = self.rise / duration;
        let part = share * share;
        let root = T::lit(2.0) * part / (one + math::sqrt_or_zero(one - four * part));
        let limited = if root > T::lit(0.25) { math::min(root, one - self.cruise / duration) } else { root };
        math::max(limited, T::EPS) * duration
    }
}

impl<T: Float> Profile<T> {
    /// Where it starts.
    pub fn from(&self) -> T {
        self.from
    }

    /// Where it ends.
    pub fn to(&self) -> T {
        self.to
    }

    /// How long it speeds up, and how long it slows down: τ, in seconds; 0 for a joint that does not move.
    pub fn ramp(&self) -> T {
        self.ramp
    }

    /// When it begins to slow down, in seconds from the start: D - τ.
    pub fn braking(&self) -> T {
        self.duration - self.ramp
    }

    /// How long it takes, in seconds.
    pub fn duration(&self) -> T {
        self.duration
    }

    /// The velocity between the ramps, signed: the peak.
    pub fn velocity(&self) -> T {
        if self.moves() { (self.to - self.from) / (self.duration - self.ramp) } else { T::lit(0.0) }
    }

    /// The acceleration of the first ramp, signed; the second has the opposite.
    pub fn acceleration(&self) -> T {
        if self.moves() { self.velocity() / self.ramp } else { T::lit(0.0) }
    }

    /// Its figure.
    pub fn shape(&self) -> Shape {
        let flat = self.duration - (self.ramp + self.ramp);
        match () {
            () if !self.moves() => Shape::Still,
            () if flat <= T::lit(8.0) * T::EPS * self.duration => Shape::Triangular,
            () => Shape::Trapezoidal,
        }
    }

    /// Position, velocity and acceleration at a time from the start.
    ///
    /// Before the start (and at a time that is not a number) it rests at the start, from the end on at the end, exactly. The second
    /// half is counted back from the end. Where the acceleration jumps it has the value that follows.
    pub fn at(&self, time: T) -> (T, T, T) {
        let zero = T::lit(0.0);
        if time >= self.duration {
            return (self.to, zero, zero);
        }
        if !self.moves() || time < zero || math::is_nan(time) {
            return (self.from, zero, zero);
        }
        let left = self.duration - time;
        let early = time <= left;
        let (near, half) = (math::min(time, left), T::lit(0.5));
        let velocity = self.velocity();
        let ramping = if early { near < self.ramp } else { near <= self.ramp };
        let (way, speed, push) = if ramping {
            let share = near / self.ramp;
            (half * velocity * share * near, velocity * share, velocity / self.ramp)
        } else {
            (velocity * (near - half * self.ramp), velocity, zero)
        };
        let (position, push) = if early { (self.from + way, push) } else { (self.to - way, -push) };
        (between(position, self.from, self.to), speed, push)
    }

    fn moves(&self) -> bool {
        self.ramp > T::lit(0.0)
    }
}

/// A value that rounding put beyond one of the ends is that end.
fn between<T: Float>(value: T, a: T, b: T) -> T {
    math::max(math::min(a, b), math::min(value, math::max(a, b)))
}
