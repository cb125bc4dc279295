//! Trajectories against what can be said of them without a formula.

use super::*;
use crate::joints;
use crate::sample::{Random, Text};

fn limits<const N: usize>(velocity: [f64; N], acceleration: [f64; N]) -> RateLimits<f64, N> {
    RateLimits { velocity: pose::column(velocity), acceleration: pose::column(acceleration) }
}

/// The report of seed 003 prints τ = Δ/q̇max for the triangular profile; it must be √(Δ/q̈max).
#[test]
fn the_switching_time_of_a_triangle_is_a_root() {
    let trajectory =
        Trajectory::new(&joints![0.0], &joints![0.5], &limits([2.0], [2.0]), Shared::Duration).unwrap();
    let profile = trajectory.profile(0).unwrap();
    assert_eq!((profile.shape(), profile.ramp(), profile.duration()), (Shape::Triangular, 0.5, 1.0));
    assert_eq!((profile.velocity(), profile.acceleration()), (1.0, 2.0));
    // With the printed 0.25 s the joint would be half-way at 0.0625 rad instead of 0.25.
    assert_eq!(trajectory.at(0.5).q, joints![0.25]);
}

#[test]
fn reversed_moves_are_mirrored_and_still_joints_rest() {
    let (a, b) = (joints![0.0, 1.0, -2.0], joints![1.5, 1.0, 0.25]);
    let limits = limits([1.0, 1.0, 3.0], [2.0, 1.0, 1.0]);
    for sync in [Shared::Duration, Shared::Phases] {
        let there = Trajectory::new(&a, &b, &limits, sync).unwrap();
        let back = Trajectory::new(&b, &a, &limits, sync).unwrap();
        assert_eq!(there.duration(), back.duration());
        assert_eq!(there.profile(1).unwrap().shape(), Shape::Still);
        for k in 0..=100 {
            let time = there.duration() * f64::from(k) / 100.0;
            let (x, y) = (there.at(time), back.at(there.duration() - time));
            assert!((x.q - y.q).amax() < 1e-15 && (x.velocity + y.velocity).amax() < 1e-14);
            assert_eq!((x.q[1], x.velocity[1], x.acceleration[1]), (1.0, 0.0, 0.0));
        }
    }
    let none = Trajectory::new(&a, &a, &limits, Shared::Phases).unwrap();
    assert_eq!((none.duration(), none.at(0.0).q, none.samples(20.0).unwrap().count()), (0.0, a, 1));
}

#[test]
fn shared_phases_are_a_straight_line() {
    let (a, b) = (joints![0.0, 1.0, -2.0], joints![1.5, 0.5, 0.25]);
    let limits = limits([0.5, 1.0, 3.0], [2.0, 1.0, 1.0]);
    let line = Trajectory::new(&a, &b, &limits, Shared::Phases).unwrap();
    let free = Trajectory::new(&a, &b, &limits, Shared::Duration).unwrap();
    assert!(line.duration() > free.duration());
    for state in line.samples(100.0).unwrap() {
        let part = (state.q[0] - a[0]) / (b[0] - a[0]);
        assert!((state.q - (a + (b - a) * part)).amax() < 1e-15);
    }
}

#[test]
fn the_end_is_sampled_once() {
    let move_in = |duration: f64| {
        let limits = limits([1e3], [1e3]);
        Trajectory::lasting(&joints![0.0], &joints![1.0], &limits, Shared::Duration, duration).unwrap()
    };
    for (duration, count) in [(1.0, 21), (1.0 + 1e-12, 21), (1.0 - 1e-12, 21), (1.01, 22), (0.99, 21)] {
        let mut before = -1.0;
        for state in move_in(duration).samples(20.0).unwrap() {
            assert!(state.time > before);
            before = state.time;
        }
        assert_eq!((move_in(duration).samples(20.0).unwrap().count(), before), (count, duration));
    }
    assert_eq!(move_in(1.0).samples(0.0), Err(TrajectoryError::BadTime));
    assert_eq!(move_in(1.0).samples(f64::NAN).err(), Some(TrajectoryError::BadTime));
}

#[test]
fn a_route_rests_at_its_stops_and_counts_one_clock() {
    let stops = [joints![0.0, 0.0], joints![1.0, -1.0], joints![1.0, -1.0], joints![0.0, 2.0]];
    let limits = limits([1.0, 2.0], [2.0, 2.0]);
    let route = Route::new(&stops, &limits, Shared::Duration).unwrap();
    let mut end = 0.0;
    for (leg, to) in route.legs().zip(&stops[1..]) {
        assert!(leg.start == end && leg.end >= leg.start && leg.trajectory.to() == to);
        assert_eq!(leg.at(leg.end).velocity, joints![0.0, 0.0]);
        end = leg.end;
    }
    assert_eq!(end, route.duration());
    let (mut last, mut before) = (stops[0], 0.0);
    for state in route.samples(200.0).unwrap() {
        // No jump between legs: at most the largest velocity times the time between.
        assert!((state.q - last).amax() <= 2.0 * (state.time - before) + 1e-12);
        (last, before) = (state.q, state.time);
    }
    assert_eq!((last, before), (stops[3], route.duration()));
    assert_eq!(Route::new(&stops[..1], &limits, Shared::Duration), Err(TrajectoryError::NoStops));
}

