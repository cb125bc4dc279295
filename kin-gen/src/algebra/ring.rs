//! The normal form in which equality is decided.
//!
//! A polynomial over the integers in these variables: each constant length and each length parameter, the cosine and
//! sine of each constant angle that is no multiple of a quarter turn, of each angle parameter and of each revolute
//! joint, the value of each prismatic joint, and the entries of a given pose. The one relation, s² = 1 - c² for each
//! pair, is applied as soon as a square of a sine appears, so that a polynomial has one form only: two functions of
//! the joints are equal when their forms are.

use std::cell::Cell;
use std::cmp::Reverse;

use super::monomial::Monomial;
pub use super::monomial::Var;
pub use super::poly::Poly;
use super::show::Shown;
use crate::number::{Angle, Real, Scalar};

/// Most variables of one ring; four bits of exponent for each.
pub const MAX_VARS: usize = 128;

/// What a variable stands for.
#[derive(Clone, PartialEq, Debug)]
pub enum VarKind {
    /// A constant.
    Constant,
    /// The cosine (then the next variable is the sine) of a constant angle.
    ConstantPair(Angle),
    /// The cosine (then the next variable is the sine) of something that varies.
    Pair,
    /// The same, of an angle parameter, by its index.
    ParamPair(usize),
    /// The sine that belongs to the variable before it.
    Sine,
    /// A length parameter, by its index.
    Param(usize),
    /// Anything else that varies.
    Free,
}

#[derive(Clone, Debug)]
pub(super) struct VarInfo {
    pub(super) name: String,
    kind: VarKind,
    /// The value, of a constant.
    value: Option<Scalar>,
}

/// A parameter as a factor of a monomial.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Factor {
    /// A length parameter, by its index.
    Length(usize),
    /// The cosine of an angle parameter.
    Cosine(usize),
    /// The sine of an angle parameter.
    Sine(usize),
}

/// The variables and the work done so far. A result is trustworthy only while [`Ring::exhausted`] is false.
#[derive(Clone, Debug, Default)]
pub struct Ring {
    pub(super) vars: Vec<VarInfo>,
    /// The second bit of each sine's exponent: set in a product exactly when that sine is squared.
    pub(super) sine_squares: Monomial,
    /// All exponent bits of each variable that varies.
    pub(super) varying: Monomial,
    pub(super) work: Cell<u64>,
    /// Whether the work is not limited.
    pub(super) unbounded: bool,
    pub(super) exhausted: Cell<bool>,
}

impl Ring {
    /// A ring without variables.
    pub fn new() -> Ring {
        Ring::default()
    }

    /// A ring without variables whose work is not limited.
    pub fn unbounded() -> Ring {
        Ring { unbounded: true, ..Ring::default() }
    }

    /// Whether some result was too large to be represented: nothing computed since may be used.
    pub fn exhausted(&self) -> bool {
        self.exhausted.get()
    }

    /// Term products so far: the measure of the proof's cost.
    pub fn work(&self) -> u64 {
        self.work.get()
    }

    /// Gives up: nothing that this ring says may be believed any more.
    pub fn exhaust(&self) {
        self.exhausted.set(true);
    }

    fn push(&mut self, name: String, kind: VarKind, value: Option<Scalar>) -> Var {
        if self.vars.len() >= MAX_VARS {
            self.exhausted.set(true);
            return Var(0);
        }
        let var = Var(self.vars.len() as u8);
        if kind == VarKind::Sine {
            self.sine_squares = self.sine_squares.united(Monomial::of(var, 2));
        }
        if value.is_none() {
            self.varying = self.varying.united(Monomial::of(var, 15));
        }
        self.vars.push(VarInfo { name, kind, value });
        var
    }

    /// A new constant with its value.
    pub fn constant(&mut self, name: impl Into<String>, value: Scalar) -> Var {
        self.push(name.into(), VarKind::Constant, Some(value))
    }

    /// A new variable.
    pub fn free(&mut self, name: impl Into<String>) -> Var {
        self.push(name.into(), VarKind::Free, None)
    }

    /// A new variable that is a length parameter.
    pub fn param(&mut self, name: impl Into<String>, index: usize) -> Var {
        self.push(name.into(), VarKind::Param(index), None)
    }

    /// The name of a length parameter.
    pub fn param_name(&self, index: usize) -> String {
        let info = self.vars.iter().find(|v| v.kind == VarKind::Param(index));
        info.map_or_else(String::new, |v| v.name.clone())
    }

    /// The length parameters in the first monomial, each as often as its exponent says; `None` if anything else that
    /// varies is in it.
    pub fn params_in(&self, a: &Poly) -> Option<Vec<usize>> {
        let factors = self.factors_in(a)?.into_iter();
        factors.map(|f| if let Factor::Length(index) = f { Some(index) } else { None }).collect()
    }

    /// The parameters in the first monomial, each as often as its exponent says; `None` if anything else that varies is
    /// in it.
    pub fn factors_in(&self, a: &Poly) -> Option<Vec<Factor>> {
        let mut found = Vec::new();
        let Some((monomial, _)) = a.terms.first() else { return Some(found) };
        for (position, info) in self.vars.iter().enumerate() {
            let exponent = monomial.exponent(Var(position as u8));
            if exponent == 0 || info.value.is_some() {
                continue;
            }
            let before = position.checked_sub(1).map(|i| &self.vars[i].kind);
            let factor = match (&info.kind, before) {
                (VarKind::Param(index), _) => Factor::Length(*index),
                (VarKind::ParamPair(index), _) => Factor::Cosine(*index),
                (VarKind::Sine, Some(VarKind::ParamPair(index))) => Factor::Sine(*index),
                _ => return None,
            };
            found.extend((0..exponent).map(|_| factor));
        }
        Some(found)
    }

