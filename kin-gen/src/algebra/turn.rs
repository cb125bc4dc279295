//! Sums of angles: the arguments of sines, fused before any sine is taken.

use crate::chain::AngleSum;
use crate::number::{Angle, Real};

/// A sum of joint values, with integer coefficients, and a constant part: the argument of a sine.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Turn {
    /// Coefficients of the commanded joint values, by joint.
    pub joints: Vec<(i64, usize)>,
    /// The constant part, and the part made of parameters.
    pub rest: AngleSum,
}

impl Turn {
    /// The constant angle.
    pub fn constant(angle: Angle) -> Turn {
        Turn { joints: Vec::new(), rest: AngleSum { constant: angle, params: Vec::new() } }
    }

    /// `self + factor·other`; `None` where the exact sum cannot be represented.
    pub fn plus(&self, other: &Turn, factor: i64) -> Option<Turn> {
        Some(Turn {
            joints: merged(&self.joints, &other.joints, factor)?,
            rest: AngleSum {
                constant: self.rest.constant.add(other.rest.constant.times(factor)?)?,
                params: merged(&self.rest.params, &other.rest.params, factor)?,
            },
        })
    }

    /// Whether nothing in it varies.
    pub fn is_constant(&self) -> bool {
        self.joints.is_empty() && self.rest.params.is_empty()
    }

    /// The first coefficient: its sign decides which of ±angle gets the sine.
    pub(super) fn leads_negative(&self) -> bool {
        match (self.joints.first(), self.rest.params.first()) {
            (Some((coefficient, _)), _) | (None, Some((coefficient, _))) => *coefficient < 0,
            (None, None) => self.rest.constant.to_real() < Real::ZERO,
        }
    }
}

/// The sum of two sorted lists of coefficients.
fn merged(a: &[(i64, usize)], b: &[(i64, usize)], factor: i64) -> Option<Vec<(i64, usize)>> {
    let mut sum = a.to_vec();
    for &(coefficient, index) in b {
        let term = coefficient.checked_mul(factor)?;
        match sum.iter_mut().find(|(_, i)| *i == index) {
            Some((c, _)) => *c = c.checked_add(term)?,
            None => sum.push((term, index)),
        }
    }
    sum.retain(|(c, _)| *c != 0);
    sum.sort_by_key(|(_, i)| *i);
    Some(sum)
}
