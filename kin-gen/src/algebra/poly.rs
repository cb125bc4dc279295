//! Polynomials in normal form. What can be done with them without knowing the variables stands here, the rest in
//! [`super::ring`].

use super::monomial::Monomial;

/// A polynomial in normal form: terms in descending order of their monomials, no zero coefficient.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Poly {
    pub(super) terms: Vec<(Monomial, i64)>,
}

impl Poly {
    /// The polynomial 0.
    pub fn zero() -> Poly {
        Poly::default()
    }

    /// A constant integer.
    pub fn integer(value: i64) -> Poly {
        Poly { terms: if value == 0 { Vec::new() } else { vec![(Monomial::default(), value)] } }
    }

    /// Whether it is the polynomial 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value if it is 0, 1 or -1.
    pub fn as_unit(&self) -> Option<i64> {
        match self.terms.as_slice() {
            [] => Some(0),
            [(m, c)] if m.is_one() && c.abs() == 1 => Some(*c),
            _ => None,
        }
    }

    /// Whether the leading coefficient is negative.
    pub fn leads_negative(&self) -> bool {
        self.terms.first().is_some_and(|(_, c)| *c < 0)
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it has no terms.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The polynomial with all signs changed.
    pub fn neg(&self) -> Poly {
        Poly { terms: self.terms.iter().map(|&(m, c)| (m, -c)).collect() }
    }
}
