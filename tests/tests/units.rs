//! The unit of length is the declarer's: an arm and a pose in a unit that is 1024 times smaller have the same solutions, to the
//! last bit, for nothing is rounded on the way from one to the other. What is compared with a length must be one.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_runtime::Boundary::{ShoulderCone, WristCone};
use kin_runtime::prelude::*;
use kin_runtime::{JointKind, dexterity};
use tests::sample::Sampler;

const POSES: usize = 150;

/// Units of length in one metre, in the smaller of the two.
const SMALLER: f64 = 1024.0;

dh! {
    /// Two links and a wrist of three axes at right angles.
    struct Elbow(standard, m, deg);

    param u = 0.01;

    | joint | theta  | d        | a        | alpha |
    |-------|--------|----------|----------|-------|
    | J1    | q      | 30 * u  | 10 * u  | -90   |
    | J2    | q + 90 | 0        | 45 * u | 0     |
    | J3    | -q     | 0        | 5 * u | 90    |
    | J4    | q      | 40 * u  | 0        | -90   |
    | J5    | q      | 0        | 0        | 90    |
    | J6    | q      | 8 * u | 0        | 0     |
}

dh! {
    /// The third joint slides; the axes of the wrist stand obliquely.
    struct Telescope(standard, m, deg);

    param u = 0.01;

    | joint | theta | d        | a        | alpha |
    |-------|-------|----------|----------|-------|
    | J1    | q     | 40 * u  | 10 * u  | -90   |
    | J2    | q     | 15 * u | 0        | 90    |
    | J3    | 90    | q        | 0        | 0     |
    | J4    | q     | 0        | 0        | -60   |
    | J5    | q     | 0        | 0        | 70    |
    | J6    | q     | 10 * u  | 0        | 0     |
}

dh! {
    /// No two neighbouring axes of the base meet or are parallel.
    struct Skew(standard, m, deg);

    param u = 0.01;

    | joint | theta | d        | a        | alpha |
    |-------|-------|----------|----------|-------|
    | J1    | q     | 30 * u  | 15 * u | 60    |
    | J2    | q     | 10 * u  | 45 * u | 75    |
    | J3    | q     | -20 * u | 25 * u | 110   |
    | J4    | q     | 30 * u  | 0        | -90   |
    | J5    | q     | 0        | 0        | 90    |
    | J6    | q     | 10 * u  | 0        | 0     |
}

dh! {
    /// Two slides carry the turn that carries the wrist.
    struct Gantry(standard, m, deg);

    param u = 0.01;

    | joint | theta | d       | a       | alpha |
    |-------|-------|---------|---------|-------|
    | J1    | 0     | q       | 10 * u | 90    |
    | J2    | 40    | q       | 20 * u | 55    |
    | J3    | q     | 10 * u | 50 * u | 90    |
    | J4    | q     | 30 * u | 0       | -90   |
    | J5    | q     | 0       | 0       | 90    |
    | J6    | q     | 10 * u | 0       | 0     |
}

dh! {
    /// A shoulder like a ball, an elbow, and a hand of two axes.
    struct Ball(standard, m, deg);

    param u = 0.01;

    | joint | theta  | d        | a        | alpha |
    |-------|--------|----------|----------|-------|
    | J1    | q      | 30 * u  | 0        | -90   |
    | J2    | q      | 0        | 0        | 90    |
    | J3    | q + 90 | 40 * u  | 0        | -90   |
    | J4    | q      | 0        | 35 * u | 0     |
    | J5    | q      | 3 * u | 0        | 90    |
    | J6    | q      | 8 * u | 0        | 0     |
}

dh! {
    /// Four joints, one of which slides.
    struct Scara(standard, m, deg);

    param u = 0.01;

    | joint | theta | d       | a       | alpha |
    |-------|-------|---------|---------|-------|
    | J1    | q     | 30 * u | 40 * u | 0     |
    | J2    | q     | 0       | 30 * u | 180   |
    | J3    | 0     | q       | 0       | 0     |
    | J4    | q     | 10 * u | 0       | 0     |
}

dh! {
    /// Five joints; folded, joints 1 and 2 are left to the orientation.
    struct Roll(standard, m, deg);

    param u = 0.01;

    | joint | theta  | d        | a       | alpha |
    |-------|--------|----------|---------|-------|
    | J1    | q      | 30 * u  | 0       | 90    |
    | J2    | q      | 0        | 40 * u | 0     |
    | J3    | q      | 0        | 40 * u | 0     |
    | J4    | q + 90 | 0        | 0       | 90    |
    | J5    | q      | 15 * u | 0       | 0     |
}

/// A slide's value in metres, in the smaller unit; an angle is the same.
fn scaled<const N: usize, A: Arm<N>>(_: &A, q: &Joints<f64, N>) -> Joints<f64, N> {
    let slides = |i: usize| A::JOINTS[i].kind == JointKind::Prismatic;
    Joints::from_fn(|i, _| if slides(i) { q[i] * SMALLER } else { q[i] })
}

fn shrunk(pose: &Pose<f64>) -> Pose<f64> {
    let mut pose = *pose;
    pose.translation.vector *= SMALLER;
    pose
}

