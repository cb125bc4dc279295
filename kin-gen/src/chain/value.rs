//! The value of an expression: a typed constant, plus multiples of the joint variable and of parameters.

use crate::decl::{AngleUnit, LengthUnit};
use crate::number::{Angle, Ratio, Scalar};

/// The constant part of a value.
#[derive(Clone, Debug)]
pub(super) enum Constant {
    /// Nothing was said yet: a joint variable or untyped parameter alone takes any type.
    Open,
    /// A bare number, which takes the header's unit where it is used.
    Bare(Scalar),
    /// A power of length, in the declared unit; never the power 0.
    Length(Scalar, i32),
    /// An angle.
    Angle(Angle),
}

/// What an expression amounts to.
#[derive(Clone, Debug)]
pub(super) struct Value {
    /// The constant part; the nominal values of parameters are not in it.
    pub(super) constant: Constant,
    /// The coefficient of the joint variable.
    pub(super) joint: Ratio,
    /// Coefficients of parameters, sorted by parameter.
    pub(super) params: Vec<(Ratio, usize)>,
    /// The constant part as an integer combination of `let`s, if it is written as one; empty for a written 0.
    pub(super) lets: Option<Vec<(i64, usize)>>,
}

/// Why two values cannot be combined.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    pub(super) message: String,
    pub(super) help: Option<String>,
}

/// A fault with a remedy.
pub(super) fn fault(message: impl Into<String>, help: impl Into<String>) -> Fault {
    Fault { message: message.into(), help: Some(help.into()) }
}

/// An exact number outgrew its representation.
pub(super) fn overflow() -> Fault {
    fault("the exact value needs more than 127 bits", "write it with fewer digits")
}

impl Value {
    /// A value without joint variable, parameters or `let`s.
    pub(super) fn constant(constant: Constant) -> Value {
        let zero = match &constant {
            Constant::Open => true,
            Constant::Bare(x) | Constant::Length(x, _) => x.is_zero(),
            Constant::Angle(angle) => angle.is_zero(),
        };
        Value { constant, joint: Ratio::ZERO, params: Vec::new(), lets: zero.then(Vec::new) }
    }

    /// Whether it has no joint variable and no parameter.
    pub(super) fn is_constant(&self) -> bool {
        self.joint.is_zero() && self.params.is_empty()
    }

