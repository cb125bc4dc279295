//! Velocity and force: round trips where the arm is regular, bounded rates where it is not, virtual work, rates of the Jacobian.

use kin_runtime::dexterity;
use kin_runtime::prelude::*;
use kin_runtime::rates::{
    Damping, RateError, Twist, Wrench, acceleration, jacobian_rate, position_rates, rates, torques, twist,
};
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use nalgebra::Vector3;
use tests::sample::Sampler;

fn vector<const N: usize>(random: &mut Sampler) -> Joints<f64, N> {
    Joints::from_fn(|_, _| random.between(-1.0, 1.0))
}

/// Linear entries in reaches.
fn parts(twist: &Twist<f64>, reach: f64) -> Twist<f64> {
    Twist::from_fn(|i, _| if i < 3 { twist[i] / reach } else { twist[i] })
}

fn back<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) {
    let (reach, mut exact) = (arm.reach(), 0);
    for _ in 0..300 {
        let (q, moved) = (vector(random) * 3.0, vector::<N>(random));
        let asked = twist(arm, &q, &moved);
        let found = rates(arm, &q, &asked, &Damping::default()).expect("finite numbers");
        let missed = parts(&(asked - arm.jacobian(&q) * found.velocity), reach).amax();
        assert!((missed - found.missed).abs() < 1e-13, "{}: {missed} {found:?}", A::NAME);
        let margin = dexterity(arm, &q).margin;
        assert!((found.margin - margin).abs() < 1e-14);
        if margin >= 0.01 {
            exact += 1;
            assert!(found.damping == 0.0 && found.missed < 1e-14, "{}: {found:?}", A::NAME);
            if N == 6 {
                let slack = 1e-14 / margin * reach.max(1.0);
                assert!((found.velocity - moved).amax() < slack, "{}: {found:?} {moved}", A::NAME);
            } else {
                // Of all that give this twist none is shorter.
                assert!(found.velocity.norm() <= moved.norm() * (1.0 + 1e-12));
            }
        } else {
            assert!(found.damping > 0.0 && found.damping <= 0.005 + 1e-15);
        }
    }
    assert!(exact > 100, "{} {exact}", A::NAME);
}

#[test]
fn rates_come_back_where_the_arm_is_regular() {
    let mut random = Sampler::new(91);
    back(&robots::Puma560, &mut random);
    back(&robots::LabArm, &mut random);
    back(&robots::ElbowWrist, &mut random);
    back(&robots::Stanford, &mut random);
    back(&robots::Ur5, &mut random);
    back(&robots::Panda, &mut random);
}

#[test]
fn near_a_singular_pose_rates_are_bounded_and_say_so() {
    let (arm, damping, mut random) = (robots::Puma560, Damping::default(), Sampler::new(92));
    for _ in 0..if cfg!(debug_assertions) { 10 } else { 100 } {
        let mut q = vector(&mut random) * 3.0;
        let asked = Twist::from_fn(|_, _| random.between(-1.0, 1.0));
        let size = parts(&asked, arm.reach()).norm();
        let (mut before, mut widest) = (None, 0.0_f64);
        for k in 0..=2000 {
            q[4] = 0.2 - 1e-4 * f64::from(k);
            let found = rates(&arm, &q, &asked, &damping).expect("finite numbers");
            // Regular directions give 1/0.01 at most, damped ones 1/(2·λ), or less than 1/0.01 between: σ/(σ² + λ²).
            assert!(found.velocity.norm() <= size * 1.01 / damping.most, "{found:?}");
            if let Some(before) = before.replace(found.velocity) {
                widest = widest.max((found.velocity - before).norm() / size);
            }
        }
        // No jump where damping sets in, nor where it is full: a slope of at most 1/λ² times the change of σ, which is below 2e-4.
        assert!(widest < 2e-4 / (damping.most * damping.most), "{widest}");
        // q5 is 0 now. A twist that the arm can make there is made, exactly, in spite of the damping.
        q[4] = 0.0;
        let made = twist(&arm, &q, &vector(&mut random));
        let found = rates(&arm, &q, &made, &damping).expect("finite numbers");
        assert!((found.damping - damping.most).abs() < 1e-12 || found.margin > 1e-12, "{found:?}");
        if dexterity(&arm, &q).singular_values[4] >= 0.01 {
            assert!(found.missed < 1e-13 && found.margin < 1e-15, "{found:?}");
            assert!(
                matches!(rates(&arm, &q, &made, &Damping::none()), Err(RateError::Singular { margin }) if margin < 1e-15)
            );
            let lost = rates(&arm, &q, &asked, &damping).expect("finite numbers");
            assert!(lost.missed > 1e-6, "{lost:?}");
        }
        q[4] = 1e-6;
        assert!(rates(&arm, &q, &asked, &Damping::none()).is_ok_and(|found| found.damping == 0.0));
    }
}

