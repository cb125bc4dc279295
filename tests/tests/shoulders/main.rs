//! Arms whose first three axes meet: their families, factors, reasons and reach, with couplings, a base and a tool.

mod ends;

use std::f64::consts::PI;

use kin_runtime::math::wrap;
use kin_runtime::prelude::*;
use kin_runtime::singularity::{determinant, normalised};
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use kin_runtime::watch::{Factor, Factored, Watch};
use kin_runtime::{Boundary, Constraint, DynOutcome, Singularity};
use tests::invented::{Folding, Human, Twisted};
use tests::reliability::subject::{ByTool, Tried};
use tests::reliability::trial::complaints;
use tests::sample::Sampler;

dh! {
    /// Joint 4 slides.
    pub struct Crane(standard, m, deg);

    | joint | theta | d       | a    | alpha |
    |-------|-------|---------|------|-------|
    | J1    | q     | 0.3     | 0    | -90   |
    | J2    | q     | 0       | 0    | 90    |
    | J3    | q     | 0.1     | 0.05 | 90    |
    | J4    | 30    | q + 0.2 | 0    | 90    |
    | J5    | q     | 0.1     | 0.15 | 90    |
    | J6    | q     | 0.1     | 0    | 0     |
}

/// The largest difference of two joint vectors, angles modulo a turn, slides over the reach.
fn apart<A: Arm<6>>(arm: &A, a: &Joints<f64, 6>, b: &Joints<f64, 6>) -> f64 {
    let differences = (0..6).map(|i| match A::JOINTS[i].kind {
        kin_runtime::JointKind::Revolute => wrap(a[i] - b[i]),
        kin_runtime::JointKind::Prismatic => (a[i] - b[i]) / arm.reach(),
    });
    differences.fold(0.0, |most, way| f64::max(most, way.abs()))
}

fn random_joints<A: Arm<6>>(random: &mut Sampler) -> Joints<f64, 6> {
    let angles = random.angles::<6>();
    Joints::from_fn(|i, _| match A::JOINTS[i].kind {
        kin_runtime::JointKind::Revolute => angles[i],
        kin_runtime::JointKind::Prismatic => random.between(-0.8, 0.8),
    })
}

/// An arm that RELIABILITY.md does not have.
#[test]
fn a_slide_in_the_hand_comes_back() {
    let mut random = Sampler::new(4);
    assert_eq!(complaints::<f64, 6>(&Tried(Crane, ByTool), 4000, &mut random), Vec::<String>::new());
    assert_eq!(complaints::<f32, 6>(&Tried(Crane, ByTool), 4000, &mut random), Vec::<String>::new());
}

/// Their product is the determinant; each is in its range between any two times.
fn factored<A: Factored<6>>(arm: &A, apart: bool, seed: u64) {
    let mut random = Sampler::new(seed);
    for _ in 0..200 {
        let (from, to) = (random_joints::<A>(&mut random), random_joints::<A>(&mut random));
        let (factors, det) = (arm.factors(&from), determinant(&normalised(arm, &from)).expect("six joints"));
        assert!((factors.determinant() - det).abs() < 1e-14, "{}: {factors:?} {det}", A::NAME);
        assert!(factors.bend.is_some() && factors.shoulder.is_none() && factors.wrist.is_none());
        assert_eq!((factors.hand.is_some(), factors.elbow.is_some()), (apart, apart));
        assert!(factors.hand.zip(factors.elbow).is_none_or(|(hand, elbow)| factors.base == hand * elbow));
        let limits = RateLimits::uniform(random.between(0.5, 3.0), random.between(1.0, 9.0));
        let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration).expect("sound");
        let watch = Watch::new(arm, &trajectory);
        let width = trajectory.duration() * 10f64.powf(random.between(-4.0, 0.0));
        let start = random.between(0.0, trajectory.duration() - width);
        for factor in Factor::ALL {
            let Some((low, high)) = watch.factor_range(factor, start, start + width) else { continue };
            for k in 0..=20 {
                let value = watch.factors(start + width * f64::from(k) / 20.0).get(factor).expect("known");
                assert!(low - 1e-13 <= value && value <= high + 1e-13, "{} {factor:?} {width}", A::NAME);
            }
        }
    }
}

