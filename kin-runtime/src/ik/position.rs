//! Two or three joints: alone they put the tool point in its place.

use crate::arm::Arm;
use crate::ik::base::{Placed, Placements};
use crate::ik::general::{Axis, GeneralBase, SLACK};
use crate::ik::target::{accepted, distance, size};
use crate::ik::{Base, PairBase, finite, given_out, sliding};
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use crate::private::{Carried, SolvePosition};
use crate::solutions::{ArmPosture, Free, JointSet, Loose, Margins, Reason, Slot, Solution, Solutions};
use nalgebra::Point3;

/// The angle from folded, or the extension over the reach, below which the links may bring the point beside axis 2.
const FOLDED: f64 = 1.0 / 64.0;

/// How far from axis 2 that is where the figure of joint 1 touches, times the fourth root of ε and the size.
const TWICE: f64 = 0.25;

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

    /// Whether the point is all but on the last axis that carries it, as lengths that are parameters may have it: its place says next to
    /// nothing of that joint then.
    pub(crate) fn leaves_last(&self) -> bool {
        let near = T::lit(SLACK) * math::sqrt(T::EPS) * self.reach();
        let distance = match self {
            Carrier::Three(Base::Elbow(base)) => Some(base.fore),
            Carrier::Three(Base::Telescope(_)) => None,
            Carrier::Three(Base::General(GeneralBase { axes: [_, _, last], carried, .. }))
            | Carrier::Two(PairBase { axes: [_, last], carried, .. }) => last.distance(*carried),
        };
        distance.is_some_and(|distance| distance <= near)
    }

    /// Whether the point is so near the axes of joints 1 and 2 that its place says next to nothing of them: where two ways meet, the
    /// figures know it to the root of their round-off.
    pub(crate) fn beside(&self, placed: &Placed<T>, size: T) -> [bool; 2] {
        let root = math::sqrt(T::EPS);
        let near = T::lit(SLACK) * root * size;
        // Where the figure of joint 1 touches, its own round-off is that root, and seen from axis 2 it counts as long as it is more
        // than what two solutions may be apart.
        let near_second = if placed.shoulder <= near {
            math::max(near, T::lit(TWICE) * math::sqrt(root) * size)
        } else {
            near
        };
        let is_near = |axis: &Axis<T>, point, near| axis.distance(point).is_some_and(|far| far <= near);
        let [_, t2, t3] = placed.rows;
        match self {
            Carrier::Three(base) => {
                let unit = match base {
                    Base::Elbow(_) => T::lit(1.0),
                    Base::Telescope(base) => base.reach,
                    Base::General(_) => T::lit(f64::INFINITY),
                };
                // In a plane the axes are passed only where a figure is all but singular.
                if placed.shoulder > near && placed.elbow > unit * T::lit(FOLDED) {
                    return [false; 2];
                }
                let base = base.lines();
                let ([first, second, third], [_, o2, o3]) = (&base.axes, base.offset);
                let lifted = third.moved(base.carried, t3 + o3);
                [is_near(first, second.moved(lifted, t2 + o2), near), is_near(second, lifted, near_second)]
            }
            // The shoulder of a pair is the distance from axis 1.
            Carrier::Two(_) => [placed.shoulder <= near, false],
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