/// Any joint values, many of them at or near a quarter turn, where arms are singular.
fn joints<const N: usize, A: Arm<N>>(_: &A, random: &mut Sampler) -> Joints<f64, N> {
    Joints::from_fn(|i, _| {
        if A::JOINTS[i].kind == JointKind::Prismatic {
            return random.between(-0.8, 0.8);
        }
        match random.below(4) {
            0 => FRAC_PI_2 * random.below(4) as f64 - PI,
            1 => FRAC_PI_2 * random.below(4) as f64 - PI + 10_f64.powi(-(random.below(17) as i32)),
            _ => random.between(-PI, PI),
        }
    })
}

/// Joint values, residual and the count of families; or by how much a slot is missed.
type Found<const N: usize> = Result<(Joints<f64, N>, f64, usize), Option<f64>>;

/// What was found, in a unit of which so many are the smaller one.
fn told<const N: usize, A: InverseKinematics<N>>(
    arm: &A,
    solutions: &Solutions<f64, N, A::Branch>,
    unit: f64,
) -> Vec<Found<N>> {
    let slots = solutions.slots().iter().map(|slot| match slot {
        Slot::Solved(found) => {
            let q = if unit == 1.0 { found.q } else { scaled(arm, &found.q) };
            Ok((q, found.residual, found.families().count()))
        }
        Slot::Empty(Reason::OutOfReach { by, towards: WristCone | ShoulderCone, .. }) => Err(Some(*by)),
        Slot::Empty(Reason::OutOfReach { by, .. }) => Err(Some(unit * by)),
        Slot::Empty(Reason::Orientation { by }) => Err(Some(*by)),
        Slot::Empty(_) | Slot::Merged { .. } => Err(None),
    });
    slots.collect()
}

/// To the last bit.
fn compare<const N: usize, A: InverseKinematics<N>>(
    (metres, here): (&A, &Solutions<f64, N, A::Branch>),
    (small, there): (&A, &Solutions<f64, N, A::Branch>),
) {
    let (one, other) = (told(metres, here, SMALLER), told(small, there, 1.0));
    assert_eq!(one, other, "{}\n{here}\n{there}", A::NAME);
}

/// The same pose, out of reach, and joint values held where they are free.
fn solutions<const N: usize, A: InverseKinematics<N>>(metres: &A, small: &A) {
    let mut random = Sampler::new(17);
    for round in 0..POSES {
        let q = joints(metres, &mut random);
        let mut pose = metres.fk(&q);
        assert_eq!(shrunk(&pose), small.fk(&scaled(metres, &q)), "{} {q}", A::NAME);
        let [one, other] = [dexterity(metres, &q), dexterity(small, &scaled(metres, &q))];
        assert_eq!(one.margin, other.margin, "{} {q}", A::NAME);
        if round % 5 == 4 {
            pose.translation.vector *= 1.5;
        }
        let (here, there) = (metres.ik(&pose), small.ik(&shrunk(&pose)));
        compare((metres, &here), (small, &there));
        let (here, there) =
            (metres.ik_holding(&pose, &q), small.ik_holding(&shrunk(&pose), &scaled(metres, &q)));
        compare((metres, &here), (small, &there));
    }
}

/// Ways through singular poses, each joint as far as it goes.
fn tracks<const N: usize, A: InverseKinematics<N>>(metres: &A, small: &A) {
    let mut random = Sampler::new(18);
    for _ in 0..15 {
        let steps = (5 + random.below(12)) as f64;
        let (from, to) = (joints(metres, &mut random), joints(metres, &mut random));
        let path: Vec<_> =
            (0..25).map(|i| metres.fk(&(from + (to - from) * (f64::from(i) / steps)))).collect();
        let here = metres.track(&from, path.iter().copied());
        let there = small.track(&scaled(metres, &from), path.iter().map(shrunk));
        for (here, there) in here.zip(there) {
            let same = std::mem::discriminant(&here) == std::mem::discriminant(&there);
            let q = here.q().map(|q| scaled(metres, q));
            assert!(same && q.as_ref() == there.q(), "{} from {from} to {to}\n{here:?}\n{there:?}", A::NAME);
        }
    }
}

/// A check of arms in metres and in the smaller unit.
macro_rules! in_both_units {
    ($check:ident: $($arm:ident),*) => {
        $($check(&$arm::default(), &$arm { u: 0.01 * SMALLER });)*
    };
}

#[test]
fn solutions_are_the_same_in_any_unit() {
    in_both_units!(solutions: Elbow, Telescope, Skew, Gantry, Ball, Scara, Roll);
}

#[test]
fn paths_are_followed_in_the_same_way_in_any_unit() {
    in_both_units!(tracks: Elbow, Telescope, Gantry, Ball, Scara);
}

/// A tool that turns about its own tip stays in its place but for what the joints bend the way between two poses: little beside
/// the turn, in whatever unit.
#[test]
fn a_tool_turns_about_its_tip_in_any_unit() {
    let (metres, small) = (Elbow::default(), Elbow { u: 0.01 * SMALLER });
    let start = joints![0.3, -0.6, 0.9, 0.4, 1.1, -0.7];
    let pose = metres.fk(&start);
    let path: Vec<_> = (0..6)
        .map(|i| {
            let turn = EulerZyx { z: 0.0, y: 0.0, x: 0.2 * f64::from(i) }.at([0.0; 3]);
            let mut turned = pose;
            turned.rotation = pose.rotation * turn.rotation;
            turned
        })
        .collect();
    let going = |step: Step<f64, 6, Posture>| matches!(step, Step::Continuous(_));
    assert!(metres.track(&start, path.iter().copied()).all(going));
    assert!(small.track(&start, path.iter().map(shrunk)).all(going));
}
