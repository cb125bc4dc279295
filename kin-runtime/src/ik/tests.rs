//! The solvers against arms that are plain products of matrices: what was put in comes out, wherever the arm stands.

mod targets;

use crate::ik::ACCEPTED;
use crate::math;
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::sample::{Figures, LAB_ARM, LabRrr, PUMA_560, Random, STANFORD_ARM};
use crate::{
    Arm, Boundary, EulerZyx, Float, InverseKinematics, Point3, PositionInverse, Posture, Reason, Slot,
    Solution, Solutions, dexterity,
};
use core::f64::consts::{FRAC_PI_2, PI};

const EPS: f64 = f64::EPSILON;

/// The largest joint difference, angles modulo a turn.
fn apart<T: Float, const N: usize, A: Arm<N>>(_: &A, a: &Joints<T, N>, b: &Joints<T, N>) -> T {
    let mut largest = T::lit(0.0);
    for ((x, y), joint) in pose::entries(a).into_iter().zip(pose::entries(b)).zip(A::JOINTS) {
        let slides = joint.kind == crate::JointKind::Prismatic;
        largest = math::max(largest, math::abs(if slides { x - y } else { math::wrap(x - y) }));
    }
    largest
}

fn random_joints<T: Float, A: Arm<6>>(_: &A, random: &mut Random) -> Joints<T, 6> {
    let slides = A::JOINTS.map(|joint| joint.kind == crate::JointKind::Prismatic);
    pose::column(slides.map(|slides| T::lit(if slides { random.within(-1.0, 1.0) } else { random.angle() })))
}

/// What holds for every answer to a reachable pose.
fn judge<T: Float, A>(arm: &A, q: &Joints<T, 6>, worst: f64) -> Solutions<T, 6, Posture>
where
    A: InverseKinematics<6, Branch = Posture>,
{
    let pose = arm.fk(q);
    let solutions = arm.ik(&pose);
    let mut nearest = T::lit(1e9);
    for solution in solutions.iter() {
        assert!(solution.residual <= T::lit(worst) * T::EPS, "{:?}", solution.residual);
        assert!(pose::entries(&solution.q).iter().all(|x| math::is_finite(*x)));
        nearest = math::min(nearest, apart(arm, &solution.q, q));
        for other in solutions.iter().take_while(|other| other.branch != solution.branch) {
            assert!(apart(arm, &solution.q, &other.q) > T::lit(6.0) * math::sqrt(T::EPS), "{solutions}");
        }
    }
    if solutions.iter().any(|solution| !solution.is_isolated()) {
        for member in arm.ik_holding(&pose, q).iter() {
            assert!(member.residual <= T::lit(ACCEPTED) * T::EPS);
            nearest = math::min(nearest, apart(arm, &member.q, q));
        }
    }
    // Rounding of the pose itself moves the joints by ε / margin.
    let margin = dexterity(arm, q).margin;
    assert!(nearest <= T::lit(100.0) * T::EPS / margin, "{nearest:?}, margin {margin:?}, {q:?}\n{solutions}");
    solutions
}

#[test]
fn random_poses_give_their_joints_back() {
    let mut random = Random(1);
    for _ in 0..400 {
        let q = random_joints(&LAB_ARM, &mut random);
        judge::<f64, _>(&LAB_ARM, &q, 8.0);
        let q = random_joints(&PUMA_560, &mut random);
        assert_eq!(judge::<f64, _>(&PUMA_560, &q, 8.0).len(), 8);
        let q = random_joints(&STANFORD_ARM, &mut random);
        assert_eq!(judge::<f64, _>(&STANFORD_ARM, &q, 8.0).len(), 8);
        let arm = Figures::<false>::random(&mut random, true);
        judge::<f64, _>(&arm, &random_joints(&arm, &mut random), 16.0);
        let arm = Figures::<true>::random(&mut random, true);
        judge::<f64, _>(&arm, &random_joints(&arm, &mut random), 16.0);
    }
}

