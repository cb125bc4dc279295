//! Where two singular sets meet: values of the joint that one leaves free at which the other begins, the nearest member and the
//! ranges within limits over both, against dense scans that know the joints of the second from plain arithmetic.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kin_runtime::prelude::*;
use kin_runtime::{Constraint, JointKind, Ranges, Standing};
use tests::sample::Sampler;
use tests::score::wrap;

const POSES: usize = if cfg!(debug_assertions) { 12 } else { 40 };
const SCANNED: usize = 1440;

dh! {
    /// Its links over axis 1.
    struct Over(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0   | -90   |
    | J2    | q     | 0   | 0.4 | 0     |
    | J3    | q     | 0   | 0   | 90    |
    | J4    | q     | 0.5 | 0   | -90   |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

dh! {
    /// Links of one length beside axis 1: folded, the wrist centre lies on axis 2.
    struct Folding(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0.2 | -90   |
    | J2    | q     | 0   | 0.4 | 0     |
    | J3    | q     | 0   | 0   | 90    |
    | J4    | q     | 0.4 | 0   | -90   |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

dh! {
    /// Its first three axes meet; seen from the tool its links stand over axis 6.
    struct Shouldered(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0   | 90    |
    | J2    | q     | 0   | 0   | -90   |
    | J3    | q     | 0.4 | 0   | 90    |
    | J4    | q     | 0   | 0.5 | 0     |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

/// Joint values at two singular sets: joint `free` has any value, and here, at `outer`, another line of members begins.
struct Meeting {
    q: Joints<f64, 6>,
    free: usize,
    outer: [usize; 2],
    /// How the second of these moves with the first.
    slope: f64,
}

impl Meeting {
    /// A member of the line, by plain arithmetic.
    fn aside(&self, by: f64) -> Joints<f64, 6> {
        let (mut q, [i, j]) = (self.q, self.outer);
        q[i] = wrap(q[i] + by);
        q[j] = wrap(q[j] + self.slope * by);
        q
    }
}

/// The wrist centre on axis 1, the wrist straight, bent by nothing or by half a turn.
fn over(random: &mut Sampler) -> Meeting {
    let mut q = Joints::from(random.angles::<6>());
    let lean = (-0.8 * q[1].cos()).asin();
    q[2] = wrap(if random.below(2) == 0 { lean } else { PI - lean } - q[1]);
    let back = random.below(2) == 1;
    q[4] = if back { PI } else { 0.0 };
    Meeting { q, free: 0, outer: [3, 5], slope: if back { 1.0 } else { -1.0 } }
}

/// The wrist centre on axis 2, the wrist straight.
fn folded(random: &mut Sampler) -> Meeting {
    let mut q = Joints::from(random.angles::<6>());
    (q[2], q[4]) = (-FRAC_PI_2, 0.0);
    Meeting { q, free: 1, outer: [3, 5], slope: -1.0 }
}

/// The shoulder's centre on axis 6, the shoulder straight.
fn shouldered(random: &mut Sampler) -> Meeting {
    let mut q = Joints::from(random.angles::<6>());
    q[4] = wrap((-0.5 * q[3].cos()).atan2(0.4 + 0.5 * q[3].sin()) - q[3]);
    q[1] = 0.0;
    Meeting { q, free: 5, outer: [0, 2], slope: -1.0 }
}

fn farthest(a: &Joints<f64, 6>, b: &Joints<f64, 6>) -> f64 {
    (a - b).map(|way| wrap(way).abs()).amax()
}

fn keeps(limits: &Limits<6>, q: &Joints<f64, 6>) -> bool {
    (0..6).all(|joint| limits.standing(joint, JointKind::Revolute, q[joint]) == Standing::Within)
}

fn values(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| -PI + TAU * (i as f64 + 0.5) / count as f64)
}

/// Every family of the meeting's free joint, and where the other begins in it.
fn families<A: InverseKinematics<6>>(
    arm: &A,
    meeting: &Meeting,
    mut see: impl FnMut(&Family<'_, f64, 6, A::Branch>, f64),
) {
    let pose = arm.fk(&meeting.q);
    let mut seen = 0;
    let solutions = arm.ik(&pose);
    for family in solutions.iter().flat_map(|solution| solution.families()) {
        if family.constraint() != Constraint::Follow || family.free() != meeting.free {
            continue;
        }
        let crossings = family.crossings(arm, &pose);
        assert!(crossings.len() <= 2, "{crossings:?}");
        for (value, end) in crossings.iter() {
            assert_eq!(value, end);
            let Slot::Solved(member) = family.member(arm, &pose, value) else { panic!("{value}") };
            assert_eq!(member.families().count(), 2);
            if wrap(value - meeting.q[meeting.free]).abs() < 1e-6
                && member.families().any(|line| {
                    matches!(line.constraint(), Constraint::Sum { .. })
                        && line.constraint().missed_by(&meeting.q).is_some_and(|by| by < 1e-6)
                        && farthest(
                            &member.q,
                            &meeting.aside(wrap(member.q[meeting.outer[0]] - meeting.q[meeting.outer[0]])),
                        ) < 1e-6
                })
            {
                seen += 1;
                see(&family, value);
            }
        }
    }
    assert!(seen > 0, "{}\n{solutions}", meeting.q);
}

fn nearest<A: InverseKinematics<6>>(arm: &A, meet: fn(&mut Sampler) -> Meeting) {
    let mut random = Sampler::new(71);
    let mut on_line = 0;
    for _ in 0..POSES {
        let meeting = meet(&mut random);
        let pose = arm.fk(&meeting.q);
        families(arm, &meeting, |family, _| {
            // Anywhere, or beside a member of the line.
            for near in [false, true] {
                let mut to = Joints::from(random.angles::<6>());
                if near {
                    to = meeting.aside(to[0]) + Joints::from([(); 6].map(|()| random.between(-0.1, 0.1)));
                }
                let cost = |slot: Slot<f64, 6, A::Branch>| {
                    slot.solution().map_or(f64::INFINITY, |found| farthest(&found.q, &to))
                };
                let curve = values(SCANNED).map(|value| cost(family.member(arm, &pose, value)));
                let curve = curve.fold(f64::INFINITY, f64::min);
                let line = values(SCANNED).map(|by| farthest(&meeting.aside(by), &to));
                let line = line.fold(f64::INFINITY, f64::min);
                on_line += usize::from(line < curve);
                let Slot::Solved(found) = family.nearest(arm, &pose, &to) else { panic!() };
                assert!((arm.fk(&found.q).to_matrix() - pose.to_matrix()).amax() < 1e-13, "{}", found.q);
                // Between two that were scanned is half a step; another line may cross elsewhere.
                let found = farthest(&found.q, &to);
                assert!(found <= curve.min(line) + 1e-3, "{found} {curve} {line}");
            }
        });
    }
    assert!(on_line >= POSES / 2, "{on_line}");
}

fn ranges<A: InverseKinematics<6>>(arm: &A, meet: fn(&mut Sampler) -> Meeting) {
    let mut random = Sampler::new(72);
    let (mut points, mut without) = (0, 0);
    for _ in 0..POSES {
        let meeting = meet(&mut random);
        let pose = arm.fk(&meeting.q);
        families(arm, &meeting, |family, value| {
            // About a member of the line, or anywhere.
            let mut limits = [None; 6];
            let middle = meeting.aside(random.between(-PI, PI));
            let about = random.below(2) == 0;
            for joint in [meeting.free, meeting.outer[0], meeting.outer[1]] {
                let middle = if about { middle[joint] } else { random.between(-PI, PI) };
                limits[joint] = Some((middle - random.between(0.1, 1.0), middle + random.between(0.1, 1.0)));
            }
            let limits = Limits::new(limits);
            let ranges = family.ranges(arm, &pose, &limits);
            for at in values(90) {
                let Slot::Solved(member) = family.member(arm, &pose, at) else { panic!() };
                assert_eq!(ranges.contains(at), keeps(&limits, &member.q), "{at} {ranges:?}");
                assert_eq!(family.member_within(arm, &pose, at, &limits).is_some(), ranges.contains(at));
            }
            let scanned = values(SCANNED).any(|by| keeps(&limits, &meeting.aside(by)));
            assert_eq!(ranges.contains(value), scanned, "{value} {ranges:?}");
            for (low, high) in ranges.iter() {
                points += usize::from(low == high);
                for end in [low, high] {
                    let Some(member) = family.member_within(arm, &pose, end, &limits) else {
                        panic!("{end}")
                    };
                    assert!(keeps(&limits, &member.q) && wrap(member.q[meeting.free] - end).abs() < 1e-7);
                    let missed = (arm.fk(&member.q).to_matrix() - pose.to_matrix()).amax();
                    assert!(missed < 1e-13, "{missed}");
                }
            }
            if scanned {
                let near = arm.ik_near_within(&pose, &Joints::from(random.angles::<6>()), &limits);
                assert!(near.is_ok_and(|near| keeps(&limits, &near.q)), "{near:?}");
            } else {
                without += 1;
            }
        });
    }
    assert!(points >= POSES / 2 && without >= POSES / 4, "{points} {without}");
}

#[test]
fn the_nearest_member_may_be_of_a_family_that_crosses() {
    nearest(&Over, over);
    nearest(&Folding, folded);
    nearest(&Shouldered, shouldered);
}

#[test]
fn ranges_know_the_members_of_families_that_cross() {
    ranges(&Over, over);
    ranges(&Folding, folded);
    ranges(&Shouldered, shouldered);
}

/// Upright, axes 1, 4 and 6 are one: any two of their joints have any values, the third makes up for them.
#[test]
fn where_families_are_one_everywhere_every_pair_of_values_is_a_member() {
    let mut random = Sampler::new(73);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..POSES {
        let [first, fourth, sixth, ..] = random.angles::<6>();
        let q = joints![first, -FRAC_PI_2, FRAC_PI_2, fourth, 0.0, sixth];
        let pose = Over.fk(&q);
        let solutions = Over.ik(&pose);
        let Some(family) = solutions.iter().find_map(|solution| solution.family()) else {
            panic!("{solutions}")
        };
        assert_eq!((family.free(), family.crossings(&Over, &pose)), (0, Ranges::all()));
        let to = Joints::from(random.angles::<6>());
        // Whatever is missing of the sum is best shared by all three.
        let left = wrap(first + fourth + sixth - to[0] - to[3] - to[5]).abs() / 3.0;
        let Slot::Solved(found) = family.nearest(&Over, &pose, &to) else { panic!() };
        let off = [0, 3, 5].map(|joint| wrap(found.q[joint] - to[joint]).abs());
        let others = [1, 2, 4].map(|joint| wrap(found.q[joint] - to[joint]).abs());
        let (off, others) = (off.into_iter().fold(0.0, f64::max), others.into_iter().fold(0.0, f64::max));
        assert!(off <= left.max(others) + 1e-9, "{off} {left}");
        let mut range = || {
            let low = random.between(-PI, PI);
            (low, low + random.between(0.5, 4.0))
        };
        let [one, four, six] = [(); 3].map(|()| range());
        let limits = Limits::new([Some(one), None, None, Some(four), None, Some(six)]);
        let ranges = family.ranges(&Over, &pose, &limits);
        for value in values(60) {
            // What is left for joint 6 is an interval as long as the range of joint 4.
            let within = (-2..=2).any(|turn| (one.0..=one.1).contains(&(value + TAU * f64::from(turn))));
            let left = first + fourth + sixth - value;
            let shared = (-4..=4).any(|turn| {
                let low = left - four.1 + TAU * f64::from(turn);
                low <= six.1 && low + (four.1 - four.0) >= six.0
            });
            assert_eq!(ranges.contains(value), within && shared, "{value} {ranges:?}");
            *(if within && shared { &mut inside } else { &mut outside }) += 1;
            let member = family.member_within(&Over, &pose, value, &limits);
            assert_eq!(member.is_some(), within && shared);
            assert!(member.is_none_or(|member| keeps(&limits, &member.q)));
        }
        let near = Over.ik_near_within(&pose, &to, &limits);
        assert_eq!(near.is_ok(), !ranges.is_empty(), "{near:?}");
    }
    assert!(inside > 10 * POSES / 4 && outside > 10 * POSES, "{inside} {outside}");
}

dh! {
    /// Folded, its wrist centre is where axes 1 and 2 meet.
    struct Both(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0   | -90   |
    | J2    | q     | 0   | 0.4 | 0     |
    | J3    | q     | 0   | 0   | 90    |
    | J4    | q     | 0.4 | 0   | -90   |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

#[test]
fn where_two_joints_of_the_base_are_free_the_nearest_member_moves_both() {
    let mut random = Sampler::new(74);
    for _ in 0..POSES {
        let mut q = Joints::from(random.angles::<6>());
        q[2] = -FRAC_PI_2;
        let pose = Both.fk(&q);
        let solutions = Both.ik(&pose);
        let to = Joints::from(random.angles::<6>());
        let mut seen = 0;
        for solution in solutions.iter() {
            let mut least = f64::INFINITY;
            for (first, second) in values(72).flat_map(|first| values(72).map(move |second| (first, second)))
            {
                let held = Both.ik_holding(&pose, &joints![first, second, 0.0, 0.0, 0.0, 0.0]);
                least = held
                    .solution(solution.branch)
                    .map_or(least, |member| least.min(farthest(&member.q, &to)));
            }
            for family in solution.families().filter(|family| family.free() < 2) {
                let Slot::Solved(found) = family.nearest(&Both, &pose, &to) else { panic!() };
                assert!((Both.fk(&found.q).to_matrix() - pose.to_matrix()).amax() < 1e-13);
                // Neither is exact; the scan's steps are of 5°.
                assert!(farthest(&found.q, &to) <= least + 0.02, "{} {least}", farthest(&found.q, &to));
                seen += 1;
            }
        }
        assert!(seen >= 2, "{solutions}");
    }
}

#[test]
fn where_two_joints_are_free_both_are_brought_within_their_limits() {
    let mut random = Sampler::new(75);
    for _ in 0..POSES {
        let ranges = [(); 2].map(|()| {
            let low = random.between(-9.0, 9.0);
            (low, low + random.between(0.1, 2.0))
        });
        let [one, two] = ranges;
        let from = Joints::from(random.angles::<6>());
        let within =
            |q: f64, (low, high): (f64, f64)| (0.0..=high - low + 1e-12).contains(&(q - low).rem_euclid(TAU));

        let limits = Limits::new([Some(one), Some(two), None]);
        let folded = Point3::new(0.0, 0.0, 0.168);
        let solutions = robots::LabRrr.ik_position(&folded);
        let families: Vec<_> = solutions.iter().flat_map(|solution| solution.families()).collect();
        assert_eq!(families.len(), 2);
        for (family, range) in families.iter().zip(ranges) {
            let found = family.ranges_at(&robots::LabRrr, &folded, &limits);
            assert!(
                values(60).all(|value| found.contains(value) == within(value, range)),
                "{found:?} {range:?}"
            );
        }
        let near =
            robots::LabRrr.ik_position_near_within(&folded, &from.fixed_rows::<3>(0).into_owned(), &limits);
        assert!(near.is_ok(), "{near:?}");

        let mut q = Joints::from(random.angles::<6>());
        q[2] = -FRAC_PI_2;
        let near = Both.ik_near_within(
            &Both.fk(&q),
            &from,
            &Limits::new([Some(one), Some(two), None, None, None, None]),
        );
        assert!(near.is_ok_and(|near| within(near.q[0], one) && within(near.q[1], two)), "{near:?}");
    }
}
