//! Two or three joints: alone they put the tool point in its place.

use crate::arm::Arm;
use crate::ik::base::Placements;
use crate::ik::target::{accepted, distance, size};
use crate::ik::{Base, PairBase, finite, given_out, sliding};
use crate::math::Float;
use crate::pose::{self, Joints};
use crate::private::{Carried, SolvePosition};
use crate::solutions::{ArmPosture, Free, JointSet, Loose, Margins, Reason, Slot, Solution, Solutions};
use nalgebra::Point3;

/// The joints that carry a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Carrier<T> {
    /// Three of them: through space.
    Three(Base<T>),
    /// Two: on a surface.
    Two(PairBase<T>),
}

impl<T: Float> Carrier<T> {
    /// Whether every constant is a finite number.
    pub fn is_finite(&self) -> bool {
        match self {
            Carrier::Three(base) => base.is_finite(),
            Carrier::Two(pair) => pair.is_finite(),
        }
    }

    /// The arm's reach.
    pub fn reach(&self) -> T {
        match self {
            Carrier::Three(base) => base.reach(),
            Carrier::Two(pair) => pair.reach,
        }
    }

    /// All ways of putting the point at `p`, in the carrier's own frame: see [`Base::place`].
    pub fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
        match self {
            Carrier::Three(base) => base.place(p, size, hold),
            Carrier::Two(pair) => {
                let [first, _] = hold;
                pair.place(p, size, first)
            }
        }
    }
}

/// All solutions of an arm of three joints; a free joint takes the value 0.
pub fn solve<T: Float, A: SolvePosition<3>>(arm: &A, p: &Point3<T>) -> Solutions<T, 3, ArmPosture> {
    place(arm, &Carrier::Three(arm.base()), (p, arm.tool_point(p)), [None; 2], &|rows| arm.command(rows))
}

/// All solutions; a free joint keeps its value in `hold`, or takes 0 if that is not finite.
pub fn solve_holding<T: Float, A: SolvePosition<3>>(
    arm: &A,
    p: &Point3<T>,
    hold: &Joints<T, 3>,
) -> Solutions<T, 3, ArmPosture> {
    let [t1, t2, _] = finite(arm.rows(pose::entries(hold)));
    place(arm, &Carrier::Three(arm.base()), (p, arm.tool_point(p)), [t1, t2], &|rows| arm.command(rows))
}

/// All joint values that bring the tool point to a place, given in the world and in the carrier's frame.
pub(crate) fn place<T: Float, const N: usize, A: Arm<N>, B: Carried>(
    arm: &A,
    carrier: &Carrier<T>,
    (wanted, point): (&Point3<T>, [T; 3]),
    hold: [Option<T>; 2],
    command: &dyn Fn([T; 3]) -> [T; N],
) -> Solutions<T, N, B> {
    let sliding = sliding(&A::JOINTS);
    let wanted = pose::entries(&wanted.coords);
    let checked = if carrier.is_finite() { size(&wanted, carrier.reach()) } else { Err(Reason::NotAnArm) };
    let size = match checked {
        Ok(size) => size,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let placements = carrier.place(point, size, hold);
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for branch in B::ALL {
        let slot = match branch.base().pick(placements.each_ref()) {
            Err(reason) => Slot::Empty(*reason),
            Ok(placed) => {
                let q = given_out(command(placed.rows), &A::JOINTS);
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
    solutions.merge(carrier.reach());
    solutions
}

/// A joint that no other follows.
fn alone<const N: usize>(joint: u8) -> Loose<N> {
    Loose::Follow { joint, moving: JointSet::EMPTY.with(usize::from(joint)) }
}
