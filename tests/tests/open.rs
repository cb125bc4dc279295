//! Arms whose every length is open, at values that nobody chose: some vanish, some are equal. Each is tried as the arms of
//! RELIABILITY.md are, aimed at its own singular sets.

use kin_runtime::math::{Float, abs, wrap};
use kin_runtime::prelude::*;
use kin_runtime::singularity::{determinant, normalised, position_determinant};
use tests::invented::{Human, PrrA};
use tests::reliability::subject::{ByPoint, ByPose, ByTool, Subject, Tried};
use tests::reliability::trial::complaints;
use tests::sample::Sampler;

dh! {
    /// Links in a plane, every offset, and an oblique wrist.
    pub struct Elbow(standard, m, deg);

    param a1 = 0.2; param d2 = 0.1; param a2 = 0.4; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | -90   |
    | J2    | q     | d2  | a2 | 0     |
    | J3    | q     | 0   | a3 | -90   |
    | J4    | q     | d4  | 0  | -60   |
    | J5    | q     | 0   | 0  | 60    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// Three axes that are oblique to each other, and joint 2 not at rest at 0.
    pub struct General(standard, m, deg);

    param a1 = 0.2; param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2; param d4 = 0.3; param turn = 0.26;

    | joint | theta    | d   | a  | alpha |
    |-------|----------|-----|----|-------|
    | J1    | q        | 0.3 | a1 | 70    |
    | J2    | q + turn | d2  | a2 | 80    |
    | J3    | q        | d3  | a3 | -60   |
    | J4    | q        | d4  | 0  | -90   |
    | J5    | q        | 0   | 0  | 90    |
    | J6    | q        | 0.1 | 0  | 0     |
}

dh! {
    /// The same under an oblique wrist.
    pub struct Oblique(standard, m, deg);

    param a1 = 0.2; param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | 70    |
    | J2    | q     | d2  | a2 | 80    |
    | J3    | q     | d3  | a3 | -60   |
    | J4    | q     | d4  | 0  | -60   |
    | J5    | q     | 0   | 0  | 70    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// Axes 1 and 2 meet.
    pub struct Meeting(standard, m, deg);

    param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | 0  | 70    |
    | J2    | q     | d2  | a2 | 80    |
    | J3    | q     | d3  | a3 | -60   |
    | J4    | q     | d4  | 0  | -90   |
    | J5    | q     | 0   | 0  | 90    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// Axes 1 and 2 are parallel.
    pub struct Parallel(standard, m, deg);

    param a1 = 0.3; param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | 0     |
    | J2    | q     | d2  | a2 | 80    |
    | J3    | q     | d3  | a3 | -60   |
    | J4    | q     | d4  | 0  | -90   |
    | J5    | q     | 0   | 0  | 90    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// Joint 3 slides, oblique to axis 2.
    pub struct Outward(standard, m, deg);

    param a1 = 0.3; param d2 = 0.1; param a2 = 0.4; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | 70    |
    | J2    | q     | d2  | a2 | 80    |
    | J3    | 20    | q   | a3 | -60   |
    | J4    | q     | d4  | 0  | -90   |
    | J5    | q     | 0   | 0  | 90    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// Joint 2 slides, oblique to its neighbours.
    pub struct Between(standard, m, deg);

    param a1 = 0.3; param a2 = 0.4; param d3 = 0.1; param a3 = 0.2; param d4 = 0.3;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | 70    |
    | J2    | 30    | q   | a2 | 80    |
    | J3    | q     | d3  | a3 | -60   |
    | J4    | q     | d4  | 0  | -90   |
    | J5    | q     | 0   | 0  | 90    |
    | J6    | q     | 0.1 | 0  | 0     |
}

