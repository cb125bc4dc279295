//! Paths of poses followed through singular poses: the joints that made the path come back, and nothing flips.

use std::f64::consts::PI;

use kin_runtime::ik::Base;
use kin_runtime::prelude::*;
use kin_runtime::private::SolveWrist;
use kin_runtime::{Cause, JointKind};
use nalgebra::Vector6;
use tests::motion::tracking;
use tests::sample::Sampler;

/// Poses of a path.
const POSES: usize = 41;

/// Paths for each arm and each singular set.
const PATHS: usize = if cfg!(debug_assertions) { 100 } else { 500 };

/// The singular set that a path is led through.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Aim {
    Wrist,
    Shoulder,
    Elbow,
    WristAndShoulder,
    Nothing,
}

const AIMS: [Aim; 5] = [Aim::Wrist, Aim::Shoulder, Aim::Elbow, Aim::WristAndShoulder, Aim::Nothing];

/// The wrist centre's place along the common normal of axes 1 and 2: 0 where the shoulders meet.
fn along<A: SolveWrist<6>>(arm: &A, q: &Joints<f64, 6>) -> f64 {
    let (offset, reversed) = match arm.base::<f64>() {
        Base::Elbow(b) => (b.offset[0], b.reversed[0]),
        Base::Telescope(b) => (b.offset[0], b.reversed[0]),
        Base::General(b) => (b.offset[0], false),
    };
    let psi = if reversed { offset - q[0] } else { offset + q[0] };
    let [x, y, _] = arm.wrist_centre(&arm.fk(q));
    psi.cos() * x + psi.sin() * y
}

