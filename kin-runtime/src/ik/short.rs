//! Two to five joints: the first two or three carry a point of the tool, the others, none to two, turn the tool about it.
//!
//! A pose asks for more than such an arm can do. The point is put in its place in closed form, the turns are read from what
//! rotation remains, small steps in all joints take back what round-off has made of either, and forward kinematics decides: where the pose is none of the arm's, the reason says whether the point is
//! off the surface that the arm reaches, or by which angle the tool cannot be turned as the pose asks.
//!
//! Where the point lies on the axis of a joint that carries it, so that its place leaves that joint free, the orientation
//! tells its value. How well the axes of the turns fit the pose is then A + B·cos θ + C·sin θ: it is asked for three values.

use crate::ik::base::Placed;
use crate::ik::settle::improved;
use crate::ik::target::{Target, accepted, distance};
use crate::ik::{ACCEPTED, FAMILY, finite, given_out, sliding};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::private::{Carried, SolveShort};
use crate::solutions::{
    ArmPosture, Boundary, Elbow, Free, JointSet, Loose, Margins, Reason, Shoulder, Slot, Solution, Solutions,
};

/// How far joint values that were read from figures may miss the pose and still be led onto it, as the largest entry of a
/// rotation or of a position over the reach. Beside an axis the direction to the point is its own round-off over its distance: just
/// outside the window in which that joint counts as free an eighth of a radian.
const ASTRAY: f64 = 0.25;

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
    fn gap(&self, m: &[[T; 3]; 3]) -> T {
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
    let task = Task { arm, target, turns: arm.turns() };
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for branch in B::ALL {
        let slot = match branch.base().pick(placements.each_ref()) {
            Err(reason) => Slot::Empty(*reason),
            Ok(placed) => task.completed(*branch, placed),
        };
        solutions.put(*branch, slot);
    }
    solutions.merge(carrier.reach());
    solutions
}

/// What is asked of an arm.
struct Task<'a, T: Float, A> {
    arm: &'a A,
    target: Target<T>,
    turns: Turns<T>,
}

