//! Sine, cosine and the arc tangent by integer series.

use super::super::limbs;
use super::{PI, Real};
use std::cmp::Ordering;

/// A fraction in [0, 1) of 320 bits: 64 more than the result keeps.
type Fraction = [u64; 5];

/// How often [`Real::atan2`] halves its angle; each time costs a root and spares terms of the series.
const HALVINGS: u32 = 5;

impl Real {
    /// Sine and cosine of this many radians.
    ///
    /// The angle is reduced by a π of 768 bits, so that a multiple of π/2 costs no accuracy, for sizes below
    /// 2^192. Above that it is not an angle in any sense, and is taken for zero.
    pub fn sin_cos(self) -> (Real, Real) {
        let (quarters, rest) = self.quarters();
        let sine = rest.small_sine();
        // Below 45° the root is the well-conditioned way.
        let cosine = (Real::ONE - sine * sine).sqrt();
        turned(quarters, (sine, cosine))
    }

    /// The angle from the x axis to the point (x, y), within (−π, π]: 0, ±π/2 and π on the axes, 0 at the origin.
    /// So little below the negative x axis that the angle rounds to −π, it is −π.
    pub fn atan2(y: Real, x: Real) -> Real {
        let (height, width) = (y.abs(), x.abs());
        let steep = height > width;
        let acute = if steep { small_atan(width, height) } else { small_atan(height, width) };
        let acute = if steep { Real::pi().scaled(-1) - acute } else { acute };
        let size = if x.negative { Real::pi() - acute } else { acute };
        if y.negative { -size } else { size }
    }

    /// `n · π + x` to the last bits, however much of it cancels, for `n` and `x` that are themselves exact.
    pub(in super::super) fn pi_times_plus(n: Real, x: Real) -> Real {
        let rounded = n * Real::pi();
        if rounded.signum() * x.signum() >= 0 || rounded.exponent.abs_diff(x.exponent) > 1 {
            return rounded + x;
        }
        let product: [u64; 16] = limbs::multiply(&n.mantissa, &PI);
        let mut addend = [0; 16];
        addend[12..].copy_from_slice(&x.mantissa);
        let weight = n.exponent.max(x.exponent) + 2;
        let (product, _) = limbs::shift_right(&product, (weight - n.exponent - 2) as u32);
        let (addend, _) = limbs::shift_right(&addend, (weight - x.exponent) as u32);
        let (mut large, small, negative) = match limbs::compare(&product, &addend) {
            Ordering::Less => (addend, product, x.negative),
            _ => (product, addend, n.negative),
        };
        limbs::subtract(&mut large, &small);
        Real::round(negative, weight as i64, &large, false)
    }

    /// The angle as quarter turns, of which only the last two bits matter, and a rest within about ±π/4.
    fn quarters(self) -> (u64, Real) {
        if self.exponent < -1 {
            return (0, self);
        }
        if self.exponent >= 192 {
            return (0, Real::ZERO);
        }
        let (count, whole) = (self / Real::pi()).scaled(1).nearest_integer();
        // 2x − nπ, halved: the product is exact to 1024 bits before anything cancels.
        (count, Real::pi_times_plus(-whole, self.scaled(1)).scaled(-1))
    }

    /// The nearest whole number: its lowest limb in two's complement, and itself. The size must be below 2^255.
    fn nearest_integer(self) -> (u64, Real) {
        if self.exponent < -1 {
            return (0, Real::ZERO);
        }
        let wide = [0, self.mantissa[0], self.mantissa[1], self.mantissa[2], self.mantissa[3]];
        // One limb of fraction, whose top bit is the half.
        let (mut integer, _) = limbs::shift_right(&wide, (255 - self.exponent.min(254)) as u32);
        limbs::add(&mut integer, &[1 << 63, 0, 0, 0, 0]);
        integer[0] = 0;
        let low = if self.negative { integer[1].wrapping_neg() } else { integer[1] };
        (low, Real::round(self.negative, 255, &integer, false))
    }

    /// The sine of an angle below 1: `x · (1 − z/(2·3) · (1 − z/(4·5) · (…)))` with z = x².
    fn small_sine(self) -> Real {
        let square = fraction(self * self);
        let zeros = limbs::leading_zeros(&square);
        // Terms until what follows is below the last bit; 40 if the angle is 1.
        let (mut terms, mut bits) = (0_u64, 0);
        while bits < 320 {
            terms += 1;
            bits += zeros + (2 * terms * (2 * terms + 1)).ilog2();
        }
        let mut tail: Fraction = [0; 5];
        while terms > 0 {
            let product = times(&square, &tail);
            tail = square;
            limbs::subtract(&mut tail, &product);
            limbs::divide_small(&mut tail, 2 * terms * (2 * terms + 1));
            terms -= 1;
        }
        self * (Real::ONE - real(&tail))
    }
}

/// Sine and cosine after so many more quarter turns.
pub(in super::super) fn turned(quarters: u64, (sine, cosine): (Real, Real)) -> (Real, Real) {
    match quarters & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// The angle below 45° of a right triangle with `height ≤ width`; 0 if both are zero.
fn small_atan(height: Real, width: Real) -> Real {
    if height.is_zero() {
        return Real::ZERO;
    }
    // Only their proportion counts; near 1 no square leaves the range.
    let height = height.scaled(-width.exponent);
    let mut width = width.scaled(-width.exponent);
    // The bisector of the x axis and the direction (x, y) is the direction (x + √(x² + y²), y).
    let square = height * height;
    let mut i = 0;
    while i < HALVINGS {
        width = width + (width * width + square).sqrt();
        i += 1;
    }
    let tangent = height / width;
    (tangent * arc_factor(fraction(tangent * tangent))).scaled(HALVINGS as i32)
}

/// `atan(t) / t = 1 − z · (1/3 − z · (1/5 − …))` with z = t², which must be small.
fn arc_factor(square: Fraction) -> Real {
    let zeros = limbs::leading_zeros(&square).max(1);
    let mut terms = (320 / zeros) as u64 + 1;
    let mut tail: Fraction = [0; 5];
    while terms > 0 {
        let mut next: Fraction = [u64::MAX; 5];
        limbs::divide_small(&mut next, 2 * terms + 1);
        limbs::subtract(&mut next, &tail);
        tail = times(&square, &next);
        terms -= 1;
    }
    Real::ONE - real(&tail)
}

/// A real within [0, 1), cut off after 320 bits.
fn fraction(value: Real) -> Fraction {
    if value.is_zero() || value.exponent >= 0 {
        return [0; 5];
    }
    let wide = [0, value.mantissa[0], value.mantissa[1], value.mantissa[2], value.mantissa[3]];
    limbs::shift_right(&wide, (-1 - value.exponent).unsigned_abs()).0
}

/// The nearest real to a fraction.
fn real(value: &Fraction) -> Real {
    Real::round(false, -1, value, false)
}

/// The product of two fractions, cut off after 320 bits.
fn times(a: &Fraction, b: &Fraction) -> Fraction {
    let product: [u64; 10] = limbs::multiply(a, b);
    [product[5], product[6], product[7], product[8], product[9]]
}
