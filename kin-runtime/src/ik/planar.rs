//! Bases whose joints 2 and 3 work in a plane at right angles to axis 2: figures over the shoulder, the elbow or the slide,
//! whether or not they touch.
//!
//! 1. Axis 2 carries the arm in a plane at right angles to it, at the lateral offset h: the wrist centre u in the
//!    turned frame has z2·u = h. That is a [chord](crate::geometry::circle_meets_plane) of the circle about axis 1 on
//!    which the wrist centre moves when joint 1 turns.
//! 2. In that plane, from the foot of axis 2, the wrist centre is at (X, V); two links span D = √(X² + V²)
//!    ([circles](crate::geometry::circle_meets_circle)), or a slide does.

use crate::geometry::{Chord, Span, circle_meets_circle, circle_meets_plane, turn};
use crate::ik::base::{Placed, Placements};
use crate::ik::wrist::{figure_angle, row_length, row_value};
use crate::ik::{ElbowBase, ROUND_OFF, TelescopeBase, elbow};
use crate::math::{self, Float};
use crate::solutions::{Boundary, Reason, Shoulder};

/// A base whose joints 2 and 3 work in a plane at right angles to axis 2.
pub(super) enum Planar<'a, T> {
    Elbow(&'a ElbowBase<T>),
    Telescope(&'a TelescopeBase<T>),
}

/// The first two axes: common to both kinds of base.
struct Stand<T> {
    a1: T,
    twist: (T, T),
    lateral: T,
    offset: [T; 2],
    reversed: [bool; 2],
}

/// The wrist centre seen from axis 1: its azimuth and its distance, and how it must lie once joint 1 is set.
struct Sight<T> {
    azimuth: T,
    radius: T,
    /// Across the common normal of axes 1 and 2, in the turned frame.
    across: T,
    /// In the arm's plane, at right angles to that normal.
    v: T,
    chord: Chord<T>,
}

/// The arm's plane, once joint 1 is set: its row value, the wrist centre in the plane, and whether joint 1 was free.
#[derive(Clone, Copy)]
struct Plane<T> {
    t1: T,
    x: T,
    v: T,
    free: bool,
}

/// How the links or the slide close over a distance: with the elbow up and down, the direction of the wrist centre less
/// ψ2, and the row value of joint 3.
struct Figure<T> {
    ways: [(T, T); 2],
    margin: T,
    free: bool,
}

/// Why they do not: the radius of the boundary circle, and the reason.
struct Open<T> {
    boundary: T,
    reason: Reason<T>,
}

impl<T: Float> Planar<'_, T> {
    pub(super) fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
        let (stand, window) = (self.stand(), T::lit(ROUND_OFF) * T::EPS * size);
        let sight = stand.sight(p, window);
        let [right, left] = match (self, sight.chord) {
            (Planar::Elbow(base), Chord::Cut(half)) if half > window => {
                elbow::both_shoulders(base, p, window)
            }
            _ => [None; 2],
        };
        let side = |regular: Option<[Placed<T>; 2]>, side| match regular {
            Some(placed) => placed.map(Ok),
            None => self.carefully(&stand, &sight, p, side, window, hold),
        };
        let ([right_up, right_down], [left_up, left_down]) =
            (side(right, Shoulder::Right), side(left, Shoulder::Left));
        [right_up, right_down, left_up, left_down]
    }

    /// One shoulder, up and down: what becomes of it, whether or not its figures touch.
    fn carefully(
        &self,
        stand: &Stand<T>,
        sight: &Sight<T>,
        p: [T; 3],
        side: Shoulder,
        window: T,
        hold: [Option<T>; 2],
    ) -> [Result<Placed<T>, Reason<T>>; 2] {
        let plane = stand.plane(p, sight, side, hold);
        let placed = plane.and_then(|plane| self.elbows(stand, sight, &plane, side, window, hold));
        placed.map_or_else(|reason| [Err(reason); 2], |placed| placed.map(Ok))
    }

    /// Up and down, once joint 1 is set, or nearly so.
    fn elbows(
        &self,
        stand: &Stand<T>,
        sight: &Sight<T>,
        plane: &Plane<T>,
        side: Shoulder,
        window: T,
        hold: [Option<T>; 2],
    ) -> Result<[Placed<T>; 2], Reason<T>> {
        self.close(stand, plane, side, window, hold).or_else(|open| {
            // Near the touching of the first figure its round-off is amplified in x: a boundary of the second
            // that is missed by no more than that is reached. And where joint 1 is free but for round-off, the
            // wrist centre's own azimuth reaches a boundary that the convention misses.
            let nudged = if plane.free {
                Some(stand.own(sight, side))
            } else {
                stand.nudged(plane, sight, side, open.boundary, window)
            };
            let closed = nudged.and_then(|plane| self.close(stand, &plane, side, window, hold).ok());
            closed.ok_or(open.reason)
        })
    }

    /// Joints 2 and 3 with the elbow up and down, once joint 1 is set.
    fn close(
        &self,
        stand: &Stand<T>,
        plane: &Plane<T>,
        side: Shoulder,
        window: T,
        hold: [Option<T>; 2],
    ) -> Result<[Placed<T>; 2], Open<T>> {
        let distance = math::hypot(plane.x, plane.v);
        let figure = match self {
            Planar::Elbow(base) => base.span(side, distance, window),
            Planar::Telescope(base) => base.slide(distance, window),
        };
        let figure = figure.map_err(|open| Open { reason: open.reason.at(plane.t1), ..open })?;
        let [_, held] = hold;
        let towards = math::atan2(plane.v, plane.x);
        Ok(figure.ways.map(|(lean, t3)| {
            let t2 =
                if figure.free { held.map_or(T::lit(0.0), math::wrap) } else { stand.second(towards - lean) };
            Placed {
                rows: [plane.t1, t2, t3],
                shoulder: if plane.free { T::lit(0.0) } else { math::abs(plane.x + stand.a1) },
                elbow: figure.margin,
                shoulder_free: plane.free,
                elbow_free: figure.free,
            }
        }))
    }

    pub(super) fn is_finite(&self) -> bool {
        let (offset, lengths) = match self {
            Planar::Elbow(base) => (base.offset, [base.upper, base.fore]),
            Planar::Telescope(base) => (base.offset, [base.arm, base.arm]),
        };
        let Stand { a1, twist: (sine, cosine), lateral, .. } = self.stand();
        let all = |values: &[T]| values.iter().all(|x| math::is_finite(*x));
        all(&offset) && all(&lengths) && all(&[a1, lateral, sine, cosine])
    }

    fn stand(&self) -> Stand<T> {
        let (a1, twist, lateral, offset, reversed) = match self {
            Planar::Elbow(b) => (b.a1, b.twist, b.lateral, b.offset, b.reversed),
            Planar::Telescope(b) => (b.a1, b.twist, b.lateral, b.offset, b.reversed),
        };
        let ([o1, o2, _], [r1, r2, _]) = (offset, reversed);
        Stand { a1, twist, lateral, offset: [o1, o2], reversed: [r1, r2] }
    }
}

