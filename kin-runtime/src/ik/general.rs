//! Any three joints that carry a point: their axes as lines, solved by where two [conics](crate::ik::conic) meet.
//!
//! 1. Joint 3 moves the carried point on a circle or a line; joint 1, taken back, does so with the point to be reached. In
//!    the plane of what joint 2 cannot change both are conics, and their meeting points give joints 1 and 3.
//! 2. Joint 2 turns, or slides, the one onto the other.
//! 3. The three values are refined together on the arm itself: a damped Newton step, kept only if it comes nearer. Where two
//!    ways meet the figures are flat and round-off grows to its square root; the step takes that back.
//!
//! # Labels
//!
//! A base whose axes 1 and 2, or 2 and 3, lie in one plane has two ways for joint 1 (right, left) times two for joint 3 (up,
//! down). Else up and down tell the sign of the Jacobian's determinant, which cannot change but through a singular pose, and
//! right and left are the order of joint 3's value among those of the same sign.

use crate::ik::base::{Placed, Placements};
use crate::ik::conic::{self, Path, Way};
use crate::ik::refine::{STEPS, Side};
use crate::ik::{ACCEPTED, ROUND_OFF};
use crate::math::{self, Float};
use crate::pose::dot;
use crate::solutions::{ArmPosture, Boundary, Branch, Reason, Shoulder, tolerance};

/// The axis of a joint, where the arm stands with all figure values zero.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axis<T> {
    /// Whether the joint slides along it instead of turning about it.
    pub slides: bool,
    /// Its unit direction, in which a slide's value grows and about which a turn's does, in the axes of the first row's frame.
    pub direction: [T; 3],
    /// A point of it, in the same axes, from the base's origin.
    pub point: [T; 3],
}

/// Three joints of any kind and the point that they carry, in the axes of the first row's frame, from an origin on axis 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GeneralBase<T> {
    /// The axes of joints 1, 2 and 3.
    pub axes: [Axis<T>; 3],
    /// The carried point, where the arm stands with all figure values zero.
    pub carried: [T; 3],
    /// The figure values where the row values are 0.
    pub offset: [T; 3],
    /// The arm's reach.
    pub reach: T,
}

/// How far, in √ε of the size, a figure may stay open and still be handed to the refinement: the round-off of a double root.
pub(super) const SLACK: f64 = 64.0;

pub(super) fn less<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a - x, b - y, c - z]
}

pub(super) fn plus<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3], times: T) -> [T; 3] {
    [a + times * x, b + times * y, c + times * z]
}

pub(super) fn cross<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// What a symmetric positive definite matrix, by rows, takes to `right`: Cramer's rule. None if rounding has made it singular.
pub(super) fn solved<T: Float>([r0, r1, r2]: [[T; 3]; 3], right: [T; 3]) -> Option<[T; 3]> {
    // The columns of the adjugate are cross products of the rows.
    let (k0, k1, k2) = (cross(r1, r2), cross(r2, r0), cross(r0, r1));
    let determinant = dot(&r0, &k0);
    if determinant <= T::lit(0.0) {
        return None;
    }
    let [m0, m1, m2] = right.map(|m| m / determinant);
    Some(plus(plus(k0.map(|k| k * m0), k1, m1), k2, m2))
}

pub(super) fn length<T: Float>(v: [T; 3]) -> T {
    math::sqrt(dot(&v, &v))
}

pub(super) fn largest<T: Float>([a, b, c]: [T; 3]) -> T {
    math::max(math::max(math::abs(a), math::abs(b)), math::abs(c))
}

/// A unit vector at right angles to a unit vector, made with the coordinate axis that it is farthest from.
pub(super) fn across<T: Float>(z @ [x, y, w]: [T; 3]) -> [T; 3] {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let (x, y, w) = (math::abs(x), math::abs(y), math::abs(w));
    let farthest = if x <= y && x <= w {
        [one, zero, zero]
    } else if y <= w {
        [zero, one, zero]
    } else {
        [zero, zero, one]
    };
    let v = cross(farthest, z);
    v.map(|c| c / length(v))
}

impl<T: Float> Axis<T> {
    /// From the foot on the axis to the point.
    pub(super) fn arm(&self, point: [T; 3]) -> [T; 3] {
        let offset = less(point, self.point);
        plus(offset, self.direction, -dot(&self.direction, &offset))
    }

    /// How far from the axis a point is; none where the joint slides, which does not turn it.
    pub(super) fn distance(&self, point: [T; 3]) -> Option<T> {
        (!self.slides).then(|| length(self.arm(point)))
    }

    /// A vector turned by the joint's value.
    pub(super) fn turned(&self, v: [T; 3], value: T) -> [T; 3] {
        if self.slides {
            return v;
        }
        let (s, c) = math::sin_cos(value);
        let along = dot(&self.direction, &v);
        let [x, y, z] = plus(v, self.direction, -along);
        plus(plus([c * x, c * y, c * z], cross(self.direction, v), s), self.direction, along)
    }

