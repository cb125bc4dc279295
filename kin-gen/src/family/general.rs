//! Any three joints that move a point through space: their axes as lines.
//!
//! Nothing about the lines is assumed. What meets, is parallel or stands at right angles is found by the runtime from the same
//! numbers, because parameters may bring axes together; refused is only what cannot reach a volume whatever the numbers.

use super::Refusal;
use super::base::{Base, Shape};
use super::home::Home;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, V3};
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
    let origin = home.axes[0].point.clone();
    let from_origin = |home: &mut Home<'_>, point: &V3<Poly>| {
        let offset = vector::sub(&mut home.ring, point, &origin);
        let [x, y, z] = [0, 1, 2].map(|i| home.linear(&offset[i]));
        Ok([x?, y?, z?])
    };
    let point = from_origin(home, carried)?;
    let axis = |home: &mut Home<'_>, i: usize| {
        let line = home.axes[i].clone();
        let point = from_origin(home, &line.point)?;
        Ok(Axis { slides: line.kind == JointKind::Prismatic, direction: line.numbers, point })
    };
    let general = General { axes: [axis(home, 0)?, axis(home, 1)?, axis(home, 2)?], carried: point };
    if moves_in_a_surface(&general, home.reach) {
        return Err(Refusal::new(
            "the first three joints move the point that they carry in a surface only, whatever their values",
        ));
    }
    let offset = |i: usize| match general.axes[i].slides {
        true => Quantity::Linear(home.axes[i].offset.clone()),
        false => Quantity::angle(home.axes[i].offset.clone(), &[]),
    };
    let offsets = [offset(0), offset(1), offset(2)];
    let base = home.base.clone();
    let from_base = vector::apply(&mut home.ring, &base.rotation, &origin);
    let in_world = vector::add(&mut home.ring, &base.position, &from_base);
    Ok(Base { axes: base.rotation, origin: in_world, shape: Shape::General(Box::new(general)), offsets })
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

/// Whether the three motions of the point lie in a plane wherever the arm stands, told from four postures in general
/// position: a determinant that is not identically zero is zero on a surface of postures only. Parameters stand at nominal
/// values that nobody chose to coincide, plus a share of the reach each, so that what they may bring apart is apart.
fn moves_in_a_surface(general: &General, reach: Real) -> bool {
    let number = |linear: &Linear| {
        let share = |index: usize| reach * Real::from_i64(7 + 4 * index as i64) / Real::from_i64(16);
        linear.params.iter().fold(linear.constant, |sum, (c, i)| sum + *c * share(*i))
    };
    let numbers = |v: &[Linear; 3]| [0, 1, 2].map(|i| number(&v[i]));
    let axes = [0, 1, 2].map(|i| {
        let axis = &general.axes[i];
        (axis.slides, axis.direction, numbers(&axis.point))
    });
    let velocity = |axis: &(bool, Vector, Vector), p: &Vector| match axis.0 {
        true => axis.1.map(|c| c * reach),
        false => cross(&axis.1, &plus(p, &axis.2, -Real::ONE)),
    };
    let carried = numbers(&general.carried);
    let limit = reach * reach * reach * roundoff();
    [(3, 5), (-7, 11), (13, -4), (-9, -17)].iter().all(|(b, c)| {
        let [b, c] = [*b, *c].map(|k| Real::from_i64(k) / Real::from_i64(10));
        let lifted = moved(&axes[2], &carried, c, reach);
        let placed = moved(&axes[1], &lifted, b, reach);
        let end = plus(&lifted, &velocity(&axes[2], &lifted), Real::ONE);
        // Joint 2 carries the motion of joint 3 with it.
        let third = plus(&moved(&axes[1], &end, b, reach), &placed, -Real::ONE);
        let pair = cross(&velocity(&axes[0], &placed), &velocity(&axes[1], &placed));
        dot(&pair, &third).abs() <= limit
    })
}
