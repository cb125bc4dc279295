//! What several pages show alike: solutions with their true values, mistakes with what follows from them.

use std::collections::BTreeSet;

use kin_gen::number::Real;
use kin_runtime::prelude::*;
use kin_runtime::{JointSet, dexterity};
use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};

use crate::exact::{self, Goal, refined};
use crate::html::{Page, Table, digits, number, rough};
use crate::model::{Frame, Model};
use crate::picture::{Look, Picture, Window};
use crate::svg::Svg;
use crate::view::View;

/// One mistake of a report.
pub(super) struct Mistake {
    /// Its name to programs that read the page.
    pub(super) key: &'static str,
    /// Where it stands.
    pub(super) place: &'static str,
    /// What is printed.
    pub(super) printed: String,
    /// What is true.
    pub(super) truth: String,
    /// What follows, measured when the page was made.
    pub(super) consequence: String,
}

/// The section of mistakes.
pub(super) fn mistakes(page: &mut Page, lead: &str, all: Vec<Mistake>) {
    page.section("mistakes", "Mistakes, and what follows from them");
    page.text(lead);
    let mut table = Table::new(&["where", "printed", "true", "measured"]).stacked();
    for m in all {
        table.row(&format!("mistake {}", m.key), vec![m.place.to_owned(), m.printed, m.truth, m.consequence]);
    }
    page.table(&table);
}

/// The nearest double, what is nothing but round-off of 256 bits being nothing.
pub(super) fn double(value: Real) -> f64 {
    if value.abs().to_f64() < 1e-60 { 0.0 } else { value.to_f64() }
}

/// A frame as the solver takes it.
pub(super) fn pose_of(frame: &Frame<Real>) -> Pose<f64> {
    let r = frame.rotation.map(|row| row.map(double));
    let [x, y, z] = frame.origin.map(double);
    let rotation = Matrix3::from_fn(|i, j| r[i][j]);
    IsometryMatrix3::from_parts(Translation3::new(x, y, z), Rotation3::from_matrix_unchecked(rotation))
}

/// An angle brought into (-π, π].
pub(super) fn wrapped(angle: f64) -> f64 {
    let turns = (angle / std::f64::consts::TAU).round();
    let rest = angle - turns * std::f64::consts::TAU;
    if rest <= -std::f64::consts::PI { rest + std::f64::consts::TAU } else { rest }
}

/// A solution of the solver and its true joint values.
pub(super) struct True {
    /// As the solver gave it.
    pub(super) solution: Solution<f64, 6, Posture>,
    /// The doubles nearest to the true values.
    pub(super) q: [f64; 6],
    /// The largest difference between the two.
    pub(super) off: f64,
    /// The families it belongs to, in words.
    pub(super) families: Vec<String>,
    /// The joints that these move.
    pub(super) moving: JointSet,
}

/// The solutions of a pose, each refined to its true values.
pub(super) fn solutions<A>(arm: &A, model: &Model, frame: &Frame<Real>) -> Vec<True>
where
    A: InverseKinematics<6, Branch = Posture>,
{
    let found = arm.ik(&pose_of(frame));
    let one = |solution: &Solution<f64, 6, Posture>| {
        let families: Vec<_> = solution.families().collect();
        let held: Vec<usize> = families.iter().map(|f| f.free()).collect();
        let moving = families.iter().flat_map(|f| f.moving().iter()).fold(JointSet::EMPTY, JointSet::with);
        let q: Vec<f64> = solution.q.iter().copied().collect();
        let exact = refined(model, Goal::Pose(frame), &q, &held)?;
        let q: [f64; 6] = std::array::from_fn(|i| wrapped(double(exact[i])));
        let off = q.iter().zip(&solution.q).map(|(a, b)| wrapped(a - b).abs()).fold(0.0, f64::max);
        let families = families.iter().map(ToString::to_string).collect();
        Some(True { solution: *solution, q, off, families, moving })
    };
    found.iter().filter_map(one).collect()
}

/// Joint values as cells.
pub(super) fn joint_cells(q: &[f64], decimals: usize) -> Vec<String> {
    q.iter().map(|x| number(*x, decimals)).collect()
}

