//! Trajectories: limits, arrivals and durations against an oracle without their formulas; lines and arcs followed by arms.

use kin_runtime::prelude::*;
use kin_runtime::trajectory::{ToolLimits, ToolPath, ToolState, TrajectoryError};
use nalgebra::Vector3;
use tests::motion::timing;
use tests::sample::Sampler;

#[test]
fn limits_hold_ends_are_reached_and_nothing_is_shorter() {
    let found = timing::run(1, 0..if cfg!(debug_assertions) { 4_000 } else { 200_000 });
    println!("{found:?}");
    assert!(found.broken().is_empty(), "{:?}", found.broken());
    assert!(found.shapes.iter().all(|count| *count > found.tries / 4), "{:?}", found.shapes);
}

const LIMITS: ToolLimits<f64> =
    ToolLimits { velocity: 0.4, acceleration: 1.5, spin: 1.2, spin_acceleration: 3.0 };

fn pose(random: &mut Sampler) -> Pose<f64> {
    let [z, y, x] = random.angles();
    EulerZyx { z, y, x }.at([0.0; 3].map(|_: f64| random.between(-1.0, 1.0)))
}

fn place(pose: &Pose<f64>) -> Vector3<f64> {
    pose.translation.vector
}

/// The angle between two orientations that are close: from the sine, which keeps its digits.
fn spin(a: &ToolState<f64>, b: &ToolState<f64>) -> f64 {
    let m = (b.pose.rotation * a.pose.rotation.inverse()).into_inner();
    (0.5 * Vector3::new(m.m32 - m.m23, m.m13 - m.m31, m.m21 - m.m12).norm()).asin()
}

/// The motion at 2000 instants, with its velocities and accelerations from differences alone.
fn differences(at: impl Fn(f64) -> ToolState<f64>, duration: f64) -> [f64; 4] {
    let (h, mut most) = (duration * 1e-4, [0.0_f64; 4]);
    for k in 1..2000 {
        let t = duration * f64::from(k) / 2000.0;
        let [a, b, c] = [t - h, t, t + h].map(&at);
        let [p, q, r] = [&a, &b, &c].map(|state| place(&state.pose));
        let rates = [(r - p).norm() / (2.0 * h), (p - q * 2.0 + r).norm() / (h * h)];
        let spins = [spin(&a, &c) / (2.0 * h), (spin(&b, &c) - spin(&a, &b)).abs() / (h * h)];
        for (most, now) in most.iter_mut().zip(rates.into_iter().chain(spins)) {
            *most = most.max(now);
        }
        assert!(((r - p) / (2.0 * h) - b.linear).norm() < 1e-3, "linear velocity");
        assert!((spins[0] - b.angular.norm()).abs() < 1e-3, "angular velocity");
    }
    most
}

#[test]
fn the_tool_keeps_its_limits_on_lines_and_arcs() {
    let mut random = Sampler::new(61);
    let (mut tight, mut arcs) = (0, 0);
    for round in 0..60 {
        let (from, to, through) = (pose(&mut random), pose(&mut random), pose(&mut random));
        let path = if round % 2 == 0 {
            ToolPath::line(&from, &to).expect("a line")
        } else {
            arcs += 1;
            let path = ToolPath::arc(&from, place(&through).into(), &to).expect("three points");
            let radius = path.radius().expect("an arc");
            // The point is on the circle, and the path comes by it.
            let nearest = (0..=20_000)
                .map(|k| (place(&path.pose(f64::from(k) / 20_000.0)) - place(&through)).norm())
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-3 * radius.max(1.0), "{nearest}");
            path
        };
        let length: f64 = (0..10_000)
            .map(|k| [k, k + 1].map(|k| place(&path.pose(f64::from(k) / 10_000.0))))
            .map(|[a, b]| (b - a).norm())
            .sum();
        assert!((length - path.length()).abs() < 1e-6 * length);
        let motion = path.timed(&LIMITS).expect("a motion");
        assert_eq!((motion.at(0.0).pose, motion.at(motion.duration()).pose), (from, to));
        let most = differences(|t| motion.at(t), motion.duration());
        let limits = [LIMITS.velocity, LIMITS.acceleration, LIMITS.spin, LIMITS.spin_acceleration];
        for (most, limit) in most.iter().zip(limits) {
            assert!(*most <= limit * (1.0 + 1e-3), "{most} > {limit}");
        }
        tight += usize::from(most.iter().zip(limits).any(|(most, limit)| *most > 0.98 * limit));
    }
    assert!(tight >= 55 && arcs == 30, "{tight}");
}

