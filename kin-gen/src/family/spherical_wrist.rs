//! Arms with six joints whose last three axes meet, on a three-joint base.
//!
//! The wrist centre is carried by the first three joints alone, so position and orientation separate (Pieper 1968):
//! the base is solved for the wrist centre, the wrist for what rotation remains.

use super::base::{self, Base};
use super::home::Home;
use super::{Inverse, Refusal};
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::chain::JointKind;
use crate::number::Real;
use crate::quantity::{Linear, Quantity};

/// How the three wrist angles are read from a rotation m = before·³R₆·after, the first possibly transposed.
#[derive(Clone, Debug)]
pub enum WristForm {
    /// Axis 5 perpendicular to axes 4 and 6: m = Rz(a)·Ry(b)·Rz(c).
    Orthogonal,
    /// Any other angles: m = Rz(a)·K₄·Rz(b)·K₅·Rz(c), with these two rotations by rows.
    Oblique(Box<[[[Real; 3]; 3]; 2]>),
}

/// The wrist.
#[derive(Clone, Debug)]
pub struct Wrist {
    /// How it is read.
    pub form: WristForm,
    /// F of m = Fᵀ·³R₆·G, by rows.
    pub before: M3<Poly>,
    /// G of m = Fᵀ·³R₆·G, by rows.
    pub after: M3<Poly>,
    /// What is added to each row value to give the angle in m.
    pub offsets: [Quantity; 3],
}

/// What the spherical-wrist solver needs.
#[derive(Clone, Debug)]
pub struct SphericalWrist {
    /// The base, carrying the wrist centre.
    pub base: Base,
    /// The wrist.
    pub wrist: Wrist,
    /// The wrist centre in frame 3.
    pub centre_in_frame3: V3<Poly>,
    /// The wrist centre in the tool's frame.
    pub centre_in_tool: V3<Poly>,
    /// From the tool's orientation back to frame 6: ⁰R₆ = R·this.
    pub tool_to_frame6: M3<Poly>,
}

/// Recognises the family.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    home.require_fixed_directions()?;
    if let Some(index) = (3..6).find(|i| home.axes[*i].kind != JointKind::Revolute) {
        return Err(Refusal::new(format!(
            "joint {} slides, so the last three axes are no spherical wrist",
            index + 1
        )));
    }
    let centre = wrist_centre(home)?;
    let base = base::recognise(home, &centre)?;
    let wrist = wrist(home);
    let centre_in_frame3 = seen_from(home, &centre, 2);
    let tip = home.tip.clone();
    let from_tip = vector::sub(&mut home.ring, &centre, &tip.position);
    let centre_in_tool = vector::apply(&mut home.ring, &vector::transpose(&tip.rotation), &from_tip);
    // Behind joint 6 nothing moves: what lies between the tool and frame 6 is the same in every position.
    let frame6 = home.frames[5].rotation.clone();
    let tool_to_frame6 = vector::product(&mut home.ring, &vector::transpose(&tip.rotation), &frame6);
    Ok(Inverse::Pose(Box::new(SphericalWrist {
        base,
        wrist,
        centre_in_frame3,
        centre_in_tool,
        tool_to_frame6,
    })))
}

/// A point in the coordinates of one joint's frame.
fn seen_from(home: &mut Home<'_>, point: &V3<Poly>, joint: usize) -> V3<Poly> {
    let frame = home.frames[joint].clone();
    let offset = vector::sub(&mut home.ring, point, &frame.position);
    vector::apply(&mut home.ring, &vector::transpose(&frame.rotation), &offset)
}

