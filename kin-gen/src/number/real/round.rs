//! Rounding, and the ways in and out of [`Real`].

use super::super::{Ratio, limbs};
use super::Real;

/// The bit below the last one that is kept.
const HALF: u64 = 1 << 63;

impl Real {
    /// The nearest real to an integer of `N > 4` limbs whose bit `64 · N − 1` has the weight 2^`exponent`; `more`
    /// says that something not zero was cut off below. Ties go to even.
    pub(super) fn round<const N: usize>(
        negative: bool,
        exponent: i64,
        integer: &[u64; N],
        more: bool,
    ) -> Real {
        const { assert!(N > 4, "there is nothing to round") };
        let zeros = limbs::leading_zeros(integer);
        let integer = limbs::shift_left(integer, zeros);
        let mut exponent = exponent - zeros as i64;
        let mut mantissa = [integer[N - 4], integer[N - 3], integer[N - 2], integer[N - 1]];
        let rest = integer[N - 5];
        let tie = rest == HALF && !more && !limbs::any_below(&integer, N - 5);
        let up = rest >= HALF && (!tie || mantissa[0] & 1 == 1);
        if up && limbs::increment(&mut mantissa) {
            mantissa = [0, 0, 0, HALF];
            exponent += 1;
        }
        Real::within_range(negative, exponent, mantissa)
    }

    /// A whole number, exactly.
    pub fn from_i64(value: i64) -> Real {
        Real::from_i128(value as i128)
    }

    /// A whole number, exactly.
    pub fn from_i128(value: i128) -> Real {
        let size = value.unsigned_abs();
        Real::round(value < 0, 255, &[0, size as u64, (size >> 64) as u64, 0, 0], false)
    }

    /// The nearest real to a ratio.
    pub fn from_ratio(value: Ratio) -> Real {
        // Both parts are exact, so that there is one rounding: the division's.
        let num = Real::from_i128(value.num());
        if value.is_integer() { num } else { num / Real::from_i128(value.den()) }
    }

    /// A double, exactly; `None` of an infinity or a NaN.
    pub fn from_f64(value: f64) -> Option<Real> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let (size, biased) = match (bits >> 52) & 0x7ff {
            0 => (fraction, 1),
            biased => (fraction | (1 << 52), biased as i32),
        };
        let size = Real::from_i128(size as i128).scaled(biased - 1075);
        Some(if value < 0.0 { -size } else { size })
    }

    /// The nearest double, ties to even: also among the subnormal ones, and infinite from halfway beyond the
    /// largest one on. Zero is positive.
    pub fn to_f64(self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        let bits = if self.exponent > 1023 { 0x7ff << 52 } else { self.size_bits() };
        f64::from_bits(bits | ((self.negative as u64) << 63))
    }

    /// The bits of the nearest double to the size, which is below 2^1024.
    fn size_bits(self) -> u64 {
        // The double keeps 53 bits, and fewer below 2^-1022; its first bit then is no longer implied.
        let subnormal = self.exponent < -1022;
        let kept = if subnormal { (self.exponent + 1075).max(-1) } else { 53 };
        if kept < 0 {
            return 0;
        }
        // One bit stands for all that is below the top limb: the halfway mark is at least ten bits above it.
        let top = self.mantissa[3] | limbs::any_below(&self.mantissa, 3) as u64;
        let split = (top as u128) << kept;
        let (above, below) = ((split >> 64) as u64, split as u64);
        let up = below > HALF || (below == HALF && above & 1 == 1);
        let rounded = above + up as u64;
        // The implied bit, and a carry out of the rounding, count the exponent up by one, even to infinity.
        if subnormal { rounded } else { (((self.exponent + 1022) as u64) << 52) + rounded }
    }

    /// The ratio that this is, if it has at most 64 bits and fits.
    pub(in super::super) fn to_short_ratio(self) -> Option<Ratio> {
        if self.is_zero() {
            return Some(Ratio::ZERO);
        }
        if limbs::any_below(&self.mantissa, 3) {
            return None;
        }
        let zeros = self.mantissa[3].trailing_zeros() as i32;
        let odd = (self.mantissa[3] >> zeros) as i128;
        let exponent = self.exponent - 63 + zeros;
        let scale =
            if exponent.unsigned_abs() < 127 { 1_i128 << exponent.unsigned_abs() } else { return None };
        let odd = if self.negative { -odd } else { odd };
        if exponent < 0 { Ratio::new(odd, scale) } else { Ratio::new(odd.checked_mul(scale)?, 1) }
    }
}