dh! {
    /// An oblique shoulder, and a hand whose axes are oblique to each other.
    pub struct Shouldered(standard, m, deg);

    param d3 = 0.35; param a3 = 0.1; param d4 = 0.1; param a4 = 0.3; param d5 = 0.05; param a5 = 0.25; param a6 = 0.1;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | 0  | -70   |
    | J2    | q     | 0   | 0  | 80    |
    | J3    | q     | d3  | a3 | -70   |
    | J4    | q     | d4  | a4 | 80    |
    | J5    | q     | d5  | a5 | -75   |
    | J6    | q     | 0.1 | a6 | 20    |
}

dh! {
    /// Three joints that carry a point.
    pub struct Three(standard, m, deg);

    param a1 = 0.3; param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2;

    | joint | theta | d   | a  | alpha |
    |-------|-------|-----|----|-------|
    | J1    | q     | 0.3 | a1 | 70    |
    | J2    | q     | d2  | a2 | 80    |
    | J3    | q     | d3  | a3 | -60   |
}

/// A length: one in four vanishes, one in four is equal to others.
fn length(random: &mut Sampler) -> f64 {
    match random.below(4) {
        0 => 0.0,
        1 => [0.1, 0.2, 0.3, -0.3, 0.5][random.below(5)],
        _ => random.between(-0.6, 0.6),
    }
}

/// Whether the arm is singular wherever it stands, because of the lengths that vanish: then it is no arm with that many joints.
fn is_stuck<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) -> bool {
    (0..40).all(|_| {
        let jacobian = normalised(arm, &Joints::from(random.angles::<N>()));
        determinant(&jacobian).or_else(|| position_determinant(&jacobian)).is_none_or(|det| det.abs() < 1e-12)
    })
}

/// Some tries of many such arms find nothing wrong; a tenth of them in singles, of which more find what is known to be lost still, where
/// several figures are singular at once.
fn tried<const N: usize, S: Subject<N>>(seed: u64, arm: impl Fn(&mut dyn FnMut() -> f64) -> S) {
    let (arms, tries) = if cfg!(debug_assertions) { (24, 10) } else { (600, 30) };
    let (mut random, mut stuck) = (Sampler::new(seed), 0);
    for number in 0..arms {
        let mut lengths = vec![];
        let subject = arm(&mut || {
            lengths.push(length(&mut random));
            lengths[lengths.len() - 1]
        });
        if is_stuck(&subject, &mut random) {
            stuck += 1;
            continue;
        }
        let doubles = complaints::<f64, N>(&subject, tries, &mut random);
        let singles = complaints::<f32, N>(&subject, tries / 10, &mut Sampler::new(seed + number));
        let clear = doubles.is_empty() && singles.is_empty();
        assert!(clear, "{} {number} of {lengths:?}: {doubles:?} {singles:?}", S::NAME);
    }
    // A human arm without an upper arm or a forearm is stuck, nearly half of those drawn.
    assert!(4 * stuck < 3 * arms, "{stuck} of {arms}");
}

macro_rules! open {
    ($($name:ident: $Arm:ident by $Kind:ident of $joints:literal, $seed:literal, [$($length:ident)*];)*) => { $(
        #[test]
        fn $name() {
            tried::<$joints, _>($seed, |length| Tried($Arm { $($length: length()),* }, $Kind));
        }
    )* };
}
open! {
    elbows_come_back: Elbow by ByPose of 6, 1, [a1 d2 a2 a3 d4];
    general_bases_come_back: General by ByPose of 6, 2, [a1 d2 a2 d3 a3 d4 turn];
    oblique_wrists_come_back: Oblique by ByPose of 6, 3, [a1 d2 a2 d3 a3 d4];
    meeting_axes_come_back: Meeting by ByPose of 6, 4, [d2 a2 d3 a3 d4];
    parallel_axes_come_back: Parallel by ByPose of 6, 5, [a1 d2 a2 d3 a3 d4];
    a_slide_outward_comes_back: Outward by ByPose of 6, 6, [a1 d2 a2 a3 d4];
    a_slide_between_comes_back: Between by ByPose of 6, 7, [a1 a2 d3 a3 d4];
    spherical_shoulders_come_back: Shouldered by ByTool of 6, 8, [d3 a3 d4 a4 d5 a5 a6];
    human_arms_come_back: Human by ByTool of 6, 10, [upper fore stretch lean];
    three_joints_come_back: Three by ByPoint of 3, 9, [a1 d2 a2 d3 a3];
}