/// The point in which axes 4, 5 and 6 meet, or the sentence that says by how much they do not.
fn wrist_centre(home: &mut Home<'_>) -> Result<V3<Poly>, Refusal> {
    for (a, b) in [(3, 4), (4, 5)] {
        if base::parallel(&home.axes[a].numbers, &home.axes[b].numbers) {
            return Err(Refusal::new(format!(
                "axes 4, 5 and 6 are no spherical wrist: axes {} and {} are parallel",
                a + 1,
                b + 1
            )));
        }
    }
    let between = home.between(3, 4);
    let gap = distance_of_lines(home, 3, 4, &between)?;
    if !gap.vanishes(home.tolerance()) {
        return Err(refuse(home, &format!("axes 4 and 5 pass each other at {}", home.say_length(&gap)), 4));
    }
    let centre = common_point(home, &between)?;
    let from_axis6 = vector::sub(&mut home.ring, &centre, &home.axes[5].point.clone());
    let direction = home.direction(5);
    let across = vector::cross(&mut home.ring, &from_axis6, &direction);
    let forms = [0, 1, 2].map(|i| home.linear(&across[i]));
    let [x, y, z] = forms;
    let miss = norm(&[x?, y?, z?]);
    if !miss.vanishes(home.tolerance()) {
        let distance = home.say_length(&miss);
        return Err(refuse(
            home,
            &format!("axis 6 misses the common point of axes 4 and 5 by {distance}"),
            5,
        ));
    }
    Ok(centre)
}

fn refuse(home: &Home<'_>, what: &str, joint: usize) -> Refusal {
    let culprit = culprit(home, joint);
    Refusal { reason: format!("axes 4, 5 and 6 do not meet in one point: {what}"), culprit }
}

/// The last translation before joint `joint` that lies behind joint 4: the likeliest cell.
fn culprit(home: &Home<'_>, joint: usize) -> Option<usize> {
    let elements = &home.chain.elements;
    let position = |wanted: usize| {
        elements
            .iter()
            .position(|e| matches!(e.motion, crate::chain::Motion::Revolute { joint, .. } if joint == wanted))
    };
    let (from, to) = (position(3)?, position(joint)?);
    (from..to).rev().find(|i| matches!(elements[*i].motion, crate::chain::Motion::Shift(_)))
}

/// The length of a vector of linear forms; a parameter in any of them stays visible.
fn norm(v: &[Linear; 3]) -> Linear {
    let square = v.iter().fold(Real::ZERO, |sum, l| sum + l.constant * l.constant);
    let mut length = Linear::constant(square.sqrt());
    length.params = v.iter().flat_map(|l| l.params.clone()).collect();
    length
}

/// The distance of two lines that are not parallel: the share of `between` along their common normal.
fn distance_of_lines(home: &mut Home<'_>, a: usize, b: usize, between: &V3<Poly>) -> Result<Linear, Refusal> {
    let (u, v) = (home.direction(a), home.direction(b));
    let normal = vector::cross(&mut home.ring, &u, &v);
    let square = vector::dot(&mut home.ring, &normal, &normal);
    let share = vector::dot(&mut home.ring, between, &normal);
    let length = home.ring.value(&square).to_real().sqrt();
    let share = home.linear(&share)?;
    Ok(Linear::constant(Real::ZERO).plus(&share, Real::ONE / length))
}

/// Where axis 4 meets axis 5: o₄ + z₄·((o₅ - o₄)·(z₄ - cos·z₅))/sin², with a constant for 1/sin² where it is needed.
fn common_point(home: &mut Home<'_>, between: &V3<Poly>) -> Result<V3<Poly>, Refusal> {
    let (u, v) = (home.direction(3), home.direction(4));
    let cosine = vector::dot(&mut home.ring, &u, &v);
    let part = vector::scale(&mut home.ring, &cosine, &v);
    let direction = vector::sub(&mut home.ring, &u, &part);
    let mut along = vector::dot(&mut home.ring, between, &direction);
    if !home.ring.vanishes(&cosine) {
        let cosine = home.ring.value(&cosine).to_real();
        let inverse = Real::ONE / (Real::ONE - cosine * cosine);
        let inverse = home.ring.constant("inverse_square", crate::number::Scalar::Real(inverse));
        let inverse = home.ring.var(inverse);
        along = home.ring.mul(&along, &inverse);
    }
    let step = vector::scale(&mut home.ring, &along, &u);
    let point = home.axes[3].point.clone();
    Ok(vector::add(&mut home.ring, &point, &step))
}

