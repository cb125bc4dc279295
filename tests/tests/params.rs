//! Arms with parameters: fields of the struct, the same kinematics as if their values had been written in the table,
//! and the same solver for every value.

use std::f64::consts::PI;

use kin_runtime::prelude::*;
use nalgebra::{Rotation3, Vector3};
use tests::sample::Sampler;

dh! {
    /// Every length and two angles are open.
    pub struct Open(standard, m, deg);

    param d1 = 0.3; param a1 = 0.1; param a2 = 0.45; param a3 = 0.05; param d4 = 0.4; param d6 = 0.08;
    param home2 = 90deg; param home5 = 0deg; param tcp = 0.12;

    | joint | theta     | d  | a  | alpha |
    |-------|-----------|----|----|-------|
    | J1    | q         | d1 | a1 | -90   |
    | J2    | q + home2 | 0  | a2 | 0     |
    | J3    | q         | 0  | a3 | 90    |
    | J4    | q         | d4 | 0  | -90   |
    | J5    | q + home5 | 0  | 0  | 90    |
    | J6    | q         | d6 | 0  | 0     |

    tool: Tz(tcp);
}

dh! {
    /// The same arm with its nominal values written out.
    pub struct Closed(standard, m, deg);

    | joint | theta  | d    | a    | alpha |
    |-------|--------|------|------|-------|
    | J1    | q      | 0.3  | 0.1  | -90   |
    | J2    | q + 90 | 0    | 0.45 | 0     |
    | J3    | q      | 0    | 0.05 | 90    |
    | J4    | q      | 0.4  | 0    | -90   |
    | J5    | q      | 0    | 0    | 90    |
    | J6    | q      | 0.08 | 0    | 0     |

    tool: Tz(0.12);
}

dh! {
    /// Where an arm stands and what it holds is open, and one drive reaches across the base.
    pub struct Mounted(standard, m, deg);

    param lean = 10deg; param hold = 25deg; param flange = 0.05;

    | joint | theta | d       | a      | alpha |
    |-------|-------|---------|--------|-------|
    | J1    | q     | 0.6     | 0      | 90    |
    | J2    | q     | 0       | 0.4318 | 0     |
    | J3    | q     | 0.15005 | 0.0203 | -90   |
    | J4    | q     | 0.4318  | 0      | 90    |
    | J5    | q     | 0       | 0      | -90   |
    | J6    | q     | 0.1     | 0      | 0     |
    |       | hold  | flange  | 0.02   | 0     |

    base: Rx(lean) Tz(1);
    tool: Ry(90) Tz(0.1);
    couple: J4 += J1, J6 -= J5;
}

dh! {
    /// Homes of joints that stand at exactly half a turn where the arm is in a plane.
    pub struct Zeroed(standard, m, deg);

    param home1 = 0deg; param home4 = 0deg; param home6 = 0deg;

    | joint | theta     | d    | a    | alpha |
    |-------|-----------|------|------|-------|
    | J1    | q + home1 | 0.3  | 0.1  | -90   |
    | J2    | q         | 0    | 0.45 | 0     |
    | J3    | q         | 0    | 0.05 | 90    |
    | J4    | q + home4 | 0.4  | 0    | -90   |
    | J5    | q         | 0    | 0    | 90    |
    | J6    | q + home6 | 0.08 | 0    | 0     |
}

#[test]
fn homes_of_next_to_nothing_leave_angles_in_their_range() {
    let mut random = Sampler::new(14);
    let mut half_turns = 0;
    for home in [0.0, 1e-17, 5.5e-17, 2.2e-16, 4.4e-16, 6e-16, 1e-13] {
        for home in [home, -home] {
            let arm = Zeroed { home1: home, home4: home, home6: home };
            for _ in 0..100 {
                let [x, z] = [random.between(-0.7, 0.7), random.between(0.0, 0.9)];
                let turned = Rotation3::from_axis_angle(&Vector3::y_axis(), random.between(-3.0, 3.0));
                for solution in arm.ik(&Pose::from_parts(Vector3::new(x, 0.0, z).into(), turned)).iter() {
                    let angles = || solution.q.iter();
                    assert!(angles().all(|angle| (-PI < *angle) & (*angle <= PI)), "{home} {}", solution.q);
                    half_turns += angles().filter(|angle| **angle == PI).count();
                }
            }
        }
    }
    assert!(half_turns > 1000, "{half_turns} angles at the end of the range");
}

