//! Seed 004: the three-joint lab arm.

mod mistakes;

use std::f64::consts::{FRAC_PI_2, PI};

use kin_gen::number::Real;
use kin_runtime::position_dexterity;
use kin_runtime::prelude::*;
use robots::LabRrr;

use super::parts::{double, exactly, joint_cells, named, overlaid, side_by_side, wrapped};
use crate::exact::{Goal, decimal, refined};
use crate::formulas;
use crate::html::{Page, Table, digits, number, rough};
use crate::model::{Model, ModelError};
use crate::picture::{Look, Picture};
use crate::section::Section;
use crate::view::View;

/// The report's lengths, in metres.
const D: f64 = 0.168;
const L: f64 = 0.133_35;

/// The “final” table, which lost d.
const FINAL: &str = "struct Final(standard, m, rad);
let l = 0.13335;
| i | a | alpha | d | theta |
|---|---|-------|---|-------|
| 1 | 0 | pi/2  | 0 | q     |
| 2 | l | 0     | 0 | q     |
| 3 | l | 0     | 0 | q     |";

/// Writes the page.
///
/// # Errors
/// If the arm's own table were refused.
pub fn page() -> Result<Page, ModelError> {
    let model = Model::of(LabRrr::TABLE)?;
    let last = Model::of(FINAL)?;
    let mut page = Page::new(
        "Three-joint lab arm: forward and inverse kinematics",
        "“Laboratory #1”, handwritten notes of January 2021: three tables, a geometric solution, one test point. What was \
         right, what was not, and all four solutions.",
    );
    arm(&mut page, &model);
    formulas::derivation(&mut page, &model);
    examples(&mut page, &model, &last);
    solutions(&mut page, &model);
    workspace(&mut page, &model);
    mistakes::section(&mut page);
    Ok(page)
}

fn arm(page: &mut Page, model: &Model) {
    page.section("arm", "The arm");
    page.part("As printed: three tables");
    page.text("Standard Denavit-Hartenberg parameters, d = 0.168 m, l = 0.13335 m.");
    let mut table =
        Table::new(&["table", "i", "a<sub>i</sub>", "α<sub>i</sub>", "d<sub>i</sub>", "θ<sub>i</sub>"]);
    for (name, rows) in [
        (
            "preparation",
            [["1", "0", "π/2", "d", "q₁"], ["2", "l", "0", "0", "q₂"], ["3", "l", "0", "0", "q₃"]],
        ),
        (
            "by the joints",
            [["1", "0", "0", "d₁", "q₁"], ["2", "0", "q₂", "l₂", "0"], ["3", "0", "q₃", "l₃", "0"]],
        ),
        (
            "“final solution”",
            [["1", "0", "π/2", "0", "θ₁"], ["2", "l", "0", "0", "θ₂"], ["3", "l", "0", "0", "θ₃"]],
        ),
    ] {
        for (index, row) in rows.iter().enumerate() {
            let mut cells = vec![if index == 0 { name.to_owned() } else { String::new() }];
            cells.extend(row.iter().map(|cell| (*cell).to_owned()));
            table.row("", cells);
        }
    }
    page.table(&table);
    page.text(
        "The second has the joint variable under α, which is a twist and cannot vary: the compiler refuses it under that \
         cell. The third lost d.",
    );
    page.part("As it must be");
    page.text("The table of the preparation, with the report’s own test as a check.");
    page.code(LabRrr::TABLE);
    let q = [0.5, 0.5, -0.5];
    let body = model.body(&q);
    let zero = model.body(&[0.0; 3]);
    let picture =
        |body, view| Picture::new(view, model.reach(), "m").arm(body, Look::Solid).named(body).frames(body);
    page.figure(
        "figure-arm",
        &[
            (
                picture(&zero, View::SIDE).draw(330.0, "The three-joint arm at zero, from the side"),
                "All joints zero, from the side.".to_owned(),
            ),
            (
                picture(&body, View::from(-60.0, 20.0)).draw(330.0, "The three-joint arm at its test point"),
                "The test point, q = (0.5, 0.5, −0.5).".to_owned(),
            ),
        ],
        "The arm with the frame of each joint: x red, y green, z blue.",
    );
}

/// The report's geometric forward kinematics: ψ = q₂ - acos(x / 2l), which bends the elbow one way only.
fn geometric(q: [f64; 3]) -> [f64; 3] {
    let x = (2.0 * L * L - 2.0 * L * L * (PI - q[2]).cos()).sqrt();
    let psi = q[1] - (x / (2.0 * L)).acos();
    let s = x * psi.cos();
    [s * q[0].cos(), s * q[0].sin(), D + x * psi.sin()]
}

/// The report's inverse, as printed.
fn printed_inverse(p: [f64; 3]) -> [f64; 3] {
    let square = p[0] * p[0] + p[1] * p[1] + (p[2] - D) * (p[2] - D);
    let x = square.sqrt();
    let q3 = PI - ((2.0 * L * L - square) / (2.0 * L * L)).acos();
    let alpha1 = (x * x / (2.0 * L * x)).acos();
    let alpha2 = ((p[2] - D) / p[0].hypot(p[1])).atan();
    [(p[1] / p[0]).atan(), FRAC_PI_2 - alpha1 - alpha2, q3]
}