#[test]
fn factors_are_those_of_the_determinant() {
    factored(&Human::NOMINAL, true, 6);
    factored(&Folding, true, 7);
    factored(&Twisted, false, 8);
    factored(&Crane, true, 9);
    // Each is what the solver's margins measure in its own terms.
    let (arm, mut random) = (Human::NOMINAL, Sampler::new(10));
    for _ in 0..200 {
        let q = random_joints::<Human>(&mut random);
        let (factors, solutions) = (arm.factors(&q), arm.ik(&arm.fk(&q)));
        let solution = solutions.nearest(&q).filter(|s| (s.q - q).amax() < 1e-9).expect("itself");
        let [hand, elbow, bend] = [factors.hand, factors.elbow, factors.bend].map(Option::unwrap);
        let (margins, reach) = (solution.margins, arm.reach());
        assert!((hand.abs() - margins.wrist.unwrap() / reach).abs() < 1e-12);
        assert!((elbow.abs() - 0.4 * 0.35 / (reach * reach) * margins.elbow.sin()).abs() < 1e-12);
        assert!((bend.abs() - margins.shoulder.sin()).abs() < 1e-12);
    }
}

#[test]
fn a_shoulder_that_passes_straight_is_found_at_its_time() {
    let (from, to) = (joints![0.3, -0.4, 0.6, 0.4, 0.5, 0.2], joints![0.3, 0.6, 0.6, 0.4, 0.5, 0.2]);
    let limits = RateLimits::uniform(0.5, 1.0);
    let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration).expect("sound");
    let watch = Watch::new(&Human::NOMINAL, &trajectory);
    let all: Vec<_> = watch.factor_crossings(Factor::Bend, 0.0).collect();
    let [crossing] = all.as_slice() else { panic!("{all:?}") };
    // 1/2·0.5²/1 rad on the ramp of 0.5 s, and 0.275 rad at 0.5 rad/s.
    assert!(f64::abs(crossing.time - 1.05) < 1e-9 && f64::abs(crossing.q[1]) < 1e-9, "{crossing:?}");
    let spells: Vec<_> = watch.factor_spells(Factor::Bend, 0.1).map(|spell| spell.to_string()).collect();
    let words = "SINGULARITY: from t = 0.850 s to t = 1.250 s the shoulder is nearly straight";
    assert!(matches!(spells.as_slice(), [spell] if spell.starts_with(words)), "{spells:?}");
    assert!(watch.factor_crossings(Factor::Wrist, 0.0).next().is_none(), "it has no wrist");
}

#[test]
fn a_straight_shoulder_is_a_family() {
    let arm = Human::NOMINAL;
    for (q2, difference) in [(0.0, false), (PI, true)] {
        let q = joints![0.7, q2, 0.4, 0.9, -0.5, 0.3];
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        let solution = solutions.nearest(&q).expect("its own pose");
        let singular = solutions.iter().find(|s| (s.q[3] - 0.9).abs() < 1e-9 && !s.is_isolated());
        let family = singular.and_then(|s| s.family()).unwrap_or_else(|| panic!("{solution}\n{solutions}"));
        assert_eq!((family.singularity(), family.free()), (Singularity::Shoulder, 0));
        let Constraint::Sum { joints, difference: found, equals } = family.constraint() else { panic!() };
        assert_eq!((joints, found), ([0, 2], difference));
        let constant = if difference { 0.7 - 0.4 } else { 0.7 + 0.4 };
        assert!(wrap(equals - constant).abs() < 1e-14);
        assert!(family.constraint().missed_by(&q).is_some_and(|by| by < 1e-14));
        let sign = if difference { '-' } else { '+' };
        assert_eq!(family.to_string(), format!("theta1 {sign} theta3 = {constant:.4}"));
        // Shared evenly by convention, any member on demand, the nearest to the joints that were.
        let half = if difference { -0.5 } else { 0.5 };
        assert!((family.solution().q[2] - half * constant).abs() < 1e-14, "{family}");
        let Slot::Solved(member) = family.member(&arm, &pose, 0.7) else { panic!() };
        assert!((member.q - q).amax() < 1e-14);
        let Slot::Solved(nearest) = family.nearest(&arm, &pose, &q) else { panic!() };
        assert!((nearest.q - q).amax() < 1e-14);
        // -170° ≤ θ1 ≤ 170° and the same of θ3, one the other less a constant.
        let limit = 170f64.to_radians();
        let ranges = family.ranges(&arm, &pose, &arm.limits());
        for value in [-3.0, -2.8, -1.5, 0.0, 1.5, 2.8, 3.0] {
            let other = wrap(if difference { value - constant } else { constant - value });
            assert_eq!(ranges.contains(value), value.abs() <= limit && other.abs() <= limit, "{value}");
        }
        let warning = "SINGULARITY: There are infinite solutions for the value of theta1 and theta3. These angles will then \
                       assume symmetrical values.";
        assert!(solutions.to_string().contains(warning), "{solutions}");
        assert_eq!(family.solution().margins.shoulder, 0.0);
    }
}

