//! Seeded samples: the same numbers on every machine.

use std::f64::consts::PI;

/// A splitmix64 generator (G. Steele, D. Lea and C. Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014).
#[derive(Clone, Debug)]
pub struct Sampler(u64);

impl Sampler {
    /// A generator that starts there.
    pub fn new(seed: u64) -> Sampler {
        Sampler(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Uniform in 0 .. count; 0 if there is nothing to choose from.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }

    /// Angles uniform in [-π, π).
    pub fn angles<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.between(-PI, PI))
    }
}

#[test]
fn samples_are_spread_and_repeat() {
    let (mut a, mut b) = (Sampler::new(7), Sampler::new(7));
    let drawn: Vec<f64> = (0..1000).map(|_| a.between(-1.0, 1.0)).collect();
    assert!(drawn.iter().all(|x| (-1.0..1.0).contains(x)));
    assert!(drawn.iter().sum::<f64>().abs() < 60.0);
    assert_eq!(drawn[999], (0..1000).map(|_| b.between(-1.0, 1.0)).last().unwrap());
}