#[test]
fn torques_do_the_work_of_the_wrench() {
    let mut random = Sampler::new(93);
    for _ in 0..300 {
        let (q, moved) = (vector(&mut random) * 3.0, vector(&mut random));
        let wrench = Wrench::from_fn(|_, _| random.between(-10.0, 10.0));
        let (held, moving) = (torques(&robots::Stanford, &q, &wrench), twist(&robots::Stanford, &q, &moved));
        let scale = held.norm() * moved.norm() + wrench.norm() * moving.norm();
        assert!((held.dot(&moved) - wrench.dot(&moving)).abs() < 1e-14 * scale);
    }
    // The arm of seed 004, stretched level: 20 N down at 2l = 0.2667 m from axis 2, at l from axis 3.
    let held =
        torques(&robots::LabRrr, &joints![0.0, 0.0, 0.0], &Wrench::from([0.0, 0.0, -20.0, 0.0, 0.0, 0.0]));
    assert!((held - joints![0.0, -20.0 * 0.2667, -20.0 * 0.13335]).amax() < 1e-14, "{held}");
}

fn jacobian_moves<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) {
    let reach = arm.reach();
    for _ in 0..100 {
        let (q, velocity) = (vector(random) * 3.0, vector::<N>(random));
        let h = 1e-6;
        let difference = (arm.jacobian(&(q + velocity * h)) - arm.jacobian(&(q - velocity * h))) / (2.0 * h);
        let found = jacobian_rate(arm, &q, &velocity);
        assert!((found - difference).amax() < 1e-8 * reach.max(1.0), "{}", A::NAME);
        let push = vector(random);
        let known = arm.jacobian(&q) * push + found * velocity;
        assert!((acceleration(arm, &q, &velocity, &push) - known).amax() < 1e-13 * reach.max(1.0));
    }
}

#[test]
fn the_jacobian_changes_as_differences_say() {
    let mut random = Sampler::new(94);
    jacobian_moves(&robots::Puma560, &mut random);
    jacobian_moves(&robots::Stanford, &mut random);
    jacobian_moves(&robots::Panda, &mut random);
    jacobian_moves(&robots::LabRrr, &mut random);
    // The acceleration of the tool point along a trajectory, from positions alone.
    let limits = RateLimits::uniform(1.0, 2.0);
    let ends = [joints![0.3, -0.8, 0.6, 0.4, 0.5, 0.2], joints![1.0, -0.1, 0.1, 0.9, -0.5, -1.2]];
    let trajectory = Trajectory::new(&ends[0], &ends[1], &limits, Shared::Phases).expect("sound");
    let place = |t: f64| robots::Puma560.fk(&trajectory.at(t).q).translation.vector;
    let (t, h) = (0.2 * trajectory.duration(), 1e-4);
    let state = trajectory.at(t);
    let found = acceleration(&robots::Puma560, &state.q, &state.velocity, &state.acceleration);
    let difference = (place(t + h) - place(t) * 2.0 + place(t - h)) / (h * h);
    assert!((found.fixed_rows::<3>(0) - difference).norm() < 1e-6, "{found} {difference}");
}

#[test]
fn a_position_alone_is_enough_for_three_joints() {
    let mut random = Sampler::new(95);
    for _ in 0..300 {
        let q = vector(&mut random) * 3.0;
        let moved = vector(&mut random);
        let asked: Vector3<f64> = twist(&robots::LabRrr, &q, &moved).fixed_rows::<3>(0).into();
        let found = position_rates(&robots::LabRrr, &q, &asked, &Damping::default()).expect("finite numbers");
        if found.damping == 0.0 {
            assert!((found.velocity - moved).amax() < 1e-12 && found.missed < 1e-15, "{found:?}");
        }
    }
}

#[test]
fn every_bit_pattern_has_a_typed_answer() {
    let mut random = Sampler::new(96);
    let mut refused = 0;
    for _ in 0..20_000 {
        let mut wild = || match random.below(3) {
            0 => f64::from_bits(random.bits()),
            _ => random.between(-3.0, 3.0),
        };
        let (q, asked) = (Joints::<f64, 6>::from_fn(|_, _| wild()), Twist::from_fn(|_, _| wild()));
        match rates(&robots::Puma560, &q, &asked, &Damping::default()) {
            Ok(found) => assert!(found.velocity.iter().all(|x| !x.is_nan()) && !found.missed.is_nan()),
            Err(_) => refused += 1,
        }
    }
    assert!(refused > 0);
}
