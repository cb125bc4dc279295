//! The trigonometric kernel against correctly rounded values.
//!
//! The judge is CORE-MATH (A. Sibidanov, P. Zimmermann and S. Glondu, "The CORE-MATH project", ARITH 2022), whose
//! functions give the double nearest to the true value. A distance of n counts the doubles from there to ours: the
//! error lies between n - 1/2 and n + 1/2 units in the last place. What lanes give is judged; that one number alone
//! has the same bits is required on the way.

use kin_runtime::{Float, Real, math};
use std::f64::consts::FRAC_PI_2;

use crate::sample::Sampler;

/// Lanes of one draw.
const LANES: usize = 8;

/// How samples are drawn.
#[derive(Clone, Copy, Debug)]
pub enum Draw {
    /// Uniform in ±1 of this size.
    Uniform(f64),
    /// Every finite bit pattern alike: log-uniform over the whole range, subnormal numbers among them.
    Bits,
    /// Within a few last places of a multiple of π/2, up to 2^bits of them.
    Quarters(u32),
    /// Subnormal.
    Subnormal,
    /// From 2^40 to the largest number, log-uniform.
    Huge,
}

/// Each way to draw, with its name in the table.
pub const DRAWS: [(&str, Draw); 9] = [
    ("uniform, one turn", Draw::Uniform(6.3)),
    ("uniform, 4000 turns", Draw::Uniform(25_100.0)),
    ("uniform, 1e9", Draw::Uniform(1e9)),
    ("every bit pattern", Draw::Bits),
    ("near few quarters", Draw::Quarters(4)),
    ("near usual quarters", Draw::Quarters(14)),
    ("near many quarters", Draw::Quarters(40)),
    ("subnormal", Draw::Subnormal),
    ("huge", Draw::Huge),
];

impl Draw {
    /// The next sample; finite.
    pub fn next(self, sampler: &mut Sampler) -> f64 {
        let bits = sampler.bits();
        let sign = bits & (1 << 63);
        match self {
            Draw::Uniform(size) => sampler.between(-size, size),
            Draw::Bits => f64::from_bits(sign | (bits % (0x7ff << 52))),
            Draw::Quarters(many) => {
                let quarters = (bits >> (63 - many)) as f64;
                let near = (quarters * FRAC_PI_2).to_bits().saturating_add(sampler.bits() % 5);
                f64::from_bits(sign | near.saturating_sub(2))
            }
            Draw::Subnormal => f64::from_bits(sign | (bits & ((1 << (bits % 53)) - 1))),
            Draw::Huge => f64::from_bits(sign | ((1063 << 52) + bits % ((2047 - 1063) << 52))),
        }
    }

    /// The same in single precision, where the draw has a meaning there.
    pub fn next_single(self, sampler: &mut Sampler) -> f32 {
        let bits = sampler.bits() as u32;
        let sign = bits & (1 << 31);
        match self {
            Draw::Bits => f32::from_bits(sign | (bits % (0xff << 23))),
            Draw::Quarters(_) => {
                let near = (self.next(sampler) as f32).to_bits().saturating_add(sampler.bits() as u32 % 5);
                f32::from_bits(near.saturating_sub(2))
            }
            Draw::Subnormal => f32::from_bits(sign | (bits & ((1 << (bits % 24)) - 1))),
            Draw::Huge => f32::from_bits(sign | ((167 << 23) + bits % ((255 - 167) << 23))),
            Draw::Uniform(_) => self.next(sampler) as f32,
        }
    }
}

/// The largest distances of one draw, and how many results were not the nearest number.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// Largest distance of sine, cosine and arctangent.
    pub largest: [u64; 3],
    /// Results that are not the nearest number.
    pub off: [u64; 3],
}

impl Errors {
    /// Counts one result.
    fn add(&mut self, function: usize, distance: u64) {
        self.largest[function] = self.largest[function].max(distance);
        self.off[function] += u64::from(distance != 0);
    }
}