/// Joints come back as one isolated solution, within so much.
fn comes_back<A: InverseKinematics<6>>(arm: &A, bits: [u64; 6], within: f64) {
    base_comes_back(arm, Joints::from(bits.map(f64::from_bits)), 6, within);
}

/// So do the first of them; a wrist turns with round-off, or is free, where its axes all but coincide.
fn base_comes_back<T: Float, const N: usize, A: InverseKinematics<N>>(
    arm: &A,
    q: Joints<T, N>,
    first: usize,
    within: T,
) {
    let solutions = arm.ik(&arm.fk(&q));
    let is_near = |s: &Solution<T, N, _>| (s.q - q).iter().take(first).all(|way| abs(wrap(*way)) <= within);
    let back = solutions.iter().any(|s| (first < N || s.is_isolated()) && is_near(s));
    assert!(back, "{}: {q}\n{solutions}", A::NAME);
}

/// The point all but on axis 2, and joint 3 sliding along: it changes the distance from axis 2 and the height on it at once.
#[test]
fn a_slide_that_passes_axis_2_comes_back() {
    let arm = Outward { a1: 0.26171278911771156, d2: -0.35008765317543344, a2: 0.0, a3: 0.0, d4: 0.0 };
    let bits = [
        0xbffe_d6e9_976e_a2ba,
        0x4008_c7d4_fdd7_988e,
        0xbd3d_3419_d09a_2d2c,
        0x3ff7_886f_0170_f7e4,
        0x3ffd_20c9_3d5a_5de0,
        0x3ff7_2159_b7a2_3ef8,
    ];
    comes_back(&arm, bits, 1e-3);
}

/// Joint 2 is told by 1e-10 of the point, so that ways that come to one root differ in it by 1e-7: they are one, and the other is tried.
#[test]
fn ways_that_only_round_off_tells_apart_beside_axis_2_are_one() {
    let arm = Outward { a1: -0.2820229066853264, d2: -0.3, a2: 0.0, a3: 0.0, d4: 0.0 };
    let bits: [u64; 6] = [
        0xbfd7_4dfb_dd41_c4a8,
        0x3fe7_df0a_d4f4_3f68,
        0xbdda_fe5f_0092_f463,
        0xc002_ca31_d11a_7f65,
        0x4009_21fb_5440_bd7c,
        0xbffe_52c2_9c73_c3a8,
    ];
    base_comes_back(&arm, Joints::from(bits.map(f64::from_bits)), 3, 1e-5);
}

dh! {
    /// Three joints, the tool beside the last axis or on it.
    pub struct BesideSkew(standard, m, deg);

    param tool = 0.0;

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.2 | 0.1  | 90    |
    | J2    | q     | 0   | 0.3  | 70    |
    | J3    | q     | 0.2 | tool | 0     |
}

dh! {
    /// The same, axes 2 and 3 parallel.
    pub struct BesideElbow(standard, m, deg);

    param tool = 0.0;

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.2 | 0.1  | 90    |
    | J2    | q     | 0   | 0.3  | 0     |
    | J3    | q     | 0.2 | tool | 0     |
}

dh! {
    /// The same, and the tool passes axis 1.
    pub struct BesideFirst(standard, m, deg);

    param tool = 0.0;

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.2 | 0.1  | 90    |
    | J2    | q     | 0   | 0.3  | 90    |
    | J3    | q     | 0.2 | tool | 0     |
}

dh! {
    /// Axes 2 and 3 all but meet: two joints carry that point.
    pub struct BesideSecond(standard, m, deg);

    param link = 0.0;

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.2 | 0.1  | 90    |
    | J2    | q     | 0   | link | 70    |
    | J3    | q     | 0.2 | 0    | 0     |
}

