//! The derivation of an arm, set from its algebra: nothing in it is typed by hand.

use kin_gen::algebra::ring::{Poly, Ring};
use kin_gen::algebra::vector::V3;
use kin_gen::back::mathml;
use kin_gen::model::Solver;
use kin_gen::textbook::{Formulas, Frame};

use crate::html::Page;
use crate::model::Model;

/// A letter with its frames: ⁰T₆.
pub fn between(letter: &str, from: &str, to: &str) -> String {
    format!(
        "<mmultiscripts><mi>{letter}</mi><mn>{to}</mn><none></none><mprescripts></mprescripts><none></none><mn>{from}</mn>\
         </mmultiscripts>"
    )
}

fn equals() -> String {
    mathml::operator("=")
}

fn column(ring: &Ring, vector: &V3<Poly>) -> String {
    let cells: Vec<Vec<String>> = vector.iter().map(|p| vec![mathml::poly(ring, p)]).collect();
    mathml::matrix(&cells)
}

/// A pose as its 4×4 matrix.
fn homogeneous(ring: &Ring, frame: &Frame) -> String {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for (row, p) in frame.rotation.iter().zip(&frame.position) {
        rows.push(row.iter().chain([p]).map(|p| mathml::poly(ring, p)).collect());
    }
    rows.push(["0", "0", "0", "1"].map(|digit| format!("<mn>{digit}</mn>")).to_vec());
    mathml::matrix(&rows)
}

/// `c₂₃ = cos(θ₂ + θ₃)` for each sum of angles.
fn angles(formulas: &Formulas) -> String {
    let sums = formulas.angles.iter().filter(|(_, sum)| sum.len() > 1).map(|(suffix, sum)| {
        let terms = sum.iter().enumerate().map(|(k, (sign, joint))| {
            let sign = if *sign < 0 {
                "<mo>−</mo>"
            } else if k > 0 {
                "<mo>+</mo>"
            } else {
                ""
            };
            format!("{sign}{}", mathml::name(&format!("theta{}", joint + 1)))
        });
        let sum: String = terms.collect();
        let cosine = mathml::name(&format!("c{suffix}"));
        mathml::inline(&format!("{cosine}{}<mi>cos</mi><mo>(</mo>{sum}<mo>)</mo>", equals()))
    });
    sums.collect::<Vec<_>>().join(", ")
}

/// The whole section.
pub fn derivation(page: &mut Page, model: &Model) {
    page.section("derivation", "Derivation");
    let sums = angles(&model.textbook.fused);
    page.text(&format!(
        "Every formula of this section is printed by the program from the exact polynomials that it also proves the \
         compiled code against. c<sub>i</sub> and s<sub>i</sub> are cosine and sine of θ<sub>i</sub>{}{sums}.",
        if sums.is_empty() { "" } else { "; joints with parallel axes are summed before a sine is taken, " }
    ));
    links(page, model);
    pose(page, model);
    axes(page, model);
    determinant(page, model);
    wrist(page, model);
}

fn links(page: &mut Page, model: &Model) {
    page.part("Link matrices");
    let book = &model.textbook;
    let mut all = Vec::new();
    for (index, link) in book.links.iter().enumerate() {
        let name = match model.arm.joints.get(index) {
            Some(_) => between("T", &index.to_string(), &(index + 1).to_string()),
            None => between("T", &index.to_string(), "tool"),
        };
        let matrix = homogeneous(&book.own.ring, link);
        all.push((format!("link {}", index + 1), mathml::block(&format!("{name}{}{matrix}", equals()))));
    }
    page.formulas(&all);
}

fn pose(page: &mut Page, model: &Model) {
    let (count, formulas) = (model.arm.joints.len(), &model.textbook.fused);
    page.part(&format!("Forward kinematics: <sup>0</sup>T<sub>{count}</sub>"));
    let mut lines = Vec::new();
    for (i, row) in formulas.tip.rotation.iter().enumerate() {
        for (j, poly) in row.iter().enumerate() {
            lines.push((format!("r{}{}", i + 1, j + 1), poly));
        }
    }
    for (name, poly) in ["x", "y", "z"].into_iter().zip(&formulas.tip.position) {
        lines.push((format!("p_{name}"), poly));
    }
    let lines: Vec<_> =
        lines.iter().map(|(name, poly)| (mathml::name(name), mathml::poly(&formulas.ring, poly))).collect();
    page.formula("forward", &mathml::equations(&lines));
}

