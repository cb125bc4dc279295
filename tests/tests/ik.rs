//! Inverse kinematics against the complete solution sets of the reference, and against its own forward kinematics.

use std::collections::BTreeMap;

use kin_runtime::prelude::*;
use kin_runtime::{Singularity, dexterity};
use tests::declared::{self, Declared, Inverse};
use tests::pose::difference;
use tests::product;
use tests::sample::Sampler;
use tests::score::{Score, distance, score};

/// The worst pose error of a returned solution, lengths relative to the reach.
const RESIDUAL: f64 = 1e-14;

fn invertible() -> impl Iterator<Item = (Declared, Inverse)> {
    declared::all().into_iter().filter_map(|arm| arm.inverse.map(|inverse| (arm, inverse)))
}

/// The scores of one arm by kind of case.
fn scores(arm: &Declared, inverse: Inverse) -> BTreeMap<String, Score> {
    let record = arm.record();
    let mut scores: BTreeMap<String, Score> = BTreeMap::new();
    for case in record.cases().ik {
        let solutions = inverse(&case.pose, &case.task);
        scores.entry(case.kind.clone()).or_default().add(score(&record, &case, &solutions));
    }
    scores
}

#[test]
fn random_poses_give_back_every_solution_and_nothing_else() {
    let mut arms = 0;
    for (arm, inverse) in invertible() {
        let random = scores(&arm, inverse)["random"];
        let wrong = (random.spurious, random.duplicates, random.unlisted, random.unwrapped);
        assert_eq!((random.found, wrong), (random.listed, (0, 0, 0, 0)), "{}: {random:?}", arm.name);
        assert!(random.worst <= RESIDUAL, "{}: {:e}", arm.name, random.worst);
        arms += 1;
    }
    // The 18 arms with a spherical wrist and two parallel axes, the Stanford arm, and six with two to four joints.
    assert_eq!(arms, 25);
}

/// Prints the score of every kind, singular and boundary poses included, and holds it.
#[test]
fn every_kind_of_pose_is_counted() {
    let mut kinds: BTreeMap<String, Score> = BTreeMap::new();
    for (arm, inverse) in invertible() {
        for (kind, score) in scores(&arm, inverse) {
            kinds.entry(kind).or_default().add(score);
        }
    }
    println!(
        "kind                          complete      solutions  families  spurious  unlisted  twice  worst"
    );
    for (kind, s) in &kinds {
        let complete = format!("{}/{}", s.complete, s.cases);
        let solutions = format!("{}/{}", s.found, s.listed);
        let families = format!("{}/{}", s.families_found, s.families_listed);
        println!(
            "{kind:<28} {complete:>9} {solutions:>14} {families:>9} {:>9} {:>9} {:>6}  {:.1e}",
            s.spurious, s.unlisted, s.duplicates, s.worst
        );
        assert_eq!((s.found, s.families_found), (s.listed, s.families_listed), "{kind}");
        assert_eq!((s.spurious, s.duplicates, s.unwrapped), (0, 0, 0), "{kind}");
        assert!(s.worst <= RESIDUAL, "{kind}: {:e}", s.worst);
        // Two arms reach six of these poses with two wrists near their singularity, of which the data lists one.
        let known = if kind == "near_wrist" { 12 } else { 0 };
        assert_eq!(s.unlisted, known, "{kind}");
    }
    for kind in ["far_unreachable", "off_manifold"] {
        assert_eq!(kinds[kind].returned, 0, "{kind}");
    }
}

