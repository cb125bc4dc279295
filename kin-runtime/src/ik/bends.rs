//! Both bends of an orthogonal wrist over a placement of the base, and forward kinematics of what comes out; without a branch,
//! so that a loop over placements or poses becomes one over vectors ([`wrists`](crate::ik::wrists)).
//!
//! A sine is taken once for all that need it: the wrist's matrix and forward kinematics of both bends turn by the same first
//! joints, the bend itself only changes its sign, and its outer angles go to the other side.

use crate::ik::given_out;
use crate::ik::wrist::{Rows, straight_row_value};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::private::{Known, SolveWrist};

/// The sines and cosines of a program's turns.
pub(super) struct Turned<T> {
    pub(super) sines: [T; 8],
    pub(super) cosines: [T; 8],
}

impl<T: Float> Turned<T> {
    /// Of the first `count` angles, those that are `known` from there.
    #[inline(always)]
    fn new(angles: [T; 8], count: usize, known: impl Fn(usize, T) -> Option<[T; 2]>) -> Self {
        let [a, b, c, d, e, f, g, h] = angles;
        let ([sa, ca], [sb, cb]) = (taken(0, a, count, &known), taken(1, b, count, &known));
        let ([sc, cc], [sd, cd]) = (taken(2, c, count, &known), taken(3, d, count, &known));
        let ([se, ce], [sf, cf]) = (taken(4, e, count, &known), taken(5, f, count, &known));
        let ([sg, cg], [sh, ch]) = (taken(6, g, count, &known), taken(7, h, count, &known));
        Turned { sines: [sa, sb, sc, sd, se, sf, sg, sh], cosines: [ca, cb, cc, cd, ce, cf, cg, ch] }
    }

    /// Sine and cosine of one of these angles.
    #[inline(always)]
    fn of(&self, index: usize) -> Option<[T; 2]> {
        Some([*self.sines.get(index)?, *self.cosines.get(index)?])
    }

    /// Sine and cosine of an angle that is half a turn from one of these, whose own angle is `known`, but for round-off. Of any
    /// other they would be so far off that forward kinematics misses the pose.
    #[inline(always)]
    fn across(&self, index: usize, known: T, angle: T) -> Option<[T; 2]> {
        let [sine, cosine] = self.of(index)?;
        // What the difference is besides half a turn, exactly but for one rounding of next to nothing.
        let by = angle - known;
        let back = by - angle;
        let lost = (angle - (by - back)) - (known + back);
        let (half, rest) = (math::half_turn::<T>(), T::TURN.1 * T::lit(0.5));
        let sign = if by > T::lit(0.0) { T::lit(1.0) } else { T::lit(-1.0) };
        let over = ((by - sign * half) + lost) - sign * rest;
        Some([-(sine + cosine * over), sine * over - cosine])
    }
}

/// Sine and cosine of one of so many angles, if it is not known from elsewhere.
#[inline(always)]
fn taken<T: Float>(
    index: usize,
    angle: T,
    count: usize,
    known: &impl Fn(usize, T) -> Option<[T; 2]>,
) -> [T; 2] {
    if index >= count {
        // The zero that compilers know to change no sum.
        return [T::lit(-0.0); 2];
    }
    if let Some(known) = known(index, angle) {
        return known;
    }
    let (sine, cosine) = T::sin_cos_straight(angle);
    [sine, cosine]
}

/// What the wrist must turn over a placement.
pub(super) struct Aimed<T> {
    pub(super) turned: Turned<T>,
    pub(super) matrix: [[T; 3]; 3],
    /// The sine of the bend, not negative: how long the third column is beside the axis.
    pub(super) sine: T,
}

impl<T: Float> Aimed<T> {
    /// `first` are sine and cosine of joint 1, which the wrist may turn by too.
    #[inline(always)]
    pub(super) fn new<A: SolveWrist<6>>(arm: &A, pose: &Pose<T>, rows: [T; 3], first: [T; 2]) -> Self {
        let [t1, ..] = rows;
        let turned = Turned::new(
            arm.wrist_turns(rows),
            A::WRIST_TURNS,
            #[inline(always)]
            |index, angle| (index == 0 && is_known_as(angle, t1)).then_some(first),
        );
        let matrix = arm.wrist_matrix(&arm.wrist_turned(rows, pose, &turned.sines, &turned.cosines));
        let [[_, _, m13], [_, _, m23], _] = matrix;
        Aimed { sine: math::sqrt(m13 * m13 + m23 * m23), turned, matrix }
    }
}

/// Whether two angles are the same. And not `==`, which compilers know of one number only where it is known not to be NaN.
#[inline(always)]
fn is_known_as<T: Float>(a: T, b: T) -> bool {
    let (less, greater) = (a < b, a > b);
    !(less | greater)
}

