//! Numbers: the only module that calls a transcendental function.
//!
//! Sines, cosines and arctangents are our own, in + − × ÷ of doubles and integers, without a fused multiply-add: the same
//! input gives the same bits on every target, one at a time or side by side. Measured over 10⁸ samples, sines and cosines
//! are at most one double away from the correctly rounded value, arctangents at most two (`cargo run --release -p tests
//! --bin trig`). Single precision is double precision rounded. Roots are those of IEEE 754, correctly rounded everywhere.
//!
//! ```text
//! sine ◄ remainder      sine and cosine; what is left of a huge angle
//! angle                 the angle of a plane vector
//! root                  square roots
//! lanes                 many numbers as one
//! ```
//!
//! [`Float`] includes nalgebra's `RealField`, which has methods of the same names. Inside this crate the free
//! functions of this module are used, so that it is always plain which of the two is meant.

mod angle;
mod lanes;
mod remainder;
mod root;
mod sine;

pub use lanes::Lanes;

use core::fmt::LowerExp;
use core::ops::{Add, Div, Mul, Neg, Sub};
use nalgebra::{ComplexField, RealField, Scalar};

/// What forward kinematics needs of a number: field operations, a square root, sine and cosine. It has no order,
/// so that a bundle of lanes can be a `Real`.
pub trait Real:
    Scalar
    + Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to `x`.
    fn lit(x: f64) -> Self;
    /// The square root, correctly rounded; NaN for negative numbers.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The sines and the cosines of several angles: the bits of [`sin_cos`](Real::sin_cos), in less time where the
    /// type can have them side by side.
    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sines, mut cosines) = (angles, angles);
        for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
            (*sine, *cosine) = Real::sin_cos(*sine);
        }
        (sines, cosines)
    }
    /// The same of angles that stand side by side already, as lanes do: with the caller's instructions.
    #[inline(always)]
    fn sin_cos_lanes<const L: usize>(angles: [Self; L]) -> ([Self; L], [Self; L]) {
        Self::sin_cos_all(angles)
    }
}

/// What inverse kinematics needs besides: an order and an arctangent. Implemented for `f32` and `f64`.
pub trait Float: Real + PartialOrd + RealField + LowerExp {
    /// The distance from 1 to the next larger number; every round-off window is a multiple of it.
    const EPS: Self;
    /// One turn, 2π, as the nearest number and what that rounding left over.
    const TURN: (Self, Self);
    /// The angle of the plane vector (x, y), in [-π, π]; 0 for the zero vector.
    fn atan2(y: Self, x: Self) -> Self;
    /// The angles of several plane vectors: the bits of [`atan2`](Float::atan2), in less time where the type can have
    /// them side by side.
    #[inline]
    fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        let mut angles = y;
        Self::atan2_each(&mut angles, &x);
        angles
    }
    /// Replaces each `y` by the angle of the plane vector (x, y), as [`atan2`](Float::atan2); what has no `x` stays.
    #[inline]
    fn atan2_each(y: &mut [Self], x: &[Self]) {
        for (y, x) in y.iter_mut().zip(x) {
            *y = Float::atan2(*y, *x);
        }
    }
    /// The absolute value: the same number without its sign.
    fn abs(self) -> Self;
    /// √(x² + y²) without overflow on the way.
    fn hypot(x: Self, y: Self) -> Self;
    /// The largest whole number not above `self`.
    fn floor(self) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        root::double(self)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        sine::sin_cos(self)
    }
    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        sine::sin_cos_all(angles)
    }
    #[inline(always)]
    fn sin_cos_lanes<const L: usize>(angles: [Self; L]) -> ([Self; L], [Self; L]) {
        sine::sin_cos_lanes(angles)
    }
}

impl Float for f64 {
    const EPS: Self = f64::EPSILON;
    const TURN: (Self, Self) = (core::f64::consts::TAU, 2.449_293_598_294_706_4e-16);
    fn atan2(y: Self, x: Self) -> Self {
        angle::atan2(y, x)
    }
    #[inline(always)]
    fn atan2_each(y: &mut [Self], x: &[Self]) {
        angle::atan2_each(y, x);
    }
    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline]
    fn hypot(x: Self, y: Self) -> Self {
        libm::hypot(x, y)
    }
    fn floor(self) -> Self {
        libm::floor(self)
    }
}

