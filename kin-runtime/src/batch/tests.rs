//! Batches as they are without `std`, over arms that are plain products of matrices. Machines with wider instructions and
//! threads: `tests/tests/batch.rs`.

use super::{Batch, BatchError, Progress, Run};
use crate::pose::{self, Jacobian, Joints, Pose};
use crate::sample::{LAB_ARM, Random, STANFORD_ARM, Table};
use crate::{Arm, EulerZyx, InverseKinematics};
use core::ops::ControlFlow;

/// Two chunks and a rest, whatever goes side by side.
const COUNT: usize = 45;
/// More than is done between two words of progress.
const MANY: usize = 1500;

fn joints(random: &mut Random) -> Joints<f64, 6> {
    pose::column([(); 6].map(|()| random.angle()))
}

fn nowhere() -> Pose<f64> {
    EulerZyx { z: 0.1, y: 0.2, x: 0.3 }.at([1e9; 3])
}

fn forward<const WHICH: char>(arm: &Table<WHICH>) {
    let mut random = Random(31);
    let q = [(); COUNT].map(|()| joints(&mut random));
    let (mut poses, mut jacobians) = ([nowhere(); COUNT], [Jacobian::<f64, 6>::zeros(); COUNT]);
    arm.fk_batch(&q, &mut poses).unwrap();
    arm.jacobian_batch(&q, &mut jacobians).unwrap();
    for ((q, pose), jacobian) in q.iter().zip(&poses).zip(&jacobians) {
        assert_eq!((*pose, *jacobian), (arm.fk(q), arm.jacobian(q)));
    }
    let both = (poses, jacobians);
    (poses, jacobians) = ([nowhere(); COUNT], [Jacobian::zeros(); COUNT]);
    arm.fk_jacobian_batch(&q, &mut poses, &mut jacobians).unwrap();
    assert!((poses, jacobians) == both);
}

#[test]
fn what_goes_forward_is_what_goes_forward_alone() {
    forward(&LAB_ARM);
    forward(&STANFORD_ARM);
}

#[test]
fn what_goes_back_is_what_goes_back_alone() {
    let mut random = Random(32);
    let poses = [(); 20].map(|()| LAB_ARM.fk(&joints(&mut random)));
    let mut solutions = [const { None }; 20];
    LAB_ARM.ik_batch(&poses, &mut solutions).unwrap();
    for (pose, found) in poses.iter().zip(&solutions) {
        assert_eq!(*found, Some(LAB_ARM.ik(pose)));
    }
    assert_eq!(
        LAB_ARM.ik_batch(&poses, &mut solutions[1..]),
        Err(BatchError::Lengths { given: 20, places: 19 })
    );
}

#[test]
fn an_early_end_leaves_the_rest_alone() {
    let q = [Joints::<f64, 6>::zeros(); MANY];
    let mut poses = [nowhere(); MANY];
    let mut calls = 0;
    let mut told = |_| {
        calls += 1;
        ControlFlow::Break(())
    };
    let ended = Run::new().with_progress(&mut told).fk(&LAB_ARM, &q, &mut poses);
    let Err(BatchError::Stopped(Progress { done, total: MANY })) = ended else { panic!("{ended:?}") };
    assert!(calls == 1 && (1..MANY).contains(&done));
    let rest = LAB_ARM.fk(&q[0]);
    assert!(poses[..done].iter().all(|pose| *pose == rest));
    assert!(poses[done..].iter().all(|pose| *pose == nowhere()));
}
