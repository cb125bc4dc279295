//! Two joints that carry a point: in a plane or in space, turning or sliding.
//!
//! They are the last two of a [general base](crate::ik::general) whose first joint has nothing to turn: its axis passes through
//! the point to be reached. The point moves on a surface only, so that most points are not reached.

use crate::ik::base::Placements;
use crate::ik::general::{Axis, GeneralBase, cross, length, less};
use crate::ik::position::{self, Carrier};
use crate::ik::{ROUND_OFF, finite};
use crate::math::{self, Float};
use crate::pose::{self, Joints, dot};
use crate::private::SolvePair;
use crate::solutions::{Boundary, Elbow, Reason, Solutions};
use nalgebra::Point3;

/// Two joints of any kind and the point that they carry, in the axes of the first row's frame, from an origin on axis 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PairBase<T> {
    /// The axes of joints 1 and 2.
    pub axes: [Axis<T>; 2],
    /// The carried point, where the arm stands with all figure values zero.
    pub carried: [T; 3],
    /// The figure values where the row values are 0.
    pub offset: [T; 2],
    /// The arm's reach.
    pub reach: T,
}

/// All solutions of an arm of two joints; a free joint takes the value 0.
pub fn solve<T: Float, A: SolvePair<2>>(arm: &A, p: &Point3<T>) -> Solutions<T, 2, Elbow> {
    place(arm, p, None)
}

/// All solutions; a free joint keeps its value in `hold`, or takes 0 if that is not finite.
pub fn solve_holding<T: Float, A: SolvePair<2>>(
    arm: &A,
    p: &Point3<T>,
    hold: &Joints<T, 2>,
) -> Solutions<T, 2, Elbow> {
    let [first, _] = finite(arm.rows(pose::entries(hold)));
    place(arm, p, first)
}

fn place<T: Float, A: SolvePair<2>>(arm: &A, p: &Point3<T>, hold: Option<T>) -> Solutions<T, 2, Elbow> {
    let carrier = Carrier::Two(arm.base::<T>());
    let command = |[t1, t2, _]: [T; 3]| arm.command([t1, t2]);
    position::place(arm, &carrier, (p, arm.tool_point(p)), [hold, None], &command)
}

impl<T: Float> PairBase<T> {
    /// Whether every constant is a finite number: parameters may have made it otherwise.
    pub fn is_finite(&self) -> bool {
        let all = |values: &[T]| values.iter().all(|x| math::is_finite(*x));
        let axes = self.axes.iter().all(|axis| all(&axis.direction) && all(&axis.point));
        axes && all(&self.carried) && all(&self.offset)
    }

    /// All ways of putting the carried point at `p`; the third value of a placement is nothing. Both shoulders are one. Where no
    /// way leads there, a figure's distance is that of the surface.
    pub fn place(&self, p: [T; 3], size: T, hold: Option<T>) -> Placements<T> {
        let placements = self.behind(p).place(p, size, [None, hold]);
        let surface = placements.iter().all(|placement| placement.is_err()).then(|| self.distance(p));
        placements.map(|placement| {
            let mut placed = placement.map_err(|reason| match reason {
                Reason::OutOfReach { by, .. } => {
                    let by = surface.map_or(by, |least| math::min(by, least));
                    Reason::OutOfReach { by, towards: Boundary::Surface, theta1: None }
                }
                other => other,
            })?;
            let [_, t1, t2] = placed.rows;
            let free = placed.elbow_free;
            (placed.shoulder, placed.elbow) = self.margins([t1, t2], size);
            if free {
                placed.shoulder = T::lit(0.0);
            }
            (placed.rows, placed.shoulder_free, placed.elbow_free) = ([t1, t2, T::lit(0.0)], free, false);
            Ok(placed)
        })
    }

    /// Where the carried point is, and before the first joint has moved it.
    fn carried_to(&self, [t1, t2]: [T; 2]) -> ([T; 3], [T; 3]) {
        let ([first, second], [o1, o2]) = (&self.axes, self.offset);
        let lifted = second.moved(self.carried, t2 + o2);
        (first.moved(lifted, t1 + o1), lifted)
    }

    /// How far `p` is from all that the carried point comes to.
    fn distance(&self, p: [T; 3]) -> T {
        let (nearest, _) = self.carried_to(self.closest(p));
        length(less(nearest, p))
    }

    /// The row values that bring the carried point nearest to `p`.
    pub(super) fn closest(&self, p: [T; 3]) -> [T; 2] {
        let [_, t1, t2] = self.behind(p).closest(p);
        [t1, t2]
    }

    /// The base of three joints whose first one turns about the point to be reached.
    fn behind(&self, p: [T; 3]) -> GeneralBase<T> {
        let ([first, second], [o1, o2]) = (self.axes, self.offset);
        let still = Axis { slides: false, point: p, ..first };
        let offset = [T::lit(0.0), o1, o2];
        GeneralBase { axes: [still, first, second], carried: self.carried, offset, reach: self.reach }
    }

    /// The distance of the point from axis 1, and the angle between the two motions, whichever way they go; where axis 1
    /// slides its distance is not asked for.
    fn margins(&self, [t1, t2]: [T; 2], size: T) -> (T, T) {
        let ([first, second], [o1, _]) = (&self.axes, self.offset);
        let (placed, lifted) = self.carried_to([t1, t2]);
        let (one, two) = (first.velocity(placed), first.turned(second.velocity(lifted), t1 + o1));
        let across = cross(one, two);
        let sine = math::sqrt(dot(&across, &across));
        let far = if first.slides { size } else { math::sqrt(dot(&one, &one)) };
        let angle = math::atan2(sine, math::abs(dot(&one, &two)));
        (far, if sine <= T::lit(ROUND_OFF) * T::EPS * size { T::lit(0.0) } else { angle })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_constant_must_be_a_number() {
        let axis = Axis { slides: false, direction: [0.0, 0.0, 1.0], point: [0.1, 0.2, 0.3] };
        let whole = PairBase { axes: [axis; 2], carried: [0.4, 0.5, 0.6], offset: [0.0; 2], reach: 1.0 };
        assert!(whole.is_finite());
        for spoiled in [f64::NAN, f64::INFINITY] {
            for i in 0..3 {
                for part in 0..2 {
                    let (mut direction, mut point, mut carried, mut offset) = (whole, whole, whole, whole);
                    direction.axes[part].direction[i] = spoiled;
                    point.axes[part].point[i] = spoiled;
                    carried.carried[i] = spoiled;
                    offset.offset[part] = spoiled;
                    for pair in [direction, point, carried, offset] {
                        assert!(!pair.is_finite(), "{pair:?}");
                    }
                }
            }
        }
    }
}