/// How far the lengths are that are nothing or all but nothing.
const BESIDE: [f64; 8] = [0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 0.1];

/// Many come back.
fn all_come_back<A: InverseKinematics<3>>(arm: &A, within: f64, mut draw: impl FnMut() -> [f64; 3]) {
    for _ in 0..200 {
        base_comes_back(arm, Joints::from(draw()), 3, within);
    }
}

/// The place of a point that is all but on the last axis that carries it says nothing of that joint: the orientation tells it, and joint 1
/// too where the point is on its axis besides.
#[test]
fn a_joint_that_does_not_move_the_point_is_told_by_the_orientation() {
    let mut random = Sampler::new(12);
    for by in BESIDE {
        all_come_back(&BesideSkew { tool: by }, 1e-9, || random.angles());
        all_come_back(&BesideElbow { tool: by }, 1e-9, || random.angles());
        all_come_back(&BesideFirst { tool: by }, 1e-9, || random.angles());
        all_come_back(&BesideSecond { link: by }, 1e-9, || random.angles());
    }
    // Where 0.1 + 0.3·cos θ2 + 0.2·sin θ2 vanishes the tool on axis 3 is on axis 1.
    let onto = f64::atan2(0.2, 0.3) + (-0.1 / f64::hypot(0.2, 0.3)).acos();
    all_come_back(&BesideFirst { tool: 0.0 }, 1e-6, || {
        let [t1, _, t3] = random.angles();
        [t1, onto, t3]
    });
}

/// Both ways that pass axis 2 have the label "right" there: each is led to the root that it is nearer to.
#[test]
fn ways_of_one_label_that_pass_axis_2_keep_apart() {
    let cases: [[u32; 6]; 3] = [
        [0x3d33_1e81, 0xbe99_48d8, 0xc037_20fb, 0x4044_ae78, 0x4049_0fdb, 0xc017_02a7],
        [0x3ec5_9a88, 0xbe97_17a7, 0xc036_ead7, 0x3daf_6714, 0x403a_8bba, 0xc043_908e],
        [0x3f3c_ec44, 0x4018_a763, 0xc036_f5ee, 0xbf67_3eb6, 0x3fee_2a27, 0xc023_194c],
    ];
    for bits in cases {
        base_comes_back(&PrrA, Joints::from(bits.map(f32::from_bits)), 3, 1e-3);
    }
}

/// Near a cusp the roots of a general base are farther along what is lost than a straight step goes before the other joints miss.
#[test]
fn beside_a_cusp_the_other_joints_follow_what_is_lost() {
    let arm =
        Three { a1: -0.4167174964733861, d2: 0.0, a2: -0.16192830103422745, d3: 0.0, a3: 0.1790271408669617 };
    let bits = [0x3fe2_6d74_894a_890c_u64, 0x4003_1ac0_2f7f_7880, 0x3fd6_2af5_47bd_d948];
    let q = Joints::from(bits.map(f64::from_bits));
    let solutions = arm.ik_position(&Point3 { coords: arm.fk(&q).translation.vector });
    let nearest = solutions.iter().map(|s| (s.q - q).amax()).fold(9.0, f64::min);
    assert!(nearest <= 1e2 * f64::EPSILON.cbrt(), "{nearest:e}\n{solutions}");
}

/// Beside a cusp where a second direction is weak too, which the other joints still close.
#[test]
fn beside_a_cusp_what_is_merely_weak_is_closed() {
    let arm = General {
        a1: 0.2705234097392831,
        d2: 0.3899701572462191,
        a2: 0.13967905201742647,
        d3: 0.07467776767053591,
        a3: 0.4389916306179208,
        d4: 0.0,
        turn: 0.4435422597445432,
    };
    let bits = [
        0xbfd0_4e62_5fb2_a260,
        0xc00c_2ef3_38e4_4047,
        0x3ffe_52d2_e3dc_7c70,
        0xbfe1_9fba_3498_00e8,
        0xbff5_73ae_2959_d3e7,
        0xbff4_8cad_c5b0_4a03,
    ];
    comes_back(&arm, bits, 1e2 * f64::EPSILON.cbrt());
}

