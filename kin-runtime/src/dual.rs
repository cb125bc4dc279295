//! Dual numbers: a value and its rate of change, so that what computes forward kinematics computes velocities too.
//!
//! (a + a′ε)·(b + b′ε) = ab + (a′b + ab′)ε, with ε² = 0 (W. Clifford 1873). A derivative found so is exact but for round-off.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use kin_runtime::Dual;
//!
//! /// The derivative of the Jacobian with respect to time.
//! fn rate<const N: usize>(arm: &impl Arm<N>, q: &Joints<f64, N>, velocity: &Joints<f64, N>) -> Jacobian<f64, N> {
//!     arm.jacobian(&q.zip_map(velocity, |value, rate| Dual { value, rate })).map(|entry| entry.rate)
//! }
//! ```

use crate::math::{self, Real};
use crate::pose::{self, Joints};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its rate of change.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dual<T> {
    /// The value.
    pub value: T,
    /// The derivative of the value with respect to whatever moves it.
    pub rate: T,
}

impl<T: Real> Dual<T> {
    /// A value that changes at a rate.
    pub const fn new(value: T, rate: T) -> Self {
        Self { value, rate }
    }
}

/// Joint values that move.
pub(crate) fn moving<T: Real, const N: usize>(
    q: &Joints<T, N>,
    velocity: &Joints<T, N>,
) -> Joints<Dual<T>, N> {
    let mut duals = pose::entries(q).map(|value| Dual::new(value, T::lit(0.0)));
    for (dual, rate) in duals.iter_mut().zip(pose::entries(velocity)) {
        dual.rate = rate;
    }
    pose::column(duals)
}

impl<T: Real> Add for Dual<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual::new(self.value + other.value, self.rate + other.rate)
    }
}

impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Dual::new(self.value - other.value, self.rate - other.rate)
    }
}

impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Dual::new(self.value * other.value, self.value * other.rate + self.rate * other.value)
    }
}

impl<T: Real> Div for Dual<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Dual::new(quotient, (self.rate - quotient * other.rate) / other.value)
    }
}

impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Dual::new(-self.value, -self.rate)
    }
}

impl<T: Real> Real for Dual<T> {
    fn lit(x: f64) -> Self {
        Dual::new(T::lit(x), T::lit(0.0))
    }
    fn sqrt(self) -> Self {
        let root = math::sqrt(self.value);
        Dual::new(root, self.rate / (root + root))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = math::sin_cos(self.value);
        (Dual::new(s, c * self.rate), Dual::new(c, -(s * self.rate)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    #[test]
    fn rates_are_those_of_differences() {
        let f = |x: Dual<f64>, y: Dual<f64>| {
            let ((s, c), root) = (Real::sin_cos(x * y), Real::sqrt(x * x + Dual::lit(2.0)));
            (s - c) / root + -(y / (x + Dual::lit(3.0)))
        };
        let mut random = Random(71);
        for _ in 0..1_000 {
            let [x, y, u, v] = [(); 4].map(|()| random.within(-2.0, 2.0));
            let at = |t: f64| f(Dual::new(x + t * u, 0.0), Dual::new(y + t * v, 0.0)).value;
            let found = f(Dual::new(x, u), Dual::new(y, v));
            assert!(found.value.to_bits() == at(0.0).to_bits());
            assert!((found.rate - (at(1e-5) - at(-1e-5)) / 2e-5).abs() < 1e-7, "{x} {y} {u} {v}");
        }
    }
}