#[test]
fn single_precision_gives_its_joints_back() {
    let mut random = Random(2);
    for _ in 0..400 {
        judge::<f32, _>(&LAB_ARM, &random_joints(&LAB_ARM, &mut random), 8.0);
        judge::<f32, _>(&PUMA_560, &random_joints(&PUMA_560, &mut random), 8.0);
        judge::<f32, _>(&STANFORD_ARM, &random_joints(&STANFORD_ARM, &mut random), 8.0);
        let arm = Figures::<false>::random(&mut random, true);
        judge::<f32, _>(&arm, &random_joints(&arm, &mut random), 16.0);
    }
}

#[test]
fn oblique_wrists_give_their_joints_back() {
    let mut random = Random(3);
    let mut arm = Figures::<false>::random(&mut random, false);
    // Twists of 60° and 50°, as they are built.
    let [sixty, fifty] = [60_f64, 50.0].map(|twist| crate::sample::about_x(twist.to_radians()));
    arm.between = Some([sixty, fifty]);
    for _ in 0..400 {
        judge::<f64, _>(&arm, &random_joints(&arm, &mut random), 16.0);
    }
    for _ in 0..400 {
        let arm = Figures::<false>::random(&mut random, false);
        judge::<f64, _>(&arm, &random_joints(&arm, &mut random), 40.0);
    }
}

/// Ten to a random power down to 1e-17, either sign; sometimes nothing at all.
fn small(random: &mut Random) -> f64 {
    let exponent = random.within(0.0, 18.0);
    let size = if exponent > 17.0 { 0.0 } else { libm_pow10(-exponent) };
    if random.coin() { size } else { -size }
}

/// 10^x for x in (-18, 0], well enough.
fn libm_pow10(x: f64) -> f64 {
    let (mut power, mut left) = (1.0, -x);
    while left >= 1.0 {
        (power, left) = (power * 0.1, left - 1.0);
    }
    power * (1.0 - 0.9 * left)
}

/// Joints at, or within a power of ten of, the singular sets that `aim` names.
fn aimed<const SLIDE: bool>(arm: &Figures<SLIDE>, aim: u8, random: &mut Random) -> Joints<f64, 6> {
    let mut psi = [(); 6].map(|()| random.angle());
    let half_turn = |random: &mut Random| if random.coin() { PI } else { 0.0 };
    if SLIDE {
        psi[2] = random.within(0.3, 1.0);
    }
    if aim & 1 != 0 {
        psi[4] = half_turn(random) + small(random);
    }
    if aim & 2 != 0 {
        psi[2] = small(random) + if SLIDE { 0.0 } else { half_turn(random) };
    }
    if aim & 4 != 0 {
        // The arm's plane meets the wrist centre at the foot of the common normal, where both shoulders are one.
        let ([first, second], (s3, c3)) = (arm.links, math::sin_cos(psi[2]));
        let (x, y) = if SLIDE { (first, psi[2]) } else { (first + second * c3, second * s3) };
        let (distance, direction) = (math::hypot(x, y), math::atan2(y, x));
        if distance > arm.a1 {
            let lean = math::atan2(math::sqrt((distance - arm.a1) * (distance + arm.a1)), -arm.a1);
            psi[1] = if random.coin() { lean } else { -lean } - direction + small(random);
        }
    }
    let mut rows = psi;
    for (row, (offset, reversed)) in rows.iter_mut().zip(arm.offset.iter().zip(arm.reversed)) {
        *row = if reversed { offset - *row } else { *row - offset };
    }
    pose::column(arm.command(rows))
}

fn singular_sets<const SLIDE: bool>(seed: u64) {
    let mut random = Random(seed);
    for aim in 0..8 {
        for _ in 0..300 {
            let mut arm = Figures::<SLIDE>::random(&mut random, true);
            if random.coin() {
                (arm.lateral, arm.twist) = (0.0, FRAC_PI_2);
            }
            // A slide that passes through axis 2 and an arm whose wrist comes near the axes at once would have two
            // folds in one corner, where the pose no longer tells the joints apart.
            if !SLIDE && random.coin() {
                arm.links[1] = arm.links[0];
            }
            let q = aimed(&arm, aim, &mut random);
            assert!(!judge::<f64, _>(&arm, &q, 18.0).is_empty());
        }
    }
}

#[test]
fn nothing_is_lost_at_or_near_the_singular_sets() {
    singular_sets::<false>(4);
}

#[test]
fn nothing_is_lost_near_the_singular_sets_of_a_slide() {
    singular_sets::<true>(5);
}

