//! Whether a pose can tell two joint vectors apart at all: not if a way leads from one to the other on which it is reached.
//!
//! The way is found by halving. The middle of its ends is brought back onto the pose by damped least-squares steps, and each half is
//! halved in its turn, until all pieces are short and their middles lie where they would if the piece were straight, but for a tenth of
//! its length. Where that fails each end is first moved towards the other along the directions that the arm has lost there, as far as the
//! pose allows. Where a way turns too sharply for its middle to be near the middle of its ends, as beside the pole of a sphere, it is
//! traced from one end, step by step, the shorter the more it bends. Where what is lost is lost to the pose's rounding alone, so that
//! nothing draws back a way that strays, one joint is turned on and the others follow.
//! At each point of the way forward kinematics meets the pose within what a solution may miss, so that each is as good a solution as
//! either end, and a solver that is given the rounded pose, and nothing else, has no means of preferring one. There are more points than
//! any arm of six joints has isolated solutions. How they are found does not matter to that; a way that is not found is held against
//! the solver.

use std::f64::consts::{PI, TAU};

use kin_runtime::prelude::*;
use kin_runtime::{Joint, JointKind, singularity};
use nalgebra::{Matrix6, SMatrix, SVD, Vector6};

/// A piece of a way is at most this part of the distance of its ends: with them there are more points than the 16 isolated solutions
/// that six joints can have …
const SHORT: f64 = 1.0 / 16.0;

/// … and its middle at most this part of its length from where it would be if the piece were straight.
const BENT: f64 = 0.1;

/// Steps that bring a point back at most …
const STEPS: usize = 60;

/// … and those of a whole way.
const TRIED: usize = 1500;

/// The points of a traced way are brought back by at most this part of a step …
const STRAIGHT: f64 = 1e-3;

/// … in so many steps in all.
const TRACED: usize = 20_000;

/// One joint leads the others in so many steps at most …
const LED: usize = 2_000;

/// … each of which they follow in so many.
const HELD: usize = 4;

/// A direction with a smaller singular value is lost.
const LOST: f64 = 1e-5;

/// A singular value whose square is less than this counts for nothing in a [quick](Manner::Quick) step.
const DULL: f64 = 1e-14;

/// How points are brought back. A way that is not found in one manner may be in another.
#[derive(Clone, Copy)]
enum Manner {
    /// By least squares, damped by the square of what is missed: such steps close in quadratically on solutions that are not isolated
    /// (Yamashita and Fukushima 2001). Nearly all ways that there are are found so, and without the singular values.
    Quick,
    /// By the shortest step that leaves the part `left` of what is missed, where moves of the first and of the second half of the joints
    /// count as so much shorter than they are, and from ends that have moved towards each other.
    Shortest { left: f64, ease: [f64; 2] },
}

/// All of them, the quickest first.
const MANNERS: [Manner; 8] = [
    Manner::Quick,
    Manner::Shortest { left: 0.1, ease: [1.0, 1.0] },
    Manner::Shortest { left: 0.01, ease: [1.0, 1.0] },
    Manner::Shortest { left: 0.5, ease: [1.0, 1.0] },
    Manner::Shortest { left: 1e-4, ease: [1.0, 1.0] },
    Manner::Shortest { left: 0.1, ease: [0.01, 1.0] },
    Manner::Shortest { left: 0.1, ease: [1.0, 0.01] },
    Manner::Shortest { left: 0.01, ease: [1e-4, 1.0] },
];

/// An arm in doubles, whoever it is: turns in radians, slides in reaches.
pub trait Moving<const N: usize> {
    /// Its joints.
    fn joints(&self) -> [Joint; N];
    /// Its reach.
    fn length(&self) -> f64;
    /// Whether orientations count.
    fn turns(&self) -> bool;
    /// The pose and the Jacobian.
    fn at(&self, q: &Joints<f64, N>) -> (Pose<f64>, Jacobian<f64, N>);
    /// The pose alone.
    fn reached(&self, q: &Joints<f64, N>) -> Pose<f64>;
}

fn slides(joint: &Joint) -> bool {
    joint.kind == JointKind::Prismatic
}

