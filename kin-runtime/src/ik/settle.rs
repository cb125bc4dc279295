//! Joint values led onto a pose by small steps, from values that nearly reach it: for a path where figures collapse.
//!
//! Where two singular sets are near each other, the rounding of one figure is magnified by the next: a straight wrist
//! beside a stretched elbow comes out bent by more than round-off, and its outer angles are then those of the rounding.
//! The joint values that a path was at are a better guide there than the figures.
//!
//! Each step is the damped least-squares solution of J·δ = error, K. Levenberg's with the square of the error for the
//! damping (N. Yamashita and M. Fukushima, "On the rate of convergence of the Levenberg-Marquardt method", 2001: fast at
//! singular solutions too), by conjugate gradients, which leave alone what J does not see. Where two sets meet, two of its
//! directions are so short that conjugate gradients no longer tell them from rounding; the steps are then made one joint after
//! another. Turns count in radians and slides in reaches, so that an arm makes the same steps in any unit of length.

use crate::arm::Arm;
use crate::ik::refine::{FARTHEST, parabola};
use crate::ik::target::{Target, accepted};
use crate::ik::{ROUND_OFF, given_out};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::singularity::{directions, in_reaches, normalised, units};
use crate::solutions::tolerance;

/// Steps at most. Where branches touch, each step halves the way.
const STEPS: usize = 40;

/// Steps that may miss as much as the one before them, while that is more than rounding makes: the pose is out of reach.
const VAIN: usize = 12;

/// Steps that a residual is given to come down to round-off, once it is good enough.
const POLISH: usize = 3;

/// Steps that may miss by more than is good enough once one was: beside a double root joint values that nearly reach the pose may
/// be half a millionth from it, and the way there, halved with each step, misses by its square.
const DETOUR: usize = 8;

/// Directions of one step: as many as a Jacobian has rows, and two to make up for rounding.
const DIRECTIONS: usize = 8;

/// Joint values near `q` that reach the pose as exactly as a solution does, and how far they miss it. They keep the
/// turns of `q`.
pub(crate) fn settle<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    pose: &Pose<T>,
    q: &Joints<T, N>,
) -> Option<(Joints<T, N>, T)> {
    let reach = T::lit(arm.reach());
    let (target, units) = (Target::for_reach(pose, reach).ok()?, units(&A::JOINTS, reach));
    let mut q = pose::entries(q);
    let (mut best, mut polish): (Option<(Joints<T, N>, T)>, usize) = (None, POLISH);
    let (mut least, mut vain, mut detour) = (T::lit(f64::INFINITY), 0, DETOUR);
    for _ in 0..STEPS {
        let (at, jacobian) = arm.fk_jacobian(&pose::column(q));
        // What is checked is what would be given out.
        let wrapped = given_out(q, &A::JOINTS);
        if let Ok(residual) = accepted(target.missed_by(&arm.fk(&wrapped))) {
            if best.as_ref().is_none_or(|(_, least)| residual < *least) {
                best = Some((pose::column(q), residual));
            }
            if residual <= T::lit(ROUND_OFF) * T::EPS || polish == 0 {
                break;
            }
            polish -= 1;
        } else if best.is_some() {
            if detour == 0 {
                break;
            }
            detour -= 1;
        }
        let jacobian = in_reaches(&jacobian, &A::JOINTS, reach);
        let error = error(&target.pose, &at, reach);
        let size = product(&error, &error);
        // A step that does not halve what is missed has been lost in rounding.
        let step = if size < least * T::lit(0.25) {
            least_squares(&jacobian.data.0, error, size)
        } else {
            vain += usize::from(size > T::EPS);
            if vain > VAIN {
                break;
            }
            orthogonalised(&jacobian.data.0, error, size)
        };
        least = size;
        walk(&mut q, &step, &units);
    }
    best
}

/// Makes a step, told in radians and reaches.
fn walk<T: Float, const N: usize>(q: &mut [T; N], step: &[T; N], units: &[T; N]) {
    for ((value, by), unit) in q.iter_mut().zip(step).zip(units) {
        *value += *by * *unit;
    }
}

