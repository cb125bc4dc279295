//! Nothing allocates: a counting allocator sees none of the library's calls, singular poses and refusals among them.

use std::hint::black_box;
use std::ops::ControlFlow;

use allocation_counter::{AllocationInfo, measure};
use kin_runtime::batch::Run;
use kin_runtime::prelude::*;
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use nalgebra::Point3;
use robots::{Irb2400, LabRrr, Puma560, Stanford};
use tests::sample::Sampler;

/// Configurations of each arm.
const TRIES: usize = 50;

/// Calls something for configurations of which half are next to or at a singular wrist.
fn none_for<A: Arm<N>, const N: usize>(arm: &A, calls: impl Fn(&A, &Joints<f64, N>)) {
    let mut sampler = Sampler::new(23);
    for index in 0..TRIES {
        let mut q: Joints<f64, N> = Joints::zeros();
        q.iter_mut().for_each(|angle| *angle = sampler.between(-3.0, 3.0));
        if index % 2 == 0 && N > 4 {
            q[4] = 10_f64.powi(-(index as i32)) * f64::from(u8::from(index % 4 == 0));
        }
        let seen = measure(|| calls(arm, &q));
        assert_eq!(seen.count_total, 0, "{}: {} bytes at {q:?}", A::NAME, seen.bytes_total);
    }
}

/// Everything that asks for joints by the pose of the tool.
fn inverse<A: InverseKinematics<6>>(arm: &A, q: &Joints<f64, 6>) {
    let pose = arm.fk(q);
    let limits = arm.limits();
    let solutions = arm.ik(&pose);
    black_box(solutions.within(&limits).iter().count());
    black_box(solutions.windings(&limits).count());
    black_box((solutions.nearest(q).is_some(), arm.ik_near_within(&pose, q, &limits).is_ok()));
    black_box(arm.track(q, [pose, pose]).count());
    let mut far = pose;
    far.translation.vector *= 100.0;
    black_box(arm.ik(&far));
}

/// The forward half, and rates of singular values.
fn forward<A: Arm<N>, const N: usize>(arm: &A, q: &Joints<f64, N>) {
    black_box((arm.fk(q), arm.frames(q), arm.jacobian(q), arm.fk_jacobian(q)));
}

#[test]
fn the_counter_counts() {
    assert_eq!(measure(|| drop(black_box(vec![1_u8]))).count_total, 1);
}

#[test]
fn forward_kinematics_and_jacobians_allocate_nothing() {
    none_for(&Irb2400, forward);
    none_for(&Puma560, forward);
    none_for(&robots::Panda, forward);
}

#[test]
fn inverse_kinematics_allocates_nothing() {
    none_for(&Irb2400, inverse);
    none_for(&Puma560, inverse);
    none_for(&Stanford, inverse);
    none_for(&LabRrr, |arm, q| {
        black_box(arm.ik_position(&Point3::from(arm.fk(q).translation.vector)));
    });
}

#[test]
fn trajectories_allocate_nothing() {
    none_for(&Irb2400, |_, q| {
        let limits = RateLimits::uniform(1.0, 2.0);
        let moved = Trajectory::new(&Joints::zeros(), q, &limits, Shared::Duration).unwrap();
        black_box(moved.samples(20.0).unwrap().count());
    });
}

#[test]
fn batches_allocate_nothing() {
    let mut sampler = Sampler::new(29);
    let q: Vec<Joints<f64, 6>> = (0..5000).map(|_| Joints::from(sampler.angles())).collect();
    let mut poses = vec![Pose::identity(); q.len()];
    let mut jacobians = vec![Jacobian::<f64, 6>::zeros(); q.len()];
    let mut solutions = vec![None; q.len()];
    let mut calls = 0;
    let mut told = |_| {
        calls += 1;
        ControlFlow::Continue(())
    };
    let mut batches = |mut run: Run<'_>| {
        run.fk(&Irb2400, &q, &mut poses).unwrap();
        run.jacobian(&Irb2400, &q, &mut jacobians).unwrap();
        run.fk_jacobian(&Irb2400, &q, &mut poses, &mut jacobians).unwrap();
        run.ik(&Irb2400, &poses, &mut solutions).unwrap();
    };
    let none = |seen: AllocationInfo| assert_eq!(seen.count_total, 0, "{} bytes", seen.bytes_total);
    none(measure(|| batches(Run::new().with_progress(&mut told))));
    // In a pool of one thread all is done on the thread that counts, by the code that several threads have.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    pool.install(|| {
        batches(Run::new().on_threads());
        none(measure(|| batches(Run::new().on_threads())));
    });
    assert!(calls > 8);
}
