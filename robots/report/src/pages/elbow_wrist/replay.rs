//! The printed inverse, carried out.

use kin_runtime::prelude::*;
use robots::ElbowWrist;

use super::super::parts::share;
use super::super::sample::{Sample, TRIALS};
use crate::html::{Page, Table};
use crate::model::Model;

/// What is put right.
#[derive(Clone, Copy)]
pub(super) struct Fixes {
    /// The sign of q6.
    pub(super) sign: bool,
    /// Atan2 for θ1, θ2, and the wrist.
    pub(super) atan2: [bool; 3],
}

impl Fixes {
    /// Nothing.
    pub(super) const PRINTED: Fixes = Fixes { sign: false, atan2: [false; 3] };
    /// Everything.
    pub(super) const ALL: Fixes = Fixes { sign: true, atan2: [true; 3] };
}

const L: [f64; 3] = [0.3, 1.0, 0.8];

/// The report's inverse, line by line.
fn inverse(pose: &Pose<f64>, fixes: Fixes) -> [f64; 6] {
    let [x, y, z] = pose.translation.vector.data.0[0];
    let [l1, l2, l34] = L;
    let theta1 = if fixes.atan2[0] { (-x).atan2(y) } else { -(x / y).atan() };
    let s = z - l1;
    let q3 = ((s * s + x * x + y * y - l2 * l2 - l34 * l34) / (2.0 * l2 * l34)).clamp(-1.0, 1.0).acos();
    let (r, whole) = (x.hypot(y), x * x + y * y + s * s);
    let sine = ((l2 + l34 * q3.cos()) * s - l34 * q3.sin() * r) / whole;
    let cosine = ((l2 + l34 * q3.cos()) * r + l34 * q3.sin() * s) / whole;
    let q2 = if fixes.atan2[1] { sine.atan2(cosine) } else { sine.clamp(-1.0, 1.0).asin() };
    let (third, _) = ElbowWrist.r03(theta1, q2, q3);
    let m = third.transpose() * pose.rotation.matrix();
    let q5 = m[(0, 2)].hypot(m[(1, 2)]).atan2(m[(2, 2)]);
    let sign = if fixes.sign { -1.0 } else { 1.0 };
    let (q4, q6) = if fixes.atan2[2] {
        (m[(1, 2)].atan2(m[(0, 2)]), (sign * m[(2, 1)]).atan2(m[(2, 0)]))
    } else {
        ((m[(1, 2)] / m[(0, 2)]).atan(), (sign * m[(2, 1)] / m[(2, 0)]).atan())
    };
    [theta1, q2, q3, q4, q5, q6]
}

/// How many of the poses of random configurations come back.
pub(super) fn reproduced(fixes: Fixes) -> usize {
    let mut sample = Sample(3);
    let mut right = 0;
    for _ in 0..TRIALS {
        let pose = ElbowWrist.fk(&Joints::from(sample.angles::<6>()));
        let back = ElbowWrist.fk(&Joints::from(inverse(&pose, fixes)));
        right += usize::from((back.to_homogeneous() - pose.to_homogeneous()).amax() < 1e-6);
    }
    right
}

pub(super) fn section(page: &mut Page, _: &Model) {
    page.section("replay", "The printed inverse, replayed");
    page.text(
        "The report’s formulas carried out on the poses of 200 random configurations, and put back into forward kinematics. \
         Even with every angle by Atan2 they give one of eight solutions.",
    );
    let mut table = Table::new(&["put right", "reproduced"]);
    let with = |atan2: [bool; 3]| Fixes { sign: true, atan2 };
    for (words, key, fixes) in [
        ("as printed", "printed", Fixes::PRINTED),
        ("the sign of q<sub>6</sub>", "sign", with([false; 3])),
        ("and θ<sub>1</sub> by Atan2", "theta1", with([true, false, false])),
        ("and q<sub>2</sub> by Atan2", "theta2", with([true, true, false])),
        ("and the wrist by Atan2", "all", Fixes::ALL),
    ] {
        let key = format!("replay {key}");
        table.row(&key, vec![words.to_owned(), share(reproduced(fixes), TRIALS)]);
    }
    page.table(&table);
}
