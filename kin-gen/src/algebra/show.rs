//! Polynomials in the field's notation: `-c4·c5·s6 - s4·c6`.

use std::fmt;

use super::monomial::{Monomial, Var};
use super::poly::Poly;
use super::ring::Ring;

/// A polynomial that can be printed.
pub struct Shown<'a> {
    pub(super) ring: &'a Ring,
    pub(super) poly: &'a Poly,
}

/// One term of a polynomial, as it is read: what every printer of polynomials starts from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Part<'a> {
    /// Its integer coefficient.
    pub coefficient: i64,
    /// The variables by name and their exponents, constants before what varies, as reports print it: d6·c4·s5.
    pub factors: Vec<(&'a str, u32)>,
}

impl Ring {
    /// The terms of a polynomial, in its own order.
    pub fn parts(&self, poly: &Poly) -> Vec<Part<'_>> {
        let part = |&(monomial, coefficient): &(Monomial, i64)| {
            let mut factors = Vec::new();
            for wanted in [true, false] {
                for (index, info) in self.vars.iter().enumerate() {
                    let var = Var(index as u8);
                    let constant = Monomial::of(var, 1).masked(self.varying).is_one();
                    if constant == wanted && monomial.exponent(var) > 0 {
                        factors.push((info.name.as_str(), monomial.exponent(var)));
                    }
                }
            }
            Part { coefficient, factors }
        };
        poly.terms.iter().map(part).collect()
    }
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.poly.is_zero() {
            return f.write_str("0");
        }
        for (position, part) in self.ring.parts(self.poly).iter().enumerate() {
            f.write_str(match (position, part.coefficient < 0) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let mut factors: Vec<String> = Vec::new();
            if part.coefficient.unsigned_abs() != 1 || part.factors.is_empty() {
                factors.push(part.coefficient.unsigned_abs().to_string());
            }
            for (name, exponent) in &part.factors {
                factors.extend((0..*exponent).map(|_| (*name).to_owned()));
            }
            f.write_str(&factors.join("·"))?;
        }
        Ok(())
    }
}
