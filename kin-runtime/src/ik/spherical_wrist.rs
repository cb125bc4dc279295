//! Six joints, the last three axes through one point: the base puts that point in its place, the wrist turns the tool.
//!
//! ```text
//! pose ─► wrist centre ─► base figures ─► four (t1, t2, t3) ─► ³R₆ = ⁰R₃ᵀ·R ─► wrist ─► eight (t1 … t6) ─► checked q
//! ```

use crate::ik::base::Placed;
use crate::ik::target::{Target, accepted};
use crate::ik::wrist::Wrist;
use crate::ik::{given_out, sliding};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::solutions::{
    ArmPosture, Bend, Boundary, Branch, Free, JointSet, Posture, Reason, Slot, Solution, Solutions,
};
use nalgebra::SVector;

/// All solutions; free coordinates by the convention of seed 000.
pub fn solve<T: Float, A: SolveWrist<6>>(arm: &A, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, None)
}

/// All solutions; free coordinates keep their values in `hold`.
pub fn solve_holding<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &Joints<T, 6>,
) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, Some(arm.rows(pose::entries(hold))))
}

fn solve_choosing<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: Option<[T; 6]>,
) -> Solutions<T, 6, Posture> {
    let (sliding, base) = (sliding(&A::JOINTS), arm.base::<T>());
    let target = match Target::new(pose, base.reach()) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let held = hold.map(|[t1, t2, ..]| [t1, t2]);
    let placements = base.place(arm.wrist_centre(&target.pose), target.scale, held);
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for posture in ArmPosture::ALL {
        let [noflip, flip] = match posture.of(&placements) {
            Ok(placed) => bend(arm, &target, *posture, placed, hold),
            Err(reason) => [Slot::Empty(*reason); 2],
        };
        solutions.put(posture.with(Bend::NoFlip), noflip);
        solutions.put(posture.with(Bend::Flip), flip);
    }
    solutions.merge(base.reach());
    solutions
}

/// The two slots of one placement of the wrist centre.
fn bend<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    posture: ArmPosture,
    placed: &Placed<T>,
    hold: Option<[T; 6]>,
) -> [Slot<T, 6, Posture>; 2] {
    let (rows, wrist) = reached(arm, target, placed, hold.is_some());
    let [t1, t2, t3] = rows;
    let free = |wrist| Free {
        shoulder: placed.shoulder_free.then(|| moving(arm, target, rows, 0)),
        elbow: placed.elbow_free.then(|| moving(arm, target, rows, 1)),
        wrist,
    };
    let slot = |bend, [t4, t5, t6]: [T; 3], wrist| {
        check(arm, target, posture.with(bend), [t1, t2, t3, t4, t5, t6], free(wrist))
    };
    match wrist {
        Wrist::Two { noflip, flip } => [slot(Bend::NoFlip, noflip, None), slot(Bend::Flip, flip, None)],
        Wrist::Family(family) => {
            let member = match hold {
                Some([_, _, _, t4, _, _]) => family.member(t4),
                None => family.even(),
            };
            let merged = Slot::Merged { with: posture.with(Bend::NoFlip) };
            match slot(Bend::NoFlip, member, Some(line(arm, family.difference))) {
                Slot::Empty(reason) => [Slot::Empty(reason); 2],
                solved => [solved, merged],
            }
        }
        Wrist::OutOfReach { by } => {
            [Slot::Empty(Reason::OutOfReach { by, towards: Boundary::WristCone, theta1: Some(t1) }); 2]
        }
    }
}

/// What the wrist makes of a placement. An oblique wrist may not reach where a free joint stands by convention; then
/// sixteen other values of that joint are tried.
fn reached<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    placed: &Placed<T>,
    held: bool,
) -> ([T; 3], Wrist<T>) {
    let solve = |rows| (rows, arm.wrist_angles(&arm.wrist_rotation(rows, &target.pose)));
    let convention = solve(placed.rows);
    if held || !matches!(convention.1, Wrist::OutOfReach { .. }) {
        return convention;
    }
    let [t1, t2, t3] = placed.rows;
    for turn in 1..16 {
        let step = math::half_turn::<T>() * T::lit(0.125 * f64::from(turn));
        let other = match (placed.shoulder_free, placed.elbow_free) {
            (true, _) => solve([math::wrap(t1 + step), t2, t3]),
            (false, true) => solve([t1, math::wrap(t2 + step), t3]),
            (false, false) => break,
        };
        if !matches!(other.1, Wrist::OutOfReach { .. }) {
            return other;
        }
    }
    convention
}

/// The joint values that command these row values, if forward kinematics confirms them.
fn check<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    branch: Posture,
    rows: [T; 6],
    free: Free<6>,
) -> Slot<T, 6, Posture> {
    let q = given_out(arm.command(rows), &A::JOINTS);
    match accepted(target.missed_by(&arm.fk(&q))) {
        Ok(residual) => Slot::Solved(Solution { branch, q, residual, free }),
        Err(reason) => Slot::Empty(reason),
    }
}

/// The direction in which the joints may go when axes 4 and 6 coincide: whole numbers, because couplings are.
fn line<A: SolveWrist<6>>(arm: &A, difference: bool) -> SVector<i8, 6> {
    let back = if difference { 1.0 } else { -1.0 };
    SVector::from(arm.command([0.0, 0.0, 0.0, 1.0, 0.0, back]).map(|step: f64| step as i8))
}

/// The joints that move when the free joint `of` does, told from three other members of the family.
fn moving<T: Float, A: SolveWrist<6>>(arm: &A, target: &Target<T>, rows: [T; 3], of: usize) -> JointSet {
    let here = sample(arm, target, rows);
    let mut set = JointSet::EMPTY.with(of);
    for step in [0.1, -0.1, 2.0] {
        let mut other = rows;
        if let Some(value) = other.get_mut(of) {
            *value += T::lit(step);
        }
        let there = sample(arm, target, other);
        if let (Some(here), Some(there)) = (here, there) {
            for (joint, (a, b)) in pose::entries(&here).into_iter().zip(pose::entries(&there)).enumerate() {
                if math::abs(math::wrap(a - b)) > T::lit(64.0) * math::sqrt(T::EPS) {
                    set = set.with(joint);
                }
            }
        }
    }
    set
}

/// One of the joint vectors with the given first three row values, where the wrist can follow.
fn sample<T: Float, A: SolveWrist<6>>(arm: &A, target: &Target<T>, rows: [T; 3]) -> Option<Joints<T, 6>> {
    let [t4, t5, t6] = match arm.wrist_angles(&arm.wrist_rotation(rows, &target.pose)) {
        Wrist::Two { noflip, .. } => noflip,
        Wrist::Family(family) => family.even(),
        Wrist::OutOfReach { .. } => return None,
    };
    let [t1, t2, t3] = rows;
    Some(given_out(arm.command([t1, t2, t3, t4, t5, t6]), &A::JOINTS))
}
