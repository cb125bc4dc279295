//! Any three joints that move a point through space: their axes as lines.
//!
//! Nothing about the lines is assumed. What meets, is parallel or stands at right angles is found by the runtime from the same
//! numbers, because parameters may bring axes together; refused is only what cannot reach a volume whatever the numbers.

use super::Refusal;
use super::base::{Base, Shape};
use super::home::Home;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::chain::JointKind;
use crate::number::Real;
use crate::quantity::{Linear, Quantity, roundoff};

/// The axis of a joint at home.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Whether it slides.
    pub slides: bool,
    /// Its unit direction, in the axes of the first row's frame.
    pub direction: [Real; 3],
    /// A point of it, from the base's origin.
    pub point: [Linear; 3],
}

/// Three joints and the point they carry.
#[derive(Clone, Debug)]
pub struct General {
    /// The axes of joints 1, 2 and 3.
    pub axes: [Axis; 3],
    /// The point at home, from the base's origin.
    pub carried: [Linear; 3],
}

/// Recognises any base that moves the point `carried` through space.
pub fn recognise(home: &mut Home<'_>, carried: &V3<Poly>) -> Result<Base, Refusal> {
    let axes = [line(home, 0)?, line(home, 1)?, line(home, 2)?];
    let general = General { axes, carried: from_first_axis(home, carried)? };
    if moves_in_a_surface(&Posed::of(&general.axes, &general.carried, home.reach), home.reach) {
        return Err(Refusal::new(
            "the first three joints move the point that they carry in a surface only, whatever their values",
        ));
    }
    let offsets = [offset(home, 0), offset(home, 1), offset(home, 2)];
    let (axes, origin) = placed(home);
    Ok(Base { axes, origin, shape: Shape::General(Box::new(general)), offsets })
}

/// A point from that of axis 1, in the axes of the first row's frame.
pub(super) fn from_first_axis(home: &mut Home<'_>, point: &V3<Poly>) -> Result<[Linear; 3], Refusal> {
    let origin = home.axes[0].point.clone();
    let offset = vector::sub(&mut home.ring, point, &origin);
    let [x, y, z] = [0, 1, 2].map(|i| home.linear(&offset[i]));
    Ok([x?, y?, z?])
}

/// The axis of a joint, from the point of axis 1.
pub(super) fn line(home: &mut Home<'_>, joint: usize) -> Result<Axis, Refusal> {
    let line = home.axes[joint].clone();
    let point = from_first_axis(home, &line.point)?;
    Ok(Axis { slides: line.kind == JointKind::Prismatic, direction: line.numbers, point })
}

/// What is added to the row value of a joint to give the figure's.
pub(super) fn offset(home: &Home<'_>, joint: usize) -> Quantity {
    let line = &home.axes[joint];
    match line.kind {
        JointKind::Prismatic => Quantity::Linear(line.offset.clone()),
        JointKind::Revolute => Quantity::angle(line.offset.clone(), &[]),
    }
}

/// The orientation of the first row's frame and the point of axis 1, in the world.
pub(super) fn placed(home: &mut Home<'_>) -> (M3<Poly>, V3<Poly>) {
    let (base, origin) = (home.base.clone(), home.axes[0].point.clone());
    let from_base = vector::apply(&mut home.ring, &base.rotation, &origin);
    (base.rotation, vector::add(&mut home.ring, &base.position, &from_base))
}

type Vector = [Real; 3];

fn dot(a: &Vector, b: &Vector) -> Real {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn plus(a: &Vector, b: &Vector, times: Real) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i] * times)
}

/// The joint's motion of a point: a slide, or a turn whose cosine is (1 - k²)/(1 + k²) and sine 2k/(1 + k²).
fn moved(axis: &(bool, Vector, Vector), point: &Vector, k: Real, reach: Real) -> Vector {
    let (slides, z, foot) = axis;
    if *slides {
        return plus(point, z, k * reach);
    }
    let offset = plus(point, foot, -Real::ONE);
    let along = dot(&offset, z);
    let arm = plus(&offset, z, -along);
    let (square, two) = (k * k, k + k);
    let across = cross(z, &arm);
    let weight = Real::ONE + square;
    let turned = [0, 1, 2].map(|i| (arm[i] * (Real::ONE - square) + across[i] * two) / weight);
    plus(&plus(&turned, z, along), foot, Real::ONE)
}

/// Axes and a point as numbers. Parameters stand at nominal values that nobody chose to coincide, plus a share of the reach
/// each, so that what they may bring apart is apart.
pub(super) struct Posed {
    axes: Vec<(bool, Vector, Vector)>,
    carried: Vector,
}

impl Posed {
    pub(super) fn of(axes: &[Axis], carried: &[Linear; 3], reach: Real) -> Posed {
        let number = |linear: &Linear| {
            let share = |index: usize| reach * Real::from_i64(7 + 4 * index as i64) / Real::from_i64(16);
            linear.params.iter().fold(linear.constant, |sum, (c, i)| sum + *c * share(*i))
        };
        let numbers = |v: &[Linear; 3]| [0, 1, 2].map(|i| number(&v[i]));
        let axes = axes.iter().map(|axis| (axis.slides, axis.direction, numbers(&axis.point))).collect();
        Posed { axes, carried: numbers(carried) }
    }

    /// How the joints move the point, with joints 2 and 3 at these places and joint 1 at home.
    fn velocities(&self, b: Real, c: Real, reach: Real) -> Vec<Vector> {
        let velocity = |axis: &(bool, Vector, Vector), p: &Vector| match axis.0 {
            true => axis.1.map(|c| c * reach),
            false => cross(&axis.1, &plus(p, &axis.2, -Real::ONE)),
        };
        // Each joint carries the point, and the motions of those behind it.
        let (mut point, mut motions): (Vector, Vec<Vector>) = (self.carried, Vec::new());
        for (axis, k) in self.axes.iter().zip([Real::ZERO, b, c]).rev() {
            motions.push(velocity(axis, &point));
            let end = |motion: &Vector| moved(axis, &plus(&point, motion, Real::ONE), k, reach);
            let placed = moved(axis, &point, k, reach);
            motions = motions.iter().map(|motion| plus(&end(motion), &placed, -Real::ONE)).collect();
            point = placed;
        }
        motions
    }

    /// Whether something holds in four postures in general position: what is not identically zero is zero on a surface of
    /// postures only.
    fn always(&self, reach: Real, vanishes: impl Fn(&[Vector]) -> bool) -> bool {
        [(3, 5), (-7, 11), (13, -4), (-9, -17)].iter().all(|(b, c)| {
            let [b, c] = [*b, *c].map(|k| Real::from_i64(k) / Real::from_i64(10));
            vanishes(&self.velocities(b, c, reach))
        })
    }
}

/// Whether the three motions of the point lie in a plane wherever the arm stands.
fn moves_in_a_surface(posed: &Posed, reach: Real) -> bool {
    let limit = reach * reach * reach * roundoff();
    posed.always(reach, |motions| match motions {
        [a, b, c] => dot(&cross(a, b), c).abs() <= limit,
        _ => true,
    })
}

/// Whether the two motions of the point lie in a line wherever the arm stands.
pub(super) fn moves_on_a_curve(posed: &Posed, reach: Real) -> bool {
    let limit = reach * reach * roundoff();
    posed.always(reach, |motions| match motions {
        [a, b] => {
            let across = cross(a, b);
            dot(&across, &across).sqrt() <= limit
        }
        _ => true,
    })
}
