//! The geometric Jacobian: column j is the velocity of the tool point, then the angular velocity, for a unit rate of
//! the commanded value of joint j, in the axes of the base.
//!
//! For a revolute joint with axis z through a point from which the tip is seen at w, the linear part is z × w
//! (Whitney 1972). In the frame of the joint's own group z is a unit vector, so z × w = (-w_y, w_x, 0) costs nothing
//! and only has to be brought to the world; or both are brought there and multiplied: whichever adds less.

use super::pose::{Reach, Reaches, TermPose, cheapest_style, reaches, rotation_name};
use super::{Deriver, planned_or, pose};
use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::Frames;
use crate::algebra::vector::{self, V3};
use crate::plan::{self, Planned, Wanted};

/// A column: the linear part, then the angular part.
pub type Column = [Term; 6];

/// The Jacobian alone.
pub fn jacobian(exprs: &mut Exprs, frames: &Frames, couple: &[Vec<i64>]) -> Vec<Column> {
    planned_or(
        exprs,
        |exprs| {
            let planned = plan::planned(exprs, frames, Wanted::Jacobian)?;
            Some((planned_columns(exprs, &planned, couple), planned.own))
        },
        |exprs| cheapest_style(exprs, frames, |d| alone(d, couple)),
    )
}

/// The pose and the Jacobian, planned together: the columns of one serve the other.
pub fn fk_jacobian(exprs: &mut Exprs, frames: &Frames, couple: &[Vec<i64>]) -> (TermPose, Vec<Column>) {
    planned_or(
        exprs,
        |exprs| {
            let planned = plan::planned(exprs, frames, Wanted::Both)?;
            let columns = planned_columns(exprs, &planned, couple);
            let (pose, own) = pose::by_plan(planned)?;
            Some(((pose, columns), own))
        },
        |exprs| both_by_style(exprs, frames, couple),
    )
}

/// The columns of a plan, for the commanded values.
fn planned_columns(exprs: &mut Exprs, planned: &Planned, couple: &[Vec<i64>]) -> Vec<Column> {
    let mut rows: Vec<Column> = vec![[Term::ZERO; 6]; couple.len()];
    for (joint, velocity, axis) in &planned.columns {
        rows[*joint] = join(velocity, axis);
    }
    commanded(exprs, &rows, couple)
}

fn both_by_style(exprs: &mut Exprs, frames: &Frames, couple: &[Vec<i64>]) -> (TermPose, Vec<Column>) {
    let start = exprs.mark();
    let mut work = [0, 0];
    for (work, pose_first) in work.iter_mut().zip([true, false]) {
        cheapest_style(exprs, frames, |d| both(d, couple, pose_first));
        *work = exprs.work_since(start);
        exprs.roll_back(start);
    }
    cheapest_style(exprs, frames, |d| both(d, couple, work[0] <= work[1]))
}

/// The pose and the Jacobian, in either order: what comes first is there for the other to use.
pub fn both(d: &mut Deriver<'_>, couple: &[Vec<i64>], pose_first: bool) -> (TermPose, Vec<Column>) {
    let tip = &d.frames.tip;
    if pose_first {
        let rotation = d.rotation(tip, &rotation_name);
        let reach = reaches(d, tip);
        let columns = columns(d, &reach, couple);
        (TermPose { rotation, position: reach.from_world }, columns)
    } else {
        let reach = reaches(d, tip);
        let columns = columns(d, &reach, couple);
        let rotation = d.rotation(tip, &rotation_name);
        (TermPose { rotation, position: reach.from_world }, columns)
    }
}

/// The columns alone.
pub fn alone(d: &mut Deriver<'_>, couple: &[Vec<i64>]) -> Vec<Column> {
    let reach = reaches(d, &d.frames.tip);
    columns(d, &reach, couple)
}

