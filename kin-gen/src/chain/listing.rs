//! A chain as text, one line for each fact: what tests compare.

use super::{AngleSum, Chain, Distance, Element, JointKind, LengthAtom, Motion, ParamKind};
use crate::number::{Angle, Ratio, Scalar};
use std::fmt::{self, Display, Formatter};

impl Display for Chain {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (length, angle) = (self.length_unit.word(), self.angle_unit.word());
        writeln!(f, "{} ({}, {length}, {angle})", self.name, self.form.word())?;
        for length in &self.lengths {
            writeln!(f, "length {} = {}", length.name, number(length.value))?;
        }
        for param in &self.params {
            let kind = if param.kind == ParamKind::Length { "length" } else { "angle" };
            writeln!(f, "param {} = {} ({kind})", param.name, number(param.nominal))?;
        }
        if !self.base.is_empty() {
            writeln!(f, "base{}", self.product(&self.base))?;
        }
        let mut start = 0;
        for (joint, end) in self.joints.iter().zip(&self.frames) {
            let slide = if joint.kind == JointKind::Prismatic { " (slides)" } else { "" };
            let factors = self.product(self.elements.get(start..*end).unwrap_or(&[]));
            write!(f, "{}{slide}{factors}", joint.name)?;
            if let Some((low, high)) = joint.limits {
                write!(f, "  within {} .. {}", number(low), number(high))?;
            }
            writeln!(f)?;
            start = *end;
        }
        let trailing = self.elements.get(start..).unwrap_or(&[]);
        if !trailing.is_empty() {
            writeln!(f, "end{}", self.product(trailing))?;
        }
        if !self.tool.is_empty() {
            writeln!(f, "tool{}", self.product(&self.tool))?;
        }
        let coupled = self
            .couple
            .iter()
            .enumerate()
            .any(|(i, r)| r.iter().enumerate().any(|(j, k)| *k != i64::from(i == j)));
        if coupled {
            writeln!(f, "couple {:?}", self.couple)?;
            writeln!(f, "uncouple {:?}", self.uncouple)?;
        }
        match &self.demanded {
            Some(family) => writeln!(f, "ik {}", family.value),
            None => Ok(()),
        }
    }
}

impl Chain {
    fn product(&self, elements: &[Element]) -> String {
        elements.iter().map(|e| format!(" {}", self.factor(e))).collect()
    }

    /// `Rz(q1 + 90deg)`.
    pub fn factor(&self, element: &Element) -> String {
        let axis = format!("{:?}", element.axis).to_lowercase();
        let joint =
            |joint: usize, reversed: bool| format!("{}q{}", if reversed { "-" } else { "" }, joint + 1);
        match &element.motion {
            Motion::Turn(sum) => format!("R{axis}({})", join(self.angle_terms(sum))),
            Motion::Shift(distance) => format!("T{axis}({})", join(self.distance_terms(distance))),
            Motion::Revolute { joint: j, reversed, offset } => {
                let mut terms = vec![joint(*j, *reversed)];
                terms.extend(self.angle_terms(offset));
                format!("R{axis}({})", join(terms))
            }
            Motion::Prismatic { joint: j, reversed, offset } => {
                let mut terms = vec![joint(*j, *reversed)];
                terms.extend(self.distance_terms(offset));
                format!("T{axis}({})", join(terms))
            }
        }
    }

    fn distance_terms(&self, distance: &Distance) -> Vec<String> {
        let name = |atom: LengthAtom| match atom {
            LengthAtom::Constant(i) => self.lengths.get(i).map_or("?", |l| &l.name),
            LengthAtom::Param(i) => self.params.get(i).map_or("?", |p| &p.name),
        };
        distance.0.iter().map(|(k, atom)| multiple(*k, name(*atom))).collect()
    }

    fn angle_terms(&self, sum: &AngleSum) -> Vec<String> {
        let name = |i: usize| self.params.get(i).map_or("?", |p| &p.name);
        let mut terms: Vec<String> = sum.params.iter().map(|(k, i)| multiple(*k, name(*i))).collect();
        terms.extend(angle_text(sum.constant));
        terms
    }
}

/// The exact angle in degrees, the part that is not a multiple of π in radians.
fn angle_text(angle: Angle) -> Vec<String> {
    let mut terms = Vec::new();
    if !angle.pi.is_zero() {
        let degrees = angle.pi.checked_mul(Ratio::integer(180));
        terms.push(degrees.map_or_else(|| format!("{}*pi", angle.pi), |d| format!("{d}deg")));
    }
    if !angle.rad.is_zero() {
        terms.push(format!("{}rad", number(angle.rad)));
    }
    terms
}

fn multiple(k: i64, name: &str) -> String {
    match k {
        1 => name.to_string(),
        -1 => format!("-{name}"),
        k => format!("{k}*{name}"),
    }
}

fn join(terms: Vec<String>) -> String {
    terms.join(" + ").replace("+ -", "- ")
}

/// Exact numbers as ratios, others to double precision.
fn number(x: Scalar) -> String {
    match x {
        Scalar::Exact(ratio) => ratio.to_string(),
        Scalar::Real(real) => format!("{:?}", real.to_f64()),
    }
}
