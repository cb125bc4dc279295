//! Expressions to values.

use super::names::Scope;
use super::value::{Constant, Fault, Value, bare_angle, conversion, fault, overflow};
use crate::decl::{AngleUnit, Expr, Function, Node, Sign, Unit, is_joint_variable, joint_number};
use crate::number::{Angle, Ratio, Scalar};
use crate::report::{Place, Report};

/// What variables an expression may contain, and the name of what it stands in.
#[derive(Clone, Copy)]
pub(super) struct Allowed<'a> {
    /// The number of the joint whose variable may occur, counted from 1.
    pub(super) joint: Option<usize>,
    /// Whether parameters may occur.
    pub(super) params: bool,
    /// `a limit`, `a let`, …
    pub(super) what: &'a str,
}

impl Fault {
    /// Says it at a place.
    pub(super) fn report(self, place: Place, report: &mut Report) {
        match self.help {
            Some(help) => report.error_help(place, self.message, help),
            None => report.error(place, self.message),
        }
    }
}

impl Value {
    /// A zero `let` is as good as a written 0.
    pub(super) fn zero_is_written(self) -> Value {
        match Value::constant(self.constant.clone()).lets {
            Some(none) => Value { lets: Some(none), ..self },
            None => self,
        }
    }
}

impl Scope<'_> {
    /// The value of an expression that must be a constant. `None` after a message.
    pub(super) fn constant(&mut self, expr: &Expr, what: &str, report: &mut Report) -> Option<Value> {
        self.value(expr, Allowed { joint: None, params: false, what }, report)
    }

    /// The value of an expression. `None` after a message.
    pub(super) fn value(&mut self, expr: &Expr, allowed: Allowed<'_>, report: &mut Report) -> Option<Value> {
        match &expr.node {
            Node::Number(digits, unit) => match self.literal(digits, *unit) {
                Ok(value) => Some(value),
                Err(fault) => {
                    fault.report(expr.place, report);
                    None
                }
            },
            Node::Pi => Some(Value::constant(Constant::Angle(Angle { pi: Ratio::ONE, rad: Scalar::zero() }))),
            Node::Name(name) => self.name(name, expr.place, allowed, report),
            Node::Neg(inner) => self.value(inner, allowed, report).map(|v| v.neg()),
            Node::Sum(terms) => {
                let terms = terms.iter().map(|(sign, e)| (*sign == Sign::Minus, e));
                self.fold(terms, allowed, report, |sum, minus, term| {
                    sum.add(&if minus { term.neg() } else { term.clone() })
                })
            }
            Node::Product(factors) => {
                let factors = factors.iter().map(|(divide, e)| (*divide, e));
                self.fold(factors, allowed, report, |product, divide, factor| {
                    if divide { product.div(factor) } else { product.mul(factor) }
                })
            }
            Node::Call(function, argument) => {
                let value = self.constant(argument, "an argument of a function", report)?;
                match self.call(*function, &value) {
                    Ok(value) => Some(value),
                    Err(fault) => {
                        fault.report(expr.place, report);
                        None
                    }
                }
            }
        }
    }

    /// Combines operands from the left; every operand is evaluated, so that each reports its own mistakes.
    fn fold<'e>(
        &mut self,
        operands: impl Iterator<Item = (bool, &'e Expr)>,
        allowed: Allowed<'_>,
        report: &mut Report,
        combine: impl Fn(&Value, bool, &Value) -> Result<Value, Fault>,
    ) -> Option<Value> {
        let mut total: Option<Value> = None;
        let mut failed = false;
        for (flag, expr) in operands {
            let Some(value) = self.value(expr, allowed, report) else {
                failed = true;
                continue;
            };
            total = match total.take() {
                None => Some(value),
                Some(sum) if failed => Some(sum),
                Some(sum) => match combine(&sum, flag, &value) {
                    Ok(value) => Some(value),
                    Err(fault) => {
                        fault.report(expr.place, report);
                        failed = true;
                        None
                    }
                },
            };
        }
        if failed { None } else { total }
    }

    fn literal(&self, digits: &str, unit: Option<Unit>) -> Result<Value, Fault> {
        let ratio = Ratio::parse_decimal(digits.strip_suffix('.').unwrap_or(digits)).ok_or_else(overflow)?;
        let constant = match unit {
            None => Constant::Bare(Scalar::Exact(ratio)),
            Some(Unit::Angle(unit)) => Constant::Angle(bare_angle(Scalar::Exact(ratio), unit)?),
            Some(Unit::Length(unit)) => {
                let size = conversion(unit, self.length_unit).ok_or_else(overflow)?;
                Constant::Length(Scalar::Exact(ratio.checked_mul(size).ok_or_else(overflow)?), 1)
            }
        };
        Ok(Value::constant(constant))
    }

    fn name(&mut self, name: &str, place: Place, allowed: Allowed<'_>, report: &mut Report) -> Option<Value> {
        if is_joint_variable(name) {
            // Its binding was refused: which of the two is meant is not known, and not a second mistake.
            if self.refused(name) {
                let _ = self.look_up(name, place, report);
                return None;
            }
            return joint_variable(name, place, allowed, report);
        }
        let value = self.look_up(name, place, report)?;
        if !value.params.is_empty() && !allowed.params {
            let message =
                format!("{} is a constant, but `{name}` is a `param`, known only at run time", allowed.what);
            report.error_help(place, message, format!("bind `{name}` with `let` if it never changes"));
            return None;
        }
        Some(value)
    }

    fn call(&self, function: Function, value: &Value) -> Result<Value, Fault> {
        let angle = || self.as_angle(value);
        let constant = match (function, &value.constant) {
            (Function::Sin, _) => Constant::Bare(sine(angle()?)),
            (Function::Cos, _) => Constant::Bare(cosine(angle()?)?),
            (Function::Sqrt, Constant::Bare(x)) => Constant::Bare(root(*x)?),
            (Function::Sqrt, Constant::Length(x, power)) if power % 2 == 0 => {
                Constant::Length(root(*x)?, power / 2)
            }
            (Function::Sqrt, _) => {
                let message = format!("the square root of {} is not a length", value.kind());
                return Err(fault(message, "take the root of a number or of a sum of squares of lengths"));
            }
        };
        Ok(Value::constant(constant))
    }

    /// A constant as an angle.
    pub(super) fn as_angle(&self, value: &Value) -> Result<Angle, Fault> {
        match &value.constant {
            Constant::Open => Ok(Angle::default()),
            Constant::Bare(x) => bare_angle(*x, self.angle_unit),
            Constant::Angle(angle) => Ok(*angle),
            Constant::Length(..) => {
                let help = match self.angle_unit {
                    AngleUnit::Degree => "write an angle, such as `90` or `pi/2`",
                    AngleUnit::Radian => "write an angle, such as `pi/2` or `90deg`",
                };
                Err(fault(format!("this is {}, not an angle", value.kind()), help))
            }
        }
    }

    /// A constant as a length in the declared unit.
    pub(super) fn as_length(&self, value: &Value) -> Result<Scalar, Fault> {
        let x = match &value.constant {
            Constant::Open => return Ok(Scalar::zero()),
            Constant::Bare(x) | Constant::Length(x, 1) => *x,
            Constant::Length(..) | Constant::Angle(_) => {
                let help = format!("write a length, such as `120` or `120{}`", self.length_unit.word());
                return Err(fault(format!("this is {}, not a length", value.kind()), help));
            }
        };
        let float = x.to_f64();
        if float.is_finite() && (x.is_zero() || float.abs() > f64::MIN_POSITIVE) {
            Ok(x)
        } else {
            Err(fault("this length is beyond the range of f64", "write it in another unit"))
        }
    }
}

