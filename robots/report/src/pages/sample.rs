//! Random numbers that are the same in every run, so that a page is a function of the program.

use std::f64::consts::PI;

/// A splitmix64 generator (G. Steele, D. Lea and C. Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014).
#[derive(Clone, Debug)]
pub(super) struct Sample(pub(super) u64);

impl Sample {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Angles uniform in [-π, π).
    pub(super) fn angles<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| PI * (2.0 * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64) - 1.0))
    }
}

/// How many random configurations a claim is tried on.
pub(super) const TRIALS: usize = 200;
