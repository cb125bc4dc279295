//! The figure of a three-joint base: how its three joints carry one point.
//!
//! Axis 1, then axis 2 at a fixed angle to it, then either a third axis parallel to the second (the elbow of
//! articulated arms) or a slide perpendicular to it (Stanford's arm); any other three joints are a
//! [general] base. Everything is measured in the *shoulder frame*:
//! z along axis 1, x along the common normal of axes 1 and 2, origin at its foot on axis 1.

use super::Refusal;
use super::general::{self, General};
use super::home::Home;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::chain::JointKind;
use crate::number::Real;
use crate::quantity::{Linear, Quantity, roundoff};

/// What moves the point in the plane perpendicular to axis 2.
#[derive(Clone, Debug)]
pub enum Figure {
    /// An elbow: upper arm and forearm.
    Elbow {
        /// Distance of axes 2 and 3.
        upper: Quantity,
        /// Distance of axis 3 and the point, in the plane.
        fore: Quantity,
    },
    /// A telescope.
    Telescope {
        /// Signed distance of axis 2 and the line on which the point slides.
        arm: Linear,
    },
}

/// The first two axes and the figure in the plane at right angles to the second.
#[derive(Clone, Debug)]
pub struct Stand {
    /// Distance from axis 1 to axis 2 along x; may be negative.
    pub shoulder: Linear,
    /// Sine (positive) and cosine of the angle from axis 1 to axis 2 about x.
    pub twist: (Real, Real),
    /// The point's coordinate along axis 2.
    pub lateral: Linear,
    /// The figure in the plane.
    pub figure: Figure,
    /// Whether a row value turns against its figure angle.
    pub reversed: [bool; 3],
}

/// How the point is moved.
#[derive(Clone, Debug)]
pub enum Shape {
    /// In a plane at right angles to axis 2.
    Stand(Box<Stand>),
    /// By any other three joints.
    General(Box<General>),
}

/// A three-joint base and the point it carries.
#[derive(Clone, Debug)]
pub struct Base {
    /// The orientation in the world, by rows, of the frame in which the base is measured: the shoulder frame of a stand,
    /// the first row's of a general base.
    pub axes: M3<Poly>,
    /// Its origin.
    pub origin: V3<Poly>,
    /// What the joints do.
    pub shape: Shape,
    /// What is added to each row value (or, if reversed, what the row value is subtracted from) to give the figure's.
    pub offsets: [Quantity; 3],
}

/// Names of axes in messages.
fn degrees_between(a: &[Real; 3], b: &[Real; 3]) -> f64 {
    let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = cross_length(a, b);
    Real::atan2(cross, dot).to_f64().to_degrees()
}

fn cross_length(a: &[Real; 3], b: &[Real; 3]) -> Real {
    let c = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i]);
    (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]).sqrt()
}

/// Whether two directions are parallel or opposite, to within 64 ε.
pub fn parallel(a: &[Real; 3], b: &[Real; 3]) -> bool {
    cross_length(a, b) <= roundoff()
}

/// Recognises the base of the first three joints and the point `carried` by it: a stand if it is one.
pub fn recognise(home: &mut Home<'_>, carried: &V3<Poly>) -> Result<Base, Refusal> {
    stand(home, carried).or_else(|_| general::recognise(home, carried))
}