fn joint_variable(name: &str, place: Place, allowed: Allowed<'_>, report: &mut Report) -> Option<Value> {
    let Some(own) = allowed.joint else {
        let message = format!("{} is a constant, but `{name}` is a joint variable", allowed.what);
        report.error_help(place, message, "joint variables belong in theta, d or a factor of the chain");
        return None;
    };
    match joint_number(name) {
        Some(number) if usize::try_from(number) != Ok(own) => {
            let help = format!("write `q`, or `q{own}`");
            report.error_help(place, format!("`{name}` stands in joint {own}"), help);
            None
        }
        _ => Some(Value { joint: Ratio::ONE, ..Value::constant(Constant::Open) }),
    }
}

fn root(x: Scalar) -> Result<Scalar, Fault> {
    x.sqrt().ok_or_else(|| {
        fault("this is the square root of a negative number", "write a number that is not negative")
    })
}

/// The sine, exact where it is 0, ±1/2 or ±1 (Niven: no other rational multiple of π has a rational sine).
fn sine(angle: Angle) -> Scalar {
    let sixths = angle.pi.checked_mul(Ratio::integer(6)).filter(|n| n.is_integer() && angle.rad.is_zero());
    let halves = sixths.and_then(|n| match n.num().rem_euclid(12) {
        0 | 6 => Some(0),
        1 | 5 => Some(1),
        3 => Some(2),
        7 | 11 => Some(-1),
        9 => Some(-2),
        _ => None,
    });
    match halves.and_then(|n| Ratio::new(n, 2)) {
        Some(exact) => Scalar::Exact(exact),
        None => Scalar::from(angle.sin_cos().0),
    }
}

fn cosine(angle: Angle) -> Result<Scalar, Fault> {
    let half = Ratio::new(1, 2).ok_or_else(overflow)?;
    let pi = angle.pi.checked_add(half).ok_or_else(overflow)?;
    Ok(sine(Angle { pi, rad: angle.rad }))
}
