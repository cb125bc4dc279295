//! The arm at home: every joint at zero, the offsets of its cells left out, so that each axis is a line that only
//! constants and length parameters move. Seen from the first row's frame: what the arm is does not depend on where it
//! stands.

use super::Refusal;
use crate::algebra::frame::{Stretch, Values, joint_turn};
use crate::algebra::ring::{Poly, Ring};
use crate::algebra::vector::{self, V3};
use crate::chain::{Chain, JointKind, LengthUnit, Motion, ParamKind};
use crate::number::Real;
use crate::quantity::{Linear, roundoff};
use crate::truth::{self, Outers, RawPose, Symbols};

/// A joint axis at home.
#[derive(Clone, Debug)]
pub struct Line {
    /// Turning or sliding.
    pub kind: JointKind,
    /// The direction in which the row value grows.
    pub direction: V3<Poly>,
    /// The same, as numbers.
    pub numbers: [Real; 3],
    /// A point on it.
    pub point: V3<Poly>,
    /// The constant part of the cell: radians, or a length, in the sense of the row value.
    pub offset: Linear,
}

impl Line {
    /// The axis about which the joint turns, or along which it slides, what lies before it: the same line, seen from behind.
    fn reversed(&self) -> Line {
        let (direction, numbers) = (self.direction.clone().map(|d| d.neg()), self.numbers.map(|d| -d));
        Line { direction, numbers, ..self.clone() }
    }
}

/// The arm at home.
pub struct Home<'a> {
    /// The declaration.
    pub chain: &'a Chain,
    /// The meaning of the ring's variables.
    pub symbols: &'a Symbols,
    /// The ring.
    pub ring: Ring,
    /// The axes, in order of the joints.
    pub axes: Vec<Line>,
    /// The frame at the end of each joint's row.
    pub frames: Vec<RawPose>,
    /// The tool point.
    pub tip: RawPose,
    /// The first row's frame in the world.
    pub base: RawPose,
    /// The arm's reach at its nominal parameters.
    pub reach: Real,
}

