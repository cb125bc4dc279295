//! Two to five joints: the first two or three carry a point of the tool, the others, none to two, turn the tool about it.
//!
//! A pose asks for more than such an arm can do. The point is put in its place in closed form, the turns are read from what
//! rotation remains, small steps in all joints take back what round-off has made of either, and forward kinematics decides: where the
//! pose is none of the arm's, the reason says whether the point is off the surface that the arm reaches, or by which angle the tool
//! cannot be turned as the pose asks.
//!
//! Where the point lies on the axes of joints that carry it, so that its place leaves them free, the orientation tells their values:
//! `freed`.

use crate::ik::attempt::Attempt;
use crate::ik::base::Placed;
use crate::ik::general::{SLACK, length, less};
use crate::ik::settle::{improved, moved_least, other_root, settle};
use crate::ik::target::{Target, distance};
use crate::ik::{ACCEPTED, Carrier, SETTLED, finite, given_out, sliding};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::private::{Carried, SolveShort};
use crate::solutions::{
    ArmPosture, Boundary, Elbow, Free, Margins, Near, Reason, Shoulder, Slot, Solution, Solutions, tolerance,
};

/// How far joint values that were read from figures may miss the pose and still be led onto it, as the largest entry of a
/// rotation or of a position over the reach. Beside an axis the direction to the point is its own round-off over its distance: just
/// outside the window in which that joint counts as free an eighth of a radian.
const ASTRAY: f64 = 0.25;

/// Between two solutions that were one the joints are about so many times the root of what they miss from either, or less.
const ASIDE: f64 = 32.0;

/// The joints that turn the tool about the carried point, and how their angles are read from a rotation m.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Turns<T> {
    /// None: m is 1.
    None,
    /// One: m = Rz(a).
    One {
        /// What is added to the row value to give a.
        offset: T,
    },
    /// Two whose axes meet: m = Rz(a)·K·Rz(b).
    Two {
        /// K, by rows.
        between: [[T; 3]; 3],
        /// What is added to the row values to give a and b.
        offset: [T; 2],
    },
}

impl<T: Float> Turns<T> {
    /// The row values, those that are not there left out at the end.
    fn values(&self, m: &[[T; 3]; 3]) -> [T; 2] {
        let [[m11, m12, m13], [m21, m22, m23], [m31, m32, _]] = *m;
        let zero = T::lit(0.0);
        match self {
            Turns::None => [zero; 2],
            Turns::One { offset } => [math::wrap(math::atan2(m21 - m12, m11 + m22) - *offset), zero],
            Turns::Two { between, offset: [a, b] } => {
                let [[_, _, k13], [_, _, k23], [k31, k32, _]] = *between;
                let first = math::atan2(m23, m13) - math::atan2(k23, k13);
                let second = math::atan2(k32, k31) - math::atan2(m32, m31);
                [math::wrap(first - *a), math::wrap(second - *b)]
            }
        }
    }

    /// Nothing where the axes fit. For none or one this is the most there can be.
    pub(super) fn gap(&self, m: &[[T; 3]; 3]) -> T {
        let [[m11, _, _], [_, m22, _], [_, _, m33]] = *m;
        match self {
            Turns::None => m11 + m22 + m33 - T::lit(3.0),
            Turns::One { .. } => m33 - T::lit(1.0),
            Turns::Two { between: [_, _, [_, _, k33]], .. } => m33 - *k33,
        }
    }
}

/// All solutions; a free joint takes the value 0.
pub fn solve<T: Float, const N: usize, A: SolveShort<N>, B: Carried>(
    arm: &A,
    pose: &Pose<T>,
) -> Solutions<T, N, B> {
    solve_choosing(arm, pose, [None; N])
}

/// All solutions; a free joint keeps its value in `hold`, or takes 0 if that is not finite.
pub fn solve_holding<T: Float, const N: usize, A: SolveShort<N>, B: Carried>(
    arm: &A,
    pose: &Pose<T>,
    hold: &Joints<T, N>,
) -> Solutions<T, N, B> {
    solve_choosing(arm, pose, finite(arm.rows(pose::entries(hold))))
}