/// Joint values, and how far they miss the target, brought nearer to it as long as a step does so. Of an arm that a pose asks
/// too much of they are the nearest there are, in the least-squares sense.
pub(crate) fn improved<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    target: &Target<T>,
    (mut q, mut residual): (Joints<T, N>, T),
) -> (Joints<T, N>, T) {
    let reach = T::lit(arm.reach());
    let units = units(&A::JOINTS, reach);
    for _ in 0..STEPS {
        if residual <= T::lit(ROUND_OFF) * T::EPS {
            break;
        }
        let (at, jacobian) = arm.fk_jacobian(&q);
        let jacobian = in_reaches(&jacobian, &A::JOINTS, reach);
        let error = error(&target.pose, &at, reach);
        let size = product(&error, &error);
        // Along a direction that is lost, rounding alone asks for a step from which the others do not recover: the heavier damping
        // leaves it out.
        let nearer = [size, math::sqrt(size)].into_iter().find_map(|damping| {
            let mut next = pose::entries(&q);
            walk(&mut next, &least_squares(&jacobian.data.0, error, damping), &units);
            let next = given_out(next, &A::JOINTS);
            let missed = target.missed_by(&arm.fk(&next));
            (missed < residual).then_some((next, missed))
        });
        let Some(nearer) = nearer else { break };
        (q, residual) = nearer;
    }
    (q, residual)
}

/// Joint values farther by so much, in radians and reaches, in the direction that moves the tool least.
pub(crate) fn moved_least<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    by: T,
) -> Joints<T, N> {
    let mut moved = pose::entries(q);
    let reach = T::lit(arm.reach());
    if let Some(least) = directions(&normalised(arm, q)).last() {
        walk(&mut moved, &least.turn.map(|part| part * by), &units(&A::JOINTS, reach));
    }
    pose::column(moved)
}

/// About where the other of two solutions is that were one, seen from one of them: along the direction that moves the tool least,
/// where a parabola through what the pose then misses comes back to what it misses here. None if they still are one, or far apart.
pub(crate) fn other_root<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    pose: &Pose<T>,
    q: &Joints<T, N>,
) -> Option<Joints<T, N>> {
    let (all, reach) = (directions(&normalised(arm, q)), T::lit(arm.reach()));
    let (least, units) = (all.last()?, units(&A::JOINTS, reach));
    let size = math::sqrt(product(&least.column, &least.column));
    let along = |by: T| {
        let mut moved = pose::entries(q);
        walk(&mut moved, &least.turn.map(|part| part * by), &units);
        pose::column(moved)
    };
    let missed = |q: &Joints<T, N>| product(&least.column, &error(pose, &arm.fk(q), reach)) / size;
    let (middle, _) = parabola(missed(q), |by| missed(&along(by)));
    let by = middle + middle;
    (math::abs(by) > tolerance() && math::abs(by) <= T::lit(FARTHEST)).then(|| along(by))
}

/// How the tool must move, as the rows of the Jacobian count: a length in parts of the reach, then a turn.
pub(super) fn error<T: Float>(to: &Pose<T>, from: &Pose<T>, reach: T) -> [T; 6] {
    let ((r, [x, y, z]), (s, [a, b, c])) = (pose::rows(from), pose::rows(to));
    let half = T::lit(0.5);
    let mut turn = [T::lit(0.0); 3];
    for ([u, v, w], [k, l, m]) in pose::transposed(&r).into_iter().zip(pose::transposed(&s)) {
        let [i, j, n] = turn;
        turn = [i + half * (v * m - w * l), j + half * (w * k - u * m), n + half * (u * l - v * k)];
    }
    let [i, j, n] = turn;
    [(a - x) / reach, (b - y) / reach, (c - z) / reach, i, j, n]
}

