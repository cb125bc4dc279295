//! Spells: the times during which a figure is below a threshold, and how low it gets. As text they are warnings.

use super::hunt::{Hunt, Passage, Range, refined};
use super::{Factor, Measure, noise};
use crate::math::{self, Float};
use core::fmt;

/// Samples among which the least value is looked for, before the best of them is refined.
const SAMPLES: u32 = 64;

/// What is watched.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Subject {
    /// A figure of the Jacobian.
    Measure(Measure),
    /// A factor of its determinant.
    Factor(Factor),
}

/// A time during which a figure is below a threshold, its sign aside.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spell<T> {
    /// What is below it.
    pub subject: Subject,
    /// The threshold.
    pub threshold: T,
    /// From when, in seconds from the start of the trajectory.
    pub from: T,
    /// Until when; the same as `from` if the threshold is only touched.
    pub to: T,
    /// The least value found between.
    pub least: T,
    /// When that is.
    pub at: T,
}

/// The spells of a trajectory, in order.
#[derive(Clone, Debug)]
pub(super) struct Spells<T, F> {
    subject: Subject,
    threshold: T,
    duration: T,
    size: F,
    hunt: Hunt<T>,
    /// When the spell that is open began.
    open: Option<T>,
    begun: bool,
    ended: bool,
}

impl<T: Float, F: Fn(T, T) -> Range<T>> Spells<T, F> {
    pub(super) fn new(subject: Subject, duration: T, threshold: T, size: F) -> Self {
        let hunt = Hunt::new(duration, threshold, noise(threshold));
        Self { subject, threshold, duration, size, hunt, open: None, begun: false, ended: false }
    }

    fn value(&self, time: T) -> T {
        (self.size)(time, T::lit(0.0)).value
    }

    fn spell(&self, from: T, to: T) -> Spell<T> {
        let (at, least) = self.least(from, to);
        Spell { subject: self.subject, threshold: self.threshold, from, to, least, at }
    }

    /// Where the value is least: the best of some samples, then thirds around it. A factor that changes its sign in between has a
    /// kink there, which thirds find as well.
    fn least(&self, from: T, to: T) -> (T, T) {
        let step = (to - from) / T::lit(f64::from(SAMPLES));
        let (mut at, mut least) = (from, self.value(from));
        for count in 1..=SAMPLES {
            let time = from + step * T::lit(f64::from(count));
            let value = self.value(time);
            if value < least {
                (at, least) = (time, value);
            }
        }
        let (mut low, mut high) = (math::max(at - step, from), math::min(at + step, to));
        for _ in 0..80 {
            let third = (high - low) / T::lit(3.0);
            if self.value(low + third) < self.value(high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        let time = low + (high - low) * T::lit(0.5);
        let value = self.value(time);
        if value < least { (time, value) } else { (at, least) }
    }
}

impl<T: Float, F: Fn(T, T) -> Range<T>> Iterator for Spells<T, F> {
    type Item = Spell<T>;

    fn next(&mut self) -> Option<Spell<T>> {
        if !self.begun {
            self.begun = true;
            let below = self.value(T::lit(0.0)) < self.threshold - noise(self.threshold);
            self.open = below.then(|| T::lit(0.0));
        }
        while let Some(found) = self.hunt.next(&self.size) {
            let time = refined(found.from, found.to, |time| self.value(time) >= self.threshold);
            match (found.passage, found.above, self.open) {
                (Passage::Falls, ..) => self.open = Some(time),
                (Passage::Rises, _, from) => {
                    self.open = None;
                    return Some(self.spell(from.unwrap_or(found.from), time));
                }
                // Only a start on the threshold leads below it without falling.
                (Passage::Touches, Some(false), None) => self.open = Some(found.from),
                (Passage::Touches, Some(false), Some(_)) => {}
                (Passage::Touches, _, from) => {
                    self.open = None;
                    return Some(self.spell(from.unwrap_or(found.from), found.to));
                }
            }
        }
        if self.ended {
            return None;
        }
        self.ended = true;
        self.open.take().map(|from| self.spell(from, self.duration))
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Subject::Measure(Measure::Margin) => "the smallest singular value",
            Subject::Measure(Measure::Manipulability) => "the manipulability",
            Subject::Measure(Measure::Determinant) => "det J",
            Subject::Factor(Factor::Base) => "the factor of the three carrying joints",
            Subject::Factor(Factor::Shoulder) => "the shoulder factor",
            Subject::Factor(Factor::Elbow) => "the elbow factor",
            Subject::Factor(Factor::Wrist) => "the wrist factor",
            Subject::Factor(Factor::Hand) => "the hand factor",
            Subject::Factor(Factor::Bend) => "the factor of the shoulder's bend",
        })
    }
}

impl Subject {
    /// What is lost where it is zero.
    fn meaning(self) -> &'static str {
        match self {
            Subject::Measure(_) => "the arm is near a pose in which it loses a direction of motion",
            Subject::Factor(Factor::Base) => {
                "the three joints that carry the wrist centre, the shoulder's or the tool hardly move it in one direction"
            }
            Subject::Factor(Factor::Shoulder) => "the wrist centre is near axis 1, where both shoulders meet",
            Subject::Factor(Factor::Elbow) => "the elbow is nearly stretched or folded",
            Subject::Factor(Factor::Wrist) => {
                "the wrist is nearly straight: the outer two of its axes almost coincide"
            }
            Subject::Factor(Factor::Hand) => "the shoulder's centre is near axis 6, where both hands meet",
            Subject::Factor(Factor::Bend) => {
                "the shoulder is nearly straight: the outer two of its axes almost coincide"
            }
        }
    }
}

impl<T: Float> fmt::Display for Spell<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { subject, threshold, from, to, least, at } = self;
        write!(f, "SINGULARITY: from t = {from:.3} s to t = {to:.3} s {}; ", subject.meaning())?;
        write!(f, "{subject} is below {threshold}, least {least:.3e} at t = {at:.3} s")
    }
}
