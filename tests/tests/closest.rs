//! What is out of reach: the nearest pose that is reached, against a search that knows forward kinematics alone.

use std::f64::consts::PI;

use kin_runtime::prelude::*;
use kin_runtime::private::{SolvePosition, SolveWrist};
use kin_runtime::{JointKind, Reason};
use robots::{Irb2400, Kr6R700, LabArm, LabRrr, Puma560, Stanford};
use tests::sample::Sampler;
use tests::skew::Skew;

/// A search is slow where nothing is optimised: a part of the poses then.
const SHARE: usize = if cfg!(debug_assertions) { 4 } else { 1 };

dh! {
    /// A slide between two turns.
    struct Middle(standard, m, deg);

    | joint | theta |  d   |  a   | alpha | limits |
    |-------|-------|------|------|-------|--------|
    | J1    | q     | 0.3  | 0.2  |  60   |        |
    | J2    | 35    | q    | 0.3  |  70   | -1 .. 1 |
    | J3    | q     | 0.2  | 0.35 |  90   |        |
    | J4    | q     | 0.3  | 0    | -90   |        |
    | J5    | q     | 0    | 0    |  90   |        |
    | J6    | q     | 0.1  | 0    |   0   |        |
}

dh! {
    /// An elbow arm whose wrist axes stand at 60° to each other.
    struct Oblique(standard, m, deg);

    | joint | theta |  d   |  a   | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.4  | 0.1  | -90   |
    | J2    | q     | 0    | 0.45 |   0   |
    | J3    | q     | 0    | 0.05 |  90   |
    | J4    | q     | 0.5  | 0    | -60   |
    | J5    | q     | 0    | 0    |  60   |
    | J6    | q     | 0.1  | 0    |   0   |
}

/// The least distance that a plain search finds: thousands of postures, the best of them improved joint by joint.
fn searched<const N: usize, A: Arm<N>>(
    arm: &A,
    centre: impl Fn(&[f64; 3]) -> [f64; 3],
    p: [f64; 3],
    random: &mut Sampler,
) -> f64 {
    let slides = |joint: usize| A::JOINTS[joint].kind == JointKind::Prismatic;
    let distance = |rows: &[f64; 3]| {
        let [x, y, z] = centre(rows);
        ((x - p[0]).powi(2) + (y - p[1]).powi(2) + (z - p[2]).powi(2)).sqrt()
    };
    let far = 3.0 * arm.reach() + p.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut starts: Vec<(f64, [f64; 3])> = (0..3_000)
        .map(|_| {
            let rows = [0, 1, 2]
                .map(|joint| if slides(joint) { random.between(-far, far) } else { random.between(-PI, PI) });
            (distance(&rows), rows)
        })
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = f64::INFINITY;
    for (_, mut rows) in starts.into_iter().take(12) {
        let mut step = [0, 1, 2].map(|joint| if slides(joint) { 0.1 * arm.reach() } else { 0.3 });
        let mut here = distance(&rows);
        for _ in 0..4_000 {
            let joint = random.below(3);
            let mut next = rows;
            // Along one joint or across two: a narrow valley is no place to stop.
            next[joint] += random.between(-1.0, 1.0) * step[joint];
            if random.below(2) == 0 {
                let other = random.below(3);
                next[other] += random.between(-1.0, 1.0) * step[other];
            }
            let there = distance(&next);
            if there < here {
                (rows, here) = (next, there);
            } else {
                step = step.map(|s| (s * 0.99).max(1e-9));
            }
        }
        least = least.min(here);
    }
    least
}

/// A pose that stands somewhere around the arm, inside and outside its reach.
fn around(reach: f64, random: &mut Sampler) -> Pose<f64> {
    let mut angle = || random.between(-PI, PI);
    let turned = EulerZyx { z: angle(), y: angle(), x: angle() };
    let mut at = || random.between(-1.5, 1.5) * reach;
    turned.at([at(), at(), at()])
}

#[derive(Default, Debug)]
struct Tally {
    reached: usize,
    beyond: usize,
    /// The largest excess over the search, in parts of the reach, and the largest advantage.
    worse: f64,
    better: f64,
}

fn judge<A: SolveWrist<6> + InverseKinematics<6>>(arm: &A, poses: usize) {
    let (mut random, mut tally, reach) = (Sampler::new(51), Tally::default(), arm.reach());
    for _ in 0..poses {
        let pose = around(0.5 * reach, &mut random);
        let closest = arm.closest(&pose).expect("the pose is a pose");
        let reasons = arm.ik(&pose);
        let back = arm.fk(&closest.q);
        assert_eq!((back.translation, back.rotation), (closest.pose.translation, closest.pose.rotation));
        let moved = (closest.pose.translation.vector - pose.translation.vector).norm();
        assert!((moved - closest.by).abs() <= 1e-14 * reach && closest.turned < 1e-7, "{closest:?}");
        // It is on the boundary, and the boundary is reached.
        assert!(!arm.ik(&closest.pose).is_empty(), "{} {closest:?}", A::NAME);
        if !reasons.is_empty() {
            tally.reached += 1;
            assert!(closest.by <= 1e-12 * reach, "{} {closest:?}", A::NAME);
            continue;
        }
        tally.beyond += 1;
        // A figure's own distance is to points with the first joint as it is, or of one figure: never less than all of them.
        let centre = arm.wrist_centre(&pose);
        let from_rows = |[t1, t2, t3]: &[f64; 3]| {
            arm.wrist_centre(&arm.fk(&Joints::from(arm.command([*t1, *t2, *t3, 0.0, 0.0, 0.0]))))
        };
        let least = searched(arm, from_rows, centre, &mut random);
        tally.worse = tally.worse.max((closest.by - least) / reach);
        tally.better = tally.better.max((least - closest.by) / reach);
    }
    println!("{}: {tally:?}", A::NAME);
    assert!(
        tally.beyond * 4 > poses && tally.reached > 0 && tally.worse < 1e-9 && tally.better < 1e-2,
        "{} {tally:?}",
        A::NAME
    );
}

