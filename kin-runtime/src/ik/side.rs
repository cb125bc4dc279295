//! Branches side by side: the four placements of a base as lanes, their wrists, and forward kinematics of what comes out.
//!
//! A sine is taken once for all that need it: the wrist's matrix and forward kinematics of both bends turn by the same first
//! joints, the bend itself only changes its sign, and its outer angles go to the other side.

use crate::arm::{Joint, JointKind};
use crate::ik::elbow::{Seen, Side};
use crate::ik::sliding;
use crate::ik::target::{Target, accepted};
use crate::ik::wrist::{Rows, row_length};
use crate::ik::{ElbowBase, ROUND_OFF};
use crate::math::{self, Float, Lanes, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::{Known, SolveWrist};
use crate::solutions::{
    Bend, Elbow, Free, Margins, Posture, Reason, Shoulder, Slot, Solution, Solutions, tolerance,
};

/// A value for each of four placements.
pub(crate) type Four<T> = Lanes<T, 4>;

/// The sines and cosines of a program's turns.
struct Turned<T, const L: usize> {
    angles: [Lanes<T, L>; 8],
    sines: [Lanes<T, L>; 8],
    cosines: [Lanes<T, L>; 8],
}

impl<T: Float, const L: usize> Turned<T, L> {
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

    /// Sine and cosine of an angle that is the opposite of one of these, or half a turn from it but for round-off.
    #[inline(always)]
    fn across(&self, index: usize, angle: &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]> {
        let (known, [sine, cosine]) = (self.angles.get(index)?, self.of(index)?);
        if all(*known, *angle, |a, b| a == -b) {
            return Some([-sine, cosine]);
        }
        // What the difference is besides half a turn, exactly but for one rounding of next to nothing.
        let by = *angle - *known;
        let back = by - *angle;
        let lost = (*angle - (by - back)) - (*known + back);
        let (half, rest) = (math::half_turn::<T>(), T::TURN.1 * T::lit(0.5));
        let signed = |x: T| by.map(|by| if by > T::lit(0.0) { x } else { -x });
        let over = ((by - signed(half)) + lost) - signed(rest);
        let round_off = T::lit(4.0) * T::EPS;
        all(over, over, |over, _| math::abs(over) <= round_off)
            .then(|| [-(sine + cosine * over), sine * over - cosine])
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
        return [Lanes::splat(T::lit(0.0)); 2];
    }
    if let Some(known) = known(index, angle) {
        return known;
    }
    let (sines, cosines) = T::sin_cos_all(angle.0);
    [Lanes(sines), Lanes(cosines)]
}

/// Those of an angle of the placements: that of the first joint alone comes twice.
#[inline(always)]
fn of_placements<T: Float, const L: usize>(angle: &Lanes<T, L>) -> Option<[Lanes<T, L>; 2]> {
    let [a, b, c, d] = angle.0.as_slice() else { return None };
    if !((*a == *c) & (*b == *d)) {
        return None;
    }
    let ([s, t], [c, d]) = T::sin_cos_all([*a, *b]);
    let twice = |x, y| {
        let mut lanes = *angle;
        if let [a, b, c, d] = lanes.0.as_mut_slice() {
            (*a, *b, *c, *d) = (x, y, x, y);
        }
        lanes
    };
    Some([twice(s, t), twice(c, d)])
}

/// Whether something holds in all lanes; without an early return, which is a branch for each lane.
#[inline(always)]
fn all<T: Float, const L: usize>(a: Lanes<T, L>, b: Lanes<T, L>, holds: impl Fn(T, T) -> bool) -> bool {
    let mut all = true;
    for (a, b) in a.0.into_iter().zip(b.0) {
        all &= holds(a, b);
    }
    all
}

/// The same pose in every lane.
#[inline(always)]
fn side_by_side<T: Float, const L: usize>(pose: &Pose<T>) -> Pose<Lanes<T, L>> {
    let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = pose::rows(pose);
    let row = |x, y, z| [Lanes::splat(x), Lanes::splat(y), Lanes::splat(z)];
    pose::from_rows([row(a, b, c), row(d, e, f), row(g, h, i)], row(x, y, z))
}

/// Both bends of the wrist over placements side by side.
struct Bent<T, const L: usize> {
    /// Joint values, without and with the flip.
    q: [[Lanes<T, L>; 6]; 2],
    /// How far forward kinematics of them misses the pose.
    residual: [Lanes<T, L>; 2],
    /// The bend's distance from straight.
    margin: Lanes<T, L>,
}

impl<T: Float, const L: usize> Bent<T, L> {
    /// Both bends, where the sine of none of them is less than `far`.
    #[inline(always)]
    fn new<A: SolveWrist<6>>(
        arm: &A,
        pose: &Pose<Lanes<T, L>>,
        scale: Lanes<T, L>,
        [t1, t2, t3]: [Lanes<T, L>; 3],
        far: T,
    ) -> Option<Self> {
        let offsets = arm.orthogonal_wrist::<T>()?;
        let wrist =
            Turned::new(arm.wrist_turns([t1, t2, t3]), A::WRIST_TURNS, |_, angle| of_placements(angle));
        let matrix = arm.wrist_matrix(&arm.wrist_turned([t1, t2, t3], pose, &wrist.sines, &wrist.cosines));
        // The third column is that sine long: no angle is taken where it is too short.
        let [[_, _, m13], [_, _, m23], _] = matrix;
        let sine = (m13 * m13 + m23 * m23).sqrt();
        if !all(sine, sine, |sine, _| sine > far) {
            return None;
        }
        let Angles { noflip: [n4, n5, n6], flip: [f4, f5, f6], margin } =
            Angles::new(&matrix, sine, &offsets);
        let (noflip, flip) =
            (joint_values(arm, [t1, t2, t3, n4, n5, n6]), joint_values(arm, [t1, t2, t3, f4, f5, f6]));
        let first = Turned::new(
            arm.fk_turns(&noflip),
            A::FK_TURNS,
            #[inline(always)]
            |index, _| {
                if let Some(Known::Wrist(turn)) = A::FK_KNOWN.get(index) { wrist.of(*turn) } else { None }
            },
        );
        let second = Turned::new(
            arm.fk_turns(&flip),
            A::FK_TURNS,
            #[inline(always)]
            |index, angle| match A::FK_KNOWN.get(index) {
                Some(Known::Wrist(_) | Known::Base) => first.of(index),
                _ => first.across(index, angle),
            },
        );
        let residual = [
            missed(pose, scale, &arm.fk_turned(&noflip, &first.sines, &first.cosines)),
            missed(pose, scale, &arm.fk_turned(&flip, &second.sines, &second.cosines)),
        ];
        Some(Bent { residual, q: [pose::entries(&noflip), pose::entries(&flip)], margin })
    }
}

/// The joint values that command row values, angles in (-π, π].
#[inline(always)]
fn joint_values<T: Float, const L: usize, A: SolveWrist<6>>(
    arm: &A,
    rows: [Lanes<T, L>; 6],
) -> Joints<Lanes<T, L>, 6> {
    let q = arm.command(rows);
    // Row values are in that range already.
    pose::column(if A::COUPLED { commanded(&A::JOINTS, q) } else { q })
}

/// How far poses miss others: see [`Target::missed_by`].
#[inline(always)]
fn missed<T: Float, const L: usize>(
    pose: &Pose<Lanes<T, L>>,
    scale: Lanes<T, L>,
    other: &Pose<Lanes<T, L>>,
) -> Lanes<T, L> {
    let (([x, y, z], p), ([u, v, w], q)) = (pose::rows(pose), pose::rows(other));
    let ([x, _], [y, _], [z, _], [p, all]) = (far(x, u), far(y, v), far(z, w), far(p, q));
    // A comparison lets go of what is not a number; a sum does not, and adds nothing to what is one.
    x.greatest(y).greatest(z).greatest(p / scale) + all * Lanes::splat(T::lit(0.0))
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

/// Joint by joint what came placement by placement.
pub(crate) fn transposed<T>([a, b, c, d]: [[T; 6]; 4]) -> [Four<T>; 6] {
    let ([a1, a2, a3, a4, a5, a6], [b1, b2, b3, b4, b5, b6]) = (a, b);
    let ([c1, c2, c3, c4, c5, c6], [d1, d2, d3, d4, d5, d6]) = (c, d);
    [
        Lanes([a1, b1, c1, d1]),
        Lanes([a2, b2, c2, d2]),
        Lanes([a3, b3, c3, d3]),
        Lanes([a4, b4, c4, d4]),
        Lanes([a5, b5, c5, d5]),
        Lanes([a6, b6, c6, d6]),
    ]
}

/// All solutions of an arm with an elbow and an orthogonal wrist, if no figure is near a singular one: so far from it that no
/// two solutions can be one, nothing is free, and nothing is in doubt.
#[inline(always)]
pub(crate) fn regular<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    base: &ElbowBase<T>,
) -> Option<Solutions<T, 6, Posture>> {
    let (one, far) = (T::lit(1.0), T::lit(64.0) * tolerance::<T>());
    let far_away = far * math::max(target.scale, one);
    let centre = arm.wrist_centre(&target.pose);
    let seen = Seen::new(base, centre.map(|x| Lanes([x; 2])));
    let [half, _] = seen.half.0;
    if half <= far_away {
        return None;
    }
    let window = T::lit(ROUND_OFF) * T::EPS * target.scale;
    let side = Side::new(base, &seen, Lanes([one, -one]), Lanes::splat(window));
    let ([right, left], [elbow, bow]) = (side.closes, side.elbow.0);
    let apart = ((elbow > far_away) | !right) & ((bow > far_away) | !left);
    if !(apart & (right | left)) {
        return None;
    }
    // Where a shoulder does not close stands the other one.
    let pick = |Lanes([a, b]): Lanes<T, 2>| [if right { a } else { b }, if left { b } else { a }];
    let four = |up: Lanes<T, 2>, down: Lanes<T, 2>| {
        let ([a, b], [c, d]) = (pick(up), pick(down));
        Lanes([a, b, c, d])
    };
    let [[first, up2, up3], [_, down2, down3]] = side.elbows(base);
    let rows = [four(first, first), four(up2, down2), four(up3, down3)];
    let bent = Bent::new(arm, &side_by_side(&target.pose), Lanes::splat(target.scale), rows, far)?;
    let [noflip, flip] = bent.residual;
    if !all(noflip, flip, |a, b| accepted(a).is_ok() & accepted(b).is_ok()) {
        return None;
    }
    let [t1, t1_left] = first.0;
    let mut open = [None; 2];
    if !right {
        open = [Some(side.open(base, 0, t1, target.scale)?), None];
    }
    if !left {
        open = [None, Some(side.open(base, 1, t1_left, target.scale)?)];
    }
    Some(slots(&A::JOINTS, &bent, half, [elbow, bow], open))
}

/// The slots of four placements, where `open` does not say why a shoulder is empty.
#[inline(always)]
fn slots<T: Float>(
    joints: &[Joint; 6],
    bent: &Bent<T, 4>,
    shoulder: T,
    elbow: [T; 2],
    [right, left]: [Option<Reason<T>>; 2],
) -> Solutions<T, 6, Posture> {
    let ([noflip, flip], [q, flipped], [elbow, bow]) = (bent.residual, &bent.q, elbow);
    Solutions::new(
        sliding(joints),
        #[inline(always)]
        |branch: Posture| {
            let (open, elbow) = if branch.shoulder == Shoulder::Right { (right, elbow) } else { (left, bow) };
            if let Some(reason) = open {
                return Slot::Empty(reason);
            }
            // The lanes are right and left with the elbow up, then with the elbow down.
            let lane =
                usize::from(branch.shoulder == Shoulder::Left) + 2 * usize::from(branch.elbow == Elbow::Down);
            let (q, residual) = if branch.wrist == Bend::NoFlip { (q, noflip) } else { (flipped, flip) };
            let margins = Margins { shoulder, elbow, wrist: Some(bent.margin.lane(lane)) };
            let q = pose::column(q.each_ref().map(|value| value.lane(lane)));
            Slot::Solved(Solution { branch, q, residual: residual.lane(lane), margins, free: Free::NOTHING })
        },
    )
}

/// The row values of an orthogonal wrist, and its bend's distance from straight.
struct Angles<T, const L: usize> {
    noflip: [Lanes<T, L>; 3],
    flip: [Lanes<T, L>; 3],
    margin: Lanes<T, L>,
}

impl<T: Float, const L: usize> Angles<T, L> {
    /// As [`zyz`](crate::ik::wrist), where the third column, so long beside the axis, is not short.
    #[inline(always)]
    fn new(matrix: &[[Lanes<T, L>; 3]; 3], sine: Lanes<T, L>, offsets: &Rows<T>) -> Self {
        let [[m11, m12, m13], [m21, m22, m23], [_, _, m33]] = *matrix;
        let a = Lanes::atan2(m23, m13);
        let b = Lanes::atan2(sine, m33);
        let c = Lanes::atan2(m13 * m21 - m23 * m11, m13 * m22 - m23 * m12);
        let half = math::half_turn::<T>();
        let turn = |angle: T| angle - if angle > T::lit(0.0) { half } else { -half };
        let margin = b.least(Lanes::splat(half) - b);
        let ([oa, ob, oc], [ra, rb, rc]) = (offsets.offset, offsets.reversed);
        let row = |figure, offset, reversed| row_length(figure, Lanes::splat(offset), reversed);
        let [a, b, c, d, e, f] = Lanes::wrap_all([
            row(a, oa, ra),
            row(b, ob, rb),
            row(c, oc, rc),
            row(a.map(turn), oa, ra),
            row(-b, ob, rb),
            row(c.map(turn), oc, rc),
        ]);
        Angles { noflip: [a, b, c], flip: [d, e, f], margin }
    }
}