impl<'a> Home<'a> {
    /// `None` if an exact value cannot be represented.
    pub fn new(chain: &'a Chain, symbols: &'a Symbols, mut ring: Ring, outers: &Outers) -> Option<Home<'a>> {
        let rows = Stretch { elements: chain.elements.iter().collect(), frames: chain.frames.clone() };
        let raw = truth::walk(&mut ring, symbols, chain, Values::Home, &rows)?;
        let tip = truth::compose(&mut ring, &raw.tip, &outers.tool.pose);
        let base = outers.base.pose.clone();
        let mut axes: Vec<Line> = Vec::new();
        for (joint, direction, point) in raw.axes {
            let numbers = direction.clone().map(|d| ring.value(&d).to_real());
            let kind = chain.joints.get(joint)?.kind;
            let offset = offset_of(chain, symbols, &ring, joint)?;
            axes.push(Line { kind, direction, numbers, point, offset });
        }
        if ring.exhausted() || axes.len() != chain.joints.len() {
            return None;
        }
        Some(Home {
            chain,
            symbols,
            ring,
            axes,
            frames: raw.frames,
            tip,
            base,
            reach: chain.reach().to_real(),
        })
    }

    /// The same arm seen from its tool: the last joint comes first, each moves the other way, and the tool's frame is where
    /// the arm stands. What the frames and the tip were is not to be asked there.
    pub fn seen_from_tool<R>(&mut self, look: impl FnOnce(&mut Home<'a>) -> R) -> R {
        let rotation = vector::transpose(&self.tip.rotation);
        let position = vector::apply(&mut self.ring, &rotation, &self.tip.position).map(|p| p.neg());
        let reversed = self.axes.iter().rev().map(Line::reversed).collect();
        let axes = std::mem::replace(&mut self.axes, reversed);
        let base = std::mem::replace(&mut self.base, RawPose { rotation, position });
        let seen = look(self);
        (self.axes, self.base) = (axes, base);
        seen
    }

    /// The same arm with its joints in another order, for what asks of axes alone.
    pub fn in_order<R>(&mut self, order: &[usize], look: impl FnOnce(&mut Home<'a>) -> R) -> R {
        let ordered = order.iter().filter_map(|joint| self.axes.get(*joint).cloned()).collect();
        let axes = std::mem::replace(&mut self.axes, ordered);
        let seen = look(self);
        self.axes = axes;
        seen
    }

    /// Every direction must be the same for all values of the parameters.
    pub fn require_fixed_directions(&self) -> Result<(), Refusal> {
        for (index, axis) in self.axes.iter().enumerate() {
            if !axis.direction.iter().all(|d| self.ring.is_constant(d)) {
                let angle = self.chain.params.iter().find(|p| p.kind == ParamKind::Angle);
                return Err(Refusal::new(format!(
                    "the direction of axis {} depends on the parameter {}, so no family holds for all its values",
                    index + 1,
                    angle.map_or("", |p| &p.name),
                )));
            }
        }
        Ok(())
    }

    /// Comparisons of lengths: 64 ε of the reach.
    pub fn tolerance(&self) -> Real {
        self.reach * roundoff()
    }

    /// A length as a linear form.
    pub fn linear(&self, poly: &Poly) -> Result<Linear, Refusal> {
        Linear::of(&self.ring, poly)
            .ok_or_else(|| Refusal::new("a distance between axes is not linear in the parameters"))
    }

    /// Whether a length is zero for all values of the parameters.
    pub fn is_zero_length(&self, poly: &Poly) -> Result<bool, Refusal> {
        Ok(self.linear(poly)?.vanishes(self.tolerance()))
    }

    /// The vector from the point of one axis to that of another.
    pub fn between(&mut self, from: usize, to: usize) -> V3<Poly> {
        let (from, to) = (self.axes[from].point.clone(), self.axes[to].point.clone());
        vector::sub(&mut self.ring, &to, &from)
    }

    /// A direction of an axis.
    pub fn direction(&self, index: usize) -> V3<Poly> {
        self.axes[index].direction.clone()
    }

    /// A length with its unit, for messages: `0.13 mm`.
    pub fn say_length(&self, linear: &Linear) -> String {
        let mut text = format!("{} {}", short(linear.constant.abs()), unit(self.chain.length_unit));
        if !linear.params.is_empty() {
            let names =
                linear.params.iter().filter_map(|(_, i)| self.chain.params.get(*i)).map(|p| p.name.as_str());
            text = format!("a distance that depends on {}", names.collect::<Vec<_>>().join(" and "));
        }
        text
    }
}

/// Six significant digits, without an exponent where that reads well.
fn short(value: Real) -> String {
    let value = value.to_f64();
    let text =
        if (1e-4..1e7).contains(&value) { format!("{value:.9}") } else { return format!("{value:.3e}") };
    let digits = text.chars().filter(char::is_ascii_digit).skip_while(|c| *c == '0').count();
    let surplus = digits.saturating_sub(6).min(9);
    let text = format!("{value:.*}", 9 - surplus);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// The unit as it is written.
pub fn unit(unit: LengthUnit) -> &'static str {
    match unit {
        LengthUnit::Metre => "m",
        LengthUnit::Centimetre => "cm",
        LengthUnit::Millimetre => "mm",
        LengthUnit::Inch => "in",
    }
}

/// What is added to the row value of a joint to give its figure value at home.
fn offset_of(chain: &Chain, symbols: &Symbols, ring: &Ring, joint: usize) -> Option<Linear> {
    for element in &chain.elements {
        match &element.motion {
            Motion::Revolute { joint: j, reversed, .. } if *j == joint => {
                let turn = joint_turn(chain, Values::Rows, &element.motion)?;
                let sign = if *reversed { Real::from_i64(-1) } else { Real::ONE };
                let mut offset = Linear::constant(turn.rest.constant.to_real() * sign);
                for (coefficient, index) in &turn.rest.params {
                    offset.params.push((Real::from_i64(*coefficient) * sign, *index));
                }
                return Some(offset);
            }
            Motion::Prismatic { joint: j, reversed, offset } if *j == joint => {
                let offset = symbols.distance(ring, offset);
                return Linear::of(ring, &if *reversed { offset.neg() } else { offset });
            }
            _ => {}
        }
    }
    None
}
