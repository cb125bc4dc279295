//! Inverse solutions against the listed ones, counted as the reference's own scorer counts them.
//!
//! A returned solution is *valid* if the plain product puts the tool where it was asked for; it *matches* a listed one if
//! no joint differs by more than a tolerance that grows with the sensitivity there, 1/σ_min. Limits play no part.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use crate::pose::difference;
use crate::product::pose;
use crate::reference::{Inverse, Record};

/// The pose tolerance: metres divided by the reach, and entries of the rotation matrix.
pub const TOLERANCE: f64 = 1e-10;

/// What is counted over one or more cases.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Score {
    /// The cases.
    pub cases: usize,
    /// Cases in which nothing is missing and nothing is wrong.
    pub complete: usize,
    /// Solutions returned.
    pub returned: usize,
    /// Isolated solutions listed.
    pub listed: usize,
    /// Of these, found.
    pub found: usize,
    /// Double roots listed; rounding of the pose may legitimately push them out of reach.
    pub doubles_listed: usize,
    /// Of these, found.
    pub doubles_found: usize,
    /// One-parameter families listed.
    pub families_listed: usize,
    /// Of these, with a member returned.
    pub families_found: usize,
    /// Returned solutions that miss the pose.
    pub spurious: usize,
    /// Valid returned solutions that match nothing listed.
    pub unlisted: usize,
    /// Valid solutions that were returned before.
    pub duplicates: usize,
    /// Valid solutions with an angle outside (-π, π].
    pub unwrapped: usize,
    /// The worst pose error of a valid solution.
    pub worst: f64,
}

impl Score {
    /// Adds another score.
    pub fn add(&mut self, other: Score) {
        self.cases += other.cases;
        self.complete += other.complete;
        self.returned += other.returned;
        self.listed += other.listed;
        self.found += other.found;
        self.doubles_listed += other.doubles_listed;
        self.doubles_found += other.doubles_found;
        self.families_listed += other.families_listed;
        self.families_found += other.families_found;
        self.spurious += other.spurious;
        self.unlisted += other.unlisted;
        self.duplicates += other.duplicates;
        self.unwrapped += other.unwrapped;
        self.worst = self.worst.max(other.worst);
    }
}

/// An angle brought into (-π, π].
pub fn wrap(angle: f64) -> f64 {
    let turned = (angle + PI) % TAU;
    if turned <= 0.0 { turned + PI } else { turned - PI }
}

/// The largest difference of a joint outside `skipped`, angles modulo 2π.
pub fn distance(kinds: &[char], a: &[f64], b: &[f64], skipped: &[usize]) -> f64 {
    let gap = |i: usize| if kinds[i] == 'R' { wrap(a[i] - b[i]).abs() } else { (a[i] - b[i]).abs() };
    (0..kinds.len()).filter(|i| !skipped.contains(i)).map(gap).fold(0.0, f64::max)
}

/// Scores the solutions, in metres and radians, that were returned for one case.
pub fn score(arm: &Record, case: &Inverse, solutions: &[Vec<f64>]) -> Score {
    let kinds = arm.kinds();
    let mut score = Score { cases: 1, returned: solutions.len(), ..Score::default() };
    let valid = validate(arm, case, solutions, &kinds, &mut score);
    let matched = match_listed(case, &valid, &kinds, &mut score);
    score.unlisted = valid.len() - matched.len();
    // Where the families cross each other only one valid answer is asked for.
    if case.kind == "shoulder_and_wrist_singular" {
        (score.families_listed, score.families_found, score.unlisted) =
            (1, usize::from(!valid.is_empty()), 0);
    }
    let whole = score.found == score.listed && score.families_found == score.families_listed;
    let clean = score.spurious + score.unlisted + score.duplicates == 0;
    score.complete = usize::from(whole && clean);
    score
}