/// The wrist centre a few ε from axis 1 of a general base: two shoulders are all but one, and the oblique wrist, at its rim, takes none of
/// the values of joint 1 between them.
#[test]
fn beyond_shoulders_that_are_all_but_one_the_rim_is_reached() {
    let arm = Oblique {
        a1: 0.009805925467920362,
        d2: 0.0,
        a2: -0.3,
        d3: 0.2951881360609977,
        a3: 0.0,
        d4: 0.4502341744146773,
    };
    let bits = [
        0xbfe2_e0c8_e499_ed88,
        0x3fe4_b997_a712_6431,
        0x4006_0849_15e1_42db,
        0xbff6_dda2_36bc_77d9,
        0x3c67_0ef5_4646_d497,
        0x3fef_19d9_22fc_a250,
    ];
    comes_back(&arm, bits, 1e-3);
}

/// A spherical shoulder at its rim, and the wrist's point so near axis 5 that its round-off says little of joint 5.
#[test]
fn a_rim_seen_from_beside_axis_5_is_reached() {
    let arm = Shouldered {
        d3: 0.0,
        a3: 0.1,
        d4: 0.0,
        a4: 0.1,
        d5: 0.32544079161877515,
        a5: 0.0,
        a6: -0.525335962828434,
    };
    let bits = [
        0xbff7_2d02_c1ef_072d,
        0xbe45_798e_e230_8c3a,
        0xbff4_0def_53f9_1214,
        0x4009_2283_3fa8_dfbd,
        0x3fef_3542_16b3_1006,
        0x4002_7401_b48a_6742,
    ];
    comes_back(&arm, bits, 1e-3);
}

/// An oblique wrist at the rim of its cone, and the base at a double root, whose round-off puts it fifteen times as far beyond the rim
/// as its magnification says.
#[test]
fn a_rim_above_a_double_root_is_reached() {
    let arm =
        Oblique { a1: 0.3, d2: 0.1, a2: -0.3, d3: 0.0, a3: -0.1585019266190535, d4: -0.329905188158189 };
    let bits = [
        0xc008_6048_62fc_6113,
        0x3ffe_33ea_2d8f_7a7c,
        0x3ff5_e439_b49e_35a1,
        0xbfed_c4a8_27ef_6d50,
        0xbda5_fd7f_e179_6495,
        0xbff2_c6b7_c9e8_a2b5,
    ];
    comes_back(&arm, bits, 1e-3);
}

dh! {
    /// A slide under an oblique wrist, all axes through one line.
    pub struct Drawn(standard, m, deg);

    param d2 = 0.1; param d4 = 0.3;

    | joint | theta | d   | a | alpha |
    |-------|-------|-----|---|-------|
    | J1    | q     | 0.3 | 0 | -90   |
    | J2    | q     | d2  | 0 | 90    |
    | J3    | 0     | q   | 0 | 0     |
    | J4    | q     | d4  | 0 | -60   |
    | J5    | q     | 0   | 0 | 70    |
    | J6    | q     | 0.1 | 0 | 0     |
}

/// The slide drawn in to 1e-9 and both shoulders one: what joint 1 is off by, the root of round-off, is more than that, and tells joint 2
/// nothing.
#[test]
fn a_slide_drawn_in_where_shoulders_meet_comes_back() {
    let arm = Drawn { d2: 0.30514981998243795, d4: 0.3 };
    let bits = [
        0x3ff2_c88f_5ee4_2004,
        0x3fdb_b8a5_df79_dd10,
        0xbfd3_3333_347b_5b09,
        0xbffe_2e66_067e_7f60,
        0x4009_21fb_5444_2d18,
        0x4009_17f9_c278_06d4,
    ];
    comes_back(&arm, bits, 1e-3);
}
