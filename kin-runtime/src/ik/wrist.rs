//! Three axes through one point: the last three joints from the rotation that they must produce.

use crate::geometry::{Corner, cone_meets_cone};
use crate::ik::{DOUBTFUL, FAMILY, ROUND_OFF};
use crate::math::{self, Float, Real};
use crate::pose;

/// What the last three joints can do about a rotation. All values are row values: angles in (-π, π].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Wrist<T> {
    /// Two ways: bent positively and bent negatively. They may be equal where an oblique wrist is stretched.
    Two {
        /// Bent positively.
        noflip: [T; 3],
        /// Bent negatively.
        flip: [T; 3],
        /// The angle of the bend from where the three axes lie in one plane.
        margin: T,
        /// The family that this would be if the bend were round-off, where it is less than 1/4096: the rotation alone does
        /// not tell.
        doubt: Option<WristFamily<T>>,
    },
    /// Axes 4 and 6 coincide: infinitely many ways.
    Family(WristFamily<T>),
    /// The axis of joint 6 cannot point there: only for an oblique wrist.
    OutOfReach {
        /// The angle that is missing.
        by: T,
        /// The way that comes nearest: the three axes in one plane, that of joint 6 on the rim of its cone.
        rim: [T; 3],
    },
}

/// All ways of a wrist whose axes 4 and 6 coincide: only the sum or the difference of their angles is known.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WristFamily<T> {
    /// Whether `t4 - t6` is constant; otherwise `t4 + t6` is.
    pub difference: bool,
    /// That constant, in (-π, π].
    pub constant: T,
    /// The bend at which the axes coincide.
    straight: T,
    /// The member that the entries of the rotation favour: the axes coincide but for round-off, and this is its trace.
    own: [T; 3],
    /// The angle between the axes that round-off has left.
    tilt: T,
}

impl<T: Float> WristFamily<T> {
    /// The member with the given t4.
    pub fn member(&self, t4: T) -> [T; 3] {
        // Before anything is added to it: many turns would leave no digits for the constant.
        let t4 = math::wrap(t4);
        let t6 = if self.difference { t4 - self.constant } else { self.constant - t4 };
        [t4, self.straight, math::wrap(t6)]
    }

    /// The same with axes that coincide exactly, t6 moved by so much.
    pub(crate) fn straightened(self, t6: T) -> Self {
        let constant = math::wrap(if self.difference { self.constant - t6 } else { self.constant + t6 });
        Self { constant, tilt: T::lit(0.0), ..self }
    }

    /// The member that shares the constant evenly between joints 4 and 6: the convention. Where that
    /// would cost accuracy, the member that fits best.
    pub fn even(&self) -> [T; 3] {
        let harmless = self.tilt <= T::lit(ROUND_OFF) * T::EPS;
        if harmless { self.member(self.constant * T::lit(0.5)) } else { self.own }
    }
}

/// From figure angles to row values: offsets taken off, reversed joints turned round.
#[derive(Clone, Copy, Debug)]
pub struct Rows<T> {
    /// What the figure angle is where the row value is 0.
    pub offset: [T; 3],
    /// Whether the figure angle falls where the row value rises.
    pub reversed: [bool; 3],
}

impl<T: Float> Rows<T> {
    /// The row values of three figure angles, in (-π, π].
    pub fn values(&self, [a, b, c]: [T; 3]) -> [T; 3] {
        let ([oa, ob, oc], [ra, rb, rc]) = (self.offset, self.reversed);
        [row_value(a, oa, ra), row_value(b, ob, rb), row_value(c, oc, rc)]
    }
}

/// The row value of a figure angle, in (-π, π].
pub fn row_value<T: Float>(figure: T, offset: T, reversed: bool) -> T {
    math::wrap(row_length(figure, offset, reversed))
}

/// The row value of a figure length.
#[inline(always)]
pub fn row_length<T: Real>(figure: T, offset: T, reversed: bool) -> T {
    if reversed { offset - figure } else { figure - offset }
}

/// The figure angle of a row value.
pub fn figure_angle<T: Float>(row: T, offset: T, reversed: bool) -> T {
    if reversed { offset - row } else { row + offset }
}

/// The same direction seen from the other side, without leaving [-π, π].
fn opposite<T: Float>(angle: T) -> T {
    if angle > T::lit(0.0) { angle - math::half_turn::<T>() } else { angle + math::half_turn::<T>() }
}

/// An orthogonal wrist: m = Rz(a)·Ry(b)·Rz(c), by rows.
///
/// c comes from what a leaves over, never from m alone: near the singularity a is any angle, and c must fit it.
pub fn zyz<T: Float>(m: [[T; 3]; 3], rows: &Rows<T>) -> Wrist<T> {
    let [[m11, m12, m13], [m21, m22, m23], [_, _, m33]] = m;
    let sin_b = math::hypot(m13, m23);
    let a = math::atan2(m23, m13);
    let b = math::atan2(sin_b, m33);
    let singular = sin_b <= T::lit(DOUBTFUL) * T::EPS;
    // Away from the singularity the third column is itself the direction (cos a, sin a), but for its length.
    let (sa, ca) = if singular { math::sin_cos(a) } else { (m23, m13) };
    let c = math::atan2(ca * m21 - sa * m11, ca * m22 - sa * m12);
    let family = (sin_b <= T::lit(BENT)).then(|| {
        let straight = if m33 < T::lit(0.0) { math::half_turn() } else { T::lit(0.0) };
        family([a, b, c], [a, straight, c], sin_b, m33, rows)
    });
    let [noflip, flip] = [[a, b, c], [opposite(a), -b, opposite(c)]].map(|angles| rows.values(angles));
    told(noflip, flip, from_straight(b), family)
}

