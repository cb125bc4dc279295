//! What is out of reach: the nearest pose that is reached, against a search that knows forward kinematics alone.

use std::f64::consts::PI;

use kin_runtime::prelude::*;
use kin_runtime::private::{SolvePair, SolvePosition, SolveShoulder, SolveWrist};
use kin_runtime::{Boundary, JointKind, Reason};
use robots::{Irb2400, Kr6R700, LabArm, LabRrr, Puma560, Stanford, TwoLink};
use tests::invented::{
    HandMeetingA, HandRprA, Human, PlanarRrOffset, PolarRp, SkewPr, SkewRr, TelescopeA, Twisted,
};
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

dh! {
    /// Human shoulders, but that axis 2 leans towards axis 1 and axis 3.
    struct Leaning(standard, m, deg);

    | joint | theta | d    | a    | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.2  | 0    | -50   |
    | J2    | q     | 0    | 0    |  60   |
    | J3    | q     | 0.35 | 0.02 | -90   |
    | J4    | q     | 0    | 0.3  |   0   |
    | J5    | q     | 0    | 0    |  90   |
    | J6    | q     | 0.1  | 0.05 |  30   |
}

/// The least distance that a plain search finds: thousands of postures, the best of them improved joint by joint. `slides` are
/// those of the joints that are searched.
fn searched<const N: usize>(
    reach: f64,
    slides: [bool; N],
    centre: impl Fn(&[f64; N]) -> [f64; 3],
    p: [f64; 3],
    random: &mut Sampler,
) -> f64 {
    let distance = |rows: &[f64; N]| {
        let [x, y, z] = centre(rows);
        ((x - p[0]).powi(2) + (y - p[1]).powi(2) + (z - p[2]).powi(2)).sqrt()
    };
    let far = 3.0 * reach + p.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut starts: Vec<(f64, [f64; N])> = (0..3_000)
        .map(|_| {
            let rows =
                slides.map(|slides| if slides { random.between(-far, far) } else { random.between(-PI, PI) });
            (distance(&rows), rows)
        })
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = f64::INFINITY;
    for (_, mut rows) in starts.into_iter().take(12) {
        let mut step = slides.map(|slides| if slides { 0.1 * reach } else { 0.3 });
        let mut here = distance(&rows);
        for _ in 0..4_000 {
            let joint = random.below(N);
            let mut next = rows;
            // Along one joint or across two: a narrow valley is no place to stop.
            next[joint] += random.between(-1.0, 1.0) * step[joint];
            if random.below(2) == 0 {
                let other = random.below(N);
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

/// The joints of an arm that slide, of those asked for.
fn slides<const N: usize, const M: usize, A: Arm<N>>(_: &A, joints: [usize; M]) -> [bool; M] {
    joints.map(|joint| A::JOINTS[joint].kind == JointKind::Prismatic)
}

/// `centre` is what the base must reach for a pose, `reached` where its row values bring it, `base` its joints.
fn judge<A: ClosestPose<6> + InverseKinematics<6>>(
    arm: &A,
    poses: usize,
    base: [usize; 3],
    centre: impl Fn(&Pose<f64>) -> [f64; 3],
    reached: impl Fn(&[f64; 3]) -> [f64; 3],
) {
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
        assert!(
            missed(&reasons, false).all(|by| by >= closest.by - 1e-9 * reach),
            "{} {closest:?}\n{reasons}",
            A::NAME
        );
        assert!(missed(&reasons, false).count() > 0, "{}\n{reasons}", A::NAME);
        let least = searched(reach, slides(arm, base), &reached, centre(&pose), &mut random);
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

/// By how much the slots say that a pose is out of reach: angles of those that miss a cone, or lengths of the others.
fn missed<T: Float + Into<f64>, const N: usize, B: Branch>(
    solutions: &Solutions<T, N, B>,
    cones: bool,
) -> impl Iterator<Item = f64> {
    solutions.slots().iter().filter_map(move |slot| match slot {
        Slot::Empty(Reason::OutOfReach { by, towards, .. }) => {
            (matches!(towards, Boundary::WristCone | Boundary::ShoulderCone) == cones).then(|| (*by).into())
        }
        _ => None,
    })
}

fn wrist<A: SolveWrist<6> + InverseKinematics<6> + ClosestPose<6>>(arm: &A, poses: usize) {
    let reached = |[t1, t2, t3]: &[f64; 3]| {
        arm.wrist_centre(&arm.fk(&Joints::from(arm.command([*t1, *t2, *t3, 0.0, 0.0, 0.0]))))
    };
    judge(arm, poses, [0, 1, 2], |pose| arm.wrist_centre(pose), reached);
}

fn shoulder<A: SolveShoulder<6> + InverseKinematics<6> + ClosestPose<6>>(arm: &A, poses: usize) {
    let reached = |[t6, t5, t4]: &[f64; 3]| {
        arm.shoulder_centre(&arm.fk(&Joints::from(arm.command([0.0, 0.0, 0.0, *t4, *t5, *t6]))))
    };
    judge(arm, poses, [5, 4, 3], |pose| arm.shoulder_centre(pose), reached);
}

#[test]
fn the_nearest_pose_is_that_of_a_search() {
    wrist(&Puma560, 40 / SHARE);
    wrist(&LabArm, 40 / SHARE);
    wrist(&Irb2400, 40 / SHARE);
    wrist(&Kr6R700, 40 / SHARE);
    wrist(&Skew, 60 / SHARE);
}

#[test]
fn so_it_is_of_arms_with_a_spherical_shoulder() {
    shoulder(&Human::default(), 80 / SHARE);
    shoulder(&Twisted, 80 / SHARE);
    shoulder(&HandMeetingA, 120 / SHARE);
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
            (TelescopeA.closest(&pose), TelescopeA.ik(&pose).is_empty(), TelescopeA.reach()),
            (HandRprA.closest(&pose), HandRprA.ik(&pose).is_empty(), HandRprA.reach()),
        ] {
            let closest = closest.expect("the pose is a pose");
            if (closest.by > 1e-11 * reach) != none {
                println!("FAIL {reach} {} {none}", closest.by);
            }
            beyond += usize::from(none);
        }
    }
    assert!(beyond > 20, "{beyond}");
}

fn turns_as_little_as_it_must<A: ClosestPose<6> + InverseKinematics<6>>(arm: &A) {
    let (mut random, mut turned, mut cones) = (Sampler::new(53), 0, 0);
    for _ in 0..300 {
        let pose = around(0.8 * arm.reach() / 1.5, &mut random);
        let closest = arm.closest(&pose).expect("the pose is a pose");
        assert!(!arm.ik(&closest.pose).is_empty(), "{closest:?}");
        if closest.turned > 1e-6 {
            turned += 1;
            // The slot with the same three joints of the base misses the cone by this angle.
            let by = arm.ik(&closest.pose).iter().map(|s| (s.q - closest.q).amax()).fold(9.0, f64::min);
            assert!(by < 1e-3, "{by}");
            // Where some ways miss but the cone, the centre is reached by one of them, and turned by what its cone misses.
            let solutions = arm.ik(&pose);
            let apart = missed(&solutions, true).map(|by| (by - closest.turned).abs()).reduce(f64::min);
            assert!(apart.is_none_or(|apart| apart < 1e-5), "{apart:?} {closest:?}\n{solutions}");
            cones += usize::from(apart.is_some());
        }
    }
    assert!(turned > 20 && cones > 10, "{turned} {cones}");
}

#[test]
fn an_oblique_wrist_turns_the_tool_as_little_as_it_must() {
    turns_as_little_as_it_must(&Oblique);
}

#[test]
fn so_does_an_oblique_shoulder() {
    turns_as_little_as_it_must(&Leaning);
}

/// A position arm, in both number formats.
fn point<const N: usize, T, A>(
    arm: &A,
    tolerance: f64,
    tool: impl Fn(&Point3<f64>) -> [f64; 3],
    command: impl Fn([f64; N]) -> [f64; N],
) where
    T: Float + Into<f64>,
    A: ClosestPoint<N> + PositionInverse<N>,
{
    let mut random = Sampler::new(54);
    let mut beyond = 0;
    for _ in 0..200 / SHARE {
        let wide = around(arm.reach(), &mut random).translation.vector;
        let p = Point3::from(wide.map(T::lit));
        let closest = arm.closest_point(&p).expect("a point");
        assert!(!arm.ik_position(&Point3::from(closest.pose.translation.vector)).is_empty(), "{closest:?}");
        let by: f64 = closest.by.into();
        let reasons = arm.ik_position(&p);
        if reasons.is_empty() {
            beyond += 1;
            // What two joints cannot reach is off their surface, and each figure tells how far; of three, none tells less.
            let more = || missed(&reasons, false).map(|told| (told - by) / arm.reach());
            assert!(more().all(|more| more > -tolerance && (N > 2 || more < tolerance)), "{by}\n{reasons}");
            assert!(more().count() > 0, "{reasons}");
            let reached = |rows: &[f64; N]| {
                let q: Joints<f64, N> = Joints::from(command(*rows));
                tool(&Point3::from(arm.fk(&q).translation.vector))
            };
            let centre = tool(&Point3::from(p.coords.map(Into::into)));
            let joints = core::array::from_fn(|joint| joint);
            let least = searched(arm.reach(), slides(arm, joints), reached, centre, &mut random);
            assert!(by - least < tolerance * arm.reach() && least - by < 1e-3 * arm.reach(), "{by} {least}");
        } else {
            assert!(by <= tolerance * arm.reach(), "{closest:?}");
        }
    }
    assert!(beyond > 50 / SHARE, "{beyond}");
}

fn three<T: Float + Into<f64>, A>(arm: &A, tolerance: f64)
where
    A: SolvePosition<3> + PositionInverse<3> + ClosestPoint<3>,
{
    point::<3, T, A>(arm, tolerance, |p| arm.tool_point(p), |rows| arm.command(rows));
}

fn two<T: Float + Into<f64>, A>(arm: &A, tolerance: f64)
where
    A: SolvePair<2> + PositionInverse<2> + ClosestPoint<2>,
{
    point::<2, T, A>(arm, tolerance, |p| arm.tool_point(p), |rows| arm.command(rows));
}

#[test]
fn positions_too_and_in_single_precision() {
    three::<f64, _>(&LabRrr, 1e-9);
    three::<f32, _>(&LabRrr, 1e-5);
}

#[test]
fn two_joints_come_as_near_as_a_search() {
    two::<f64, _>(&TwoLink, 1e-9);
    two::<f64, _>(&PlanarRrOffset, 1e-9);
    two::<f64, _>(&SkewRr, 1e-9);
    two::<f64, _>(&PolarRp, 1e-9);
    two::<f64, _>(&SkewPr, 1e-9);
    two::<f32, _>(&SkewRr, 1e-5);
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
    pose.translation.vector.y = f64::NAN;
    assert_eq!(Human::default().closest(&pose).map(|c| c.by), Err(Reason::NotFinite));
    let nowhere = Point3::new(f64::INFINITY, 0.0, 0.0);
    assert_eq!(TwoLink.closest_point(&nowhere).map(|c| c.by), Err(Reason::NotFinite));
    assert_eq!(LabRrr.closest_point(&nowhere).map(|c| c.by), Err(Reason::NotFinite));
}
