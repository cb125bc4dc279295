//! Seed 001: the anthropomorphic arm with a y-z-y wrist.

use kin_gen::back::mathml;
use kin_runtime::prelude::*;
use robots::Anthropomorphic;

use super::parts::{
    Mistake, joint_cells, mistakes, named, overlaid, share, side_by_side, solution_table, solutions,
};
use super::sample::{Sample, TRIALS};
use crate::exact::{decimal, zyx};
use crate::formulas;
use crate::html::{Page, Table, number, rough};
use crate::model::{Frame, Model, ModelError};
use crate::picture::{Look, Picture};
use crate::section::Section;
use crate::view::View;

/// The report's chain with its lengths: d1 = 0, as its inverse assumes.
fn with_lengths(d3: &str, d4: &str) -> Result<Model, ModelError> {
    let d4 = if d4 == "0" { String::new() } else { format!("Ty({d4})") };
    Model::of(&format!(
        "struct Printed(chain, m, rad); let d2 = 1; let d3 = {d3}; let d5 = 1;
         Rz(q) Rx(q) Ty(d2) Rx(q) Ty(d3) Ry(q) {d4} Rz(q) Ty(d5) Ry(q);"
    ))
}

/// The wrist centre with d4 = 0, for the sum of squares.
const WRIST: &str = "struct Wrist(chain, m, rad); let d1 = 1; let d2 = 3; let d3 = 1;
    Rz(q) Tz(d1) Rx(q) Ty(d2) Rx(q) Ty(d3);";

/// Writes the page.
///
/// # Errors
/// If the arm's own chain were refused.
pub fn page() -> Result<Page, ModelError> {
    let model = Model::of(Anthropomorphic::TABLE)?;
    let mut page = Page::new(
        "Anthropomorphic arm with a y-z-y wrist",
        "A report whose inverse kinematics “did not work”: its figure 3 shows the arm beside the point (4, 0, 0). Why it did \
         not, sign by sign, and the point reached, in eight ways.",
    );
    arm(&mut page, &model);
    formulas::derivation(&mut page, &model);
    figures(&mut page, &model);
    replay(&mut page)?;
    workspace(&mut page, &model);
    wrong(&mut page, &model)?;
    Ok(page)
}

fn arm(page: &mut Page, model: &Model) {
    page.section("arm", "The arm");
    page.part("As printed");
    page.text("The chain of elementary transforms; the report prints no lengths.");
    let factors = [
        ("R_z", "theta1"),
        ("T_z", "d1"),
        ("R_x", "theta2"),
        ("T_y", "d2"),
        ("R_x", "theta3"),
        ("T_y", "d3"),
        ("R_y", "theta4"),
        ("T_y", "d4"),
        ("R_z", "theta5"),
        ("T_y", "d5"),
        ("R_y", "theta6"),
    ];
    let factor = |(f, x): (&str, &str)| format!("{}<mo>(</mo>{}<mo>)</mo>", mathml::name(f), mathml::name(x));
    let product: String = factors.into_iter().map(factor).collect();
    page.formula("", &mathml::block(&format!("{}{}{product}", mathml::name("P_end"), mathml::operator("="))));
    page.part("As it must be");
    page.text(
        "The chain is right as it stands. With these lengths the arm reaches the point (4, 0, 0) of the report’s figure 3; the \
         replay below uses d<sub>2</sub> = d<sub>3</sub> + d<sub>4</sub> = d<sub>5</sub> = 1 and d<sub>1</sub> = 0, as the \
         report’s inverse assumes.",
    );
    page.code(Anthropomorphic::TABLE);
    let zero = model.body(&[0.0; 6]);
    page.figure(
        "figure-arm",
        &[(
            Picture::new(View::FRONT, model.reach(), "m")
                .arm(&zero, Look::Solid)
                .named(&zero)
                .frames(&zero)
                .draw(380.0, "The anthropomorphic arm at zero"),
            "All joints zero, from the front; x red, y green, z blue.".to_owned(),
        )],
        "The arm with the frame after each joint.",
    );
}

/// What the report's figure 2 shows is not printed: these were drawn once.
const RANDOM: [f64; 6] = [0.7, 0.5, -1.1, 0.4, 0.9, -0.6];

