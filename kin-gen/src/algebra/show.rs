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

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.poly.is_zero() {
            return f.write_str("0");
        }
        for (position, &(monomial, coefficient)) in self.poly.terms.iter().enumerate() {
            f.write_str(match (position, coefficient < 0) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let mut factors: Vec<String> = Vec::new();
            if coefficient.unsigned_abs() != 1 || monomial.is_one() {
                factors.push(coefficient.unsigned_abs().to_string());
            }
            // Constants stand before what varies, as reports print it: d6·c4·s5.
            for wanted in [true, false] {
                for (index, info) in self.ring.vars.iter().enumerate() {
                    let constant = Monomial::of(Var(index as u8), 1).masked(self.ring.varying).is_one();
                    if constant == wanted {
                        let exponent = monomial.exponent(Var(index as u8));
                        factors.extend((0..exponent).map(|_| info.name.clone()));
                    }
                }
            }
            f.write_str(&factors.join("·"))?;
        }
        Ok(())
    }
}