impl Real for f32 {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        x as f32
    }
    #[inline]
    fn sqrt(self) -> Self {
        root::single(self)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = sine::sin_cos(f64::from(self));
        (s as f32, c as f32)
    }
    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = sine::sin_cos_all(wide(angles));
        (narrow(sines), narrow(cosines))
    }
    #[inline(always)]
    fn sin_cos_lanes<const L: usize>(angles: [Self; L]) -> ([Self; L], [Self; L]) {
        let (sines, cosines) = sine::sin_cos_lanes(wide(angles));
        (narrow(sines), narrow(cosines))
    }
}

/// In double precision. A loop and not `map`, which is not always inlined: here it must be, for the instructions of the caller.
#[inline(always)]
fn wide<const L: usize>(numbers: [f32; L]) -> [f64; L] {
    let mut wide = [0.0; L];
    for (wide, number) in wide.iter_mut().zip(numbers) {
        *wide = f64::from(number);
    }
    wide
}

/// In single precision, rounded.
#[inline(always)]
fn narrow<const L: usize>(numbers: [f64; L]) -> [f32; L] {
    let mut narrow = [0.0; L];
    for (narrow, number) in narrow.iter_mut().zip(numbers) {
        *narrow = number as f32;
    }
    narrow
}

impl Float for f32 {
    const EPS: Self = f32::EPSILON;
    const TURN: (Self, Self) = (core::f32::consts::TAU, -1.748_455_6e-7);
    fn atan2(y: Self, x: Self) -> Self {
        angle::atan2(f64::from(y), f64::from(x)) as f32
    }
    #[inline]
    fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        let mut angles = wide(y);
        angle::atan2_each(&mut angles, &wide(x));
        narrow(angles)
    }
    #[inline]
    fn abs(self) -> Self {
        f32::abs(self)
    }
    fn hypot(x: Self, y: Self) -> Self {
        libm::hypotf(x, y)
    }
    fn floor(self) -> Self {
        libm::floorf(self)
    }
}

/// The square root, correctly rounded; NaN for negative numbers.
#[inline(always)]
pub fn sqrt<T: Real>(x: T) -> T {
    Real::sqrt(x)
}

/// The square root of a number that is negative by round-off alone: those give 0.
#[inline(always)]
pub fn sqrt_or_zero<T: Float>(x: T) -> T {
    if x > T::lit(0.0) { Real::sqrt(x) } else { T::lit(0.0) }
}

/// Sine and cosine of an angle in radians.
pub fn sin_cos<T: Real>(x: T) -> (T, T) {
    Real::sin_cos(x)
}

/// The angle of the plane vector (x, y), in [-π, π]; 0 for the zero vector.
pub fn atan2<T: Float>(y: T, x: T) -> T {
    Float::atan2(y, x)
}

/// Sines and cosines side by side, each with the bits that it has alone.
#[inline]
pub fn sin_cos_lanes<const L: usize>(angles: [f64; L]) -> ([f64; L], [f64; L]) {
    sine::sin_cos_lanes(angles)
}

/// The angles of plane vectors (x, y) side by side, each with the bits that it has alone.
#[inline]
pub fn atan2_lanes<const L: usize>(y: [f64; L], x: [f64; L]) -> [f64; L] {
    Float::atan2_all(y, x)
}

/// √(x² + y²) without overflow on the way.
pub fn hypot<T: Float>(x: T, y: T) -> T {
    Float::hypot(x, y)
}

/// The absolute value.
#[inline(always)]
pub fn abs<T: Float>(x: T) -> T {
    Float::abs(x)
}

/// The larger of two numbers; the second if they have no order.
#[inline(always)]
pub fn max<T: Float>(x: T, y: T) -> T {
    if x > y { x } else { y }
}

/// The smaller of two numbers; the second if they have no order.
#[inline(always)]
pub fn min<T: Float>(x: T, y: T) -> T {
    if x < y { x } else { y }
}

/// Whether a number is neither infinite nor NaN.
pub fn is_finite<T: Float>(x: T) -> bool {
    ComplexField::is_finite(&x)
}

