//! Seed 003: the elbow arm with a spherical wrist, tracking and trajectories.

mod check;
mod inverse;
mod motion;
mod replay;

use kin_gen::back::mathml;
use kin_runtime::prelude::*;
use robots::ElbowWrist;

use super::parts::{Mistake, mistakes, postures, share};
use super::sample::TRIALS;
use crate::formulas;
use crate::html::{Page, rough};
use crate::model::{Model, ModelError};
use crate::picture::{Look, Picture};
use crate::section::Section;
use crate::view::View;

/// Writes the page.
///
/// # Errors
/// If the arm's own chain were refused.
pub fn page() -> Result<Page, ModelError> {
    let model = Model::of(ElbowWrist::TABLE)?;
    let mut page = Page::new(
        "Elbow arm with a spherical wrist: tracking and trajectories",
        "E. Mozhegova, “Fundamentals of Robotics: Assignment 2”. Six tasks: inverse kinematics, many positions, the number of \
         solutions along the way, the Jacobian, a synchronised trajectory at 20 Hz, and a check for singularities on it.",
    );
    arm(&mut page, &model)?;
    formulas::derivation(&mut page, &model);
    inverse::tasks(&mut page, &model);
    motion::tasks(&mut page, &model);
    workspace(&mut page, &model);
    replay::section(&mut page, &model);
    wrong(&mut page);
    Ok(page)
}

/// The chain as section 2 prints it: without the turn that section 3.1 has before joint 4.
const SECTION_2: &str =
    "struct Section2(chain, m, deg); let l1 = 0.3; let l2 = 1; let l3 = 0.5; let l4 = 0.3;
    Rz(q) Tz(l1) Rz(90) Rx(90)  Rz(q) Tx(l2)  Rz(q) Tx(l3)
    Rz(q) Tz(l4) Rx(-90) Rz(-180)  Rz(q) Rx(-90)  Rz(q);";

/// A transform as a product of named factors; an argument that is no name is a multiple of π, in quarter turns.
fn chain(from: &str, to: &str, factors: &[(&str, &str)]) -> (String, String) {
    let factor = |(f, x): &(&str, &str)| {
        let argument = match *x {
            "90" => "<mfrac><mi>π</mi><mn>2</mn></mfrac>".to_owned(),
            "-90" => "<mrow><mo>−</mo><mfrac><mi>π</mi><mn>2</mn></mfrac></mrow>".to_owned(),
            "-180" => "<mrow><mo>−</mo><mi>π</mi></mrow>".to_owned(),
            name => mathml::name(name),
        };
        format!("{}<mo>(</mo>{argument}<mo>)</mo>", mathml::name(f))
    };
    let product: String = factors.iter().map(factor).collect();
    let name = formulas::between("T", from, to);
    (String::new(), mathml::block(&format!("{name}{}{product}", mathml::operator("="))))
}

fn arm(page: &mut Page, model: &Model) -> Result<(), ModelError> {
    page.section("arm", "The arm");
    page.part("As printed: section 2");
    let all = [
        chain("0", "1", &[("R_z", "theta1"), ("T_z", "l1"), ("R_z", "90"), ("R_x", "90")]),
        chain("1", "2", &[("R_z", "theta2"), ("T_x", "l2")]),
        chain("2", "3", &[("R_z", "theta3"), ("T_x", "l3")]),
        chain("3", "4", &[("R_z", "theta4"), ("T_z", "l4"), ("R_x", "-90"), ("R_z", "-180")]),
        chain("4", "5", &[("R_z", "theta5"), ("T_y", "l5"), ("R_x", "-90")]),
        chain("5", "6", &[("R_z", "theta6"), ("T_z", "l6")]),
    ];
    page.formulas(&all);
    let printed = Model::of(SECTION_2)?;
    let turned = printed.body(&[0.3, 0.7, -1.2, 0.0, 0.8, 0.2]);
    let alike = crate::view::dot(turned.joints[2].1, turned.joints[3].1);
    page.text(&format!(
        "Taken as printed, axis 4 is parallel to axes 2 and 3: z<sub>3</sub>·z<sub>4</sub> = {}. Section 3.1 turns by \
         R<sub>y</sub>(π/2) R<sub>z</sub>(π/2) there, and the printed <sup>3</sup>R<sub>6</sub> belongs to that arm.",
        rough(alike)
    ));
    page.part("As it must be");
    page.text(
        "With the turn of section 3.1, l<sub>1</sub> = 0.3, l<sub>2</sub> = 1, l<sub>3</sub> + l<sub>4</sub> = 0.8 m as in \
         its wrist position, l<sub>5</sub> = l<sub>6</sub> = 0 as in its <sup>3</sup>R<sub>6</sub>.",
    );
    page.code(ElbowWrist::TABLE);
    let body = model.body(&inverse::START);
    let zero = model.body(&[0.0; 6]);
    let picture = |body, view| Picture::new(view, model.reach(), "m").arm(body, Look::Solid).named(body);
    page.figure(
        "figure-arm",
        &[
            (
                picture(&zero, View::FRONT).frames(&zero).draw(340.0, "The elbow arm at zero"),
                "All joints zero, from the front; x red, y green, z blue.".to_owned(),
            ),
            (
                picture(&body, View::from(-20.0, 22.0))
                    .draw(340.0, "The elbow arm at the start of its tasks"),
                super::parts::named("θ", &inverse::START),
            ),
        ],
        "The arm, its frames just before the next joint.",
    );
    Ok(())
}

