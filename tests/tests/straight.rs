//! Wrists that are exactly straight come back as families, whatever round-off the base makes of its wrist centre.

use std::f64::consts::{PI, TAU};

use kin_runtime::prelude::*;
use kin_runtime::private::SolveWrist;
use kin_runtime::{JointKind, Singularity, Wrist};
use tests::invented::TelescopeA;
use tests::reliability::aim::Sights;
use tests::reliability::subject::{ByPose, Subject, Tried};
use tests::sample::Sampler;
use tests::skew::Skew;

/// Poses for each arm and each kind of base.
const POSES: usize = if cfg!(debug_assertions) { 500 } else { 5000 };

/// What the base does while the wrist is straight.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Stands {
    /// Anywhere: a stretched elbow is as near as chance has it.
    Anywhere,
    /// Far from its singular sets, or exactly on one or two of them.
    OnTheSet,
}

/// Row values with a wrist that is exactly straight.
fn straight<A: SolveWrist<6> + InverseKinematics<6>>(
    arm: &Tried<A, ByPose>,
    sights: &Sights,
    stands: Stands,
    random: &mut Sampler,
) -> Joints<f64, 6> {
    // The two solutions of any bend lie to both sides of where the wrist is straight.
    let Wrist::Two { noflip: [_, a, _], flip: [_, b, _], .. } =
        arm.0.wrist_angles(&arm.0.r36(0.25, 1.0, 0.5))
    else {
        panic!("{}: the wrist is bent by one radian", A::NAME);
    };
    let exact = |margin: Option<f64>, unit: f64| margin.is_none_or(|x| x > 1e-3 * unit || x < 1e-16 * unit);
    loop {
        let mut rows = sights.row_values(random);
        if stands == Stands::Anywhere {
            for (row, joint) in rows.iter_mut().zip(A::JOINTS) {
                // A slide that is all the way in is a singular set of its own.
                let half = 0.5 * arm.reach();
                *row = if joint.kind == JointKind::Revolute {
                    random.between(-PI, PI)
                } else {
                    random.between(0.25 * half, half)
                };
            }
        }
        rows[4] = 0.5 * (a + b) + if random.below(2) == 0 { 0.0 } else { PI };
        let [shoulder, elbow, _] = sights.margins(&rows);
        if stands == Stands::Anywhere || (exact(shoulder, arm.reach()) && exact(elbow, 1.0)) {
            return Joints::from(arm.commanded(rows));
        }
    }
}

/// Whether a solution is a family of the wrist at these joint values.
fn is_there<A: SolveWrist<6> + InverseKinematics<6>>(
    solution: &Solution<f64, 6, A::Branch>,
    q: &Joints<f64, 6>,
) -> bool {
    let near = |joint: usize| {
        let way = solution.q[joint] - q[joint];
        let turning = A::JOINTS[joint].kind == JointKind::Revolute;
        (if turning { (way + PI).rem_euclid(TAU) - PI } else { way }).abs() < 1e-5
    };
    solution.families().any(|family| family.singularity() == Singularity::Wrist) && (0..6).all(near)
}

fn none_is_missed<A: SolveWrist<6> + InverseKinematics<6>>(arm: A) {
    let arm = Tried(arm, ByPose);
    // On a general base nothing is exactly on the set: its determinant is as small as its rounding lets it.
    let sights = arm.sights();
    let planar = sights.kinds().contains(&"elbow");
    let stands = if planar { &[Stands::Anywhere, Stands::OnTheSet][..] } else { &[Stands::Anywhere] };
    for &stands in stands {
        let mut random = Sampler::new(41);
        for _ in 0..POSES {
            let q = straight(&arm, &sights, stands, &mut random);
            let target = arm.fk(&q);
            let back = arm.0.ik_holding(&target, &q);
            assert!(
                back.iter().any(|solution| is_there::<A>(solution, &q)),
                "{} {stands:?}: {q} {back:?}",
                A::NAME
            );
            for solution in &back {
                let reached = arm.fk(&solution.q);
                let turn = (reached.rotation.matrix() - target.rotation.matrix()).amax();
                let shift = (reached.translation.vector - target.translation.vector).amax() / arm.reach();
                assert!(turn.max(shift) <= 40.0 * f64::EPSILON, "{} {stands:?}: {q} {solution:?}", A::NAME);
            }
        }
    }
}

macro_rules! try_arm {
    ($Arm:ident pose) => {
        none_is_missed(robots::$Arm::default());
    };
    ($Arm:ident $other:ident) => {};
}

macro_rules! try_all {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        #[test]
        fn exactly_straight_wrists_come_back_as_families() {
            $(try_arm!($Arm $inverse);)*
            none_is_missed(Skew);
        }
    };
}
robots::for_each!(try_all);

/// Found by the program `reliability`: seen from its tool, the first figure of the base touches, and the second one, a slide that is all
/// but pulled in, magnifies the root of its round-off once more.
#[test]
fn exactly_straight_shoulders_behind_two_figures_that_touch_come_back_as_families() {
    let arm = TelescopeA;
    let mut random = Sampler::new(42);
    for round in 0..POSES {
        let mut q = Joints::from(random.angles::<6>());
        q[1] = [0.0, PI][random.below(2)];
        q[3] = 10_f64.powf(random.between(-13.0, -7.0)) * [1.0, -1.0][random.below(2)];
        // The shoulder's centre is then in the plane in which both hands are one.
        q[4] = 2.121_600_797_2 * [1.0, -1.0][random.below(2)];
        let target = arm.fk(&q);
        let solutions = arm.ik_holding(&target, &q);
        let near = |s: &Solution<f64, 6, _>| {
            (s.q - q).map(|way| ((way + PI).rem_euclid(TAU) - PI).abs()).amax() < 1e-4
        };
        assert!(solutions.iter().any(|s| !s.is_isolated() && near(s)), "{round}: {q}\n{solutions}");
    }
}
