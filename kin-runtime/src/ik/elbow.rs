//! The shoulders of an elbow base, each with its elbow up and down, where no figure touches; without a branch, so that a loop
//! over shoulders, angles or poses becomes one over vectors ([`side`](crate::ik::side), [`abreast`](crate::ik::abreast)).
//!
//! The figures are those of [`base`](crate::ik::base), each angle taken at once from a vector that has its direction. With D
//! the distance, S the sum of the links u and f, d their difference, o² = S² - D², s² = D² - d² and w = o·s:
//!
//! * the plane of the arm turns from (half, across) to (px, py);
//! * the elbow bends by 2·atan2(w, s²), either way;
//! * the forearm pulls the wrist centre away from the upper arm by the angle of (u(s² + o²) + f(s² - o²), 2f·w); the upper
//!   arm stands that far to either side of (x, v).
//!
//! No sine is taken, and no two angles are added but to the constants of the table.

use crate::ik::ElbowBase;
use crate::ik::base::Placed;
use crate::ik::wrist::straight_row_value;
use crate::math::{self, Float};
use crate::solutions::{Boundary, Reason};

/// The wrist centre seen from axis 1.
pub(super) struct Seen<T> {
    pub(super) x: T,
    pub(super) y: T,
    /// Its distances across the arm's plane, to either side along it, and at right angles to both.
    pub(super) across: T,
    pub(super) half: T,
    pub(super) v: T,
}

/// A shoulder, and the triangle of the links over what is left once joint 1 is set.
pub(super) struct Side<T> {
    /// By how much, at some scale, the links close over the distance beyond the window; not positive where they do not.
    pub(super) spare: T,
    /// The square of that distance.
    pub(super) square: T,
    /// The wrist centre in the arm's plane.
    centre: [T; 2],
    /// Sine and cosine, at some length: of the angle of the arm's plane, of half the elbow's bend, and of the angle by which
    /// the forearm turns the wrist centre with the elbow up.
    plane: [T; 2],
    bend: [T; 2],
    lean: [T; 2],
    /// Which way the elbow bends where it is up.
    sign: T,
}

/// Placements with the elbow up and with the elbow down.
pub(super) struct Elbows<T> {
    /// Row values, in (-π, π].
    pub(super) rows: [[T; 3]; 2],
    /// The elbow's angle from stretched or folded.
    pub(super) margin: T,
}

/// Whether axis 1 lies in the arm's plane: so it does for most arms, whose compilers know it and save a root.
#[inline(always)]
fn is_centred<T: Float>(base: &ElbowBase<T>) -> bool {
    let (_, cosine) = base.twist;
    (cosine == T::lit(0.0)) & (base.lateral == T::lit(0.0))
}

impl<T: Float> Seen<T> {
    /// The first figure: the circle of the wrist centre about axis 1 meets the arm's plane; `half` is 0 where it does not.
    #[inline(always)]
    pub(super) fn new(base: &ElbowBase<T>, [x, y, z]: [T; 3]) -> Self {
        let (sine, cosine) = base.twist;
        let radius = math::sqrt(x * x + y * y);
        if is_centred(base) {
            return Seen { x, y, across: T::lit(0.0), half: radius, v: sine * z };
        }
        let across = (cosine * z - base.lateral) / sine;
        let half = math::sqrt_or_zero((radius - across) * (radius + across));
        Seen { x, y, across, half, v: cosine * across + sine * z }
    }
}