fn stand(home: &mut Home<'_>, carried: &V3<Poly>) -> Result<Base, Refusal> {
    let [first, second, third] = [0, 1, 2].map(|i| home.axes[i].clone());
    if first.kind != JointKind::Revolute || second.kind != JointKind::Revolute {
        return Err(Refusal::new("the first two joints of the base are not both revolute"));
    }
    if parallel(&first.numbers, &second.numbers) {
        return Err(Refusal::new("axes 1 and 2 are parallel, which this family does not cover"));
    }
    let (sine, normal, inverse_sine) = common_normal(home);
    let cosine = vector::dot(&mut home.ring, &first.direction, &second.direction);
    let offset12 = home.between(0, 1);
    let along = distance_to_foot(home, &offset12, &cosine, &inverse_sine);
    let to_foot = vector::scale(&mut home.ring, &along, &first.direction);
    let origin = vector::add(&mut home.ring, &first.point, &to_foot);
    let y = vector::cross(&mut home.ring, &first.direction, &normal);
    let axes = vector::from_columns(&normal, &y, &first.direction);
    let axes = vector::product(&mut home.ring, &home.base.rotation.clone(), &axes);
    let from_base = vector::apply(&mut home.ring, &home.base.rotation.clone(), &origin);
    let origin_in_world = vector::add(&mut home.ring, &home.base.position.clone(), &from_base);
    let shoulder = vector::dot(&mut home.ring, &offset12, &normal);
    let from_origin = vector::sub(&mut home.ring, carried, &origin);
    let lateral = vector::dot(&mut home.ring, &second.direction, &from_origin);
    // The plane perpendicular to axis 2: x along the common normal, y completing it.
    let across = vector::cross(&mut home.ring, &second.direction, &normal);
    let plane = Plane { origin: origin.clone(), x: normal, y: across, shoulder: shoulder.clone() };
    let (figure, angle2, third_offset, reversed3) = match third.kind {
        JointKind::Revolute => elbow(home, &plane, carried)?,
        JointKind::Prismatic => telescope(home, &plane, carried)?,
    };
    let offset = |home: &Home<'_>, i: usize| home.axes[i].offset.clone();
    let twist = (home.ring.value(&sine).to_real(), home.ring.value(&cosine).to_real());
    Ok(Base {
        axes,
        origin: origin_in_world,
        shape: Shape::Stand(Box::new(Stand {
            shoulder: home.linear(&shoulder)?,
            twist,
            lateral: home.linear(&lateral)?,
            figure,
            reversed: [false, false, reversed3],
        })),
        offsets: [
            Quantity::angle(offset(home, 0), &[]),
            Quantity::angle(offset(home, 1), &[(false, angle2.0, angle2.1)]),
            third_offset,
        ],
    })
}

/// |z₁ × z₂|, the unit vector along z₁ × z₂, and 1/|z₁ × z₂|: exact where the axes are perpendicular, else with one
/// constant that stands for the inverse sine.
fn common_normal(home: &mut Home<'_>) -> (Poly, V3<Poly>, Poly) {
    let (a, b) = (home.direction(0), home.direction(1));
    let cross = vector::cross(&mut home.ring, &a, &b);
    let square = vector::dot(&mut home.ring, &cross, &cross);
    if square.as_unit() == Some(1) {
        return (Poly::integer(1), cross, Poly::integer(1));
    }
    let sine = home.ring.value(&square).to_real().sqrt();
    let inverse = home.ring.constant("inverse_sine", crate::number::Scalar::Real(Real::ONE / sine));
    let inverse = home.ring.var(inverse);
    let normal = vector::scale(&mut home.ring, &inverse, &cross);
    let sine = home.ring.mul(&square, &inverse);
    (sine, normal, inverse)
}

/// From the point of axis 1 to the foot of the common normal: (o₂ - o₁)·(z₁ - cos·z₂)/sin².
fn distance_to_foot(home: &mut Home<'_>, offset12: &V3<Poly>, cosine: &Poly, inverse_sine: &Poly) -> Poly {
    let (a, b) = (home.direction(0), home.direction(1));
    let part = vector::scale(&mut home.ring, cosine, &b);
    let direction = vector::sub(&mut home.ring, &a, &part);
    let distance = vector::dot(&mut home.ring, offset12, &direction);
    let once = home.ring.mul(&distance, inverse_sine);
    home.ring.mul(&once, inverse_sine)
}

/// The plane perpendicular to axis 2 through the foot of the common normal.
struct Plane {
    origin: V3<Poly>,
    x: V3<Poly>,
    y: V3<Poly>,
    shoulder: Poly,
}