    /// The kind of its constant, in words.
    pub(super) fn kind(&self) -> &'static str {
        match &self.constant {
            Constant::Open => "a variable",
            Constant::Bare(_) => "a bare number",
            Constant::Length(_, 1) => "a length",
            Constant::Length(_, 2) => "an area",
            Constant::Length(..) => "a power of a length",
            Constant::Angle(_) => "an angle",
        }
    }

    /// The negative.
    pub(super) fn neg(&self) -> Value {
        let constant = match &self.constant {
            Constant::Open => Constant::Open,
            Constant::Bare(x) => Constant::Bare(x.neg()),
            Constant::Length(x, power) => Constant::Length(x.neg(), *power),
            Constant::Angle(angle) => Constant::Angle(angle.neg()),
        };
        let params = self.params.iter().map(|(k, i)| (k.neg(), *i)).collect();
        let lets = self.lets.as_ref().and_then(|terms| scaled(terms, -1));
        Value { constant, joint: self.joint.neg(), params, lets }
    }

    /// The sum.
    pub(super) fn add(&self, other: &Value) -> Result<Value, Fault> {
        let constant = match (&self.constant, &other.constant) {
            (Constant::Open, known) | (known, Constant::Open) => known.clone(),
            (Constant::Bare(a), Constant::Bare(b)) => Constant::Bare(a.add(*b).ok_or_else(overflow)?),
            (Constant::Length(a, p), Constant::Length(b, r)) if p == r => {
                Constant::Length(a.add(*b).ok_or_else(overflow)?, *p)
            }
            (Constant::Angle(a), Constant::Angle(b)) => Constant::Angle(a.add(*b).ok_or_else(overflow)?),
            _ => return Err(mixed(self, other)),
        };
        let lets = match (&self.lets, &other.lets) {
            (Some(a), Some(b)) => merged(a, b),
            _ => None,
        };
        let joint = self.joint.checked_add(other.joint).ok_or_else(overflow)?;
        let mut params = self.params.clone();
        for (k, i) in &other.params {
            match params.iter_mut().find(|(_, known)| known == i) {
                Some((sum, _)) => *sum = sum.checked_add(*k).ok_or_else(overflow)?,
                None => params.push((*k, *i)),
            }
        }
        params.retain(|(k, _)| !k.is_zero());
        params.sort_by_key(|(_, i)| *i);
        Ok(Value { constant, joint, params, lets })
    }

    /// The product; at most one of the two may contain a variable, and the other must then be a rational number.
    pub(super) fn mul(&self, other: &Value) -> Result<Value, Fault> {
        match (self.is_constant(), other.is_constant()) {
            (true, true) => {}
            (false, true) => return self.scale(other),
            (true, false) => return other.scale(self),
            (false, false) => {
                let help = "a cell is linear in q and in parameters: bind a `param` to the product";
                return Err(fault("this is a product of two variables", help));
            }
        }
        let constant = match (&self.constant, &other.constant) {
            (Constant::Bare(a), Constant::Bare(b)) => Constant::Bare(product(*a, *b)?),
            (Constant::Bare(a), Constant::Length(b, p)) | (Constant::Length(b, p), Constant::Bare(a)) => {
                Constant::Length(product(*a, *b)?, *p)
            }
            (Constant::Length(a, p), Constant::Length(b, r)) => {
                length(product(*a, *b)?, p.saturating_add(*r))
            }
            (Constant::Bare(a), Constant::Angle(b)) | (Constant::Angle(b), Constant::Bare(a)) => {
                Constant::Angle(times(*b, *a)?)
            }
            (Constant::Angle(_), _) | (_, Constant::Angle(_)) => {
                let help = "an angle can be multiplied by a bare number only";
                return Err(fault(format!("{} cannot be multiplied by {}", self.kind(), other.kind()), help));
            }
            (Constant::Open, _) | (_, Constant::Open) => Constant::Bare(Scalar::zero()),
        };
        let lets = match (self.whole_number(), other.whole_number()) {
            (Some(k), _) => other.lets.as_ref().and_then(|terms| scaled(terms, k)),
            (_, Some(k)) => self.lets.as_ref().and_then(|terms| scaled(terms, k)),
            _ => None,
        };
        Ok(Value { lets, ..Value::constant(constant) }.with_written_zero())
    }

    /// The quotient.
    pub(super) fn div(&self, other: &Value) -> Result<Value, Fault> {
        if !other.is_constant() {
            let help = "a cell is linear in q and in parameters: bind a `param` to the quotient";
            return Err(fault("this divides by a variable", help));
        }
        let zero = match &other.constant {
            Constant::Bare(x) | Constant::Length(x, _) => x.is_zero(),
            Constant::Angle(angle) => angle.is_zero(),
            Constant::Open => true,
        };
        if zero {
            return Err(fault("this divides by zero", "write a divisor that is not zero"));
        }
        if let (Constant::Angle(a), Constant::Angle(b)) = (&self.constant, &other.constant) {
            let quotient = Value::constant(Constant::Bare(angle_ratio(*a, *b)?));
            return if self.is_constant() { Ok(quotient) } else { self.scale(&quotient) };
        }
        let inverse = |x: &Scalar| Scalar::one().div(*x).ok_or_else(overflow);
        let constant = match &other.constant {
            Constant::Bare(x) => Constant::Bare(inverse(x)?),
            Constant::Length(x, power) => Constant::Length(inverse(x)?, power.saturating_neg()),
            Constant::Angle(_) | Constant::Open => {
                return Err(fault(
                    format!("{} cannot be divided by an angle", self.kind()),
                    "divide by a bare number",
                ));
            }
        };
        self.mul(&Value::constant(constant))
    }

    /// A linear value times a constant.
    fn scale(&self, by: &Value) -> Result<Value, Fault> {
        let Constant::Bare(Scalar::Exact(ratio)) = by.constant else {
            let help = "a cell with q reduces to `q` or `-q` plus a constant; a parameter takes integer coefficients";
            return Err(fault(format!("a variable cannot be multiplied by {}", by.described()), help));
        };
        let times = |k: &Ratio| k.checked_mul(ratio).ok_or_else(overflow);
        let mut params = Vec::new();
        for (k, i) in &self.params {
            params.push((times(k)?, *i));
        }
        params.retain(|(k, _)| !k.is_zero());
        let fixed = Value { joint: Ratio::ZERO, params: Vec::new(), ..self.clone() };
        let fixed = match fixed.constant {
            Constant::Open => fixed,
            _ => fixed.mul(by)?,
        };
        Ok(Value { joint: times(&self.joint)?, params, ..fixed })
    }

    fn described(&self) -> &'static str {
        match self.constant {
            Constant::Bare(_) => "an irrational number",
            _ => self.kind(),
        }
    }

    /// Its value, if it is written as a whole number and not through a `let`.
    fn whole_number(&self) -> Option<i64> {
        let Constant::Bare(Scalar::Exact(ratio)) = self.constant else { return None };
        let written = self.lets.as_ref().is_none_or(Vec::is_empty);
        if written && ratio.is_integer() { i64::try_from(ratio.num()).ok() } else { None }
    }

    /// An exact zero is no length of anything.
    fn with_written_zero(mut self) -> Value {
        if Value::constant(self.constant.clone()).lets.is_some() {
            self.lets = Some(Vec::new());
        }
        self
    }
}

