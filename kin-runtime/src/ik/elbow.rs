//! Both shoulders of an elbow base side by side, each with its elbow up and down, where no figure touches.
//!
//! The figures are those of [`base`](crate::ik::base). With D the distance, S the sum of the links and d their difference,
//! o² = (S - D)(S + D) and s² = (D - d)(D + d): the elbow bends by 2·atan2(o, s), and upper arm and forearm, u and f, lean by
//! atan2(2f·o·s, u(s² + o²) + f(s² - o²)). No sine is taken, and all angles are taken at once.

use crate::ik::ElbowBase;
use crate::ik::base::Placed;
use crate::ik::wrist::row_length;
use crate::math::{self, Float};

/// Where the wrist centre is seen from axis 1: its azimuth, its distances across the arm's plane, to either side along it,
/// and at right angles to both.
pub(super) struct Seen<T> {
    pub(super) azimuth: T,
    pub(super) across: T,
    pub(super) half: T,
    pub(super) v: T,
}

/// Of the right shoulder, then the left one: elbow up, then down; none where the triangle does not close, or just touches.
pub(super) fn both_shoulders<T: Float>(
    base: &ElbowBase<T>,
    seen: &Seen<T>,
    window: T,
) -> [Option<[Placed<T>; 2]>; 2] {
    let (zero, two) = (T::lit(0.0), T::lit(2.0));
    let Seen { azimuth, across, half, v } = *seen;
    let (upper, fore) = (base.upper, base.fore);
    let (sum, difference) = (upper + fore, math::abs(upper - fore));
    let along = [half, -half];
    let x = along.map(|along| along - base.a1);
    let distance = x.map(|x| math::sqrt(x * x + v * v));
    let closes = distance.map(|d| (sum - d > window) & (d - difference > window) & (d > window));
    if let [false, false] = closes {
        return [None; 2];
    }
    let open = distance.map(|d| math::max((sum - d) * (sum + d), zero));
    let shut = distance.map(|d| math::max((d - difference) * (d + difference), zero));
    let (([o, p], [s, t]), [x0, x1], [half0, half1]) = ((open, shut), x, along);
    let across_lean = |o: T, s: T| two * fore * math::sqrt(o * s);
    let along_lean = |o: T, s: T| upper * (s + o) + fore * (s - o);
    let [first, other, towards, away, bend, bow, lean, slant] = T::atan2_all(
        [across, across, v, v, math::sqrt(o), math::sqrt(p), across_lean(o, s), across_lean(p, t)],
        [half0, half1, x0, x1, math::sqrt(s), math::sqrt(t), along_lean(o, s), along_lean(p, t)],
    );
    // Seen along z2, a forearm that bends back downwards leaves the elbow up; over the back it is the other way, and so it
    // is where axis 2 points to the other side.
    let sign = if base.twist.0 < zero { T::lit(1.0) } else { T::lit(-1.0) };
    let ([bend, bow], [lean, slant]) = ([bend, bow].map(|half| two * half), [sign * lean, -sign * slant]);
    let (up, down) = (sign * bend, -sign * bow);
    let ([o1, o2, o3], [r1, r2, r3]) = (base.offset, base.reversed);
    let rows = [
        row_length(azimuth - first, o1, r1),
        row_length(azimuth - other, o1, r1),
        row_length(towards - lean, o2, r2),
        row_length(towards + lean, o2, r2),
        row_length(away - slant, o2, r2),
        row_length(away + slant, o2, r2),
        row_length(up, o3, r3),
        row_length(-up, o3, r3),
        row_length(down, o3, r3),
        row_length(-down, o3, r3),
    ];
    let [a1, b1, a2, a2_down, b2, b2_down, a3, a3_down, b3, b3_down] = math::wrap_all(rows);
    let placed = |rows, bend| Placed {
        rows,
        shoulder: half,
        elbow: math::min(bend, math::half_turn::<T>() - bend),
        shoulder_free: false,
        elbow_free: false,
    };
    let [right, left] = closes;
    [
        right.then(|| [placed([a1, a2, a3], bend), placed([a1, a2_down, a3_down], bend)]),
        left.then(|| [placed([b1, b2, b3], bow), placed([b1, b2_down, b3_down], bow)]),
    ]
}