impl<T: Float, A> Task<'_, T, A> {
    /// A placement of the point with the turns that the pose asks for, if together they reach it.
    fn completed<const N: usize, B: Carried>(&self, branch: B, placed: &Placed<T>) -> Slot<T, N, B>
    where
        A: SolveShort<N>,
    {
        let (base, free) = self.oriented(branch.base(), placed);
        let read = self.joints(base);
        let reached = self.arm.fk(&read);
        let mut found = (read, self.target.missed_by(&reached));
        if found.1 <= T::lit(ASTRAY) {
            // Near an axis the place of the point says little of that joint, the orientation more: together they are settled.
            found = improved(self.arm, &self.target, found);
        }
        let (q, missed) = found;
        let margins = Margins { shoulder: placed.shoulder, elbow: placed.elbow, wrist: None };
        match accepted(missed) {
            Ok(residual) => Slot::Solved(Solution { branch, q, residual, margins, free }),
            // What the pose asks too much of is told of the figures: a compromise would blame a little of everything.
            Err(Reason::Inaccurate { residual }) => Slot::Empty(self.reason(&reached, residual)),
            Err(reason) => Slot::Empty(reason),
        }
    }

    /// All joint values, from the row values of those that carry the point.
    fn joints<const N: usize>(&self, base: [T; 3]) -> Joints<T, N>
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
    fn rest<const N: usize>(&self, base: [T; 3]) -> [[T; 3]; 3]
    where
        A: SolveShort<N>,
    {
        pose::matrix_rows(&self.arm.rest(self.rows(base), &self.target.pose))
    }

    /// The placement with the value of a free joint that the orientation asks for; what it leaves free all the same.
    fn oriented<const N: usize>(&self, posture: ArmPosture, placed: &Placed<T>) -> ([T; 3], Free<N>)
    where
        A: SolveShort<N>,
    {
        let nothing = Free { shoulder: None, elbow: None, wrist: None };
        let (index, far) = match (placed.shoulder_free, placed.elbow_free) {
            (true, _) if A::CARRIERS == 3 => (0, posture.shoulder == Shoulder::Left),
            (true, _) => (0, posture.elbow == Elbow::Down),
            (false, true) => (1, posture.elbow == Elbow::Down),
            (false, false) => return (placed.rows, nothing),
        };
        let with = |value: T| {
            let mut base = placed.rows;
            if let Some(row) = base.get_mut(index) {
                *row = value;
            }
            base
        };
        let quarter = math::half_turn::<T>() * T::lit(0.5);
        let [at_0, at_90, at_180] =
            [T::lit(0.0), quarter, quarter + quarter].map(|t| self.turns.gap(&self.rest(with(t))));
        let half = T::lit(0.5);
        let (mean, cosine) = ((at_0 + at_180) * half, (at_0 - at_180) * half);
        let (sine, amplitude) = (at_90 - mean, math::hypot(cosine, at_90 - mean));
        if amplitude <= T::lit(FAMILY) * T::EPS {
            return (placed.rows, self.family(index, placed.rows, with));
        }
        let middle = math::atan2(sine, cosine);
        // With none or one the axes fit where they fit best; with two on either side of that.
        let swing = match self.turns {
            Turns::Two { .. } => {
                let across = math::sqrt_or_zero((amplitude - mean) * (amplitude + mean));
                math::atan2(across, -mean)
            }
            Turns::None | Turns::One { .. } => T::lit(0.0),
        };
        (with(math::wrap(if far { middle - swing } else { middle + swing })), nothing)
    }

    /// A joint that the orientation leaves free too, and the joints that follow it.
    fn family<const N: usize>(&self, index: usize, here: [T; 3], with: impl Fn(T) -> [T; 3]) -> Free<N>
    where
        A: SolveShort<N>,
    {
        let joint = A::ORDER.get(index).copied().unwrap_or(0);
        let mut moving = JointSet::EMPTY.with(joint);
        let now = here.get(index).copied().unwrap_or(T::lit(0.0));
        let (here, there) = (self.joints::<N>(here), self.joints::<N>(with(now + T::lit(0.5))));
        for (other, (a, b)) in pose::entries(&here).into_iter().zip(pose::entries(&there)).enumerate() {
            if math::abs(math::wrap(a - b)) > T::lit(64.0) * math::sqrt(T::EPS) {
                moving = moving.with(other);
            }
        }
        let loose = Some(Loose::Follow { joint: joint as u8, moving });
        let (shoulder, elbow) = if index == 0 { (loose, None) } else { (None, loose) };
        Free { shoulder, elbow, wrist: None }
    }

    /// Why the nearest that the arm does is not the pose.
    fn reason(&self, reached: &Pose<T>, residual: T) -> Reason<T> {
        let ((r, p), (wanted, to)) = (pose::rows(reached), pose::rows(&self.target.pose));
        let off = distance(&p, &to);
        if off > T::lit(ACCEPTED) * T::EPS * self.target.scale {
            return Reason::OutOfReach { by: off, towards: Boundary::Surface, theta1: None };
        }
        let apart = r.iter().flatten().zip(wanted.iter().flatten());
        let square = apart.fold(T::lit(0.0), |sum, (a, b)| sum + (*a - *b) * (*a - *b));
        // The Frobenius norm of the difference of two rotations is √8 times the sine of half the angle between them.
        let sine = math::min(math::sqrt(square * T::lit(0.125)), T::lit(1.0));
        let cosine = math::sqrt_or_zero((T::lit(1.0) - sine) * (T::lit(1.0) + sine));
        let by = T::lit(2.0) * math::atan2(sine, cosine);
        if by > T::lit(0.0) { Reason::Orientation { by } } else { Reason::Inaccurate { residual } }
    }
}
