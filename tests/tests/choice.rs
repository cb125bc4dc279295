//! Windings, limits, members of families and the nearest solution, each against a plain search.

use std::f64::consts::{PI, TAU};

use kin_runtime::prelude::*;
use kin_runtime::{JointKind, Standing};
use tests::sample::Sampler;

/// The representatives of an angle in a range, by trying turns.
fn tried(value: f64, (low, high): (f64, f64)) -> Vec<f64> {
    (-40..=40).map(|k| value + TAU * f64::from(k)).filter(|x| low <= *x && *x <= high).collect()
}

#[test]
fn representatives_are_those_that_trying_finds() {
    let mut random = Sampler::new(41);
    for _ in 0..20_000 {
        let low = random.between(-20.0, 20.0);
        let range = (low, low + random.between(0.0, 20.0));
        let (value, to) = (random.between(-20.0, 20.0), random.between(-30.0, 30.0));
        let limits = Limits::new([Some(range)]);
        let found: Vec<f64> = limits.representatives(0, JointKind::Revolute, value).collect();
        let expected = tried(value, range);
        assert_eq!(found.len(), expected.len(), "{value} in {range:?}");
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-13));
        let nearest = expected.iter().copied().min_by(|a, b| (a - to).abs().total_cmp(&(b - to).abs()));
        match (limits.nearest(0, JointKind::Revolute, value, to), nearest) {
            (Some(a), Some(b)) => assert!(((a - to).abs() - (b - to).abs()).abs() < 1e-12),
            (a, b) => assert_eq!(a, b),
        }
        match limits.standing(0, JointKind::Revolute, value) {
            Standing::Within => assert!(!expected.is_empty()),
            Standing::Passed(by) => {
                let ends = (-40..=40).map(|k| value + TAU * f64::from(k));
                let least = ends.map(|x| (range.0 - x).max(x - range.1)).fold(f64::INFINITY, f64::min);
                assert!(expected.is_empty() && by > 0.0 && (by - least).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn strange_ranges_have_typed_answers() {
    let inf = f64::INFINITY;
    let of = |range, value: f64| {
        let limits = Limits::new([Some(range)]);
        let counted = limits.representatives(0, JointKind::Revolute, value).count();
        (counted, limits.standing(0, JointKind::Revolute, value))
    };
    for nothing in [(f64::NAN, 1.0), (0.0, f64::NAN), (1.0, -1.0)] {
        let (count, standing) = of(nothing, 0.5);
        assert!(
            count == 0 && matches!(standing, Standing::Passed(by) if by > 0.0),
            "{nothing:?} {standing:?}"
        );
    }
    for all in [(-inf, inf), (0.0, inf), (-inf, 0.0)] {
        assert_eq!(of(all, 0.5), (1, Standing::Within));
    }
    assert_eq!(of((-PI, PI), f64::NAN), (0, Standing::Passed(inf)));
    assert_eq!(of((-1e9, 1e9), 0.0).0, 2049);
    let limits = Limits::new([Some((0.0, inf))]);
    assert_eq!(limits.nearest(0, JointKind::Revolute, 0.5, 100.0 * TAU), Some(0.5 + 100.0 * TAU));
    assert_eq!(limits.nearest(0, JointKind::Revolute, 0.5, f64::NAN), Some(0.5));
    assert_eq!(limits.standing(0, JointKind::Prismatic, -1.0), Standing::Passed(1.0));
    assert_eq!(limits.standing(0, JointKind::Prismatic, 1e9), Standing::Within);
    // 170° .. 190°, in single precision: -175° is 185°.
    let back = Limits::new([Some((170_f64.to_radians(), 190_f64.to_radians()))]);
    let found: Vec<f32> = back.representatives(0, JointKind::Revolute, (-175_f32).to_radians()).collect();
    assert!(matches!(found.as_slice(), [x] if (x - 185_f32.to_radians()).abs() < 1e-6), "{found:?}");
}

#[test]
fn windings_are_all_combinations_in_order() {
    let mut random = Sampler::new(42);
    let arm = robots::Puma560;
    let mut seen = 0;
    for _ in 0..300 {
        let solutions = arm.ik(&arm.fk(&Joints::from(random.angles::<6>())));
        let ranges = [(); 6].map(|()| {
            let low = random.between(-8.0, 4.0);
            (random.below(3) > 0).then(|| (low, low + random.between(2.0, 12.0)))
        });
        let limits = Limits::new(ranges);
        let mut expected: Vec<Vec<f64>> = Vec::new();
        for solution in solutions.iter() {
            let mut lists: Vec<Vec<f64>> = vec![Vec::new()];
            for (value, range) in solution.q.iter().zip(ranges) {
                let values = range.map_or_else(|| vec![*value], |range| tried(*value, range));
                lists = lists
                    .iter()
                    .flat_map(|l| values.iter().map(|v| [l.as_slice(), &[*v]].concat()))
                    .collect();
            }
            expected.extend(lists);
        }
        let found: Vec<_> = solutions.windings(&limits).collect();
        assert_eq!(found.len(), expected.len());
        for (winding, values) in found.iter().zip(&expected) {
            assert!(winding.q.iter().zip(values).all(|(a, b)| (a - b).abs() < 1e-13));
        }
        let to = Joints::from(random.angles::<6>()) * 2.0;
        let largest = |q: &Joints<f64, 6>| (q - to).amax();
        if ranges.iter().all(Option::is_some) {
            let least = found.iter().map(|w| largest(&w.q)).fold(f64::INFINITY, f64::min);
            let nearest = solutions.nearest_winding(&to, &limits).map_or(f64::INFINITY, |w| largest(&w.q));
            assert!(nearest == least || (nearest - least).abs() < 1e-12, "{nearest} {least}");
        }
        seen += found.len();
    }
    assert!(seen > 1000, "{seen}");
    let none = arm.ik(&EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([9.0, 0.0, 0.0]));
    assert!(none.windings(&Limits::NONE).next().is_none());
    assert!(none.nearest_winding(&joints![0.0, 0.0, 0.0, 0.0, 0.0, 0.0], &Limits::NONE).is_none());
}

#[test]
fn the_nearest_solution_is_found_and_wound_and_keeps_what_is_free() {
    let arm = robots::Puma560;
    let mut random = Sampler::new(43);
    for round in 0..500 {
        let mut values = random.angles::<6>().map(|x| 2.0 * x);
        if round % 2 == 0 {
            values[4] = 0.0;
        }
        let q = Joints::from(values);
        let pose = arm.fk(&q);
        let near = arm.ik_near(&pose, &q).unwrap_or_else(|reason| panic!("{reason}"));
        // Beside another singular set the rounding of its figure bends a straight wrist, which is then no family.
        let m = near.solution.margins;
        assert!((near.q - q).amax() < 1e-6 || m.shoulder.min(m.elbow) < 0.1, "{} {q}", near.q);
        let limits = arm.limits();
        match arm.ik_near_within(&pose, &q, &limits) {
            Ok(at) => {
                assert!((0..6).all(|j| {
                    limits.range(j).is_none_or(|(a, b)| a - 1e-12 <= at.q[j] && at.q[j] <= b + 1e-12)
                }));
                let best = arm.ik_holding(&pose, &q).nearest_winding(&q, &limits);
                assert!(best.is_none_or(|best| (at.q - q).amax() <= (best.q - q).amax()));
            }
            Err(reason) => {
                assert!(matches!(reason, Reason::Limit { by, .. } if by > 0.0), "{reason}");
                assert!(arm.ik(&pose).windings(&limits).next().is_none());
            }
        }
    }
    let q = joints![0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
    let far = EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([9.0, 0.0, 0.0]);
    assert!(matches!(arm.ik_near(&far, &q), Err(Reason::OutOfReach { by, .. }) if by > 5.0));
    let lost = q.map(|x| if x > 0.5 { f64::NAN } else { x });
    assert_eq!(arm.ik_near(&arm.fk(&q), &lost).map(|w| w.q), Err(Reason::NotFinite));
    let p = robots::LabRrr.fk(&joints![0.5_f32, 0.4, -0.5]).translation.vector;
    let at =
        robots::LabRrr.ik_position_near(&Point3::from(p), &joints![0.5 + std::f32::consts::TAU, 0.4, -0.5]);
    assert!(at.is_ok_and(|at| (at.q[0] - 0.5 - std::f32::consts::TAU).abs() < 1e-5));
}

#[test]
fn ranges_of_members_are_those_that_keep_the_limits() {
    let mut random = Sampler::new(44);
    let (mut inside, mut outside) = (0, 0);
    for round in 0..60 {
        // A straight wrist (exact), and the wrist centre on axis 1 (sampled).
        let (arm, shoulder) = (robots::LabArm, round % 4 == 3);
        let pose = if shoulder {
            EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([0.0, 0.0, 300.0])
        } else {
            let mut q = random.angles::<6>();
            q[4] = 0.0;
            arm.fk(&Joints::from(q))
        };
        let solutions = arm.ik(&pose);
        let Some(family) = solutions.iter().find_map(|s| s.family()) else { continue };
        let mut range = || {
            let low = random.between(-8.0, 4.0);
            Some((low, low + random.between(1.0, 7.0)))
        };
        let limits = Limits::new([if shoulder { range() } else { None }, None, None, range(), None, range()]);
        let ranges = family.ranges(&arm, &pose, &limits);
        for _ in 0..200 {
            let value = random.between(-PI, PI);
            let Slot::Solved(member) = family.member(&arm, &pose, value) else {
                panic!("no member at {value}")
            };
            let keeps =
                (0..6).all(|j| limits.standing(j, JointKind::Revolute, member.q[j]) == Standing::Within);
            assert_eq!(ranges.contains(value), keeps, "{value} {ranges:?} {}", member.q);
            *(if keeps { &mut inside } else { &mut outside }) += 1;
        }
    }
    assert!(inside > 500 && outside > 500, "{inside} {outside}");
}

#[test]
fn the_nearest_member_is_that_of_a_fine_search() {
    let mut random = Sampler::new(45);
    let arm = robots::LabArm;
    for round in 0..40 {
        let pose = if round % 4 == 3 {
            EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([0.0, 0.0, 300.0])
        } else {
            let mut q = random.angles::<6>();
            q[4] = 0.0;
            arm.fk(&Joints::from(q))
        };
        let to = Joints::from(random.angles::<6>());
        let solutions = arm.ik(&pose);
        let Some(family) = solutions.iter().find_map(|s| s.family()) else { continue };
        let cost = |slot: Slot<f64, 6, Posture>| match slot {
            Slot::Solved(s) => (s.q - to).map(|x| tests::score::wrap(x).abs()).amax(),
            _ => f64::INFINITY,
        };
        let searched = (0..2000).map(|i| cost(family.member(&arm, &pose, -PI + TAU * f64::from(i) / 2000.0)));
        let least = searched.fold(f64::INFINITY, f64::min);
        assert!(cost(family.nearest(&arm, &pose, &to)) <= least + 1e-3, "{round}");
        for solution in solutions.iter() {
            for family in solution.families() {
                assert!(family.constraint().missed_by(&solution.q).is_none_or(|by| by < 1e-12));
            }
        }
    }
}

#[test]
fn joints_that_move_are_those_that_differ_among_members() {
    let mut random = Sampler::new(46);
    let arm = robots::LabArm;
    let mut seen = [0; 2];
    for round in 0..40 {
        // The wrist centre on axis 1; now and then the tool upright on it, so that joint 6 alone makes up for joint 1.
        let upright = round % 4 == 0;
        let mut angle = || random.between(-PI, PI);
        let turned = EulerZyx {
            z: angle(),
            y: if upright { 0.0 } else { angle() },
            x: if upright { 0.0 } else { angle() },
        };
        let tool = turned.at([0.0; 3]).rotation.matrix().column(2) * 29.0;
        let pose = turned.at([tool.x, tool.y, tool.z + 250.0]);
        for family in arm.ik(&pose).iter().flat_map(Solution::families) {
            if family.free() != 0 {
                continue;
            }
            let members: Vec<_> = (0..40)
                .filter_map(|i| {
                    let slot = family.member(&arm, &pose, -3.0 + 0.15 * f64::from(i));
                    slot.solution().map(|s| s.q)
                })
                .collect();
            let moved =
                |j: usize| members.iter().any(|q| tests::score::wrap(q[j] - members[0][j]).abs() > 1e-6);
            let differ: Vec<usize> = (0..6).filter(|&j| moved(j)).collect();
            assert_eq!(family.moving().iter().collect::<Vec<_>>(), differ, "{round}");
            seen[usize::from(upright)] += 1;
        }
    }
    assert!(seen[0] > 50 && seen[1] > 10, "{seen:?}");
}

#[test]
fn a_constraint_tells_by_how_much_it_is_missed_if_it_is_one_of_values() {
    let arm = robots::Puma560;
    let straight = arm.fk(&joints![0.4, -0.5, 0.3, 0.7, 0.0, 0.2]);
    let solutions = arm.ik(&straight);
    let family = solutions.iter().find_map(|s| s.family()).expect("a straight wrist is a family");
    let constraint = family.constraint();
    for [four, six, off] in
        [[0.7, 0.2, 0.0], [1.7, -0.8, 0.0], [0.7, 0.5, 0.3], [4.0, -3.1 - TAU, 0.0], [0.9, 3.1, 3.1]]
    {
        let missed = constraint.missed_by(&joints![0.0, 0.0, 0.0, four, 0.0, six]).expect("a sum of angles");
        assert!((missed - off).abs() < 1e-14, "{four} {six}: {missed}");
    }
    let follows: Constraint<f64, 6> = Constraint::Follow;
    assert_eq!(follows.missed_by(&joints![0.0, 0.0, 0.0, 0.0, 0.0, 0.0]), None);
}