/// In how many postures of the arm the wrist centre can be at a distance from axis 1 and a height; the tool stands `tool`
/// before the wrist centre, in its own frame.
pub(super) fn postures<A>(arm: &A, tool: [f64; 3], rho: f64, z: f64) -> usize
where
    A: InverseKinematics<6, Branch = Posture>,
{
    // Any orientation that is not singular for the wrist will do.
    let rotation = EulerZyx { z: 0.3, y: 0.4, x: 0.5 }.to_rotation();
    let tool = rotation * Vector3::from(tool);
    let shift = Translation3::new(rho + tool.x, tool.y, z + tool.z);
    let solved = arm.ik(&IsometryMatrix3::from_parts(shift, rotation));
    let postures: BTreeSet<String> = solved.iter().map(|s| s.branch.arm().to_string()).collect();
    postures.len()
}

/// The table of a pose's solutions, isolated ones and families.
pub(super) fn solution_table<A>(arm: &A, key: &str, all: &[True]) -> Table
where
    A: InverseKinematics<6, Branch = Posture>,
{
    let mut table = Table::new(&[
        "branch",
        "θ<sub>1</sub>",
        "θ<sub>2</sub>",
        "θ<sub>3</sub>",
        "θ<sub>4</sub>",
        "θ<sub>5</sub>",
        "θ<sub>6</sub>",
        "what it is",
        "σ<sub>min</sub>",
        "off in doubles",
    ])
    .dense();
    for one in all {
        let kind = if one.families.is_empty() { "isolated" } else { "family" };
        let mut cells = vec![one.solution.branch.to_string()];
        cells.extend(joint_cells(&one.q, 13));
        cells.push(match one.families.as_slice() {
            [] => "isolated".to_owned(),
            words => words.join("; ").replace("theta", "θ").replace('-', "−"),
        });
        cells.push(rough(dexterity(arm, &Joints::from(one.q)).margin));
        cells.push(rough(one.off));
        table.row(&format!("{kind} {key}"), cells);
    }
    table
}

/// Pictures of configurations side by side, all with one scale.
pub(super) fn side_by_side(
    model: &Model,
    unit: &'static str,
    view: View,
    width: f64,
    all: &[(Vec<f64>, String)],
    target: [f64; 3],
    name: &str,
) -> Vec<(Svg, String)> {
    let pictures: Vec<Picture> = all
        .iter()
        .map(|(q, _)| {
            Picture::new(view, model.reach(), unit).arm(&model.body(q.as_slice()), Look::Solid).target(target)
        })
        .collect();
    let window = pictures.iter().map(Picture::window).reduce(Window::with);
    let Some(window) = window else { return Vec::new() };
    let draw = |(picture, (_, words)): (&Picture, &(Vec<f64>, String))| {
        (picture.draw_in(window, width, name), words.clone())
    };
    pictures.iter().zip(all).map(draw).collect()
}

/// All configurations over one another, the first in full colour.
pub(super) fn overlaid(
    model: &Model,
    unit: &'static str,
    view: View,
    all: &[Vec<f64>],
    target: [f64; 3],
) -> Picture {
    let mut picture = Picture::new(view, model.reach(), unit);
    for (index, q) in all.iter().enumerate() {
        let look = if index == 0 { Look::Solid } else { Look::Ghost };
        picture = picture.arm(&model.body(q.as_slice()), look);
    }
    picture.target(target)
}

/// A pose's position and angles in words: (−69, 0, 112).
pub(super) fn listed(values: &[&str]) -> String {
    format!("({})", values.join(", ").replace('-', "−"))
}

/// A true number with that many decimals.
pub(super) fn exactly(value: Real, decimals: usize) -> String {
    digits(&exact::decimals(value, decimals))
}

/// `0 of 200`, in the colour of what it says.
pub(super) fn share(count: usize, of: usize) -> String {
    let class = if count == of { "good" } else { "bad" };
    format!("<span class=\"{class}\">{count} of {of}</span>")
}

/// Joint values in words: θ = (0.0000, 1.5708, …).
pub(super) fn named(letter: &str, q: &[f64]) -> String {
    // Rounded first, so that nothing is written as a negative zero.
    let values = q.iter().map(|x| format!("{:.4}", (x * 1e4).round() / 1e4 + 0.0).replace('-', "−"));
    format!("{letter} = ({})", values.collect::<Vec<_>>().join(", "))
}
