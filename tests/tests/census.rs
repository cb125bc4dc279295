//! Seed 003, tasks 1 to 3: inverse kinematics for many positions, how many solutions there are along the way, the one closest to
//! the current configuration, and in a singular pose the previous value of the joint.

use kin_runtime::Census;
use kin_runtime::prelude::*;
use robots::ElbowWrist;
use tests::sample::Sampler;

/// Poses of joint values that move evenly.
fn line(from: [f64; 6], to: [f64; 6], count: u32) -> Vec<Joints<f64, 6>> {
    let (from, to) = (Joints::from(from), Joints::from(to));
    (0..=count).map(|i| from + (to - from) * (f64::from(i) / f64::from(count))).collect()
}

/// Task 2: at many positions; all eight solutions where the wrist centre is off axis 1 and within 0.2 m and 1.8 m of the shoulder.
#[test]
fn every_position_has_its_eight_solutions() {
    let mut random = Sampler::new(101);
    for _ in 0..2_000 {
        let q = Joints::from(random.angles());
        let pose = ElbowWrist.fk(&q);
        let solutions = ElbowWrist.ik(&pose);
        let census = solutions.census();
        assert_eq!(census, Census { isolated: 8, families: 0, merged: 0 }, "{solutions}");
        assert!(solutions.nearest(&q).is_some_and(|found| (found.q - q).amax() < 1e-7), "{solutions}");
    }
}

/// Task 3: the count along the way, and the solution closest to where the arm is.
#[test]
fn the_closest_solution_is_followed_and_the_others_are_counted() {
    // Joint 5 passes 0 at the middle; joint 3 ends at 0, stretched.
    let path = line([-0.9, 0.3, -0.9, 0.6, 0.8, 0.1], [0.8, 1.0, 0.0, -0.5, -0.8, 0.3], 60);
    let poses = path.iter().map(|q| ElbowWrist.fk(q));
    let stops: Vec<_> = ElbowWrist.track(&path[0], poses).counted().collect();
    assert_eq!(stops.len(), 61);
    for (index, (stop, q)) in stops.iter().zip(&path).enumerate() {
        let Step::Continuous(at) = &stop.step else { panic!("{index}: {stop:?}") };
        match index {
            // The wrist is straight for the posture that was followed and for its mirror image with the other shoulder.
            30 => {
                assert_eq!((stop.count.families, stop.count.merged), (2, 2), "{stop:?}");
                assert_eq!(stop.held.iter().collect::<Vec<_>>(), [3, 5]);
                assert!((at.q[3] + at.q[5] - q[3] - q[5]).abs() < 1e-9);
            }
            // Both elbows meet: each shoulder has one with two wrists.
            60 => assert_eq!((stop.count.isolated, stop.count.merged), (4, 4), "{stop:?}"),
            _ => {
                assert_eq!(stop.count, Census { isolated: 8, families: 0, merged: 0 }, "{index}");
                assert!((at.q - q).amax() < 1e-7 && stop.held.is_empty(), "{index}");
            }
        }
    }
    assert_eq!(stops[30].count.to_string(), "4 solutions and 2 families");
    assert_eq!(stops[60].count.to_string(), "4 solutions");
}

/// Beyond 1.8 m there is none, and the arm waits where it is.
#[test]
fn out_of_reach_there_is_no_solution() {
    let start = joints![0.0, 0.2, -0.6, 0.4, 0.7, 0.1];
    let mut pose = ElbowWrist.fk(&start);
    let mut counts = Vec::new();
    let poses: Vec<_> = (0..40)
        .map(|_| {
            pose.translation.vector.y += 0.02;
            pose
        })
        .collect();
    for (stop, pose) in ElbowWrist.track(&start, poses.iter().copied()).counted().zip(&poses) {
        let far = (pose.translation.vector - Point3::new(0.0, 0.0, 0.3).coords).norm() > 1.8;
        assert_eq!(far, stop.count.total() == 0, "{stop:?}");
        assert_eq!(far, matches!(stop.step, Step::Blocked(Reason::OutOfReach { .. })), "{stop:?}");
        counts.push(stop.count.total());
    }
    assert!(counts.contains(&8) && counts.ends_with(&[0]), "{counts:?}");
}

/// "When a singularity situation arises … we can revert back to the previous non-singular solution for this joint."
#[test]
fn a_singular_pose_keeps_the_previous_value_of_the_joint() {
    let (mut random, mut kept) = (Sampler::new(102), 0);
    for _ in 0..500 {
        let before = Joints::from(random.angles());
        let mut straight = before;
        straight[4] = 0.0;
        let pose = ElbowWrist.fk(&straight);
        let found = ElbowWrist.ik_near(&pose, &before).expect("the pose is the arm's");
        // Some other branch may be nearer; where this one is taken joint 4 stays, and joint 6 takes what is left.
        if found.solution.is_isolated() {
            continue;
        }
        kept += 1;
        assert!((found.q[3] - before[3]).abs() < 1e-13, "{found:?} {before}");
        assert!((ElbowWrist.fk(&found.q).translation.vector - pose.translation.vector).norm() < 1e-14);
    }
    assert!(kept > 150, "{kept}");
}
