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
use crate::ik::wrist::row_length;
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

/// Shoulders, each with joint 1 set, and the triangle of the links over what is left.
pub(super) struct Side<T, const L: usize> {
    /// The row value of joint 1, but for whole turns.
    first: Lanes<T, L>,
    /// The elbow's angle from stretched or folded.
    pub(super) elbow: Lanes<T, L>,
    /// Whether the links close over the distance, and by more than the window.
    pub(super) closes: [bool; L],
    /// The wrist centre in the arm's plane, and the square of its distance.
    x: Lanes<T, L>,
    v: Lanes<T, L>,
    square: Lanes<T, L>,
    /// Cosine and sine, at some length, of the angle by which the forearm turns the wrist centre with the elbow up.
    lean: [Lanes<T, L>; 2],
    /// The elbow's bend then.
    bend: Lanes<T, L>,
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
        let mut closes = [false; L];
        let least = (sum + sum) * window;
        for (closes, spare) in closes.iter_mut().zip((open.least(shut) - least).0) {
            *closes = spare > zero;
        }
        // Where nothing closes these stand for numbers.
        let positive = |x: T| if x > zero { x } else { one };
        let (open, shut) = (open.map(positive), shut.map(positive));
        let width = (open * shut).sqrt();
        let (rise, run) = (py * along - px * across, px * along + py * across);
        let [plane, bend] = Lanes::atan2_both([rise, width], [run, shut]);
        let bend = bend + bend;
        // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way, and
        // so it is where axis 2 points to the other side.
        let sign = if base.twist.0 < zero { side } else { -side };
        let lean = [upper * (shut + open) + fore * (shut - open), (fore + fore) * width * sign];
        let ([offset, ..], [reversed, ..]) = (base.offset, base.reversed);
        Side {
            first: row_length(plane, Lanes::splat(offset), reversed),
            elbow: bend.least(Lanes::splat(math::half_turn::<T>()) - bend),
            closes,
            x,
            v,
            square,
            lean,
            bend: sign * bend,
        }
    }

    /// Why the links of this lane do not close, joint 1 being at `t1`; nothing where it is by so little that the wrist centre
    /// may still be at the boundary but for round-off.
    pub(super) fn open(&self, base: &ElbowBase<T>, lane: usize, t1: T, scale: T) -> Option<Reason<T>> {
        let distance = math::sqrt(self.square.lane(lane));
        let (beyond, within) =
            (distance - (base.upper + base.fore), math::abs(base.upper - base.fore) - distance);
        let (by, boundary) =
            if beyond > within { (beyond, Boundary::OuterCircle) } else { (within, Boundary::InnerCircle) };
        (by > T::lit(1e-3) * scale).then(|| Reason::beyond(by, boundary).at(t1))
    }

    /// The row values with the elbow up, and with the elbow down, in (-π, π].
    #[inline(always)]
    pub(super) fn elbows(&self, base: &ElbowBase<T>) -> [[Lanes<T, L>; 3]; 2] {
        let ([c, s], [_, o2, o3], [_, r2, r3]) = (self.lean, base.offset, base.reversed);
        let (x, v) = (self.x, self.v);
        let ([y, z], [a, b]) = ([v * c, x * s], [x * c, v * s]);
        let [up, down] = Lanes::atan2_both([y - z, y + z], [a + b, a - b]);
        let row = |figure, offset, reversed| row_length(figure, Lanes::splat(offset), reversed);
        let [first, up, down, bent, bowed] = Lanes::wrap_all([
            self.first,
            row(up, o2, r2),
            row(down, o2, r2),
            row(self.bend, o3, r3),
            row(-self.bend, o3, r3),
        ]);
        [[first, up, bent], [first, down, bowed]]
    }
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
    let [up, down] = side.elbows(base);
    let placed = |lane, [t1, t2, t3]: [Lanes<T, 2>; 3]| Placed {
        rows: [t1.lane(lane), t2.lane(lane), t3.lane(lane)],
        shoulder: half,
        elbow: side.elbow.lane(lane),
        shoulder_free: false,
        elbow_free: false,
    };
    let [right, left] = side.closes;
    let of = |lane| [placed(lane, up), placed(lane, down)];
    [right.then(|| of(0)), left.then(|| of(1))]
}
