//! The numeric examples of section 6, beside the true values.

use kin_gen::number::Real;
use kin_runtime::prelude::*;
use robots::LabArm;

use super::super::parts::{
    double, exactly, listed, named, pose_of, side_by_side, solution_table, solutions, wrapped,
};
use crate::exact::{decimal, pi_over, zyx};
use crate::html::{Page, Table, digits, number, rough};
use crate::model::{Frame, Model};
use crate::view::View;

/// One inverse example.
pub(super) struct Example {
    /// As the truth of the examples names it.
    pub(super) key: &'static str,
    title: &'static str,
    /// The position as printed.
    position: [&'static str; 3],
    /// Whether the orientation is (π/4, -π/2, -π/4), else it is zero.
    down: bool,
    /// The printed rows.
    printed: &'static [[&'static str; 6]],
    words: &'static str,
}

/// Section 6.1 to 6.5.
pub(super) const EXAMPLES: [Example; 8] = [
    Example {
        key: "6.1 default",
        title: "6.1 Default position",
        position: ["-69", "0", "112"],
        down: true,
        printed: &[
            ["-3.1416", "-1.1547", "-0.4276", "3.1416", "1.5593", "-0.0000"],
            ["-3.1416", "-1.1547", "-0.4276", "-0.0000", "-1.5593", "3.1416"],
            ["-3.1416", "1.7113", "0.7329", "0.0000", "0.6974", "3.1416"],
            ["-3.1416", "1.7113", "0.7329", "-3.1416", "-0.6974", "-0.0000"],
            ["0.0000", "0.0000", "-0.0000", "-0.0000", "0.0000", "-0.0000"],
            ["0.0000", "0.0000", "-0.0000", "3.1416", "-0.0000", "3.1416"],
            ["0.0000", "4.0689", "0.3053", "-0.0000", "1.9090", "-0.0000"],
            ["0.0000", "4.0689", "0.3053", "3.1416", "-1.9090", "3.1416"],
        ],
        words: "Six isolated solutions and one family: with θ₅ = 0 only θ₄ + θ₆ is determined. The fifth and sixth \
                printed rows are two members of that family.",
    },
    Example {
        key: "6.2 stretched forward",
        title: "6.2 Stretched forward",
        position: ["-309", "0", "72"],
        down: true,
        printed: &[
            ["0.0000", "-3.1416", "-2.8363", "-3.1416", "0.3053", "3.1416"],
            ["0.0000", "-3.1416", "-2.8363", "0.0000", "-0.3053", "-0.0000"],
            ["0.0000", "-2.9819", "3.1416", "-3.1416", "0.1597", "3.1416"],
            ["0.0000", "-2.9819", "3.1416", "0.0000", "-0.1597", "-0.0000"],
        ],
        words: "Four solutions, all with θ₁ = 0, as printed.",
    },
    Example {
        key: "6.3 z1 aligned z6",
        title: "6.3 z₁ aligned with z₆",
        position: ["0", "0", "300"],
        down: false,
        printed: &[
            ["0", "0.5950", "-1.4575", "3.1416", "0.7083", "-3.1416"],
            ["0", "0.5950", "-1.4575", "-0.0000", "-0.7083", "0.0000"],
            ["0", "2.2145", "1.7628", "0.0000", "0.7351", "-0.0000"],
            ["0", "2.2145", "1.7628", "-3.1416", "-0.7351", "3.1416"],
            ["3.1416", "0.5950", "-1.4575", "3.1416", "0.7083", "0.0000"],
            ["3.1416", "0.5950", "-1.4575", "-0.0000", "-0.7083", "-3.1416"],
            ["3.1416", "2.2145", "1.7628", "0.0000", "0.7351", "-3.1416"],
            ["3.1416", "2.2145", "1.7628", "-3.1416", "-0.7351", "0.0000"],
        ],
        words: "Four families and no isolated solution: the wrist centre lies on axis 1, θ₁ is free and θ₆ follows. The eight \
                printed rows are two members of each.",
    },
    Example {
        key: "6.4 z4 aligned z6",
        title: "6.4 z₄ aligned with z₆",
        position: ["-10", "0", "371"],
        down: false,
        printed: &[
            ["6.2832", "1.4111", "-2.8363", "3.1416", "0.1456", "-3.1416"],
            ["6.2832", "1.4111", "-2.8363", "-0.0000", "-0.1456", "0.0000"],
            ["6.2832", "1.5708", "3.1416", "0.2450", "0", "-0.2450"],
            ["6.2832", "1.5708", "3.1416", "-2.8966", "0", "2.8966"],
        ],
        words: "Two isolated solutions and one family with θ₅ = 0, all with θ₁ = 0, which the report prints as 6.2832.",
    },
    Example {
        key: "6.5 near reach z=372.52",
        title: "6.5 Near the reach: z = 372.52",
        position: ["-30", "0", "372.52"],
        down: false,
        printed: &[],
        words: "Four solutions.",
    },
    Example {
        key: "6.5 z=372.5294643",
        title: "6.5 Nearer: z = 372.5294643",
        position: ["-30", "0", "372.5294643"],
        down: false,
        printed: &[],
        words: "Four solutions still.",
    },
    Example {
        key: "6.5 z=372.52946438",
        title: "6.5 Too far: z = 372.52946438",
        position: ["-30", "0", "372.52946438"],
        down: false,
        printed: &[],
        words: "None, by geometry and not by a loss of precision.",
    },
    Example {
        key: "6.5 z=372.53",
        title: "6.5 Too far: z = 372.53",
        position: ["-30", "0", "372.53"],
        down: false,
        printed: &[],
        words: "None.",
    },
];

