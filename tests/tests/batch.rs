//! Batches: the bits of one by one, in every set of instructions that this machine has, on one thread and on several; and
//! nothing lost where slices do not fit or a run is ended early.

use std::ops::ControlFlow;

use kin_runtime::batch::{BatchError, Found, Instructions, Progress, Run};
use kin_runtime::prelude::*;
use nalgebra::Rotation3;
use robots::{Cobra600, Irb2400, LabArm, Panda, Planar3, Puma560, Stanford};
use tests::sample::Sampler;

dh! {
    /// Every joint has its home somewhere else.
    pub struct Homed(standard, m, deg);

    | joint | theta  | d   | a    | alpha |
    |-------|--------|-----|------|-------|
    | J1    | q + 30 | 0.4 | 0.1  | -90   |
    | J2    | q - 90 | 0   | 0.45 | 0     |
    | J3    | q - 20 | 0   | 0.05 | 90    |
    | J4    | q + 45 | 0.4 | 0    | -90   |
    | J5    | q - 60 | 0   | 0    | 90    |
    | J6    | q + 180 | 0.1 | 0   | 0     |
}

dh! {
    /// Drives that reach across joints.
    pub struct Coupled(standard, m, deg);

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.4 | 0.1  | -90   |
    | J2    | q     | 0   | 0.45 | 0     |
    | J3    | q     | 0   | 0.05 | 90    |
    | J4    | q     | 0.4 | 0    | -90   |
    | J5    | q     | 0   | 0    | 90    |
    | J6    | q     | 0.1 | 0    | 0     |

    couple: J3 += J2;
    couple: J6 += J5;
}

dh! {
    /// Homes and a length that are known when the program runs.
    pub struct Open(standard, m, deg);

    param upper = 0.45; param home2 = 90deg; param home5 = 0deg;

    | joint | theta     | d   | a     | alpha |
    |-------|-----------|-----|-------|-------|
    | J1    | q         | 0.4 | 0.1   | -90   |
    | J2    | q + home2 | 0   | upper | 0     |
    | J3    | q         | 0   | 0.05  | 90    |
    | J4    | q         | 0.4 | 0     | -90   |
    | J5    | q + home5 | 0   | 0     | 90    |
    | J6    | q         | 0.1 | 0     | 0     |
}

/// Numbers by their bits: 0 is not -0. NaN is NaN: which sign it has no standard says, and no compiler keeps.
trait Bits: Float {
    fn bits(self) -> u64;
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        if self.is_nan() { u64::MAX } else { self.to_bits() }
    }
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        if self.is_nan() { u64::MAX } else { u64::from(self.to_bits()) }
    }
}

fn bits<'a, T: Bits>(entries: impl IntoIterator<Item = &'a T>) -> Vec<u64> {
    entries.into_iter().map(|entry| entry.bits()).collect()
}

fn pose_bits<T: Bits>(pose: &Pose<T>) -> Vec<u64> {
    bits(pose.rotation.matrix().iter().chain(&pose.translation.vector))
}

/// Configurations, now and then one with a huge value, an infinite one, or none.
fn configurations<T: Float, const N: usize>(sampler: &mut Sampler, count: usize) -> Vec<Joints<T, N>> {
    let value = |sampler: &mut Sampler| match sampler.below(97) {
        0 => [f64::NAN, f64::INFINITY, -0.0, 1e300, 123_456.789][sampler.below(5)],
        _ => sampler.between(-7.0, 7.0),
    };
    (0..count).map(|_| Joints::from(std::array::from_fn(|_| T::lit(value(sampler))))).collect()
}

/// What no program gives: what stands in a place that was not written.
fn unwritten<T: Float, const N: usize>(count: usize) -> (Vec<Pose<T>>, Vec<Jacobian<T, N>>) {
    let mut pose = Pose::identity();
    pose.translation.vector.fill(T::lit(1234.5));
    (vec![pose; count], vec![Jacobian::repeat(T::lit(1234.5)); count])
}