fn product(a: Scalar, b: Scalar) -> Result<Scalar, Fault> {
    a.mul(b).ok_or_else(overflow)
}

fn length(x: Scalar, power: i32) -> Constant {
    if power == 0 { Constant::Bare(x) } else { Constant::Length(x, power) }
}

/// An angle times a number.
pub(super) fn times(angle: Angle, by: Scalar) -> Result<Angle, Fault> {
    match by {
        Scalar::Exact(ratio) => {
            let pi = angle.pi.checked_mul(ratio).ok_or_else(overflow)?;
            Ok(Angle { pi, rad: product(angle.rad, by)? })
        }
        Scalar::Real(x) => Ok(Angle { pi: Ratio::ZERO, rad: (angle.to_real() * x).into() }),
    }
}

/// A quotient of angles: exact where both are multiples of π, or both rational.
fn angle_ratio(a: Angle, b: Angle) -> Result<Scalar, Fault> {
    if a.rad.is_zero() && b.rad.is_zero() {
        return a.pi.checked_div(b.pi).map(Scalar::Exact).ok_or_else(overflow);
    }
    if a.pi.is_zero() && b.pi.is_zero() {
        return a.rad.div(b.rad).ok_or_else(overflow);
    }
    Ok((a.to_real() / b.to_real()).into())
}

/// A bare number as an angle in the header's unit.
pub(super) fn bare_angle(x: Scalar, unit: AngleUnit) -> Result<Angle, Fault> {
    match unit {
        AngleUnit::Radian => Ok(Angle { pi: Ratio::ZERO, rad: x }),
        AngleUnit::Degree => {
            let degree = Ratio::new(1, 180).ok_or_else(overflow)?;
            times(Angle { pi: degree, rad: Scalar::zero() }, x)
        }
    }
}

/// How many `to` one `from` is.
pub(super) fn conversion(from: LengthUnit, to: LengthUnit) -> Option<Ratio> {
    Ratio::new(from.tenths_of_millimetre().into(), to.tenths_of_millimetre().into())
}

fn mixed(a: &Value, b: &Value) -> Fault {
    let bare = matches!(a.constant, Constant::Bare(_)) || matches!(b.constant, Constant::Bare(_));
    let help = if bare { "write the unit on both, or on none" } else { "add values of one kind only" };
    fault(format!("{} cannot be added to {}", b.kind(), a.kind()), help)
}

fn scaled(terms: &[(i64, usize)], by: i64) -> Option<Vec<(i64, usize)>> {
    if by == 0 {
        return Some(Vec::new());
    }
    terms.iter().map(|(k, i)| Some((k.checked_mul(by)?, *i))).collect()
}

fn merged(a: &[(i64, usize)], b: &[(i64, usize)]) -> Option<Vec<(i64, usize)>> {
    let mut sum = a.to_vec();
    for (k, i) in b {
        match sum.iter_mut().find(|(_, known)| known == i) {
            Some((total, _)) => *total = total.checked_add(*k)?,
            None => sum.push((*k, *i)),
        }
    }
    sum.retain(|(k, _)| *k != 0);
    sum.sort_by_key(|(_, i)| *i);
    Some(sum)
}
