//! The first three joints: where they put the wrist centre, by figures over the shoulder, the elbow or the slide.
//!
//! # The shoulder frame
//!
//! z along joint axis 1; the origin at the foot, on axis 1, of the common normal of axes 1 and 2; x along that normal
//! towards axis 2. ψ1 turns this frame about z; in the turned frame axis 2 passes through (a1, 0, 0) in the direction
//! z2 = (0, -sin α, cos α), the twist α being counted about x. ψ2 and ψ3 turn about z2.
//!
//! # The figures
//!
//! 1. Axis 2 carries the arm in a plane at right angles to it, at the lateral offset h: the wrist centre u in the
//!    turned frame has z2·u = h. That is a [chord](crate::geometry::circle_meets_plane) of the circle about axis 1 on
//!    which the wrist centre moves when joint 1 turns.
//! 2. In that plane, from the foot of axis 2, the wrist centre is at (X, V); two links span D = √(X² + V²)
//!    ([circles](crate::geometry::circle_meets_circle)), or a slide does.

use crate::geometry::{Chord, Span, circle_meets_circle, circle_meets_plane};
use crate::ik::BOUNDARY;
use crate::ik::wrist::{figure_angle, row_length, row_value};
use crate::math::{self, Float};
use crate::solutions::{ArmPosture, Boundary, Branch, Elbow, Reason, Shoulder};

/// The constants of the first three joints: generated code writes them, or a run-time loader.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Base<T> {
    /// Three revolute joints, axes 2 and 3 parallel.
    Elbow(ElbowBase<T>),
    /// Two revolute joints and a slide at right angles to axis 2.
    Telescope(TelescopeBase<T>),
}

/// Three revolute joints with axes 2 and 3 parallel: shoulder, upper arm and forearm.
///
/// Figure angles from row values: ψ = offset + t, or offset - t where the joint is reversed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ElbowBase<T> {
    /// The distance between axes 1 and 2, not negative.
    pub a1: T,
    /// Sine and cosine of the angle from axis 1 to axis 2 about their common normal; the sine is not zero.
    pub twist: (T, T),
    /// The distance of the wrist centre, along axis 2, from the foot of the common normal: h.
    pub lateral: T,
    /// The distance between axes 2 and 3, positive.
    pub upper: T,
    /// The distance of the wrist centre from axis 3, positive.
    pub fore: T,
    /// The figure angles where the row values are 0.
    pub offset: [T; 3],
    /// Whether a figure angle falls where its row value rises.
    pub reversed: [bool; 3],
    /// The arm's reach.
    pub reach: T,
}

/// Two revolute joints and a slide at right angles to axis 2, as in the Stanford arm.
///
/// ψ3 is a length s along the slide, from the foot of the perpendicular on axis 2 (where the slide's line misses it).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TelescopeBase<T> {
    /// The distance between axes 1 and 2, not negative.
    pub a1: T,
    /// Sine and cosine of the angle from axis 1 to axis 2 about their common normal; the sine is not zero.
    pub twist: (T, T),
    /// The distance of the wrist centre, along axis 2, from the foot of the common normal: h.
    pub lateral: T,
    /// The distance between axis 2 and the line on which the wrist centre slides, not negative: b. The wrist centre is
    /// at Rz(ψ2)·(b, s).
    pub arm: T,
    /// The figure angles, and the figure length, where the row values are 0.
    pub offset: [T; 3],
    /// Whether a figure value falls where its row value rises.
    pub reversed: [bool; 3],
    /// The arm's reach.
    pub reach: T,
}

/// Row values that put the wrist centre in its place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Placed<T> {
    /// Of joints 1, 2 and 3.
    pub rows: [T; 3],
    /// Whether joint 1 may take any other value.
    pub shoulder_free: bool,
    /// Whether joint 2 may take any other value.
    pub elbow_free: bool,
}

