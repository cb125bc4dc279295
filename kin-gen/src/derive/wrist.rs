//! What a spherical wrist is solved with: ³R₆, ⁰R₃ with the wrist centre, and their counterparts for a given pose.

use super::pose::{TermPose, by_plan, cheapest_style, fk, rotation_name};
use super::{Deriver, Style, planned_or};
use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::Frames;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::plan;

/// ³R₆ of the last three joints.
pub fn r36(exprs: &mut Exprs, frames: &Frames) -> M3<Term> {
    planned_or(
        exprs,
        |exprs| {
            let (pose, own) = by_plan(plan::planned_turn(exprs, frames)?)?;
            Some((pose.rotation, own))
        },
        |exprs| r36_by_style(exprs, frames),
    )
}

/// Staged column by column, or with the four products of outer sines and cosines shared.
fn r36_by_style(exprs: &mut Exprs, frames: &Frames) -> M3<Term> {
    let start = exprs.mark();
    let staged =
        |exprs: &mut Exprs| cheapest_style(exprs, frames, |d| d.rotation(&frames.tip, &rotation_name));
    staged(exprs);
    let work_staged = exprs.work_since(start);
    exprs.roll_back(start);
    if let Some(shared) = outer_products(exprs, frames)
        && exprs.work_since(start) < work_staged
    {
        return shared;
    }
    exprs.roll_back(start);
    staged(exprs)
}

/// K₀·Rz(a)·M·Rz(c)·K₃ with M = K₁·Rz(b)·K₂: each entry of the inner 2×2 block is a sum of products cos a·cos c,
/// sin a·sin c, … with an entry of M, and those four products serve all of them.
fn outer_products(exprs: &mut Exprs, frames: &Frames) -> Option<M3<Term>> {
    let [first, second, third] = frames.groups.as_slice() else { return None };
    let [a, b, c] =
        [first, second, third].map(|g| g.stages.first().map(|s| s.turn.clone()).unwrap_or_default());
    if [first, second, third].iter().any(|g| g.stages.len() != 1) {
        return None;
    }
    let (cb, sb) = exprs.cos_sin(&b);
    let turn_b = vector::rotation(exprs, 2, &cb, &sb);
    let left = vector::product(exprs, &second.from_previous, &turn_b);
    let middle = vector::product(exprs, &left, &third.from_previous);
    let (ca, sa) = exprs.cos_sin(&a);
    let (cc, sc) = exprs.cos_sin(&c);
    let outer_left = vector::rotation(exprs, 2, &ca, &sa);
    let outer_right = vector::rotation(exprs, 2, &cc, &sc);
    let mut inner = [[Term::ZERO; 3]; 3];
    for (i, row) in inner.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            for k in 0..3 {
                for l in 0..3 {
                    let product = exprs.mul(outer_left[i][k], outer_right[l][j]);
                    let part = exprs.mul(middle[k][l], product);
                    *entry = exprs.add(*entry, part);
                }
            }
        }
    }
    let inner = vector::product(exprs, &first.from_previous, &inner);
    Some(vector::product(exprs, &inner, &frames.tip.local))
}

/// ⁰R₃ and a point fixed in frame 3.
pub fn r03(exprs: &mut Exprs, frames: &Frames, point: &V3<Poly>) -> TermPose {
    let frames = with_tip_at(exprs, frames, point);
    fk(exprs, &frames)
}

/// The frames with the tip moved to a point fixed in it.
pub fn with_tip_at(exprs: &mut Exprs, frames: &Frames, point: &V3<Poly>) -> Frames {
    let mut tip = frames.tip.clone();
    let point = constants(exprs, point);
    let offset = vector::apply(exprs, &tip.local, &point);
    tip.shift = vector::add(exprs, &tip.shift, &offset);
    Frames { tip, ..frames.clone() }
}

/// The given pose's entries as a matrix and a vector.
fn given(exprs: &mut Exprs) -> (M3<Term>, V3<Term>) {
    let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| exprs.entry(3 * i + j)));
    (rotation, [9, 10, 11].map(|i| exprs.entry(i)))
}

/// Polynomials in lengths, constants and length parameters as terms.
pub fn constants(exprs: &mut Exprs, v: &V3<Poly>) -> V3<Term> {
    v.clone().map(|p| exprs.polynomial(&p))
}

