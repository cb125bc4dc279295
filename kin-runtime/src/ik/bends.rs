//! Both bends of an orthogonal wrist over placements of the base side by side, and forward kinematics of what comes out.
//!
//! Lanes are the placements of one pose ([`side`](crate::ik::side)) or poses of a batch ([`abreast`](crate::ik::abreast)); a
//! lane has the same bits whatever stands beside it.
//!
//! A sine is taken once for all that need it: the wrist's matrix and forward kinematics of both bends turn by the same first
//! joints, the bend itself only changes its sign, and its outer angles go to the other side.

use crate::arm::{Joint, JointKind};
use crate::ik::wrist::{Rows, row_values};
use crate::math::{self, Float, Lanes, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::{Known, SolveWrist};

/// The sines and cosines of a program's turns.
pub(super) struct Turned<T, const L: usize> {
    angles: [Lanes<T, L>; 8],
    pub(super) sines: [Lanes<T, L>; 8],
    pub(super) cosines: [Lanes<T, L>; 8],
}

impl<T: Float, const L: usize> Turned<T, L> {
    /// Of a program whose turns nobody asks for again.
    #[inline(always)]
    pub(super) fn of_unknown(sines: [Lanes<T, L>; 8], cosines: [Lanes<T, L>; 8]) -> Self {
        Turned { angles: [Lanes::splat(T::lit(0.0)); 8], sines, cosines }
    }

    /// The sines and cosines of the first `count` angles, those that are `known` from there.
    #[inline(always)]
    fn new(
        angles: [Lanes<T, L>; 8],
        count: usize,
        known: impl Fn(usize, &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]>,
    ) -> Self {
        let [a, b, c, d, e, f, g, h] = &angles;
        let [a, b, c, d] = [(0, a), (1, b), (2, c), (3, d)];
        let [e, f, g, h] = [(4, e), (5, f), (6, g), (7, h)];
        let ([sa, ca], [sb, cb]) = (taken(a, count, &known), taken(b, count, &known));
        let ([sc, cc], [sd, cd]) = (taken(c, count, &known), taken(d, count, &known));
        let ([se, ce], [sf, cf]) = (taken(e, count, &known), taken(f, count, &known));
        let ([sg, cg], [sh, ch]) = (taken(g, count, &known), taken(h, count, &known));
        Turned { sines: [sa, sb, sc, sd, se, sf, sg, sh], cosines: [ca, cb, cc, cd, ce, cf, cg, ch], angles }
    }

    /// Sine and cosine of one of these angles.
    #[inline(always)]
    fn of(&self, index: usize) -> Option<[Lanes<T, L>; 2]> {
        Some([*self.sines.get(index)?, *self.cosines.get(index)?])
    }

    /// Zero, or NaN if a sine is none: as only that of a lane that is alone may be.
    #[inline(always)]
    fn nothing(&self) -> Lanes<T, L> {
        if !Lanes::<T, L>::ALONE {
            return Lanes::splat(T::lit(-0.0));
        }
        let [a, b, c, d, e, f, g, h] = self.sines;
        (((a + b) + (c + d)) + ((e + f) + (g + h))) * Lanes::splat(T::lit(0.0))
    }

    /// Sine and cosine of angles that are half a turn from one of these but for round-off; where a lane is alone, NaN if it is
    /// not.
    #[inline(always)]
    fn across(&self, index: usize, angle: &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]> {
        let (known, [sine, cosine]) = (self.angles.get(index)?, self.of(index)?);
        // What the difference is besides half a turn, exactly but for one rounding of next to nothing.
        let by = *angle - *known;
        let back = by - *angle;
        let lost = (*angle - (by - back)) - (*known + back);
        let (half, rest) = (math::half_turn::<T>(), T::TURN.1 * T::lit(0.5));
        let sign = by.map(|by| if by > T::lit(0.0) { T::lit(1.0) } else { T::lit(-1.0) });
        let over = ((by - sign * Lanes::splat(half)) + lost) - sign * Lanes::splat(rest);
        let is_round_off = |over: T| math::abs(over) <= T::lit(4.0) * T::EPS;
        let across = |over: Lanes<T, L>| [-(sine + cosine * over), sine * over - cosine];
        if Lanes::<T, L>::ALONE {
            return Some(across(over.map(|over| if is_round_off(over) { over } else { T::lit(f64::NAN) })));
        }
        if all(over, over, |over, _| is_round_off(over)) {
            return Some(across(over));
        }
        // Each lane has the bits that it has beside any others.
        let ([mut sines, mut cosines], [across_sines, across_cosines]) = (angle.turned(), across(over));
        for (lane, over) in over.0.into_iter().enumerate() {
            if is_round_off(over) {
                sines.put(lane, across_sines.lane(lane));
                cosines.put(lane, across_cosines.lane(lane));
            }
        }
        Some([sines, cosines])
    }
}

/// Sine and cosine of one of so many angles, if it is not known from elsewhere.
#[inline(always)]
fn taken<T: Float, const L: usize>(
    (index, angle): (usize, &Lanes<T, L>),
    count: usize,
    known: &impl Fn(usize, &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]>,
) -> [Lanes<T, L>; 2] {
    if index >= count {
        // The zero that compilers know to change no sum.
        return [Lanes::splat(T::lit(-0.0)); 2];
    }
    if let Some(known) = known(index, angle) {
        return known;
    }
    angle.turned()
}

/// Whether something holds in all lanes; without an early return, which is a branch for each lane.
#[inline(always)]
pub(super) fn all<T: Float, const L: usize>(
    a: Lanes<T, L>,
    b: Lanes<T, L>,
    holds: impl Fn(T, T) -> bool,
) -> bool {
    let mut all = true;
    for (a, b) in a.0.into_iter().zip(b.0) {
        all &= holds(a, b);
    }
    all
}

/// Both bends of the wrist over placements side by side.
#[derive(Clone, Copy)]
pub(super) struct Bent<T, const L: usize> {
    /// Joint values, without and with the flip.
    pub(super) q: [[Lanes<T, L>; 6]; 2],
    /// How far forward kinematics of them misses the pose.
    pub(super) residual: [Lanes<T, L>; 2],
}

/// What the wrist must turn over placements side by side.
pub(super) struct Aimed<T, const L: usize> {
    pub(super) turned: Turned<T, L>,
    pub(super) matrix: [[Lanes<T, L>; 3]; 3],
    /// The sine of the bend, not negative: how long the third column is beside the axis.
    pub(super) sine: Lanes<T, L>,
}

impl<T: Float, const L: usize> Aimed<T, L> {
    /// The sines and cosines of the wrist's turns are taken where they are not `known`.
    #[inline(always)]
    pub(super) fn new<A: SolveWrist<6>>(
        arm: &A,
        pose: &Pose<Lanes<T, L>>,
        rows: [Lanes<T, L>; 3],
        known: impl Fn(usize, &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]>,
    ) -> Self {
        let turned = Turned::new(arm.wrist_turns(rows), A::WRIST_TURNS, known);
        let matrix = arm.wrist_matrix(&arm.wrist_turned(rows, pose, &turned.sines, &turned.cosines));
        let [[_, _, m13], [_, _, m23], _] = matrix;
        Aimed { sine: (m13 * m13 + m23 * m23).sqrt(), turned, matrix }
    }
}

/// The row values of an orthogonal wrist, and its bend's distance from straight.
#[derive(Clone, Copy)]
pub(super) struct Angles<T, const L: usize> {
    pub(super) noflip: [Lanes<T, L>; 3],
    pub(super) flip: [Lanes<T, L>; 3],
    pub(super) margin: Lanes<T, L>,
}

impl<T: Float, const L: usize> Angles<T, L> {
    /// As [`zyz`](crate::ik::wrist), where the third column, so long beside the axis, is not short.
    #[inline(always)]
    pub(super) fn new(aimed: &Aimed<T, L>, offsets: &Rows<T>) -> Self {
        let ([[m11, m12, m13], [m21, m22, m23], [_, _, m33]], sine) = (aimed.matrix, aimed.sine);
        let a = Lanes::directed(m23, m13);
        let b = Lanes::directed(sine, m33);
        let c = Lanes::directed(m13 * m21 - m23 * m11, m13 * m22 - m23 * m12);
        let half = math::half_turn::<T>();
        let turn =
            |angle: Lanes<T, L>| angle - angle.map(|angle| if angle > T::lit(0.0) { half } else { -half });
        let margin = b.least(Lanes::splat(half) - b);
        let ([oa, ob, oc], [ra, rb, rc]) = (offsets.offset, offsets.reversed);
        let noflip = [row_values(a, oa, ra), row_values(b, ob, rb), row_values(c, oc, rc)];
        let flip = [row_values(turn(a), oa, ra), row_values(-b, ob, rb), row_values(turn(c), oc, rc)];
        if Lanes::<T, L>::ALONE {
            return Angles { noflip, flip, margin };
        }
        let ([a, b, c], [d, e, f]) = (noflip, flip);
        let [a, b, c, d, e, f] = Lanes::wrap_all([a, b, c, d, e, f]);
        let (noflip, flip) = ([a, b, c], [d, e, f]);
        Angles { noflip, flip, margin }
    }
}

impl<T: Float, const L: usize> Bent<T, L> {
    /// Both bends of a wrist that is not straight; `per_scale` is one over the size against which the poses are judged.
    #[inline(always)]
    pub(super) fn new<A: SolveWrist<6>>(
        arm: &A,
        pose: &Pose<Lanes<T, L>>,
        per_scale: Lanes<T, L>,
        [t1, t2, t3]: [Lanes<T, L>; 3],
        aimed: &Aimed<T, L>,
        angles: &Angles<T, L>,
    ) -> Self {
        let ([n4, n5, n6], [f4, f5, f6]) = (angles.noflip, angles.flip);
        let (noflip, flip) =
            (joint_values(arm, [t1, t2, t3, n4, n5, n6]), joint_values(arm, [t1, t2, t3, f4, f5, f6]));
        let first = Turned::new(
            arm.fk_turns(&noflip),
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
                Some(Known::Outer) => first.across(index, angle),
                Some(Known::Bend) if opposite => first.of(index).map(|[sine, cosine]| [-sine, cosine]),
                _ => None,
            },
        );
        let residual = [
            missed(pose, per_scale, &arm.fk_turned(&noflip, &first.sines, &first.cosines)) + first.nothing(),
            missed(pose, per_scale, &arm.fk_turned(&flip, &second.sines, &second.cosines)) + second.nothing(),
        ];
        Bent { residual, q: [pose::entries(&noflip), pose::entries(&flip)] }
    }
}

