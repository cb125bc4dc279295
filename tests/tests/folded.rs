//! Short arms folded onto the axes of the joints that carry their point: what the place does not tell of these joints the
//! orientation does, or leaves free, and no pose that is reached comes back empty.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_runtime::prelude::*;
use kin_runtime::{JointKind, dexterity, math};
use tests::invented::{RollRrrrr, ScaraFolding, SlidingRrprr};
use tests::reliability::subject::Bits;
use tests::sample::Sampler;

const POSES: usize = if cfg!(debug_assertions) { 600 } else { 6000 };

dh! {
    /// Folded, its third axis crosses axis 1 where axis 2 does, and is parallel to axis 2.
    struct Waist(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0   | 90    |
    | J2    | q     | 0   | 0.4 | 0     |
    | J3    | q     | 0   | 0.4 | 0     |
    | J4    | q     | 0   | 0.1 | 0     |
    tool: Ry(90);
}

dh! {
    /// The same with a roll.
    struct Roll(standard, m, deg);

    | joint | theta  | d    | a   | alpha |
    |-------|--------|------|-----|-------|
    | J1    | q      | 0.3  | 0   | 90    |
    | J2    | q      | 0    | 0.4 | 0     |
    | J3    | q      | 0    | 0.4 | 0     |
    | J4    | q + 90 | 0    | 0   | 90    |
    | J5    | q      | 0.15 | 0   | 0     |
}

dh! {
    /// Its links beside axis 1: folded, the point is as near to that as it can be, and both shoulders are one.
    struct Beside(standard, m, deg);

    | joint | theta  | d    | a    | alpha |
    |-------|--------|------|------|-------|
    | J1    | q      | 0.3  | 0    | -90   |
    | J2    | q      | 0.3  | 0.28 | 0     |
    | J3    | q      | 0    | 0.28 | 0     |
    | J4    | q + 90 | 0    | 0    | -90   |
    | J5    | q      | 0.15 | 0.59 | 0     |
}

fn apart<T: Bits, const N: usize, A: Arm<N>>(_: &A, a: &Joints<T, N>, b: &Joints<T, N>) -> f64 {
    let way = |i: usize| {
        let way = a[i].wide() - b[i].wide();
        if A::JOINTS[i].kind == JointKind::Revolute { math::wrap(way).abs() } else { way.abs() }
    };
    (0..N).map(way).fold(0.0, f64::max)
}

fn missed<T: Bits, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>, pose: &Pose<T>) -> f64 {
    let largest = |difference: &[T]| difference.iter().map(|x| x.wide().abs()).fold(0.0, f64::max);
    let reached = arm.fk(q);
    let shift = largest((reached.translation.vector - pose.translation.vector).as_slice());
    let size = largest(pose.translation.vector.as_slice()).max(arm.reach());
    let turn = largest((reached.rotation.matrix() - pose.rotation.matrix()).as_slice());
    turn.max(shift / size)
}

/// One joint at ±10⁻ᵏ from where it folds the arm, the others anywhere or, if they may meet there, at such a distance from a
/// multiple of a quarter turn.
fn aimed<const N: usize, A: Arm<N>>(
    arm: &A,
    (fold, folded): (usize, f64),
    meet: bool,
    random: &mut Sampler,
) -> [f64; N] {
    let off = |random: &mut Sampler| {
        let size = 10_f64.powi(-(random.below(18) as i32));
        [size, -size, 0.0][random.below(3)]
    };
    std::array::from_fn(|i| {
        let slides = A::JOINTS[i].kind == JointKind::Prismatic;
        if i == fold {
            folded + off(random)
        } else if slides {
            random.between(-0.5, 0.5) * arm.reach()
        } else if meet && random.below(3) == 0 {
            FRAC_PI_2 * random.below(4) as f64 + off(random)
        } else {
            random.between(-PI, PI)
        }
    })
}