/// From one joint vector to another, angles the short way round.
pub fn between<const N: usize>(
    arm: &dyn Moving<N>,
    from: &Joints<f64, N>,
    to: &Joints<f64, N>,
) -> Joints<f64, N> {
    let joints = arm.joints();
    Joints::from_fn(|joint, _| {
        let way = to[joint] - from[joint];
        if slides(&joints[joint]) {
            return way / arm.length();
        }
        let turned = way + PI;
        // A remainder is dear, and nearly always the number itself.
        (if (0.0..TAU).contains(&turned) { turned } else { turned.rem_euclid(TAU) }) - PI
    })
}

fn moved<const N: usize>(arm: &dyn Moving<N>, from: &Joints<f64, N>, by: &Joints<f64, N>) -> Joints<f64, N> {
    let joints = arm.joints();
    Joints::from_fn(|joint, _| {
        from[joint] + by[joint] * if slides(&joints[joint]) { arm.length() } else { 1.0 }
    })
}

/// The Jacobian of what is asked for, in radians and reaches.
pub fn jacobian<const N: usize>(arm: &dyn Moving<N>, jacobian: &Jacobian<f64, N>) -> Jacobian<f64, N> {
    let mut jacobian = singularity::scaled(jacobian, arm.length());
    for (column, joint) in arm.joints().iter().enumerate() {
        if slides(joint) {
            jacobian.column_mut(column).scale_mut(arm.length());
        }
    }
    if !arm.turns() {
        jacobian.fixed_rows_mut::<3>(3).fill(0.0);
    }
    jacobian
}

/// How the tool must move to the target, as the rows of the Jacobian count, and by how much it misses it: the largest entry of the
/// position, over the reach, or of the rotation.
fn missing<const N: usize>(arm: &dyn Moving<N>, here: &Pose<f64>, target: &Pose<f64>) -> (Vector6<f64>, f64) {
    let shift = (target.translation.vector - here.translation.vector) / arm.length();
    if !arm.turns() {
        return (Vector6::new(shift.x, shift.y, shift.z, 0.0, 0.0, 0.0), shift.amax());
    }
    let (wanted, found) = (target.rotation.matrix(), here.rotation.matrix());
    let turn = wanted * found.transpose();
    let turn = (turn - turn.transpose()) * 0.5;
    let step = Vector6::new(shift.x, shift.y, shift.z, turn[(2, 1)], turn[(0, 2)], turn[(1, 0)]);
    (step, shift.amax().max((wanted - found).amax()))
}

/// Whether the pose is reached within `window` all along some way to one of the ends. Most ends that are led to are found in the first
/// manner, so that all of them are tried in one manner before any is in the next.
pub fn leads<const N: usize>(
    arm: &dyn Moving<N>,
    target: &Pose<f64>,
    from: &Joints<f64, N>,
    ends: &[Joints<f64, N>],
    window: f64,
) -> bool {
    let search = |manner| Search { arm, target, window, manner };
    ends.iter().any(|to| search(Manner::Quick).straight(from, &between(arm, from, to)))
        || MANNERS.into_iter().any(|manner| ends.iter().any(|to| search(manner).halved(*from, *to)))
        || ends.iter().any(|to| search(Manner::Quick).traced(from, to))
        || ends.iter().any(|to| search(Manner::Quick).led_by_one(from, to))
}

/// What ways are looked for.
struct Search<'a, const N: usize> {
    arm: &'a dyn Moving<N>,
    target: &'a Pose<f64>,
    window: f64,
    manner: Manner,
}