impl<T: Float> Stand<T> {
    /// The first figure: the circle of the wrist centre about axis 1 meets the arm's plane.
    fn sight(&self, [px, py, pz]: [T; 3], window: T) -> Sight<T> {
        let (sine, cosine) = self.twist;
        // z2·u = h, solved for the part of u across the common normal.
        let across = (cosine * pz - self.lateral) / sine;
        let radius = math::hypot(px, py);
        Sight {
            azimuth: math::atan2(py, px),
            radius,
            across,
            v: cosine * across + sine * pz,
            chord: circle_meets_plane(radius, across, window),
        }
    }

    /// Joint 1: turns the arm's plane onto the wrist centre.
    fn plane(
        &self,
        [px, py, _]: [T; 3],
        sight: &Sight<T>,
        side: Shoulder,
        hold: [Option<T>; 2],
    ) -> Result<Plane<T>, Reason<T>> {
        match sight.chord {
            Chord::Apart(by) => Err(Reason::OutOfReach { by, towards: Boundary::Cylinder, theta1: None }),
            Chord::Cut(half) => Ok(self.turned(sight, if side == Shoulder::Right { half } else { -half })),
            Chord::Free => {
                let ([offset, _], [reversed, _]) = (self.offset, self.reversed);
                let [held, _] = hold;
                let t1 = held.map_or(T::lit(0.0), math::wrap);
                let (s, c) = math::sin_cos(figure_angle(t1, offset, reversed));
                let [along, _] = turn([px, py], (-s, c));
                Ok(Plane { t1, x: along - self.a1, v: sight.v, free: true })
            }
        }
    }

