//! The correctly rounded operations: `+ − × ÷ √`.

use super::super::limbs;
use super::Real;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

impl Neg for Real {
    type Output = Real;

    fn neg(self) -> Real {
        Real { negative: !self.negative && !self.is_zero(), ..self }
    }
}

impl Add for Real {
    type Output = Real;

    fn add(self, other: Real) -> Real {
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return other;
        }
        let (large, small) =
            if self.compare_sizes(&other) == Ordering::Less { (other, self) } else { (self, other) };
        // A limb above for the carry, a limb below for what is shifted out; all that is further down is one bit.
        let distance = large.exponent.abs_diff(small.exponent);
        let mut sum = widened(&large.mantissa);
        let (addend, more) = limbs::shift_right(&widened(&small.mantissa), distance);
        if large.negative == small.negative {
            limbs::add(&mut sum, &addend);
        } else {
            limbs::subtract(&mut sum, &addend);
            // What was cut off is taken off too: one unit now, which the bit then gives back in part.
            if more {
                limbs::decrement(&mut sum);
            }
        }
        Real::round(large.negative, large.exponent as i64 + 64, &sum, more)
    }
}

/// A mantissa with a limb below and a limb above.
fn widened(mantissa: &[u64; 4]) -> [u64; 6] {
    [0, mantissa[0], mantissa[1], mantissa[2], mantissa[3], 0]
}

impl Sub for Real {
    type Output = Real;

    fn sub(self, other: Real) -> Real {
        self + -other
    }
}

impl Mul for Real {
    type Output = Real;

    fn mul(self, other: Real) -> Real {
        if self.is_zero() || other.is_zero() {
            return Real::ZERO;
        }
        let product: [u64; 8] = limbs::multiply(&self.mantissa, &other.mantissa);
        let exponent = self.exponent as i64 + other.exponent as i64 + 1;
        Real::round(self.negative != other.negative, exponent, &product, false)
    }
}

impl Div for Real {
    type Output = Real;

    /// The quotient; zero of a division by zero.
    fn div(self, other: Real) -> Real {
        if self.is_zero() || other.is_zero() {
            return Real::ZERO;
        }
        let (quotient, more) = limbs::divide(&self.mantissa, &other.mantissa);
        // Bit 320 of the quotient has the weight of the exponents' difference, and bit 383 is the top one.
        let exponent = self.exponent as i64 - other.exponent as i64 + 63;
        Real::round(self.negative != other.negative, exponent, &quotient, more)
    }
}

impl Real {
    /// The square root; zero of a negative number.
    pub fn sqrt(self) -> Real {
        if self.is_zero() || self.negative {
            return Real::ZERO;
        }
        // Within [1, 4), with an even exponent left over.
        let square = Real { exponent: self.exponent & 1, ..self };
        let mut doubled = [0; 8];
        doubled[4..].copy_from_slice(&self.mantissa);
        let (radicand, _) = limbs::shift_right(&doubled, (square.exponent ^ 1) as u32);

        // Heron's rule doubles the 63 bits of the first guess twice, which leaves a few units of the last bit.
        let head = ((radicand[7] as u128) << 64) | radicand[6] as u128;
        let mut root = Real { negative: false, exponent: 0, mantissa: [0, 0, 0, head.isqrt() as u64] };
        root = (root + square / root).scaled(-1);
        root = (root + square / root).scaled(-1);

        let guess = if root.exponent == 0 { root.mantissa } else { [u64::MAX; 4] };
        Real { negative: false, exponent: self.exponent >> 1, mantissa: nearest_root(guess, &radicand) }
    }
}

/// The integer next to the root of `radicand`, from a guess that is a few units off.
fn nearest_root(guess: [u64; 4], radicand: &[u64; 8]) -> [u64; 4] {
    let mut root = guess;
    let mut steps = 0;
    // It is r where (r − ½)² = r² − r + ¼ is below the radicand and (r + ½)² = r² + r + ¼ above.
    while steps < 8 {
        let wide = [root[0], root[1], root[2], root[3], 0, 0, 0, 0];
        let mut low: [u64; 8] = limbs::multiply(&root, &root);
        let mut high = low;
        limbs::subtract(&mut low, &wide);
        limbs::add(&mut high, &wide);
        if limbs::compare(radicand, &low) != Ordering::Greater {
            limbs::decrement(&mut root);
        } else if limbs::compare(radicand, &high) == Ordering::Greater {
            limbs::increment(&mut root);
        } else {
            break;
        }
        steps += 1;
    }
    root
}
