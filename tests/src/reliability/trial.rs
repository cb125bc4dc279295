//! One try: joint values forward to a pose and back, and what must hold of the answer.

use kin_runtime::prelude::*;
use kin_runtime::{Joint, JointKind, singularity};

use nalgebra::{ArrayStorage, Matrix6, Vector6};

use super::aim::Sights;
use super::subject::{Bits, Family, Subject};
use super::tally::{Fault, Tally};
use super::way::{self, Moving};
use crate::sample::Sampler;

/// The joints may come back this many ε over the smallest singular value away …
const CONDITIONED: f64 = 1e3;
/// … and never more than this many √ε.
const CUSP: f64 = 1e2;
/// Solutions closer than this many √ε are one: the library's own promise, 1e-7 for doubles.
const SAME: f64 = 6.710_886_4;

/// A try that can say what it is.
pub struct Try<'a, S> {
    /// The arm.
    pub subject: &'a S,
    /// Where to aim.
    pub sights: &'a Sights,
    /// What its family promises.
    pub family: Family,
    /// The number of the try.
    pub index: u64,
}

/// So many tries of one arm, aimed at its own singular sets: what went wrong, in words.
pub fn complaints<T: Bits, const N: usize>(
    subject: &impl Subject<N>,
    tries: u64,
    random: &mut Sampler,
) -> Vec<String> {
    let (sights, family, mut tally) = (subject.sights(), subject.family(), Tally::default());
    for index in 0..tries {
        Try { subject, sights: &sights, family, index }.round_trip::<T, N>(random, &mut tally);
    }
    tally.complaints()
}

/// A solution: its joint values, and whether it is isolated.
type Answer<T, const N: usize> = (Joints<T, N>, bool);

/// An arm in one number format, whoever it is: what follows is then compiled once for each number of joints.
trait Asked<T, const N: usize>: Moving<N> {
    fn fk(&self, q: &Joints<T, N>) -> Pose<T>;
    fn solved(&self, target: &Pose<T>) -> Vec<Answer<T, N>>;
    fn solved_holding(&self, target: &Pose<T>, hold: &Joints<T, N>) -> Vec<Answer<T, N>>;
    fn commanded(&self, rows: [f64; 6]) -> [f64; N];
}

impl<const N: usize, S: Subject<N>> Moving<N> for S {
    fn joints(&self) -> [Joint; N] {
        S::JOINTS
    }

    fn length(&self) -> f64 {
        self.reach()
    }

    fn turns(&self) -> bool {
        S::TURNS
    }

    fn at(&self, q: &Joints<f64, N>) -> (Pose<f64>, Jacobian<f64, N>) {
        self.fk_jacobian(q)
    }

    fn reached(&self, q: &Joints<f64, N>) -> Pose<f64> {
        Arm::fk(self, q)
    }
}

impl<T: Bits, const N: usize, S: Subject<N>> Asked<T, N> for S {
    fn fk(&self, q: &Joints<T, N>) -> Pose<T> {
        Arm::fk(self, q)
    }

    fn solved(&self, target: &Pose<T>) -> Vec<Answer<T, N>> {
        self.solve(target).iter().map(|s| (s.q, s.is_isolated())).collect()
    }

    fn solved_holding(&self, target: &Pose<T>, hold: &Joints<T, N>) -> Vec<Answer<T, N>> {
        self.solve_holding(target, hold).iter().map(|s| (s.q, s.is_isolated())).collect()
    }

    fn commanded(&self, rows: [f64; 6]) -> [f64; N] {
        Subject::commanded(self, rows)
    }
}

/// The bit patterns of numbers.
pub fn bits<T: Bits>(values: &[T]) -> Vec<String> {
    values.iter().map(|x| format!("{:#x}", x.bits())).collect()
}

/// A pose in doubles.
fn widened<T: Bits>(pose: &Pose<T>) -> Pose<f64> {
    let (rows, position) = kin_runtime::private::entries(pose);
    kin_runtime::private::pose(rows.map(|row| row.map(T::wide)), position.map(T::wide))
}

