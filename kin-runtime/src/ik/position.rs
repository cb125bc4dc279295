//! Three joints: the base alone puts the tool point in its place.

use crate::ik::target::{accepted, distance, size};
use crate::ik::{finite, given_out, sliding};
use crate::math::Float;
use crate::pose::{self, Joints};
use crate::private::SolvePosition;
use crate::solutions::{
    ArmPosture, Branch, Free, JointSet, Loose, Margins, Reason, Slot, Solution, Solutions,
};
use nalgebra::Point3;

/// All solutions; a free joint takes the value 0.
pub fn solve<T: Float, A: SolvePosition<3>>(arm: &A, p: &Point3<T>) -> Solutions<T, 3, ArmPosture> {
    solve_choosing(arm, p, [None; 2])
}

/// All solutions; a free joint keeps its value in `hold`, or takes 0 if that is not finite.
pub fn solve_holding<T: Float, A: SolvePosition<3>>(
    arm: &A,
    p: &Point3<T>,
    hold: &Joints<T, 3>,
) -> Solutions<T, 3, ArmPosture> {
    let [t1, t2, _] = finite(arm.rows(pose::entries(hold)));
    solve_choosing(arm, p, [t1, t2])
}

fn solve_choosing<T: Float, A: SolvePosition<3>>(
    arm: &A,
    p: &Point3<T>,
    hold: [Option<T>; 2],
) -> Solutions<T, 3, ArmPosture> {
    let (sliding, base) = (sliding(&A::JOINTS), arm.base::<T>());
    let wanted = pose::entries(&p.coords);
    let checked = if base.is_finite() { size(&wanted, base.reach()) } else { Err(Reason::NotAnArm) };
    let size = match checked {
        Ok(size) => size,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let placements = base.place(arm.tool_point(p), size, hold);
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for branch in ArmPosture::ALL {
        let slot = match branch.of(&placements) {
            Err(reason) => Slot::Empty(*reason),
            Ok(placed) => {
                let q = given_out(arm.command(placed.rows), &A::JOINTS);
                let free = Free {
                    shoulder: placed.shoulder_free.then(|| alone(0)),
                    elbow: placed.elbow_free.then(|| alone(1)),
                    wrist: None,
                };
                let margins = Margins { shoulder: placed.shoulder, elbow: placed.elbow, wrist: None };
                let (_, reached) = pose::rows(&arm.fk(&q));
                match accepted(distance(&reached, &wanted) / size) {
                    Ok(residual) => Slot::Solved(Solution { branch: *branch, q, residual, margins, free }),
                    Err(reason) => Slot::Empty(reason),
                }
            }
        };
        solutions.put(*branch, slot);
    }
    solutions.merge(base.reach());
    solutions
}

/// A joint that no other follows.
fn alone(joint: u8) -> Loose<3> {
    Loose::Follow { joint, moving: JointSet::EMPTY.with(usize::from(joint)) }
}