/// The number of doubles from one to another; a zero of the wrong sign is one away, a NaN very far.
pub fn distance(x: f64, y: f64) -> u64 {
    let place =
        |x: f64| if x.is_sign_negative() { !(x.to_bits() as i64 & i64::MAX) } else { x.to_bits() as i64 };
    if x.is_nan() || y.is_nan() { u64::MAX } else { place(x).abs_diff(place(y)) }
}

/// As [`distance`], in single precision.
pub fn distance_single(x: f32, y: f32) -> u64 {
    let place =
        |x: f32| if x.is_sign_negative() { !(x.to_bits() as i32 & i32::MAX) } else { x.to_bits() as i32 };
    if x.is_nan() || y.is_nan() { u64::MAX } else { u64::from(place(x).abs_diff(place(y))) }
}

/// Double precision over at least `count` samples of one draw.
///
/// # Panics
///
/// If a lane has not the bits of its number alone.
pub fn double(draw: Draw, count: u64, seed: u64) -> Errors {
    let (mut sampler, mut errors) = (Sampler::new(seed), Errors::default());
    for _ in 0..count.div_ceil(LANES as u64) {
        let x: [f64; LANES] = std::array::from_fn(|_| draw.next(&mut sampler));
        let y: [f64; LANES] = std::array::from_fn(|lane| match lane % 4 {
            // Near a diagonal, where octants meet; of a size of its own; else of the same draw.
            0 => {
                f64::from_bits((x[lane].to_bits() ^ (sampler.bits() << 63)).wrapping_add(sampler.bits() % 3))
            }
            1 => x[lane] * sampler.between(-4.0, 4.0),
            _ => draw.next(&mut sampler),
        });
        let (sines, cosines) = math::sin_cos_lanes(x);
        let angles = math::atan2_lanes(y, x);
        for lane in 0..LANES {
            let (sine, cosine) = Real::sin_cos(x[lane]);
            assert_eq!(sine.to_bits(), sines[lane].to_bits(), "sin {:e}", x[lane]);
            assert_eq!(cosine.to_bits(), cosines[lane].to_bits(), "cos {:e}", x[lane]);
            let angle = <f64 as Float>::atan2(y[lane], x[lane]);
            assert_eq!(angle.to_bits(), angles[lane].to_bits(), "atan2 {:e} {:e}", y[lane], x[lane]);
            errors.add(0, distance(sine, core_math::sin(x[lane])));
            errors.add(1, distance(cosine, core_math::cos(x[lane])));
            if !y[lane].is_nan() {
                errors.add(2, distance(angle, core_math::atan2(y[lane], x[lane])));
            }
        }
    }
    errors
}

/// Single precision over at least `count` samples of one draw.
///
/// # Panics
///
/// If a lane has not the bits of its number alone.
pub fn single(draw: Draw, count: u64, seed: u64) -> Errors {
    let (mut sampler, mut errors) = (Sampler::new(seed), Errors::default());
    for _ in 0..count.div_ceil(LANES as u64) {
        let x: [f32; LANES] = std::array::from_fn(|_| draw.next_single(&mut sampler));
        let (sines, cosines) = Real::sin_cos_all(x);
        for lane in 0..LANES {
            let (sine, cosine) = Real::sin_cos(x[lane]);
            assert_eq!(sine.to_bits(), sines[lane].to_bits(), "sin {:e}", x[lane]);
            assert_eq!(cosine.to_bits(), cosines[lane].to_bits(), "cos {:e}", x[lane]);
            let y = draw.next_single(&mut sampler);
            errors.add(0, distance_single(sine, core_math::sinf(x[lane])));
            errors.add(1, distance_single(cosine, core_math::cosf(x[lane])));
            errors.add(2, distance_single(<f32 as Float>::atan2(y, x[lane]), core_math::atan2f(y, x[lane])));
        }
    }
    errors
}
