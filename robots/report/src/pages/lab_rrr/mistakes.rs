//! What is wrong in the report, measured.

use std::f64::consts::PI;

use super::super::parts::{Mistake, mistakes, share};
use super::super::sample::{Sample, TRIALS};
use super::{L, distance, geometric, position, printed_inverse};
use crate::html::{Page, number};

pub(super) fn section(page: &mut Page) {
    let mut sample = Sample(4);
    let (mut forward, mut inverse, mut bent) = (0, 0, 0);
    for _ in 0..TRIALS {
        let q = sample.angles::<3>();
        let point = position(q);
        let right = distance(geometric(q), point) < 1e-9;
        forward += usize::from(right);
        bent += usize::from(q[2] <= 0.0);
        inverse += usize::from(distance(position(printed_inverse(point)), point) < 1e-9);
    }
    let mut all = tables();
    all.extend([
        Mistake {
            key: "geometric",
            place: "geometric forward kinematics",
            printed: "ψ = q<sub>2</sub> − cos⁻¹(x/2l)".to_owned(),
            truth: "ψ = q<sub>2</sub> + q<sub>3</sub>/2, that is − for q<sub>3</sub> ≤ 0 and + above".to_owned(),
            consequence: format!(
                "{} random configurations right, {bent} of which have q<sub>3</sub> ≤ 0",
                share(forward, TRIALS)
            ),
        },
        Mistake {
            key: "inverse",
            place: "inverse kinematics as printed",
            printed: "q<sub>2</sub> = π/2 − α<sub>1</sub> − α<sub>2</sub>, q<sub>1</sub> = tan⁻¹(P<sub>y</sub>/P<sub>x</sub>)"
                .to_owned(),
            truth: "q<sub>2</sub> = α<sub>2</sub> ∓ α<sub>1</sub> for q<sub>3</sub> = ±…, q<sub>1</sub> by atan2, and both again \
                    with the arm turned round"
                .to_owned(),
            consequence: format!("{} random points reproduced", share(inverse, TRIALS)),
        },
    ]);
    all.extend(formulas());
    mistakes(page, "Measured while this page was written, on 200 random configurations.", all);
}

/// The tables.
fn tables() -> Vec<Mistake> {
    vec![
        Mistake {
            key: "final table",
            place: "“final solution”, row 1",
            printed: "d<sub>1</sub> = 0".to_owned(),
            truth: "d<sub>1</sub> = d = 0.168 m".to_owned(),
            consequence: "every height is 0.168 m too low; the report’s own test fails with it".to_owned(),
        },
        Mistake {
            key: "alpha",
            place: "table by the joints",
            printed: "α<sub>2</sub> = q<sub>2</sub>, α<sub>3</sub> = q<sub>3</sub>".to_owned(),
            truth: "joints turn about z: q belongs under θ".to_owned(),
            consequence: "no arm; a compile error under each of the two cells".to_owned(),
        },
    ]
}

/// The formulas of one page that do not agree with one another.
fn formulas() -> Vec<Mistake> {
    let x = L;
    vec![
        Mistake {
            key: "cosine",
            place: "cosine rule for α<sub>1</sub>",
            printed: "cos⁻¹((l² − l² − x²)/2lx) = cos⁻¹(−x/2l)".to_owned(),
            truth: "cos⁻¹(x/2l), as the next line uses".to_owned(),
            consequence: format!(
                "at x = l: {} against {} rad",
                number((-x / (2.0 * L)).acos(), 4),
                number((x / (2.0 * L)).acos(), 4)
            ),
        },
        Mistake {
            key: "q3",
            place: "q<sub>3</sub>, three forms on one page",
            printed: "π + cos⁻¹((x² − 2l²)/2l²) and π − cos⁻¹((2l² − x²)/2l²)".to_owned(),
            truth: "the second, and its negative: two elbows".to_owned(),
            consequence: format!(
                "at x = l they are {} and {} rad",
                number(PI + ((x * x - 2.0 * L * L) / (2.0 * L * L)).acos(), 4),
                number(PI - ((2.0 * L * L - x * x) / (2.0 * L * L)).acos(), 4)
            ),
        },
    ]
}