/// Joint values as doubles.
fn wide<T: Bits, const N: usize>(q: &Joints<T, N>) -> Joints<f64, N> {
    Joints::from_fn(|joint, _| q[joint].wide())
}

/// Whether every joint value may be given out: finite, angles in (-π, π].
pub fn well_formed<T: Bits, const N: usize>(joints: &[Joint; N], q: &Joints<T, N>) -> bool {
    let half = T::TURN.0.wide() * 0.5;
    joints.iter().zip(q).all(|(joint, value)| {
        let (value, turning) = (value.wide(), joint.kind == JointKind::Revolute);
        value.is_finite() && (!turning || (value > -half && value <= half))
    })
}

/// A number that the smallest singular value does not exceed, and seldom falls much short of: by how much the Jacobian stretches the
/// direction of one inverse iteration. Infinite if there is none, or other than six joints.
fn least_above<const N: usize>(jacobian: &Jacobian<f64, N>) -> f64 {
    let Ok(columns) = <[[f64; 6]; 6]>::try_from(jacobian.data.0.as_slice()) else { return f64::INFINITY };
    let square = Matrix6::from_array_storage(ArrayStorage(columns));
    let direction = square.transpose().lu().solve(&Vector6::repeat(1.0));
    let direction = direction.and_then(|once| square.lu().solve(&once));
    let stretch = direction.map(|along| (square * along).norm() / along.norm());
    stretch.filter(|stretch| stretch.is_finite()).unwrap_or(f64::INFINITY)
}

impl<S> Try<'_, S> {
    /// There and back again, in the number format `T`.
    pub fn round_trip<T: Bits, const N: usize>(&self, random: &mut Sampler, tally: &mut Tally)
    where
        S: Subject<N>,
    {
        let (sights, family, index) = (self.sights, self.family, self.index);
        Trip::<T, N> { arm: self.subject, name: S::NAME, family, index }.go(sights, random, tally);
    }
}

/// A try of an arm whose type is forgotten.
struct Trip<'a, T, const N: usize> {
    arm: &'a dyn Asked<T, N>,
    name: &'static str,
    family: Family,
    index: u64,
}

/// Where a try came from.
struct There<T: Bits, const N: usize> {
    q: Joints<T, N>,
    target: Pose<T>,
}

