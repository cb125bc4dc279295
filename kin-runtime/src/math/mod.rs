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
//! wrap                  angles in (-π, π]
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
mod wrap;

pub use lanes::Lanes;
pub(crate) use root::VISIBLE as ROOT_IS_VISIBLE;
pub use wrap::{half_turn, wrap, wrap_all};
pub(crate) use wrap::{without_minus_half, wrap_down, wrap_up};

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
        for (angle, x) in angles.iter_mut().zip(x) {
            *angle = Float::atan2(*angle, x);
        }
        angles
    }
    /// Sine and cosine without a branch: the bits of [`sin_cos`](Real::sin_cos) for angles of less than a thousand turns and
    /// NaN for NaN; of others, nothing of meaning.
    #[doc(hidden)]
    #[inline(always)]
    fn sin_cos_straight(x: Self) -> (Self, Self) {
        Real::sin_cos(x)
    }
    /// The angle of the plane vector (x, y) without a branch: the bits of [`atan2`](Float::atan2) where |x| + |y| is a number
    /// and not zero, NaN for NaN and for the zero vector; of others, nothing of meaning. And what rounding took off the angle, as
    /// far as it is known: the sum is the angle to less than ε/2.
    #[doc(hidden)]
    #[inline(always)]
    fn atan2_straight(y: Self, x: Self) -> (Self, Self) {
        (Float::atan2(y, x), Self::lit(0.0))
    }
    /// As [`atan2_straight`](Float::atan2_straight), of a y that is not negative and not -0.
    #[doc(hidden)]
    #[inline(always)]
    fn atan2_above(y: Self, x: Self) -> (Self, Self) {
        Self::atan2_straight(y, x)
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
    fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        angle::atan2_lanes(y, x)
    }
    #[inline(always)]
    fn sin_cos_straight(x: Self) -> (Self, Self) {
        sine::straight(x)
    }
    #[inline(always)]
    fn atan2_straight(y: Self, x: Self) -> (Self, Self) {
        angle::straight(y, x)
    }
    #[inline(always)]
    fn atan2_above(y: Self, x: Self) -> (Self, Self) {
        angle::above(y, x)
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
    #[inline(always)]
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

/// An angle in single precision, and what rounding took off it.
#[inline(always)]
fn narrow_angle((angle, _): (f64, f64)) -> (f32, f32) {
    let rounded = angle as f32;
    (rounded, (angle - f64::from(rounded)) as f32)
}

impl Float for f32 {
    const EPS: Self = f32::EPSILON;
    const TURN: (Self, Self) = (core::f32::consts::TAU, -1.748_455_6e-7);
    fn atan2(y: Self, x: Self) -> Self {
        angle::atan2(f64::from(y), f64::from(x)) as f32
    }
    #[inline]
    fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        narrow(angle::atan2_lanes(wide(y), wide(x)))
    }
    #[inline(always)]
    fn sin_cos_straight(x: Self) -> (Self, Self) {
        let (sine, cosine) = sine::straight(f64::from(x));
        (sine as f32, cosine as f32)
    }
    #[inline(always)]
    fn atan2_straight(y: Self, x: Self) -> (Self, Self) {
        narrow_angle(angle::straight(f64::from(y), f64::from(x)))
    }
    #[inline(always)]
    fn atan2_above(y: Self, x: Self) -> (Self, Self) {
        narrow_angle(angle::above(f64::from(y), f64::from(x)))
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