#[test]
fn margins_are_the_factors_of_the_determinant() {
    let mut random = Random(9);
    for oblique in [false, true] {
        for _ in 0..200 {
            let arm = Figures::<false>::random(&mut random, !oblique);
            let q = random_joints(&arm, &mut random);
            let determinant = dexterity(&arm, &q).manipulability;
            let product = |s: &Solution<f64, 6, Posture>| {
                let (elbow, wrist) =
                    (math::sin_cos(s.margins.elbow).0, math::sin_cos(s.margins.wrist.unwrap()).0);
                s.margins.shoulder * elbow * wrist
            };
            let solutions = arm.ik(&arm.fk(&q));
            let own = solutions.nearest(&q).unwrap();
            // det J = |sin α| · shoulder · (upper · fore · sin elbow) · (sin 45 · sin 56 · sin wrist), linear rows per reach.
            let reach = arm.reach();
            let [upper, fore] = arm.links;
            let axes = arm
                .between
                .map_or(1.0, |[k4, k5]| math::hypot(k4[2][0], k4[2][1]) * math::hypot(k5[0][2], k5[1][2]));
            let twist = math::sin_cos(arm.twist).0.abs();
            let expected = twist * upper * fore * axes * product(own) / (reach * reach * reach);
            assert!(
                (determinant - expected).abs() < 1e-10 * determinant.max(1e-4),
                "{determinant} {expected}"
            );
        }
    }
}

#[test]
fn an_elbow_that_is_up_is_above_the_one_that_is_down() {
    let mut random = Random(10);
    let shoulders = [crate::Shoulder::Right, crate::Shoulder::Left];
    for _ in 0..200 {
        let puma = PUMA_560.ik(&PUMA_560.fk(&random_joints::<f64, _>(&PUMA_560, &mut random)));
        let lab = LAB_ARM.ik(&LAB_ARM.fk(&random_joints::<f64, _>(&LAB_ARM, &mut random)));
        for shoulder in shoulders {
            // Both upper arms rise by the sine of q2. That of the lab arm stands 30 mm before axis 1, so that only
            // reaching over its back is it surely on the far side of its shoulder.
            for (solutions, certain) in [(&puma, true), (&lab, shoulder == crate::Shoulder::Left)] {
                let height = |elbow| {
                    let solution =
                        solutions.solution(Posture { shoulder, elbow, wrist: crate::Bend::NoFlip });
                    solution.map(|s| math::sin_cos(s.q[1]).0)
                };
                if let (true, Some(up), Some(down)) =
                    (certain, height(crate::Elbow::Up), height(crate::Elbow::Down))
                {
                    assert!(up > down, "{shoulder} {up} {down}");
                }
            }
        }
    }
}

#[test]
fn a_boundary_pose_is_reached_and_one_beyond_it_is_not() {
    let level = EulerZyx { z: 0.0, y: 0.0, x: 0.0 };
    let stretched = PUMA_560.fk(&pose::column([0.3, 0.2, -math::atan2(0.4318, 0.0203), 0.1, 0.5, 0.2]));
    let solutions = PUMA_560.ik(&stretched);
    assert_eq!(solutions.iter().count(), 4, "{solutions}");
    // Seed 000, 6.5: 3.4e-10 mm too far, in an arm of 420 mm.
    assert_eq!(LAB_ARM.ik(&level.at([-30.0, 0.0, 372.5294643])).len(), 4);
    let beyond = LAB_ARM.ik(&level.at([-30.0, 0.0, 372.52946438]));
    assert!(beyond.is_empty());
    let reasons = beyond.slots().iter().filter(|slot| {
        matches!(slot, Slot::Empty(Reason::OutOfReach { by, towards: Boundary::OuterCircle, theta1: Some(_) })
            if *by > 3.3e-10)
    });
    assert_eq!(reasons.count(), 8);
    for far in [1e3, 1e6, 1e9, 1e18, 1e200, f64::MAX] {
        let solutions = LAB_ARM.ik(&level.at([far, 0.0, far]));
        let far_away = |slot: &Slot<f64, 6, Posture>| matches!(slot, Slot::Empty(Reason::OutOfReach { by, .. }) if *by > 0.5 * far && by.is_finite());
        assert!(solutions.slots().iter().all(far_away), "{solutions}");
    }
}

