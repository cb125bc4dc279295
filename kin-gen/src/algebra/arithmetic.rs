//! Sums, products and derivatives of polynomials: each result in normal form, the work counted.

use std::cmp::{Ordering, Reverse};

use super::monomial::Monomial;
use super::poly::Poly;
use super::ring::{Ring, Var};

/// Most term products of one derivation: beyond it the proof would take a minute in an unoptimised macro.
const WORK_LIMIT: u64 = 3_000_000;

impl Ring {
    /// The sum.
    pub fn add(&self, a: &Poly, b: &Poly) -> Poly {
        self.combine(a, b, 1)
    }

    /// The difference.
    pub fn sub(&self, a: &Poly, b: &Poly) -> Poly {
        self.combine(a, b, -1)
    }

    fn combine(&self, a: &Poly, b: &Poly, sign: i64) -> Poly {
        let mut terms = Vec::with_capacity(a.terms.len() + b.terms.len());
        let (mut left, mut right) = (a.terms.as_slice(), b.terms.as_slice());
        loop {
            match (left, right) {
                ([], rest) => {
                    terms.extend(rest.iter().map(|&(m, c)| (m, c * sign)));
                    break;
                }
                (rest, []) => {
                    terms.extend_from_slice(rest);
                    break;
                }
                ([(ml, cl), more_left @ ..], [(mr, cr), more_right @ ..]) => match ml.cmp(mr) {
                    Ordering::Greater => {
                        terms.push((*ml, *cl));
                        left = more_left;
                    }
                    Ordering::Less => {
                        terms.push((*mr, cr * sign));
                        right = more_right;
                    }
                    Ordering::Equal => {
                        let sum = self.checked(cl.checked_add(cr * sign));
                        if sum != 0 {
                            terms.push((*ml, sum));
                        }
                        (left, right) = (more_left, more_right);
                    }
                },
            }
        }
        Poly { terms }
    }

    fn checked(&self, value: Option<i64>) -> i64 {
        // i64::MIN cannot be negated, so it counts as an overflow too.
        value.filter(|v| *v != i64::MIN).unwrap_or_else(|| {
            self.exhausted.set(true);
            0
        })
    }

    /// The product.
    pub fn mul(&self, a: &Poly, b: &Poly) -> Poly {
        let work = self.work.get() + (a.terms.len() * b.terms.len()) as u64;
        self.work.set(work);
        if work > WORK_LIMIT && !self.unbounded {
            self.exhausted.set(true);
        }
        if self.exhausted.get() {
            return Poly::zero();
        }
        let mut terms = Vec::with_capacity(a.terms.len() * b.terms.len());
        let mut reduced = false;
        for &(ma, ca) in &a.terms {
            for &(mb, cb) in &b.terms {
                let coefficient = self.checked(ca.checked_mul(cb));
                let Some(monomial) = ma.times(mb) else {
                    self.exhausted.set(true);
                    return Poly::zero();
                };
                reduced |= !monomial.masked(self.sine_squares).is_one();
                self.push_reduced(&mut terms, monomial, coefficient);
            }
        }
        // Multiplying by one monomial keeps the order of the other factor.
        if reduced || (a.terms.len() > 1 && b.terms.len() > 1) {
            terms.sort_unstable_by_key(|term| Reverse(term.0));
            self.merge(&mut terms);
        }
        Poly { terms }
    }

    /// Pushes a term, with s² = 1 - c² applied to each squared sine in it.
    fn push_reduced(&self, terms: &mut Vec<(Monomial, i64)>, monomial: Monomial, coefficient: i64) {
        let Some(sine) = monomial.masked(self.sine_squares).first() else {
            terms.push((monomial, coefficient));
            return;
        };
        let rest = monomial.without(Monomial::of(sine, 2));
        self.push_reduced(terms, rest, coefficient);
        match rest.times(Monomial::of(Var(sine.0 - 1), 2)) {
            Some(cosine) => self.push_reduced(terms, cosine, -coefficient),
            None => self.exhausted.set(true),
        }
    }

    fn merge(&self, terms: &mut Vec<(Monomial, i64)>) {
        let mut kept = 0;
        for i in 0..terms.len() {
            let (monomial, coefficient) = terms[i];
            if kept > 0 && terms[kept - 1].0 == monomial {
                terms[kept - 1].1 = self.checked(terms[kept - 1].1.checked_add(coefficient));
            } else {
                if kept > 0 && terms[kept - 1].1 == 0 {
                    kept -= 1;
                }
                terms[kept] = (monomial, coefficient);
                kept += 1;
            }
        }
        if kept > 0 && terms[kept - 1].1 == 0 {
            kept -= 1;
        }
        terms.truncate(kept);
    }

    /// The integer multiple.
    pub fn scale(&self, a: &Poly, factor: i64) -> Poly {
        self.mul(a, &Poly::integer(factor))
    }

    /// The derivative by an angle whose cosine is `cos` (and whose sine is the next variable).
    pub fn derivative_by_angle(&self, a: &Poly, cos: Var) -> Poly {
        let sin = Var(cos.0 + 1);
        let by_cos = self.derivative(a, cos);
        let by_sin = self.derivative(a, sin);
        self.sub(&self.mul(&by_sin, &self.var(cos)), &self.mul(&by_cos, &self.var(sin)))
    }

    /// The partial derivative by one variable.
    pub fn derivative(&self, a: &Poly, var: Var) -> Poly {
        let one = Monomial::of(var, 1);
        let mut terms: Vec<(Monomial, i64)> = a
            .terms
            .iter()
            .filter(|(m, _)| m.exponent(var) > 0)
            .map(|&(m, c)| (m.without(one), self.checked(c.checked_mul(i64::from(m.exponent(var))))))
            .collect();
        terms.sort_unstable_by_key(|term| Reverse(term.0));
        Poly { terms }
    }

    /// `a` as A·v + C with neither A nor C in v; `None` if v occurs in a higher power.
    pub fn split(&self, a: &Poly, var: Var) -> Option<[Poly; 2]> {
        let one = Monomial::of(var, 1);
        let mut parts: [Poly; 2] = Default::default();
        for &(m, c) in &a.terms {
            match m.exponent(var) {
                0 => parts[1].terms.push((m, c)),
                1 => parts[0].terms.push((m.without(one), c)),
                _ => return None,
            }
        }
        // What all have lost in common leaves their order as it was.
        Some(parts)
    }

    /// `a` as A·cos + B·sin + C with neither in A, B and C; `None` if there are products of them.
    pub fn split_by_angle(&self, a: &Poly, cos: Var) -> Option<[Poly; 3]> {
        let [by_cos, rest] = self.split(a, cos)?;
        let [mixed, by_cos] = self.split(&by_cos, Var(cos.0 + 1))?;
        let [by_sin, rest] = self.split(&rest, Var(cos.0 + 1))?;
        mixed.is_zero().then_some([by_cos, by_sin, rest])
    }
}
