//! Branches side by side: the four placements of a base as lanes, their wrists, and forward kinematics of what comes out.
//!
//! A sine is taken once for all that need it: the wrist's matrix and forward kinematics of both bends turn by the same first
//! joints, and the bend itself only changes its sign.

use crate::arm::{Joint, JointKind};
use crate::ik::base::{Placed, Placements};
use crate::ik::sliding;
use crate::ik::target::{Target, accepted};
use crate::ik::wrist::{Rows, row_length};
use crate::math::{self, Float, Lanes, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::solutions::{Bend, Branch, Free, Margins, Posture, Slot, Solution, Solutions, tolerance};
use core::array;

/// A value for each of the four placements.
pub(crate) type Four<T> = Lanes<T, 4>;

/// The turns of a program with their sines and cosines.
struct Turned<T> {
    angles: [Four<T>; 8],
    sines: [Four<T>; 8],
    cosines: [Four<T>; 8],
    count: usize,
}

impl<T: Float> Turned<T> {
    /// No turns.
    fn none() -> Self {
        let zeros = [Lanes::splat(T::lit(0.0)); 8];
        Turned { angles: zeros, sines: zeros, cosines: zeros, count: 0 }
    }

    /// Takes the sines and cosines of the first `count` of these angles, those that are `known` from there.
    #[inline(always)]
    fn take<'a>(
        &mut self,
        angles: [Four<T>; 8],
        count: usize,
        known: impl Fn(usize, &Four<T>) -> Option<Known<'a, T>>,
    ) where
        T: 'a,
    {
        (self.angles, self.count) = (angles, count);
        let places = self.sines.iter_mut().zip(&mut self.cosines);
        for (index, ((sine, cosine), angle)) in places.zip(&angles).enumerate().take(count) {
            match known(index, angle) {
                Some(Known { sine: known, cosine: other, negative: false }) => {
                    (*sine, *cosine) = (*known, *other)
                }
                Some(Known { sine: known, cosine: other, negative: true }) => {
                    (*sine, *cosine) = (-*known, *other)
                }
                None => (*sine, *cosine) = Real::sin_cos(*angle),
            }
        }
    }

    /// Sine and cosine of an angle that is one of these.
    #[inline(always)]
    fn find(&self, angle: &Four<T>) -> Option<Known<'_, T>> {
        let place = self.angles.iter().take(self.count).position(|known| same(known, angle))?;
        Some(Known { sine: self.sines.get(place)?, cosine: self.cosines.get(place)?, negative: false })
    }

    /// Sine and cosine of an angle that is the one with this number, or its opposite.
    #[inline(always)]
    fn alike(&self, index: usize, angle: &Four<T>) -> Option<Known<'_, T>> {
        let known = self.angles.get(index)?;
        let negative = !same(known, angle);
        if negative && !opposite(known, angle) {
            return None;
        }
        Some(Known { sine: self.sines.get(index)?, cosine: self.cosines.get(index)?, negative })
    }
}

/// A sine, or the negative of one, and a cosine.
struct Known<'a, T> {
    sine: &'a Four<T>,
    cosine: &'a Four<T>,
    negative: bool,
}

/// Whether all lanes are equal; where they are not, the first one mostly tells.
fn same<T: Float>(a: &Four<T>, b: &Four<T>) -> bool {
    a.0.iter().zip(&b.0).all(|(a, b)| *a == *b)
}

/// Whether all lanes are opposite.
fn opposite<T: Float>(a: &Four<T>, b: &Four<T>) -> bool {
    a.0.iter().zip(&b.0).all(|(a, b)| *a == -*b)
}

/// The row values of the four placements, joint by joint. Where there is none stands another, so that all lanes are numbers;
/// nothing if there is none at all.
fn rows<T: Float>(placements: &Placements<T>) -> Option<[Four<T>; 3]> {
    let any = placements.iter().flatten().next()?.rows;
    let [a, b, c, d] = placements;
    let rows = |placement: &Result<Placed<T>, _>| placement.as_ref().map_or(any, |placed| placed.rows);
    let ([a1, a2, a3], [b1, b2, b3], [c1, c2, c3], [d1, d2, d3]) = (rows(a), rows(b), rows(c), rows(d));
    Some([Lanes([a1, b1, c1, d1]), Lanes([a2, b2, c2, d2]), Lanes([a3, b3, c3, d3])])
}