#[test]
fn every_bit_pattern_has_a_typed_answer() {
    let mut random = Random(6);
    for _ in 0..2_000 {
        let mut entry = || f64::from_bits(random.bits());
        let rotation = [(); 3].map(|()| [(); 3].map(|()| entry()));
        let solutions = PUMA_560.ik(&pose::from_rows(rotation, [(); 3].map(|()| entry())));
        assert!(solutions.is_empty());
        // A true rotation with a wild position.
        let pose = pose::from_rows(random.rotation(), [(); 3].map(|()| f64::from_bits(random.bits())));
        for solution in PUMA_560.ik(&pose).iter().chain(STANFORD_ARM.ik(&pose).iter()) {
            assert!(solution.residual <= ACCEPTED * EPS && solution.q.iter().all(|x| x.is_finite()));
        }
    }
}

#[test]
fn what_is_not_a_rotation_is_said_so_and_what_nearly_is_one_is_mended() {
    let q = pose::column([0.3, 0.5, -0.2, 0.4, 0.6, -0.9]);
    let (r, p) = pose::rows(&PUMA_560.fk(&q));
    let reason = |pose: Pose<f64>| *PUMA_560.ik(&pose).slots().first().unwrap();
    let scaled = r.map(|row| row.map(|x| 1.01 * x));
    assert!(matches!(
        reason(pose::from_rows(scaled, p)),
        Slot::Empty(Reason::NotARotation { defect }) if (defect - 0.0201).abs() < 1e-6
    ));
    let [x, y, z] = r;
    assert_eq!(reason(pose::from_rows([y, x, z], p)), Slot::Empty(Reason::LeftHanded));
    assert_eq!(reason(pose::from_rows(r, [f64::NAN, 0.0, 0.0])), Slot::Empty(Reason::NotFinite));
    assert_eq!(reason(pose::from_rows([x, [f64::INFINITY; 3], z], p)), Slot::Empty(Reason::NotFinite));
    let rounded = r.map(|row| row.map(|x| f64::from(x as f32)));
    let solutions = PUMA_560.ik(&pose::from_rows(rounded, p));
    assert_eq!(solutions.len(), 8);
    assert!(solutions.iter().any(|s| apart(&PUMA_560, &s.q, &q) < 1e-6));
}

#[test]
fn the_four_inverse_solutions_of_seed_004() {
    let point = Point3::new(0.219_725_290_871_839_4, 0.120_036_473_484_936_97, 0.231_931_395_572_870_48);
    let solutions = LabRrr.ik_position(&point);
    for expected in [[0.5, 0.5, -0.5], [0.5, 0.0, 0.5], [0.5 - PI, PI, -0.5], [0.5 - PI, PI - 0.5, 0.5]] {
        let found = |q| apart(&LabRrr, q, &pose::column(expected)) < 1e-14;
        assert!(solutions.iter().any(|s| found(&s.q)), "{solutions}");
    }
    assert_eq!(solutions.len(), 4);
    let folded = LabRrr.ik_position(&Point3::new(0.0, 0.0, 0.168));
    assert_eq!(folded.len(), 1, "{folded}");
    let member = folded.iter().next().unwrap().families().last().unwrap().member_at(
        &LabRrr,
        &Point3::new(0.0, 0.0, 0.168),
        0.7,
    );
    assert!(matches!(member, Slot::Solved(s) if s.q.y == 0.7 && s.residual < 8.0 * EPS));
    let far = LabRrr.ik_position(&Point3::new(1.0_f32, 0.0, 0.168));
    assert!(far.slots().iter().all(|slot| matches!(slot, Slot::Empty(Reason::OutOfReach { .. }))));
}

#[test]
fn folded_onto_the_first_axis_the_residual_stays_small() {
    // Both figures have collapsed but for round-off, and no window may grow by the other.
    for bits in [
        [0xbfc6_4dee_cd86_2c50_u64, 0xbe53_76ed_17d6_c3fc, 0x4009_21fb_5444_2d32],
        [0xc001_a335_04fb_6837, 0x3fb2_eea0_8672_29a0, 0x4009_21fb_5444_2d32],
    ] {
        let q = pose::column(bits.map(f64::from_bits));
        let solutions = LabRrr.ik_position(&Point3 { coords: LabRrr.fk(&q).translation.vector });
        assert!(!solutions.is_empty());
        assert!(solutions.iter().all(|solution| solution.residual <= 13.0 * EPS), "{solutions}");
    }
}

