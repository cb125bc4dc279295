//! Tasks 1 to 4: inverse kinematics, many positions, the number of solutions along the way, singular poses.

use kin_runtime::prelude::*;
use kin_runtime::{Limits, dexterity};
use nalgebra::{IsometryMatrix3, Translation3};
use robots::ElbowWrist;

use super::super::parts::{
    double, named, overlaid, pose_of, side_by_side, solution_table, solutions, wrapped,
};
use crate::exact::decimal;
use crate::html::{Page, Table, number, rough};
use crate::model::Model;
use crate::picture::{Look, Picture};
use crate::plot::{Plot, Series};
use crate::view::View;

/// Where the tasks begin.
pub(super) const START: [f64; 6] = [0.3, 0.7, -1.2, 0.4, 0.8, 0.2];

/// Where the wrist is stretched half-way: θ5 passes through 0.
const END: [f64; 6] = [0.9, 0.2, -0.5, 0.9, -0.8, -0.4];

/// Poses along the path of task 3, an odd number, so that the middle one is singular.
const POSES: usize = 41;

pub(super) fn tasks(page: &mut Page, model: &Model) {
    page.section("tasks-1-3", "Tasks 1–3: inverse kinematics, many positions, the closest solution");
    first(page, model);
    along(page, model);
    tracked(page, model);
}

fn first(page: &mut Page, model: &Model) {
    page.part("Task 1: all solutions of a pose");
    let q = START.map(|x| decimal(&format!("{x}")));
    let frame = model.body(&q).tip;
    let all = solutions(&ElbowWrist, model, &frame);
    page.text(&format!(
        "The pose of {}: {} solutions, where the printed formulas give none.",
        named("θ", &START),
        all.len()
    ));
    page.table(&solution_table::<ElbowWrist>(&ElbowWrist, "task 1", &all));
    let configurations: Vec<(Vec<f64>, String)> =
        all.iter().map(|one| (one.q.to_vec(), named("θ", &one.q))).collect();
    let (view, target) = (View::from(-10.0, 24.0), frame.origin.map(double));
    let drawings = side_by_side(model, "m", view, 240.0, &configurations, target, "A solution of task 1");
    page.figure("figure-task-1", &drawings, "All eight side by side, the target ringed.");
    let over: Vec<Vec<f64>> = configurations.into_iter().map(|(q, _)| q).collect();
    page.figure(
        "figure-task-1-overlaid",
        &[(
            overlaid(model, "m", view, &over, target).draw(400.0, "The solutions over one another"),
            String::new(),
        )],
        "The same over one another.",
    );
}

/// Limits for the count; the report gives none.
fn limits() -> Limits<6> {
    Limits::new([
        Some((-2.6, 2.6)),
        Some((-0.8, 2.4)),
        Some((-2.5, 2.5)),
        Some((-3.0, 3.0)),
        Some((-2.0, 2.0)),
        None,
    ])
}

/// A straight line outwards, the orientation kept: from inside the void past the outer boundary.
fn line(k: usize, count: usize) -> Pose<f64> {
    let s = k as f64 / (count - 1) as f64;
    let (from, to) = ([0.05, 0.05, 0.35], [1.35, 1.2, 0.9]);
    let [x, y, z] = [0, 1, 2].map(|i| from[i] + s * (to[i] - from[i]));
    let rotation = EulerZyx { z: 0.4, y: 1.1, x: -0.3 }.to_rotation();
    IsometryMatrix3::from_parts(Translation3::new(x, y, z), rotation)
}

fn along(page: &mut Page, model: &Model) {
    page.part("Tasks 2 and 3: many positions, and how many solutions each has");
    let ranges: Vec<String> = (0..6)
        .map(|joint| match limits().range(joint) {
            Some((low, high)) => {
                format!("{:.0}° … {:.0}°", low.to_degrees(), high.to_degrees()).replace('-', "−")
            }
            None => "none".to_owned(),
        })
        .collect();
    page.text(&format!(
        "The tool moves outwards along a straight line with its orientation kept: from inside the void, which the folded arm \
         cannot enter, past the reach of the stretched arm. The report gives no limits; those of the dashed curve are \
         illustrative: {}.",
        ranges.join(", ")
    ));
    let count = 381;
    let distance = |pose: &Pose<f64>| (pose.translation.vector - line(0, count).translation.vector).norm();
    let (mut every, mut kept) = (Vec::new(), Vec::new());
    let mut table =
        Table::new(&["distance, m", "x, m", "y, m", "z, m", "solutions", "within limits", "why fewer"])
            .dense();
    for k in 0..count {
        let pose = line(k, count);
        let found = ElbowWrist.ik(&pose);
        let inside = found.within(&limits());
        every.push((distance(&pose), found.len() as f64));
        kept.push((distance(&pose), inside.len() as f64));
        if k % 38 == 0 {
            let p = pose.translation.vector;
            let reason = found.slots().iter().find_map(|slot| match slot {
                Slot::Empty(reason) => Some(reason.to_string()),
                _ => None,
            });
            let limited = inside.slots().iter().find_map(|slot| match slot {
                Slot::Empty(reason @ Reason::Limit { .. }) => Some(reason.to_string()),
                _ => None,
            });
            let mut cells = vec![number(distance(&pose), 4)];
            cells.extend([p.x, p.y, p.z].map(|x| number(x, 4)));
            cells.extend([found.len().to_string(), inside.len().to_string()]);
            cells.push(reason.or(limited).unwrap_or_default());
            table.row("position", cells);
        }
    }
    let plot = Plot::new("distance along the line, m", "number of solutions")
        .series(Series::new("all", every).stepped())
        .series(Series::new("within the limits", kept).stepped());
    let picture = line_through_space(model, count);
    page.figure(
        "figure-counts",
        &[
            (plot.draw(480.0, 300.0, "clip-counts", "Number of solutions along a line"), String::new()),
            (picture.draw(330.0, "The line through space"), String::new()),
        ],
        "The number of solutions along the line, and the line itself; its end, out of reach, is ringed.",
    );
    page.table(&table);
}