fn columns(d: &mut Deriver<'_>, reach: &Reaches, couple: &[Vec<i64>]) -> Vec<Column> {
    let frames = d.frames;
    let mut rows: Vec<Column> = vec![[Term::ZERO; 6]; couple.len()];
    for (group, stages) in frames.groups.iter().enumerate() {
        for (stage, joint) in stages.stages.iter().enumerate() {
            let name = joint.joint + 1;
            let axis = d.column(2 * group + 1, 2, &|row| format!("z{name}{}", ["x", "y", "z"][row]));
            let velocity =
                reach.from_axis[group].get(stage).map_or([Term::ZERO; 3], |w| linear(d, group, w, name));
            let (velocity, axis) = match joint.negative {
                true => (vector::negate(d.exprs, &velocity), vector::negate(d.exprs, &axis)),
                false => (velocity, axis),
            };
            rows[joint.joint] = join(&velocity, &axis);
        }
    }
    for slide in &frames.slides {
        let (level, direction) = d.carry(slide.carrier, &slide.direction);
        let direction =
            d.to_world(level, &direction, &|row| format!("d{}{}", slide.joint + 1, ["x", "y", "z"][row]));
        rows[slide.joint] = join(&direction, &[Term::ZERO; 3]);
    }
    commanded(d.exprs, &rows, couple)
}

/// The velocity of the tip for a unit rate about the group's z.
fn linear(d: &mut Deriver<'_>, group: usize, w: &Reach, joint: usize) -> V3<Term> {
    let name = move |row: usize| format!("v{joint}{}", ["x", "y", "z"][row]);
    let level = 2 * group + 1;
    let across = |d: &mut Deriver<'_>, w: &V3<Term>| [d.exprs.neg(w[1]), w[0], Term::ZERO];
    let in_group = |d: &mut Deriver<'_>| {
        let total = w.total(d.exprs);
        let v = across(d, &total);
        d.to_world(level, &v, &name)
    };
    let in_world = |d: &mut Deriver<'_>| {
        let total = w.total(d.exprs);
        let reach = d.to_world(level, &total, &name);
        let axis = d.column(level, 2, &name);
        vector::cross(d.exprs, &axis, &reach)
    };
    let in_world_by_shares = |d: &mut Deriver<'_>| {
        let reach = w.in_world(d, level);
        let axis = d.column(level, 2, &name);
        vector::cross(d.exprs, &axis, &reach)
    };
    let Some(part) = w.part.filter(|_| w.is_only_part()) else {
        return d.cheapest(&[&in_group, &in_world, &in_world_by_shares]).unwrap_or([Term::ZERO; 3]);
    };
    let scaled_after = |d: &mut Deriver<'_>| {
        let v = across(d, &part.vector);
        let direction = d.to_world(level, &v, &name);
        vector::scale(d.exprs, &part.factor, &direction)
    };
    let scaled_in_world = |d: &mut Deriver<'_>| {
        let reach = part.direction(d);
        let axis = d.column(level, 2, &name);
        let direction = vector::cross(d.exprs, &axis, &reach);
        vector::scale(d.exprs, &part.factor, &direction)
    };
    let ways = d.cheapest(&[&in_group, &in_world, &in_world_by_shares, &scaled_after, &scaled_in_world]);
    ways.unwrap_or([Term::ZERO; 3])
}

fn join(linear: &V3<Term>, angular: &V3<Term>) -> Column {
    let [a, b, c] = *linear;
    let [x, y, z] = *angular;
    [a, b, c, x, y, z]
}

/// From rates of the rows to rates of what the caller commands.
fn commanded(exprs: &mut Exprs, rows: &[Column], couple: &[Vec<i64>]) -> Vec<Column> {
    (0..rows.len())
        .map(|j| {
            let mut sum = [Term::ZERO; 6];
            for (row, coefficients) in rows.iter().zip(couple) {
                let coefficient = coefficients.get(j).copied().unwrap_or(0);
                if coefficient == 0 {
                    continue;
                }
                let factor = exprs.constant(crate::algebra::ring::Poly::integer(coefficient));
                for (total, term) in sum.iter_mut().zip(row) {
                    let share = exprs.mul(factor, *term);
                    *total = exprs.add(*total, share);
                }
            }
            sum
        })
        .collect()
}

/// The outputs of a Jacobian, column by column: `j11`, `j21`, ….
pub fn outputs(columns: &[Column]) -> Vec<(String, Term)> {
    let entry = |(j, column): (usize, &Column)| {
        column
            .iter()
            .enumerate()
            .map(move |(i, term)| (format!("j{}{}", i + 1, j + 1), *term))
            .collect::<Vec<_>>()
    };
    columns.iter().enumerate().flat_map(entry).collect()
}

/// The outputs of a pose and a Jacobian.
pub fn pose_outputs(tip: &pose::TermPose, columns: &[Column]) -> Vec<(String, Term)> {
    tip.outputs("").into_iter().chain(outputs(columns)).collect()
}
