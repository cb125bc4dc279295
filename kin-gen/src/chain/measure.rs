//! The nominal values of distances and angles, and the reach.

use super::{AngleSum, Chain, Distance, Element, JointKind, LengthAtom, Motion};
use crate::number::{Angle, Real, Scalar};

impl Chain {
    /// The nominal value of a distance, in the declared unit.
    pub fn distance(&self, distance: &Distance) -> Scalar {
        let mut total = Scalar::zero();
        for (coefficient, atom) in &distance.0 {
            let value = match *atom {
                LengthAtom::Constant(i) => self.lengths.get(i).map(|l| l.value),
                LengthAtom::Param(i) => self.params.get(i).map(|p| p.nominal),
            };
            let value = value.unwrap_or_default();
            let term = value.mul(Scalar::from(*coefficient));
            let term = term.unwrap_or_else(|| (value.to_real() * Real::from_i64(*coefficient)).into());
            total = plus(total, term);
        }
        total
    }

    /// The nominal value of an angle, in radians.
    pub fn angle(&self, sum: &AngleSum) -> Real {
        self.nominal_angle(sum).to_real()
    }

    /// The nominal value of an angle; exact as far as it can be.
    pub(super) fn nominal_angle(&self, sum: &AngleSum) -> Angle {
        let mut total = sum.constant;
        for (coefficient, param) in &sum.params {
            let nominal = self.params.get(*param).map(|p| p.nominal).unwrap_or_default();
            let term = nominal.mul(Scalar::from(*coefficient));
            let term = term.unwrap_or_else(|| (nominal.to_real() * Real::from_i64(*coefficient)).into());
            total.rad = plus(total.rad, term);
        }
        total
    }

    /// What lengths are compared with: Σ|a| + |d| over all rows and the tool at nominal parameters, plus the travel of
    /// prismatic joints that have limits. An arm that slides and has neither lengths nor limits has no size of its own: it is
    /// measured in its unit.
    pub fn reach(&self) -> Scalar {
        let mut total = Scalar::zero();
        for Element { motion, .. } in self.elements.iter().chain(&self.tool) {
            if let Motion::Shift(distance) | Motion::Prismatic { offset: distance, .. } = motion {
                total = plus(total, self.distance(distance).abs());
            }
        }
        for joint in self.joints.iter().filter(|j| j.kind == JointKind::Prismatic) {
            if let Some((low, high)) = joint.limits {
                total = plus(total, low.abs().max(high.abs()));
            }
        }
        let slides = self.joints.iter().any(|j| j.kind == JointKind::Prismatic);
        if total.is_zero() && slides { Scalar::one() } else { total }
    }
}

/// A sum that falls back to 256 bits where the exact one would overflow.
fn plus(a: Scalar, b: Scalar) -> Scalar {
    a.add(b).unwrap_or_else(|| (a.to_real() + b.to_real()).into())
}

/// An angle in radians; rational if it does not involve π.
pub(super) fn radians(angle: Angle) -> Scalar {
    if angle.pi.is_zero() { angle.rad } else { angle.to_real().into() }
}
