//! Numbers of an arm's geometry: exact where everything is constant, an expression where a parameter takes part.

use crate::algebra::ring::{Poly, Ring};
use crate::number::{Ratio, Real};

/// A constant plus multiples of parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct Linear {
    /// The constant part.
    pub constant: Real,
    /// Coefficients and indices of parameters.
    pub params: Vec<(Real, usize)>,
}

impl Linear {
    /// A constant.
    pub fn constant(value: Real) -> Linear {
        Linear { constant: value, params: Vec::new() }
    }

    /// A polynomial in constants and length parameters; `None` if it is not linear in these.
    pub fn of(ring: &Ring, poly: &Poly) -> Option<Linear> {
        let mut linear = Linear::constant(Real::ZERO);
        for (varying, coefficient) in ring.by_varying(poly) {
            let value = ring.value(&coefficient).to_real();
            match ring.params_in(&varying)?.as_slice() {
                [] => linear.constant = linear.constant + value,
                [index] => linear.params.push((value, *index)),
                _ => return None,
            }
        }
        // A coefficient that is an irrational zero is a zero.
        linear.params.retain(|(coefficient, _)| !coefficient.is_negligible());
        Some(linear)
    }

    /// Its value if no parameter takes part.
    pub fn as_constant(&self) -> Option<Real> {
        self.params.is_empty().then_some(self.constant)
    }

    /// Whether it is zero for every value of the parameters, up to `tolerance` in its constant part.
    pub fn vanishes(&self, tolerance: Real) -> bool {
        self.params.is_empty() && self.constant.abs() <= tolerance
    }

    /// Itself plus a constant multiple of another.
    pub fn plus(&self, other: &Linear, factor: Real) -> Linear {
        let mut sum = self.clone();
        sum.constant = sum.constant + other.constant * factor;
        for (coefficient, index) in &other.params {
            match sum.params.iter_mut().find(|(_, i)| i == index) {
                Some((c, _)) => *c = *c + *coefficient * factor,
                None => sum.params.push((*coefficient * factor, *index)),
            }
        }
        sum.params.retain(|(coefficient, _)| !coefficient.is_negligible());
        sum
    }
}

/// A number of the arm's geometry.
#[derive(Clone, PartialEq, Debug)]
pub enum Quantity {
    /// Linear in the parameters.
    Linear(Linear),
    /// The length of a planar vector, at least one of whose components has a parameter.
    Length(Linear, Linear),
    /// A linear angle plus the directions (x, y) of planar vectors, each with a sign.
    Angle(Linear, Vec<(bool, Linear, Linear)>),
    /// A constant plus the absolute values of linear forms.
    SumOfAbsolutes(Real, Vec<Linear>),
}

impl Quantity {
    /// The length of the planar vector (x, y).
    pub fn length(x: &Linear, y: &Linear) -> Quantity {
        match (x.as_constant(), y.as_constant()) {
            (Some(x), Some(y)) => Quantity::Linear(Linear::constant((x * x + y * y).sqrt())),
            _ => Quantity::Length(x.clone(), y.clone()),
        }
    }

    /// A constant angle plus the signed directions of planar vectors; constant directions are folded exactly.
    pub fn angle(rest: Linear, directions: &[(bool, Linear, Linear)]) -> Quantity {
        let mut folded = rest;
        let mut open = Vec::new();
        for (negative, x, y) in directions {
            match (x.as_constant(), y.as_constant()) {
                (Some(x), Some(y)) => {
                    let sign = Real::from_i64(if *negative { -1 } else { 1 });
                    folded = folded.plus(&Linear::constant(Real::atan2(y, x)), sign);
                }
                _ => open.push((*negative, x.clone(), y.clone())),
            }
        }
        if open.is_empty() {
            folded.constant = wrapped(folded.constant);
            Quantity::Linear(folded)
        } else {
            Quantity::Angle(folded, open)
        }
    }

    /// Its nearest double if no parameter takes part.
    pub fn as_f64(&self) -> Option<f64> {
        match self {
            Quantity::Linear(linear) => linear.as_constant().map(|r| r.to_f64()),
            Quantity::SumOfAbsolutes(constant, forms) if forms.is_empty() => Some(constant.to_f64()),
            _ => None,
        }
    }
}

/// An angle brought into (-π, π], so that the offset loses no digits.
fn wrapped(angle: Real) -> Real {
    let (pi, turn) = (Real::pi(), Real::pi() + Real::pi());
    let mut angle = angle;
    // Offsets are sums of at most a handful of angles; the bound only keeps a hostile table from looping long.
    for _ in 0..64 {
        if angle > pi {
            angle = angle - turn;
        } else if angle <= -pi {
            angle = angle + turn;
        }
    }
    angle
}

/// 64 ε of a double, 2⁻⁴⁶: what counts as parallel, and, times the reach, as the same point.
pub fn roundoff() -> Real {
    Ratio::new(1, 1 << 46).map_or(Real::ZERO, Real::from_ratio)
}