/// The row values of an orthogonal wrist, and its bend's distance from straight.
pub(super) struct Angles<T> {
    pub(super) noflip: [T; 3],
    pub(super) flip: [T; 3],
    pub(super) margin: T,
}

impl<T: Float> Angles<T> {
    /// As [`zyz`](crate::ik::wrist), where the third column, so long beside the axis, is not short.
    #[inline(always)]
    pub(super) fn new(aimed: &Aimed<T>, offsets: &Rows<T>) -> Self {
        let ([[m11, m12, m13], [m21, m22, m23], [_, _, m33]], sine) = (aimed.matrix, aimed.sine);
        let a = T::atan2_straight(m23, m13);
        let b = T::atan2_straight(sine, m33);
        let c = T::atan2_straight(m13 * m21 - m23 * m11, m13 * m22 - m23 * m12);
        let half = math::half_turn::<T>();
        let turn = |angle: T| angle - if angle > T::lit(0.0) { half } else { -half };
        let ([oa, ob, oc], [ra, rb, rc]) = (offsets.offset, offsets.reversed);
        let row = |a, b, c| {
            [straight_row_value(a, oa, ra), straight_row_value(b, ob, rb), straight_row_value(c, oc, rc)]
        };
        let (noflip, flip) = (row(a, b, c), row(turn(a), -b, turn(c)));
        Angles { noflip, flip, margin: math::min(b, half - b) }
    }
}

/// How far forward kinematics of both bends misses the pose; `per_scale` is one over the size against which it is judged. The
/// wrist is not straight.
#[inline(always)]
pub(super) fn residuals<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    per_scale: T,
    [t1, t2, t3]: [T; 3],
    aimed: &Aimed<T>,
    angles: &Angles<T>,
) -> [T; 2] {
    let ([n4, n5, n6], [f4, f5, f6]) = (angles.noflip, angles.flip);
    let (noflip, flip) =
        (joint_values(arm, [t1, t2, t3, n4, n5, n6]), joint_values(arm, [t1, t2, t3, f4, f5, f6]));
    let turns = arm.fk_turns(&noflip);
    let first = Turned::new(
        turns,
        A::FK_TURNS,
        #[inline(always)]
        |index, _| match A::FK_KNOWN.get(index) {
            Some(Known::Wrist(turn)) => aimed.turned.of(*turn),
            _ => None,
        },
    );
    // With an offset the bend is not the opposite of what it was.
    let is_opposite = |Rows { offset: [_, bend, _], .. }| bend == T::lit(0.0);
    let opposite = arm.orthogonal_wrist::<T>().is_some_and(is_opposite);
    let second = Turned::new(
        arm.fk_turns(&flip),
        A::FK_TURNS,
        #[inline(always)]
        |index, angle| match A::FK_KNOWN.get(index) {
            Some(Known::Wrist(_) | Known::Base) => first.of(index),
            Some(Known::Outer) => first.across(index, *turns.get(index)?, angle),
            Some(Known::Bend) if opposite => first.of(index).map(|[sine, cosine]| [-sine, cosine]),
            _ => None,
        },
    );
    [
        missed(pose, per_scale, &arm.fk_turned(&noflip, &first.sines, &first.cosines)),
        missed(pose, per_scale, &arm.fk_turned(&flip, &second.sines, &second.cosines)),
    ]
}

/// The joint values that command row values, angles in (-π, π].
#[inline(always)]
pub(super) fn joint_values<T: Float, A: SolveWrist<6>>(arm: &A, rows: [T; 6]) -> Joints<T, 6> {
    let q = arm.command(rows);
    // Row values are in that range already.
    if A::COUPLED { given_out(q, &A::JOINTS) } else { pose::column(q) }
}

/// How far a pose misses another, `per_scale` being one over the scale: see [`Target::missed_by`](crate::ik::target::Target).
/// A comparison lets go of what is not a number; but here all are: the arm's constants and turns because it is usual, the pose
/// because it has been judged, row values where [`Aimed::sine`] is one.
#[inline(always)]
fn missed<T: Float>(pose: &Pose<T>, per_scale: T, other: &Pose<T>) -> T {
    let (([x, y, z], p), ([u, v, w], q)) = (pose::rows(pose), pose::rows(other));
    let (x, y, z, p) = (apart(x, u), apart(y, v), apart(z, w), apart(p, q));
    math::max(math::max(math::max(x, y), z), p * per_scale)
}

/// The largest difference between two triples.
#[inline(always)]
fn apart<T: Float>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> T {
    let [a, b, c] = [math::abs(a - d), math::abs(b - e), math::abs(c - f)];
    math::max(math::max(a, b), c)
}
