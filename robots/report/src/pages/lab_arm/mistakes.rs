//! What is wrong in the report, measured.

use kin_gen::back::mathml;
use kin_gen::model::Solver;
use kin_runtime::prelude::*;
use kin_runtime::singularity::{scaled, singular_values};
use nalgebra::{Matrix3, Vector3};
use robots::LabArm;

use super::super::parts::{Mistake, exactly, mistakes, share};
use super::super::sample::{Sample, TRIALS};
use super::examples::{EXAMPLES, highest};
use crate::exact::decimal;
use crate::html::{Page, Table, number, rough};
use crate::model::Model;

pub(super) fn section(page: &mut Page, model: &Model) {
    aligned(page, model);
    let all = vec![
        matrix_4_7(model),
        inverse_4_6(),
        wrist_4_3(model),
        aligned_axes(),
        shoulder(),
        family_6_1(),
        families_6_3(),
        lengths_6_5(model),
        precision_6_5(model),
        range(),
    ];
    let lead = "The arm, the method and nearly every number of the report are right. These are not; what follows from each was \
                measured while this page was written, on 200 random configurations where a formula is meant.";
    mistakes(page, lead, all);
}

/// The two configurations of section 5 that the report judges wrongly.
pub(super) const ALIGNED: [(&str, &str, [f64; 6]); 2] = [
    (
        "z1 aligned with z4",
        "singular z1 z4",
        [0.3, 7.424_206_202_669_955, -12.136_595_183_054_645, 0.4, 0.9, -0.5],
    ),
    ("wrist centre on z1", "singular wrist on z1", [0.3, -2.214_505_583_207_689, -1.4575, 0.7, 0.8, 0.2]),
];

fn values(q: [f64; 6]) -> Joints<f64, 6> {
    // Millimetres to metres, as the linear rows are usually given.
    singular_values(&scaled(&LabArm.jacobian(&Joints::from(q)), 1000.0))
}

fn aligned(page: &mut Page, model: &Model) {
    page.section("singular", "Section 5: which alignments are singular");
    page.text(
        "Singular values of the Jacobian, its linear rows in metres per radian. In both configurations the sixth is zero to \
         the last bit: the rank is 5.",
    );
    let mut table = Table::new(&["configuration", "", "1", "2", "3", "4", "5", "6"]);
    for (words, key, q) in ALIGNED {
        let cells = |first: &str, second: &str, values: &[f64]| {
            let mut cells = vec![first.to_owned(), second.to_owned()];
            cells.extend(values.iter().map(|x| number(*x, 15)));
            cells
        };
        table.row(&format!("{key} q"), cells(words, "θ", &q));
        let sigma: Vec<f64> = values(q).iter().copied().collect();
        let mut row = cells("", "σ", &sigma);
        row[7] = rough(sigma[5]);
        table.row(&format!("{key} sigma"), row);
    }
    page.table(&table);
    let body = model.body(&ALIGNED[0].2);
    let mut table = Table::new(&["axis", "x", "y", "z"]);
    for joint in [0, 3] {
        let axis = body.joints[joint].1;
        let mut cells = vec![format!("z<sub>{}</sub>", joint + 1)];
        cells.extend(axis.iter().map(|x| number(*x, 15)));
        table.row(&format!("singular axis {}", joint + 1), cells);
    }
    page.table(&table);
    let tip = LabArm.fk(&Joints::from(ALIGNED[1].2)).translation.vector;
    let mut table = Table::new(&["tool point, wrist centre on z<sub>1</sub>", "x, mm", "y, mm"]);
    table.row("singular tool", vec!["off axis 1".to_owned(), number(tip.x, 12), number(tip.y, 12)]);
    page.table(&table);
}

