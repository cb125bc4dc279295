//! Values to distances and angles: which lengths are atoms, and what they are called.

use super::names::{Meaning, Scope};
use super::value::{Constant, Value, fault};
use super::{AngleSum, Distance, Length, LengthAtom, ParamKind};
use crate::number::{Ratio, Scalar};
use crate::report::{Place, Report};

/// The lengths that have occurred so far.
#[derive(Default)]
pub(super) struct Lengths {
    pub(super) list: Vec<Length>,
    /// For each name of the scope that is an atom, its index and the atom's.
    bound: Vec<(usize, usize)>,
}

/// A cell, or the argument of a factor, to be told about in messages.
#[derive(Clone, Copy)]
pub(super) struct Slot<'a> {
    /// The column (`a`) or the transform (`Tx`).
    pub(super) label: &'a str,
    /// What to call a length that has no name of its own.
    pub(super) atom: &'a str,
    pub(super) place: Place,
}

impl Lengths {
    /// The distance that a value stands for, its joint variable left out of account.
    pub(super) fn distance(
        &mut self,
        value: &Value,
        slot: Slot<'_>,
        scope: &mut Scope<'_>,
        report: &mut Report,
    ) -> Option<Distance> {
        if let Constant::Angle(_) = value.constant {
            let unit = scope.length_unit.word();
            let help = format!("write a length, such as `90{unit}`, or move the angle to `alpha` or `theta`");
            let message = format!("this is an angle, but {} is a length", slot.label);
            fault(
                message,
                if slot.label.starts_with('`') {
                    help
                } else {
                    format!("write a length, such as `90{unit}`")
                },
            )
            .report(slot.place, report);
            return None;
        }
        let nominal = match scope.as_length(value) {
            Ok(nominal) => nominal,
            Err(fault) => {
                fault.report(slot.place, report);
                return None;
            }
        };
        let mut terms = self.constant_terms(value, nominal, slot, scope);
        for (coefficient, param) in integers(value, scope, slot, report)? {
            scope.use_param(param, ParamKind::Length, slot.place, report);
            terms.push((coefficient, LengthAtom::Param(param)));
        }
        terms.sort_by_key(|(_, atom)| *atom);
        Some(Distance(terms))
    }

    /// The constant part: the `let`s it is written with, else one atom of its own.
    fn constant_terms(
        &mut self,
        value: &Value,
        nominal: Scalar,
        slot: Slot<'_>,
        scope: &Scope<'_>,
    ) -> Vec<(i64, LengthAtom)> {
        if nominal.is_zero() {
            return Vec::new();
        }
        let Some(lets) = &value.lets else {
            let name = self.free_name(slot.atom, scope);
            self.list.push(Length { name, value: nominal });
            return vec![(1, LengthAtom::Constant(self.list.len() - 1))];
        };
        let mut terms = Vec::new();
        for (coefficient, index) in lets {
            if let Some(atom) = self.bound_atom(*index, scope) {
                terms.push((*coefficient, LengthAtom::Constant(atom)));
            }
        }
        terms
    }

    /// The atom of a `let`, unless that is zero.
    fn bound_atom(&mut self, index: usize, scope: &Scope<'_>) -> Option<usize> {
        if let Some((_, atom)) = self.bound.iter().find(|(known, _)| *known == index) {
            return Some(*atom);
        }
        let name = scope.names.get(index)?;
        let Meaning::Let(Some(value)) = &name.meaning else { return None };
        let nominal = scope.as_length(value).ok().filter(|x| !x.is_zero())?;
        self.list.push(Length { name: name.text.clone(), value: nominal });
        self.bound.push((index, self.list.len() - 1));
        Some(self.list.len() - 1)
    }

    /// `a2`, else `a2b`, `a2c`, …; `base_z`, else `base_z2`, …: the first that is not taken.
    fn free_name(&self, wanted: &str, scope: &Scope<'_>) -> String {
        let taken = |name: &str| scope.find(name).is_some() || self.list.iter().any(|l| l.name == name);
        let ends_in_digit = |text: &str| text.ends_with(|c: char| c.is_ascii_digit());
        // `d2b` of a fixed row carries its letter already: `d2c` follows.
        let stem = wanted.strip_suffix('b').filter(|stem| ends_in_digit(stem)).unwrap_or(wanted);
        let letters = ('b'..='z').filter(|_| ends_in_digit(stem)).map(|c| format!("{stem}{c}"));
        let separator = if ends_in_digit(stem) { "_" } else { "" };
        let numbers = (2u32..).map(|n| format!("{stem}{separator}{n}"));
        let mut names = std::iter::once(wanted.to_string()).chain(letters).chain(numbers);
        names.find(|name| !taken(name)).unwrap_or_default()
    }
}

/// The angle that a value stands for, its joint variable left out of account.
pub(super) fn angle_sum(
    value: &Value,
    slot: Slot<'_>,
    scope: &mut Scope<'_>,
    report: &mut Report,
) -> Option<AngleSum> {
    if let Constant::Length(_, 1) = value.constant {
        let example =
            if scope.angle_unit == super::AngleUnit::Degree { "`90` or `pi/2`" } else { "`pi/2` or `90deg`" };
        let help = if slot.label.starts_with('`') {
            format!("write an angle, such as {example}, or move the length to `a` or `d`")
        } else {
            format!("write an angle, such as {example}")
        };
        report.error_help(slot.place, format!("this is a length, but {} is an angle", slot.label), help);
        return None;
    }
    let constant = match scope.as_angle(value) {
        Ok(angle) => angle,
        Err(fault) => {
            fault.report(slot.place, report);
            return None;
        }
    };
    let params = integers(value, scope, slot, report)?;
    for (_, param) in &params {
        scope.use_param(*param, ParamKind::Angle, slot.place, report);
    }
    Some(AngleSum { constant, params })
}

/// The coefficients of parameters, which must be integers.
fn integers(
    value: &Value,
    scope: &Scope<'_>,
    slot: Slot<'_>,
    report: &mut Report,
) -> Option<Vec<(i64, usize)>> {
    let mut terms = Vec::new();
    for (coefficient, param) in &value.params {
        match i64::try_from(coefficient.num()) {
            Ok(integer) if coefficient.is_integer() => terms.push((integer, *param)),
            _ => {
                let name = scope.params.get(*param).map_or("", |p| &p.name);
                let message = format!(
                    "the param `{name}` is multiplied by {coefficient} here, which is not an integer"
                );
                report.error_help(slot.place, message, "declare a `param` for what the cell holds");
                return None;
            }
        }
    }
    Some(terms)
}

/// +1 or −1: how q occurs in a value that contains it.
pub(super) fn joint_sign(value: &Value, slot: Slot<'_>, report: &mut Report) -> Option<bool> {
    if value.joint == Ratio::ONE {
        return Some(false);
    }
    if value.joint == Ratio::ONE.neg() {
        return Some(true);
    }
    let message = if value.joint.is_zero() {
        "q cancels out here".to_string()
    } else {
        format!("q is multiplied by {} here", value.joint)
    };
    report.error_help(slot.place, message, "a joint is `q` or `-q`, plus a constant");
    None
}