fn figures(page: &mut Page, model: &Model) {
    page.section("figures", "The report’s figures, redrawn");
    let plain = |q: &[f64; 6], view, name: &str| {
        let body = model.body(q);
        Picture::new(view, model.reach(), "m").arm(&body, Look::Solid).named(&body).draw(340.0, name)
    };
    let view = View::from(25.0, 20.0);
    page.figure(
        "figure-zero-random",
        &[
            (plain(&[0.0; 6], view, "Figure 1: zero angles"), named("θ", &[0.0; 6])),
            (plain(&RANDOM, view, "Figure 2: random angles"), named("θ", &RANDOM)),
        ],
        "Figure 1, zero angles, and figure 2, random angles.",
    );
    page.part("Figure 3: the point (4, 0, 0), reached");
    let zero = decimal("0");
    let frame = zyx([decimal("4"), zero, zero], [zero; 3]);
    let all = solutions(&Anthropomorphic, model, &frame);
    page.text(&format!("The tool at (4, 0, 0), upright: {} solutions, true to the last digit.", all.len()));
    page.table(&solution_table::<Anthropomorphic>(&Anthropomorphic, "(4, 0, 0)", &all));
    let configurations: Vec<(Vec<f64>, String)> =
        all.iter().map(|one| (one.q.to_vec(), named("θ", &one.q))).collect();
    let view = View::from(-62.0, 24.0);
    let target = [4.0, 0.0, 0.0];
    let drawings =
        side_by_side(model, "m", view, 240.0, &configurations, target, "A solution for the point (4, 0, 0)");
    page.figure("figure-three", &drawings, "All solutions side by side, the target ringed.");
    let over: Vec<Vec<f64>> = configurations.iter().map(|(q, _)| q.clone()).collect();
    page.figure(
        "figure-overlaid",
        &[(
            overlaid(model, "m", view, &over, target).draw(440.0, "The solutions over one another"),
            String::new(),
        )],
        "The same over one another.",
    );
}

/// Which of the four mistakes are put right.
#[derive(Clone, Copy)]
struct Fixes {
    wrist: bool,
    theta1: bool,
    theta4: bool,
    length: bool,
}

const PRINTED: Fixes = Fixes { wrist: false, theta1: false, theta4: false, length: false };

/// The report's inverse, line by line; nothing if it asks for the root of a negative number.
fn printed_inverse(pose: &Frame<f64>, [d2, d3, d4, d5]: [f64; 4], fixes: Fixes) -> Option<[f64; 6]> {
    let y = pose.axis(1);
    let along = if fixes.wrist { -d5 } else { d5 };
    let [px, py, pz]: [f64; 3] = std::array::from_fn(|i| pose.origin[i] + along * y[i]);
    let d3 = if fixes.length { d3 + d4 } else { d3 };
    let theta1 = if fixes.theta1 { (-px).atan2(py) } else { py.atan2(px) };
    let c3 = (px * px + py * py + pz * pz - d2 * d2 - d3 * d3) / (2.0 * d2 * d3);
    if c3.abs() > 1.0 {
        return None;
    }
    let s3 = (1.0 - c3 * c3).sqrt();
    let theta3 = s3.atan2(c3);
    let (r, whole) = (px.hypot(py), d2 * d2 + d3 * d3 + 2.0 * d2 * d3 * c3);
    let c2 = ((d2 + d3 * c3) * r + d3 * s3 * pz) / whole;
    let s2 = (pz * (d2 + d3 * c3) - d3 * s3 * r) / whole;
    let theta2 = s2.atan2(c2);
    // ³R₆ = ⁰R₃ᵀ R with ⁰R₃ = Rz(θ₁) Rx(θ₂ + θ₃).
    let ((s1, c1), (s, c)) = (theta1.sin_cos(), (theta2 + theta3).sin_cos());
    let third = [[c1, -s1 * c, s1 * s], [s1, c1 * c, -c1 * s], [0.0, s, c]];
    let r = |i: usize, j: usize| (0..3).map(|k| third[k][i] * pose.rotation[k][j]).sum::<f64>();
    let theta4 = if fixes.theta4 { r(2, 1).atan2(-r(0, 1)) } else { r(2, 1).atan2(r(0, 1)) };
    let theta5 = r(1, 0).hypot(r(1, 2)).atan2(r(1, 1));
    Some([theta1, theta2, theta3, theta4, theta5, r(1, 2).atan2(r(1, 0))])
}

/// How many of the poses of random configurations the printed inverse gives back, and how many it calls unreachable.
fn reproduced(model: &Model, lengths: [f64; 4], fixes: Fixes) -> (usize, usize) {
    let mut sample = Sample(1);
    let (mut right, mut unreachable) = (0, 0);
    for _ in 0..TRIALS {
        let pose = model.body(&sample.angles::<6>()).tip;
        match printed_inverse(&pose, lengths, fixes) {
            Some(q) => {
                let back = model.body(&q).tip;
                let off = (0..3).flat_map(|i| {
                    let turned = (0..3).map(move |j| back.rotation[i][j] - pose.rotation[i][j]);
                    turned.chain([back.origin[i] - pose.origin[i]])
                });
                right += usize::from(off.fold(0.0f64, |worst, x| worst.max(x.abs())) < 1e-6);
            }
            None => unreachable += 1,
        }
    }
    (right, unreachable)
}