/// What became of the four branches of the base.
pub type Placements<T> = <ArmPosture as Branch>::Slots<Result<Placed<T>, Reason<T>>>;

/// The first two axes: common to both kinds of base.
struct Stand<T> {
    a1: T,
    twist: (T, T),
    lateral: T,
    offset: [T; 2],
    reversed: [bool; 2],
}

/// The arm's plane, once joint 1 is set: the row value, the wrist centre in the plane, and whether joint 1 was free.
#[derive(Clone, Copy)]
struct Plane<T> {
    t1: T,
    x: T,
    v: T,
    free: bool,
}

/// Where the arm's second figure closes: its direction in the plane, less ψ2, and the row value of joint 3.
struct Figure<T> {
    lean: T,
    t3: T,
    free: bool,
}

impl<T: Float> Base<T> {
    /// All ways of putting the wrist centre at `p`, in the shoulder frame. `size` is what round-off is compared with;
    /// `hold` are row values for joints that turn out to be free.
    pub fn place(&self, p: [T; 3], size: T, hold: Option<[T; 2]>) -> Placements<T> {
        let stand = self.stand();
        let right = stand.plane(p, Shoulder::Right, size, hold.map(|[t1, _]| t1));
        let left = stand.plane(p, Shoulder::Left, size, hold.map(|[t1, _]| t1));
        let held = hold.map(|[_, t2]| t2);
        ArmPosture::slots(|posture| {
            let plane = match posture.shoulder {
                Shoulder::Right => right?,
                Shoulder::Left => left?,
            };
            let distance = math::hypot(plane.x, plane.v);
            let figure = match self {
                Base::Elbow(base) => base.span(posture, distance, size),
                Base::Telescope(base) => base.slide(posture, distance, size),
            };
            let figure = figure.map_err(|reason| reason.at(plane.t1))?;
            let t2 = stand.second(&plane, &figure, distance, size, held);
            Ok(Placed { rows: [plane.t1, t2, figure.t3], shoulder_free: plane.free, elbow_free: figure.free })
        })
    }

    fn stand(&self) -> Stand<T> {
        let (a1, twist, lateral, offset, reversed) = match self {
            Base::Elbow(b) => (b.a1, b.twist, b.lateral, b.offset, b.reversed),
            Base::Telescope(b) => (b.a1, b.twist, b.lateral, b.offset, b.reversed),
        };
        let ([o1, o2, _], [r1, r2, _]) = (offset, reversed);
        Stand { a1, twist, lateral, offset: [o1, o2], reversed: [r1, r2] }
    }
}

impl<T: Float> Stand<T> {
    /// Joint 1: turns the arm's plane onto the wrist centre.
    fn plane(
        &self,
        [px, py, pz]: [T; 3],
        side: Shoulder,
        size: T,
        hold: Option<T>,
    ) -> Result<Plane<T>, Reason<T>> {
        let (sine, cosine) = self.twist;
        // z2·u = h, solved for the part of u across the common normal.
        let across = (cosine * pz - self.lateral) / sine;
        let in_plane =
            |t1, along, free| Plane { t1, x: along - self.a1, v: cosine * across + sine * pz, free };
        let radius = math::hypot(px, py);
        match circle_meets_plane(radius, across, size) {
            Chord::Apart(by) => Err(Reason::OutOfReach { by, towards: Boundary::Cylinder, theta1: None }),
            Chord::Cut(half) => {
                let along = if side == Shoulder::Right { half } else { -half };
                Ok(in_plane(self.first(math::atan2(py, px) - math::atan2(across, along)), along, false))
            }
            Chord::Free => {
                let turned = |t1: T| {
                    let (s, c) = math::sin_cos(self.figure_first(t1));
                    (c * px + s * py, c * py - s * px)
                };
                let wanted = hold.unwrap_or(T::lit(0.0));
                let (along, aside) = turned(wanted);
                if hold.is_some() || math::abs(aside - across) <= T::lit(BOUNDARY) * T::EPS * size {
                    return Ok(in_plane(math::wrap(wanted), along, true));
                }
                // The convention would cost accuracy: take the direction that round-off has left.
                let t1 = self.first(math::atan2(py, px));
                Ok(in_plane(t1, turned(t1).0, true))
            }
        }
    }