/// All three batches of an arm.
fn as_one_by_one<T: Bits, A: Arm<N> + Sync, const N: usize>(
    arm: &A,
    q: &[Joints<T, N>],
    run: impl Fn() -> Run<'static>,
) {
    let (mut poses, mut jacobians) = unwritten(q.len());
    let (mut poses_of_both, mut jacobians_of_both) = unwritten(q.len());
    run().fk(arm, q, &mut poses).unwrap();
    run().jacobian(arm, q, &mut jacobians).unwrap();
    run().fk_jacobian(arm, q, &mut poses_of_both, &mut jacobians_of_both).unwrap();
    for (index, q) in q.iter().enumerate() {
        let at = || format!("{}, configuration {index}: {q:?}", A::NAME);
        assert_eq!(pose_bits(&poses[index]), pose_bits(&arm.fk(q)), "{}", at());
        assert_eq!(bits(&jacobians[index]), bits(&arm.jacobian(q)), "{}", at());
        let (pose, jacobian) = arm.fk_jacobian(q);
        assert_eq!(pose_bits(&poses_of_both[index]), pose_bits(&pose), "{}", at());
        assert_eq!(bits(&jacobians_of_both[index]), bits(&jacobian), "{}", at());
    }
}

#[test]
fn every_set_of_instructions_has_the_bits_of_one_by_one() {
    let here: Vec<Instructions> = Instructions::ALL.into_iter().filter(|set| set.are_here()).collect();
    // What the compiler may assume of this machine it has.
    assert_eq!(here[0], Instructions::Baseline);
    assert!(!cfg!(target_feature = "avx2") || here.contains(&Instructions::Avx2));
    println!("tried: {here:?}");
    let mut sampler = Sampler::new(71);
    for set in here {
        let run = || Run::new().at_most(set);
        as_one_by_one::<f64, _, _>(&Irb2400, &configurations(&mut sampler, 500), run);
        as_one_by_one::<f32, _, _>(&Irb2400, &configurations(&mut sampler, 500), run);
        as_one_by_one::<f64, _, _>(&Puma560, &configurations(&mut sampler, 500), run);
        as_one_by_one::<f64, _, _>(&Stanford, &configurations(&mut sampler, 500), run);
        as_one_by_one::<f64, _, _>(&Panda, &configurations(&mut sampler, 500), run);
        as_one_by_one::<f64, _, _>(&Planar3, &configurations(&mut sampler, 500), run);
    }
}

#[test]
fn every_length_has_the_bits_of_one_by_one() {
    let mut sampler = Sampler::new(72);
    for count in 0..=70 {
        as_one_by_one::<f64, _, _>(&Irb2400, &configurations(&mut sampler, count), Run::new);
        as_one_by_one::<f32, _, _>(&Irb2400, &configurations(&mut sampler, count), Run::new);
    }
}

/// Threads that are not all the machine's, so that the test is the same on each.
fn three_threads() -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("three threads")
}

#[test]
fn threads_change_nothing() {
    let mut sampler = Sampler::new(73);
    for count in [0, 1, 1023, 1024, 1025, 2049, 10_007] {
        let q = configurations::<f64, 6>(&mut sampler, count);
        three_threads().install(|| as_one_by_one(&Irb2400, &q, || Run::new().on_threads()));
    }
    let poses = poses(&Irb2400, &mut sampler, 3001);
    let mut solutions = vec![None; poses.len()];
    three_threads().install(|| Run::new().on_threads().ik(&Irb2400, &poses, &mut solutions)).unwrap();
    all_solved(&Irb2400, &poses, &solutions);
}

/// Poses that are reached, some of them with a straight wrist, and some that are out of reach or none at all.
fn poses<A: Arm<N>, const N: usize>(arm: &A, sampler: &mut Sampler, count: usize) -> Vec<Pose<f64>> {
    let pose = |index: usize| {
        let mut q = Joints::from(std::array::from_fn(|_| sampler.between(-3.0, 3.0)));
        if index.is_multiple_of(5) && N > 4 {
            q[4] = 0.0;
        }
        let mut pose = arm.fk(&q);
        match index % 11 {
            3 => pose.translation.vector *= 50.0,
            7 => pose.translation.vector.x = f64::NAN,
            9 => pose.rotation = Rotation3::from_matrix_unchecked(pose.rotation.matrix() * 2.0),
            _ => {}
        }
        pose
    };
    (0..count).map(pose).collect()
}

