//! Seed 000: the six-axis arm of the 2019 lab report from Lisbon.

mod examples;
mod figures;
mod mistakes;

use kin_runtime::prelude::*;
use robots::LabArm;

use super::parts::postures;
use crate::formulas;
use crate::html::{Page, Table};
use crate::model::{Model, ModelError};
use crate::picture::{Look, Picture};
use crate::section::Section;
use crate::view::View;

/// Writes the page.
///
/// # Errors
/// If the arm's own table were refused.
pub fn page() -> Result<Page, ModelError> {
    let model = Model::of(LabArm::TABLE)?;
    let mut page = Page::new(
        "Six-axis lab arm: direct and inverse kinematics",
        "M. Madeira and M. T. Parreira, first laboratory assignment, Instituto Superior Técnico, Lisbon, March 2019. \
         Its table, its derivation, each of its numeric examples, its figures, and its mistakes, recomputed.",
    );
    arm(&mut page, &model);
    formulas::derivation(&mut page, &model);
    examples::section(&mut page, &model);
    figures::four_configurations(&mut page, &model);
    workspace(&mut page, &model);
    mistakes::section(&mut page, &model);
    Ok(page)
}

fn arm(page: &mut Page, model: &Model) {
    page.section("arm", "The arm");
    page.part("As printed: Table 3.1");
    page.text(
        "Modified Denavit-Hartenberg parameters (Craig); the rows 2 and 5 that stand twice are its auxiliary frames 2′ and \
         5′, which turn with no joint. d<sub>1</sub> = 47, a<sub>1</sub> = 30, d<sub>2</sub> = 45, a<sub>2</sub> = 120, \
         a<sub>4</sub> = 20, d<sub>5</sub> = 130, d<sub>6</sub> = 29 mm.",
    );
    let mut table =
        Table::new(&["frame", "α<sub>i−1</sub>", "a<sub>i−1</sub>", "d<sub>i</sub>", "θ<sub>i</sub>"]);
    for row in [
        ["1", "0", "0", "d<sub>1</sub>", "θ<sub>1</sub>"],
        ["2′", "0", "−a<sub>1</sub>", "d<sub>2</sub>", "0"],
        ["2", "π/2", "0", "0", "θ<sub>2</sub>"],
        ["3", "0", "a<sub>2</sub>", "0", "π/2 + θ<sub>3</sub>"],
        ["4", "−π/2", "a<sub>4</sub>", "0", "θ<sub>4</sub>"],
        ["5′", "0", "0", "d<sub>5</sub>", "0"],
        ["5", "π/2", "0", "0", "θ<sub>5</sub>"],
        ["6", "−π/2", "0", "d<sub>6</sub>", "θ<sub>6</sub>"],
    ] {
        table.row("", row.map(str::to_owned).to_vec());
    }
    page.table(&table);
    page.part("As it must be");
    page.text(
        "The table is right as it stands. This is the declaration that the page was made from, with the report’s own \
         pose of section 6.1 as a check that the compiler makes; the limits of J1 are illustrative.",
    );
    page.code(LabArm::TABLE);
    let q = [0.35, 1.1, -0.5, 0.6, -0.7, 0.3];
    let body = model.body(&q);
    let zero = model.body(&[0.0; 6]);
    let reach = model.reach();
    let picture = |body, view| Picture::new(view, reach, "mm").arm(body, Look::Solid).named(body);
    page.figure(
        "figure-arm",
        &[
            (
                picture(&zero, View::SIDE).frames(&zero).draw(330.0, "The lab arm at zero, from the side"),
                "All joints zero, from the side, with the frame of each joint: x red, y green, z blue."
                    .to_owned(),
            ),
            (
                picture(&body, View::from(-55.0, 22.0)).draw(330.0, "The lab arm, turned"),
                "θ = (0.35, 1.1, −0.5, 0.6, −0.7, 0.3).".to_owned(),
            ),
        ],
        "The arm, as figure 2.1 of the report assigns its frames.",
    );
}

/// How many ways there are to bring the wrist centre to a distance from axis 1 and a height.
fn ways(rho: f64, z: f64) -> usize {
    postures(&LabArm, [0.0, 0.0, 29.0], rho, z)
}

fn workspace(page: &mut Page, model: &Model) {
    page.section("workspace", "Workspace");
    let section = Section::of(model, "mm", &ways);
    page.figure(
        "figure-workspace",
        &[(section.draw(400.0, "Cross-section of the workspace of the wrist centre"), String::new())],
        "Where the wrist centre can be, cut through axis 1. The curves are where the factors of det J that belong to \
         shoulder and elbow vanish, followed to the last bit and carried into space; which of them are boundaries was decided by counting \
         solutions on both sides. Axis 2 stands 30 mm off axis 1, so that turning joint 1 by half a turn does not give the \
         same region: that is why some points are reached in two ways and some in four.",
    );
}