#[test]
fn an_arc_is_as_fast_as_its_centripetal_acceleration_lets_it() {
    // A half circle of radius 0.2 without a turn: of all cruises tried, none gives a shorter duration.
    let at = |x: f64, y: f64| EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([x, y, 0.0]);
    let path = ToolPath::arc(&at(0.2, 0.0), [0.0, 0.2, 0.0], &at(-0.2, 0.0)).expect("an arc");
    let (length, radius) = (path.length(), path.radius().expect("an arc"));
    assert!((length - 0.2 * std::f64::consts::PI).abs() < 1e-15 && (radius - 0.2).abs() < 1e-15);
    for (velocity, acceleration) in [(10.0, 1.5), (0.4, 1.5), (0.3, 0.1), (1.0, 50.0)] {
        let limits = ToolLimits { velocity, acceleration, ..LIMITS };
        let duration = path.timed(&limits).expect("a motion").duration();
        let mut best = f64::INFINITY;
        for k in 1..200_000 {
            let v = velocity * f64::from(k) / 199_999.0;
            let room = acceleration * acceleration - v.powi(4) / (radius * radius);
            if room > 0.0 && v * v <= length * room.sqrt() {
                best = best.min(length / v + v / room.sqrt());
            }
        }
        assert!(duration <= best * (1.0 + 1e-9) && duration > best * (1.0 - 1e-6), "{duration} {best}");
    }
}

#[test]
fn paths_that_are_none_have_their_reason() {
    let at = |x: f64| EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([x, 0.0, 0.0]);
    let bad = Some(TrajectoryError::BadPose);
    assert_eq!(ToolPath::arc(&at(0.0), [1.0, 0.0, 0.0], &at(2.0)).err(), bad);
    assert_eq!(ToolPath::arc(&at(0.0), [1.0, 1.0, 0.0], &at(0.0)).err(), bad);
    assert_eq!(ToolPath::line(&at(f64::NAN), &at(0.0)).err(), bad);
    let still = ToolPath::line(&at(1.0), &at(1.0)).expect("no way");
    let motion = still.timed(&LIMITS).expect("no motion");
    assert_eq!((motion.duration(), motion.poses(20.0).expect("a rate").count()), (0.0, 1));
    let stuck = ToolLimits { spin: 0.0, ..LIMITS };
    assert_eq!(still.timed(&stuck).err(), Some(TrajectoryError::BadLimit { joint: 1 }));
}

#[test]
fn half_turns_of_the_tool_keep_their_digits() {
    let mut random = Sampler::new(62);
    for round in 0..2_000 {
        let from = pose(&mut random);
        let axis = nalgebra::Unit::new_normalize(place(&pose(&mut random)));
        let off = [0.0, 1e-12, 1e-8, 1e-3, 1.0][round % 5];
        let angle = if round % 2 == 0 { std::f64::consts::PI - off } else { off };
        let to = Pose::from_parts(
            from.translation,
            nalgebra::Rotation3::from_axis_angle(&axis, angle) * from.rotation,
        );
        let path = ToolPath::line(&from, &to).expect("a turn");
        assert!((path.turn() - angle).abs() < 4e-15, "{} {angle}", path.turn());
        let half = nalgebra::Rotation3::from_axis_angle(&axis, 0.5 * angle) * from.rotation;
        let other = nalgebra::Rotation3::from_axis_angle(&axis, -0.5 * angle) * from.rotation;
        let off = |a: &nalgebra::Rotation3<f64>| (path.pose(0.5).rotation.matrix() - a.matrix()).amax();
        // Exactly half a turn may go either way round.
        let miss = if off(&half) < 1e-6 { off(&half) } else { off(&other) };
        assert!(miss < 1e-14, "{miss:e} {angle}");
        assert!((path.pose(1.0 - 1e-16).rotation.matrix() - to.rotation.matrix()).amax() < 1e-14);
    }
}

#[test]
fn an_arm_follows_lines_and_arcs_at_20_hz() {
    let arm = robots::Puma560;
    let q = joints![0.3, -0.8, 0.6, 0.4, 0.7, 0.2];
    let from = arm.fk(&q);
    let to = arm.fk(&(q + joints![0.4, 0.2, -0.3, 0.2, 0.3, -0.4]));
    let middle = (place(&from) + place(&to)) * 0.5 + Vector3::new(0.0, 0.0, 0.1);
    for path in [ToolPath::line(&from, &to), ToolPath::arc(&from, middle.into(), &to)] {
        let motion = path.and_then(|path| path.timed(&LIMITS)).expect("a motion");
        let poses = motion.poses(20.0).expect("a rate");
        let steps: Vec<_> = arm.track(&q, poses).collect();
        assert_eq!(steps.len(), (motion.duration() * 20.0).ceil() as usize + 1);
        for (step, pose) in steps.iter().zip(poses) {
            let Step::Continuous(at) = step else { panic!("{step:?}") };
            assert!((place(&arm.fk(&at.q)) - place(&pose)).norm() < 1e-14);
        }
    }
}
