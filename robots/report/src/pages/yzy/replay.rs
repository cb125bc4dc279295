//! The printed inverse, carried out.

use super::super::parts::share;
use super::super::sample::{Sample, TRIALS};
use crate::html::{Page, Table};
use crate::model::{Frame, Model, ModelError};

/// The report's chain with its lengths: d1 = 0, as its inverse assumes.
pub(super) fn with_lengths(d3: &str, d4: &str) -> Result<Model, ModelError> {
    let d4 = if d4 == "0" { String::new() } else { format!("Ty({d4})") };
    Model::of(&format!(
        "struct Printed(chain, m, rad); let d2 = 1; let d3 = {d3}; let d5 = 1;
         Rz(q) Rx(q) Ty(d2) Rx(q) Ty(d3) Ry(q) {d4} Rz(q) Ty(d5) Ry(q);"
    ))
}

/// Which of the four mistakes are put right.
#[derive(Clone, Copy)]
pub(super) struct Fixes {
    pub(super) wrist: bool,
    pub(super) theta1: bool,
    pub(super) theta4: bool,
    pub(super) length: bool,
}

/// None.
pub(super) const PRINTED: Fixes = Fixes { wrist: false, theta1: false, theta4: false, length: false };

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
pub(super) fn reproduced(model: &Model, lengths: [f64; 4], fixes: Fixes) -> (usize, usize) {
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

pub(super) fn section(page: &mut Page) -> Result<(), ModelError> {
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