/// The rows of the replay: what is put right.
const REPLAY: [(&str, &str, Fixes); 7] = [
    ("as printed", "printed", PRINTED),
    ("wrist by T<sub>y</sub>(−d<sub>5</sub>)", "Ty", Fixes { wrist: true, ..PRINTED }),
    ("θ<sub>1</sub> = Atan2(−P<sub>x</sub>, P<sub>y</sub>)", "theta1", Fixes { theta1: true, ..PRINTED }),
    ("θ<sub>4</sub> = Atan2(R<sub>32</sub>, −R<sub>12</sub>)", "theta4", Fixes { theta4: true, ..PRINTED }),
    ("wrist and θ<sub>1</sub>", "Ty theta1", Fixes { wrist: true, theta1: true, ..PRINTED }),
    (
        "wrist, θ<sub>1</sub> and θ<sub>4</sub>",
        "Ty theta1 theta4",
        Fixes { wrist: true, theta1: true, theta4: true, length: false },
    ),
    (
        "these and d<sub>3</sub> + d<sub>4</sub>",
        "all",
        Fixes { wrist: true, theta1: true, theta4: true, length: true },
    ),
];

fn replay(page: &mut Page) -> Result<(), ModelError> {
    page.section("replay", "The printed inverse, replayed");
    page.text(
        "The report’s formulas were carried out on the poses of 200 random configurations, with d<sub>4</sub> = 0 and with \
         d<sub>4</sub> = 0.4, and what they give was put back into forward kinematics. Three signs and one length must be put \
         right, and each alone changes nothing.",
    );
    let mut table = Table::new(&[
        "put right",
        "reproduced, d<sub>4</sub> = 0",
        "called unreachable",
        "reproduced, d<sub>4</sub> = 0.4",
        "called unreachable",
    ]);
    let models = [
        (with_lengths("1", "0")?, [1.0, 1.0, 0.0, 1.0]),
        (with_lengths("0.6", "0.4")?, [1.0, 0.6, 0.4, 1.0]),
    ];
    for (words, key, fixes) in REPLAY {
        let mut cells = vec![words.to_owned()];
        for (model, lengths) in &models {
            let (right, unreachable) = reproduced(model, *lengths, fixes);
            cells.push(share(right, TRIALS));
            cells.push(unreachable.to_string());
        }
        table.row(&format!("replay {key}"), cells);
    }
    page.table(&table);
    Ok(())
}

fn workspace(page: &mut Page, model: &Model) {
    page.section("workspace", "Workspace");
    let ways = |rho: f64, z: f64| {
        // Any orientation that is not singular for the wrist will do; the tool stands 1 m along its own y.
        let rotation = EulerZyx { z: 0.3, y: 0.4, x: 0.5 }.to_rotation();
        let tool = rotation * nalgebra::Vector3::new(0.0, 1.0, 0.0);
        let shift = nalgebra::Translation3::new(rho + tool.x, tool.y, z + tool.z);
        let solved = Anthropomorphic.ik(&nalgebra::IsometryMatrix3::from_parts(shift, rotation));
        let postures: std::collections::BTreeSet<String> =
            solved.iter().map(|s| s.branch.arm().to_string()).collect();
        postures.len()
    };
    let section = Section::of(model, "m", &ways);
    page.figure(
        "figure-workspace",
        &[(section.draw(360.0, "Cross-section of the workspace of the wrist centre"), String::new())],
        "Where the wrist centre can be, cut through axis 1: between the circle of the stretched and the circle of the folded \
         arm, d<sub>2</sub> being longer than d<sub>3</sub> + d<sub>4</sub>. On axis 1 joint 1 is free.",
    );
}

