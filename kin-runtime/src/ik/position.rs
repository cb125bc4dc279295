//! Three joints: the base alone puts the tool point in its place.

use crate::JointKind;
use crate::ik::target::{accepted, distance, size};
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use crate::private::SolvePosition;
use crate::solutions::{ArmPosture, Branch, Free, JointSet, Reason, Slot, Solution, Solutions};
use nalgebra::Point3;

/// All solutions; a free joint takes the value 0.
pub fn solve<T: Float, A: SolvePosition<3>>(arm: &A, p: &Point3<T>) -> Solutions<T, 3, ArmPosture> {
    solve_choosing(arm, p, None)
}

/// All solutions; a free joint keeps its value in `hold`.
pub fn solve_holding<T: Float, A: SolvePosition<3>>(
    arm: &A,
    p: &Point3<T>,
    hold: &Joints<T, 3>,
) -> Solutions<T, 3, ArmPosture> {
    let [t1, t2, _] = arm.rows(pose::entries(hold));
    solve_choosing(arm, p, Some([t1, t2]))
}

fn solve_choosing<T: Float, A: SolvePosition<3>>(
    arm: &A,
    p: &Point3<T>,
    hold: Option<[T; 2]>,
) -> Solutions<T, 3, ArmPosture> {
    let sliding = JointSet::sliding(A::JOINTS.iter().map(|joint| joint.kind));
    let reach = T::lit(arm.reach());
    let wanted = pose::entries(&p.coords);
    let size = match size(&wanted, reach) {
        Ok(size) => size,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let placements = arm.base::<T>().place(arm.tool_point(p), size, hold);
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for branch in ArmPosture::ALL {
        let slot = match branch.of(&placements) {
            Err(reason) => Slot::Empty(*reason),
            Ok(placed) => {
                let q = commanded(arm, placed.rows);
                let free = Free {
                    shoulder: placed.shoulder_free.then(|| JointSet::EMPTY.with(0)),
                    elbow: placed.elbow_free.then(|| JointSet::EMPTY.with(1)),
                    wrist: None,
                };
                let (_, reached) = pose::rows(&arm.fk(&q));
                match accepted(distance(&reached, &wanted) / size) {
                    Ok(residual) => Slot::Solved(Solution { branch: *branch, q, residual, free }),
                    Err(reason) => Slot::Empty(reason),
                }
            }
        };
        solutions.put(*branch, slot);
    }
    solutions.merge(reach);
    solutions
}

/// What the caller commands for these row values, angles in (-π, π].
fn commanded<T: Float, A: SolvePosition<3>>(arm: &A, rows: [T; 3]) -> Joints<T, 3> {
    let mut q = arm.command(rows);
    for (value, joint) in q.iter_mut().zip(&A::JOINTS) {
        if joint.kind == JointKind::Revolute {
            *value = math::wrap(*value);
        }
    }
    pose::column(q)
}