/// A matrix of such polynomials as terms.
pub fn constant_matrix(exprs: &mut Exprs, m: &M3<Poly>) -> M3<Term> {
    m.clone().map(|row| constants(exprs, &row))
}

/// The point of the given pose that lies at `local` in it, seen in the frame with orientation `axes` and `origin`.
pub fn point_of_pose(exprs: &mut Exprs, local: &V3<Poly>, axes: &M3<Poly>, origin: &V3<Poly>) -> V3<Term> {
    let (rotation, position) = given(exprs);
    let local = constants(exprs, local);
    let axes = vector::transpose(&constant_matrix(exprs, axes));
    let origin = constants(exprs, origin);
    let offset = vector::apply(exprs, &rotation, &local);
    let from_world = vector::add(exprs, &position, &offset);
    let from_origin = vector::sub(exprs, &from_world, &origin);
    vector::apply(exprs, &axes, &from_origin)
}

/// ³R₆ = ⁰R₃ᵀ·Bᵀ·R·Q of a given rotation R, up through the frames of the first three joints.
pub fn rotation_of_pose(exprs: &mut Exprs, frames: &Frames, before: &M3<Poly>, after: &M3<Poly>) -> M3<Term> {
    let wanted = framed(exprs, before, after);
    let mut d = Deriver::new(exprs, frames, Style::Descend);
    let columns = [0, 1, 2].map(|i| {
        let mut v = vector::column(&wanted, i);
        for (index, group) in frames.groups.iter().enumerate() {
            let back = vector::transpose(&group.from_previous);
            v = vector::apply(d.exprs, &back, &v);
            v = d.turn_back(index, group.stages.len() - 1, &v);
            let seen_from = group.stages.last().map_or(0, |s| s.joint + 1);
            for (row, term) in v.iter().enumerate() {
                d.exprs.label(*term, || format!("m{}{}_{seen_from}", row + 1, i + 1));
            }
        }
        vector::apply(d.exprs, &vector::transpose(&frames.tip.local), &v)
    });
    vector::from_columns(&columns[0], &columns[1], &columns[2])
}

/// A point fixed in the world as the given pose sees it, in the frame with orientation `axes` and `origin` in that pose.
pub fn point_seen_from_pose(
    exprs: &mut Exprs,
    point: &V3<Poly>,
    axes: &M3<Poly>,
    origin: &V3<Poly>,
) -> V3<Term> {
    let (rotation, position) = given(exprs);
    let point = constants(exprs, point);
    let axes = vector::transpose(&constant_matrix(exprs, axes));
    let origin = constants(exprs, origin);
    let from_tool = vector::sub(exprs, &point, &position);
    let seen = vector::apply(exprs, &vector::transpose(&rotation), &from_tool);
    let from_origin = vector::sub(exprs, &seen, &origin);
    vector::apply(exprs, &axes, &from_origin)
}

/// ⁰R₃ = Bᵀ·R·Q·³R₆ᵀ of a given rotation R: its rows, down through the frames of the last three joints.
pub fn rotation_before(exprs: &mut Exprs, frames: &Frames, before: &M3<Poly>, after: &M3<Poly>) -> M3<Term> {
    let wanted = framed(exprs, before, after);
    let mut d = Deriver::new(exprs, frames, Style::Descend);
    [0, 1, 2].map(|i| {
        let mut v = vector::apply(d.exprs, &frames.tip.local, &wanted[i]);
        for (index, group) in frames.groups.iter().enumerate().rev() {
            v = d.turn(index, group.stages.len() - 1, &v);
            v = vector::apply(d.exprs, &group.from_previous, &v);
            let seen_from = group.stages.first().map_or(0, |s| s.joint);
            for (column, term) in v.iter().enumerate() {
                d.exprs.label(*term, || format!("m{}{}_{seen_from}", i + 1, column + 1));
            }
        }
        v
    })
}

/// Fᵀ·R·G of a given rotation.
pub fn framed(exprs: &mut Exprs, before: &M3<Poly>, after: &M3<Poly>) -> M3<Term> {
    let (rotation, _) = given(exprs);
    let before = vector::transpose(&constant_matrix(exprs, before));
    let after = constant_matrix(exprs, after);
    let left = vector::product(exprs, &before, &rotation);
    vector::product(exprs, &left, &after)
}