fn wrong(page: &mut Page, model: &Model) -> Result<(), ModelError> {
    let fused = &model.textbook.fused;
    let centre = fused.wrist_centre.clone().unwrap_or_default();
    let cells: Vec<Vec<String>> = centre.iter().map(|p| vec![mathml::poly(&fused.ring, p)]).collect();
    let unit = with_lengths("1", "0")?;
    let (printed, unreachable) = reproduced(&unit, [1.0, 1.0, 0.0, 1.0], PRINTED);
    let alone = |fixes| share(reproduced(&unit, [1.0, 1.0, 0.0, 1.0], fixes).0, TRIALS);
    let split = with_lengths("0.6", "0.4")?;
    let lost = Fixes { length: false, wrist: true, theta1: true, theta4: true };
    let all = vec![
        Mistake {
            key: "wrist position",
            place: "position of the wrist",
            printed: "(c<sub>1</sub>k, s<sub>1</sub>k, …), k = d<sub>2</sub>c<sub>2</sub> + d<sub>3</sub>c<sub>23</sub>".to_owned(),
            truth: mathml::inline(&mathml::matrix(&cells)),
            consequence: "at zero the arm lies along y, not x".to_owned(),
        },
        Mistake {
            key: "Ty",
            place: "P<sub>w</sub> = P<sub>desired</sub> T<sub>y</sub>(d<sub>5</sub>)",
            printed: "T<sub>y</sub>(+d<sub>5</sub>)".to_owned(),
            truth: "T<sub>y</sub>(−d<sub>5</sub>): from the tool back to the wrist".to_owned(),
            consequence: format!(
                "as printed {} poses, {unreachable} called unreachable; put right alone {}",
                share(printed, TRIALS),
                alone(Fixes { wrist: true, ..PRINTED })
            ),
        },
        Mistake {
            key: "theta1",
            place: "θ<sub>1</sub>",
            printed: "Atan2(P<sub>y</sub>, P<sub>x</sub>)".to_owned(),
            truth: "Atan2(−P<sub>x</sub>, P<sub>y</sub>)".to_owned(),
            consequence: format!("put right alone {}", alone(Fixes { theta1: true, ..PRINTED })),
        },
        Mistake {
            key: "theta4",
            place: "θ<sub>4</sub>",
            printed: "Atan2(R<sub>32</sub>, R<sub>12</sub>)".to_owned(),
            truth: "Atan2(R<sub>32</sub>, −R<sub>12</sub>)".to_owned(),
            consequence: format!("put right alone {}", alone(Fixes { theta4: true, ..PRINTED })),
        },
        Mistake {
            key: "length",
            place: "k",
            printed: "d<sub>3</sub>".to_owned(),
            truth: "d<sub>3</sub> + d<sub>4</sub>".to_owned(),
            consequence: format!(
                "with the three signs right and d<sub>4</sub> = 0.4: {}; with the length as well {}",
                share(reproduced(&split, [1.0, 0.6, 0.4, 1.0], lost).0, TRIALS),
                share(reproduced(&split, [1.0, 0.6, 0.4, 1.0], Fixes { length: true, ..lost }).0, TRIALS)
            ),
        },
        squares()?,
        line(),
        Mistake {
            key: "one of eight",
            place: "s<sub>3</sub> “with positive sign just because”",
            printed: "one solution".to_owned(),
            truth: "eight".to_owned(),
            consequence: format!("{} of 200 random poses have all eight branches solved", eight()),
        },
    ];
    mistakes(
        page,
        "The printed <sup>3</sup>R<sub>6</sub> is right: the algebra gives the same nine polynomials.",
        all,
    );
    Ok(())
}

/// How many random poses have eight solutions.
fn eight() -> usize {
    let mut sample = Sample(8);
    (0..TRIALS)
        .filter(|_| Anthropomorphic.ik(&Anthropomorphic.fk(&Joints::from(sample.angles::<6>()))).len() == 8)
        .count()
}

/// The sum of squares of the wrist's coordinates, by the algebra.
fn squares() -> Result<Mistake, ModelError> {
    let wrist = Model::of(WRIST)?;
    let own = &wrist.textbook.own;
    let (mut sum, ring) = (Default::default(), &own.ring);
    for p in &own.tip.position {
        sum = ring.add(&sum, &ring.mul(p, p));
    }
    let mut sample = Sample(2);
    let mut worst = 0.0f64;
    for _ in 0..TRIALS {
        let [_, q2, q3] = sample.angles::<3>();
        worst = worst.max(2.0 * (q3.sin() - (q2 + q3).sin()).abs());
    }
    Ok(Mistake {
        key: "squares",
        place: "P<sub>x</sub>² + P<sub>y</sub>² + P<sub>z</sub>²",
        printed: "… + 2d<sub>1</sub>d<sub>3</sub>s<sub>3</sub>".to_owned(),
        truth: format!(
            "2d<sub>1</sub>d<sub>3</sub>s<sub>23</sub>: {}",
            mathml::inline(&mathml::poly(ring, &sum))
        ),
        consequence: format!(
            "off by up to {} d<sub>1</sub>d<sub>3</sub>; the report then sets d<sub>1</sub> = 0, which it need not",
            rough(worst)
        ),
    })
}

fn line() -> Mistake {
    let (c3, d2, d3) = (0.5, 1.0, 0.6);
    let mut cells = joint_cells(&[d2 - d3 * c3, d2 + d3 * c3], 2);
    let truth = cells.pop().unwrap_or_default();
    Mistake {
        key: "line",
        place: "substitution of s<sub>2</sub>, denominator",
        printed: "d<sub>2</sub> − d<sub>3</sub>c<sub>3</sub>".to_owned(),
        truth: "d<sub>2</sub> + d<sub>3</sub>c<sub>3</sub>".to_owned(),
        consequence: format!(
            "{} for {} at c<sub>3</sub> = {}, d<sub>3</sub> = {}; the next line is right again",
            cells.pop().unwrap_or_default(),
            truth,
            number(c3, 1),
            number(d3, 1)
        ),
    }
}
