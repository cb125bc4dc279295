//! What the pages set as mathematics, read back and computed: programs against the interpreter, formulas against the
//! plain product of matrices.

use std::collections::BTreeMap;

use kin_gen::algebra::ring::{Poly, Ring, Var};
use kin_gen::back::{listing, mathml};
use kin_gen::eval::{Inputs, eval};
use kin_gen::model::Arm;
use kin_gen::program::Program;
use kin_gen::textbook::{self, Formulas, Textbook};
use nalgebra::{Matrix3, Matrix6};
use tests::markup::{Values, read};
use tests::sample::Sampler;

/// The value of a constant of the ring, by the name that is shown.
fn constant(ring: &Ring, shown: &str) -> Option<f64> {
    let vars = (0..128).map(Var).take_while(|var| !ring.name(*var).is_empty());
    let var = vars.into_iter().find(|var| read(&mathml::name(ring.name(*var))).text() == shown)?;
    Some(ring.value(&ring.var(var)).to_f64())
}

/// Random inputs, by the names under which formulas know them.
fn inputs(sampler: &mut Sampler, arm: &Arm) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let joints = (0..arm.joints.len()).map(|_| sampler.between(-3.0, 3.0)).collect();
    let params = arm.params.iter().map(|p| p.nominal + sampler.between(-0.1, 0.1)).collect();
    (joints, params, (0..12).map(|_| sampler.between(-1.0, 1.0)).collect())
}

fn program_means_what_it_computes(sampler: &mut Sampler, arm: &Arm, program: &Program) {
    let (joints, params, entries) = inputs(sampler, arm);
    let mut known = BTreeMap::new();
    known.extend(joints.iter().enumerate().map(|(i, x)| (format!("q{}", i + 1), *x)));
    known.extend(arm.params.iter().zip(&params).map(|(p, x)| (read(&mathml::name(&p.name)).text(), *x)));
    known.extend(entries.iter().enumerate().map(|(i, x)| (kin_gen::truth::entry_name(i), *x)));
    let other = |name: &str| constant(&arm.ring, name);
    let mut values = Values { known, other: &other };
    values.equations(&read(&mathml::program(arm, program)));
    let expected = eval(program, Inputs { joints: &joints, params: &params, entries: &entries });
    for (output, expected) in program.outputs.iter().zip(expected) {
        let shown = read(&mathml::name(&output.name)).text();
        let found = values.known.get(&shown).unwrap_or_else(|| panic!("{}: no {shown}", arm.name));
        let scale = 1.0 + expected.abs() + arm.reach.as_f64().unwrap_or(1.0);
        assert!(
            (found - expected).abs() <= 1e-13 * scale,
            "{} {}: {found} {expected}",
            arm.name,
            output.name
        );
    }
}

#[test]
fn printed_programs_mean_what_the_interpreter_says() {
    let mut sampler = Sampler::new(31);
    let golden = include_str!("../golden/every_statement.dh");
    for table in robots::ALL.iter().map(|arm| arm.table()).chain([golden]) {
        let arm = kin_gen::compile_text(table).unwrap_or_else(|messages| panic!("{messages}"));
        for program in listing::programs(&arm) {
            program_means_what_it_computes(&mut sampler, &arm, program);
        }
    }
}

/// The value of a printed polynomial at joint values, in whichever angles it is written.
fn value(formulas: &Formulas, poly: &Poly, q: &[f64]) -> f64 {
    let mut known = BTreeMap::new();
    for (suffix, sum) in &formulas.angles {
        let angle: f64 = sum.iter().map(|(sign, joint)| *sign as f64 * q[*joint]).sum();
        known.insert(format!("c{suffix}"), angle.cos());
        known.insert(format!("s{suffix}"), angle.sin());
    }
    known.extend(q.iter().enumerate().map(|(i, x)| (format!("q{}", i + 1), *x)));
    let other = |name: &str| constant(&formulas.ring, name);
    Values { known, other: &other }.value(&read(&mathml::inline(&mathml::poly(&formulas.ring, poly))))
}