/// The sine of the largest bend that round-off of a base may have made: beyond, a base that magnifies it so much is anywhere.
const BENT: f64 = 1.0 / 4096.0;

/// How far an angle in [0, π] is from the nearer end.
fn from_straight<T: Float>(bend: T) -> T {
    math::min(bend, math::half_turn::<T>() - bend)
}

/// The family of a wrist by figure angles: the member `own` that fits best, and a member bent so that axes 4 and 6
/// coincide exactly; the sign of `cosine` tells whether they then have the same sense.
fn family<T: Float>(own: [T; 3], exact: [T; 3], tilt: T, cosine: T, rows: &Rows<T>) -> WristFamily<T> {
    let [first, _, last] = rows.reversed;
    let [t4, straight, t6] = rows.values(exact);
    // In figure angles a + c is constant where the axes agree, a - c where they oppose; one reversed joint swaps that.
    let difference = (cosine < T::lit(0.0)) != (first != last);
    let constant = math::wrap(if difference { t4 - t6 } else { t4 + t6 });
    WristFamily { difference, constant, straight, own: rows.values(own), tilt }
}

/// Two ways, or the family where the tilt between axes 4 and 6 is surely round-off.
fn told<T: Float>(noflip: [T; 3], flip: [T; 3], margin: T, family: Option<WristFamily<T>>) -> Wrist<T> {
    match family {
        Some(family) if family.tilt <= T::lit(FAMILY) * T::EPS => Wrist::Family(family),
        doubt => Wrist::Two { noflip, flip, margin, doubt },
    }
}

/// An oblique wrist: m = Rz(a)·K4·Rz(b)·K5·Rz(c), by rows; K4 and K5 are constant rotations.
///
/// The axes are three unit vectors; axis 5 stands at fixed angles to 4 and to 6, so that the bend is a spherical
/// triangle. Not every rotation can be reached.
pub fn oblique<T: Float>(m: [[T; 3]; 3], k4: [[T; 3]; 3], k5: [[T; 3]; 3], rows: &Rows<T>) -> Wrist<T> {
    let [[_, _, m13], [_, _, m23], [_, _, m33]] = m;
    let [_, _, [u1, u2, u3]] = k4;
    let [[_, _, v1], [_, _, v2], [_, _, v3]] = k5;
    // Axis 4 in the frame before the bend is u, axis 6 after it is v; their angles to axis 5 are fixed.
    let sin_46 = math::hypot(m13, m23);
    let angle_45 = math::atan2(math::hypot(u1, u2), u3);
    let angle_56 = math::atan2(math::hypot(v1, v2), v3);
    let angle_46 = math::atan2(sin_46, m33);
    // With this bend axes 4 and 6 are at their smallest angle, on the same side of axis 5.
    let closest = math::atan2(u2 * v1 - u1 * v2, u1 * v1 + u2 * v2);
    let rim = |by, swing| Wrist::OutOfReach { by, rim: rows.values(bent(&m, &k4, &k5, closest + swing)) };
    let swing = match cone_meets_cone(angle_45, angle_56, angle_46, T::lit(ROUND_OFF) * T::EPS) {
        Corner::Angle(corner) => corner,
        Corner::TooFar(by) => return rim(by, math::half_turn()),
        Corner::TooNear(by) => return rim(by, T::lit(0.0)),
    };
    let noflip = bent(&m, &k4, &k5, closest + swing);
    let family = (sin_46 <= T::lit(BENT)).then(|| {
        let straight = if m33 < T::lit(0.0) { closest + math::half_turn() } else { closest };
        family(noflip, bent(&m, &k4, &k5, straight), sin_46, m33, rows)
    });
    let flip = bent(&m, &k4, &k5, closest - swing);
    told(rows.values(noflip), rows.values(flip), from_straight(swing), family)
}

/// The figure angles of an oblique wrist whose bend is known: a turns axis 6 to its place, c takes what is left.
fn bent<T: Float>(m: &[[T; 3]; 3], k4: &[[T; 3]; 3], k5: &[[T; 3]; 3], b: T) -> [T; 3] {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let (sb, cb) = math::sin_cos(b);
    let turned = pose::product(&[[cb, -sb, zero], [sb, cb, zero], [zero, zero, one]], k5);
    let inner = pose::product(k4, &turned);
    let [[_, _, n13], [_, _, n23], _] = inner;
    let [[m11, _, m13], [m21, _, m23], [m31, _, _]] = *m;
    let a = math::atan2(m23, m13) - math::atan2(n23, n13);
    // m = Rz(a)·inner·Rz(c): the first column of Rz(c) is innerᵀ·Rz(-a) times that of m.
    let (sa, ca) = math::sin_cos(a);
    let first = [ca * m11 + sa * m21, ca * m21 - sa * m11, m31];
    let [along, across, _] = pose::transposed(&inner);
    [a, b, math::atan2(pose::dot(&across, &first), pose::dot(&along, &first))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    #[test]
    fn figure_angles_and_row_values_are_each_other_s_inverse() {
        let mut random = Random(81);
        for _ in 0..1_000 {
            let (row, offset) = (random.angle(), random.sometimes(-3.0, 3.0));
            for reversed in [false, true] {
                let back = row_value(figure_angle(row, offset, reversed), offset, reversed);
                assert!((back - row).abs() <= 4.0 * f64::EPSILON, "{row} {offset} {reversed}: {back}");
            }
        }
    }
}
