//! The singularity monitor: an arm's dexterity along a trajectory, and every time at which it passes a threshold.
//!
//! * [`Watch::readings`]: the figures at a steady rate: det J, singular values, manipulability.
//! * [`Watch::crossings`]: the times at which a figure passes a threshold, between the samples too. Over every
//!   interval it is known how far the figure can be from its value in the middle, from its slope there and a bound of second
//!   order, and intervals are halved until the threshold is out of reach: none is passed over.
//! * [`Watch::factor_crossings`]: the same of the factors of the determinant, one for each kind of singular pose.
//! * [`Watch::spells`]: the times during which a figure is below a threshold, with the least value; as text, a warning.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
//! use kin_runtime::watch::{Factor, Factored, Measure, Watch};
//!
//! fn warn<A: Factored<6>>(arm: &A, from: &Joints<f64, 6>, to: &Joints<f64, 6>) -> usize {
//!     let limits = RateLimits::uniform(1.0, 2.0);
//!     let Ok(trajectory) = Trajectory::new(from, to, &limits, Shared::Duration) else { return 0 };
//!     let watch = Watch::new(arm, &trajectory);
//!     for spell in watch.spells(Measure::Margin, 0.02) {
//!         println!("{spell}");
//!     }
//!     // How often the wrist is stretched on the way.
//!     watch.factor_crossings(Factor::Wrist, 0.0).count()
//! }
//! ```
//!
//! Everything is normalised as in [`crate::singularity`]: linear rows divided by the arm's reach.
//!
//! # What holds
//!
//! Round-off of a figure is 64 ε, or 64 ε of the threshold if that is larger than 1. Between the brackets that come back a figure is on
//! one side of its threshold all the time, and where it goes beyond by more than round-off it comes back as two crossings, each by
//! itself. A bracket is 2^-34 of the duration wide, or as wide as the figure takes to pass through round-off: 10^-7 of the
//! duration or so where it only just reaches the threshold. What is no farther beyond than round-off may come back as
//! [`Passage::Touches`], or not at all. The time that all this takes is bounded: where a figure stays within round-off of a
//! threshold for long, the search grows coarser and one bracket that touches is as wide as the doubt.

mod bounds;
mod factors;
mod hunt;
mod moving;
mod spell;

pub use factors::{Factor, Factored, Factors};
pub use hunt::Passage;
pub use spell::{Spell, Subject};

use crate::arm::Arm;
use crate::dual;
use crate::math::{self, Float};
use crate::pose::{Jacobian, Joints};
use crate::singularity::{self, Dexterity};
use crate::trajectory::{State, Ticks, Trajectory, TrajectoryError};
use bounds::Bounds;
use core::fmt;
use hunt::{Hunt, Range, refined};
use moving::Moving;
use spell::Spells;

/// Round-off of a figure of the normalised Jacobian, in units of ε; differences below are no differences.
const NOISE: f64 = 64.0;

/// A figure of the normalised Jacobian.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Measure {
    /// The smallest singular value: how far from losing a direction.
    Margin,
    /// The product of the singular values (T. Yoshikawa, "Manipulability of robotic mechanisms", 1985).
    Manipulability,
    /// The determinant, with its sign; its absolute value is the manipulability. It is for as many joints as the task has
    /// coordinates: of any other arm it is the manipulability.
    Determinant,
}

/// An arm on a trajectory. See the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Watch<'a, A, T, const N: usize> {
    arm: &'a A,
    trajectory: Trajectory<T, N>,
    bounds: Bounds<T>,
    /// Whether the tool's orientation counts, or its position alone.
    oriented: bool,
}

/// The figures at one time.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Reading<T, const N: usize> {
    /// Where the joints are, and when.
    pub state: State<T, N>,
    /// Singular values, manipulability, margin.
    pub dexterity: Dexterity<T, N>,
    /// The determinant; `None` if there are more or fewer joints than coordinates.
    pub determinant: Option<T>,
}