    /// A point moved by the joint's value.
    pub(super) fn moved(&self, point: [T; 3], value: T) -> [T; 3] {
        if self.slides {
            plus(point, self.direction, value)
        } else {
            plus(self.turned(less(point, self.point), value), self.point, T::lit(1.0))
        }
    }

    /// How a point moves with the joint's value.
    pub(super) fn velocity(&self, point: [T; 3]) -> [T; 3] {
        if self.slides { self.direction } else { cross(self.direction, less(point, self.point)) }
    }
}

/// What joint 2 cannot change of a point.
struct View<T> {
    axis: Axis<T>,
    /// Across the direction of a slide.
    across: [[T; 3]; 2],
}

impl<T: Float> View<T> {
    fn new(axis: &Axis<T>, near: [T; 3]) -> Self {
        let x = across(axis.direction);
        let along = dot(&axis.direction, &less(near, axis.point));
        let point = plus(axis.point, axis.direction, along);
        View { axis: Axis { point, ..*axis }, across: [x, cross(axis.direction, x)] }
    }

    /// The path of a point from the middle, in directions x and y of length one.
    fn circle(&self, centre: [T; 3], x: [T; 3], y: [T; 3], radius: T) -> Path<T> {
        let z = &self.axis.direction;
        if self.axis.slides {
            let seen = |v: [T; 3]| self.across.map(|a| dot(&a, &v));
            return Path::Circle { centre: seen(centre), x: seen(x), y: seen(y), radius };
        }
        let offset = less(centre, self.axis.point);
        let half = (dot(&offset, &offset) + radius * radius) * T::lit(0.5);
        let seen = |v: [T; 3]| [dot(z, &v), dot(&offset, &v)];
        Path::Circle { centre: [dot(z, &offset), half], x: seen(x), y: seen(y), radius }
    }

    fn line(&self, start: [T; 3], along: [T; 3]) -> Path<T> {
        let (zero, half) = (T::lit(0.0), T::lit(0.5));
        if self.axis.slides {
            let seen = |v: [T; 3]| self.across.map(|a| dot(&a, &v));
            return Path::Line { start: seen(start), along: seen(along), square: [zero; 2] };
        }
        let (z, offset) = (&self.axis.direction, less(start, self.axis.point));
        Path::Line {
            start: [dot(z, &offset), dot(&offset, &offset) * half],
            along: [dot(z, &along), dot(&offset, &along)],
            square: [zero, half],
        }
    }
}

/// The base and the point to be reached, all lengths divided by the size.
pub(super) struct Sized<T> {
    pub(super) axes: [Axis<T>; 3],
    pub(super) carried: [T; 3],
    pub(super) point: [T; 3],
    /// Of the point about axis 1.
    radius: T,
}

impl<T: Float> GeneralBase<T> {
    /// Whether every constant is a finite number: parameters may have made it otherwise.
    pub fn is_finite(&self) -> bool {
        let all = |values: &[T]| values.iter().all(|x| math::is_finite(*x));
        let axes = self.axes.iter().all(|axis| all(&axis.direction) && all(&axis.point));
        axes && all(&self.carried) && all(&self.offset)
    }