/// Every place holds what `ik` gives, to the bit: numbers are printed with as many digits as they need.
fn all_solved<A: InverseKinematics<N>, const N: usize>(
    arm: &A,
    poses: &[Pose<f64>],
    solutions: &[Found<f64, N, A>],
) {
    assert_eq!(poses.len(), solutions.len());
    for (pose, found) in poses.iter().zip(solutions) {
        assert_eq!(format!("{found:?}"), format!("{:?}", Some(arm.ik(pose))), "{}: {pose}", A::NAME);
    }
}

#[test]
fn solutions_are_those_of_one_by_one_in_every_set_of_instructions() {
    fn solved<A: InverseKinematics<N> + Sync, const N: usize>(arm: &A, sampler: &mut Sampler)
    where
        Found<f64, N, A>: Send,
    {
        for set in Instructions::ALL {
            for count in [0, 1, 7, 16, 45] {
                let poses = poses(arm, sampler, count);
                let mut solutions = vec![None; count];
                Run::new().at_most(set).ik(arm, &poses, &mut solutions).unwrap();
                all_solved(arm, &poses, &solutions);
            }
        }
    }
    let mut sampler = Sampler::new(74);
    solved(&Irb2400, &mut sampler);
    solved(&Puma560, &mut sampler);
    solved(&Stanford, &mut sampler);
    solved(&LabArm, &mut sampler);
    solved(&Cobra600, &mut sampler);
}

/// Solutions of poses most of which are far from singular ones, one in three out of a shoulder's reach.
fn solved_abreast<A, T: Bits>(arm: &A, sampler: &mut Sampler)
where
    A: InverseKinematics<6> + Sync,
    Found<T, 6, A>: Send,
{
    let q = |sampler: &mut Sampler| Joints::from(std::array::from_fn(|_| T::lit(sampler.between(-3.0, 3.0))));
    let mut poses: Vec<Pose<T>> = (0..400).map(|_| arm.fk(&q(sampler))).collect();
    poses[77].translation.vector.z = T::lit(f64::NAN);
    poses[78].translation.vector *= T::lit(1e30);
    for set in Instructions::ALL {
        let mut solutions = vec![None; poses.len()];
        // Places are used again: what other poses have left there must not be seen.
        poses.rotate_left(13);
        Run::new().at_most(set).ik(arm, &poses, &mut solutions).unwrap();
        poses.rotate_left(1);
        Run::new().at_most(set).ik(arm, &poses, &mut solutions).unwrap();
        for (pose, found) in poses.iter().zip(&solutions) {
            let (found, alone) = (found.as_ref().unwrap(), arm.ik(pose));
            // Numbers that are equal and not the same are zeros of different signs.
            for (found, alone) in found.slots().iter().zip(alone.slots()) {
                let same = match (found.solution(), alone.solution()) {
                    (Some(a), Some(b)) => bits(&a.q) == bits(&b.q) && a.residual.bits() == b.residual.bits(),
                    _ => true,
                };
                let (found, alone) = (format!("{found:?}"), format!("{alone:?}"));
                assert!(same && found == alone, "{}, {set:?}, {pose}: {found} {alone}", A::NAME);
            }
        }
    }
}

#[test]
fn poses_abreast_have_the_bits_of_one_by_one() {
    let mut sampler = Sampler::new(78);
    solved_abreast::<_, f64>(&Irb2400, &mut sampler);
    solved_abreast::<_, f32>(&Irb2400, &mut sampler);
    solved_abreast::<_, f64>(&Puma560, &mut sampler);
    solved_abreast::<_, f64>(&LabArm, &mut sampler);
    solved_abreast::<_, f64>(&Homed, &mut sampler);
    solved_abreast::<_, f32>(&Homed, &mut sampler);
    solved_abreast::<_, f64>(&Coupled, &mut sampler);
    solved_abreast::<_, f64>(&Open::NOMINAL, &mut sampler);
    // Parameters that leave what needs no branch: then poses are solved one by one.
    let homes = [(1e5, 0.0), (-2.5, 1.0), (1e-17, 3.2), (f64::NAN, 0.0), (0.5, f64::INFINITY)];
    for (home2, home5) in homes {
        solved_abreast::<_, f64>(&Open { home2, home5, ..Open::NOMINAL }, &mut sampler);
    }
    for upper in [1e120, 1e-120, 0.0, f64::NAN, f64::INFINITY] {
        solved_abreast::<_, f64>(&Open { upper, ..Open::NOMINAL }, &mut sampler);
    }
}