/// Whether a number is not a number: the only value that is not at least, and not at most, itself.
pub fn is_nan<T: Float>(x: T) -> bool {
    x.partial_cmp(&x).is_none()
}

/// Half a turn, π rounded.
#[inline(always)]
pub fn half_turn<T: Float>() -> T {
    T::TURN.0 * T::lit(0.5)
}

/// The same angle in (-π, π].
///
/// The turn is taken off in two parts, so that an angle within a few turns keeps its last bit. An angle of more
/// than a million turns has no meaningful last bits; it still gives a value of the range. NaN and infinities give NaN.
pub fn wrap<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    if angle > -half && angle <= half {
        return angle;
    }
    let turns = Float::floor((angle + half) / T::TURN.0);
    if abs(turns) >= T::lit(1e6) || is_nan(turns) {
        let (s, c) = Real::sin_cos(angle);
        return into_range(Float::atan2(s, c));
    }
    into_range((angle - turns * T::TURN.0) - turns * T::TURN.1)
}

/// The same angles in (-π, π], side by side.
#[inline(always)]
pub fn wrap_all<T: Float, const L: usize>(angles: [T; L]) -> [T; L] {
    if in_range(&angles) { angles } else { wrapped(angles) }
}

/// As [`wrap_all`], where it has something to do.
#[inline(never)]
fn wrapped<T: Float, const L: usize>(mut angles: [T; L]) -> [T; L] {
    let all = angles;
    for angle in &mut angles {
        *angle = within_a_turn(*angle);
    }
    if !in_range(&angles) {
        for (angle, from) in angles.iter_mut().zip(all) {
            *angle = wrap(from);
        }
    }
    angles
}

/// Whether all angles are in (-π, π]; without an early return, which is a branch for each lane.
#[inline(always)]
fn in_range<T: Float, const L: usize>(angles: &[T; L]) -> bool {
    let half = half_turn::<T>();
    let mut all = true;
    for angle in angles {
        all &= (*angle > -half) & (*angle <= half);
    }
    all
}

/// The same angle in (-π, π], if it is within a turn and a half: as [`into_range`], without a branch.
#[inline(always)]
fn within_a_turn<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    let (back, forth) = ((angle - T::TURN.0) - T::TURN.1, (angle + T::TURN.0) + T::TURN.1);
    let back = if back > -half { back } else { half };
    let forth = if forth <= half { forth } else { half };
    let least = if angle <= -half { forth } else { angle };
    if angle > half { back } else { least }
}

/// Puts an angle that round-off left at or just beyond the ends of (-π, π] back into it.
fn into_range<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    if angle > half {
        let back = (angle - T::TURN.0) - T::TURN.1;
        if back > -half { back } else { half }
    } else if angle <= -half {
        let back = (angle + T::TURN.0) + T::TURN.1;
        if back <= half { back } else { half }
    } else {
        angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn wrapping_keeps_the_angle_and_its_range() {
        for k in -40..=40 {
            let x = 0.1 * f64::from(k);
            let y = wrap(x);
            assert!(y > -PI && y <= PI);
            assert!((libm::sin(x) - libm::sin(y)).abs() < 1e-15);
            assert!((libm::cos(x) - libm::cos(y)).abs() < 1e-15);
        }
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(PI), PI);
        // 10 - 4π to the last bit, though 4π is not a double.
        assert_eq!(wrap(10.0), -2.566_370_614_359_173);
        assert!(wrap(f64::NAN).is_nan() && wrap(f64::INFINITY).is_nan());
        let (half, mut bits) = (core::f32::consts::PI, 1_u32);
        for _ in 0..1_000_000 {
            bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let y = wrap(f32::from_bits(bits));
            assert!(y.is_nan() || (y > -half && y <= half));
        }
    }

    #[test]
    fn the_turn_is_two_pi_in_two_parts() {
        assert!((f64::from(f32::TURN.0) + f64::from(f32::TURN.1) - 2.0 * PI).abs() < 1e-13);
        // sin(2π rounded) = -(what is left), to full precision
        assert!((libm::sin(f64::TURN.0) + f64::TURN.1).abs() < 1e-30);
    }
}