    /// A new (cosine, sine) pair of an angle parameter.
    pub fn param_pair(&mut self, name: &str, index: usize) -> (Var, Var) {
        let cos = self.push(format!("c_{name}"), VarKind::ParamPair(index), None);
        (cos, self.push(format!("s_{name}"), VarKind::Sine, None))
    }

    /// A new (cosine, sine) pair of something that varies, named `c…` and `s…`.
    pub fn pair(&mut self, suffix: &str) -> (Var, Var) {
        let cos = self.push(format!("c{suffix}"), VarKind::Pair, None);
        (cos, self.push(format!("s{suffix}"), VarKind::Sine, None))
    }

    /// Cosine and sine of a constant angle: exact for quarter turns, else the pair of that angle, made on first use.
    pub fn constant_pair(&mut self, angle: Angle) -> (Poly, Poly) {
        if let Some(quarters) = angle.quarters() {
            let (c, s) = [(1, 0), (0, 1), (-1, 0), (0, -1)][usize::from(quarters.rem_euclid(4) as u8)];
            return (Poly::integer(c), Poly::integer(s));
        }
        // Angles of opposite sign share a pair.
        let positive = angle.to_real() > Real::ZERO;
        let key = if positive { angle } else { angle.neg() };
        let known = self.vars.iter().position(|v| v.kind == VarKind::ConstantPair(key));
        let index = match known {
            Some(index) => index,
            None => {
                let count = self.vars.iter().filter(|v| matches!(v.kind, VarKind::ConstantPair(_))).count();
                let suffix = format!("φ{}", count + 1);
                let (sin, cos) = key.sin_cos();
                let var = self.push(format!("c{suffix}"), VarKind::ConstantPair(key), Some(cos.into()));
                self.push(format!("s{suffix}"), VarKind::Sine, Some(sin.into()));
                usize::from(var.0)
            }
        };
        let (cos, sin) = (self.var(Var(index as u8)), self.var(Var(index as u8 + 1)));
        (cos, if positive { sin } else { sin.neg() })
    }

    /// Whether it is a multiple of one constant that is no cosine or sine.
    pub fn is_length(&self, a: &Poly) -> bool {
        let [(monomial, _)] = a.terms.as_slice() else { return false };
        let mut factors = self.vars.iter().enumerate().filter(|(i, _)| monomial.exponent(Var(*i as u8)) > 0);
        let only = factors.next().is_some_and(|(_, info)| info.kind == VarKind::Constant);
        only && factors.next().is_none()
    }

    /// The polynomial that is this variable.
    pub fn var(&self, var: Var) -> Poly {
        Poly { terms: vec![(Monomial::of(var, 1), 1)] }
    }

    /// A variable's name.
    pub fn name(&self, var: Var) -> &str {
        self.vars.get(usize::from(var.0)).map_or("", |v| &v.name)
    }

    /// Whether no variable occurs that varies.
    pub fn is_constant(&self, a: &Poly) -> bool {
        a.terms.iter().all(|(m, _)| m.masked(self.varying).is_one())
    }

    /// The parts of `a` by what varies: (the varying factors as a polynomial, its constant coefficient).
    pub fn by_varying(&self, a: &Poly) -> Vec<(Poly, Poly)> {
        let mut parts: Vec<(Monomial, Poly)> = Vec::new();
        for &(m, c) in &a.terms {
            let varying = m.masked(self.varying);
            let constant = (m.without(varying), c);
            match parts.iter_mut().find(|(key, _)| *key == varying) {
                Some((_, poly)) => poly.terms.push(constant),
                None => parts.push((varying, Poly { terms: vec![constant] })),
            }
        }
        parts
            .into_iter()
            .map(|(key, mut poly)| {
                poly.terms.sort_unstable_by_key(|term| Reverse(term.0));
                (Poly { terms: vec![(key, 1)] }, poly)
            })
            .collect()
    }

    /// The value of a polynomial in which nothing varies; what varies counts as 0.
    pub fn value(&self, a: &Poly) -> Scalar {
        let mut sum = Scalar::zero();
        for &(m, c) in &a.terms {
            if !m.masked(self.varying).is_one() {
                continue;
            }
            let mut product = Scalar::Exact(crate::number::Ratio::integer(c));
            for (index, info) in self.vars.iter().enumerate() {
                let exponent = m.exponent(Var(index as u8));
                if let (1.., Some(value)) = (exponent, info.value) {
                    product = (0..exponent).fold(product, |product, _| times(product, value));
                }
            }
            sum = plus(sum, product);
        }
        sum
    }

    /// Whether `a` is the zero function: no terms, or, for each varying monomial, a coefficient whose exact value is 0
    /// (two lengths of equal value cancel).
    pub fn vanishes(&self, a: &Poly) -> bool {
        a.is_zero() || self.by_varying(a).iter().all(|(_, coefficient)| self.value(coefficient).is_zero())
    }

    /// The polynomial as text, in the field's names: `-c4·c5·s6 - s4·c6`.
    pub fn show<'a>(&'a self, poly: &'a Poly) -> Shown<'a> {
        Shown { ring: self, poly }
    }
}

/// The exact product where it can be represented, else the product to 256 bits.
fn times(a: Scalar, b: Scalar) -> Scalar {
    a.mul(b).unwrap_or_else(|| Scalar::Real(a.to_real() * b.to_real()))
}

/// The exact sum where it can be represented, else the sum to 256 bits.
fn plus(a: Scalar, b: Scalar) -> Scalar {
    a.add(b).unwrap_or_else(|| Scalar::Real(a.to_real() + b.to_real()))
}