impl Plane {
    /// A point's coordinates in the plane, measured from axis 2.
    fn project(&self, home: &mut Home<'_>, point: &V3<Poly>) -> Result<(Poly, Poly), Refusal> {
        let from_origin = vector::sub(&mut home.ring, point, &self.origin);
        let x = vector::dot(&mut home.ring, &from_origin, &self.x);
        let x = home.ring.sub(&x, &self.shoulder);
        let y = vector::dot(&mut home.ring, &from_origin, &self.y);
        Ok((x, y))
    }
}

type Direction = (Linear, Linear);
type Parts = (Figure, Direction, Quantity, bool);

fn elbow(home: &mut Home<'_>, plane: &Plane, carried: &V3<Poly>) -> Result<Parts, Refusal> {
    let (second, third) = (home.axes[1].clone(), home.axes[2].clone());
    if !parallel(&second.numbers, &third.numbers) {
        let degrees = degrees_between(&second.numbers, &third.numbers);
        return Err(Refusal::new(format!(
            "axes 2 and 3 are not parallel (the angle between them is {degrees:.6} degrees), which this family needs"
        )));
    }
    let dot = vector::dot(&mut home.ring, &second.direction, &third.direction);
    let reversed = home.ring.value(&dot).to_real() < Real::ZERO;
    let (x2, y2) = plane.project(home, &third.point)?;
    let (x, y) = plane.project(home, carried)?;
    let (x3, y3) = (home.ring.sub(&x, &x2), home.ring.sub(&y, &y2));
    let [x2, y2, x3, y3] = [x2, y2, x3, y3].map(|p| home.linear(&p));
    let (x2, y2, x3, y3) = (x2?, y2?, x3?, y3?);
    let tolerance = home.tolerance();
    if x2.vanishes(tolerance) && y2.vanishes(tolerance) {
        return Err(Refusal::new("axes 2 and 3 are the same line, so the two joints cannot be told apart"));
    }
    if x3.vanishes(tolerance) && y3.vanishes(tolerance) {
        return Err(Refusal::new(
            "the point that the base carries lies on axis 3, so joint 3 cannot move it",
        ));
    }
    let figure = Figure::Elbow { upper: Quantity::length(&x2, &y2), fore: Quantity::length(&x3, &y3) };
    // The figure angle of the elbow is measured from the upper arm to the forearm.
    let rest = home.axes[2].offset.clone();
    let rest = if reversed { Linear::constant(Real::ZERO).plus(&rest, Real::from_i64(-1)) } else { rest };
    let offset = Quantity::angle(rest, &[(false, x3, y3), (true, x2.clone(), y2.clone())]);
    Ok((figure, (x2, y2), offset, reversed))
}

fn telescope(home: &mut Home<'_>, plane: &Plane, carried: &V3<Poly>) -> Result<Parts, Refusal> {
    let (second, third) = (home.direction(1), home.direction(2));
    let tilt = vector::dot(&mut home.ring, &second, &third);
    if home.ring.value(&tilt).to_real().abs() > roundoff() {
        let degrees = degrees_between(&home.axes[1].numbers, &home.axes[2].numbers);
        return Err(Refusal::new(format!(
            "joint 3 does not slide perpendicularly to axis 2 (the angle is {degrees:.6} degrees), which this family needs"
        )));
    }
    let dx = vector::dot(&mut home.ring, &third, &plane.x);
    let dy = vector::dot(&mut home.ring, &third, &plane.y);
    let (x, y) = plane.project(home, carried)?;
    let (along_x, along_y) = (home.ring.mul(&x, &dx), home.ring.mul(&y, &dy));
    let along = home.ring.add(&along_x, &along_y);
    let (across_x, across_y) = (home.ring.mul(&x, &dy), home.ring.mul(&y, &dx));
    let across = home.ring.sub(&across_x, &across_y);
    let arm = home.linear(&across)?;
    let start = home.linear(&along)?.plus(&home.axes[2].offset, Real::ONE);
    // The link's own x axis is perpendicular to the slide: (dy, -dx).
    let minus_dx = dx.neg();
    let direction = (home.linear(&dy)?, home.linear(&minus_dx)?);
    Ok((Figure::Telescope { arm }, direction, Quantity::Linear(start), false))
}
