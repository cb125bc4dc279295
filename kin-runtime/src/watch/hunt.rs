//! Where a function crosses a threshold, if for every interval a range is known in which its values lie.
//!
//! Intervals are halved until their range is above the threshold or below it, or they are as short as the resolution. What
//! crosses changes sides between two decided intervals, so that nothing is lost between samples. (For ranges from a bound on
//! the slope see S. Piyavskii 1972 and B. Shubert, "A sequential method seeking the global maximum of a function", 1972.)

use crate::math::{self, Float};

/// A value, and how far from it any other of an interval can be, towards the threshold at least.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Range<T> {
    pub(super) value: T,
    pub(super) spread: T,
}

/// How a function passes a threshold.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Passage {
    /// From above it to below it.
    Falls,
    /// From below it to above it.
    Rises,
    /// It comes so near that the resolution, or round-off, cannot tell whether it crosses; afterwards it is where it was before.
    /// So it is too where a trajectory starts or ends on the threshold.
    Touches,
}

/// A passage, and the times between which it is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Found<T> {
    pub(super) from: T,
    pub(super) to: T,
    pub(super) passage: Passage,
    /// Where the function is afterwards; nothing if it was never known.
    pub(super) above: Option<bool>,
}

/// Finer than this part of the duration nothing is looked at.
const FINEST: u32 = 34;
/// An undecided stretch is resolved to this part of its length: a function that stays on the threshold must not be halved
/// to the last bit all along.
const STRETCH: u64 = 1024;
/// After so many ranges the search grows coarser, twice with every [`STEP`] more, so that it ends: a function that stays beside the
/// threshold all along would be asked everywhere.
const PATIENCE: u64 = 1 << 16;
/// See [`PATIENCE`].
const STEP: u64 = 1 << 9;

/// The search, from the start to the end of a duration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hunt<T> {
    duration: T,
    threshold: T,
    /// Differences from the threshold that round-off may have made.
    noise: T,
    /// The interval that is next: its place among the 2^depth equal parts of the duration.
    depth: u32,
    place: u64,
    done: bool,
    /// Whether the last decided interval was above.
    above: Option<bool>,
    /// Where the undecided stretch began, in parts of 2^-FINEST.
    doubt: Option<u64>,
    /// How many ranges have been asked for.
    asked: u64,
}

/// What is known of an interval.
enum Verdict {
    Above(bool),
    Undecided,
    Halve,
}

impl<T: Float> Hunt<T> {
    pub(super) fn new(duration: T, threshold: T, noise: T) -> Self {
        let (depth, place, above, doubt) = (0, 0, None, None);
        // A threshold that is no number is passed by nothing.
        let done = !math::is_finite(threshold) || duration <= T::lit(0.0);
        Self { duration, threshold, noise, depth, place, done, above, doubt, asked: 0 }
    }

    /// The next passage. `range` is asked for the middle and the half width of an interval.
    pub(super) fn next(&mut self, range: impl Fn(T, T) -> Range<T>) -> Option<Found<T>> {
        while !self.done {
            self.asked = self.asked.saturating_add(1);
            match self.judge(&range) {
                Verdict::Halve => {
                    self.depth += 1;
                    self.place *= 2;
                }
                Verdict::Undecided => {
                    self.doubt = self.doubt.or(Some(self.start()));
                    self.advance();
                }
                Verdict::Above(now) => {
                    let (before, from, to) = (self.above.replace(now), self.doubt.take(), self.start());
                    self.advance();
                    let passage = match before {
                        Some(before) if before != now => {
                            Some(if now { Passage::Rises } else { Passage::Falls })
                        }
                        _ => from.map(|_| Passage::Touches),
                    };
                    if let Some(passage) = passage {
                        return Some(self.found(from.unwrap_or(to), to, passage));
                    }
                }
            }
        }
        // The end itself may be on the threshold.
        let from = self.doubt.take()?;
        Some(self.found(from, 1 << FINEST, Passage::Touches))
    }

    fn judge(&self, range: &impl Fn(T, T) -> Range<T>) -> Verdict {
        let parts = T::lit((1_u64 << (self.depth + 1)) as f64);
        let half = self.duration / parts;
        let Range { value, spread } = range(T::lit((2 * self.place + 1) as f64) * half, half);
        let gap = value - self.threshold;
        if math::abs(gap) > spread + self.noise {
            return Verdict::Above(gap > T::lit(0.0));
        }
        let width = 1_u64 << (FINEST - self.depth);
        let stretched = self.doubt.map_or(1, |from| (self.start() - from) / STRETCH);
        let tired = (self.asked.saturating_sub(PATIENCE) / STEP).min(u64::from(FINEST));
        let allowed = if tired == 0 { stretched } else { stretched.max(1 << tired) };
        // Of what is not a number nothing is known, in any part.
        let blurred = spread <= self.noise || math::is_nan(value) || math::is_nan(spread);
        if self.depth >= FINEST || width <= allowed || blurred { Verdict::Undecided } else { Verdict::Halve }
    }

    /// Where the interval begins, in parts of 2^-FINEST.
    fn start(&self) -> u64 {
        self.place << (FINEST - self.depth)
    }

    /// To the interval after this one.
    fn advance(&mut self) {
        self.place += 1;
        while self.depth > 0 && self.place & 1 == 0 {
            self.place >>= 1;
            self.depth -= 1;
        }
        self.done = self.depth == 0;
    }

    fn found(&self, from: u64, to: u64, passage: Passage) -> Found<T> {
        let whole = T::lit((1_u64 << FINEST) as f64);
        let time = |place: u64| T::lit(place as f64) * (self.duration / whole);
        Found { from: time(from), to: time(to), passage, above: self.above }
    }
}

/// The time in a bracket at which the function changes sides, by halving; the middle if it does not.
pub(super) fn refined<T: Float>(from: T, to: T, above: impl Fn(T) -> bool) -> T {
    let (mut low, mut high) = (from, to);
    let start = above(low);
    if above(high) != start {
        for _ in 0..64 {
            let middle = low + (high - low) * T::lit(0.5);
            if above(middle) == start { low = middle } else { high = middle }
        }
    }
    low + (high - low) * T::lit(0.5)
}
