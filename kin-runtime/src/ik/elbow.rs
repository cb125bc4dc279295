//! Both shoulders of an elbow base side by side, each with its elbow up and down, where no figure touches.
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
use crate::ik::wrist::row_values;
use crate::math::{self, Float, Lanes, Real};
use crate::solutions::{Boundary, Reason};

/// The wrist centre seen from axis 1.
pub(super) struct Seen<T, const L: usize> {
    x: Lanes<T, L>,
    y: Lanes<T, L>,
    /// Its distances across the arm's plane, to either side along it, and at right angles to both.
    across: Lanes<T, L>,
    pub(super) half: Lanes<T, L>,
    v: Lanes<T, L>,
}

/// Shoulders, and the triangle of the links over what is left once joint 1 is set.
#[derive(Clone, Copy)]
pub(super) struct Side<T, const L: usize> {
    /// By how much, at some scale, the links close over the distance beyond the window; not positive where they do not.
    pub(super) spare: Lanes<T, L>,
    /// The square of that distance.
    pub(super) square: Lanes<T, L>,
    /// The wrist centre in the arm's plane.
    pub(super) centre: [Lanes<T, L>; 2],
    /// Sine and cosine, at some length: of the angle of the arm's plane, of half the elbow's bend, and of the angle by which
    /// the forearm turns the wrist centre with the elbow up.
    pub(super) plane: [Lanes<T, L>; 2],
    pub(super) bend: [Lanes<T, L>; 2],
    pub(super) lean: [Lanes<T, L>; 2],
    /// Which way the elbow bends where it is up.
    pub(super) sign: Lanes<T, L>,
}

/// Placements with the elbow up and with the elbow down.
#[derive(Clone, Copy)]
pub(super) struct Elbows<T, const L: usize> {
    /// Row values, in (-π, π].
    pub(super) rows: [[Lanes<T, L>; 3]; 2],
    /// The elbow's angle from stretched or folded.
    pub(super) margin: Lanes<T, L>,
}

impl<T: Float, const L: usize> Seen<T, L> {
    /// The first figure: the circle of the wrist centre about axis 1 meets the arm's plane; `half` is 0 where it does not.
    #[inline(always)]
    pub(super) fn new(base: &ElbowBase<T>, [x, y, z]: [Lanes<T, L>; 3]) -> Self {
        let (sine, cosine) = (Lanes::splat(base.twist.0), Lanes::splat(base.twist.1));
        let across = (cosine * z - Lanes::splat(base.lateral)) / sine;
        let radius = (x * x + y * y).sqrt();
        let half = ((radius - across) * (radius + across)).map(math::sqrt_or_zero);
        Seen { x, y, across, half, v: cosine * across + sine * z }
    }
}

impl<T: Float, const L: usize> Side<T, L> {
    /// The shoulders on the sides of these signs: 1 for the right one, -1 for the left one.
    #[inline(always)]
    pub(super) fn new(
        base: &ElbowBase<T>,
        seen: &Seen<T, L>,
        side: Lanes<T, L>,
        window: Lanes<T, L>,
    ) -> Self {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let (sum, difference) = (base.upper + base.fore, math::abs(base.upper - base.fore));
        let (sum, difference) = (Lanes::splat(sum), Lanes::splat(difference));
        let (upper, fore) = (Lanes::splat(base.upper), Lanes::splat(base.fore));
        let &Seen { x: px, y: py, across, half, v } = seen;
        let along = half * side;
        let x = along - Lanes::splat(base.a1);
        let square = x * x + v * v;
        let (open, shut) = (sum * sum - square, square - difference * difference);
        let spare = open.least(shut) - (sum + sum) * window;
        // Where nothing closes these stand for numbers.
        let positive = |x: T| if x > zero { x } else { one };
        let (open, shut) = (open.map(positive), shut.map(positive));
        let width = (open * shut).sqrt();
        // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way, and
        // so it is where axis 2 points to the other side.
        let sign = if base.twist.0 < zero { side } else { -side };
        let lean = [(fore + fore) * width * sign, upper * (shut + open) + fore * (shut - open)];
        Side {
            spare,
            square,
            centre: [x, v],
            plane: [py * along - px * across, px * along + py * across],
            bend: [width, shut],
            lean,
            sign,
        }
    }

    /// Whether the links close over the distance, and by more than the window.
    #[inline(always)]
    pub(super) fn closes(&self) -> [bool; L] {
        let mut closes = [false; L];
        for (closes, spare) in closes.iter_mut().zip(self.spare.0) {
            *closes = spare > T::lit(0.0);
        }
        closes
    }

    /// Why the links of this lane do not close, joint 1 being at `t1`; nothing where it is by so little that the wrist centre
    /// may still be at the boundary but for round-off.
    pub(super) fn open(&self, base: &ElbowBase<T>, lane: usize, t1: T, scale: T) -> Option<Reason<T>> {
        open(base, self.square.lane(lane), t1, scale)
    }

    /// Its placements.
    #[inline(always)]
    pub(super) fn elbows(&self, base: &ElbowBase<T>) -> Elbows<T, L> {
        let ([rise, run], [width, shut], [s, c], [x, v]) = (self.plane, self.bend, self.lean, self.centre);
        let [plane, bend] = Lanes::directed_both([rise, width], [run, shut]);
        let ([y, z], [a, b]) = ([v * c, x * s], [x * c, v * s]);
        let [up, down] = Lanes::directed_both([y - z, y + z], [a + b, a - b]);
        let bend = bend + bend;
        let margin = bend.least(Lanes::splat(math::half_turn::<T>()) - bend);
        let bend = self.sign * bend;
        let ([o1, o2, o3], [r1, r2, r3]) = (base.offset, base.reversed);
        let (first, up, down) = (row_values(plane, o1, r1), row_values(up, o2, r2), row_values(down, o2, r2));
        let (bent, bowed) = (row_values(bend, o3, r3), row_values(-bend, o3, r3));
        if Lanes::<T, L>::ALONE {
            return Elbows { rows: [[first, up, bent], [first, down, bowed]], margin };
        }
        let [first, up, down, bent, bowed] = Lanes::wrap_all([first, up, down, bent, bowed]);
        let rows = [[first, up, bent], [first, down, bowed]];
        Elbows { rows, margin }
    }
}

/// As [`Side::open`], from the square of the distance.
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
    let (one, two) = (T::lit(1.0), p.map(|x| Lanes([x; 2])));
    let seen = Seen::new(base, two);
    let [half, _] = seen.half.0;
    if half <= window {
        return [None; 2];
    }
    let side = Side::new(base, &seen, Lanes([one, -one]), Lanes::splat(window));
    let Elbows { rows: [up, down], margin } = side.elbows(base);
    let placed = |lane, [t1, t2, t3]: [Lanes<T, 2>; 3]| Placed {
        rows: [t1.lane(lane), t2.lane(lane), t3.lane(lane)],
        shoulder: half,
        elbow: margin.lane(lane),
        shoulder_free: false,
        elbow_free: false,
    };
    let [right, left] = side.closes();
    let of = |lane| [placed(lane, up), placed(lane, down)];
    [right.then(|| of(0)), left.then(|| of(1))]
}