/// The formulas of an arm without parameters and coupling.
fn formulas(table: &str) -> (Arm, Textbook) {
    let chain = kin_gen::check_text(table).unwrap_or_else(|messages| panic!("{messages}"));
    let arm = kin_gen::model::derive(&chain).unwrap_or_else(|mismatch| panic!("{mismatch}"));
    let textbook = textbook::of(&chain, &arm).unwrap_or_else(|| panic!("{}: too large", chain.name));
    (arm, textbook)
}

#[test]
fn textbook_formulas_are_the_plain_product() {
    let mut sampler = Sampler::new(32);
    for table in robots::ALL.iter().map(|arm| arm.table()) {
        let (arm, book) = formulas(table);
        let reach = arm.reach.as_f64().expect("constant lengths");
        for _ in 0..4 {
            let q: Vec<f64> = arm.joints.iter().map(|_| sampler.between(-3.0, 3.0)).collect();
            let expected = arm.eval_fk(&q);
            for formulas in [&book.own, &book.fused] {
                for (i, expected) in expected.iter().enumerate() {
                    for (j, expected) in expected.iter().enumerate() {
                        let poly =
                            if j < 3 { &formulas.tip.rotation[i][j] } else { &formulas.tip.position[i] };
                        let found = value(formulas, poly, &q);
                        assert!((found - expected).abs() < 1e-12 * (1.0 + reach), "{} {i}{j}", arm.name);
                    }
                }
            }
            for (column, expected) in book.jacobian.iter().zip(arm.eval_jacobian(&q)) {
                for (poly, expected) in column.iter().zip(expected) {
                    let found = value(&book.fused, poly, &q);
                    assert!((found - expected).abs() < 1e-12 * (1.0 + reach), "{}", arm.name);
                }
            }
        }
    }
}

#[test]
fn factors_of_the_determinant_multiply_to_it() {
    let mut sampler = Sampler::new(33);
    let mut factored = 0;
    for table in robots::ALL.iter().map(|arm| arm.table()) {
        let (arm, book) = formulas(table);
        // A spherical wrist behind three joints, or three joints alone.
        let wanted = book.fused.wrist_centre.is_some() || arm.joints.len() == 3;
        assert_eq!(book.determinant.is_some(), wanted, "{}", arm.name);
        let Some(determinant) = &book.determinant else { continue };
        factored += 1;
        let reach = arm.reach.as_f64().expect("constant lengths");
        for _ in 0..20 {
            let q: Vec<f64> = arm.joints.iter().map(|_| sampler.between(-3.0, 3.0)).collect();
            let columns = arm.eval_jacobian(&q);
            let expected = match columns.as_slice() {
                [a, b, c] => Matrix3::from_fn(|i, j| [a, b, c][j][i]).determinant(),
                columns => Matrix6::from_fn(|i, j| columns[j][i]).determinant(),
            };
            let product = determinant.factors.iter().map(|factor| {
                let formulas = if factor.fused { &book.fused } else { &book.own };
                value(formulas, &factor.poly, &q)
            });
            let found = value(&book.fused, &determinant.coefficient, &q) * product.product::<f64>();
            assert!((found - expected).abs() < 1e-12 * reach.powi(3), "{} {found} {expected}", arm.name);
        }
    }
    assert!(factored >= 21, "{factored}");
}

/// The factors of the lab arm's determinant are those that its singularities are known by.
#[test]
fn the_lab_arm_is_singular_where_its_factors_vanish() {
    let (_, book) = formulas(<robots::LabArm as kin_runtime::Arm<6>>::TABLE);
    let determinant = book.determinant.expect("a spherical wrist");
    let shown: Vec<String> = determinant
        .factors
        .iter()
        .map(|f| if f.fused { &book.fused.ring } else { &book.own.ring }.show(&f.poly).to_string())
        .collect();
    assert_eq!(book.fused.ring.show(&determinant.coefficient).to_string(), "a2");
    assert_eq!(shown, ["a2·c2 - d5·c23 - a4·s23 - a1", "a4·c3 - d5·s3", "s5"]);
}
