//! Numbers of the plain product: f64, and dual numbers that carry one exact derivative.

use std::ops::{Add, Mul, Neg, Sub};

/// What a matrix product needs.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// A constant.
    fn constant(x: f64) -> Self;
    /// The sine and the cosine.
    fn sin_cos(self) -> (Self, Self);
}

impl Number for f64 {
    fn constant(x: f64) -> f64 {
        x
    }

    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }
}

/// `value + slope·ε` with ε² = 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// The derivative.
    pub slope: f64,
}

impl Number for Dual {
    fn constant(value: f64) -> Dual {
        Dual { value, slope: 0.0 }
    }

    fn sin_cos(self) -> (Dual, Dual) {
        let (s, c) = self.value.sin_cos();
        (Dual { value: s, slope: c * self.slope }, Dual { value: c, slope: -s * self.slope })
    }
}

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        Dual { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        Dual { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual { value: -self.value, slope: -self.slope }
    }
}