impl<const N: usize> Search<'_, N> {
    /// Whether the pose is reached at eight points of a straight piece.
    fn straight(&self, from: &Joints<f64, N>, by: &Joints<f64, N>) -> bool {
        (1..=8).all(|point| self.reaches(&moved(self.arm, from, &(by * (f64::from(point) / 8.0)))))
    }

    /// Whether halving finds a way.
    fn halved(&self, from: Joints<f64, N>, to: Joints<f64, N>) -> bool {
        let arm = self.arm;
        let short = between(arm, &from, &to).amax() * SHORT;
        let (mut pieces, mut tried) = (vec![(from, to)], 0);
        while let Some((from, to)) = pieces.pop() {
            let (from, to) = match self.manner {
                Manner::Quick => (from, to),
                Manner::Shortest { .. } => {
                    let from = self.slid(from, &to);
                    (from, self.slid(to, &from))
                }
            };
            let whole = between(arm, &from, &to);
            let length = whole.amax();
            if length <= short && self.straight(&from, &whole) {
                continue;
            }
            let middle = moved(arm, &from, &(whole * 0.5));
            let Some(back) = self.brought_back(middle, &mut tried) else { return false };
            if length <= short && between(arm, &middle, &back).amax() <= BENT * length {
                continue;
            }
            // Beside a bend of the wrist that is nothing the middle may be farther than the ends are, but then not by much.
            let far = |end: &Joints<f64, N>| between(arm, end, &back).amax() > 2.0 * length;
            if tried > TRIED || far(&from) || far(&to) {
                return false;
            }
            pieces.extend([(back, to), (from, back)]);
        }
        true
    }

    /// Whether a curve of joint values that reach the pose, along what the arm has lost, comes from one end to the other.
    fn traced(&self, from: &Joints<f64, N>, to: &Joints<f64, N>) -> bool {
        let by = between(self.arm, from, to);
        self.comes_to(to, *from, by) || self.comes_to(to, *from, -by)
    }

    /// Whether the curve comes to the end that begins in a direction. Each step goes on in what is lost of the direction of the last, and
    /// is brought back onto the pose, which may hardly change it.
    fn comes_to(&self, end: &Joints<f64, N>, mut here: Joints<f64, N>, mut heading: Joints<f64, N>) -> bool {
        let (arm, short, mut tried) = (self.arm, heading.amax() * SHORT, 0);
        let mut length = short;
        while tried < TRACED {
            if between(arm, &here, end).amax() <= 2.0 * length && self.halved(here, *end) {
                return true;
            }
            let lost = self.lost(&here);
            let along: Joints<f64, N> = lost.iter().map(|way| way * way.dot(&heading)).sum();
            if along.amax() <= LOST * heading.amax() {
                return false;
            }
            let by = along * (length / along.amax());
            let ahead = moved(arm, &here, &by);
            let back = self.brought_back(ahead, &mut tried);
            match back.filter(|back| between(arm, &ahead, back).amax() <= STRAIGHT * length) {
                Some(back) => {
                    heading = between(arm, &here, &back);
                    (here, length) = (back, short.min(2.0 * length));
                }
                None => length *= 0.25,
            }
        }
        false
    }

    /// Whether one joint that turns on, either way round, takes the others with it from one end to the other: only where so much is lost
    /// that the pose hardly sees a piece of it.
    fn led_by_one(&self, from: &Joints<f64, N>, to: &Joints<f64, N>) -> bool {
        let (_, sizes, _) = decomposed(&jacobian(self.arm, &self.arm.at(from).1));
        let least = sizes.iter().take(N).copied().fold(f64::INFINITY, f64::min);
        if least * SHORT > self.window || !self.reaches(from) {
            return false;
        }
        let by = between(self.arm, from, to);
        let joints = self.arm.joints().into_iter().enumerate().filter(|(_, joint)| !slides(joint));
        joints
            .flat_map(|(joint, _)| [by[joint], by[joint] - TAU.copysign(by[joint])].map(|by| (joint, by)))
            .filter(|(_, by)| by.abs() > SHORT)
            .any(|(joint, by)| self.comes_with(joint, by, *from, to))
    }

    /// Whether a joint that turns by so much brings the others to the end, in steps that are ways themselves.
    fn comes_with(&self, joint: usize, by: f64, mut here: Joints<f64, N>, end: &Joints<f64, N>) -> bool {
        let (mut done, mut step) = (0.0, SHORT * SHORT);
        for _ in 0..LED {
            if done >= 1.0 {
                return self.halved(here, *end);
            }
            let share = step.min(1.0 - done);
            let mut ahead = here;
            ahead[joint] += share * by;
            let is_near = |ahead: &Joints<f64, N>| {
                between(self.arm, &here, ahead).amax() <= SHORT && self.halved(here, *ahead)
            };
            match self.held(joint, ahead).filter(is_near) {
                Some(ahead) => (here, done, step) = (ahead, done + share, 2.0 * step),
                None => step = 0.25 * share,
            }
        }
        false
    }

    fn reaches(&self, q: &Joints<f64, N>) -> bool {
        missing(self.arm, &self.arm.reached(q), self.target).1 <= self.window
    }

    /// Joint values near those given that reach the pose, one of them as it is.
    fn held(&self, joint: usize, mut q: Joints<f64, N>) -> Option<Joints<f64, N>> {
        for _ in 0..HELD {
            let (pose, velocities) = self.arm.at(&q);
            let mut velocities = jacobian(self.arm, &velocities);
            velocities.column_mut(joint).fill(0.0);
            q = moved(self.arm, &q, &damped(&velocities, &missing(self.arm, &pose, self.target).0)?);
        }
        self.reaches(&q).then_some(q)
    }

    /// Nearer to other joint values, along each direction that the arm has lost.
    fn slid(&self, mut q: Joints<f64, N>, towards: &Joints<f64, N>) -> Joints<f64, N> {
        for direction in self.lost(&q) {
            let by = direction.scale(direction.dot(&between(self.arm, &q, towards)));
            if self.straight(&q, &by) {
                q = moved(self.arm, &q, &by);
            }
        }
        q
    }

    /// The directions that the arm has lost, at right angles to each other; of joints that are not there they have nothing.
    fn lost(&self, q: &Joints<f64, N>) -> Vec<Joints<f64, N>> {
        let (_, sizes, v) = decomposed(&jacobian(self.arm, &self.arm.at(q).1));
        let rows = sizes.iter().zip(v.row_iter()).filter(|(size, _)| **size <= LOST);
        rows.map(|(_, row)| row.transpose().fixed_rows::<N>(0).into_owned()).collect()
    }

    /// Joint values near those given that reach the pose, twice as well as they must if they can.
    fn brought_back(&self, mut q: Joints<f64, N>, tried: &mut usize) -> Option<Joints<f64, N>> {
        let mut best = (self.window, None);
        for _ in 0..STEPS {
            *tried += 1;
            let (pose, velocities) = self.arm.at(&q);
            let (step, missed) = missing(self.arm, &pose, self.target);
            if missed <= 0.5 * self.window {
                return Some(q);
            }
            if missed <= best.0 {
                best = (missed, Some(q));
            }
            let velocities = jacobian(self.arm, &velocities);
            let by = match self.manner {
                Manner::Quick => damped(&velocities, &step)?,
                Manner::Shortest { left, ease } => {
                    let enough = (left * step.norm()).max(0.4 * self.window);
                    let ease = Joints::<f64, N>::from_fn(|joint, _| ease[usize::from(2 * joint >= N)]);
                    let eased = velocities * SMatrix::from_diagonal(&ease);
                    mended(&eased, &step, enough).component_mul(&ease)
                }
            };
            q = moved(self.arm, &q, &by);
        }
        best.1
    }
}

