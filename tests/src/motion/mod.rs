//! Motion judged without its formulas: limits by integrating what is sampled, durations by bisection.
//!
//! A try is a function of the seed and its number, so that a worst case can be made again.

pub mod arms;
pub mod passing;
pub mod sides;
pub mod timing;
pub mod tracking;

/// The largest figure seen, and the try in which it was.
#[derive(Clone, Copy, Default, Debug, PartialEq)]
pub struct Worst {
    /// The figure.
    pub figure: f64,
    /// The number of the try.
    pub trial: u64,
}

impl Worst {
    /// Keeps the larger; a NaN is larger than any number.
    pub fn see(&mut self, figure: f64, trial: u64) {
        if figure > self.figure || figure.is_nan() {
            *self = Worst { figure, trial };
        }
    }

    /// The larger of two.
    pub fn and(mut self, other: Worst) -> Worst {
        self.see(other.figure, other.trial);
        self
    }
}