fn axes(page: &mut Page, model: &Model) {
    let formulas = &model.textbook.fused;
    page.part("Axes and Jacobian");
    page.text(
        "z<sub>i</sub> is the direction of axis i and o<sub>i</sub> a point on it, both in the base frame; a column of the \
         Jacobian at the tool point p is the velocity z<sub>i</sub> × (p − o<sub>i</sub>), then z<sub>i</sub> itself.",
    );
    let mut axes = Vec::new();
    for (index, axis) in formulas.axes.iter().enumerate() {
        let (z, o) = (column(&formulas.ring, &axis.direction), column(&formulas.ring, &axis.point));
        let name = |letter: &str| mathml::name(&format!("{letter}{}", index + 1));
        let text = format!("{}{e}{z}<mo>,</mo>{}{e}{o}", name("z"), name("o"), e = equals());
        axes.push((format!("axis {}", index + 1), mathml::block(&text)));
    }
    page.formulas(&axes);
    let mut columns = Vec::new();
    for (j, entries) in model.textbook.jacobian.iter().enumerate() {
        let cells: Vec<Vec<String>> = entries.iter().map(|p| vec![mathml::poly(&formulas.ring, p)]).collect();
        let text = format!("{}{}{}", mathml::name(&format!("J{}", j + 1)), equals(), mathml::matrix(&cells));
        columns.push((format!("jacobian {}", j + 1), mathml::block(&text)));
    }
    let cost = model.arm.forward.jacobian.cost();
    page.text(&format!(
        "Multiplied out, the columns are these; the compiled code computes all of them with {cost}."
    ));
    page.formulas(&columns);
}

fn determinant(page: &mut Page, model: &Model) {
    let book = &model.textbook;
    let Some(determinant) = &book.determinant else { return };
    page.part("Where the arm is singular: the factors of det J");
    let ring_of = |fused: bool| if fused { &book.fused.ring } else { &book.own.ring };
    let mut factors = Vec::new();
    let negative = determinant.coefficient.leads_negative();
    let coefficient = if negative { determinant.coefficient.neg() } else { determinant.coefficient.clone() };
    if coefficient != Poly::integer(1) {
        factors.push(mathml::factor(&book.fused.ring, &coefficient));
    }
    factors.extend(determinant.factors.iter().map(|f| mathml::factor(ring_of(f.fused), &f.poly)));
    let sign = if negative { mathml::operator("−") } else { String::new() };
    let product = mathml::product(&factors);
    let text = format!("<mi>det</mi><mo>&#x2061;</mo><mi>J</mi>{}{sign}{product}", equals());
    page.formula("determinant", &mathml::block(&text));
    page.text(match book.fused.wrist_centre {
        Some(_) => {
            "The determinant does not depend on the point whose velocity is meant. At the wrist centre it falls into the \
             determinants of two 3×3 blocks, each expanded by its sparse rows; every factor that is zero is one kind of \
             singular pose."
        }
        None => {
            "Of the linear rows, seen from the frame in which they are sparse; every factor that is zero is one kind of \
             singular position."
        }
    });
}

fn wrist(page: &mut Page, model: &Model) {
    let Solver::Pose(solver) = &model.arm.solver else { return };
    page.part("The wrist: centre and <sup>3</sup>R<sub>6</sub>");
    let formulas = &model.textbook.fused;
    if let Some(centre) = &formulas.wrist_centre {
        let text = format!("<mi>w</mi>{}{}", equals(), column(&formulas.ring, centre));
        page.formula("wrist centre", &mathml::block(&text));
    }
    let rows: Vec<Vec<String>> = solver
        .r36_meaning
        .iter()
        .map(|row| row.iter().map(|p| mathml::poly(&model.arm.ring, p)).collect())
        .collect();
    let text = format!("{}{}{}", between("R", "3", "6"), equals(), mathml::matrix(&rows));
    page.formula("r36", &mathml::block(&text));
}