fn matrix_4_7(model: &Model) -> Mistake {
    let truth = match &model.arm.solver {
        Solver::Pose(solver) => mathml::poly(&model.arm.ring, &solver.r36_meaning[0][1]),
        _ => String::new(),
    };
    let ring = &model.arm.ring;
    let product = |names: &[&str]| names.iter().filter_map(|n| ring.named(n)).reduce(|a, b| ring.mul(&a, &b));
    let wrong = match (product(&["c4", "c6", "s6"]), product(&["s4", "c6"])) {
        (Some(a), Some(b)) => ring.sub(&a.neg(), &b),
        _ => Default::default(),
    };
    let mut sample = Sample(47);
    let (mut worst, mut rotations) = (0.0f64, 0);
    for _ in 0..TRIALS {
        let [q4, q5, q6] = sample.angles::<3>();
        let mut r: Matrix3<f64> = LabArm.r36(q4, q5, q6);
        let printed = -q4.cos() * q6.cos() * q6.sin() - q4.sin() * q6.cos();
        worst = worst.max((printed - r[(0, 1)]).abs());
        r[(0, 1)] = printed;
        rotations += usize::from((r.transpose() * r - Matrix3::identity()).amax() < 1e-9);
    }
    Mistake {
        key: "4.7",
        place: "(4.7), entry (1, 2) of <sup>3</sup>T<sub>6</sub>",
        printed: mathml::inline(&mathml::poly(ring, &wrong)),
        truth: mathml::inline(&truth),
        consequence: format!(
            "wrong by up to {}; {} printed matrices are rotations. The other fifteen entries are right.",
            rough(worst),
            share(rotations, TRIALS)
        ),
    }
}

fn inverse_4_6() -> Mistake {
    let mut sample = Sample(46);
    let (mut worst, mut right) = (0.0f64, 0);
    for _ in 0..TRIALS {
        let frame = LabArm.frames(&Joints::from(sample.angles::<6>()))[2];
        let (r, p) = (frame.rotation.matrix(), frame.translation.vector);
        // The printed inverse applied to the frame's own origin, which must come to rest at zero.
        let landed: Vector3<f64> = r.transpose() * p + r.transpose() * p;
        worst = worst.max(landed.norm());
        right += usize::from(landed.norm() < 1e-6);
    }
    Mistake {
        key: "4.6",
        place: "(4.6), translation of the inverse of <sup>0</sup>T<sub>3</sub>",
        printed: "Rᵀ P".to_owned(),
        truth: "−Rᵀ P".to_owned(),
        consequence: format!(
            "the origin of frame 3 is carried up to {} mm away from zero; {} inverses are inverses",
            rough(worst),
            share(right, TRIALS)
        ),
    }
}

fn wrist_4_3(model: &Model) -> Mistake {
    let book = &model.textbook;
    let origin = book.links.get(5).map(|link| link.position.clone()).unwrap_or_default();
    let truth: Vec<Vec<String>> = origin.iter().map(|p| vec![mathml::poly(&book.own.ring, p)]).collect();
    let mut sample = Sample(43);
    let (mut literal, mut column) = (0.0f64, 0.0f64);
    for _ in 0..TRIALS {
        let q = Joints::from(sample.angles::<6>());
        let frames = LabArm.frames(&q);
        let tip = LabArm.fk(&q);
        let fifth = frames[4];
        let offset = Vector3::new(0.0, 0.0, 29.0);
        let found = tip.translation.vector - fifth.rotation * offset;
        literal = literal.max((found - fifth.translation.vector).norm());
        let found = tip.translation.vector - tip.rotation * offset;
        column = column.max((found - fifth.translation.vector).norm());
    }
    Mistake {
        key: "4.3",
        place: "(4.1)–(4.3), origin of frame 6 in frame 5",
        printed: "<sup>0</sup>R<sub>5</sub> = <sup>0</sup>R<sub>6</sub> and P = (0, 0, d<sub>6</sub>)"
            .to_owned(),
        truth: format!(
            "{} with <sup>0</sup>R<sub>5</sub>; (0, 0, d<sub>6</sub>) only with <sup>0</sup>R<sub>6</sub>",
            mathml::inline(&mathml::matrix(&truth))
        ),
        consequence: format!(
            "taken literally the wrist centre is up to {} mm off; with the third column of <sup>0</sup>R<sub>6</sub> it is \
             right to {} mm",
            rough(literal),
            rough(column)
        ),
    }
}

fn aligned_axes() -> Mistake {
    let sigma = values(ALIGNED[0].2);
    Mistake {
        key: "z1 z4",
        place: "section 5, z<sub>1</sub> aligned with z<sub>4</sub>",
        printed: "“it is <em>not</em> a singularity”".to_owned(),
        truth: "it is one: axes 1 and 4 turn the tool the same way".to_owned(),
        consequence: format!(
            "σ<sub>6</sub> = {}, σ<sub>5</sub> = {}: rank 5",
            rough(sigma[5]),
            rough(sigma[4])
        ),
    }
}