fn position(q: [f64; 3]) -> [f64; 3] {
    let p = LabRrr.fk(&Joints::from(q)).translation.vector;
    [p.x, p.y, p.z]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// The configurations on which the geometric formula is tried.
const GEOMETRIC: [[f64; 3]; 4] = [[0.5, 0.5, -0.5], [0.5, 0.5, 0.5], [0.3, 0.9, -1.2], [0.3, 0.9, 1.2]];

fn examples(page: &mut Page, model: &Model, last: &Model) {
    page.section("examples", "The numeric examples");
    page.part("for_kin([0.5, 0.5, −0.5])");
    let test = ["0.5", "0.5", "-0.5"].map(decimal);
    let exact = model.body(&test).tip.origin;
    let lost = last.body(&test).tip.origin;
    let mut table = Table::new(&["", "x, m", "y, m", "z, m"]);
    let row = |name: &str, cells: [String; 3]| [vec![name.to_owned()], cells.to_vec()].concat();
    table.row("", row("printed", ["0.21973", "0.12004", "0.23193"].map(digits)));
    table.row("for_kin", row("true, 20 decimals", exact.map(|x| exactly(x, 20))));
    let ours = position([0.5, 0.5, -0.5]);
    table.row("for_kin doubles", row("in doubles", ours.map(|x| number(x, 17))));
    table.row("for_kin final", row("with the “final” table", lost.map(|x| exactly(x, 20))));
    page.table(&table);
    page.text("The printed numbers are the true ones, rounded; the “final” table is 0.168 m too low.");

    page.part("The geometric forward kinematics");
    page.text("ψ = q₂ − cos⁻¹(x / 2l) bends the elbow one way: it holds for q₃ ≤ 0 only.");
    let mut table = Table::new(&["q", "", "x, m", "y, m", "z, m", "apart, m"]);
    for (index, q) in GEOMETRIC.iter().enumerate() {
        let (theirs, ours) = (geometric(*q), position(*q));
        let words = format!("({}, {}, {})", q[0], q[1], q[2]).replace('-', "−");
        let cells = |a: String, b: &str, p: [f64; 3], c: String| {
            [vec![a, b.to_owned()], p.iter().map(|x| number(*x, 15)).collect(), vec![c]].concat()
        };
        table.row(&format!("geometric {index}"), cells(words, "as printed", theirs, String::new()));
        table
            .row(&format!("true {index}"), cells(String::new(), "true", ours, rough(distance(theirs, ours))));
    }
    page.table(&table);

    page.part("The printed inverse of that point");
    let found = printed_inverse(ours);
    let back = position(found);
    let off = (0..3).map(|i| (back[i] - ours[i]).abs()).fold(0.0, f64::max);
    let mut table = Table::new(&["", "1 or x", "2 or y", "3 or z"]);
    let row = |name: &str, v: [f64; 3]| [vec![name.to_owned()], joint_cells(&v, 15)].concat();
    table.row("printed inverse q", row("q as printed, rad", found));
    table.row("printed inverse fk", row("where that is, m", back));
    table.row(
        "printed inverse off",
        vec!["off, largest coordinate, m".to_owned(), number(off, 15), String::new(), String::new()],
    );
    page.table(&table);
}

/// The true solutions for the test point: as found, then refined.
fn all_four(model: &Model) -> Vec<(Solution<f64, 3, ArmPosture>, [f64; 3])> {
    let test = ["0.5", "0.5", "-0.5"].map(decimal);
    let point: [Real; 3] = model.body(&test).tip.origin;
    let [x, y, z] = point.map(double);
    let found = LabRrr.ik_position(&Point3::new(x, y, z));
    let one = |s: &Solution<f64, 3, ArmPosture>| {
        let q: Vec<f64> = s.q.iter().copied().collect();
        let exact = refined(model, Goal::Point(point), &q, &[])?;
        Some((*s, std::array::from_fn(|i| wrapped(double(exact[i])))))
    };
    found.iter().filter_map(one).collect()
}

fn solutions(page: &mut Page, model: &Model) {
    page.section("solutions", "All four solutions");
    page.text(
        "For the test point, true to the last printed digit. The report looks for one and finds none. The margin is the \
         smallest singular value of the linear rows divided by the sum of all lengths.",
    );
    let all = all_four(model);
    let mut table = Table::new(&[
        "branch",
        "q<sub>1</sub>",
        "q<sub>2</sub>",
        "q<sub>3</sub>",
        "margin",
        "off in doubles",
    ]);
    for (solution, q) in &all {
        let mut cells = vec![solution.branch.to_string()];
        cells.extend(joint_cells(q, 15));
        cells.push(rough(position_dexterity(&LabRrr, &Joints::from(*q)).margin));
        let off = q.iter().zip(&solution.q).map(|(a, b)| wrapped(a - b).abs()).fold(0.0, f64::max);
        cells.push(rough(off));
        table.row("isolated", cells);
    }
    page.table(&table);
    let target = position([0.5, 0.5, -0.5]);
    let configurations: Vec<(Vec<f64>, String)> =
        all.iter().map(|(_, q)| (q.to_vec(), named("q", q))).collect();
    let view = View::from(-61.0, 14.0);
    let drawings = side_by_side(model, "m", view, 240.0, &configurations, target, "One of four solutions");
    page.figure("figure-solutions", &drawings, "The four solutions, the target ringed.");
    let over: Vec<Vec<f64>> = configurations.iter().map(|(q, _)| q.clone()).collect();
    page.figure(
        "figure-overlaid",
        &[(
            overlaid(model, "m", view, &over, target).draw(380.0, "Four solutions over one another"),
            String::new(),
        )],
        "The same over one another.",
    );
}

fn workspace(page: &mut Page, model: &Model) {
    page.section("workspace", "Workspace");
    let ways = |rho: f64, z: f64| LabRrr.ik_position(&Point3::new(rho, 0.0, z)).len();
    let section = Section::of(model, "m", &ways);
    page.figure(
        "figure-workspace",
        &[(section.draw(360.0, "Cross-section of the workspace of the tool point"), String::new())],
        "Where the tool point can be, cut through axis 1; the curves are where the factors of det J vanish. Both links are \
         equally long, so that the arm, folded, reaches its own shoulder and there is no void.",
    );
}