/// The arm on the line, half-way.
fn line_through_space(model: &Model, count: usize) -> Picture {
    let [start, end] = [0, count - 1].map(|k| line(k, count).translation.vector);
    let reached = ElbowWrist.ik(&line(150, count));
    let body = reached.iter().next().map(|s| model.body(s.q.as_slice()));
    let mut picture = Picture::new(View::from(-40.0, 22.0), model.reach(), "m");
    if let Some(body) = &body {
        picture = picture.arm(body, Look::Solid);
    }
    picture
        .path(vec![[start.x, start.y, start.z], [end.x, end.y, end.z]], "figure")
        .target([end.x, end.y, end.z])
}

fn path(k: usize) -> Pose<f64> {
    let s = k as f64 / (POSES - 1) as f64;
    // The middle is exact: θ5 is 0 there, not nearly 0.
    let at = |i: usize| START[i] * (1.0 - s) + END[i] * s;
    ElbowWrist.fk(&Joints::from(std::array::from_fn::<_, 6, _>(at)))
}

fn tracked(page: &mut Page, model: &Model) {
    page.part("Task 3: the solution closest to the current configuration, through a singular pose");
    page.text(
        "A path of 41 poses on which the wrist is stretched half-way: at the 21st pose axes 4 and 6 coincide. One branch, \
         followed by its name, jumps there. The solution closest to the current configuration goes on; where a \
         joint value is not determined it keeps its previous value, as the report asks.",
    );
    let branch = ElbowWrist.ik(&path(0)).nearest(&Joints::from(START)).map(|s| s.branch);
    let steps: Vec<_> = ElbowWrist.track(&Joints::from(START), (0..POSES).map(path)).collect();
    let mut series: Vec<Vec<(f64, f64)>> = vec![Vec::new(); 12];
    let (mut flips, mut largest, mut jump) = (0, 0.0f64, 0.0f64);
    let (mut previous, mut fixed) = (Joints::from(START), Joints::from(START));
    for (k, step) in steps.iter().enumerate() {
        flips += usize::from(!matches!(step, Step::Continuous(_)));
        if let Some(q) = step.q() {
            largest = largest.max((q - previous).amax());
            previous = *q;
        }
        let solved = ElbowWrist.ik(&path(k));
        let named = branch.and_then(|b| solved.solution(b)).map_or(fixed, |s| s.q);
        jump = jump.max((named - fixed).map(|x| wrapped(x).abs()).amax());
        fixed = named;
        for joint in 0..6 {
            series[joint].push((k as f64, previous[joint]));
            series[6 + joint].push((k as f64, fixed[joint]));
        }
    }
    let plot = |offset: usize| {
        (0..6).fold(Plot::new("pose", "joint value, rad"), |plot, joint| {
            plot.series(Series::new(format!("θ{}", joint + 1), series[offset + joint].clone()))
        })
    };
    page.figure(
        "figure-track",
        &[
            (
                plot(0).mark(20.0, "θ5 = 0").draw(
                    480.0,
                    320.0,
                    "clip-track",
                    "Joint values, closest solution",
                ),
                format!(
                    "The closest solution: largest move of a joint in one step {} rad, {flips} flips.",
                    rough(largest)
                ),
            ),
            (
                plot(6).mark(20.0, "θ5 = 0").draw(480.0, 320.0, "clip-branch", "Joint values, one branch"),
                format!("One branch by its name: a joint jumps by {} rad.", rough(jump)),
            ),
        ],
        "Joint values along the path of task 3.",
    );
    singular(page, model);
}

/// What the singular pose in the middle has to offer.
fn singular(page: &mut Page, model: &Model) {
    let middle: [f64; 6] = std::array::from_fn(|i| (START[i] + END[i]) / 2.0);
    let q = middle.map(|x| kin_gen::number::Real::from_f64(x).unwrap_or_default());
    let frame = model.body(&q).tip;
    let all = solutions(&ElbowWrist, model, &frame);
    let families = all.iter().filter(|one| !one.families.is_empty()).count();
    page.text(&format!(
        "The pose in the middle: {} isolated solutions and {families} families, in which only a sum or difference of θ₄ and \
         θ₆ is determined.",
        all.len() - families
    ));
    page.table(&solution_table::<ElbowWrist>(&ElbowWrist, "middle", &all));
    let held = ElbowWrist.ik_near(&pose_of(&frame), &Joints::from(middle));
    if let Ok(held) = held {
        page.text(&format!(
            "Nearest to the previous configuration, free coordinates kept: {}.",
            named("θ", held.q.as_slice())
        ));
    }
}

/// The margin with the wrist centre on axis 1 and neither elbow nor wrist near singular.
pub(super) fn shoulder_margin() -> f64 {
    // l2 c2 + (l3 + l4) c23 = 0 with θ2 = 1: the wrist centre stands on axis 1.
    let theta2 = 1.0f64;
    let theta3 = (-theta2.cos() / 0.8).acos() - theta2;
    dexterity(&ElbowWrist, &Joints::from([0.3, theta2, theta3, 0.4, 0.8, 0.2])).margin
}
