//! Forward kinematics against 50-digit poses and plain products, on all arms of the reference.

use kin_gen::eval::{Inputs, eval};
use kin_runtime::prelude::*;
use tests::pose::difference;
use tests::reference::{Matrix4, Record};
use tests::sample::Sampler;
use tests::{declared, dh, product, reference};

/// What the file's poses may differ from ours, relative to the reach; entries of rotations as they are.
const TOLERANCE: f64 = 2e-15;

fn worst(arm: &Record, fk: impl Fn(&[f64]) -> Matrix4) -> f64 {
    let cases = arm.cases().fk;
    assert_eq!(cases.len(), 50, "{}", arm.name);
    cases.iter().map(|case| difference(&fk(&case.q), &case.pose).relative(arm.reach())).fold(0.0, f64::max)
}

#[test]
fn generated_code_agrees_with_fifty_digits() {
    let arms = declared::all();
    assert_eq!(arms.len(), 27);
    for arm in arms {
        let worst = worst(&arm.record(), arm.fk);
        assert!(worst <= TOLERANCE, "{}: {worst:e}", arm.name);
    }
}

#[test]
fn interpreted_programs_agree_with_fifty_digits() {
    let arms = reference::arms();
    assert_eq!(arms.len(), 42);
    for arm in arms {
        let derived = kin_gen::compile_text(&dh::text(&arm)).unwrap_or_else(|e| panic!("{}: {e}", arm.name));
        let worst = worst(&arm, |q| {
            let r = eval(&derived.forward.fk, Inputs { joints: q, ..Inputs::default() });
            [
                [r[0], r[1], r[2], r[9]],
                [r[3], r[4], r[5], r[10]],
                [r[6], r[7], r[8], r[11]],
                [0.0, 0.0, 0.0, 1.0],
            ]
        });
        assert!(worst <= TOLERANCE, "{}: {worst:e}", arm.name);
    }
}

#[test]
fn frames_are_the_partial_products() {
    let mut sampler = Sampler::new(1);
    for arm in declared::all() {
        // A chain counts its frames otherwise: see `frames_of_a_chain`.
        if arm.name == "seed003_lab6dof" {
            continue;
        }
        let record = arm.record();
        for _ in 0..20 {
            let q: Vec<f64> = (0..record.dof).map(|_| sampler.between(-3.0, 3.0)).collect();
            let frames = (arm.frames)(&q);
            let expected = product::frames(&record, &q);
            assert_eq!(frames.len(), expected.len());
            for (frame, expected) in frames.iter().zip(&expected) {
                let off = difference(frame, expected).relative(record.reach() + 3.0);
                assert!(off <= 4e-15, "{}: {off:e}", arm.name);
            }
        }
    }
}

#[test]
fn frames_of_a_chain_stand_before_the_next_joint() {
    use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};
    let q = joints![0.3, -0.8, 0.6, 1.1, -0.7, 0.4];
    let turn = |axis: Vector3<f64>, angle: f64| Rotation3::new(axis * angle);
    let step = |axis, angle, y: f64| {
        IsometryMatrix3::from_parts(Translation3::identity(), turn(axis, angle))
            * Translation3::new(0.0, y, 0.0)
    };
    // Rz(q) Tz(d1)  Rx(q) Ty(d2)  Rx(q) Ty(d3)  Ry(q) Ty(d4)  Rz(q) Ty(d5)  Ry(q)
    let first = Translation3::new(0.0, 0.0, 1.0) * step(Vector3::z(), q[0], 0.0);
    let steps = [
        (Vector3::x(), 3.0),
        (Vector3::x(), 1.0),
        (Vector3::y(), 1.0),
        (Vector3::z(), 1.0),
        (Vector3::y(), 0.0),
    ];
    let mut expected = vec![first];
    for (i, (axis, length)) in steps.into_iter().enumerate() {
        expected.push(expected[i] * step(axis, q[i + 1], length));
    }
    let frames = robots::Anthropomorphic.frames(&q);
    for (frame, expected) in frames.iter().zip(&expected) {
        assert!((frame.to_homogeneous() - expected.to_homogeneous()).amax() < 1e-14);
    }
    // What trails the last joint belongs to its frame, and this arm has no tool.
    let tip = robots::Anthropomorphic.fk(&q);
    assert!((frames[5].to_homogeneous() - tip.to_homogeneous()).amax() < 1e-14);
}

#[test]
fn single_precision_is_as_good_as_its_digits() {
    let mut sampler = Sampler::new(2);
    for _ in 0..200 {
        let q = Joints::from(sampler.angles::<6>());
        let single = robots::Puma560.fk(&q.map(|x| x as f32));
        let double = robots::Puma560.fk(&q.map(|x| f64::from(x as f32)));
        let off = (single.to_homogeneous().map(f64::from) - double.to_homogeneous()).amax();
        assert!(off < 16.0 * f64::from(f32::EPSILON), "{off:e}");
    }
}

#[test]
fn reach_and_limits_are_those_of_the_table() {
    for arm in declared::all() {
        let record = arm.record();
        let kinds = record.kinds();
        let travel = |i: usize| record.limits_of(i).map_or(0.0, |(low, high)| low.abs().max(high.abs()));
        let travels: f64 = (0..record.dof).filter(|&i| kinds[i] == 'P').map(travel).sum();
        assert!(((arm.reach)() - record.reach() - travels).abs() < 1e-14 * record.reach(), "{}", arm.name);
        // The lab arm's limits are this project's: the report has none.
        if arm.name == "seed000_lab6dof" {
            continue;
        }
        for (i, limits) in (arm.limits)().into_iter().enumerate() {
            let close = |a: f64, b: f64| (a - b).abs() <= 4e-16 * a.abs().max(1.0);
            let same = match (limits, record.limits_of(i)) {
                (None, None) => true,
                (Some(ours), Some(theirs)) => close(ours.0, theirs.0) && close(ours.1, theirs.1),
                _ => false,
            };
            assert!(same, "{}: J{}: {limits:?}, {:?}", arm.name, i + 1, record.limits_of(i));
        }
    }
}