fn solve_choosing<T: Float, const N: usize, A: SolveShort<N>, B: Carried>(
    arm: &A,
    pose: &Pose<T>,
    hold: [Option<T>; N],
) -> Solutions<T, N, B> {
    let (sliding, carrier) = (sliding(&A::JOINTS), arm.carrier::<T>());
    let checked = match carrier.is_finite() {
        true => Target::for_reach(pose, carrier.reach()),
        false => Err(Reason::NotAnArm),
    };
    let target = match checked {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let mut held = [None; 2];
    for (value, joint) in held.iter_mut().zip(A::ORDER) {
        *value = hold.get(joint).copied().flatten();
    }
    let placements = carrier.place(arm.carried_point(&target.pose), target.scale, held);
    let [first, _] = held;
    let task = Task { arm, carrier, target, turns: arm.turns(), held: first.is_some() };
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    let mut others = [[None; 3]; 4];
    for (branch, others) in B::ALL.iter().zip(&mut others) {
        let slot = match branch.base().pick(placements.each_ref()) {
            Err(reason) => Slot::Empty(*reason),
            Ok(placed) => task.completed(*branch, placed, others),
        };
        solutions.put(*branch, slot);
    }
    solutions.merge(task.carrier.reach());
    let near = Near::of(T::lit(SLACK) * math::sqrt(T::EPS), task.carrier.reach());
    for other in others.into_iter().flatten().flatten() {
        _ = solutions.add(other, near);
    }
    solutions
}

/// What is asked of an arm.
pub(super) struct Task<'a, T: Float, A> {
    arm: &'a A,
    carrier: Carrier<T>,
    target: Target<T>,
    pub(super) turns: Turns<T>,
    /// Whether joint 1 keeps a value if it is free.
    pub(super) held: bool,
}