/// The joint values that command row values, angles in (-π, π].
#[inline(always)]
pub(super) fn joint_values<T: Float, const L: usize, A: SolveWrist<6>>(
    arm: &A,
    rows: [Lanes<T, L>; 6],
) -> Joints<Lanes<T, L>, 6> {
    let q = arm.command(rows);
    // Row values are in that range already.
    pose::column(if A::COUPLED { commanded(&A::JOINTS, q) } else { q })
}

/// How far poses miss others, `per_scale` being one over the scale: see [`Target::missed_by`].
#[inline(always)]
fn missed<T: Float, const L: usize>(
    pose: &Pose<Lanes<T, L>>,
    per_scale: Lanes<T, L>,
    other: &Pose<Lanes<T, L>>,
) -> Lanes<T, L> {
    let (([x, y, z], p), ([u, v, w], q)) = (pose::rows(pose), pose::rows(other));
    let ([x, _], [y, _], [z, _], [p, all]) = (far(x, u), far(y, v), far(z, w), far(p, q));
    // A comparison lets go of what is not a number; a sum does not, and adds nothing to what is one. Entries of the rotation
    // are none only where a sine is.
    x.greatest(y).greatest(z).greatest(p * per_scale) + all * Lanes::splat(T::lit(0.0))
}

/// The largest difference between two triples, and the sum of all.
#[inline(always)]
fn far<T: Float, const L: usize>(
    [a, b, c]: [Lanes<T, L>; 3],
    [d, e, f]: [Lanes<T, L>; 3],
) -> [Lanes<T, L>; 2] {
    let [a, b, c] = [(a - d).abs(), (b - e).abs(), (c - f).abs()];
    [a.greatest(b).greatest(c), a + b + c]
}

/// Commanded values with their angles in (-π, π].
#[inline(always)]
pub(crate) fn commanded<T: Float, const L: usize>(
    joints: &[Joint; 6],
    mut q: [Lanes<T, L>; 6],
) -> [Lanes<T, L>; 6] {
    for (value, joint) in q.iter_mut().zip(joints) {
        if joint.kind == JointKind::Revolute {
            *value = value.wrap();
        }
    }
    q
}