impl Example {
    pub(super) fn frame(&self) -> Frame<Real> {
        let angles = match self.down {
            true => [pi_over(4), -pi_over(2), -pi_over(4)],
            false => [Real::ZERO; 3],
        };
        zyx(self.position.map(decimal), angles)
    }
}

pub(super) fn section(page: &mut Page, model: &Model) {
    page.section("examples", "The numeric examples");
    page.text(
        "Values printed with thirteen decimals are true: the solver’s answer, refined with 256-bit arithmetic until forward \
         kinematics returns to the pose within 10⁻⁴⁵, then rounded. The last column tells how far the solver’s own answer \
         in doubles was from it. σ<sub>min</sub> is the smallest singular value of the Jacobian with its linear rows \
         divided by the sum of all lengths.",
    );
    forward(page, model);
    for example in &EXAMPLES {
        inverse(page, model, example);
    }
    reach(page, model);
}

/// The angles about z, y and x of a rotation, to 256 bits.
fn angles(frame: &Frame<Real>) -> [Real; 3] {
    let r = &frame.rotation;
    let level = (r[2][1] * r[2][1] + r[2][2] * r[2][2]).sqrt();
    [Real::atan2(r[1][0], r[0][0]), Real::atan2(-r[2][0], level), Real::atan2(r[2][1], r[2][2])]
}