/// The joint values at which a function of them vanishes, by halving along one joint; `None` if it keeps its sign.
fn vanishing(
    mut q: Joints<f64, 6>,
    joint: usize,
    f: impl Fn(&Joints<f64, 6>) -> f64,
) -> Option<Joints<f64, 6>> {
    let at = |value: f64, q: &mut Joints<f64, 6>| {
        q[joint] = value;
        f(q)
    };
    let grid: Vec<f64> = (0..=60).map(|k| -PI + PI * f64::from(k) / 30.0).collect();
    for ends in grid.windows(2) {
        let (mut low, mut high) = (ends[0], ends[1]);
        if at(low, &mut q) * at(high, &mut q) > 0.0 {
            continue;
        }
        let sign = at(low, &mut q);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if at(middle, &mut q) * sign > 0.0 { low = middle } else { high = middle }
        }
        at(high, &mut q);
        return Some(q);
    }
    None
}

#[test]
fn a_shoulder_on_axis_6_leaves_joint_6_free() {
    let arm = Human { fore: 0.35, ..Human::NOMINAL };
    // Without the offset along axis 5 the centre can come onto axis 6.
    let arm = Level { upper: arm.upper, fore: arm.fore };
    let centre = Point3::new(0.0, 0.0, 0.3);
    let off_axis = |q: &Joints<f64, 6>| {
        let frames = arm.frames(q);
        let (hand, arm) = (&frames[4], frames[4].inverse() * centre);
        assert!(hand.translation.vector.iter().all(|x| x.is_finite()));
        arm.x
    };
    let q = vanishing(joints![0.4, 0.8, -0.6, 1.1, 0.0, 0.5], 4, off_axis).expect("it crosses the axis");
    let pose = arm.fk(&q);
    let solutions = arm.ik(&pose);
    let free: Vec<_> = solutions
        .iter()
        .flat_map(|s| s.families())
        .filter(|family| family.singularity() == Singularity::Wrist)
        .collect();
    assert!(!free.is_empty(), "{solutions}");
    for family in &free {
        assert_eq!(family.free(), 5);
        assert_eq!(family.solution().q[5], 0.0);
        assert_eq!(family.solution().margins.wrist, Some(0.0));
        assert!(family.to_string().starts_with("theta6 free, theta1"), "{family}");
        for value in [-2.0, 0.3, 1.7] {
            let Slot::Solved(member) = family.member(&arm, &pose, value) else { panic!("{solutions}") };
            assert!((member.q[5] - value).abs() < 1e-15 && member.residual <= 16.0 * f64::EPSILON);
        }
    }
    let held = arm.ik_holding(&pose, &q);
    assert!(held.iter().any(|s| apart(&arm, &s.q, &q) < 1e-9), "{held}");
    let warning = "for the value of theta1, theta2, theta3 and theta6. By default, theta6 will assume the value 0.0000.";
    assert!(solutions.to_string().contains(warning), "{solutions}");
}

dh! {
    /// As [`Human`], axes 5 and 6 and the shoulder in one plane.
    pub struct Level(standard, m, deg);

    param upper = 0.4; param fore = 0.35;

    | joint | theta | d     | a    | alpha |
    |-------|-------|-------|------|-------|
    | J1    | q     | 0.3   | 0    | -90   |
    | J2    | q     | 0     | 0    | 90    |
    | J3    | q     | upper | 0    | -90   |
    | J4    | q     | 0     | fore | 0     |
    | J5    | q     | 0     | 0    | 90    |
    | J6    | q     | 0.1   | 0    | 0     |
}

#[test]
fn an_arm_folded_onto_axis_5_leaves_joint_5_free() {
    // With equal links the shoulder comes onto axis 5 where joint 4 folds the forearm back.
    let arm = Level { upper: 0.4, fore: 0.4 };
    for q4 in [PI / 2.0, -PI / 2.0] {
        let q = joints![0.4, 0.8, -0.6, q4, 0.7, 0.5];
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        let family =
            solutions.iter().flat_map(|s| s.families()).find(|f| f.singularity() == Singularity::Elbow);
        let Some(family) = family else { continue };
        assert_eq!(family.free(), 4);
        let held = arm.ik_holding(&pose, &q);
        assert!(held.iter().any(|s| apart(&arm, &s.q, &q) < 1e-7), "{held}");
        let Slot::Solved(member) = family.member(&arm, &pose, -1.0) else { panic!("{solutions}") };
        assert!((member.q[4] + 1.0).abs() < 1e-15);
        return;
    }
    panic!("neither side folds");
}