/// The least-squares step that is damped by the square of what is missed.
fn damped<const N: usize>(jacobian: &Jacobian<f64, N>, step: &Vector6<f64>) -> Option<Joints<f64, N>> {
    let damping = step.norm_squared().max(DULL);
    let normal = jacobian * jacobian.transpose() + Matrix6::from_diagonal_element(damping);
    Some(jacobian.tr_mul(&normal.cholesky()?.solve(step)))
}

/// A Jacobian as u, its singular values and v transposed; columns of joints that are not there are nothing.
fn decomposed<const N: usize>(jacobian: &Jacobian<f64, N>) -> (Matrix6<f64>, Vector6<f64>, Matrix6<f64>) {
    let mut square = Matrix6::zeros();
    square.fixed_columns_mut::<N>(0).copy_from(jacobian);
    let SVD { u, v_t, singular_values } = square.svd(true, true);
    (u.unwrap_or_default(), singular_values, v_t.unwrap_or_default())
}

/// The shortest step that leaves no more than `enough` of what is missed, by damped least squares. Where that cannot be had the damping
/// is the square of what is missed, which bounds the step.
fn mended<const N: usize>(jacobian: &Jacobian<f64, N>, step: &Vector6<f64>, enough: f64) -> Joints<f64, N> {
    let (u, sizes, v) = decomposed(jacobian);
    let (parts, least) = (u.tr_mul(step), step.norm_squared());
    let left = |damping: f64| parts.zip_map(&sizes, |part, size| part * damping / (size * size + damping));
    let mut damping = 1.0;
    while damping > least && left(damping).norm() > enough {
        damping *= 0.1;
    }
    let by = parts.zip_map(&sizes, |part, size| part * size / (size * size + damping));
    v.tr_mul(&by).fixed_rows::<N>(0).into_owned()
}