    fn first(&self, figure: T) -> T {
        let ([offset, _], [reversed, _]) = (self.offset, self.reversed);
        row_value(figure, offset, reversed)
    }

    fn figure_first(&self, row: T) -> T {
        let ([offset, _], [reversed, _]) = (self.offset, self.reversed);
        figure_angle(row, offset, reversed)
    }

    /// Joint 2: turns the closed figure onto the wrist centre.
    fn second(&self, plane: &Plane<T>, figure: &Figure<T>, distance: T, size: T, hold: Option<T>) -> T {
        let ([_, offset], [_, reversed]) = (self.offset, self.reversed);
        let harmless = distance <= T::lit(BOUNDARY) * T::EPS * size;
        match (figure.free, hold) {
            (true, Some(t2)) => math::wrap(t2),
            (true, None) if harmless => T::lit(0.0),
            _ => row_value(math::atan2(plane.v, plane.x) - figure.lean, offset, reversed),
        }
    }
}

impl<T: Float> ElbowBase<T> {
    /// The elbow: two links span the distance.
    fn span(&self, posture: ArmPosture, distance: T, size: T) -> Result<Figure<T>, Reason<T>> {
        let (bend, free) = match circle_meets_circle(self.upper, self.fore, distance, size) {
            Span::Bend(bend) => (bend, false),
            Span::Free => (math::half_turn(), true),
            Span::TooFar(by) => return Err(Reason::too_far(by)),
            Span::TooNear(by) => return Err(Reason::too_near(by)),
        };
        // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way,
        // and so it is where axis 2 points to the other side.
        let back = posture.shoulder == Shoulder::Left;
        let mirrored = self.twist.0 < T::lit(0.0);
        let up = posture.elbow == Elbow::Up;
        let psi3 = if up != (back != mirrored) { -bend } else { bend };
        let ([_, _, offset], [_, _, reversed]) = (self.offset, self.reversed);
        let (s3, c3) = math::sin_cos(psi3);
        let lean = math::atan2(self.fore * s3, self.upper + self.fore * c3);
        Ok(Figure { lean, t3: row_value(psi3, offset, reversed), free })
    }
}

impl<T: Float> TelescopeBase<T> {
    /// The slide: a right triangle of the arm b and the extension s.
    fn slide(&self, posture: ArmPosture, distance: T, size: T) -> Result<Figure<T>, Reason<T>> {
        let ([_, _, offset], [_, _, reversed]) = (self.offset, self.reversed);
        let (extension, free) = match circle_meets_plane(distance, self.arm, size) {
            Chord::Cut(half) => (half, false),
            Chord::Free => (T::lit(0.0), true),
            Chord::Apart(by) => return Err(Reason::too_near(by)),
        };
        let s = if posture.elbow == Elbow::Up { extension } else { -extension };
        Ok(Figure { lean: math::atan2(s, self.arm), t3: row_length(s, offset, reversed), free })
    }
}

impl<T: Float> Reason<T> {
    fn too_far(by: T) -> Self {
        Reason::OutOfReach { by, towards: Boundary::OuterCircle, theta1: None }
    }

    fn too_near(by: T) -> Self {
        Reason::OutOfReach { by, towards: Boundary::InnerCircle, theta1: None }
    }

    /// Remembers the value of joint 1 at which a later figure failed.
    fn at(self, t1: T) -> Self {
        match self {
            Reason::OutOfReach { by, towards, .. } => Reason::OutOfReach { by, towards, theta1: Some(t1) },
            other => other,
        }
    }
}