/// A figure passes a threshold.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Crossing<T, const N: usize> {
    /// What passes it.
    pub subject: Subject,
    /// The threshold.
    pub threshold: T,
    /// How.
    pub passage: Passage,
    /// When, in seconds from the start.
    pub time: T,
    /// Between which times it surely is: 2^-34 of the duration apart or little more, if the figure does not linger there.
    pub between: (T, T),
    /// The joint values at that time.
    pub q: Joints<T, N>,
}

impl<'a, T: Float, A: Arm<N>, const N: usize> Watch<'a, A, T, N> {
    /// An arm that is asked for position and orientation of its tool.
    pub fn new(arm: &'a A, trajectory: &Trajectory<T, N>) -> Self {
        Self { arm, trajectory: *trajectory, bounds: Bounds::new(arm, trajectory), oriented: true }
    }

    /// An arm that is asked for the position of its tool alone: the linear rows of the Jacobian.
    pub fn of_position(arm: &'a A, trajectory: &Trajectory<T, N>) -> Self {
        Self { oriented: false, ..Self::new(arm, trajectory) }
    }

    /// The trajectory.
    pub fn trajectory(&self) -> &Trajectory<T, N> {
        &self.trajectory
    }

    /// The figures at a time from the start.
    pub fn at(&self, time: T) -> Reading<T, N> {
        let state = self.trajectory.at(time);
        let jacobian = singularity::normalised(self.arm, &state.q);
        let (dexterity, determinant) = self.figures(&jacobian);
        Reading { state, dexterity, determinant }
    }

    /// The figures at 0, 1/rate, 2/rate, … seconds and at the end.
    ///
    /// # Errors
    /// [`TrajectoryError::BadTime`] for a rate (in Hz) that is not positive and finite.
    pub fn readings(
        &self,
        rate: T,
    ) -> Result<impl Iterator<Item = Reading<T, N>> + Clone, TrajectoryError<T>> {
        let ticks = Ticks::new(rate, self.trajectory.duration())?;
        Ok(ticks.map(move |time| self.at(time)))
    }

    fn figures(&self, jacobian: &Jacobian<T, N>) -> (Dexterity<T, N>, Option<T>) {
        if self.oriented {
            (singularity::measured(jacobian, 6), singularity::determinant(jacobian))
        } else {
            (
                singularity::measured(&singularity::linear(jacobian), 3),
                singularity::position_determinant(jacobian),
            )
        }
    }

    /// Least and greatest value that a figure can have between two times, for certain; wider than need be.
    pub fn range(&self, measure: Measure, from: T, to: T) -> (T, T) {
        ends(self.measured(measure, middle(from, to), half(from, to)))
    }

    /// A figure at a time, and how far its values can be from that in the half width around it.
    fn measured(&self, measure: Measure, time: T, half: T) -> Range<T> {
        let moving = self.moving(time, half);
        match measure {
            Measure::Margin => moving.margin(),
            Measure::Manipulability => moving.determinant().map_or_else(|| moving.manipulability(), positive),
            Measure::Determinant => moving.determinant().unwrap_or_else(|| moving.manipulability()),
        }
    }

    /// The same, for the question on which side of a threshold it stays.
    fn about(&self, measure: Measure, threshold: T, time: T, half: T) -> Range<T> {
        if measure == Measure::Margin {
            self.moving(time, half).margin_about(threshold, noise(threshold))
        } else {
            self.measured(measure, time, half)
        }
    }

    /// The Jacobian in the middle of an interval.
    fn moving(&self, time: T, half: T) -> Moving<T, N> {
        let state = self.trajectory.at(time);
        let whole = singularity::normalised(self.arm, &dual::moving(&state.q, &state.velocity));
        let (jacobian, rows) = if self.oriented { (whole, 6) } else { (singularity::linear(&whole), 3) };
        let (off, aside) = self.bounds.matrix(&jacobian, half);
        Moving { jacobian, rows, half, off, aside }
    }

    /// Every time at which a figure passes a threshold, in order.
    pub fn crossings(&self, measure: Measure, threshold: T) -> impl Iterator<Item = Crossing<T, N>> + Clone {
        self.passing(Subject::Measure(measure), threshold, move |time, half| {
            self.about(measure, threshold, time, half)
        })
    }