/// The matrices that the wrist must produce, by rows, and the turns of the base that they are seen through.
fn wrist_matrices<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    rows: [Four<T>; 3],
    turned: &mut Turned<T>,
) -> [[Four<T>; 3]; 3] {
    turned.take(arm.wrist_turns(rows), A::WRIST_TURNS, |_, _| None);
    arm.wrist_matrix(&arm.wrist_turned(rows, &side_by_side(pose), turned.sines, turned.cosines))
}

/// The same pose in every lane.
fn side_by_side<T: Float>(pose: &Pose<T>) -> Pose<Four<T>> {
    let (rotation, position) = pose::rows(pose);
    pose::from_rows(rotation.map(|row| row.map(Lanes::splat)), position.map(Lanes::splat))
}

/// Joint values of the four placements with one bend, and how far forward kinematics of them misses the pose.
struct Tried<T> {
    /// Joint by joint.
    q: [Four<T>; 6],
    residual: Four<T>,
}

impl<T: Float> Tried<T> {
    /// The joint values that command both sets of row values: without and with the flip.
    fn both<A: SolveWrist<6>>(
        arm: &A,
        target: &Target<T>,
        [noflip, flip]: [&[Four<T>; 6]; 2],
        wrist: &Turned<T>,
    ) -> [Self; 2] {
        let (mut first, mut second) = (Turned::none(), Turned::none());
        let (noflip, flip) =
            (commanded(&A::JOINTS, arm.command(*noflip)), commanded(&A::JOINTS, arm.command(*flip)));
        first.take(arm.fk_turns(&pose::column(noflip)), A::FK_TURNS, |_, angle| wrist.find(angle));
        second.take(arm.fk_turns(&pose::column(flip)), A::FK_TURNS, |index, angle| first.alike(index, angle));
        [
            Tried { residual: missed(arm, target, &noflip, &first), q: noflip },
            Tried { residual: missed(arm, target, &flip, &second), q: flip },
        ]
    }

    /// The joint values of one placement, and their residual.
    fn lane(&self, lane: usize) -> (Joints<T, 6>, T) {
        (pose::column(self.q.each_ref().map(|value| value.lane(lane))), self.residual.lane(lane))
    }
}

/// Commanded values with their angles in (-π, π].
#[inline(always)]
pub(crate) fn commanded<T: Float>(joints: &[Joint; 6], mut q: [Four<T>; 6]) -> [Four<T>; 6] {
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

/// How far forward kinematics of joint values misses the pose.
#[inline(never)]
fn missed<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    q: &[Four<T>; 6],
    turned: &Turned<T>,
) -> Four<T> {
    let reached = arm.fk_turned(&pose::column(*q), turned.sines, turned.cosines);
    target.missed_by_all(&reached)
}

