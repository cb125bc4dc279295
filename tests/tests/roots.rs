//! Two ways of a general base that are all but one: each comes back, and up stays up however far a joint slides.

use kin_runtime::math;
use kin_runtime::prelude::*;
use nalgebra::Matrix3;
use tests::invented::{ParallelA, PrpA, PrrA, RrpA};
use tests::sample::Sampler;

/// How far the nearest solution is from these values of joints 1 to 3.
fn off(solutions: &Solutions<f64, 6, Posture>, q: &Joints<f64, 6>) -> f64 {
    let apart =
        |other: &Joints<f64, 6>| (0..3).map(|i| math::wrap(other[i] - q[i]).abs()).fold(0.0, f64::max);
    solutions.iter().map(|solution| apart(&solution.q)).fold(f64::INFINITY, f64::min)
}

/// Where the wrist centre passes axis 2 at some distance, the arm stretched or folded but for a small angle of joint 2, both sides of
/// joint 1 are within the root of round-off of one another; those of joint 2 are not.
#[test]
fn both_sides_of_joint_1_come_back_where_they_all_but_meet() {
    let arm = ParallelA;
    let mut random = Sampler::new(41);
    let mut tried = 0;
    for [mut low, mut high] in [[1.9, 2.1], [2.6, 2.8]] {
        let from_axis = |t3: f64| arm.r03(0.0, 0.0, t3).1.x - 0.5;
        assert!(from_axis(low) * from_axis(high) < 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if from_axis(middle) * from_axis(low) > 0.0 { low = middle } else { high = middle }
        }
        for (distance, angle, side) in (1..7).flat_map(|j| {
            (1..9).flat_map(move |k| [1.0, -1.0].map(|side| (10_f64.powi(-j), 10_f64.powi(-k), side)))
        }) {
            // What the angle takes from the distance to axis 1 must be more than round-off.
            let (t3, length) = (low + distance, from_axis(low + distance).abs());
            if length * angle * angle < 1e-13 {
                continue;
            }
            for straight in [0.0, std::f64::consts::PI] {
                let [q1, q4, q5, q6] = random.angles();
                let q = joints![q1, straight + side * angle, t3, q4, q5, q6];
                let solutions = arm.ik(&arm.fk(&q));
                assert!(off(&solutions, &q) <= 0.1 * angle, "{q}\n{solutions}");
                tried += 1;
            }
        }
    }
    assert_eq!(tried, 192);
}

/// Found by the program `reliability`, beside a singular set of the base: both roots begin on one side of the middle, or both lead to
/// the same one, or round-off has opened them.
#[test]
fn roots_that_steps_led_to_one_come_back() {
    let found = [
        [0xbfc1_93ec_b6a4_5404, 0xc005_6ac6_0744_40fc, 0xc006_040d_25b1_ebcc],
        [0x3fa0_8bea_ce6f_e810, 0x4001_8a79_2483_7e06, 0xc007_a0cf_b63a_7eb8],
        [0x3fe4_e3ad_58e6_7ca6, 0x4008_68ee_51ba_7680, 0x400c_1721_1b4a_36e4],
        [0xbfd8_8b9a_39d1_c4e8, 0x4001_41ca_d7de_f8a4, 0x400a_338e_4fd7_5798],
        [0x3fe1_650b_b4a9_26c2, 0x3ff8_95e0_cdb7_aca8, 0xc001_a826_62de_a236],
        [0xbfd2_0668_0e3f_fb0f, 0x3ff4_4c5b_f06b_01e7, 0xc005_a6f6_4254_c8aa],
        [0xbfe1_882f_39e3_c690, 0xc008_4884_4a10_2b8e, 0x400c_27a5_b5ce_d4f5],
        [0xbfd5_8298_ccbe_54fb, 0xc008_8213_33f1_ab24, 0x400c_257b_68fa_86d9],
        [0xbfc9_fc4f_3133_dc5c, 0xc010_60e7_0a21_e75d, 0xc007_ab98_27fe_a54b],
    ];
    for bits in found {
        let [q1, q2, q3] = bits.map(f64::from_bits);
        let q = joints![q1, q2, q3, 0.3, 0.9, -1.2];
        let solutions = PrrA.ik(&PrrA.fk(&q));
        assert!(off(&solutions, &q) <= 100.0 * f64::EPSILON.sqrt(), "{q}\n{solutions}");
    }
}

/// How joints 1 to 3 move the wrist centre, column by column.
fn motion<A: SphericalWrist<6>>(arm: &A, q: &Joints<f64, 6>) -> Matrix3<f64> {
    let centre = |i: usize, by: f64| {
        let mut at = [q[0], q[1], q[2]];
        at[i] += by;
        arm.r03(at[0], at[1], at[2]).1.coords
    };
    Matrix3::from_columns(&[0, 1, 2].map(|i| (centre(i, 1e-6) - centre(i, -1e-6)) * 5e5))
}

/// A path that slides is seen through two charts, one of them for what is far; it is run through in one direction in both.
#[test]
fn up_is_one_sign_of_the_determinant_however_far_a_joint_slides() {
    fn every<A: InverseKinematics<6, Branch = Posture> + SphericalWrist<6>>(arm: &A, ways: usize) {
        let (mut random, mut far, mut up) = (Sampler::new(43), 0, None);
        for _ in 0..2_000 {
            let angles = random.angles::<6>();
            let q = Joints::from_fn(|i, _| match A::JOINTS[i].kind {
                kin_runtime::JointKind::Prismatic => random.between(-1.5, 1.5),
                kin_runtime::JointKind::Revolute => angles[i],
            });
            let solutions = arm.ik(&arm.fk(&q));
            assert!(solutions.len() <= 2 * ways, "{q}\n{solutions}");
            for solution in solutions.iter() {
                let determinant = motion(arm, &solution.q).determinant();
                if determinant.abs() < 1e-4 {
                    continue;
                }
                far += usize::from(solution.q[2].abs() > arm.reach());
                let is_up = (solution.branch.elbow == Elbow::Up) == (determinant > 0.0);
                assert_eq!(is_up, *up.get_or_insert(is_up), "{q}\n{solutions}");
            }
        }
        assert!(far > 100, "{far}");
    }
    every(&RrpA, 4);
    every(&PrpA, 2);
}