    /// The times during which a figure, its sign aside, is below a threshold, in order.
    pub fn spells(&self, measure: Measure, threshold: T) -> impl Iterator<Item = Spell<T>> + Clone {
        let size = move |time, half| positive(self.about(measure, threshold, time, half));
        Spells::new(Subject::Measure(measure), self.trajectory.duration(), threshold, size)
    }

    fn passing(
        &self,
        subject: Subject,
        threshold: T,
        range: impl Fn(T, T) -> Range<T> + Clone,
    ) -> impl Iterator<Item = Crossing<T, N>> + Clone {
        let mut hunt = Hunt::new(self.trajectory.duration(), threshold, noise(threshold));
        core::iter::from_fn(move || {
            let found = hunt.next(&range)?;
            let above = |time: T| range(time, T::lit(0.0)).value > threshold;
            let time = refined(found.from, found.to, above);
            let (between, passage) = ((found.from, found.to), found.passage);
            let q = self.trajectory.at(time).q;
            Some(Crossing { subject, threshold, passage, time, between, q })
        })
    }
}

impl<T: Float, A: Factored<N>, const N: usize> Watch<'_, A, T, N> {
    /// The factors of the determinant at a time from the start.
    pub fn factors(&self, time: T) -> Factors<T> {
        self.arm.factors(&self.trajectory.at(time).q)
    }

    /// Least and greatest value that a factor can have between two times, for certain; `None` if the arm does not have it.
    pub fn factor_range(&self, factor: Factor, from: T, to: T) -> Option<(T, T)> {
        self.factor(factor, middle(from, to), half(from, to)).map(ends)
    }

    fn factor(&self, factor: Factor, time: T, half: T) -> Option<Range<T>> {
        let state = self.trajectory.at(time);
        let now = self.arm.factors(&dual::moving(&state.q, &state.velocity)).get(factor)?;
        Some(Range { value: now.value, spread: self.bounds.factor(factor, now.rate, half) })
    }

    /// Every time at which a factor, with its sign, passes a threshold, in order: at 0 the times at which the singular set itself
    /// is passed. None if the arm does not have it.
    pub fn factor_crossings(
        &self,
        factor: Factor,
        threshold: T,
    ) -> impl Iterator<Item = Crossing<T, N>> + Clone {
        let range = move |time, half| self.factor(factor, time, half).unwrap_or(nothing());
        self.passing(Subject::Factor(factor), threshold, range)
    }

    /// The times during which a factor, its sign aside, is below a threshold, in order.
    pub fn factor_spells(&self, factor: Factor, threshold: T) -> impl Iterator<Item = Spell<T>> + Clone {
        let size = move |time, half| positive(self.factor(factor, time, half).unwrap_or(nothing()));
        Spells::new(Subject::Factor(factor), self.trajectory.duration(), threshold, size)
    }
}

/// What stands for a factor that an arm does not have: it is far from singular.
fn nothing<T: Float>() -> Range<T> {
    Range { value: T::lit(f64::INFINITY), spread: T::lit(0.0) }
}

/// What round-off makes of figures of the size of a threshold, or of 1 if it is smaller.
fn noise<T: Float>(threshold: T) -> T {
    T::lit(NOISE) * T::EPS * math::max(T::lit(1.0), math::abs(threshold))
}

/// The range of the absolute value.
fn positive<T: Float>(range: Range<T>) -> Range<T> {
    Range { value: math::abs(range.value), ..range }
}

fn ends<T: Float>(range: Range<T>) -> (T, T) {
    (range.value - range.spread, range.value + range.spread)
}

fn middle<T: Float>(from: T, to: T) -> T {
    from + (to - from) * T::lit(0.5)
}

fn half<T: Float>(from: T, to: T) -> T {
    math::abs(to - from) * T::lit(0.5)
}

impl<T: Float, const N: usize> fmt::Display for Crossing<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let how = match self.passage {
            Passage::Falls => "falls below",
            Passage::Rises => "rises above",
            Passage::Touches => "touches",
        };
        write!(f, "t = {:.6} s: {} {how} {}", self.time, self.subject, self.threshold)
    }
}
