//! Monomials: the exponents of all variables of a ring, packed.

use super::ring::MAX_VARS;

/// A variable: an index into the ring's table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Var(pub u8);

/// Words of a monomial, each with the exponents of 32 variables.
const WORDS: usize = MAX_VARS / 32;

/// Exponents 0 to 15 of all variables, packed; the first variable in the highest bits, so that the order of the
/// integers is the lexicographic order of the monomials.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub(super) struct Monomial([u128; WORDS]);

/// The highest bit of each exponent.
const HIGH_BITS: u128 = u128::MAX / 15 * 8;

impl Monomial {
    pub(super) fn of(var: Var, exponent: u128) -> Monomial {
        let mut words = [0; WORDS];
        words[usize::from(var.0) / 32 % WORDS] = exponent << (124 - 4 * (usize::from(var.0) % 32));
        Monomial(words)
    }

    pub(super) fn exponent(self, var: Var) -> u32 {
        ((self.0[usize::from(var.0) / 32 % WORDS] >> (124 - 4 * (usize::from(var.0) % 32))) & 15) as u32
    }

    /// The product, or `None` if an exponent would exceed 15.
    pub(super) fn times(self, other: Monomial) -> Option<Monomial> {
        let mut words = [0; WORDS];
        for ((word, a), b) in words.iter_mut().zip(self.0).zip(other.0) {
            let sum = a.wrapping_add(b);
            let carries = (a & b) | ((a | b) & !sum);
            if carries & HIGH_BITS != 0 {
                return None;
            }
            *word = sum;
        }
        Some(Monomial(words))
    }

    /// Without the given exponents, which must be present.
    pub(super) fn without(self, other: Monomial) -> Monomial {
        self.zip(other, |a, b| a - b)
    }

    pub(super) fn masked(self, mask: Monomial) -> Monomial {
        self.zip(mask, |a, b| a & b)
    }

    pub(super) fn united(self, other: Monomial) -> Monomial {
        self.zip(other, |a, b| a | b)
    }

    fn zip(mut self, other: Monomial, combine: impl Fn(u128, u128) -> u128) -> Monomial {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = combine(*a, b);
        }
        self
    }

    pub(super) fn is_one(self) -> bool {
        self.0 == [0; WORDS]
    }

    /// The first variable whose exponent has one of the bits set that are set here.
    pub(super) fn first(self) -> Option<Var> {
        let word = self.0.iter().position(|w| *w != 0)?;
        Some(Var((32 * word + self.0[word].leading_zeros() as usize / 4) as u8))
    }
}
