//! Exact and correctly rounded constants.
//!
//! ```text
//! Ratio   an exact rational: what a decimal in the table means
//! Real    256 bits: what sqrt, sin and cos of constants are rounded to
//! Scalar  a Ratio as long as that is possible, then a Real
//! Angle   an exact multiple of π plus radians: a quarter turn is known as one
//! ```
//!
//! Everything here is integer arithmetic: what the compiler derives must not depend on the machine it runs on.
//! Nothing panics, and every loop is bounded.

mod angle;
mod limbs;
mod ratio;
mod real;
#[cfg(test)]
mod reference;
#[cfg(test)]
mod tests;

pub use angle::Angle;
pub use ratio::Ratio;
pub use real::Real;

use std::cmp::Ordering;

/// A constant: exact as long as it is rational and fits, otherwise to 256 bits.
///
/// A [`Real`] result that is negligible becomes an exact zero, and one that ends after 64 of its 256 bits becomes
/// the ratio that it is; so `sqrt(2) * sqrt(2) - 2` is an exact zero. Equality is that of the representation, and
/// the order is by value, an exact number before a real of the same value.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Scalar {
    /// A rational number.
    Exact(Ratio),
    /// A number rounded to 256 bits.
    Real(Real),
}

#[expect(clippy::should_implement_trait, reason = "the operations are checked, which operators cannot be")]
impl Scalar {
    /// An exact zero.
    pub const fn zero() -> Scalar {
        Scalar::Exact(Ratio::ZERO)
    }

    /// An exact one.
    pub const fn one() -> Scalar {
        Scalar::Exact(Ratio::ONE)
    }

    /// Whether this is zero; of a real, whether it is negligible.
    pub fn is_zero(self) -> bool {
        match self {
            Scalar::Exact(value) => value.is_zero(),
            Scalar::Real(value) => value.is_negligible(),
        }
    }

    /// −1, 0 or 1; 0 exactly where [`Scalar::is_zero`] says so.
    pub fn signum(self) -> i32 {
        match self {
            Scalar::Exact(value) => value.signum(),
            Scalar::Real(value) if value.is_negligible() => 0,
            Scalar::Real(value) => value.signum(),
        }
    }

    /// The absolute value.
    pub fn abs(self) -> Scalar {
        if self.signum() < 0 { self.neg() } else { self }
    }

    /// The same size with the other sign.
    pub fn neg(self) -> Scalar {
        match self {
            Scalar::Exact(value) => Scalar::Exact(value.neg()),
            Scalar::Real(value) => Scalar::Real(-value),
        }
    }

    /// The sum; `None` if an exact one does not fit.
    pub fn add(self, other: Scalar) -> Option<Scalar> {
        match (self, other) {
            (Scalar::Exact(left), Scalar::Exact(right)) => left.checked_add(right).map(Scalar::Exact),
            (left, right) => Some(Scalar::from(left.to_real() + right.to_real())),
        }
    }

    /// The difference; `None` if an exact one does not fit.
    pub fn sub(self, other: Scalar) -> Option<Scalar> {
        self.add(other.neg())
    }

    /// The product; `None` if an exact one does not fit.
    pub fn mul(self, other: Scalar) -> Option<Scalar> {
        match (self, other) {
            (Scalar::Exact(left), Scalar::Exact(right)) => left.checked_mul(right).map(Scalar::Exact),
            (left, right) => Some(Scalar::from(left.to_real() * right.to_real())),
        }
    }

    /// The quotient; `None` of a division by zero, or if an exact one does not fit.
    pub fn div(self, other: Scalar) -> Option<Scalar> {
        match (self, other) {
            (_, divisor) if divisor.is_zero() => None,
            (Scalar::Exact(left), Scalar::Exact(right)) => left.checked_div(right).map(Scalar::Exact),
            (left, right) => Some(Scalar::from(left.to_real() / right.to_real())),
        }
    }

    /// The square root, exact of the square of a ratio; `None` of a negative number.
    pub fn sqrt(self) -> Option<Scalar> {
        match self {
            _ if self.signum() < 0 => None,
            _ if self.is_zero() => Some(Scalar::zero()),
            Scalar::Exact(value) => Some(match value.exact_sqrt() {
                Some(root) => Scalar::Exact(root),
                None => Scalar::Real(Real::from_ratio(value).sqrt()),
            }),
            Scalar::Real(value) => Some(Scalar::from(value.sqrt())),
        }
    }

    /// To 256 bits.
    pub fn to_real(self) -> Real {
        match self {
            Scalar::Exact(value) => Real::from_ratio(value),
            Scalar::Real(value) => value,
        }
    }

    /// The nearest double, ties to even.
    pub fn to_f64(self) -> f64 {
        // Rounding twice is safe: a ratio of 127 bits that is not halfway between two doubles is at least
        // 2^-182 of itself away from there, and the first rounding moves it by 2^-256.
        self.to_real().to_f64()
    }
}

impl Default for Scalar {
    fn default() -> Scalar {
        Scalar::zero()
    }
}

impl From<Ratio> for Scalar {
    fn from(value: Ratio) -> Scalar {
        Scalar::Exact(value)
    }
}

impl From<i64> for Scalar {
    fn from(value: i64) -> Scalar {
        Scalar::Exact(Ratio::integer(value))
    }
}

impl From<Real> for Scalar {
    /// Exact where the value is negligible or ends after 64 bits: no irrational constant has 192 zero bits there.
    fn from(value: Real) -> Scalar {
        if value.is_negligible() {
            return Scalar::zero();
        }
        value.to_short_ratio().map_or(Scalar::Real(value), Scalar::Exact)
    }
}

impl Ord for Scalar {
    fn cmp(&self, other: &Scalar) -> Ordering {
        match (self, other) {
            (Scalar::Exact(left), Scalar::Exact(right)) => left.cmp(right),
            (Scalar::Real(left), Scalar::Real(right)) => left.cmp(right),
            // Different ratios round to different reals, so that this is one order with the two above.
            (Scalar::Exact(left), Scalar::Real(right)) => {
                Real::from_ratio(*left).cmp(right).then(Ordering::Less)
            }
            (Scalar::Real(left), Scalar::Exact(right)) => {
                left.cmp(&Real::from_ratio(*right)).then(Ordering::Greater)
            }
        }
    }
}

impl PartialOrd for Scalar {
    fn partial_cmp(&self, other: &Scalar) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
