//! What all terms of a polynomial have in common.

use super::monomial::{Monomial, Var};
use super::poly::Poly;
use super::ring::Ring;

impl Ring {
    /// A polynomial as a product: the integer and the monomial that divide every term, and what they leave, whose first
    /// coefficient is positive. 0 is 0 times 1.
    pub fn split_content(&self, a: &Poly) -> (Poly, Poly) {
        let Some(&(_, leading)) = a.terms.first() else { return (Poly::zero(), Poly::integer(1)) };
        let divisor = a.terms.iter().fold(0, |divisor, (_, c)| gcd(divisor, c.unsigned_abs()));
        let divisor = i64::try_from(divisor).unwrap_or(1).max(1) * leading.signum();
        let mut common = Monomial::default();
        for index in 0..self.vars.len() {
            let var = Var(index as u8);
            let exponent = a.terms.iter().map(|(m, _)| m.exponent(var)).min().unwrap_or(0);
            if exponent > 0 {
                common = common.united(Monomial::of(var, u128::from(exponent)));
            }
        }
        // Every term loses the same factor, so that their order stays.
        let rest = a.terms.iter().map(|&(m, c)| (m.without(common), c / divisor)).collect();
        (Poly { terms: vec![(common, divisor)] }, Poly { terms: rest })
    }

    /// The variable of that name.
    pub fn named(&self, name: &str) -> Option<Poly> {
        let index = self.vars.iter().position(|v| v.name == name)?;
        Some(self.var(Var(index as u8)))
    }
}

fn gcd(a: u64, b: u64) -> u64 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