/// How the wrist's angles are read from ³R₆.
fn wrist(home: &mut Home<'_>) -> Wrist {
    let frame3 = vector::transpose(&home.frames[2].rotation);
    let [z4, z5, z6] = [3, 4, 5].map(|i| {
        let direction = home.direction(i);
        vector::apply(&mut home.ring, &frame3, &direction)
    });
    let at_home = {
        let frame6 = home.frames[5].rotation.clone();
        vector::product(&mut home.ring, &frame3, &frame6)
    };
    let orthogonal = [(&z4, &z5), (&z5, &z6)].iter().all(|(a, b)| {
        let cosine = vector::dot(&mut home.ring, a, b);
        home.ring.vanishes(&cosine)
    });
    let offset = |i: usize| home.axes[i].offset.clone();
    if orthogonal {
        let x = vector::cross(&mut home.ring, &z5, &z4);
        let before = vector::from_columns(&x, &z5, &z4);
        let (cosine, sine) = (vector::dot(&mut home.ring, &z6, &z4), vector::dot(&mut home.ring, &z6, &x));
        let bend = vector::rotation(&mut home.ring, 1, &cosine, &sine);
        let left = vector::product(&mut home.ring, &vector::transpose(&at_home), &before);
        let after = vector::product(&mut home.ring, &left, &bend);
        let direction = [&cosine, &sine].map(|p| Linear::constant(home.ring.value(p).to_real()));
        let [cosine, sine] = direction;
        let offsets = [
            Quantity::angle(offset(3), &[]),
            Quantity::angle(offset(4), &[(false, cosine, sine)]),
            Quantity::angle(offset(5), &[]),
        ];
        return Wrist { form: WristForm::Orthogonal, before, after, offsets };
    }
    oblique(home, [z4, z5, z6], &at_home)
}

/// ³R₆ = B₄·Rz(a)·B₄ᵀ·B₅·Rz(b)·B₅ᵀ·B₆·Rz(c)·B₆ᵀ·H, each B taking z to its axis: F = B₄, K₄ = B₄ᵀB₅, K₅ = B₅ᵀB₆.
fn oblique(home: &mut Home<'_>, axes: [V3<Poly>; 3], at_home: &M3<Poly>) -> Wrist {
    let frames = axes.map(|z| {
        let numbers = z.clone().map(|p| home.ring.value(&p).to_real());
        (numbers_to_polys(home, &basis(&numbers)), basis(&numbers))
    });
    let [(b4, n4), (_, n5), (b6, n6)] = frames;
    let after = vector::product(&mut home.ring, &vector::transpose(at_home), &b6);
    let offsets = [3, 4, 5].map(|i| Quantity::angle(home.axes[i].offset.clone(), &[]));
    Wrist {
        form: WristForm::Oblique(Box::new([relative(&n4, &n5), relative(&n5, &n6)])),
        before: b4,
        after,
        offsets,
    }
}

/// A rotation whose third column is the given unit vector.
fn basis(z: &[Real; 3]) -> [[Real; 3]; 3] {
    // The coordinate axis that z is farthest from makes the best conditioned product.
    let least = if z[0].abs() <= z[1].abs() && z[0].abs() <= z[2].abs() {
        0
    } else if z[1].abs() <= z[2].abs() {
        1
    } else {
        2
    };
    let mut e = [Real::ZERO; 3];
    e[least] = Real::ONE;
    let cross =
        |a: &[Real; 3], b: &[Real; 3]| [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i]);
    let x = cross(&e, z);
    let length = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
    let x = x.map(|c| c / length);
    let y = cross(z, &x);
    [0, 1, 2].map(|i| [x[i], y[i], z[i]])
}

fn relative(a: &[[Real; 3]; 3], b: &[[Real; 3]; 3]) -> [[Real; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[0][i] * b[0][j] + a[1][i] * b[1][j] + a[2][i] * b[2][j]))
}

fn numbers_to_polys(home: &mut Home<'_>, m: &[[Real; 3]; 3]) -> M3<Poly> {
    m.map(|row| {
        row.map(|value| {
            if value.is_negligible() {
                return Poly::zero();
            }
            match value.to_f64() {
                1.0 if (value - Real::ONE).is_negligible() => Poly::integer(1),
                -1.0 if (value + Real::ONE).is_negligible() => Poly::integer(-1),
                _ => {
                    let var = home.ring.constant("m", crate::number::Scalar::Real(value));
                    home.ring.var(var)
                }
            }
        })
    })
}