impl<T: Bits, const N: usize> Trip<'_, T, N> {
    fn go(&self, sights: &Sights, random: &mut Sampler, tally: &mut Tally) {
        let commanded = self.arm.commanded(sights.row_values(random));
        let q = Joints::<T, N>::from_fn(|joint, _| T::rounded(commanded[joint]));
        let target = self.arm.fk(&q);
        let found = self.arm.solved(&target);
        let case = || bits(q.as_slice());

        tally.tries += 1;
        tally.solutions += found.len() as u64;
        tally.families += u64::from(found.iter().any(|(_, isolated)| !isolated));
        if found.is_empty() {
            tally.of_mut(Fault::Empty).add(1.0, self.index, self.name, case);
            return;
        }
        let missed = found.iter().map(|(solution, _)| self.missed(solution, &target));
        let worst = missed.fold(0.0, |worst: f64, x| if x > worst || x.is_nan() { x } else { worst });
        tally.residual.add(worst, self.index, self.name, case);
        if worst.is_nan() || worst > self.family.promised {
            tally.of_mut(Fault::Inexact).add(worst, self.index, self.name, case);
        }
        let joints = self.arm.joints();
        if found.len() > self.family.most || !found.iter().all(|(q, _)| well_formed(&joints, q)) {
            tally.of_mut(Fault::Malformed).add(1.0, self.index, self.name, case);
        }
        if self.twice(&found) {
            tally.of_mut(Fault::Twice).add(1.0, self.index, self.name, case);
        }
        self.recall(&There { q, target }, &found, tally);
    }

    /// How far forward kinematics of a solution misses its target, over the reach and ε.
    fn missed(&self, q: &Joints<T, N>, target: &Pose<T>) -> f64 {
        let reached = self.arm.fk(q);
        let apart = |a: &[T], b: &[T]| {
            let each = a.iter().zip(b).map(|(a, b)| (a.wide() - b.wide()).abs());
            // A plain `max` would drop a NaN, which is the worst there is.
            each.fold(0.0, |worst: f64, x| if x > worst || x.is_nan() { x } else { worst })
        };
        let shift = apart(reached.translation.vector.as_slice(), target.translation.vector.as_slice());
        let turn = apart(reached.rotation.matrix().as_slice(), target.rotation.matrix().as_slice());
        let shift = shift / self.arm.length();
        let both = if self.arm.turns() && (turn > shift || turn.is_nan()) { turn } else { shift };
        both / T::EPS.wide()
    }

    fn between(&self, a: &Joints<T, N>, b: &Joints<T, N>) -> Joints<f64, N> {
        way::between(self.arm, &wide(a), &wide(b))
    }

    /// Whether two of the solutions are one.
    fn twice(&self, all: &[Answer<T, N>]) -> bool {
        // The library compares in its own format: a little less than its tolerance is a fault in any case.
        let same = 0.999 * SAME * T::EPS.wide().sqrt();
        let apart = |a: &Joints<T, N>, b: &Joints<T, N>| self.between(a, b).amax();
        all.iter().enumerate().any(|(i, (a, _))| all[..i].iter().any(|(b, _)| apart(a, b) <= same))
    }

    /// The joints that the pose came from must be among the solutions, or a member of one of their families; or a pose that
    /// determines them badly must have led to others that it cannot tell from them.
    fn recall(&self, there: &There<T, N>, back: &[Answer<T, N>], tally: &mut Tally) {
        let near = |all: &[Answer<T, N>]| -> Vec<(f64, Joints<T, N>)> {
            all.iter().map(|(q, _)| (self.between(q, &there.q).amax(), *q)).collect()
        };
        let least =
            |all: &[(f64, Joints<T, N>)]| all.iter().fold(f64::INFINITY, |least, (off, _)| least.min(*off));
        let (mut all, epsilon) = (near(back), T::EPS.wide());
        let allowed = |margin: f64| (CONDITIONED * epsilon / margin).min(CUSP * epsilon.sqrt());
        let mut off = least(&all);
        let own = wide(&there.q);
        let jacobian = way::jacobian(self.arm, &self.arm.at(&own).1);
        // What is near enough for the largest singular value needs no smallest one: none is larger than the Frobenius norm. Nor does
        // what is near enough for some that is not smaller than it, and nearer, in parts of what is allowed, than the worst so far.
        if off * jacobian.norm() <= CONDITIONED * epsilon {
            return;
        }
        let strays = off / allowed(least_above(&jacobian));
        if strays <= 1.0 && !tally.strayed.takes(strays, self.index) {
            return;
        }
        let values = singularity::singular_values(&jacobian);
        let values = values.iter().take(if self.arm.turns() { 6 } else { 3 });
        let margin = values.clone().fold(f64::INFINITY, |least, value| least.min(*value));
        let allowed = allowed(margin);
        if off > allowed && back.iter().any(|(_, isolated)| !isolated) {
            all.extend(near(&self.arm.solved_holding(&there.target, &there.q)));
            off = least(&all);
        }
        let case = || bits(there.q.as_slice());
        if off <= allowed {
            tally.strayed.add(off / allowed, self.index, self.name, case);
            return;
        }
        all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        // Solutions that hold on to nothing come back as they were.
        all.dedup_by(|(_, a), (_, b)| a == b);
        let (target, window) = (widened(&there.target), self.family.promised * epsilon);
        // Directions that are nearly lost add up to no more than the product of all singular values lets them.
        let blurred = CONDITIONED * epsilon / values.product::<f64>();
        let near = all.iter().filter(|(off, _)| *off <= blurred);
        let ends: Vec<Joints<f64, N>> = near.map(|(_, q)| wide(q)).collect();
        if way::leads(self.arm, &target, &own, &ends, window) {
            tally.blurred.add(off / allowed, self.index, self.name, case);
        } else {
            tally.of_mut(Fault::Lost).add(off / allowed, self.index, self.name, case);
        }
    }
}