#[test]
fn the_joints_a_pose_came_from_come_back() {
    let mut sampler = Sampler::new(5);
    for (arm, inverse) in invertible() {
        let record = arm.record();
        let kinds = record.kinds();
        for round in 0..200 {
            let joint = |kind: &char, sampler: &mut Sampler| match kind {
                'R' => sampler.between(-3.1, 3.1),
                _ => sampler.between(0.3, 1.2),
            };
            let q: Vec<f64> = kinds.iter().map(|kind| joint(kind, &mut sampler)).collect();
            let pose = product::pose(&record, &q);
            let task = arm.tasks[round % arm.tasks.len()];
            let solutions = inverse(&pose, task);
            let nearest =
                solutions.iter().map(|s| distance(&kinds, s, &q, &[])).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-6, "{}: {q:?} comes back {nearest:e} away", arm.name);
            for s in &solutions {
                let mut off = difference(&product::pose(&record, s), &pose);
                if task == "position" {
                    off.rotation = 0.0;
                }
                let off = off.relative(record.reach());
                assert!(off <= RESIDUAL, "{}: {q:?} gives {s:?}, off by {off:e}", arm.name);
            }
        }
    }
}

fn single_precision<const N: usize, A: InverseKinematics<N>>(arm: &A, sampler: &mut Sampler) {
    let reach = arm.reach() as f32;
    let mut regular = 0;
    for _ in 0..200 {
        let q = Joints::<f32, N>::from_fn(|_, _| sampler.between(-3.1, 3.1) as f32);
        // The rounding of the pose alone moves the joints by ε over the smallest singular value.
        if dexterity(arm, &q).margin < 0.01 {
            continue;
        }
        regular += 1;
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        let mut nearest = f32::INFINITY;
        for s in solutions.iter() {
            let back = arm.fk(&s.q);
            let position = (back.translation.vector - pose.translation.vector).amax() / reach;
            let rotation = (back.rotation.matrix() - pose.rotation.matrix()).amax();
            assert!(
                position.max(rotation) < 64.0 * f32::EPSILON,
                "{}: {q} {position:e} {rotation:e}",
                A::NAME
            );
            let moved = (s.q - q).map(|x| tests::score::wrap(f64::from(x)).abs() as f32).amax();
            nearest = nearest.min(moved);
        }
        assert!(nearest < 1e-3, "{}: {q} comes back {nearest:e} away", A::NAME);
    }
    assert!(regular > 50, "{}: {regular}", A::NAME);
}

#[test]
fn single_precision_round_trips() {
    let mut sampler = Sampler::new(6);
    single_precision(&robots::LabArm, &mut sampler);
    single_precision(&robots::Puma560, &mut sampler);
    single_precision(&robots::Kr16, &mut sampler);
    single_precision(&robots::Anthropomorphic, &mut sampler);
}

/// By how many ε at most a residual differs from what forward kinematics of the joint values misses.
fn misjudged<A: InverseKinematics<6>>(arm: &A, sampler: &mut Sampler) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..500 {
        let pose = arm.fk(&Joints::from(sampler.angles::<6>()));
        let scale = pose.translation.vector.amax().max(arm.reach());
        for s in arm.ik(&pose).iter() {
            let back = arm.fk(&s.q);
            let position = (back.translation.vector - pose.translation.vector).amax() / scale;
            let missed = position.max((back.rotation.matrix() - pose.rotation.matrix()).amax());
            worst = worst.max((s.residual - missed).abs());
        }
    }
    worst / f64::EPSILON
}

/// Far from singular poses it is made with sines that were not taken of the joint values.
#[test]
fn residuals_are_those_of_forward_kinematics() {
    let mut sampler = Sampler::new(12);
    for worst in [
        misjudged(&robots::Irb2400, &mut sampler),
        misjudged(&robots::Puma560, &mut sampler),
        misjudged(&robots::LabArm, &mut sampler),
        misjudged(&robots::Kr16, &mut sampler),
        misjudged(&robots::Rv4fr, &mut sampler),
        misjudged(&robots::Anthropomorphic, &mut sampler),
        misjudged(&robots::ElbowWrist, &mut sampler),
    ] {
        assert!(worst < 6.0, "{worst} ε");
    }
}