    /// The plane in which the wrist centre is this far along the common normal.
    fn turned(&self, sight: &Sight<T>, along: T) -> Plane<T> {
        let ([offset, _], [reversed, _]) = (self.offset, self.reversed);
        let t1 = row_value(sight.azimuth - math::atan2(sight.across, along), offset, reversed);
        Plane { t1, x: along - self.a1, v: sight.v, free: false }
    }

    /// The plane that a wrist centre almost on axis 1 lies in: one of those that a free first joint may choose.
    fn own(&self, sight: &Sight<T>, side: Shoulder) -> Plane<T> {
        let along = if side == Shoulder::Right { sight.radius } else { -sight.radius };
        Plane { free: true, ..self.turned(&Sight { across: T::lit(0.0), ..*sight }, along) }
    }

    /// The plane in which the wrist centre lies on the boundary circle of the second figure, if that is within
    /// round-off of the circle about axis 1. Where it lies so on both sides of the foot of axis 2, each shoulder has its own.
    fn nudged(
        &self,
        plane: &Plane<T>,
        sight: &Sight<T>,
        side: Shoulder,
        boundary: T,
        window: T,
    ) -> Option<Plane<T>> {
        if plane.free || math::abs(sight.v) - boundary > window {
            return None;
        }
        let x = math::sqrt_or_zero((boundary - sight.v) * (boundary + sight.v));
        let off = |x: T| math::abs(math::hypot(self.a1 + x, sight.across) - sight.radius);
        let near = if plane.x < T::lit(0.0) { -x } else { x };
        if off(near) > window {
            return None;
        }
        let own = if side == Shoulder::Right { x } else { -x };
        let along = self.a1 + if off(-near) <= window { own } else { near };
        Some(self.turned(sight, along))
    }

    fn second(&self, figure: T) -> T {
        let ([_, offset], [_, reversed]) = (self.offset, self.reversed);
        row_value(figure, offset, reversed)
    }
}

impl<T: Float> ElbowBase<T> {
    /// The elbow: two links span the distance.
    fn span(&self, side: Shoulder, distance: T, window: T) -> Result<Figure<T>, Open<T>> {
        let (bend, free) = match circle_meets_circle(self.upper, self.fore, distance, window) {
            Span::Bend(bend) => (bend, false),
            Span::Free => (math::half_turn(), true),
            Span::TooFar(by) => {
                return Err(Open {
                    boundary: self.upper + self.fore,
                    reason: Reason::beyond(by, Boundary::OuterCircle),
                });
            }
            Span::TooNear(by) => {
                let boundary = math::abs(self.upper - self.fore);
                return Err(Open { boundary, reason: Reason::beyond(by, Boundary::InnerCircle) });
            }
        };
        // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way,
        // and so it is where axis 2 points to the other side.
        let back = side == Shoulder::Left;
        let mirrored = self.twist.0 < T::lit(0.0);
        let up = if back == mirrored { -bend } else { bend };
        let ([_, _, offset], [_, _, reversed]) = (self.offset, self.reversed);
        let (s3, c3) = math::sin_cos(up);
        let lean = math::atan2(self.fore * s3, self.upper + self.fore * c3);
        let margin = math::min(bend, math::half_turn::<T>() - bend);
        let ways = [(lean, up), (-lean, -up)].map(|(lean, psi3)| (lean, row_value(psi3, offset, reversed)));
        Ok(Figure { ways, margin, free })
    }
}

impl<T: Float> TelescopeBase<T> {
    /// The slide: a right triangle of the arm b and the extension s.
    fn slide(&self, distance: T, window: T) -> Result<Figure<T>, Open<T>> {
        let ([_, _, offset], [_, _, reversed]) = (self.offset, self.reversed);
        let (extension, free) = match circle_meets_plane(distance, self.arm, window) {
            Chord::Cut(half) => (half, false),
            Chord::Free => (T::lit(0.0), true),
            Chord::Apart(by) => {
                let boundary = math::abs(self.arm);
                return Err(Open { boundary, reason: Reason::beyond(by, Boundary::InnerCircle) });
            }
        };
        let lean = math::atan2(extension, self.arm);
        let ways =
            [(lean, extension), (-lean, -extension)].map(|(lean, s)| (lean, row_length(s, offset, reversed)));
        Ok(Figure { ways, margin: extension, free })
    }
}