fn workspace(page: &mut Page, model: &Model) {
    page.section("workspace", "Workspace");
    let ways = |rho: f64, z: f64| postures(&ElbowWrist, [0.0; 3], rho, z);
    let section = Section::of(model, "m", &ways);
    page.figure(
        "figure-workspace",
        &[(section.draw(380.0, "Cross-section of the workspace of the wrist centre"), String::new())],
        "Where the wrist centre can be, cut through axis 1: the stretched and the folded arm, and axis 1 itself, which the \
         report’s list of singularities lacks.",
    );
}

fn wrong(page: &mut Page) {
    let shoulder = inverse::shoulder_margin();
    let all = vec![
        Mistake {
            key: "chain",
            place: "section 2, <sup>2</sup>T<sub>3</sub>",
            printed: "R<sub>z</sub>(θ<sub>3</sub>) T<sub>x</sub>(l<sub>3</sub>)".to_owned(),
            truth: "… R<sub>y</sub>(π/2) R<sub>z</sub>(π/2), as in section 3.1".to_owned(),
            consequence: "axis 4 would be parallel to axes 2 and 3, and no wrist spherical".to_owned(),
        },
        Mistake {
            key: "arctan",
            place: "(3.1)–(3.6), all arctan, arccos and arcsin",
            printed: "θ<sub>1</sub> = −arctan(x/y), q<sub>2</sub> = arcsin(…), q<sub>4</sub> = arctan(…)"
                .to_owned(),
            truth: "Atan2 of sine and cosine".to_owned(),
            consequence: format!(
                "as printed {}; with the sign of q<sub>6</sub> {}; with Atan2 everywhere {}",
                share(replay::reproduced(replay::Fixes::PRINTED), TRIALS),
                share(replay::reproduced(replay::Fixes { sign: true, ..replay::Fixes::PRINTED }), TRIALS),
                share(replay::reproduced(replay::Fixes::ALL), TRIALS)
            ),
        },
        Mistake {
            key: "q6",
            place: "3.6, q<sub>6</sub>",
            printed: "arctan(−s<sub>6</sub>/c<sub>6</sub>)".to_owned(),
            truth: "Atan2(−r<sub>32</sub>, r<sub>31</sub>)".to_owned(),
            consequence: "q<sub>6</sub> with the wrong sign in every pose".to_owned(),
        },
        Mistake {
            key: "singularities",
            place: "3.7, the list of singularities",
            printed: "θ<sub>3</sub> = 0 or π, θ<sub>5</sub> = 0 or π".to_owned(),
            truth: "also the wrist centre on axis 1: the factor of det J that belongs to the shoulder"
                .to_owned(),
            consequence: format!(
                "there σ<sub>min</sub> = {} with θ<sub>3</sub>, θ<sub>5</sub> far from 0 and π",
                rough(shoulder)
            ),
        },
        motion::triangle(),
        motion::cruise(),
    ];
    mistakes(
        page,
        "The printed wrist position and <sup>3</sup>R<sub>6</sub> are right. Measured while this page was written.",
        all,
    );
}
