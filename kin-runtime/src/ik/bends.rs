//! Both bends of an orthogonal wrist over a placement of the base, and forward kinematics of what comes out; without a branch,
//! so that a loop over placements or poses becomes one over vectors ([`placements`](crate::ik::placements)).
//!
//! No sine is taken that is known: joint values come with theirs ([`figure`](crate::ik::figure)), and the wrist's matrix and forward
//! kinematics of both bends turn by the same first joints.

use crate::ik::figure::{Figure, Row, Zero, values};
use crate::ik::given_out;
use crate::ik::wrist::Rows;
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
    fn new(angles: [T; 8], count: usize, known: impl Fn(usize) -> Option<[T; 2]>) -> Self {
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
}

/// Sine and cosine of one of so many angles.
#[inline(always)]
fn taken<T: Float>(index: usize, angle: T, count: usize, known: &impl Fn(usize) -> Option<[T; 2]>) -> [T; 2] {
    if index >= count {
        // The zero that compilers know to change no sum.
        return [T::lit(-0.0); 2];
    }
    if let Some(known) = known(index) {
        return known;
    }
    let (sine, cosine) = T::sin_cos_straight(angle);
    [sine, cosine]
}

/// Sine and cosine of a turn of which this is known, once these row values are.
#[inline(always)]
fn known<T: Float>(what: Option<&Known>, rows: &[Row<T>]) -> Option<[T; 2]> {
    let row = match *what? {
        Known::Row(joint) => *rows.get(joint)?,
        Known::Sum(joint, other) => rows.get(joint)?.plus(*rows.get(other)?),
        Known::Difference(joint, other) => rows.get(joint)?.plus(rows.get(other)?.negated()),
        Known::Wrist(_) | Known::Nothing => return None,
    };
    Some([row.sine, row.cosine])
}

/// What the wrist must turn over a placement.
pub(super) struct Aimed<T> {
    pub(super) turned: Turned<T>,
    pub(super) matrix: [[T; 3]; 3],
    /// The sine of the bend, not negative: how long the third column is beside the axis.
    pub(super) sine: T,
}

impl<T: Float> Aimed<T> {
    /// Over the placement with these row values.
    #[inline(always)]
    pub(super) fn new<A: SolveWrist<6>>(arm: &A, pose: &Pose<T>, rows: &[Row<T>; 3]) -> Self {
        let of = values(rows);
        let turned = Turned::new(
            arm.wrist_turns(of),
            A::WRIST_TURNS,
            #[inline(always)]
            |index| known(A::WRIST_KNOWN.get(index), rows),
        );
        let matrix = arm.wrist_matrix(&arm.wrist_turned(of, pose, &turned.sines, &turned.cosines));
        let [[_, _, m13], [_, _, m23], _] = matrix;
        Aimed { sine: math::sqrt(m13 * m13 + m23 * m23), turned, matrix }
    }
}

/// The row values of an orthogonal wrist, and its bend's distance from straight.
pub(super) struct Angles<T> {
    pub(super) noflip: [Row<T>; 3],
    pub(super) flip: [Row<T>; 3],
    pub(super) margin: T,
}

impl<T: Float> Angles<T> {
    /// As [`zyz`](crate::ik::wrist), where the third column, so long beside the axis, is not short.
    #[inline(always)]
    pub(super) fn new(aimed: &Aimed<T>, offsets: &Rows<T>) -> Self {
        let ([[m11, m12, m13], [m21, m22, m23], [_, _, m33]], sine) = (aimed.matrix, aimed.sine);
        let per = T::lit(1.0) / sine;
        // The matrix is a rotation: its third column has length 1, and the last direction that of its part beside the axis.
        let (a, b) = (Figure::of([m23, m13], per), Figure::above([sine, m33]));
        let c = Figure::of([m13 * m21 - m23 * m11, m13 * m22 - m23 * m12], per).unit();
        let ([oa, ob, oc], [ra, rb, rc]) = (offsets.offset, offsets.reversed);
        let (first, bend, last) = (Zero::new(oa, ra), Zero::new(ob, rb), Zero::new(oc, rc));
        let bent = b.row(&bend);
        let bowed = if bend.is_none() { bent.negated() } else { b.negated().row(&bend) };
        let noflip = [a.row(&first), bent, c.row(&last)];
        let flip = [a.opposite().row(&first), bowed, c.opposite().row(&last)];
        Angles { noflip, flip, margin: math::min(b.angle, math::half_turn::<T>() - b.angle) }
    }
}

/// How far forward kinematics of both bends misses the pose; `per_scale` is one over the size against which it is judged. The
/// wrist is not straight.
#[inline(always)]
pub(super) fn residuals<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    per_scale: T,
    base: &[Row<T>; 3],
    turned: &Turned<T>,
    angles: &Angles<T>,
) -> [T; 2] {
    [
        residual(arm, pose, per_scale, base, turned, &angles.noflip),
        residual(arm, pose, per_scale, base, turned, &angles.flip),
    ]
}

/// That of one of the bends.
#[inline(always)]
fn residual<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    per_scale: T,
    &[t1, t2, t3]: &[Row<T>; 3],
    turned: &Turned<T>,
    &[t4, t5, t6]: &[Row<T>; 3],
) -> T {
    let rows = [t1, t2, t3, t4, t5, t6];
    let q = joint_values(arm, [t1.value, t2.value, t3.value, t4.value, t5.value, t6.value]);
    let all = Turned::new(
        arm.fk_turns(&q),
        A::FK_TURNS,
        #[inline(always)]
        |index| match A::FK_KNOWN.get(index) {
            Some(Known::Wrist(turn)) => turned.of(*turn),
            what => known(what, &rows),
        },
    );
    missed(pose, per_scale, &arm.fk_turned(&q, &all.sines, &all.cosines))
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
