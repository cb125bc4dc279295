//! Arms of two to five joints: each structure against a multistart of its own forward kinematics, in both precisions, and what is
//! said of poses that are none of the arm's.

use std::f64::consts::PI;

use kin_runtime::prelude::*;
use kin_runtime::{Boundary, DynArm, DynOutcome, JointKind, Singularity, math};
use nalgebra::{SMatrix, Vector6};
use tests::invented::*;
use tests::sample::Sampler;

fn slides<const N: usize, A: Arm<N>>(joint: usize) -> bool {
    A::JOINTS[joint].kind == JointKind::Prismatic
}

fn apart<const N: usize, A: Arm<N>>(arm: &A, a: &Joints<f64, N>, b: &Joints<f64, N>) -> f64 {
    let way =
        |i: usize| if slides::<N, A>(i) { (a[i] - b[i]) / arm.reach() } else { math::wrap(a[i] - b[i]) };
    (0..N).map(|i| way(i).abs()).fold(0.0, f64::max)
}

fn random_joints<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) -> Joints<f64, N> {
    let angles = random.angles::<N>();
    Joints::from_fn(
        |i, _| if slides::<N, A>(i) { random.between(-1.0, 1.0) * arm.reach() } else { angles[i] },
    )
}

/// How far a pose misses another, as the rows of a Jacobian count; for a position the turn is left out.
fn missed<const N: usize, A: Arm<N>>(
    arm: &A,
    to: &Pose<f64>,
    q: &Joints<f64, N>,
    turns: f64,
) -> Vector6<f64> {
    let here = arm.fk(q);
    let shift = (to.translation.vector - here.translation.vector) / arm.reach();
    let turn = to.rotation.matrix() * here.rotation.matrix().transpose();
    let turn = (turn - turn.transpose()) * (0.5 * turns);
    Vector6::new(shift.x, shift.y, shift.z, turn[(2, 1)], turn[(0, 2)], turn[(1, 0)])
}

/// Whether the rotation is met too, which the antisymmetric part does not tell of half a turn.
fn meets<const N: usize, A: Arm<N>>(arm: &A, to: &Pose<f64>, q: &Joints<f64, N>, turns: f64) -> bool {
    let same = (arm.fk(q).rotation.matrix() - to.rotation.matrix()).amax() < 1e-9;
    missed(arm, to, q, turns).amax() < 1e-11 && (turns == 0.0 || same)
}

/// Every solution that damped Newton steps find from random starts: forward kinematics and Jacobian alone.
fn multistart<const N: usize, A: Arm<N>>(
    arm: &A,
    pose: &Pose<f64>,
    turns: f64,
    random: &mut Sampler,
) -> Vec<Joints<f64, N>> {
    let mut found: Vec<Joints<f64, N>> = Vec::new();
    for _ in 0..150 {
        let mut q = random_joints(arm, random);
        let mut damping = 1e-2;
        for _ in 0..60 {
            let miss = missed(arm, pose, &q, turns);
            if miss.amax() < 1e-14 {
                break;
            }
            let mut jacobian = kin_runtime::singularity::scaled(&arm.jacobian(&q), arm.reach());
            jacobian.fixed_rows_mut::<3>(3).scale_mut(turns);
            for (column, slide) in (0..N).map(|i| (i, slides::<N, A>(i))) {
                if slide {
                    jacobian.column_mut(column).scale_mut(arm.reach());
                }
            }
            let normal = jacobian.transpose() * jacobian + SMatrix::<f64, N, N>::identity() * damping;
            let Some(factors) = normal.cholesky() else { break };
            let mut step = factors.solve(&(jacobian.transpose() * miss));
            for i in (0..N).filter(|i| slides::<N, A>(*i)) {
                step[i] *= arm.reach();
            }
            let next = q + step;
            let better = missed(arm, pose, &next, turns).norm() < miss.norm();
            (q, damping) = if better { (next, (damping * 0.1_f64).max(1e-15)) } else { (q, damping * 10.0) };
        }
        if meets(arm, pose, &q, turns) && found.iter().all(|other| apart(arm, other, &q) > 1e-6) {
            found.push(q);
        }
    }
    found
}