fn validate<'a>(
    arm: &Record,
    case: &Inverse,
    solutions: &'a [Vec<f64>],
    kinds: &[char],
    score: &mut Score,
) -> Vec<&'a [f64]> {
    // The boundary kinds shift the target by 1e-9 of the reach: a looser tolerance would not see the shift.
    let tolerance = if case.rel_eps.is_some_and(|e| e.abs() <= 1e-8) { 1e-12 } else { TOLERANCE };
    let mut valid: Vec<&[f64]> = Vec::new();
    for q in solutions {
        if q.len() != kinds.len() || q.iter().any(|x| !x.is_finite()) {
            score.spurious += 1;
            continue;
        }
        let mut off = difference(&pose(arm, q), &case.pose);
        if case.task == "position" {
            off.rotation = 0.0;
        }
        let error = off.relative(arm.reach());
        if error > tolerance || error.is_nan() {
            score.spurious += 1;
            continue;
        }
        score.worst = score.worst.max(error);
        let wrapped = |(x, kind): (&f64, &char)| *kind != 'R' || (-PI - 1e-12 < *x && *x <= PI + 1e-12);
        score.unwrapped += usize::from(!q.iter().zip(kinds).all(wrapped));
        score.duplicates += usize::from(valid.iter().any(|v| distance(kinds, q, v, &[]) < 1e-7));
        valid.push(q);
    }
    valid
}

/// Which of the valid solutions match something listed.
fn match_listed(case: &Inverse, valid: &[&[f64]], kinds: &[char], score: &mut Score) -> BTreeSet<usize> {
    let mut matched = BTreeSet::new();
    let mut hit = |matches: &dyn Fn(&[f64]) -> bool| {
        let before: Vec<usize> = (0..valid.len()).filter(|&i| matches(valid[i])).collect();
        matched.extend(before.iter().copied());
        usize::from(!before.is_empty())
    };
    for (q, sigma) in case.solutions.iter().zip(&case.sigma_min) {
        let sensitive = (1e-13 / sigma.max(1e-300)).clamp(1e-6, 0.05);
        let (tolerance, skipped) = match (*sigma < 1e-8, case.near_moving.as_slice()) {
            (true, []) => (sensitive, &[] as &[usize]),
            (true, moving) => (1e-6, moving),
            (false, _) => (sensitive, &[] as &[usize]),
        };
        score.listed += 1;
        score.found += hit(&|v| distance(kinds, q, v, skipped) < tolerance);
    }
    for q in &case.double_roots {
        score.doubles_listed += 1;
        score.doubles_found += hit(&|v| distance(kinds, q, v, &[]) < 1e-3);
    }
    for family in &case.families {
        let gap = |v: &[f64], k: usize, x: f64| {
            if kinds[k] == 'R' { wrap(v[k] - x).abs() } else { (v[k] - x).abs() }
        };
        score.families_listed += 1;
        score.families_found += hit(&|v| family.fixed.iter().all(|(&k, &x)| gap(v, k, x) < 1e-5));
    }
    matched
}

#[test]
fn the_listed_solutions_score_full() {
    for name in ["puma560", "stanford", "seed000_lab6dof"] {
        let arm = crate::reference::arm(name);
        let mut total = Score::default();
        for case in arm.cases().ik.iter().filter(|case| case.kind == "random") {
            total.add(score(&arm, case, &case.solutions));
        }
        assert_eq!((total.found, total.spurious, total.duplicates), (total.listed, 0, 0), "{name}");
        assert_eq!(total.complete, total.cases, "{name}");
    }
}

#[test]
fn mistakes_are_counted() {
    let arm = crate::reference::arm("puma560");
    let case = &arm.cases().ik[0];
    let mut wrong = case.solutions.clone();
    let last = wrong.len() - 1;
    wrong[0][2] += 1e-6;
    wrong[1] = wrong[2].clone();
    wrong[last][5] = f64::NAN;
    let counted = score(&arm, case, &wrong);
    assert_eq!((counted.spurious, counted.duplicates, counted.complete), (2, 1, 0));
    assert_eq!(counted.found, counted.listed - 3);
}