#[test]
fn the_nearest_pose_is_that_of_a_search() {
    judge(&Puma560, 40 / SHARE);
    judge(&LabArm, 40 / SHARE);
    judge(&Irb2400, 40 / SHARE);
    judge(&Kr6R700, 40 / SHARE);
    judge(&Skew, 60 / SHARE);
}

#[test]
fn slides_go_as_far_as_it_takes() {
    // Without limits a slide reaches everything but what lies within its axis's circle.
    let mut random = Sampler::new(52);
    let mut beyond = 0;
    for _ in 0..400 {
        let pose = around(0.2, &mut random);
        for (closest, none, reach) in [
            (Stanford.closest(&pose), Stanford.ik(&pose).is_empty(), Stanford.reach()),
            (Middle.closest(&pose), Middle.ik(&pose).is_empty(), Middle.reach()),
        ] {
            let closest = closest.expect("the pose is a pose");
            assert_eq!(closest.by > 1e-11 * reach, none, "{closest:?}");
            beyond += usize::from(none);
        }
    }
    assert!(beyond > 20, "{beyond}");
}

#[test]
fn an_oblique_wrist_turns_the_tool_as_little_as_it_must() {
    let (mut random, mut turned) = (Sampler::new(53), 0);
    for _ in 0..300 {
        let pose = around(0.8 * Oblique.reach() / 1.5, &mut random);
        let closest = Oblique.closest(&pose).expect("the pose is a pose");
        assert!(!Oblique.ik(&closest.pose).is_empty(), "{closest:?}");
        if closest.turned > 1e-6 {
            turned += 1;
            // The slot with the same first three joints misses the cone by this angle.
            let by = Oblique.ik(&closest.pose).iter().map(|s| (s.q - closest.q).amax()).fold(9.0, f64::min);
            assert!(by < 1e-3, "{by}");
        }
    }
    assert!(turned > 20, "{turned}");
}

/// A position arm, in both number formats.
fn point<T: Float + Into<f64>, A: SolvePosition<3> + PositionInverse<3>>(arm: &A, tolerance: f64) {
    let mut random = Sampler::new(54);
    let mut beyond = 0;
    for _ in 0..200 / SHARE {
        let wide = around(arm.reach(), &mut random).translation.vector;
        let p = Point3::from(wide.map(T::lit));
        let closest = arm.closest_point(&p).expect("a point");
        assert!(!arm.ik_position(&Point3::from(closest.pose.translation.vector)).is_empty(), "{closest:?}");
        let by: f64 = closest.by.into();
        if arm.ik_position(&p).is_empty() {
            beyond += 1;
            let from_rows = |rows: &[f64; 3]| {
                let q: Joints<f64, 3> = Joints::from(arm.command(*rows));
                arm.tool_point(&Point3::from(arm.fk(&q).translation.vector))
            };
            let centre = arm.tool_point(&Point3::from(p.coords.map(Into::into)));
            let least = searched(arm, from_rows, centre, &mut random);
            assert!(by - least < tolerance * arm.reach() && least - by < 1e-3 * arm.reach(), "{by} {least}");
        } else {
            assert!(by <= tolerance * arm.reach(), "{closest:?}");
        }
    }
    assert!(beyond > 50 / SHARE, "{beyond}");
}

#[test]
fn positions_too_and_in_single_precision() {
    point::<f64, _>(&LabRrr, 1e-9);
    point::<f32, _>(&LabRrr, 1e-5);
}

#[test]
fn strange_poses_have_their_reasons() {
    let mut pose = Puma560.fk(&joints![0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    pose.translation.vector.x = f64::NAN;
    assert_eq!(Puma560.closest(&pose).map(|c| c.by), Err(Reason::NotFinite));
    pose.translation.vector.x = 1e300;
    assert!(matches!(Puma560.closest(&pose).map(|c| c.by), Err(Reason::OutOfReach { .. })));
    pose.translation.vector.x = 1e6;
    let far = Puma560.closest(&pose).expect("far, but not beyond numbers");
    assert!(far.by > 9.9e5 && !Puma560.ik(&far.pose).is_empty());
    let nowhere = Point3::new(f64::INFINITY, 0.0, 0.0);
    assert_eq!(LabRrr.closest_point(&nowhere).map(|c| c.by), Err(Reason::NotFinite));
}
