//! What is wrong in the report, measured.

use kin_gen::back::mathml;
use kin_runtime::prelude::*;
use robots::Anthropomorphic;

use super::super::parts::{Mistake, joint_cells, mistakes, share};
use super::super::sample::{Sample, TRIALS};
use super::replay::{Fixes, PRINTED, reproduced, with_lengths};
use crate::html::{Page, number, rough};
use crate::model::{Model, ModelError};

/// The wrist centre with d4 = 0, for the sum of squares.
const WRIST: &str = "struct Wrist(chain, m, rad); let d1 = 1; let d2 = 3; let d3 = 1;
    Rz(q) Tz(d1) Rx(q) Ty(d2) Rx(q) Ty(d3);";

pub(super) fn section(page: &mut Page, model: &Model) -> Result<(), ModelError> {
    let mut all = vec![wrist_position(model)];
    all.extend(signs()?);
    all.extend([
        squares()?,
        line(),
        Mistake {
            key: "one of eight",
            place: "s<sub>3</sub> “with positive sign just because”",
            printed: "one solution".to_owned(),
            truth: "eight".to_owned(),
            consequence: format!("{} of 200 random poses have all eight branches solved", eight()),
        },
    ]);
    mistakes(
        page,
        "The printed <sup>3</sup>R<sub>6</sub> is right: the algebra gives the same nine polynomials.",
        all,
    );
    Ok(())
}

/// What the wrist centre is.
fn wrist_position(model: &Model) -> Mistake {
    let fused = &model.textbook.fused;
    let centre = fused.wrist_centre.clone().unwrap_or_default();
    let cells: Vec<Vec<String>> = centre.iter().map(|p| vec![mathml::poly(&fused.ring, p)]).collect();
    Mistake {
            key: "wrist position",
            place: "position of the wrist",
            printed: "(c<sub>1</sub>k, s<sub>1</sub>k, …), k = d<sub>2</sub>c<sub>2</sub> + d<sub>3</sub>c<sub>23</sub>".to_owned(),
            truth: mathml::inline(&mathml::matrix(&cells)),
            consequence: "at zero the arm lies along y, not x".to_owned(),
        }
}

/// The three signs and the length without which nothing is reproduced.
fn signs() -> Result<Vec<Mistake>, ModelError> {
    let unit = with_lengths("1", "0")?;
    let (printed, unreachable) = reproduced(&unit, [1.0, 1.0, 0.0, 1.0], PRINTED);
    let alone = |fixes| share(reproduced(&unit, [1.0, 1.0, 0.0, 1.0], fixes).0, TRIALS);
    let split = with_lengths("0.6", "0.4")?;
    let lost = Fixes { length: false, wrist: true, theta1: true, theta4: true };
    Ok(vec![
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
    ])
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
