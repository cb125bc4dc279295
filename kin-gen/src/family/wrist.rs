//! Three turning axes through one point, a wrist or a shoulder: where they meet, and how their angles are read.

use super::home::Home;
use super::{Refusal, base};
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::chain::{JointKind, Motion};
use crate::number::{Real, Scalar};
use crate::quantity::{Linear, Quantity};

/// How the three angles are read from a rotation m = before·R·after, the first possibly transposed, where R is what the
/// three joints turn by: ³R₆ for a wrist.
#[derive(Clone, Debug)]
pub enum WristForm {
    /// The middle axis perpendicular to the other two: m = Rz(a)·Ry(b)·Rz(c).
    Orthogonal,
    /// Any other angles: m = Rz(a)·K₄·Rz(b)·K₅·Rz(c), with these two rotations by rows.
    Oblique(Box<[[[Real; 3]; 3]; 2]>),
}

/// Three axes through one point.
#[derive(Clone, Debug)]
pub struct Wrist {
    /// How it is read.
    pub form: WristForm,
    /// F of m = Fᵀ·R·G, by rows.
    pub before: M3<Poly>,
    /// G of m = Fᵀ·R·G, by rows.
    pub after: M3<Poly>,
    /// What is added to each row value to give the angle in m.
    pub offsets: [Quantity; 3],
}

/// Three neighbouring joints, and what they would be if their axes met.
#[derive(Clone, Copy, Debug)]
pub struct Triple {
    /// The first of them, counted from 0.
    pub first: usize,
    /// As it is called: `wrist`.
    pub name: &'static str,
}

impl Triple {
    /// The three joints, counted from 0.
    fn joints(self) -> [usize; 3] {
        [0, 1, 2].map(|i| self.first + i)
    }

    /// `axes 4, 5 and 6`.
    fn axes(self) -> String {
        let [a, b, c] = self.joints().map(|joint| joint + 1);
        format!("axes {a}, {b} and {c}")
    }

    /// The point in which the axes meet, or the sentence that says by how much they do not.
    pub fn centre(self, home: &mut Home<'_>) -> Result<V3<Poly>, Refusal> {
        let [a, b, c] = self.joints();
        if let Some(slide) = self.joints().into_iter().find(|i| home.axes[*i].kind != JointKind::Revolute) {
            return Err(Refusal::new(format!(
                "joint {} slides, so {} are no spherical {}",
                slide + 1,
                self.axes(),
                self.name
            )));
        }
        for (i, j) in [(a, b), (b, c)] {
            if base::parallel(&home.axes[i].numbers, &home.axes[j].numbers) {
                return Err(Refusal::new(format!(
                    "{} are no spherical {}: axes {} and {} are parallel",
                    self.axes(),
                    self.name,
                    i + 1,
                    j + 1
                )));
            }
        }
        let centre = self.meeting_of_two(home)?;
        let from_last = vector::sub(&mut home.ring, &centre, &home.axes[c].point.clone());
        let direction = home.direction(c);
        let across = vector::cross(&mut home.ring, &from_last, &direction);
        let [x, y, z] = [0, 1, 2].map(|i| home.linear(&across[i]));
        let miss = norm(&[x?, y?, z?]);
        if !miss.vanishes(home.tolerance()) {
            let distance = home.say_length(&miss);
            let what = format!(
                "axis {} misses the common point of axes {} and {} by {distance}",
                c + 1,
                a + 1,
                b + 1
            );
            return Err(self.refuse(home, &what, c));
        }
        Ok(centre)
    }

    /// The point in which the first two axes meet.
    pub(super) fn meeting_of_two(self, home: &mut Home<'_>) -> Result<V3<Poly>, Refusal> {
        let [a, b, _] = self.joints();
        let axes = format!("axes {} and {}", a + 1, b + 1);
        if base::parallel(&home.axes[a].numbers, &home.axes[b].numbers) {
            return Err(Refusal::new(format!(
                "{axes} are parallel, so that no point of both stays in its place"
            )));
        }
        let between = home.between(a, b);
        let gap = distance_of_lines(home, a, b, &between)?;
        if !gap.vanishes(home.tolerance()) {
            let what = format!("{axes} pass each other at {}", home.say_length(&gap));
            return Err(self.refuse(home, &what, b));
        }
        Ok(common_point(home, a, b, &between))
    }

    fn refuse(self, home: &Home<'_>, what: &str, joint: usize) -> Refusal {
        let culprit = culprit(home, self.first, joint);
        // Of two joints behind a base there is no third axis to speak of.
        let axes =
            if self.first + 2 < home.axes.len() { self.axes() } else { "the last two axes".to_owned() };
        Refusal { reason: format!("{axes} do not meet in one point: {what}"), culprit }
    }

    /// How the angles are read from the rotation between two frames, given at home: `from` before the first of the three
    /// joints, `to` behind the last.
    pub fn angles(self, home: &mut Home<'_>, from: &M3<Poly>, to: &M3<Poly>) -> Wrist {
        let back = vector::transpose(from);
        let [z4, z5, z6] = self.joints().map(|i| {
            let direction = home.direction(i);
            vector::apply(&mut home.ring, &back, &direction)
        });
        let at_home = vector::product(&mut home.ring, &back, to);
        let orthogonal = [(&z4, &z5), (&z5, &z6)].iter().all(|(a, b)| {
            let cosine = vector::dot(&mut home.ring, a, b);
            home.ring.vanishes(&cosine)
        });
        let offsets = self.joints().map(|i| home.axes[i].offset.clone());
        if orthogonal {
            orthogonal_wrist(home, [z4, z5, z6], &at_home, offsets)
        } else {
            oblique(home, [z4, z5, z6], &at_home, offsets)
        }
    }
}