fn shoulder() -> Mistake {
    let sigma = values(ALIGNED[1].2);
    let tip = LabArm.fk(&Joints::from(ALIGNED[1].2)).translation.vector;
    Mistake {
        key: "z1 z6",
        place: "section 5, a): test for the singular shoulder",
        printed: "z<sub>1</sub> aligned with z<sub>6</sub>, tool and frame 5 both on axis 1".to_owned(),
        truth: "the wrist centre on axis 1, whatever the orientation: where the shoulder’s factor of det J vanishes".to_owned(),
        consequence: format!(
            "with the tool {} mm off the axis σ<sub>6</sub> = {}; the report’s test cannot see it",
            rough(tip.x.hypot(tip.y)),
            rough(sigma[5])
        ),
    }
}

/// Isolated solutions and families of an example.
fn counts(key: &str) -> (usize, usize) {
    let Some(example) = EXAMPLES.iter().find(|e| e.key == key) else { return (0, 0) };
    let solutions = LabArm.ik(&super::super::parts::pose_of(&example.frame()));
    let isolated = solutions.iter().filter(|s| s.is_isolated()).count();
    (isolated, solutions.iter().filter(|s| !s.is_isolated()).count())
}

fn family_6_1() -> Mistake {
    let (isolated, families) = counts("6.1 default");
    Mistake {
        key: "6.1",
        place: "6.1, rows 5 and 6",
        printed: "two of eight solutions".to_owned(),
        truth: "two members of one family, θ<sub>4</sub> + θ<sub>6</sub> = 0".to_owned(),
        consequence: format!(
            "{isolated} isolated solutions and {families} family; θ<sub>4</sub> may take any value"
        ),
    }
}

fn families_6_3() -> Mistake {
    let (isolated, families) = counts("6.3 z1 aligned z6");
    Mistake {
        key: "6.3",
        place: "6.3, the eight rows",
        printed: "eight solutions".to_owned(),
        truth: "two members of each of four families".to_owned(),
        consequence: format!(
            "{isolated} isolated solutions and {families} families; θ<sub>1</sub> may take any value"
        ),
    }
}

fn lengths_6_5(model: &Model) -> Mistake {
    let length = |name: &str| model.length(name).map_or_else(String::new, |x| exactly(x, 0));
    Mistake {
        key: "6.5 lengths",
        place: "6.5, “d<sub>3_5</sub> = 131.529… ≈ 130 = a2”",
        printed: "a<sub>2</sub> = 130".to_owned(),
        truth: format!("a<sub>2</sub> = {}, d<sub>5</sub> = {}", length("a2"), length("d5")),
        consequence: "Table 3.1 itself says so; 131.529 is near d<sub>5</sub>, and z<sub>2</sub> does not line up with it \
                      but for the bend of a<sub>4</sub>"
            .to_owned(),
    }
}

fn precision_6_5(model: &Model) -> Mistake {
    let out = |z: &str| {
        let frame = crate::exact::zyx([decimal("-30"), decimal("0"), decimal(z)], [decimal("0"); 3]);
        LabArm.ik(&super::super::parts::pose_of(&frame)).len()
    };
    Mistake {
        key: "6.5 precision",
        place: "6.5, conclusion",
        printed: "“precision until the 7<sup>th</sup> decimal order”, 10⁻¹⁰ m".to_owned(),
        truth: format!("the limit is the arm’s: {} mm", exactly(highest(model), 14)),
        consequence: format!(
            "z = 372.52946437 has {} solutions, 372.52946438 has {}: nothing was lost",
            out("372.52946437"),
            out("372.52946438")
        ),
    }
}

fn range() -> Mistake {
    Mistake {
        key: "range",
        place: "6.1 and 6.4, angles",
        printed: "θ<sub>2</sub> = 4.0689, θ<sub>1</sub> = 6.2832".to_owned(),
        truth: format!("{} and {}", number(4.0689 - std::f64::consts::TAU, 4), number(0.0, 4)),
        consequence: "the same positions; angles outside (−π, π] are not comparable with limits".to_owned(),
    }
}
