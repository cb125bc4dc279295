//! The determinant of the Jacobian as a product.
//!
//! It does not depend on the axes nor on the point whose velocity is meant. At the wrist centre the last three joints
//! move nothing, so that it is the product of two 3×3 determinants: of the linear rows of joints 1 to 3 and of the
//! directions of axes 4 to 6. Seen from the frame in which it is shortest, each has a row or a column with one entry
//! only, by which it is expanded; what is left is multiplied out and what its terms share is taken before it.

use std::ops::Range;

use super::basis::translate;
use super::{Formulas, column};
use crate::algebra::ring::{Poly, Ring};
use crate::algebra::vector::{self, M3, V3};

/// One factor.
#[derive(Clone, PartialEq, Debug)]
pub struct Factor {
    /// Whether it is a polynomial of the fused angles; otherwise of the joints' own.
    pub fused: bool,
    /// The polynomial.
    pub poly: Poly,
}

/// The determinant of the Jacobian.
#[derive(Clone, PartialEq, Debug)]
pub struct Determinant {
    /// The sign, lengths and integers before the product.
    pub coefficient: Poly,
    /// The factors that vary with the joints.
    pub factors: Vec<Factor>,
}

/// The determinant in both sets of angles, of each factor the shorter form.
pub(super) fn of(own: &Formulas, fused: &Formulas) -> Option<Determinant> {
    let (mut a, mut b) = (own.clone(), fused.clone());
    // An entry is zero in one set of angles exactly if it is in the other, so that both are expanded the same way.
    let (factors, seen_from) = raw_factors(&mut b, None)?;
    let (plain, _) = raw_factors(&mut a, Some(&seen_from))?;
    let mut coefficient = Poly::integer(1);
    let mut varying = Vec::new();
    for (own, fused) in plain.into_iter().zip(factors) {
        let (ring, poly, is_fused) =
            if own.len() < fused.len() { (&a.ring, own, false) } else { (&b.ring, fused, true) };
        let (content, rest) = ring.split_content(&poly);
        for part in [content, rest] {
            let (sizes, angles) = split(ring, &part);
            coefficient = b.ring.mul(&coefficient, &translate(ring, &b.ring, &sizes)?);
            if angles != Poly::integer(1) {
                varying.push(Factor { fused: is_fused, poly: angles });
            }
        }
    }
    Some(Determinant { coefficient, factors: varying })
}

/// The factors before anything is taken out of them, and the frames from which the two blocks are seen.
fn raw_factors(formulas: &mut Formulas, seen_from: Option<&[usize]>) -> Option<(Vec<Poly>, Vec<usize>)> {
    let axes = formulas.axes.clone();
    let ring = &mut formulas.ring;
    let (point, rest) = match (&formulas.wrist_centre, axes.len()) {
        (Some(centre), 6) => (centre.clone(), axes.get(3..)?),
        (None, 3) => (formulas.tip.position.clone(), [].as_slice()),
        _ => return None,
    };
    let mut columns: Vec<V3<Poly>> = Vec::new();
    for axis in axes.get(..3)? {
        let [a, b, c, ..] = column(ring, axis, &point);
        columns.push([a, b, c]);
    }
    let turns: Vec<_> = formulas.frames.iter().map(|f| f.rotation.clone()).collect();
    let mut blocks = vec![columns];
    if !rest.is_empty() {
        blocks.push(rest.iter().map(|axis| axis.direction.clone()).collect());
    }
    let (mut factors, mut chosen) = (Vec::new(), Vec::new());
    for (index, block) in blocks.iter().enumerate() {
        let frames = match seen_from.and_then(|frames| frames.get(index)) {
            Some(frame) => *frame..*frame + 1,
            None => 0..turns.len(),
        };
        let (frame, found) = shortest(ring, &turns, frames, block)?;
        factors.extend(found);
        chosen.push(frame);
    }
    Some((factors, chosen))
}

/// A monomial with its constants apart; anything else as it is.
fn split(ring: &Ring, part: &Poly) -> (Poly, Poly) {
    match ring.by_varying(part).as_slice() {
        [(varying, constant)] => (constant.clone(), varying.clone()),
        _ => (Poly::integer(1), part.clone()),
    }
}

/// The factors of the determinant of three columns, seen from the frame in which they have the fewest terms.
fn shortest(
    ring: &mut Ring,
    turns: &[M3<Poly>],
    frames: Range<usize>,
    columns: &[V3<Poly>],
) -> Option<(usize, Vec<Poly>)> {
    let mut best: Option<(usize, usize, Vec<Poly>)> = None;
    for frame in frames {
        let back = vector::transpose(turns.get(frame)?);
        let seen: Vec<V3<Poly>> = columns.iter().map(|v| vector::apply(ring, &back, v)).collect();
        let [x, y, z] = <[V3<Poly>; 3]>::try_from(seen).ok()?;
        let matrix = vector::from_columns(&x, &y, &z).map(Vec::from);
        let factors = expand(ring, &matrix);
        // One long factor is worth less than two short ones: terms multiply.
        let size = factors.iter().map(|f| f.len().pow(2)).sum();
        if best.as_ref().is_none_or(|(least, ..)| size < *least) {
            best = Some((size, frame, factors));
        }
    }
    best.map(|(_, frame, factors)| (frame, factors))
}

/// The determinant of a small square matrix as a product: by a row or column with one entry as long as there is one,
/// what is left multiplied out.
fn expand(ring: &Ring, matrix: &[Vec<Poly>]) -> Vec<Poly> {
    if let [row] = matrix
        && let [entry] = row.as_slice()
    {
        return vec![entry.clone()];
    }
    let size = matrix.len();
    let entry = |i: usize, j: usize| &matrix[i][j];
    let alone = |line: Vec<(usize, usize)>| {
        let filled: Vec<_> = line.into_iter().filter(|(i, j)| !entry(*i, *j).is_zero()).collect();
        if let [place] = filled.as_slice() { Some(*place) } else { None }
    };
    let rows = (0..size).map(|i| (0..size).map(|j| (i, j)).collect::<Vec<_>>());
    let columns = (0..size).map(|j| (0..size).map(|i| (i, j)).collect::<Vec<_>>());
    if let Some((i, j)) = rows.chain(columns).find_map(alone) {
        let pivot = ring.scale(entry(i, j), sign(i + j));
        let mut factors = vec![pivot];
        factors.extend(expand(ring, &minor(matrix, i, j)));
        return factors;
    }
    let mut sum = Poly::zero();
    for j in 0..size {
        let rest = expand(ring, &minor(matrix, 0, j)).into_iter();
        let product = rest.fold(entry(0, j).clone(), |product, factor| ring.mul(&product, &factor));
        sum = ring.add(&sum, &ring.scale(&product, sign(j)));
    }
    vec![sum]
}

fn sign(place: usize) -> i64 {
    if place.is_multiple_of(2) { 1 } else { -1 }
}

/// The matrix without one row and one column.
fn minor(matrix: &[Vec<Poly>], row: usize, column: usize) -> Vec<Vec<Poly>> {
    let without = |entries: &Vec<Poly>| {
        let kept = entries.iter().enumerate().filter(|(j, _)| *j != column);
        kept.map(|(_, entry)| entry.clone()).collect()
    };
    matrix.iter().enumerate().filter(|(i, _)| *i != row).map(|(_, entries)| without(entries)).collect()
}
