//! The first three joints: where they put the wrist centre, by figures over the shoulder, the elbow or the slide.
//!
//! # The shoulder frame
//!
//! z along joint axis 1; the origin at the foot, on axis 1, of the common normal of axes 1 and 2; x along that normal
//! (towards axis 2 where a1 > 0). ψ1 turns this frame about z; in the turned frame axis 2 passes through (a1, 0, 0) in the direction
//! z2 = (0, -sin α, cos α), the twist α being counted about x. ψ2 and ψ3 turn about z2.
//!
//! # The figures
//!
//! 1. Axis 2 carries the arm in a plane at right angles to it, at the lateral offset h: the wrist centre u in the
//!    turned frame has z2·u = h. That is a [chord](crate::geometry::circle_meets_plane) of the circle about axis 1 on
//!    which the wrist centre moves when joint 1 turns.
//! 2. In that plane, from the foot of axis 2, the wrist centre is at (X, V); two links span D = √(X² + V²)
//!    ([circles](crate::geometry::circle_meets_circle)), or a slide does.

use crate::geometry::{Chord, Span, circle_meets_circle, circle_meets_plane, turn};
use crate::ik::ROUND_OFF;
use crate::ik::elbow;
use crate::ik::general::GeneralBase;
use crate::ik::wrist::{figure_angle, row_length, row_value};
use crate::math::{self, Float};
use crate::solutions::{ArmPosture, Boundary, Branch, Reason, Shoulder};

/// The constants of the first three joints: generated code writes them, or a run-time loader.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Base<T> {
    /// Three revolute joints, axes 2 and 3 parallel.
    Elbow(ElbowBase<T>),
    /// Two revolute joints and a slide at right angles to axis 2.
    Telescope(TelescopeBase<T>),
    /// Any other three joints.
    General(GeneralBase<T>),
}

/// Three revolute joints with axes 2 and 3 parallel: shoulder, upper arm and forearm.
///
/// Figure angles from row values: ψ = offset + t, or offset - t where the joint is reversed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ElbowBase<T> {
    /// From axis 1 to axis 2 along their common normal: negative where x points away from axis 2, as a table may have it.
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
    /// From axis 1 to axis 2 along their common normal: negative where x points away from axis 2, as a table may have it.
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
    /// The distance of the wrist centre from the plane in which both shoulders are one.
    pub shoulder: T,
    /// The elbow's angle from stretched or folded, or the slide's extension.
    pub elbow: T,
    /// Whether joint 1 may take any other value.
    pub shoulder_free: bool,
    /// Whether joint 2 may take any other value.
    pub elbow_free: bool,
}

/// What became of the four branches of the base.
pub type Placements<T> = <ArmPosture as Branch>::Slots<Result<Placed<T>, Reason<T>>>;

/// A base whose joints 2 and 3 work in a plane at right angles to axis 2.
enum Planar<'a, T> {
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

impl<T: Float> Base<T> {
    /// All ways of putting the wrist centre at `p`, in the shoulder frame. `size` is what round-off is compared with;
    /// `hold` are row values for joints that turn out to be free; without one, such a joint takes the value 0.
    pub fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
        match self {
            Base::Elbow(base) => Planar::Elbow(base).place(p, size, hold),
            Base::Telescope(base) => Planar::Telescope(base).place(p, size, hold),
            Base::General(base) => base.place(p, size, hold),
        }
    }

    /// Whether every constant is a finite number: parameters may have made it otherwise.
    pub fn is_finite(&self) -> bool {
        match self {
            Base::Elbow(base) => Planar::Elbow(base).is_finite(),
            Base::Telescope(base) => Planar::Telescope(base).is_finite(),
            Base::General(base) => base.is_finite(),
        }
    }

    /// How much round-off of the point is magnified in the row values that are not free, about; and whether branches touch, so
    /// that it grows to its square root and no more.
    pub(crate) fn magnified(&self, placed: &Placed<T>) -> (T, bool) {
        let (zero, one, reach) = (T::lit(0.0), T::lit(1.0), self.reach());
        let by = |margin: T, free| match free {
            true => zero,
            false if margin == zero => T::lit(16.0) / math::sqrt(T::EPS),
            false => one / margin,
        };
        // The second figure sees what the first one has magnified as far as it lies along its distance.
        let (elbow, aside, distance) = match self {
            Base::Elbow(base) => (placed.elbow, base.a1, base.closing(placed)),
            Base::Telescope(base) => (placed.elbow / reach, base.a1, placed.elbow),
            Base::General(_) => (placed.elbow, reach, zero),
        };
        let aside = math::abs(aside) + placed.shoulder;
        let through = if aside < distance { aside / distance } else { one };
        let (first, second) =
            (by(placed.shoulder / reach, placed.shoulder_free), by(elbow, placed.elbow_free));
        (one + first + second * (one + through * first), placed.shoulder == zero || elbow == zero)
    }

    /// The arm's reach.
    pub fn reach(&self) -> T {
        match self {
            Base::Elbow(base) => base.reach,
            Base::Telescope(base) => base.reach,
            Base::General(base) => base.reach,
        }
    }
}

impl<T: Float> Planar<'_, T> {
    fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
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
                stand.nudged(plane, sight, open.boundary, window)
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

    fn is_finite(&self) -> bool {
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
    /// round-off of the circle about axis 1.
    fn nudged(&self, plane: &Plane<T>, sight: &Sight<T>, boundary: T, window: T) -> Option<Plane<T>> {
        if plane.free || math::abs(sight.v) - boundary > window {
            return None;
        }
        let x = math::sqrt_or_zero((boundary - sight.v) * (boundary + sight.v));
        let along = self.a1 + if plane.x < T::lit(0.0) { -x } else { x };
        let off = math::abs(math::hypot(along, sight.across) - sight.radius);
        (off <= window).then(|| self.turned(sight, along))
    }

    fn second(&self, figure: T) -> T {
        let ([_, offset], [_, reversed]) = (self.offset, self.reversed);
        row_value(figure, offset, reversed)
    }
}

impl<T: Float> ElbowBase<T> {
    /// The distance that the links span where they are stretched or folded, whichever is nearer.
    fn closing(&self, placed: &Placed<T>) -> T {
        let ([_, _, t3], [_, _, offset], [_, _, reversed]) = (placed.rows, self.offset, self.reversed);
        let bend = math::abs(math::wrap(figure_angle(t3, offset, reversed)));
        if bend < math::half_turn::<T>() * T::lit(0.5) {
            self.upper + self.fore
        } else {
            math::abs(self.upper - self.fore)
        }
    }

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

impl<T: Float> Reason<T> {
    pub(super) fn beyond(by: T, towards: Boundary) -> Self {
        Reason::OutOfReach { by, towards, theta1: None }
    }

    /// Remembers the value of joint 1 at which a later figure failed.
    pub(super) fn at(self, t1: T) -> Self {
        match self {
            Reason::OutOfReach { by, towards, .. } => Reason::OutOfReach { by, towards, theta1: Some(t1) },
            other => other,
        }
    }
}