    /// All ways of putting the carried point at `p`. `size` is what round-off is compared with; `hold` are row values for
    /// joints that turn out to be free.
    pub fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
        let [held1, held2] = hold;
        let sized = self.sized(p, size);
        let (window, slack) = (T::lit(ROUND_OFF) * T::EPS, T::lit(SLACK) * math::sqrt(T::EPS));
        let [first, second, third] = &sized.axes;
        let view = View::new(second, plus(sized.carried, third.arm(sized.carried), -T::lit(1.0)));
        let (from, azimuth) = sized.first_path(&view, first);
        let to = sized.third_path(&view, third);
        let [o1, o2, o3] = self.offset;
        let ways = conic::meet(&from, &to, window, slack, o3);
        let mut found = [None; 4];
        ArmPosture::slots(|posture| {
            let mut way = (*posture.of(&ways)).ok_or(Reason::NoSuchBranch)?;
            let shared = ways.iter().flatten().filter(|other| way.is_beside(other)).count() > 1;
            way.first = match (way.free, held1, azimuth) {
                // Whole turns are taken off first: many of them would leave no digits for the offset.
                (true, Some(t1), _) => math::wrap(t1) + o1,
                (true, None, _) => o1,
                (false, _, Some(azimuth)) => azimuth - way.first,
                (false, _, None) => way.first,
            };
            let (side, held2) = (Side { posture, shared, told: None }, held2.map(|t2| math::wrap(t2) + o2));
            let mut settled = sized.settled((&way, side), held2, o2, window);
            // Two ways that have come to one root may have left out another.
            if let Ok((values, _)) = settled
                && !way.free
                && sized.are_in(values, &found)
            {
                for (way, side) in sized.anew((&way, side), values).into_iter().flatten() {
                    let other = sized.settled((&way, side), held2, o2, window);
                    if let Ok((values, _)) = other
                        && !sized.are_in(values, &found)
                    {
                        settled = other;
                        break;
                    }
                }
            }
            *posture.of_mut(&mut found) = settled.as_ref().ok().map(|(values, _)| *values);
            settled
                .map(|(values, placed)| placed.placed(self, values, size))
                .map_err(|by| Reason::OutOfReach { by: by * size, towards: Boundary::Envelope, theta1: None })
        })
    }

    /// Row values from figure values, lengths of which are parts of the size.
    pub(super) fn rows(&self, [v1, v2, v3]: [T; 3], size: T) -> [T; 3] {
        let ([a, b, c], [o1, o2, o3]) = (&self.axes, self.offset);
        let row = |axis: &Axis<T>, value: T, offset: T| {
            if axis.slides { value * size - offset } else { math::wrap(value - offset) }
        };
        [row(a, v1, o1), row(b, v2, o2), row(c, v3, o3)]
    }

    /// The distance of a point from axis 1; none where joint 1 slides.
    pub(super) fn first_distance(&self, p: [T; 3]) -> Option<T> {
        let [first, ..] = &self.axes;
        first.distance(p)
    }

    /// The distance of the carried point from axis 2; none where joint 2 slides.
    pub(super) fn second_distance(&self, placed: &Placed<T>) -> Option<T> {
        let ([_, second, third], [_, _, o3], [_, _, t3]) = (&self.axes, self.offset, placed.rows);
        second.distance(third.moved(self.carried, t3 + o3))
    }

    /// The part of how joint 1, or 2, moves the point that the other two do not make up for, at most, as it turns: the sine of the angle
    /// between its axis and the normal of the plane in which they move it; all of it, where they move it along one line.
    pub(super) fn alone(&self, placed: &Placed<T>, joint: usize) -> T {
        let ([first, second, third], [_, o2, o3], [_, t2, t3]) = (&self.axes, self.offset, placed.rows);
        let (lifted, v2) = (third.moved(self.carried, t3 + o3), t2 + o2);
        let last = second.turned(third.velocity(lifted), v2);
        let point = second.moved(lifted, v2);
        let (axis, other) = if joint == 0 { (first, second) } else { (second, first) };
        let (other, axis) = (other.velocity(point), axis.direction);
        let normal = cross(other, last);
        let size = length(normal);
        if size > math::sqrt(T::EPS) * length(other) * length(last) {
            length(cross(axis, normal)) / size
        } else {
            T::lit(1.0)
        }
    }

    pub(super) fn sized(&self, p: [T; 3], size: T) -> Sized<T> {
        let scaled = |v: [T; 3]| v.map(|c| c / size);
        let axes = self.axes.map(|axis| Axis { point: scaled(axis.point), ..axis });
        let [first, ..] = &axes;
        let point = scaled(p);
        Sized { radius: length(first.arm(point)), carried: scaled(self.carried), point, axes }
    }
}

/// What became of a way, before its values are those of the rows.
struct Settled<T> {
    shoulder: T,
    elbow: T,
    free: [bool; 2],
}

impl<T: Float> Settled<T> {
    fn placed(&self, base: &GeneralBase<T>, values: [T; 3], size: T) -> Placed<T> {
        let [shoulder_free, elbow_free] = self.free;
        let placed = Placed {
            rows: base.rows(values, size),
            shoulder: self.shoulder * size,
            elbow: self.elbow,
            shoulder_free,
            elbow_free,
        };
        // Near axis 2 the motion of joint 2 is short: its direction is as good as any, and neither of the others tells of it.
        let second = base.second_distance(&placed).map_or(placed.elbow, |distance| distance / base.reach);
        Placed { elbow: math::min(placed.elbow, second), ..placed }
    }
}

impl<T: Float> Sized<T> {
    /// Whether the values are some of those found.
    fn are_in(&self, values: [T; 3], found: &[Option<[T; 3]>; 4]) -> bool {
        let [a, b, c] = self.axes.each_ref().map(|axis| axis.slides);
        let near =
            |slides: bool, gap: T, most: T| math::abs(if slides { gap } else { math::wrap(gap) }) <= most;
        // Beside axis 1 round-off turns joint 1 by more, beside axis 2 joint 2.
        let turned =
            |distance: T| math::max(tolerance(), T::lit(ROUND_OFF) * T::EPS / math::max(distance, T::EPS));
        let [_, _, v3] = values;
        let first = if self.is_beside_first() { turned(self.radius) } else { tolerance() };
        let second = || self.second_arm(v3).map_or(tolerance(), turned);
        found.iter().flatten().any(|other| {
            let [x, y, z] = less(values, *other);
            near(a, x, first) && near(c, z, tolerance()) && near(b, y, second())
        })
    }