#[test]
fn what_is_out_of_reach_says_towards_what() {
    let arm = Human::NOMINAL;
    let q = joints![0.4, 0.8, -0.6, 1.1, 0.2, 0.5];
    let pose = arm.fk(&q);
    let far = Pose::from_parts((pose.translation.vector * 5.0).into(), pose.rotation);
    let solutions = arm.ik(&far);
    assert!(solutions.is_empty());
    for (branch, slot) in solutions.branches() {
        let Slot::Empty(Reason::OutOfReach { by, towards, theta1: None }) = slot else { panic!("{branch}") };
        assert!(*by > 0.5 && *towards == Boundary::OuterCircle);
    }
    assert!(solutions.to_string().contains("beyond the outer circle"));
    // The hand's offset keeps the shoulder outside a cylinder about axis 6, and an oblique shoulder has a cone.
    let (mut cylinder, mut cone) = (0, 0);
    let mut random = Sampler::new(6);
    for _ in 0..2_000 {
        let turn = arm.fk(&Joints::from(random.angles::<6>())).rotation;
        let along = turn * nalgebra::Vector3::new(0.0, 0.0, random.between(0.1, 0.6));
        let near = Pose::from_parts(along.into(), turn);
        let solutions = Folding.ik(&Pose::from_parts((near.translation.vector * 1e3).into(), turn));
        for slot in solutions.slots() {
            if let Slot::Empty(Reason::OutOfReach { by, towards, .. }) = slot {
                assert!(*by > 0.0);
                cylinder += usize::from(*towards == Boundary::HandCylinder);
                cone += usize::from(*towards == Boundary::ShoulderCone);
            }
        }
    }
    assert!(cylinder > 0 && cone > 0, "{cylinder} {cone}");
}

#[test]
fn limits_choice_and_paths_work_as_for_a_wrist() {
    let arm = Human::NOMINAL;
    let q = joints![0.4, 0.8, -0.6, 1.1, 0.2, 0.5];
    let pose = arm.fk(&q);
    let turned = q + joints![0.0, 2.0 * PI, 0.0, 0.0, 0.0, -2.0 * PI];
    let near = arm.ik_near(&pose, &turned).expect("its own pose");
    assert!((near.q - turned).amax() < 1e-13);
    let reasons = arm.ik(&pose).within(&arm.limits());
    for slot in reasons.slots() {
        if let Slot::Empty(Reason::Limit { joint, by }) = slot {
            assert!([0, 2].contains(joint) && *by > 0.0);
        }
    }
    // Through the straight shoulder and on: no flip.
    let path: Vec<_> = (0..=200)
        .map(|k| f64::from(k) / 100.0 - 1.0)
        .map(|t| arm.fk(&joints![0.4, 0.5 * t, -0.6, 1.1 + 0.1 * t, 0.2, 0.5]))
        .collect();
    let start = joints![0.4, -0.5, -0.6, 1.0, 0.2, 0.5];
    let mut last = start;
    for step in arm.track(&start, path) {
        let Step::Continuous(winding) = step else { panic!("{step:?}") };
        last = winding.q;
    }
    assert!((last - joints![0.4, 0.5, -0.6, 1.2, 0.2, 0.5]).amax() < 1e-6, "{last}");
}

#[test]
fn an_arm_behind_a_reference_answers_too() {
    let arm: &dyn kin_runtime::DynArm = &Human::NOMINAL;
    let q = [0.4, 0.8, -0.6, 1.1, 0.2, 0.5];
    let pose = arm.pose_at(&q).expect("six values");
    let (mut solved, mut labels) = (0, Vec::new());
    arm.solve_pose(&pose, &mut |slot| {
        labels.push(slot.branch.to_string());
        solved += usize::from(matches!(slot.outcome, DynOutcome::Solved { .. }));
    })
    .expect("it has an inverse");
    assert_eq!((labels.len(), labels[0].as_str()), (8, "noflip/up/right"));
    assert_eq!(solved, Human::NOMINAL.ik(&pose).len());
}

#[test]
fn no_arm_is_both() {
    // Its wrist centre would move on a sphere about its shoulder.
    let text = "struct Both(standard, m, deg);
        | joint | theta | d | a | alpha |
        | J1 | q | 0.3 | 0 | -90 |
        | J2 | q | 0 | 0 | 90 |
        | J3 | q | 0.4 | 0.1 | 90 |
        | J4 | q | 0.3 | 0 | -90 |
        | J5 | q | 0 | 0 | 90 |
        | J6 | q | 0.1 | 0 | 0 |";
    let derived = kin_gen::compile_text(text).unwrap_or_else(|m| panic!("{m}"));
    let kin_gen::model::Solver::None { reason, .. } = derived.solver else { panic!("{:?}", derived.solver) };
    let surface = "joints move the point that they carry in a surface only, whatever their values";
    assert_eq!(reason, format!("the first three {surface}; seen from the tool, the first three {surface}"));
}