/// The last translation before joint `joint` that lies behind joint `first`: the likeliest cell.
fn culprit(home: &Home<'_>, first: usize, joint: usize) -> Option<usize> {
    let elements = &home.chain.elements;
    let position = |wanted: usize| {
        elements.iter().position(|e| matches!(e.motion, Motion::Revolute { joint, .. } if joint == wanted))
    };
    let (from, to) = (position(first)?, position(joint)?);
    (from..to).rev().find(|i| matches!(elements[*i].motion, Motion::Shift(_)))
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

/// Where axis a meets axis b: o_a + z_a·((o_b - o_a)·(z_a - cos·z_b))/sin², with a constant for 1/sin² where it is needed.
fn common_point(home: &mut Home<'_>, a: usize, b: usize, between: &V3<Poly>) -> V3<Poly> {
    let (u, v) = (home.direction(a), home.direction(b));
    let cosine = vector::dot(&mut home.ring, &u, &v);
    let part = vector::scale(&mut home.ring, &cosine, &v);
    let direction = vector::sub(&mut home.ring, &u, &part);
    let mut along = vector::dot(&mut home.ring, between, &direction);
    if !home.ring.vanishes(&cosine) {
        let cosine = home.ring.value(&cosine).to_real();
        let inverse = Real::ONE / (Real::ONE - cosine * cosine);
        let inverse = home.ring.constant("inverse_square", Scalar::Real(inverse));
        let inverse = home.ring.var(inverse);
        along = home.ring.mul(&along, &inverse);
    }
    let step = vector::scale(&mut home.ring, &along, &u);
    let point = home.axes[a].point.clone();
    vector::add(&mut home.ring, &point, &step)
}

fn orthogonal_wrist(
    home: &mut Home<'_>,
    [z4, z5, z6]: [V3<Poly>; 3],
    at_home: &M3<Poly>,
    [o4, o5, o6]: [Linear; 3],
) -> Wrist {
    let x = vector::cross(&mut home.ring, &z5, &z4);
    let before = vector::from_columns(&x, &z5, &z4);
    let (cosine, sine) = (vector::dot(&mut home.ring, &z6, &z4), vector::dot(&mut home.ring, &z6, &x));
    let bend = vector::rotation(&mut home.ring, 1, &cosine, &sine);
    let left = vector::product(&mut home.ring, &vector::transpose(at_home), &before);
    let after = vector::product(&mut home.ring, &left, &bend);
    let [cosine, sine] = [&cosine, &sine].map(|p| Linear::constant(home.ring.value(p).to_real()));
    let offsets =
        [Quantity::angle(o4, &[]), Quantity::angle(o5, &[(false, cosine, sine)]), Quantity::angle(o6, &[])];
    Wrist { form: WristForm::Orthogonal, before, after, offsets }
}

/// ³R₆ = B₄·Rz(a)·B₄ᵀ·B₅·Rz(b)·B₅ᵀ·B₆·Rz(c)·B₆ᵀ·H, each B taking z to its axis: F = B₄, K₄ = B₄ᵀB₅, K₅ = B₅ᵀB₆.
fn oblique(home: &mut Home<'_>, axes: [V3<Poly>; 3], at_home: &M3<Poly>, offsets: [Linear; 3]) -> Wrist {
    let frames = axes.map(|z| {
        let numbers = z.clone().map(|p| home.ring.value(&p).to_real());
        (numbers_to_polys(home, &basis(&numbers)), basis(&numbers))
    });
    let [(b4, n4), (_, n5), (b6, n6)] = frames;
    let after = vector::product(&mut home.ring, &vector::transpose(at_home), &b6);
    Wrist {
        form: WristForm::Oblique(Box::new([relative(&n4, &n5), relative(&n5, &n6)])),
        before: b4,
        after,
        offsets: offsets.map(|offset| Quantity::angle(offset, &[])),
    }
}

/// A rotation whose third column is the given unit vector.
pub(super) fn basis(z: &[Real; 3]) -> [[Real; 3]; 3] {
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

pub(super) fn relative(a: &[[Real; 3]; 3], b: &[[Real; 3]; 3]) -> [[Real; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[0][i] * b[0][j] + a[1][i] * b[1][j] + a[2][i] * b[2][j]))
}

pub(super) fn numbers_to_polys(home: &mut Home<'_>, m: &[[Real; 3]; 3]) -> M3<Poly> {
    m.map(|row| {
        row.map(|value| {
            if value.is_negligible() {
                return Poly::zero();
            }
            match value.to_f64() {
                1.0 if (value - Real::ONE).is_negligible() => Poly::integer(1),
                -1.0 if (value + Real::ONE).is_negligible() => Poly::integer(-1),
                _ => {
                    let var = home.ring.constant("m", Scalar::Real(value));
                    home.ring.var(var)
                }
            }
        })
    })
}