/// All solutions of an arm with an orthogonal wrist, if no figure is near a singular one: so far from it that no two
/// solutions can be one, nothing is free, and nothing is in doubt.
pub(crate) fn regular<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    placements: &Placements<T>,
) -> Option<Solutions<T, 6, Posture>> {
    let offsets = arm.orthogonal_wrist::<T>()?;
    let far = T::lit(64.0) * tolerance::<T>();
    let far_away = far * math::max(target.scale, T::lit(1.0));
    let apart = |placed: &Placed<T>| {
        (placed.shoulder > far_away) & (placed.elbow > far_away) & !placed.shoulder_free & !placed.elbow_free
    };
    if !placements.iter().flatten().all(apart) {
        return None;
    }
    let ([t1, t2, t3], mut wrist) = (rows(placements)?, Turned::none());
    let matrices = wrist_matrices(arm, &target.pose, [t1, t2, t3], &mut wrist);
    let [[_, _, m13], [_, _, m23], _] = &matrices;
    if !(*m13 * *m13 + *m23 * *m23).0.iter().all(|square| *square > far * far) {
        return None;
    }
    let Bends { noflip: [n4, n5, n6], flip: [f4, f5, f6], margin } = Bends::new(&matrices, &offsets);
    if !margin.0.iter().all(|margin| *margin > far) {
        return None;
    }
    let rows = [&[t1, t2, t3, n4, n5, n6], &[t1, t2, t3, f4, f5, f6]];
    let [without, with] = &Tried::both(arm, target, rows, &wrist);
    Some(Solutions::new(sliding(&A::JOINTS), |branch: Posture| {
        let lane = branch.arm().index();
        let placed = match branch.arm().of(placements) {
            Ok(placed) => placed,
            Err(reason) => return Slot::Empty(*reason),
        };
        let (q, residual) = if branch.wrist == Bend::NoFlip { without.lane(lane) } else { with.lane(lane) };
        match accepted(residual) {
            Ok(residual) => {
                let wrist = Some(margin.lane(lane));
                let margins = Margins { shoulder: placed.shoulder, elbow: placed.elbow, wrist };
                Slot::Solved(Solution { branch, q, residual, margins, free: Free::NOTHING })
            }
            Err(reason) => Slot::Empty(reason),
        }
    }))
}

/// The row values of an orthogonal wrist, and its bend's distance from straight.
struct Bends<T> {
    noflip: [Four<T>; 3],
    flip: [Four<T>; 3],
    margin: Four<T>,
}

impl<T: Float> Bends<T> {
    /// As [`zyz`](crate::ik::wrist), where the third column is not short.
    #[inline(never)]
    fn new(matrices: &[[Four<T>; 3]; 3], offsets: &Rows<T>) -> Self {
        let [[m11, m12, m13], [m21, m22, m23], [_, _, m33]] = matrices;
        let zero = T::lit(0.0);
        let (mut rise, mut run) = ([[zero; 4]; 3], [[zero; 4]; 3]);
        let ([rise_a, rise_b, rise_c], [run_a, run_b, run_c]) = (&mut rise, &mut run);
        (*rise_a, *run_a, *run_b) = (m23.0, m13.0, m33.0);
        let sines = array::from_fn(|lane| {
            let (x, y) = (m13.lane(lane), m23.lane(lane));
            math::sqrt(x * x + y * y)
        });
        *rise_b = sines;
        *rise_c = (*m13 * *m21 - *m23 * *m11).0;
        *run_c = (*m13 * *m22 - *m23 * *m12).0;
        let [a, b, c] = angles(rise, run);
        let (half, turn) = (math::half_turn::<T>(), |angle: T| {
            let back = if angle > T::lit(0.0) { math::half_turn::<T>() } else { -math::half_turn::<T>() };
            angle - back
        });
        let margin = Lanes(b.0.map(|b| math::min(b, half - b)));
        let noflip = row_values(offsets, [a, b, c]);
        let flip = row_values(offsets, [Lanes(a.0.map(turn)), -b, Lanes(c.0.map(turn))]);
        Bends { noflip, flip, margin }
    }
}

/// Twelve angles at once.
fn angles<T: Float>(rise: [[T; 4]; 3], run: [[T; 4]; 3]) -> [Four<T>; 3] {
    let flat = |[[a, b, c, d], [e, f, g, h], [i, j, k, l]]: [[T; 4]; 3]| [a, b, c, d, e, f, g, h, i, j, k, l];
    let [a, b, c, d, e, f, g, h, i, j, k, l] = T::atan2_all(flat(rise), flat(run));
    [Lanes([a, b, c, d]), Lanes([e, f, g, h]), Lanes([i, j, k, l])]
}

/// The row values of figure angles, in (-π, π].
fn row_values<T: Float>(offsets: &Rows<T>, [a, b, c]: [Four<T>; 3]) -> [Four<T>; 3] {
    let ([oa, ob, oc], [ra, rb, rc]) = (offsets.offset, offsets.reversed);
    let value = |figure, offset, reversed| row_length(figure, Lanes::splat(offset), reversed).wrap();
    [value(a, oa, ra), value(b, ob, rb), value(c, oc, rc)]
}