#[test]
fn a_merged_slot_names_the_slot_that_holds_the_solution() {
    let stretched = math::atan2(-0.4318, 0.0203);
    let mut chained = 0;
    for (q3, q5) in [(stretched, 0.0), (stretched, PI), (stretched + PI, 0.0), (stretched + PI, PI)] {
        let solutions = PUMA_560.ik(&PUMA_560.fk(&pose::column([0.3, 0.2, q3, 0.1, q5, 0.2])));
        for (branch, slot) in solutions.branches() {
            if let Slot::Merged { with } = slot {
                assert!(matches!(solutions.get(*with), Slot::Solved(_)), "{branch}\n{solutions}");
                assert_eq!(solutions.solution(branch), solutions.get(*with).solution());
                chained += usize::from(with.wrist != branch.wrist && with.elbow != branch.elbow);
            }
        }
    }
    assert!(chained >= 2, "{chained} slots are two mergers away from their solution");
}

#[test]
fn what_cannot_be_held_on_to_takes_the_convention() {
    let q = pose::column([0.3, 0.5, -0.2, 0.4, 0.0, 0.7]);
    let pose = PUMA_560.fk(&q);
    let convention = PUMA_560.ik(&pose);
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(PUMA_560.ik_holding(&pose, &pose::column([value; 6])), convention);
    }
    // What is a number is held on to, however many turns it is, beside others that are not.
    for q4 in [0.4, 0.4 + 20.0 * PI, 1e300, -f64::MAX] {
        let held = PUMA_560.ik_holding(&pose, &pose::column([f64::NAN, 0.0, 0.0, q4, 0.0, 0.0]));
        assert_eq!(held.len(), convention.len(), "{held}");
        let family = held.iter().find(|s| !s.is_isolated()).unwrap();
        assert!(math::wrap(family.q[3] - math::wrap(q4)).abs() < 1e-15);
    }
    let folded = Point3::new(0.0, 0.0, 0.168);
    let held = LabRrr.ik_position_holding(&folded, &pose::column([f64::NAN; 3]));
    assert_eq!(held, LabRrr.ik_position(&folded));
}

#[test]
fn numbers_that_are_no_arm_are_said_so() {
    let mut arm = Figures::<false>::random(&mut Random(11), true);
    (arm.offset, arm.coupled) = ([0.0; 6], false);
    let pose = arm.fk(&pose::column([0.3, 0.5, -0.2, 0.4, 0.6, 0.7]));
    let says = |arm: Figures<false>| {
        let no_arm =
            |slots: &[Slot<f64, 6, Posture>]| slots.iter().all(|slot| *slot == Slot::Empty(Reason::NotAnArm));
        assert!(no_arm(arm.ik(&pose).slots()), "{arm:?}\n{}", arm.ik(&pose));
    };
    assert!(!arm.ik(&pose).is_empty());
    for wild in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, 1e-200] {
        says(Figures { links: [wild, wild], a1: 0.0, lateral: 0.0, tool: [0.0; 3], ..arm });
    }
    for wild in [f64::NAN, f64::INFINITY] {
        says(Figures { offset: [0.0, wild, 0.0, 0.0, 0.0, 0.0], ..arm });
        says(Figures { offset: [0.0, 0.0, 0.0, wild, 0.0, 0.0], ..arm });
        says(Figures { twist: wild, ..arm });
        says(Figures { lateral: wild, ..arm });
    }
    says(Figures { links: [0.0; 2], a1: 0.0, lateral: 0.0, tool: [0.0; 3], ..arm });
    // Small and large arms are arms.
    for size in [1e-30, 1e30] {
        let links = arm.links.map(|link| size * link);
        let arm =
            Figures { links, a1: 0.0, lateral: 0.0, tool: [0.0; 3], base: (arm.base.0, [0.0; 3]), ..arm };
        judge::<f64, _>(&arm, &pose::column([0.3, 0.5, 1.2, 0.4, 0.6, 0.7]), 16.0);
    }
}
