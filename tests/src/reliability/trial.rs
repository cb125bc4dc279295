//! One try: joint values forward to a pose and back, and what must hold of the answer.

use std::f64::consts::{PI, TAU};

use kin_runtime::JointKind;
use kin_runtime::prelude::*;

use super::aim::Sights;
use super::subject::{Bits, Subject};
use super::tally::Tally;
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
    /// The number of the try.
    pub index: u64,
}

/// Where a try came from.
struct There<T: Bits, const N: usize> {
    q: Joints<T, N>,
    target: Pose<T>,
    /// Of the shoulder, the elbow and the wrist.
    margins: [Option<f64>; 3],
}

/// The bit patterns of numbers.
pub fn bits<T: Bits>(values: &[T]) -> Vec<String> {
    values.iter().map(|x| format!("{:#x}", x.bits())).collect()
}

/// The move of one joint, angles the short way round.
fn way<T: Bits, const N: usize, A: Arm<N>>(_: &A, joint: usize, a: &Joints<T, N>, b: &Joints<T, N>) -> f64 {
    let way = a[joint].wide() - b[joint].wide();
    let turning = A::JOINTS[joint].kind == JointKind::Revolute;
    if turning { ((way + PI).rem_euclid(TAU) - PI).abs() } else { way.abs() }
}

/// The largest move of a joint.
fn distance<T: Bits, const N: usize, A: Arm<N>>(arm: &A, a: &Joints<T, N>, b: &Joints<T, N>) -> f64 {
    (0..N).fold(0.0, |worst: f64, joint| worst.max(way(arm, joint, a, b)))
}

/// How far forward kinematics of a solution misses its target, over the reach and ε.
fn missed<T: Bits, const N: usize, S: Subject<N>>(subject: &S, q: &Joints<T, N>, target: &Pose<T>) -> f64 {
    let reached = subject.fk(q);
    let apart = |a: &[T], b: &[T]| {
        let each = a.iter().zip(b).map(|(a, b)| (a.wide() - b.wide()).abs());
        // A plain `max` would drop a NaN, which is the worst there is.
        each.fold(0.0, |worst: f64, x| if x > worst || x.is_nan() { x } else { worst })
    };
    let shift = apart(reached.translation.vector.as_slice(), target.translation.vector.as_slice());
    let turn = apart(reached.rotation.matrix().as_slice(), target.rotation.matrix().as_slice());
    let shift = shift / subject.reach();
    let both = if S::TURNS && (turn > shift || turn.is_nan()) { turn } else { shift };
    both / T::EPS.wide()
}

/// Whether every joint value may be given out: finite, angles in (-π, π].
pub fn well_formed<T: Bits, const N: usize, A: Arm<N>>(_: &A, q: &Joints<T, N>) -> bool {
    let half = T::TURN.0.wide() * 0.5;
    (0..N).all(|joint| {
        let value = q[joint].wide();
        let turning = A::JOINTS[joint].kind == JointKind::Revolute;
        value.is_finite() && (!turning || (value > -half && value <= half))
    })
}