/// Poses come back: none empty, each solution on the pose, and the joints that made it among them or in a family of theirs.
fn poses<T: Bits, const N: usize, A: InverseKinematics<N>>(arm: &A, at: (usize, f64), meet: bool, seed: u64) {
    let (mut random, epsilon) = (Sampler::new(seed), T::EPS.wide());
    let mut families = 0;
    for _ in 0..POSES {
        let aimed = aimed(arm, at, meet, &mut random);
        let q = Joints::<T, N>::from_fn(|i, _| T::rounded(aimed[i]));
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        assert!(!solutions.is_empty(), "{} {aimed:?}\n{solutions}", A::NAME);
        for solution in solutions.iter() {
            let missed = missed(arm, &solution.q, &pose) / epsilon;
            assert!(missed <= 16.0, "{} {aimed:?} missed by {missed} ε\n{solutions}", A::NAME);
        }
        // What the last digits of the pose do not tell is not asked for.
        let allowed = 1e3 * epsilon / dexterity(arm, &q).margin.wide();
        if allowed > 0.1 && solutions.iter().all(|s| s.is_isolated()) {
            continue;
        }
        let nearest = |solutions: &Solutions<T, N, A::Branch>| {
            solutions.iter().map(|s| apart(arm, &s.q, &q)).fold(f64::INFINITY, f64::min)
        };
        let mut near = nearest(&solutions);
        if solutions.iter().any(|s| !s.is_isolated()) {
            families += 1;
            near = near.min(nearest(&arm.ik_holding(&pose, &q)));
        }
        assert!(near <= allowed, "{} lost {aimed:?} by {near:e} of {allowed:e}\n{solutions}", A::NAME);
    }
    println!("{}: {families} of {POSES} in families", A::NAME);
}

fn both<const N: usize, A: InverseKinematics<N>>(arm: &A, at: (usize, f64), meet: bool, seed: u64) {
    poses::<f64, N, A>(arm, at, meet, seed);
    poses::<f32, N, A>(arm, at, meet, seed + 1);
}

#[test]
fn arms_folded_onto_their_axes_come_back() {
    both(&robots::LabRrr, (2, PI), true, 1);
    both(&ScaraFolding, (1, PI), true, 3);
    both(&Waist, (2, PI), true, 5);
    both(&Roll, (2, PI), true, 7);
}

/// The figure of joint 1 touches where that of joint 3 folds: its round-off is the root of that, and leaves nothing of joint 2.
#[test]
fn arms_folded_onto_axis_2_beside_axis_1_come_back() {
    both(&Beside, (2, PI), true, 9);
    both(&SlidingRrprr, (2, 0.0), false, 11);
}

/// Found by the program `reliability`: the quill beside axis 1 by less than the square of a distance tells, by more than a free joint may
/// miss. Far out, it is compared with more.
#[test]
fn a_quill_next_to_axis_1_is_told_apart_from_one_on_it() {
    let mut random = Sampler::new(73);
    for _ in 0..POSES {
        let beside = 10_f64.powf(random.between(-14.5, -12.5)) * [1.0, -1.0][random.below(2)];
        let [first, last, ..] = random.angles::<6>();
        let q = joints![first, PI + beside, random.between(-2.0, 2.0), last];
        let pose = ScaraFolding.fk(&q);
        let solutions = ScaraFolding.ik(&pose);
        assert!(!solutions.is_empty(), "{q}");
        for solution in solutions.iter() {
            let missed = missed(&ScaraFolding, &solution.q, &pose) / f64::EPSILON;
            assert!(missed <= 64.0, "{missed} ε at {q}\n{solutions}");
            if solution.is_isolated() {
                assert!(missed <= 16.0, "{missed} ε at {q}\n{solutions}");
            }
        }
        // Where the place tells joint 1 to within a hundredth, both ways are there.
        if beside.abs() > 1e-13 {
            let near = |turn: f64| {
                solutions.iter().any(|s| math::wrap(s.q[0] - first - turn).abs() < 1e-2 && s.is_isolated())
            };
            assert!(near(0.0) && near(PI), "{q}\n{solutions}");
        }
    }
}

/// Found by the program `reliability`: folded beside axis 1, where a direction of the joints is all but lost; a step in it must not stop
/// the others.
#[test]
fn links_folded_beside_axis_1_come_back_on_either_side() {
    let found = [
        joints![
            -1.571_796_326_794_896_4,
            3.143_369_789_254_624,
            3.142_814_380_258_221_4,
            2.380_071,
            0.581_651
        ],
        joints![1.286_835, 3.143_116_422_197_008_5, 3.142_592_653_589_793, 2.521_756_3, 3.097_197_4],
    ];
    for q in found {
        let pose = RollRrrrr.fk(&q);
        let solutions = RollRrrrr.ik(&pose);
        let near = solutions.iter().map(|s| apart(&RollRrrrr, &s.q, &q)).fold(f64::INFINITY, f64::min);
        assert!(near <= 1e-9 && solutions.len() == 4, "{near:e}: {q}\n{solutions}");
    }
}

