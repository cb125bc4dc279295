//! Seed 001: the anthropomorphic arm with a y-z-y wrist.

mod mistakes;
mod replay;

use kin_gen::back::mathml;
use kin_runtime::prelude::*;
use robots::Anthropomorphic;

use super::parts::{named, overlaid, postures, side_by_side, solution_table, solutions};
use crate::exact::{decimal, zyx};
use crate::formulas;
use crate::html::Page;
use crate::model::{Model, ModelError};
use crate::picture::{Look, Picture};
use crate::section::Section;
use crate::view::View;

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
    replay::section(&mut page)?;
    workspace(&mut page, &model);
    mistakes::section(&mut page, &model)?;
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

fn workspace(page: &mut Page, model: &Model) {
    page.section("workspace", "Workspace");
    // The tool stands 1 m along its own y.
    let ways = |rho: f64, z: f64| postures(&Anthropomorphic, [0.0, 1.0, 0.0], rho, z);
    let section = Section::of(model, "m", &ways);
    page.figure(
        "figure-workspace",
        &[(section.draw(360.0, "Cross-section of the workspace of the wrist centre"), String::new())],
        "Where the wrist centre can be, cut through axis 1: between the circle of the stretched and the circle of the folded \
         arm, d<sub>2</sub> being longer than d<sub>3</sub> + d<sub>4</sub>. On axis 1 joint 1 is free.",
    );
}