fn same_sets<const N: usize, A: Arm<N>, B: Branch>(
    arm: &A,
    solutions: &Solutions<f64, N, B>,
    truth: &[Joints<f64, N>],
    pose: &Pose<f64>,
    turns: f64,
) {
    let all: Vec<_> = solutions.iter().map(|s| s.q).collect();
    for wanted in truth {
        let near = all.iter().map(|q| apart(arm, q, wanted)).fold(9.0, f64::min);
        assert!(near < 1e-7, "{} lost {wanted:?} by {near:e}\n{solutions}", A::NAME);
    }
    for (i, q) in all.iter().enumerate() {
        assert!(meets(arm, pose, q, turns), "{} gives {q:?}", A::NAME);
        assert!(all[..i].iter().all(|other| apart(arm, other, q) > 1e-7), "{} twice\n{solutions}", A::NAME);
        assert!(
            truth.iter().any(|t| apart(arm, t, q) < 1e-6),
            "{} {q:?} is not in the truth {truth:?}",
            A::NAME
        );
    }
    assert!(solutions.iter().all(|s| s.residual <= 64.0 * f64::EPSILON));
}

/// Poses come back as multistart finds them, and in single precision; a pose that is none of the arm's is refused.
fn poses<const N: usize, A: InverseKinematics<N>>(arm: &A, seed: u64) -> usize {
    let (mut random, mut count) = (Sampler::new(seed), 0);
    for round in 0..25 {
        let q = random_joints(arm, &mut random);
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        assert!(
            solutions.nearest(&q).is_some_and(|s| apart(arm, &s.q, &q) < 1e-7),
            "{} lost {q:?}\n{solutions}",
            A::NAME
        );
        if round < 4 {
            let truth = multistart(arm, &pose, 1.0, &mut random);
            same_sets(arm, &solutions, &truth, &pose, 1.0);
        }
        count += solutions.len();
        let narrow = Joints::<f32, N>::from_fn(|i, _| q[i] as f32);
        let back = arm.ik(&arm.fk(&narrow));
        let wide = |q: &Joints<f32, N>| Joints::<f64, N>::from_fn(|i, _| f64::from(q[i]));
        let near = back.iter().map(|s| apart(arm, &wide(&s.q), &wide(&narrow))).fold(9.0, f64::min);
        assert!(near < 3e-2, "{} lost {narrow:?} in single precision\n{back}", A::NAME);
        // Turned where it stands, by an angle that no joint makes up for.
        let turned = nalgebra::Rotation3::from_euler_angles(0.3, 0.2, -0.1) * pose.rotation;
        let other = Pose::from_parts(pose.translation, turned);
        for (branch, slot) in arm.ik(&other).branches() {
            match slot {
                Slot::Empty(Reason::Orientation { by }) => assert!(*by > 1e-9 && *by <= PI, "{branch}"),
                Slot::Empty(Reason::OutOfReach { by, .. }) => assert!(*by > 0.0, "{branch}"),
                Slot::Solved(s) => assert!(meets(arm, &other, &s.q, 1.0)),
                Slot::Merged { .. } | Slot::Empty(Reason::NoSuchBranch) => {}
                Slot::Empty(reason) => panic!("{} {branch}: {reason}", A::NAME),
            }
        }
    }
    count
}

/// The same of positions.
fn positions<const N: usize, A: PositionInverse<N>>(arm: &A, seed: u64) -> usize {
    let (mut random, mut count) = (Sampler::new(seed), 0);
    for round in 0..25 {
        let q = random_joints(arm, &mut random);
        let pose = arm.fk(&q);
        let point = Point3 { coords: pose.translation.vector };
        let solutions = arm.ik_position(&point);
        assert!(
            solutions.nearest(&q).is_some_and(|s| apart(arm, &s.q, &q) < 1e-7),
            "{} lost {q:?}\n{solutions}",
            A::NAME
        );
        if round < 4 {
            let truth = multistart(arm, &pose, 0.0, &mut random);
            same_sets(arm, &solutions, &truth, &pose, 0.0);
        }
        count += solutions.len();
        let narrow = Joints::<f32, N>::from_fn(|i, _| q[i] as f32);
        let back = arm.ik_position(&Point3 { coords: arm.fk(&narrow).translation.vector });
        let wide = |q: &Joints<f32, N>| Joints::<f64, N>::from_fn(|i, _| f64::from(q[i]));
        let near = back.iter().map(|s| apart(arm, &wide(&s.q), &wide(&narrow))).fold(9.0, f64::min);
        assert!(near < 3e-2, "{} lost {narrow:?} in single precision\n{back}", A::NAME);
    }
    count
}