impl<S> Try<'_, S> {
    /// There and back again, in the number format `T`.
    pub fn round_trip<T: Bits, const N: usize>(&self, random: &mut Sampler, tally: &mut Tally)
    where
        S: Subject<N>,
    {
        let rows = self.sights.row_values(random);
        let commanded = self.subject.commanded(rows);
        let q = Joints::<T, N>::from_fn(|joint, _| T::rounded(commanded[joint]));
        let target = self.subject.fk(&q);
        let solutions = self.subject.solve(&target);
        let found: Vec<_> = solutions.iter().collect();
        let case = || bits(q.as_slice());

        tally.tries += 1;
        tally.solutions += found.len() as u64;
        tally.families += u64::from(found.iter().any(|solution| !solution.is_isolated()));
        if found.is_empty() {
            tally.empties += 1;
            tally.empty.add(1.0, self.index, S::NAME, case);
            return;
        }
        for solution in &found {
            let residual = missed(self.subject, &solution.q, &target);
            tally.residual.add(residual, self.index, S::NAME, case);
        }
        let formed = found.iter().all(|solution| well_formed(self.subject, &solution.q));
        if !formed || found.len() > S::Branch::ALL.len() {
            tally.malformeds += 1;
            tally.malformed.add(1.0, self.index, S::NAME, case);
        }
        if self.twice(&found.iter().map(|solution| solution.q).collect::<Vec<_>>()) {
            tally.twices += 1;
            tally.twice.add(1.0, self.index, S::NAME, case);
        }
        self.recall(&There { q, target, margins: self.sights.margins(&rows) }, &solutions, tally);
    }

    /// Whether two of the joint vectors are one.
    fn twice<T: Bits, const N: usize>(&self, all: &[Joints<T, N>]) -> bool
    where
        S: Subject<N>,
    {
        // The library compares in its own format: a little less than its tolerance is a fault in any case.
        let same = 0.999 * SAME * T::EPS.wide().sqrt() * self.unit();
        all.iter().enumerate().any(|(i, a)| all[..i].iter().any(|b| distance(self.subject, a, b) <= same))
    }

    /// What one radian is compared with where joints slide.
    fn unit<const N: usize>(&self) -> f64
    where
        S: Subject<N>,
    {
        let slides = S::JOINTS.iter().any(|joint| joint.kind == JointKind::Prismatic);
        if slides { self.subject.reach().min(1.0) } else { 1.0 }
    }

    /// The joints that the pose came from must be among the solutions, or a member of one of their families.
    fn recall<T: Bits, const N: usize>(
        &self,
        there: &There<T, N>,
        back: &Solutions<T, N, S::Branch>,
        tally: &mut Tally,
    ) where
        S: Subject<N>,
    {
        let nearest = |solutions: &Solutions<T, N, S::Branch>| {
            let all = solutions.iter().map(|solution| distance(self.subject, &solution.q, &there.q));
            all.fold(f64::INFINITY, f64::min)
        };
        let epsilon = T::EPS.wide();
        let mut off = nearest(back);
        // What is near enough for the largest singular value needs no smallest one.
        if off * self.size(&there.q) <= CONDITIONED * epsilon {
            return;
        }
        let dexterity = self.subject.dexterity(&there.q);
        let allowed = (CONDITIONED * epsilon / dexterity.margin.wide()).min(CUSP * epsilon.sqrt());
        if off > allowed && back.iter().any(|solution| !solution.is_isolated()) {
            off = off.min(nearest(&self.subject.solve_holding(&there.target, &there.q)));
        }
        let case = || bits(there.q.as_slice());
        if off <= allowed {
            tally.strayed.add(off / allowed, self.index, S::NAME, case);
            return;
        }
        let blurred = CONDITIONED * epsilon / dexterity.manipulability.wide();
        let mut near =
            back.iter().filter(|solution| distance(self.subject, &solution.q, &there.q) <= blurred);
        if near.any(|solution| self.same_place(there, solution)) {
            tally.blurs += 1;
            tally.blurred.add(off / allowed, self.index, S::NAME, case);
        } else {
            tally.losses += 1;
            tally.lost.add(off / allowed, self.index, S::NAME, case);
        }
    }

    /// Whether a solution is as far from each singular set as the joints that went in; of the wrist's only where the
    /// base is the same, because the wrist follows the base.
    fn same_place<T: Bits, const N: usize>(
        &self,
        there: &There<T, N>,
        back: &Solution<T, N, S::Branch>,
    ) -> bool
    where
        S: Subject<N>,
    {
        let near = CUSP * T::EPS.wide().sqrt();
        let slides = S::JOINTS.iter().any(|joint| joint.kind == JointKind::Prismatic);
        let reach = self.subject.reach();
        let margins = [Some(back.margins.shoulder), Some(back.margins.elbow), back.margins.wrist];
        let units = [reach, if slides { reach } else { 1.0 }, 1.0];
        let mut same =
            there.margins.iter().zip(margins).zip(units).map(|((there, back), unit)| match (there, back) {
                (Some(there), Some(back)) => (there - back.wide()).abs() <= near * unit,
                _ => true,
            });
        let base = (0..3).all(|joint| way(self.subject, joint, &back.q, &there.q) <= near);
        same.next() == Some(true) && same.next() == Some(true) && (!base || same.next() == Some(true))
    }

    /// The Frobenius norm of the Jacobian, linear rows divided by the reach: no singular value is larger.
    fn size<T: Bits, const N: usize>(&self, q: &Joints<T, N>) -> f64
    where
        S: Subject<N>,
    {
        let (jacobian, reach) = (self.subject.jacobian(q), self.subject.reach());
        let squares = jacobian.row_iter().enumerate().map(|(row, entries)| {
            let unit = if row < 3 { reach } else { 1.0 };
            entries.iter().map(|x| (x.wide() / unit).powi(2)).sum::<f64>()
        });
        squares.sum::<f64>().sqrt()
    }
}