#[test]
fn a_longer_time_is_kept_and_a_shorter_one_refused() {
    let (a, b, limits) = (joints![0.0, 0.3], joints![1.0, -0.3], limits([1.0, 1.0], [3.0, 1.0]));
    for sync in [Shared::Duration, Shared::Phases] {
        let shortest = Trajectory::new(&a, &b, &limits, sync).unwrap().duration();
        let longer = Trajectory::lasting(&a, &b, &limits, sync, 1.7 * shortest).unwrap();
        assert_eq!((longer.duration(), longer.at(f64::MAX).q), (1.7 * shortest, b));
        assert!(longer.profiles().all(|profile| profile.velocity().abs() <= 1.0));
        let refused = Trajectory::lasting(&a, &b, &limits, sync, 0.999 * shortest);
        assert_eq!(refused, Err(TrajectoryError::TooShort { shortest }));
        let slowed = Trajectory::new(&a, &b, &limits, sync).unwrap().slowed(2.0).unwrap();
        assert!((slowed.duration() - 2.0 * shortest).abs() < 1e-15 && slowed.slowed(0.5).is_err());
    }
}

#[test]
fn every_bit_pattern_has_a_typed_answer() {
    fn finite(values: &Joints<f64, 2>) -> bool {
        values.iter().all(|x| x.is_finite())
    }
    let mut random = Random(51);
    let mut made = 0;
    for round in 0..200_000 {
        let mut draw = || {
            [(); 2].map(|()| match random.bits() % 3 {
                0 => f64::from_bits(random.bits()),
                1 => 2_f64.powi((random.bits() % 1200) as i32 - 600),
                _ => random.within(-1.0, 1.0),
            })
        };
        let (a, b, v, w) = (draw(), draw(), draw().map(f64::abs), draw().map(f64::abs));
        let sync = if round % 2 == 0 { Shared::Duration } else { Shared::Phases };
        let Ok(trajectory) = Trajectory::new(&pose::column(a), &pose::column(b), &limits(v, w), sync) else {
            continue;
        };
        made += 1;
        let d = trajectory.duration();
        assert!(d.is_finite() && trajectory.at(d).q == pose::column(b));
        for time in [0.0, d * 1e-9, d * 0.3, d * 0.5, d * 0.7, d, f64::NAN, f64::INFINITY, -1.0] {
            let state = trajectory.at(time);
            assert!(finite(&state.q) && finite(&state.velocity) && finite(&state.acceleration));
            for i in 0..2 {
                assert!(state.velocity[i].abs() <= v[i] * (1.0 + 1e-14), "{a:?} {b:?} {v:?} {w:?} {state:?}");
                assert!(
                    state.acceleration[i].abs() <= w[i] * (1.0 + 1e-14),
                    "{a:?} {b:?} {v:?} {w:?} {state:?}"
                );
            }
        }
    }
    assert!(made > 30_000, "{made}");
}

#[test]
fn what_is_no_trajectory_has_its_reason() {
    let make = |b: f64, v: f64, a: f64| {
        Trajectory::new(&joints![0.0, 0.0], &joints![1.0, b], &limits([1.0, v], [1.0, a]), Shared::Duration)
    };
    assert_eq!(make(f64::NAN, 1.0, 1.0), Err(TrajectoryError::NotFinite { joint: 1 }));
    assert_eq!(make(1.0, 0.0, 1.0), Err(TrajectoryError::BadLimit { joint: 1 }));
    assert_eq!(make(1.0, 1.0, f64::INFINITY), Err(TrajectoryError::BadLimit { joint: 1 }));
    assert_eq!(make(1e308, 1e-280, 1.0), Err(TrajectoryError::OutOfRange));
    let said = Text::of(&make(1.0, -1.0, 1.0).unwrap_err());
    assert_eq!(said.as_str(), "the velocity and acceleration limits of joint 2 must be positive and finite");
}

#[test]
fn single_precision_keeps_its_limits() {
    let mut random = Random(52);
    for _ in 0..100_000 {
        let mut draw = |low, high| [(); 3].map(|()| random.within(low, high) as f32);
        let (a, b, v, w) = (draw(-3.0, 3.0), draw(-3.0, 3.0), draw(0.1, 3.0), draw(0.1, 9.0));
        let limits = RateLimits { velocity: pose::column(v), acceleration: pose::column(w) };
        let trajectory =
            Trajectory::new(&pose::column(a), &pose::column(b), &limits, Shared::Duration).unwrap();
        for (profile, (v, w)) in trajectory.profiles().zip(v.into_iter().zip(w)) {
            let slack = 1.0 + 8.0 * f32::EPSILON;
            assert!(profile.velocity().abs() <= v * slack && profile.acceleration().abs() <= w * slack);
        }
    }
}

#[cfg(feature = "serde")]
#[test]
fn stored_trajectories_come_back_and_strange_ones_do_not() {
    let trajectory = Trajectory::new(
        &joints![0.0, 1.0],
        &joints![0.7, 1.0],
        &limits([1.0; 2], [2.0; 2]),
        Shared::Duration,
    );
    let text = serde_json::to_string(&trajectory.unwrap()).unwrap();
    assert_eq!(serde_json::from_str::<Trajectory<f64, 2>>(&text).unwrap(), trajectory.unwrap());
    for (good, bad) in [("\"duration\":", "\"duration\":-"), ("\"ramp\":[", "\"ramp\":[9")] {
        assert!(serde_json::from_str::<Trajectory<f64, 2>>(&text.replace(good, bad)).is_err(), "{text}");
    }
}
