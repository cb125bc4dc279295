//! Jacobians against 50-digit ones and dual numbers, on all arms of the reference.

use kin_gen::eval::{Inputs, eval};
use tests::reference::{Forward, Record};
use tests::sample::Sampler;
use tests::{declared, dh, product, reference};

/// The file has 15 digits. Linear rows are relative to the reach, angular ones as they are.
const TOLERANCE: f64 = 1e-14;

/// The largest difference, linear rows divided by the reach.
fn difference(arm: &Record, columns: &[[f64; 6]], entry: impl Fn(usize, usize) -> f64) -> f64 {
    assert_eq!(columns.len(), arm.dof);
    let mut worst = 0.0_f64;
    for (c, column) in columns.iter().enumerate() {
        for (r, value) in column.iter().enumerate() {
            let off = (value - entry(r, c)).abs() / if r < 3 { arm.reach() } else { 1.0 };
            assert!(off.is_finite(), "{}", arm.name);
            worst = worst.max(off);
        }
    }
    worst
}

fn against_file(arm: &Record, jacobian: impl Fn(&[f64]) -> Vec<[f64; 6]>) {
    let off = |case: &Forward| difference(arm, &jacobian(&case.q), |r, c| case.jacobian[r][c]);
    let worst = arm.cases().fk.iter().map(off).fold(0.0, f64::max);
    assert!(worst <= TOLERANCE, "{}: {worst:e}", arm.name);
}

#[test]
fn generated_code_agrees_with_fifty_digits() {
    for arm in declared::all() {
        against_file(&arm.record(), arm.jacobian);
        against_file(&arm.record(), |q| (arm.fk_jacobian)(q).1);
    }
}

#[test]
fn interpreted_programs_agree_with_fifty_digits() {
    for arm in reference::arms() {
        let derived = kin_gen::compile_text(&dh::text(&arm)).unwrap_or_else(|e| panic!("{}: {e}", arm.name));
        let columns = |r: &[f64]| r.as_chunks().0.to_vec();
        against_file(&arm, |q| {
            columns(&eval(&derived.forward.jacobian, Inputs { joints: q, ..Inputs::default() }))
        });
        against_file(&arm, |q| {
            columns(&eval(&derived.forward.fk_jacobian, Inputs { joints: q, ..Inputs::default() })[12..])
        });
    }
}

#[test]
fn dual_numbers_agree() {
    let mut sampler = Sampler::new(3);
    for arm in declared::all() {
        let record = arm.record();
        for _ in 0..50 {
            let q: Vec<f64> = (0..record.dof).map(|_| sampler.between(-3.0, 3.0)).collect();
            let dual = product::jacobian(&record, &q);
            // A slide of up to 3 m makes the arm longer than its rows.
            let off = difference(&record, &(arm.jacobian)(&q), |r, c| dual[c][r]);
            assert!(off <= 2.0 * TOLERANCE, "{}: {off:e}", arm.name);
        }
    }
}

#[test]
fn together_and_apart_are_the_same() {
    let mut sampler = Sampler::new(4);
    for arm in declared::all() {
        let record = arm.record();
        for _ in 0..20 {
            let q: Vec<f64> = (0..record.dof).map(|_| sampler.between(-3.0, 3.0)).collect();
            let (pose, together) = (arm.fk_jacobian)(&q);
            let apart = (arm.jacobian)(&q);
            assert!(difference(&record, &together, |r, c| apart[c][r]) <= TOLERANCE, "{}", arm.name);
            let off = tests::pose::difference(&pose, &(arm.fk)(&q)).relative(record.reach());
            assert!(off <= TOLERANCE, "{}: {off:e}", arm.name);
        }
    }
}