#[test]
fn angles_of_base_tool_and_flange_may_be_open() {
    let mut random = Sampler::new(13);
    for _ in 0..200 {
        let arm = Mounted {
            lean: random.between(-3.0, 3.0),
            hold: random.between(-3.0, 3.0),
            flange: random.between(-0.2, 0.2),
        };
        comes_back(&arm, &Joints::from(random.angles::<6>()));
    }
}

/// The joints are among the solutions of their pose, and each solution reaches it.
fn comes_back<A: InverseKinematics<6> + std::fmt::Debug>(arm: &A, q: &Joints<f64, 6>) {
    let pose = arm.fk(q);
    let solutions = arm.ik(&pose);
    let near = |s: &Joints<f64, 6>| {
        (0..6).all(|i| ((s[i] - q[i] + 3.0).rem_euclid(std::f64::consts::TAU) - 3.0).abs() < 1e-6)
    };
    assert!(solutions.iter().any(|s| near(&s.q)), "{arm:?} {q}\n{solutions}");
    for solution in solutions.iter() {
        assert!(miss(&arm.fk(&solution.q), &pose) < 1e-14);
    }
}

/// The largest entry of the difference.
fn miss(a: &Pose<f64>, b: &Pose<f64>) -> f64 {
    let rotation = (a.rotation.matrix() - b.rotation.matrix()).amax();
    rotation.max((a.translation.vector - b.translation.vector).amax())
}

#[test]
fn nominal_values_make_the_closed_arm() {
    assert_eq!(Open::default(), Open::NOMINAL);
    assert_eq!(Open::NOMINAL.a2, 0.45);
    assert_eq!(Open::NOMINAL.home2, std::f64::consts::FRAC_PI_2);
    assert!((Open::NOMINAL.reach() - Closed.reach()).abs() < 1e-15);
    let mut random = Sampler::new(11);
    for _ in 0..200 {
        let q = Joints::from(random.angles::<6>());
        let (open, closed) = (Open::NOMINAL.fk(&q), Closed.fk(&q));
        assert!(miss(&open, &closed) < 4e-15, "{:e}", miss(&open, &closed));
        let difference = Open::NOMINAL.jacobian(&q) - Closed.jacobian(&q);
        assert!(difference.amax() < 4e-15);
        let (open, closed) = (Open::NOMINAL.ik(&open), Closed.ik(&closed));
        for (a, b) in open.iter().zip(closed.iter()) {
            assert_eq!(a.branch, b.branch);
            assert!((a.q - b.q).amax() < 1e-9, "{} {}", a.q, b.q);
        }
        assert_eq!(open.len(), closed.len());
    }
}

#[test]
fn every_value_of_the_parameters_has_its_inverse() {
    let mut random = Sampler::new(12);
    for _ in 0..300 {
        let arm = Open {
            d1: random.between(-0.5, 0.5),
            a1: random.between(-0.3, 0.3),
            a2: random.between(-0.6, 0.6),
            a3: random.between(-0.2, 0.2),
            d4: random.between(0.1, 0.6),
            d6: random.between(-0.1, 0.2),
            home2: random.between(-3.0, 3.0),
            home5: random.between(-3.0, 3.0),
            tcp: random.between(-0.2, 0.2),
        };
        comes_back(&arm, &Joints::from(random.angles::<6>()));
    }
}

#[test]
fn links_that_a_value_makes_vanish_do_not_end_in_nonsense() {
    let arm = Open { a2: 0.0, a3: 0.0, d4: 0.0, ..Open::NOMINAL };
    let pose = arm.fk(&joints![0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    for solution in arm.ik(&pose).iter() {
        assert!(solution.q.iter().all(|x: &f64| x.is_finite()));
        assert!(miss(&arm.fk(&solution.q), &pose) < 1e-13);
    }
}