#[test]
fn slices_that_do_not_fit_are_refused_and_left_alone() {
    let q = configurations::<f64, 6>(&mut Sampler::new(75), 20);
    let untouched = || unwritten::<f64, 6>(19);
    let (mut poses, mut jacobians) = untouched();
    let refused = Err(BatchError::Lengths { given: 20, places: 19 });
    assert_eq!(Irb2400.fk_batch(&q, &mut poses), refused);
    assert_eq!(Irb2400.jacobian_batch(&q, &mut jacobians), refused);
    let (mut enough, mut others) = unwritten(20);
    assert_eq!(Irb2400.fk_jacobian_batch(&q, &mut poses, &mut others), refused);
    assert_eq!(Irb2400.fk_jacobian_batch(&q, &mut enough, &mut jacobians), refused);
    assert_eq!((poses, jacobians), untouched());
    assert_eq!((&enough, others), (&unwritten::<f64, 6>(20).0, unwritten(20).1));
    let mut solutions = vec![None; 21];
    let refused = Irb2400.ik_batch(&enough, &mut solutions);
    assert_eq!(refused, Err(BatchError::Lengths { given: 20, places: 21 }));
    assert!(solutions.iter().all(Option::is_none));
    assert_eq!(refused.unwrap_err().to_string(), "21 places for the results of 20");
}

/// Here, and on threads.
fn both_ways(check: impl Fn(Run<'static>) + Sync) {
    check(Run::new());
    three_threads().install(|| check(Run::new().on_threads()));
}

#[test]
fn progress_goes_up_to_all_of_it() {
    let q = configurations::<f64, 6>(&mut Sampler::new(76), 100_003);
    both_ways(|run| {
        let (mut poses, _) = unwritten::<f64, 6>(q.len());
        let mut heard = Vec::new();
        let mut tell = |progress: Progress| {
            heard.push(progress);
            ControlFlow::Continue(())
        };
        run.with_progress(&mut tell).fk(&Irb2400, &q, &mut poses).unwrap();
        assert!(heard.len() > 3 && heard.iter().all(|progress| progress.total == q.len()));
        assert!(heard.windows(2).all(|pair| pair[0].done < pair[1].done));
        assert_eq!(heard.last().unwrap().done, q.len());
    });
    // An end at the end is none; of nothing nobody is told.
    let (mut poses, _) = unwritten::<f64, 6>(9);
    let mut stop = |_| ControlFlow::Break(());
    assert_eq!(Run::new().with_progress(&mut stop).fk(&Irb2400, &q[..9], &mut poses), Ok(()));
    let mut never = |progress| panic!("{progress:?}");
    assert_eq!(Run::new().with_progress(&mut never).fk(&Irb2400, &q[..0], &mut []), Ok(()));
}

#[test]
fn an_early_end_keeps_what_is_done_and_leaves_the_rest_alone() {
    let q = configurations::<f64, 6>(&mut Sampler::new(77), 100_003);
    both_ways(|run| {
        let (mut poses, mut jacobians) = unwritten(q.len());
        let mut calls = 0;
        let mut tell = |_| {
            calls += 1;
            if calls == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let ended = run.with_progress(&mut tell).fk_jacobian(&Irb2400, &q, &mut poses, &mut jacobians);
        let Err(BatchError::Stopped(Progress { done, total })) = ended else { panic!("{ended:?}") };
        assert!(calls == 2 && total == q.len() && 0 < done && done < total);
        for (index, q) in q.iter().enumerate().take(done) {
            let (pose, jacobian) = Irb2400.fk_jacobian(q);
            assert_eq!(pose_bits(&poses[index]), pose_bits(&pose));
            assert_eq!(bits(&jacobians[index]), bits(&jacobian));
        }
        assert_eq!((poses.split_off(done), jacobians.split_off(done)), unwritten(total - done));
    });
}