impl<T: Float> Side<T> {
    /// The shoulder on the side of this sign: 1 for the right one, -1 for the left one.
    #[inline(always)]
    pub(super) fn new(base: &ElbowBase<T>, seen: &Seen<T>, side: T, window: T) -> Self {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let &ElbowBase { upper, fore, .. } = base;
        let (sum, difference) = (upper + fore, math::abs(upper - fore));
        let &Seen { x: px, y: py, across, half, v } = seen;
        let along = half * side;
        let x = along - base.a1;
        let square = x * x + v * v;
        let (open, shut) = (sum * sum - square, square - difference * difference);
        let spare = math::min(open, shut) - (sum + sum) * window;
        // Where nothing closes these stand for numbers.
        let positive = |x: T| if x > zero { x } else { one };
        let (open, shut) = (positive(open), positive(shut));
        let width = math::sqrt(open * shut);
        // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way, and
        // so it is where axis 2 points to the other side.
        let sign = if base.twist.0 < zero { side } else { -side };
        let lean = [(fore + fore) * width * sign, upper * (shut + open) + fore * (shut - open)];
        let plane = if is_centred(base) {
            [py * side, px * side]
        } else {
            [py * along - px * across, px * along + py * across]
        };
        Side { spare, square, centre: [x, v], plane, bend: [width, shut], lean, sign }
    }

    /// Sine and cosine, at some length, of the angles that its placements are made of: of the arm's plane, of half the elbow's
    /// bend, and of the upper arm with the elbow up and down.
    #[inline(always)]
    pub(super) fn directions(&self) -> [[T; 2]; 4] {
        let ([s, c], [x, v]) = (self.lean, self.centre);
        let ([y, z], [a, b]) = ([v * c, x * s], [x * c, v * s]);
        [self.plane, self.bend, [y - z, a + b], [y + z, a - b]]
    }

    /// Its placements, of those angles.
    #[inline(always)]
    pub(super) fn elbows(&self, base: &ElbowBase<T>, [plane, bend, up, down]: [T; 4]) -> Elbows<T> {
        let bend = bend + bend;
        let margin = math::min(bend, math::half_turn::<T>() - bend);
        let bend = self.sign * bend;
        let ([o1, o2, o3], [r1, r2, r3]) = (base.offset, base.reversed);
        let first = straight_row_value(plane, o1, r1);
        let (up, down) = (straight_row_value(up, o2, r2), straight_row_value(down, o2, r2));
        let (bent, bowed) = (straight_row_value(bend, o3, r3), straight_row_value(-bend, o3, r3));
        Elbows { rows: [[first, up, bent], [first, down, bowed]], margin }
    }
}

/// The angles of directions.
#[inline(always)]
pub(super) fn angles<T: Float>([a, b, c, d]: [[T; 2]; 4]) -> [T; 4] {
    let angle = |[y, x]: [T; 2]| T::atan2_straight(y, x);
    [angle(a), angle(b), angle(c), angle(d)]
}

/// Why the links do not close over a distance of this square, joint 1 being at `t1`; nothing where it is by so little that the
/// wrist centre may still be at the boundary but for round-off.
pub(super) fn open<T: Float>(base: &ElbowBase<T>, square: T, t1: T, scale: T) -> Option<Reason<T>> {
    let distance = math::sqrt(square);
    let (beyond, within) =
        (distance - (base.upper + base.fore), math::abs(base.upper - base.fore) - distance);
    let (by, boundary) =
        if beyond > within { (beyond, Boundary::OuterCircle) } else { (within, Boundary::InnerCircle) };
    (by > T::lit(1e-3) * scale).then(|| Reason::beyond(by, boundary).at(t1))
}

/// Of the right shoulder, then the left one: elbow up, then down; none where the triangle does not close, or just touches.
pub(super) fn both_shoulders<T: Float>(
    base: &ElbowBase<T>,
    p: [T; 3],
    window: T,
) -> [Option<[Placed<T>; 2]>; 2] {
    let seen = Seen::new(base, p);
    [T::lit(1.0), T::lit(-1.0)].map(|sign| {
        let side = Side::new(base, &seen, sign, window);
        if !(seen.half > window && side.spare > T::lit(0.0)) {
            return None;
        }
        let Elbows { rows, margin } = side.elbows(base, angles(side.directions()));
        Some(rows.map(|rows| Placed {
            // Offsets may be of any size here.
            rows: rows.map(math::wrap),
            shoulder: seen.half,
            elbow: margin,
            shoulder_free: false,
            elbow_free: false,
        }))
    })
}