#[test]
fn two_joints_give_every_position_back() {
    // Two for each structure: both bent ways in a plane, one way in space but for slides.
    let planar = [positions(&PlanarRr, 1), positions(&PlanarRrOffset, 2)];
    assert_eq!(planar, [50, 50]);
    let others = [
        positions(&SpatialRr, 3),
        positions(&SkewRr, 4),
        positions(&PolarRp, 5),
        positions(&SkewRp, 6),
        positions(&SlidePr, 7),
        positions(&SkewPr, 8),
    ];
    assert!(others.iter().all(|found| (25..=50).contains(found)), "{others:?}");
}

#[test]
fn three_joints_give_every_position_back() {
    assert!(positions(&SkewRrr, 9) >= 50);
    assert!(positions(&robots::Al5d, 10) >= 90);
    assert!(positions(&robots::LabRrr, 11) >= 90);
}

#[test]
fn poses_of_two_and_three_joints_come_back() {
    let found = [
        poses(&PlanarRr, 12),
        poses(&SkewRr, 13),
        poses(&PolarRp, 14),
        poses(&SkewPr, 15),
        poses(&SkewRrr, 16),
    ];
    assert_eq!(found, [25; 5]);
    assert_eq!([poses(&PlanarRrr, 17), poses(&robots::Planar3, 18)], [50, 50]);
    assert!(poses(&PlanarRrp, 19) >= 25);
}

#[test]
fn poses_of_four_joints_come_back() {
    let scara =
        [poses(&ScaraRrpr, 20), poses(&ScaraRrrp, 21), poses(&ScaraPrrr, 22), poses(&robots::Cobra600, 23)];
    assert_eq!(scara, [50; 4]);
    assert_eq!([poses(&WaistRrrr, 24), poses(&robots::Orion5, 25)], [100 / 2; 2]);
    assert_eq!(poses(&SkewRrrr, 26), 25);
}

#[test]
fn poses_of_five_joints_come_back() {
    assert!(poses(&RollRrrrr, 27) >= 50);
    assert!(poses(&SkewRrrrr, 28) >= 25);
    assert!(poses(&SlidingRrprr, 29) >= 25);
}

/// Folded onto an axis but for 10⁻ᵏ: where the point is says next to nothing of the joint, the orientation says everything.
#[test]
fn beside_an_axis_the_orientation_tells_its_joint() {
    let mut random = Sampler::new(30);
    for k in 4..=13 {
        for _ in 0..20 {
            let folded = PI - 10f64.powi(-k);
            let [one, two] = random.angles::<2>();
            let q = joints![one, two, folded];
            let solutions = robots::LabRrr.ik(&robots::LabRrr.fk(&q));
            let near = solutions.nearest(&q).map(|s| apart(&robots::LabRrr, &s.q, &q));
            assert!(near.is_some_and(|near| near < 1e-9), "{k} {q}\n{solutions}");
            let q = joints![one, folded];
            let solutions = robots::TwoLink.ik(&robots::TwoLink.fk(&q));
            let near = solutions.nearest(&q).map(|s| apart(&robots::TwoLink, &s.q, &q));
            assert!(near.is_some_and(|near| near < 1e-9), "{k} {q}\n{solutions}");
        }
    }
}

#[test]
fn what_is_off_the_surface_says_by_how_much() {
    let q = joints![0.4, 0.9];
    let point = Point3 { coords: PlanarRr.fk(&q).translation.vector };
    let above = |by: f64| PlanarRr.ik_position(&Point3::new(point.x, point.y, point.z + by));
    for by in [1e-12, 1e-9, 1e-5, 1e-2, 0.5] {
        for slot in above(by).slots() {
            let Slot::Empty(Reason::OutOfReach { by: found, towards: Boundary::Surface, .. }) = slot else {
                panic!("{slot:?}")
            };
            assert!((found - by).abs() < 1e-6 * by + 1e-15, "{found:e} for {by:e}");
        }
    }
    assert_eq!(above(1e-16).len(), 2);
    let beyond = PlanarRr.ik_position(&Point3::new(1.0_f64, 0.0, 0.2));
    for slot in beyond.slots() {
        let Slot::Empty(Reason::OutOfReach { by, .. }) = slot else { panic!("{slot:?}") };
        assert!((*by - 0.1_f64).abs() < 1e-12, "{by}");
    }
    assert!(beyond.to_string().contains("off the surface on which two joints carry the tool"), "{beyond}");
    // Stretched, the two ways are one.
    let stretched = PlanarRr.ik_position(&Point3::new(0.9, 0.0, 0.2));
    assert_eq!(stretched.len(), 1, "{stretched}");
    assert!(stretched.iter().all(|s| s.margins.elbow < 1e-7));
}