impl<T: Float, A> Task<'_, T, A> {
    /// A placement of the point with the turns that the pose asks for, if together they reach it. Beside an axis it may lead to
    /// more than one solution: `others`.
    fn completed<const N: usize, B: Carried>(
        &self,
        branch: B,
        placed: &Placed<T>,
        others: &mut [Option<Solution<T, N, B>>; 3],
    ) -> Slot<T, N, B>
    where
        A: SolveShort<N>,
    {
        let (posture, rows) = (branch.base(), placed.rows);
        let free = [placed.shoulder_free, placed.elbow_free];
        let (base, left) = self.oriented(posture, rows, free);
        let mut own = self.attempt(base, left);
        if !own.reaches() && self.carrier.leaves_last() {
            own = self.attempt(self.ended(posture, rows, free), Free::NOTHING);
        }
        let (best, rest) = match self.carrier.beside(placed, self.target.scale) {
            // Where both shoulders are one, each is known to the root of round-off: their solutions need not be one.
            [false, false] if own.reaches() && placed.shoulder == T::lit(0.0) => {
                let other = self.across(&own).filter(Attempt::reaches);
                (own, [other, None, None])
            }
            [false, false] => (own, [None; 3]),
            _ if own.reaches() && own.free != Free::NOTHING => (own, [None; 3]),
            beside => self.beside(posture, rows, beside, own),
        };
        let margins = Margins { shoulder: placed.shoulder, elbow: placed.elbow, wrist: None };
        let solution = |attempt: &Attempt<T, N>| {
            let Attempt { q, missed: residual, free, .. } = *attempt;
            Solution { branch, q, residual, margins, free }
        };
        if best.reaches() {
            *others = rest.map(|attempt| attempt.as_ref().map(solution));
            return Slot::Solved(solution(&best));
        }
        let Attempt { missed, read, .. } = best;
        // What the pose asks too much of is told of the figures: a compromise would blame a little of everything.
        Slot::Empty(if math::is_finite(missed) {
            self.reason(&self.arm.fk(&read), missed)
        } else {
            Reason::NotAnArm
        })
    }

    /// Beside an axis the rounding of the figures has left little of that joint: it is as good as free, and asked of the
    /// orientation. If that does not tell it either, small steps begin on either side of the axis, then between them. What the
    /// figures lead to may be another solution than what the orientation tells, and that may be one of two.
    fn beside<const N: usize>(
        &self,
        posture: ArmPosture,
        rows: [T; 3],
        [first, second]: [bool; 2],
        own: Attempt<T, N>,
    ) -> (Attempt<T, N>, [Option<Attempt<T, N>>; 3])
    where
        A: SolveShort<N>,
    {
        for free in [[first, second], [false, second], [first, false]] {
            let (base, left) = self.oriented(posture, rows, free);
            if free != [false; 2] && left == Free::NOTHING {
                let told = self.attempt(base, left);
                if told.reaches() {
                    // What steps have led farther, or just near enough to be accepted, may have missed what the figures lead to.
                    let rough =
                        told.moved(self.arm) > own.moved(self.arm) || told.missed > T::lit(4.0) * own.missed;
                    let (best, other) = if own.reaches() && rough { (own, told) } else { (told, own) };
                    let others = [Some(other), self.mirrored(&told), self.across(&told)];
                    return (best, others.map(|other| other.filter(Attempt::reaches)));
                }
            }
        }
        let opposite = [first && posture.shoulder == Shoulder::Left, second && posture.elbow == Elbow::Down];
        if own.reaches() && (!own.strayed || opposite == [false; 2]) {
            return (own, [None; 3]);
        }
        let ([t1, t2, t3], [opposite1, opposite2]) = (rows, opposite);
        let half = math::half_turn::<T>();
        for quarter in [T::lit(0.0), half * T::lit(0.5)] {
            let turned = |t: T, beside, opposite| {
                let side = if opposite { half + quarter } else { quarter };
                if beside { math::wrap(t + side) } else { t }
            };
            let aside = self
                .attempt([turned(t1, first, opposite1), turned(t2, second, opposite2), t3], Free::NOTHING);
            if aside.reaches() {
                return (aside, [None; 3]);
            }
        }
        (own, [None; 3])
    }

    /// From where the orientation is met best two solutions are as far on either side: the other one, if small steps have led
    /// to either.
    fn mirrored<const N: usize>(&self, told: &Attempt<T, N>) -> Option<Attempt<T, N>>
    where
        A: SolveShort<N>,
    {
        let start = pose::entries(&(told.read - told.way::<A>()));
        let moved = told.moved(self.arm);
        let apart = moved > tolerance::<T>() && moved <= T::lit(ASTRAY);
        apart.then(|| self.led(given_out(start, &A::JOINTS), told.free))
    }

    /// The place of the point may tell two solutions that are near each other no better than one: then the other one.
    fn across<const N: usize>(&self, told: &Attempt<T, N>) -> Option<Attempt<T, N>>
    where
        A: SolveShort<N>,
    {
        let start = other_root(self.arm, &self.target.pose, &told.q)?;
        Some(self.led(given_out(pose::entries(&start), &A::JOINTS), told.free))
    }

    /// The turns that the pose asks for once the point is in its place, and all joints settled on it together if they are near:
    /// beside an axis the place of the point says little of that joint, the orientation more.
    fn attempt<const N: usize>(&self, base: [T; 3], free: Free<N>) -> Attempt<T, N>
    where
        A: SolveShort<N>,
    {
        self.led(self.joints(base), free)
    }

    /// Joint values settled on the pose, if they are near.
    fn led<const N: usize>(&self, read: Joints<T, N>, free: Free<N>) -> Attempt<T, N>
    where
        A: SolveShort<N>,
    {
        let missed = self.target.missed_by(&self.arm.fk(&read));
        let mut found = (read, missed);
        if missed <= T::lit(ASTRAY) {
            found = improved(self.arm, &self.target, found);
        }
        let (q, missed) = found;
        let near = T::lit(SLACK) * math::sqrt(T::EPS);
        if !self.is_settled(missed) && missed <= near {
            // Steps that all come nearer end where two directions are lost together; those that need not do so end on the pose. Exactly
            // between two solutions no step tells where either is: then from one side.
            for by in [T::lit(0.0), T::lit(ASIDE) * math::sqrt(missed)] {
                let start = if by > T::lit(0.0) { moved_least(self.arm, &q, by) } else { q };
                if let Some((q, settled)) = settle(self.arm, &self.target.pose, &start)
                    && settled < missed
                    && (self.is_settled(settled) || by > T::lit(0.0))
                {
                    let (q, reached) = (given_out(pose::entries(&q), &A::JOINTS), self.is_settled(settled));
                    let free = Free::NOTHING;
                    return Attempt { q, missed: settled, reached, free, read, strayed: true };
                }
            }
        }
        Attempt { q, missed, reached: self.is_settled(missed), free, read, strayed: false }
    }

    /// Whether a residual is what a solution may miss: in units of the reach; where a slide leads farther out than twice that, of half the
    /// pose's own distance.
    fn is_settled<const N: usize>(&self, missed: T) -> bool
    where
        A: SolveShort<N>,
    {
        let (scale, reach) = (self.target.scale, T::lit(self.arm.reach()));
        missed * scale <= T::lit(SETTLED) * T::EPS * math::max(reach, scale * T::lit(0.5))
    }

    /// All joint values, from the row values of those that carry the point.
    pub(super) fn joints<const N: usize>(&self, base: [T; 3]) -> Joints<T, N>
    where
        A: SolveShort<N>,
    {
        let [first, second] = self.turns.values(&self.rest(base));
        let mut rows = self.rows(base);
        for (value, joint) in [first, second].into_iter().zip(A::ORDER.into_iter().skip(A::CARRIERS)) {
            if let Some(row) = rows.get_mut(joint) {
                *row = value;
            }
        }
        given_out(self.arm.command(rows), &A::JOINTS)
    }

    /// Row values of the joints that carry the point, the others nothing.
    fn rows<const N: usize>(&self, base: [T; 3]) -> [T; N]
    where
        A: SolveShort<N>,
    {
        let mut rows = [T::lit(0.0); N];
        for (value, joint) in base.into_iter().zip(A::ORDER.into_iter().take(A::CARRIERS)) {
            if let Some(row) = rows.get_mut(joint) {
                *row = value;
            }
        }
        rows
    }

    /// The rotation that the turns must produce.
    pub(super) fn rest<const N: usize>(&self, base: [T; 3]) -> [[T; 3]; 3]
    where
        A: SolveShort<N>,
    {
        pose::matrix_rows(&self.arm.rest(self.rows(base), &self.target.pose))
    }

    /// Why the nearest that the arm does is not the pose.
    fn reason(&self, reached: &Pose<T>, residual: T) -> Reason<T> {
        let ((r, p), (wanted, to)) = (pose::rows(reached), pose::rows(&self.target.pose));
        let off = distance(&p, &to);
        if off > T::lit(ACCEPTED) * T::EPS * self.target.scale {
            let by = length(less(p, to));
            return Reason::OutOfReach { by, towards: Boundary::Surface, theta1: None };
        }
        let by = pose::angle_between(&r, &wanted);
        if by > T::lit(0.0) { Reason::Orientation { by } } else { Reason::Inaccurate { residual } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Random, about_x, about_z};

    /// The turns that a rotation is made of are read from it, and there the axes fit; for none or one they fit nowhere better.
    #[test]
    fn turns_are_read_from_what_they_make_and_fit_there() {
        let mut random = Random(91);
        for _ in 0..1_000 {
            let (a, b, tilt, anywhere) = (random.angle(), random.angle(), random.angle(), random.rotation());
            let offset = [random.sometimes(-1.0, 1.0), random.sometimes(-1.0, 1.0)];
            let [o1, o2] = offset;
            let between = pose::product(&about_z(0.3), &pose::product(&about_x(tilt), &about_z(-1.1)));
            let two = pose::product(&about_z(a + o1), &pose::product(&between, &about_z(b + o2)));
            for (turns, made, [first, second]) in [
                (Turns::None, about_z(0.0), [0.0; 2]),
                (Turns::One { offset: o1 }, about_z(a + o1), [a, 0.0]),
                (Turns::Two { between, offset }, two, [a, b]),
            ] {
                assert!(turns.gap(&made).abs() <= 8.0 * f64::EPSILON, "{turns:?}");
                let [x, y] = turns.values(&made);
                let off = math::abs(math::wrap(x - first)).max(math::abs(math::wrap(y - second)));
                // Two axes that nearly coincide say little of either angle.
                assert!(
                    off * math::abs(math::sin_cos(tilt).0) <= 1e-14,
                    "{turns:?}: {x} {y} for {first} {second}"
                );
                let straying = -turns.gap(&anywhere);
                assert!(straying >= 0.0 || matches!(turns, Turns::Two { .. }), "{turns:?}");
            }
            // Without turns every angle is as far from none as any other turn by it: 4·sin²(a/2).
            let apart = pose::product(&anywhere, &pose::product(&about_z(a), &pose::transposed(&anywhere)));
            let (sine, _) = math::sin_cos(0.5 * a);
            assert!((Turns::None.gap(&apart) + 4.0 * sine * sine).abs() <= 1e-14, "{a}");
        }
    }
}
