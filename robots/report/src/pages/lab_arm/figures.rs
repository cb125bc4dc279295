//! Figure 4.1: the four geometric configurations, with the angles that the report names.

use std::f64::consts::PI;

use kin_runtime::prelude::*;
use nalgebra::{IsometryMatrix3, Translation3, Vector3};
use robots::LabArm;

use super::super::parts::wrapped;
use crate::html::{Page, Table, number};
use crate::model::Model;
use crate::picture::{Look, Picture, Window, arc};
use crate::section::carried_point;
use crate::svg::Svg;
use crate::view::{Point, View, along, dot};

/// One of the four: where the elbow is, and the report's angles.
struct Configuration {
    words: &'static str,
    q: [f64; 6],
    shoulder: Point,
    elbow: Point,
    wrist: Point,
    /// Of d2_5 above the horizontal.
    aux1: f64,
    /// Between a2 and d3_5 in the triangle.
    aux2: f64,
    /// Between a4 and d3_5.
    phi: f64,
}

/// A wrist centre before the arm and above its shoulder, one below it, each with both elbows.
const CENTRES: [([f64; 2], [&str; 2]); 2] = [
    ([105.0, 190.0], ["target high, elbow up", "target high, elbow down"]),
    ([120.0, 20.0], ["target low, elbow up", "target low, elbow down"]),
];

fn configurations(model: &Model) -> Vec<Configuration> {
    let mut all = Vec::new();
    for ([x, z], words) in CENTRES {
        let rotation = EulerZyx { z: 0.0, y: 2.2, x: 0.0 }.to_rotation();
        let tool = rotation * Vector3::new(0.0, 0.0, 29.0);
        let pose = IsometryMatrix3::from_parts(Translation3::new(x + tool.x, tool.y, z + tool.z), rotation);
        let solved = LabArm.ik(&pose);
        for (elbow, words) in [Elbow::Up, Elbow::Down].into_iter().zip(words) {
            let mut found = solved.iter().filter(|s| s.branch.elbow == elbow && s.q[0].abs() < 1e-9);
            // The wrist that turns joint 4 less.
            let first = found.next();
            let best = found.fold(first, |best, s| match best {
                Some(b) if s.q[3].abs() >= b.q[3].abs() => Some(b),
                _ => Some(s),
            });
            if let Some(solution) = best {
                all.push(measured(model, words, std::array::from_fn(|i| solution.q[i])));
            }
        }
    }
    all
}

fn measured(model: &Model, words: &'static str, q: [f64; 6]) -> Configuration {
    let body = model.body(&q);
    let (shoulder, elbow, wrist) = (body.joints[1].0, body.joints[2].0, carried_point(&body));
    let between = |a: Point, b: Point| (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).acos();
    let to_wrist = along(wrist, -1.0, shoulder);
    let (back, fore) = (along(shoulder, -1.0, elbow), along(wrist, -1.0, elbow));
    // a4 runs along x of frame 3 from the elbow.
    let a4 = body.frames[2].axis(0);
    Configuration {
        words,
        q,
        shoulder,
        elbow,
        wrist,
        aux1: to_wrist[2].atan2(to_wrist[0]),
        aux2: between(back, fore),
        phi: between(a4, fore),
    }
}

pub(super) fn four_configurations(page: &mut Page, model: &Model) {
    page.section("figure-4-1", "Figure 4.1: the four geometric configurations");
    let all = configurations(model);
    page.text(
        "The report reads θ<sub>A</sub> = π/2 + θ<sub>3</sub> from the triangle of a<sub>2</sub>, d<sub>3_5</sub> and \
         d<sub>2_5</sub>: π − t<sub>aux2</sub> − φ with the elbow on one side, π + t<sub>aux2</sub> − φ with the elbow on the \
         other. Both were tried on each configuration, and the one that fits was measured.",
    );
    let mut table = Table::new(&[
        "configuration",
        "t<sub>aux1</sub>, °",
        "t<sub>aux2</sub>, °",
        "φ, °",
        "θ<sub>A</sub> of the solver, °",
        "the report’s formula",
        "differs by, rad",
    ]);
    for c in &all {
        let theta_a = wrapped(PI / 2.0 + c.q[2]);
        let candidates = [
            ("π − t<sub>aux2</sub> − φ", PI - c.aux2 - c.phi),
            ("π + t<sub>aux2</sub> − φ", PI + c.aux2 - c.phi),
        ];
        let off = |value: f64| wrapped(value - theta_a).abs();
        let [first, second] = candidates;
        let (formula, value) = if off(first.1) <= off(second.1) { first } else { second };
        let degrees = |angle: f64| number(angle.to_degrees(), 3);
        table.row(
            "figure 4.1",
            vec![
                c.words.to_owned(),
                degrees(c.aux1),
                degrees(c.aux2),
                degrees(c.phi),
                degrees(theta_a),
                formula.to_owned(),
                crate::html::rough(off(value)),
            ],
        );
    }
    page.table(&table);
    let pictures: Vec<Picture> = all.iter().map(|c| picture(model, c)).collect();
    let Some(window) = pictures.iter().map(Picture::window).reduce(Window::with) else { return };
    let drawings: Vec<(Svg, String)> = pictures
        .iter()
        .zip(&all)
        .map(|(p, c)| (p.draw_in(window, 240.0, &format!("Figure 4.1: {}", c.words)), c.words.to_owned()))
        .collect();
    page.figure(
        "figure-figure-4-1",
        &drawings,
        "θ<sub>1</sub> = 0, from the side. The triangle has the sides a<sub>2</sub>, d<sub>3_5</sub> and d<sub>2_5</sub>; the \
         dashed arcs are t<sub>aux1</sub> at the shoulder and t<sub>aux2</sub> at the elbow.",
    );
}

fn picture(model: &Model, c: &Configuration) -> Picture {
    let body = model.body(&c.q);
    let (right, up) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let middle = |a: Point, b: Point| along(along([0.0; 3], 0.5, a), 0.5, b);
    let radius = 38.0;
    let horizontal = vec![c.shoulder, along(c.shoulder, 60.0, right)];
    let direction = |a: Point, b: Point| (b[2] - a[2]).atan2(b[0] - a[0]);
    let (back, fore) = (direction(c.elbow, c.shoulder), direction(c.elbow, c.wrist));
    let inner = back + wrapped(fore - back);
    Picture::new(View::SIDE, model.reach(), "mm")
        .arm(&body, Look::Ghost)
        .path(horizontal, "guide")
        .path(vec![c.shoulder, c.elbow, c.wrist, c.shoulder], "figure")
        .path(arc(c.shoulder, radius, right, up, 0.0, c.aux1), "guide")
        .path(arc(c.elbow, 26.0, right, up, back, inner), "guide")
        .note(middle(c.shoulder, c.elbow), "a₂")
        .note(middle(c.elbow, c.wrist), "d₃₋₅")
        .note(middle(c.shoulder, c.wrist), "d₂₋₅")
        .target(c.wrist)
}