#[test]
fn slots_keep_their_branch_from_pose_to_pose() {
    let mut sampler = Sampler::new(7);
    for _ in 0..50 {
        let q = Joints::from(sampler.angles::<6>());
        let pose = robots::Irb2400.fk(&q);
        let Some(here) = robots::Irb2400.ik(&pose).nearest(&q).copied() else { panic!("{q} is lost") };
        // A small step that stays away from the singular poses keeps the branch.
        if dexterity(&robots::Irb2400, &q).margin < 0.05 {
            continue;
        }
        let near = q.map(|x| x + 1e-3);
        let solutions = robots::Irb2400.ik(&robots::Irb2400.fk(&near));
        let Slot::Solved(there) = solutions.get(here.branch) else { panic!("{} is empty", here.branch) };
        assert!((there.q - near).map(|x| tests::score::wrap(x).abs()).amax() < 1e-9);
    }
}

#[test]
fn nearest_moves_the_largest_joint_least() {
    let mut sampler = Sampler::new(8);
    for _ in 0..100 {
        let q = Joints::from(sampler.angles::<6>());
        let from = Joints::from(sampler.angles::<6>());
        let solutions = robots::Tx40.ik(&robots::Tx40.fk(&q));
        let moved = |s: &Joints<f64, 6>| (s - from).map(|x| tests::score::wrap(x).abs()).amax();
        let least = solutions.iter().map(|s| moved(&s.q)).fold(f64::INFINITY, f64::min);
        let nearest = solutions.nearest(&from).map(|s| moved(&s.q));
        assert!(nearest.is_some_and(|x| x <= least + 1e-12), "{nearest:?} {least}");
    }
}

#[test]
fn limits_empty_slots_and_say_by_how_much() {
    let mut sampler = Sampler::new(9);
    let (arm, limits) = (robots::Puma560, robots::Puma560.limits());
    let mut refused = 0;
    for _ in 0..200 {
        let q = Joints::from(sampler.angles::<6>());
        let all = arm.ik(&arm.fk(&q));
        let within = all.within(&limits);
        let inside = |q: &Joints<f64, 6>| {
            (0..6).all(|i| {
                let (low, high) = limits.range(i).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
                // A turn more or less is the same place.
                [-1.0, 0.0, 1.0].iter().any(|turns| {
                    let x = q[i] + turns * std::f64::consts::TAU;
                    low - 1e-12 <= x && x <= high + 1e-12
                })
            })
        };
        for (branch, slot) in within.branches() {
            match (slot, all.get(branch)) {
                (Slot::Solved(s), Slot::Solved(before)) => assert!(s == before && inside(&s.q)),
                (Slot::Empty(Reason::Limit { joint, by }), Slot::Solved(before)) => {
                    assert!(!inside(&before.q) && *joint < 6 && *by > 0.0);
                    refused += 1;
                }
                (slot, before) => assert_eq!(slot, before),
            }
        }
    }
    assert!(refused > 100, "{refused}");
}

#[test]
fn the_free_joint_of_a_family_may_be_chosen() {
    // Axes 4 and 6 of the Puma coincide at q5 = 0.
    let q = joints![0.3, -0.8, 0.6, 0.4, 0.0, 0.5];
    let pose = robots::Puma560.fk(&q);
    let solutions = robots::Puma560.ik(&pose);
    let families: Vec<_> = solutions.iter().flat_map(|s| s.families()).collect();
    assert_eq!(families.len(), 1);
    let family = families[0];
    assert_eq!(family.singularity(), Singularity::Wrist);
    assert_eq!(family.to_string(), "theta4 + theta6 = 0.9000");
    for value in [-3.0_f64, -1.0, 0.0, 0.4, 2.5] {
        let Slot::Solved(member) = family.member(&robots::Puma560, &pose, value) else {
            panic!("no member at {value}")
        };
        assert!((member.q[3] - value).abs() < 1e-9);
        let back = robots::Puma560.fk(&member.q).to_homogeneous();
        assert!((back - pose.to_homogeneous()).amax() < 1e-14);
    }
    // Nothing moves that need not: the member with the previous value of joint 4 is the previous configuration.
    let held = robots::Puma560.ik_holding(&pose, &q);
    let near = held.nearest(&q).map(|s| (s.q - q).amax());
    assert!(near.is_some_and(|x| x < 1e-12), "{near:?}");
}