/// Position, then angles, as the report prints them after each configuration.
type Printed = [&'static str; 6];

/// The forward examples: joint values, and what the report prints.
const FORWARD: [([&str; 6], Printed); 8] = [
    (["0", "0", "0", "0", "0", "0"], ["-69.0000", "-0.0000", "112.0000", "0.7854", "-1.5708", "-0.7854"]),
    (
        ["-3.1416", "-1.1547", "-0.4276", "3.1416", "1.5593", "0"],
        ["-68.9973", "0.0003", "112.0003", "3.1301", "-1.5708", "-3.1301"],
    ),
    (
        ["-3.1416", "-1.1547", "-0.4276", "0", "-1.5593", "3.1416"],
        ["-68.9973", "0.0005", "112.0003", "2.3562", "-1.5708", "-2.3562"],
    ),
    (
        ["-3.1416", "1.7113", "0.7329", "0", "0.6974", "3.1416"],
        ["-68.9981", "0.0005", "111.9985", "0.7854", "-1.5708", "-0.7854"],
    ),
    (
        ["-3.1416", "1.7113", "0.7329", "-3.1416", "-0.6974", "0"],
        ["-68.9981", "0.0004", "111.9985", "-0.6540", "-1.5708", "0.6540"],
    ),
    (
        ["0", "0", "0", "3.1416", "0", "3.1416"],
        ["-69.0000", "-0.0000", "112.0000", "1.5708", "-1.5708", "-1.5708"],
    ),
    (
        ["0", "4.0689", "0.3053", "0", "1.9090", "0"],
        ["-69.0004", "-0.0000", "111.9995", "3.1416", "-1.5708", "-3.1416"],
    ),
    (
        ["0", "4.0689", "0.3053", "3.1416", "-1.9090", "3.1416"],
        ["-69.0004", "-0.0002", "111.9995", "2.8192", "-1.5708", "-2.8191"],
    ),
];

fn forward(page: &mut Page, model: &Model) {
    page.part("6.1 Forward kinematics");
    page.text(
        "At zero, and of the report’s own truncated solutions. Positions in millimetres; angles about z, y and x in radians. \
         At β = −π/2 only z + x is determined: the report’s (π/4, −π/2, −π/4) is one triple of infinitely many.",
    );
    let mut table = Table::new(&["joint values", "", "x or α", "y or β", "z or γ"]);
    for (index, (q, printed)) in FORWARD.iter().enumerate() {
        let body = model.body(&q.map(decimal));
        let position = body.tip.origin.map(|x| exactly(x, 12));
        let euler = angles(&body.tip).map(|x| exactly(x, 15));
        let ours = LabArm.fk(&Joints::from(q.map(|x| decimal(x).to_f64())));
        let off = (0..3)
            .map(|i| (double(body.tip.origin[i]) - ours.translation.vector[i]).abs())
            .fold(0.0, f64::max);
        let [x, y, z, a, b, c] = printed.map(digits);
        let words = format!("{}<br>in doubles off by {} mm", listed(q), rough(off));
        table.row("", vec![words, "printed, mm".to_owned(), x, y, z]);
        let [x, y, z] = position;
        table.row(&format!("forward position {index}"), vec![String::new(), "true, mm".to_owned(), x, y, z]);
        table.row("", vec![String::new(), "printed, rad".to_owned(), a, b, c]);
        if index > 0 {
            let [a, b, c] = euler;
            table.row(
                &format!("forward angles {index}"),
                vec![String::new(), "true, rad".to_owned(), a, b, c],
            );
        }
    }
    page.table(&table);
    page.text("The pose at zero, as a matrix, is exact:");
    let pose = LabArm.fk(&Joints::from([0.0; 6])).to_homogeneous();
    let mut matrix = Table::new(&["", "", "", "mm"]);
    for i in 0..3 {
        matrix.row("forward matrix", (0..4).map(|j| number(pose[(i, j)], 1)).collect());
    }
    page.table(&matrix);
}

fn inverse(page: &mut Page, model: &Model, example: &Example) {
    let frame = example.frame();
    page.part(example.title);
    let orientation = if example.down { "(π/4, −π/2, −π/4)" } else { "(0, 0, 0)" };
    page.text(&format!(
        "Position {} mm, orientation {orientation}. {}",
        listed(&example.position),
        example.words
    ));
    if example.key.starts_with("6.5") {
        let room = highest(model) - frame.origin[2];
        let side = if room.signum() > 0 { "inside" } else { "beyond" };
        page.text(&format!("The point lies {} mm {side} the limit of the arm.", rough(room.abs().to_f64())));
    }
    let answer = LabArm.ik(&pose_of(&frame));
    page.code(&format!("{answer}").replace('\'', "′"));
    let all = solutions(&LabArm, model, &frame);
    if !all.is_empty() {
        page.table(&solution_table::<LabArm>(&LabArm, example.key, &all));
    }
    if !example.printed.is_empty() {
        printed(page, model, example, &frame, &all);
    }
    pictures(page, model, example, &frame, &all);
}

/// The printed rows, and how far they are from the truth.
fn printed(
    page: &mut Page,
    model: &Model,
    example: &Example,
    frame: &Frame<Real>,
    all: &[super::super::parts::True],
) {
    page.text("As printed, with what forward kinematics makes of it:");
    let mut table = Table::new(&[
        "θ<sub>1</sub>",
        "θ<sub>2</sub>",
        "θ<sub>3</sub>",
        "θ<sub>4</sub>",
        "θ<sub>5</sub>",
        "θ<sub>6</sub>",
        "misses by, mm",
        "in rotation",
        "which it is",
    ]);
    for row in example.printed {
        let exact = row.map(decimal);
        let tip = model.body(&exact).tip;
        let apart = |a: Real, b: Real| double((a - b).abs());
        let position = (0..3).map(|i| apart(tip.origin[i], frame.origin[i])).fold(0.0, f64::max);
        let entries = (0..9).map(|k| apart(tip.rotation[k / 3][k % 3], frame.rotation[k / 3][k % 3]));
        let rotation = entries.fold(0.0, f64::max);
        let q = exact.map(Real::to_f64);
        let distance = |one: &super::super::parts::True| {
            let fixed = (0..6).filter(|i| !one.moving.contains(*i));
            fixed.map(|i| wrapped(q[i] - one.q[i]).abs()).fold(0.0, f64::max)
        };
        let nearest = all.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let which = nearest.map_or_else(String::new, |one| {
            let kind = if one.families.is_empty() { "" } else { "a member of the family of " };
            format!("{kind}{}", one.solution.branch)
        });
        let mut cells: Vec<String> = row.iter().map(|x| digits(x)).collect();
        cells.extend([rough(position), rough(rotation), which]);
        table.row(&format!("printed {}", example.key), cells);
    }
    page.table(&table);
}

/// The configurations side by side.
fn pictures(
    page: &mut Page,
    model: &Model,
    example: &Example,
    frame: &Frame<Real>,
    all: &[super::super::parts::True],
) {
    let mut configurations: Vec<(Vec<f64>, String)> = Vec::new();
    let pose = pose_of(frame);
    for one in all {
        if !one.moving.is_empty() {
            // Two members of each family, as the report prints them: the free joint at one value and half a turn on.
            let first = one.solution.families().next().map_or(0.0, |f| one.q[f.free()]);
            for value in [first, wrapped(first + std::f64::consts::PI)] {
                let members = one.solution.families().map(|f| f.member(&LabArm, &pose, value));
                for member in members.filter_map(|slot| slot.solution().copied()) {
                    configurations.push((member.q.iter().copied().collect(), String::new()));
                }
            }
        } else {
            configurations.push((one.q.to_vec(), String::new()));
        }
    }
    for (q, words) in &mut configurations {
        *words = named("θ", q);
    }
    if configurations.is_empty() {
        return;
    }
    let target = frame.origin.map(double);
    let name = format!("Solutions of section {}", example.title);
    let drawings = side_by_side(model, "mm", View::SIDE, 210.0, &configurations, target, &name);
    let id = example.key.replace([' ', '=', '.'], "-");
    let count = configurations.len();
    page.figure(
        &format!("figure-{id}"),
        &drawings,
        &format!("The {count} configurations, from the side; the target is ringed, the tool frame drawn in colours."),
    );
}

/// The longest that the forearm can be: √(a4² + d5²).
fn forearm(model: &Model) -> Real {
    let length = |name: &str| model.length(name).unwrap_or(Real::ZERO);
    let (a4, d5) = (length("a4"), length("d5"));
    (a4 * a4 + d5 * d5).sqrt()
}

/// The highest that the tool point can be.
pub(super) fn highest(model: &Model) -> Real {
    let lengths = ["d1", "d2", "a2", "d6"].map(|name| model.length(name).unwrap_or(Real::ZERO));
    lengths.into_iter().fold(forearm(model), |sum, length| sum + length)
}

fn reach(page: &mut Page, model: &Model) {
    page.part("6.5 The limit itself");
    page.text(
        "The longest the forearm can be is d<sub>3_5</sub> = √(a<sub>4</sub>² + d<sub>5</sub>²); stretched upwards the tool \
         stands at d<sub>1</sub> + d<sub>2</sub> + a<sub>2</sub> + d<sub>3_5</sub> + d<sub>6</sub>.",
    );
    let mut table = Table::new(&["", "mm"]);
    table.row("limit d35", vec!["d<sub>3_5</sub>".to_owned(), exactly(forearm(model), 16)]);
    table.row("limit zmax", vec!["highest tool point".to_owned(), exactly(highest(model), 16)]);
    page.table(&table);
}