#[test]
fn an_orientation_that_is_not_the_arms_says_by_which_angle() {
    let q = joints![0.3, 0.5, 0.1, -0.4];
    let pose = robots::Cobra600.fk(&q);
    let tilt = nalgebra::Rotation3::from_axis_angle(&nalgebra::Vector3::x_axis(), 0.25_f64);
    let solutions = robots::Cobra600.ik(&Pose::from_parts(pose.translation, tilt * pose.rotation));
    assert!(solutions.is_empty());
    let told = solutions.slots().iter().filter(
        |slot| matches!(slot, Slot::Empty(Reason::Orientation { by }) if (*by - 0.25_f64).abs() < 1e-2),
    );
    assert!(told.count() >= 2, "{solutions}");
    assert!(solutions.to_string().contains("the tool cannot be turned like that there"), "{solutions}");
}

#[test]
fn a_point_on_the_first_axis_takes_that_joint_from_the_orientation() {
    // Axis 4 crosses axis 1 where the links lead back to it.
    let arm = robots::Orion5;
    let level = Point3::new(0.030309, 0.0, 0.0);
    let off = |q2: f64, q3: f64| {
        let frame = arm.frames(&joints![0.0, q2, q3, 0.0])[2];
        frame.translation.vector.x - level.x
    };
    let (mut low, mut high) = (0.5, 2.5);
    assert!(off(low, 1.0) * off(high, 1.0) < 0.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if off(low, 1.0) * off(middle, 1.0) > 0.0 { low = middle } else { high = middle }
    }
    for q1 in [0.0, 0.7, -2.5] {
        let q = joints![q1, low, 1.0, 0.8];
        let solutions = arm.ik(&arm.fk(&q));
        let own = solutions.nearest(&q).unwrap_or_else(|| panic!("{solutions}"));
        assert!(apart(&arm, &own.q, &q) < 1e-9 && own.is_isolated(), "{q}\n{solutions}");
    }
    // A quill on axis 1 turns with it: only the sum, or the difference, is known.
    let folded = ScaraFolding.fk(&joints![0.4, PI, 0.1, 0.3]);
    let solutions = ScaraFolding.ik(&folded);
    let family = solutions.iter().flat_map(|s| s.families()).next().unwrap_or_else(|| panic!("{solutions}"));
    assert_eq!((family.free(), family.singularity()), (0, Singularity::Shoulder));
    assert_eq!(family.to_string(), "theta1 free, theta4 follows");
    let Slot::Solved(member) = family.member(&ScaraFolding, &folded, 0.4) else { panic!("{solutions}") };
    assert!((member.q - joints![0.4, PI, 0.1, 0.3]).amax() < 1e-12, "{}", member.q);
}

#[test]
fn a_planar_arm_of_three_links_has_poses_and_no_positions() {
    // A position would leave one joint free in every solution: `ik_position` is not derived, `ik` is.
    let arm: &dyn DynArm = &robots::Planar3;
    assert_eq!(arm.inverse(), kin_runtime::Inverse::Pose);
    let two: &dyn DynArm = &PlanarRr;
    assert_eq!(two.inverse(), kin_runtime::Inverse::PoseOrPosition);
    let mut solved = 0;
    let mut count = |slot: kin_runtime::DynSlot<'_>| {
        solved += usize::from(matches!(slot.outcome, DynOutcome::Solved { .. }))
    };
    two.solve_position([0.6, 0.3, 0.2], &mut count).expect("it has one");
    assert_eq!(solved, 2);
    let derived = kin_gen::compile_text(
        "struct P(standard, m, deg); | theta | d | a | alpha | | q | 0 | 1 | 0 | | q | 0 | 1 | 0 | | q | 0 | 1 | 0 | ik: position;",
    );
    let refusal = derived.expect_err("it has no positions");
    assert!(refusal.contains("move the point that they carry in a surface only"), "{refusal}");
    let planar = kin_gen::compile_text(<robots::Planar3 as Arm<3>>::TABLE).expect("it compiles");
    let sentence =
        "`Planar3` has no inverse kinematics from a position: a position alone would leave joints free";
    assert!(kin_gen::back::rust::items(&planar, "::kin_runtime").contains(sentence));
}