/// The value of joint 2 at which the shoulders meet, if there is one in the second half of a turn from where it is.
fn onto_axis_1<A: SolveWrist<6>>(arm: &A, q: &Joints<f64, 6>) -> Option<f64> {
    let at = |q2: f64| {
        let mut q = *q;
        q[1] = q2;
        along(arm, &q)
    };
    let (mut low, mut high) = (q[1], q[1] + PI);
    if at(low) * at(high) > 0.0 {
        return None;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if at(low) * at(middle) <= 0.0 { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}

/// Joint values on the singular set.
fn aimed<A: SolveWrist<6>>(arm: &A, aim: Aim, random: &mut Sampler) -> Joints<f64, 6> {
    loop {
        let mut q = Joints::from(random.angles::<6>());
        if A::JOINTS[2].kind == JointKind::Prismatic {
            q[2] = random.between(0.3, 1.2);
        }
        if matches!(aim, Aim::Wrist | Aim::WristAndShoulder) {
            q[4] = 0.0;
        }
        if aim == Aim::Elbow {
            q[2] = match arm.base::<f64>() {
                Base::Elbow(b) => {
                    if b.reversed[2] {
                        b.offset[2]
                    } else {
                        -b.offset[2]
                    }
                }
                Base::Telescope(b) => {
                    if b.reversed[2] {
                        b.offset[2]
                    } else {
                        -b.offset[2]
                    }
                }
                // Not among the arms of these tests.
                Base::General(b) => -b.offset[2],
            };
        }
        if matches!(aim, Aim::Shoulder | Aim::WristAndShoulder) {
            match onto_axis_1(arm, &q) {
                Some(q2) => q[1] = q2,
                None => continue,
            }
        }
        return q;
    }
}

/// A smooth path of joint values through `q`, which is its middle or between two of its poses.
fn smooth(q: &Joints<f64, 6>, random: &mut Sampler) -> Vec<Joints<f64, 6>> {
    let speed =
        Vector6::from_fn(|_, _| random.between(0.1, 0.6) * if random.below(2) == 0 { 1.0 } else { -1.0 });
    let bend = Vector6::from_fn(|_, _| random.between(-0.2, 0.2));
    let off = [0.0, 0.0, random.between(-0.5, 0.5), 10_f64.powi(-(random.below(18) as i32))][random.below(4)];
    let middle = (POSES / 2) as f64;
    let time = |i: usize| (i as f64 - middle + off) / middle;
    (0..POSES).map(|i| q + speed * time(i) + bend * (time(i) * time(i))).collect()
}

#[derive(Default, Debug)]
struct Tally {
    poses: usize,
    /// Poses whose solution is a family.
    singular: usize,
    flips: usize,
    /// Paths that took the other of two branches that both continue, and how far apart these were.
    other: usize,
    apart: f64,
    /// The largest step, and the largest error of joints that are not near a singular pose.
    step: f64,
    error: f64,
}

/// Follows random paths; a path ends where it takes another branch.
fn follow<A: SolveWrist<6> + InverseKinematics<6>>(arm: &A, aim: Aim, paths: usize, seed: u64) -> Tally {
    let (mut random, mut tally) = (Sampler::new(seed), Tally::default());
    for _ in 0..paths {
        let q = aimed(arm, aim, &mut random);
        let made = smooth(&q, &mut random);
        let poses: Vec<Pose<f64>> = made.iter().map(|q| arm.fk(q)).collect();
        let mut before = made[0];
        for (step, (made, pose)) in arm.track(&made[0], poses.iter().copied()).zip(made.iter().zip(&poses)) {
            tally.poses += 1;
            let Step::Continuous(at) = step else {
                tally.flips += 1;
                break;
            };
            let back = difference(&arm.fk(&at.q), pose, arm.reach());
            assert!(back <= 1e-13, "{} {aim:?}: {back:e}", A::NAME);
            tally.step = tally.step.max((at.q - before).amax());
            before = at.q;
            if !at.solution.is_isolated() {
                tally.singular += 1;
                continue;
            }
            let m = at.solution.margins;
            let margin = (m.shoulder / arm.reach()).min(m.elbow).min(m.wrist.unwrap_or(1.0));
            let off = (at.q - made).amax();
            if off > 1e-6 && margin > 1e-6 {
                (tally.other, tally.apart) = (tally.other + 1, tally.apart.max(off));
                break;
            }
            if margin > 1e-3 {
                tally.error = tally.error.max(off);
            }
        }
    }
    tally
}

/// The largest entry of the difference, lengths divided by the reach.
fn difference(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let rotation = (a.rotation.matrix() - b.rotation.matrix()).amax();
    rotation.max((a.translation.vector - b.translation.vector).amax() / reach)
}

fn follow_all<A: SolveWrist<6> + InverseKinematics<6>>(arm: &A) {
    for aim in AIMS {
        let start = std::time::Instant::now();
        let tally = follow(arm, aim, PATHS, 31);
        let each = start.elapsed().as_secs_f64() * 1e6 / tally.poses as f64;
        println!("{:<8} {aim:?}: {tally:?}, {each:.1} us per pose", A::NAME);
        assert_eq!(tally.flips, 0, "{} {aim:?}", A::NAME);
        // The slide of the Stanford arm at 0, out of its range, brings elbow and shoulder together.
        let single = aim != Aim::WristAndShoulder && !(aim == Aim::Elbow && A::NAME == "Stanford");
        if single {
            assert!(
                tally.other * 20 <= PATHS && tally.apart < 0.3 && tally.error < 1e-6,
                "{} {tally:?}",
                A::NAME
            );
        }
    }
}

#[test]
fn paths_through_singular_poses_come_back() {
    follow_all(&robots::LabArm);
    follow_all(&robots::Puma560);
    follow_all(&robots::Kr6R700);
    follow_all(&robots::Stanford);
}

#[test]
fn no_path_flips_where_singular_sets_meet() {
    let paths = if cfg!(debug_assertions) { 1_440 } else { 28_800 };
    let found = tracking::run(2, 0..paths);
    assert_eq!(found.broken(), Vec::<String>::new());
    assert!(found.tries.iter().all(|tried| *tried >= paths / 12) && found.families > paths / 4, "{found:?}");
}

/// Poses of joint values that move evenly.
fn line<A: Arm<6>>(arm: &A, from: [f64; 6], to: [f64; 6]) -> Vec<Pose<f64>> {
    let (from, to) = (Joints::from(from), Joints::from(to));
    (0..=40).map(|i| arm.fk(&(from + (to - from) * (f64::from(i) / 40.0)))).collect()
}

#[test]
fn a_joint_winds_as_far_as_its_limits_let_it_and_flips_there() {
    let arm = robots::Puma560;
    let (from, to) = ([0.3, -0.8, 0.6, 0.4, 0.7, 2.0], [0.3, -0.8, 0.6, 0.4, 0.7, 5.0]);
    let path = line(&arm, from, to);
    let free: Vec<_> = arm.track(&Joints::from(from), path.iter().copied()).collect();
    assert!(free.iter().all(|step| matches!(step, Step::Continuous(_))));
    let last = free.last().and_then(|step| step.q().copied());
    assert!(last.is_some_and(|q| (q - Joints::from(to)).amax() < 1e-12), "{last:?}");

    let bounded = Limits::new([None, None, None, None, None, Some((-4.0, 4.0))]);
    let mut flips = Vec::new();
    for step in arm.track(&Joints::from(from), path.iter().copied()).within(&bounded) {
        assert!(step.q().is_some_and(|q| q[5].abs() <= 4.0 + 1e-12), "{step:?}");
        if let Step::Flip { joint, jump, cause, .. } = step {
            flips.push((joint, jump, cause));
        }
    }
    let [(_, jump, Cause::Ended(Reason::Limit { joint: 5, by }))] = flips.as_slice() else {
        panic!("{flips:?}")
    };
    assert!(*by > 0.0 && *by < 0.2 && *jump > 3.0, "{jump} {by}");
}

/// With nothing ahead that tells ends of a flip apart, it leads to the nearest of all windings of all solutions.
#[test]
fn a_flip_to_the_end_of_a_path_is_as_short_as_it_can_be() {
    let (arm, mut random, mut flips) = (robots::Puma560, Sampler::new(34), 0);
    for _ in 0..200 {
        let limits = Limits::new([Some((-6.0, 6.0)); 6]);
        let [from, to] = [(); 2].map(|()| Joints::from(random.angles::<6>()));
        let pose = arm.fk(&to);
        let Some(Step::Flip { to, .. }) = arm.track(&from, [pose]).within(&limits).next() else { continue };
        let solutions = arm.ik(&pose);
        let ways = solutions.windings(&limits).map(|winding| (winding.q - from).norm());
        let (least, own) = (ways.fold(f64::INFINITY, f64::min), (to.q - from).norm());
        assert!((own - least).abs() <= 1e-9, "{own} where {least} would do: {from}");
        flips += 1;
    }
    assert!(flips > 150, "{flips}");
}

#[test]
fn what_is_out_of_reach_is_blocked_and_the_path_goes_on_after_it() {
    let arm = robots::Kr6R700;
    let q = [0.1, -1.0, 1.2, 0.3, 0.8, -0.4];
    let mut path = line(&arm, q, q.map(|x| x + 0.3));
    path[20].translation.vector.x += 5.0;
    path[21].translation.vector.x = f64::NAN;
    let steps: Vec<_> = arm.track(&Joints::from(q), path.iter().copied()).collect();
    assert!(matches!(steps[20], Step::Blocked(Reason::OutOfReach { by, .. }) if by > 3.0), "{:?}", steps[20]);
    assert!(matches!(steps[21], Step::Blocked(Reason::NotFinite)));
    let going = |step: &Step<f64, 6, Posture>| matches!(step, Step::Continuous(_));
    assert!(steps[..20].iter().chain(&steps[22..]).all(going));
    // No limit can be kept, and no joint value can be near to one that is not a number.
    let nothing = Limits::new([Some((f64::NAN, 1.0)), None, None, None, None, None]);
    let mut refused = arm.track(&Joints::from(q), path[..2].iter().copied()).within(&nothing);
    assert!(refused.all(|step| matches!(step, Step::Blocked(Reason::Limit { joint: 0, .. }))));
    let mut lost = arm.track(&Joints::from([f64::NAN; 6]), path[..2].iter().copied());
    assert!(lost.all(|step| step == Step::Blocked(Reason::NotFinite)));
    assert_eq!(arm.track(&Joints::from(q), []).count(), 0);
    // A step for every pose, and it is known how many are left.
    let mut left = arm.track(&Joints::from(q), path.iter().copied());
    for count in (0..path.len()).rev() {
        assert!(left.next().is_some() && left.size_hint() == (count, Some(count)));
    }
}

#[test]
fn a_wrist_is_led_to_where_its_singular_set_is_left() {
    // The wrist is straight for thirty poses while its outer joints go on; the pose shows only their sum.
    let arm = robots::Puma560;
    let path: Vec<_> = (0..61_i32)
        .map(|i| {
            let (t, bend) = (0.02 * f64::from(i), 0.02 * f64::from(((i - 30).abs() - 15).max(0)));
            joints![0.3 + t, -0.8, 0.6 + t, 0.2 + 2.0 * t, bend, 0.5 - 2.0 * t]
        })
        .collect();
    let steps = arm.track(&path[0], path.iter().map(|q| arm.fk(q)));
    let (mut families, mut last) = (0, path[0]);
    for step in steps {
        let Step::Continuous(at) = step else { panic!("{step:?}") };
        families += usize::from(!at.solution.is_isolated());
        last = at.q;
    }
    assert!(families >= 30, "{families}");
    assert!((last - path[60]).amax() < 1e-9, "{last}");
}

#[test]
fn single_precision_follows_too() {
    let arm = robots::LabArm;
    let mut random = Sampler::new(33);
    let mut flips = 0;
    for _ in 0..200 {
        let q = aimed(&arm, Aim::Wrist, &mut random);
        let made: Vec<Joints<f32, 6>> = smooth(&q, &mut random).iter().map(|q| q.map(|x| x as f32)).collect();
        let poses: Vec<Pose<f32>> = made.iter().map(|q| arm.fk(q)).collect();
        let mut steps = arm.track(&made[0], poses.iter().copied());
        flips += usize::from(!steps.all(|step| matches!(step, Step::Continuous(_))));
    }
    assert!(flips <= 2, "{flips}");
}

/// Places of joint values that move evenly.
fn places<const N: usize, A: Arm<N>>(arm: &A, from: [f64; N], to: [f64; N]) -> Vec<Point3<f64>> {
    let (from, to) = (Joints::from(from), Joints::from(to));
    let at = |i: i32| from + (to - from) * (f64::from(i) / 40.0);
    (0..=40).map(|i| Point3::from(arm.fk(&at(i)).translation.vector)).collect()
}

#[test]
fn paths_of_points_are_followed_and_say_what_is_in_their_way() {
    // Through axis 1, where joint 1 is free for one point, and on through where the arm is stretched.
    let arm = robots::LabRrr;
    let middle = 0.5 * (PI + 0.25);
    let (from, to) = ([0.4, middle + 0.3, -0.75], [0.9, middle - 0.3, 0.25]);
    let path = places(&arm, from, to);
    let mut last = Joints::from(from);
    for step in arm.track_position(&last, path.iter().copied()) {
        let Step::Continuous(at) = step else { panic!("{step:?}") };
        assert!((at.q - last).amax() < 0.1, "{} {last}", at.q);
        last = at.q;
    }
    assert!((last - Joints::from(to)).amax() < 1e-9, "{last}");

    // A limit on the way: a flip, and its reason.
    let bounded = Limits::new([None, Some((1.6, 4.0)), None]);
    let stopped = arm.track_position(&Joints::from(from), path.iter().copied()).within(&bounded);
    let ends: Vec<_> = stopped.filter(|step| !matches!(step, Step::Continuous(_))).collect();
    let limit = |reason: &Reason<f64>| matches!(reason, Reason::Limit { joint: 1, by } if *by > 0.0);
    let told = |step: &Step<f64, 3, ArmPosture>| match step {
        Step::Flip { cause: Cause::Ended(reason), .. } | Step::Blocked(reason) => limit(reason),
        _ => false,
    };
    assert!(!ends.is_empty() && told(&ends[0]), "{ends:?}");

    // Out of reach, and nowhere.
    let away = [Point3::new(1e3, 0.0, 0.0), Point3::new(f64::NAN, 0.0, 0.0)];
    let mut blocked = arm.track_position(&Joints::from(from), away);
    assert!(matches!(blocked.next(), Some(Step::Blocked(Reason::OutOfReach { by, .. })) if by > 1.0));
    assert!(matches!(blocked.next(), Some(Step::Blocked(Reason::NotFinite))));

    // Two joints, in single precision; and the solutions of each point are counted.
    let two = robots::TwoLink;
    let points = places(&two, [0.3, 1.0], [0.6, -1.0]);
    let points = points.iter().map(|p| p.map(|x| x as f32));
    let stops: Vec<_> = two.track_position(&joints![0.3_f32, 1.0], points).counted().collect();
    assert!(stops.iter().all(|stop| matches!(stop.step, Step::Continuous(_)) && stop.count.total() >= 1));
    let end = stops.last().and_then(|stop| stop.step.q().copied()).map(|q| q - joints![0.6_f32, -1.0]);
    assert!(end.is_some_and(|off| off.amax() < 1e-2), "{end:?}");
}

/// The end of a path of poses that is followed without a flip.
fn end<const N: usize, A: InverseKinematics<N>>(arm: &A, from: [f64; N], to: [f64; N]) -> Joints<f64, N> {
    let (from, to) = (Joints::from(from), Joints::from(to));
    let path: Vec<_> = (0..=40).map(|i| arm.fk(&(from + (to - from) * (f64::from(i) / 40.0)))).collect();
    arm.track(&from, path).fold(from, |_, step| match step {
        Step::Continuous(at) => at.q,
        other => panic!("{} {other:?}", A::NAME),
    })
}

#[test]
fn arms_of_three_and_four_joints_follow_poses_through_a_stretched_elbow() {
    let (from, to) = ([0.3, 0.9, 0.05, 0.2], [0.8, -0.7, 0.16, 1.1]);
    assert!((end(&robots::Cobra600, from, to) - Joints::from(to)).amax() < 1e-6);
    let (from, to) = ([0.3, 0.9, 0.8, 0.4], [0.8, 0.5, -0.4, 0.9]);
    assert!((end(&robots::Orion5, from, to) - Joints::from(to)).amax() < 1e-6);
    let (from, to) = ([0.3, 0.8, 0.4], [0.8, -0.4, 0.9]);
    assert!((end(&robots::Planar3, from, to) - Joints::from(to)).amax() < 1e-6);
}