    /// The point to be reached, moved back by joint 1; the azimuth from which a turning joint's angle is taken.
    fn first_path(&self, view: &View<T>, axis: &Axis<T>) -> (Path<T>, Option<T>) {
        let z = axis.direction;
        if axis.slides {
            return (view.line(self.point, z.map(|c| -c)), None);
        }
        let arm = axis.arm(self.point);
        let x = across(z);
        let y = cross(z, x);
        let azimuth = math::atan2(dot(&y, &arm), dot(&x, &arm));
        (view.circle(less(self.point, arm), x, y, self.radius), Some(azimuth))
    }

    /// The carried point, moved by joint 3.
    fn third_path(&self, view: &View<T>, axis: &Axis<T>) -> Path<T> {
        if axis.slides {
            return view.line(self.carried, axis.direction);
        }
        let arm = axis.arm(self.carried);
        let radius = length(arm);
        let x = if radius > T::lit(0.0) { arm.map(|c| c / radius) } else { across(axis.direction) };
        view.circle(less(self.carried, arm), x, cross(axis.direction, x), radius)
    }

    /// Whether the point is so near axis 1 that next to nothing is known of joint 1, and not so near that it is free: all its values
    /// lead to the point within what a way may miss.
    pub(super) fn is_beside_first(&self) -> bool {
        let [first, ..] = &self.axes;
        let (least, most) = (T::lit(ACCEPTED * 0.25) * T::EPS, T::lit(SLACK) * math::sqrt(T::EPS));
        !first.slides && self.radius > least && self.radius <= most
    }

    /// How far from axis 2 the point is carried at a value of joint 3; none where joint 2 slides.
    pub(super) fn second_arm(&self, value: T) -> Option<T> {
        let [_, second, third] = &self.axes;
        second.distance(third.moved(self.carried, value))
    }

    /// Joint 2, then all three refined. The error is by how much the point is missed.
    fn settled(
        &self,
        (way, side): (&Way<T>, Side),
        hold: Option<T>,
        convention: T,
        window: T,
    ) -> Result<([T; 3], Settled<T>), T> {
        let [first, second, third] = &self.axes;
        let mut way = self.beside_second(way, side);
        let beside_first = way.free && self.is_beside_first();
        if beside_first {
            (way.first, way.free) = (T::lit(0.0), false);
        }
        let from = third.moved(self.carried, way.third);
        let to = first.moved(self.point, -way.first);
        let (arm, goal) = (second.arm(from), second.arm(to));
        let turned = || math::atan2(dot(&second.direction, &cross(arm, goal)), dot(&arm, &goal));
        let value = if second.slides { dot(&second.direction, &less(to, from)) } else { turned() };
        if beside_first {
            // The conics know the square of a distance, to which joint 1 adds less than round-off; to the place it adds more.
            let opposite =
                if side.posture.shoulder == Shoulder::Left { math::half_turn() } else { T::lit(0.0) };
            way.first = self.facing([way.first, value, way.third]) + opposite;
        }
        let far = way.open
            && largest(less(second.moved(from, value), to)) > T::lit(SLACK * SLACK) * math::sqrt(T::EPS);
        let (mut values, mut stance) =
            self.refined([way.first, value, way.third], (way.free, side), if far { 0 } else { STEPS });
        // Asked of what the refinement leaves: a point that passes axis 2 is nearest to it in a flat figure.
        let [first_value, _, third_value] = values;
        let folded = self.second_arm(third_value).is_some_and(|arm| arm <= window);
        if folded {
            values = [first_value, hold.unwrap_or(convention), third_value];
            stance = self.stance(values, way.free);
        }
        let miss = largest(stance.missed);
        // A figure that closed but for its round-off may still be open where that is magnified: what is missed decides.
        let reached = if way.open { window + window } else { T::lit(ACCEPTED * 0.5) * T::EPS };
        if miss > reached {
            return Err(length(stance.missed));
        }
        let [j1, j2, j3] = stance.velocities;
        let (pair, speed) = (cross(j1, j2), length(j2));
        let shoulder = if folded || way.free { T::lit(0.0) } else { length(pair) / speed };
        // The angle between the third motion and the plane of the first two.
        let elbow = math::atan2(math::abs(dot(&pair, &j3)), length(cross(pair, j3)));
        Ok((values, Settled { shoulder, elbow, free: [way.free, folded] }))
    }
}

#[cfg(test)]
mod tests;
