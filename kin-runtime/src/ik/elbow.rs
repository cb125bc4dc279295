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
//! No sine is taken, and no two angles are added but to the constants of the table. The vectors' lengths are known: the radius,
//! s² + o² by half the bend, and D²(s² + o²) of the last.

use crate::ik::ElbowBase;
use crate::ik::base::Placed;
use crate::ik::figure::{Figure, Row, Zero};
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
    /// One over the length of the direction of the arm's plane.
    pub(super) per: T,
}

/// A shoulder, and the triangle of the links over what is left once joint 1 is set.
pub(super) struct Side<T> {
    /// By how much, at some scale, the links close over the distance beyond the window; not positive where they do not.
    pub(super) spare: T,
    /// The square of that distance.
    pub(super) square: T,
    /// The wrist centre in the arm's plane.
    centre: [T; 2],
    /// The angle of the arm's plane, and that by which the elbow bends, not negative.
    plane: Figure<T>,
    bend: Figure<T>,
    /// How far the elbow is from stretched or folded.
    pub(super) margin: T,
    /// Sine and cosine, at some length, of the angle by which the forearm turns the wrist centre with the elbow up; one over
    /// that length and the distance.
    lean: [T; 2],
    per: T,
    /// Which way the elbow bends where it is up.
    sign: T,
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
        let (one, square) = (T::lit(1.0), x * x + y * y);
        let radius = math::sqrt(square);
        if is_centred(base) {
            return Seen { x, y, across: T::lit(0.0), half: radius, v: sine * z, per: one / radius };
        }
        let across = (cosine * z - base.lateral) / sine;
        let half = math::sqrt_or_zero((radius - across) * (radius + across));
        Seen { x, y, across, half, v: cosine * across + sine * z, per: one / square }
    }
}

impl<T: Float> Side<T> {
    /// The shoulder on the side of this sign: 1 for the right one, -1 for the left one.
    #[inline(always)]
    pub(super) fn new(base: &ElbowBase<T>, seen: &Seen<T>, side: T, window: T) -> Self {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let &ElbowBase { upper, fore, .. } = base;
        let (sum, difference) = (upper + fore, math::abs(upper - fore));
        let &Seen { x: px, y: py, across, half, v, per } = seen;
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
        let (all, apart) = (shut + open, shut - open);
        let lean = [(fore + fore) * width * sign, upper * all + fore * apart];
        let per_lean = one / (all * square);
        let plane = if is_centred(base) {
            Figure::of([py * side, px * side], per)
        } else {
            Figure::of([py * along - px * across, px * along + py * across], per).unit()
        };
        let bend = Figure::twice([width, shut], [width + width, apart], per_lean * square);
        let margin = math::min(bend.angle, math::half_turn::<T>() - bend.angle);
        Side { spare, square, centre: [x, v], plane, bend, margin, lean, per: per_lean, sign }
    }

    /// The row values of its placement with the elbow up (1) or down (-1).
    #[inline(always)]
    pub(super) fn rows(&self, base: &ElbowBase<T>, elbow: T) -> [Row<T>; 3] {
        let ([s, c], [x, v]) = (self.lean, self.centre);
        let upper = [v * c - elbow * (x * s), x * c + elbow * (v * s)];
        let upper = Figure::of(upper, self.per).unit();
        let ([o1, o2, o3], [r1, r2, r3]) = (base.offset, base.reversed);
        let (first, second, third) = (Zero::new(o1, r1), Zero::new(o2, r2), Zero::new(o3, r3));
        [self.plane.row(&first), upper.row(&second), self.bend.signed(self.sign * elbow).row(&third)]
    }
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
        Some([T::lit(1.0), T::lit(-1.0)].map(|elbow| Placed {
            // Offsets may be of any size here.
            rows: side.rows(base, elbow).map(|row| math::wrap(row.value)),
            shoulder: seen.half,
            elbow: side.margin,
            shoulder_free: false,
            elbow_free: false,
        }))
    })
}