/// The damped least-squares solution for a matrix given by columns, by conjugate gradients.
fn least_squares<T: Float, const N: usize>(columns: &[[T; 6]; N], error: [T; 6], damping: T) -> [T; N] {
    let zero = T::lit(0.0);
    let (mut x, mut rest) = ([zero; N], error);
    let mut slope = columns.map(|column| product(&column, &rest));
    let mut direction = slope;
    let mut steepness = product(&slope, &slope);
    for _ in 0..DIRECTIONS {
        let mut image = [zero; 6];
        for (column, by) in columns.iter().zip(direction) {
            for (sum, entry) in image.iter_mut().zip(column) {
                *sum += *entry * by;
            }
        }
        let size = product(&image, &image) + damping * product(&direction, &direction);
        if size <= zero || math::is_nan(size) {
            break;
        }
        let along = steepness / size;
        add(&mut x, &direction, along);
        add(&mut rest, &image, -along);
        slope = columns.map(|column| product(&column, &rest));
        add(&mut slope, &x, -damping);
        let now = product(&slope, &slope);
        let turn = now / steepness;
        if math::is_nan(turn) {
            break;
        }
        for (old, new) in direction.iter_mut().zip(slope) {
            *old = new + turn * *old;
        }
        steepness = now;
    }
    x
}

/// The same where two directions of the joints all but vanish: one joint after another, the one that still moves the tool most first,
/// each with those before it turning so that none undoes what another has done. Their motions are made orthogonal by modified
/// Gram-Schmidt, which is backward stable (Å. Björck, "Solving linear least squares problems by Gram-Schmidt orthogonalization",
/// 1967).
fn orthogonalised<T: Float, const N: usize>(columns: &[[T; 6]; N], error: [T; 6], damping: T) -> [T; N] {
    let (mut x, mut rest) = ([T::lit(0.0); N], error);
    let mut joints = columns.map(|column| (column, x));
    for (joint, (_, turn)) in joints.iter_mut().enumerate() {
        turn.iter_mut().skip(joint).take(1).for_each(|by| *by = T::lit(1.0));
    }
    let sized = |(moved, turn): &([T; 6], [T; N])| product(moved, moved) + damping * product(turn, turn);
    let mut left = joints.as_mut_slice();
    while let [most, others @ ..] = left {
        for other in &mut *others {
            if sized(other) > sized(most) {
                core::mem::swap(most, other);
            }
        }
        let (size, (moved, turn)) = (sized(most), most);
        if size > T::lit(0.0) {
            for (other_moved, other_turn) in &mut *others {
                let share = (product(moved, other_moved) + damping * product(turn, other_turn)) / size;
                add(other_moved, moved, -share);
                add(other_turn, turn, -share);
            }
            let by = (product(moved, &rest) - damping * product(turn, &x)) / size;
            add(&mut x, turn, by);
            add(&mut rest, moved, -by);
        }
        left = others;
    }
    x
}

pub(super) fn product<T: Float, const M: usize>(a: &[T; M], b: &[T; M]) -> T {
    a.iter().zip(b).fold(T::lit(0.0), |sum, (x, y)| sum + *x * *y)
}

pub(super) fn add<T: Float, const M: usize>(to: &mut [T; M], what: &[T; M], times: T) {
    for (x, y) in to.iter_mut().zip(what) {
        *x += times * *y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{PUMA_560, Random};

    #[test]
    fn joints_settle_on_regular_and_singular_poses_and_stay_near() {
        let mut random = Random(31);
        for round in 0..500 {
            let mut q = [(); 6].map(|()| random.angle());
            if round % 2 == 0 {
                q[4] = 0.0;
            }
            let pose = PUMA_560.fk(&pose::column(q));
            let near = pose::column(q.map(|x| x + random.within(-1e-3, 1e-3)));
            let (found, residual) = settle(&PUMA_560, &pose, &near).unwrap();
            assert!(residual <= 64.0 * f64::EPSILON && (found - near).amax() < 0.3, "{q:?} {found}");
        }
    }

    #[test]
    fn what_cannot_be_reached_is_not_settled_on() {
        let q = pose::column([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
        let (r, _) = pose::rows(&PUMA_560.fk(&q));
        assert!(settle(&PUMA_560, &pose::from_rows(r, [5.0, 0.0, 0.0]), &q).is_none());
        let nowhere = pose::column([f64::NAN; 6]);
        assert!(settle(&PUMA_560, &PUMA_560.fk(&q), &nowhere).is_none());
    }
}