/// Whether the joints that made a pose are among its solutions, to what its last digits tell and never farther than 10²·√ε.
fn comes_back<const N: usize, A: InverseKinematics<N>>(arm: &A, q: &Joints<f64, N>) {
    let pose = arm.fk(q);
    let solutions = arm.ik(&pose);
    let near = solutions.iter().map(|s| apart(arm, &s.q, q)).fold(f64::INFINITY, f64::min);
    let allowed = (1e3 * f64::EPSILON / dexterity(arm, q).margin).min(1e2 * f64::EPSILON.sqrt());
    assert!(near <= allowed, "{} lost {q} by {near:e} of {allowed:e}\n{solutions}", A::NAME);
}

/// Found by the program `reliability`: beside axis 1 the orientation tells one side, from which small steps come near enough to the pose;
/// the figures lead to the other, which reaches it.
#[test]
fn what_comes_near_enough_does_not_hide_what_reaches() {
    let found = [
        [
            0x3fe0_a123_0eca_4b20,
            0x3ffa_3340_47fc_c433,
            0xbd06_849b_86a1_2b9b,
            0xc006_9bce_2ecf_7082,
            0x4006_9689_26d5_2ed6,
        ],
        [
            0xc007_efec_e32a_10d4,
            0xbffa_3340_47fc_c447,
            0x3d01_557f_7fca_ee2d,
            0x3ff1_a060_55fa_92e4,
            0xbff9_a1cf_6f64_69c5,
        ],
        [
            0xbff6_9aab_8c55_75a3,
            0xc009_21fa_b03c_61bd,
            0x4009_21fb_61b0_2665,
            0xbffe_5d7a_8866_1627,
            0xbfe0_dc3b_6753_7f9c,
        ],
        [
            0x4008_0678_d728_6988,
            0xc009_21fa_ffe4_bd7f,
            0x4009_21fb_5c6a_5eba,
            0x4006_b475_d214_5a46,
            0x4006_bced_54b3_2860,
        ],
        [
            0x4001_54ae_f644_a074,
            0x4009_21fa_b9f5_877e,
            0x4009_21fb_46d8_33cb,
            0x4004_3a7c_bffb_1390,
            0x4009_21fb_46d8_33cb,
        ],
    ];
    for bits in found {
        comes_back(&RollRrrrr, &Joints::from(bits.map(f64::from_bits)));
    }
}

/// The slide all but drawn in, and axis 5 all but in the plane of axes 2 and 4: the orientation tells two values of joint 2 that are one but
/// for what the slide and joint 1 take of it.
#[test]
fn two_ways_that_are_all_but_one_beside_axis_2_both_come_back() {
    let mut random = Sampler::new(79);
    for _ in 0..POSES {
        let size = |random: &mut Sampler, from: f64, to: f64| {
            10_f64.powf(random.between(from, to)) * [1.0, -1.0][random.below(2)]
        };
        let [first, last, ..] = random.angles::<6>();
        // Level the slide would move the point as joint 1 does.
        let second = random.between(-1.4, 1.4) + [0.0, PI][random.below(2)];
        let slide = size(&mut random, -14.5, -5.5);
        let plane = [0.0, PI][random.below(2)] + size(&mut random, -17.0, -4.5);
        comes_back(&SlidingRrprr, &joints![first, second, slide, plane, last]);
    }
}

/// Found by the program `reliability`: the slide all but drawn in and level, or upright where both shoulders are one. The place of the point
/// knows joint 1 to the root of its round-off, and two solutions that differ by less in it differ by more in the joints that follow.
#[test]
fn two_ways_that_the_place_does_not_tell_apart_both_come_back() {
    let found = [
        [
            0x3fdb_21be_6a13_1298,
            0x3ff9_21fb_5444_2ceb,
            0xbe43_7358_5fef_11bd,
            0x4009_20f4_8251_beb6,
            0xc006_9a7b_8348_4603,
        ],
        [
            0xc006_7a61_5bef_8f86,
            0xbff9_21fb_56f3_5ef4,
            0x3e45_798e_e230_8c3a,
            0x4008_a974_a388_43e6,
            0x3fe6_e264_f17e_3368,
        ],
        [
            0x3fe2_fb6a_ff5b_9ed4,
            0xc009_224d_e2fa_d788,
            0x3ef5_8ba0_d38a_cbf6,
            0xbf0a_ce43_c860_9c36,
            0xbffe_1e39_f78a_192b,
        ],
        [
            0x3feb_ab7c_73a7_6668,
            0xc009_21c6_e67e_56df,
            0x3f11_0a13_7f38_c544,
            0x3f02_1696_85fc_e81a,
            0xc008_9165_1c08_67f0,
        ],
    ];
    for bits in found {
        comes_back(&SlidingRrprr, &Joints::from(bits.map(f64::from_bits)));
    }
}
