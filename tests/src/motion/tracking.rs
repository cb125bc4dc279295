//! Paths through singular poses, followed by [`track`](kin_runtime::track).
//!
//! A path is made of joint values that move smoothly through one singular set, or where several meet. The poses are all that is
//! followed, so that there is a continuous choice from the first to the last: every flip is one that need not be. All of the path
//! is within the poses ahead, so that no choice can be blamed on what could not be seen. The tracker may take other joint values
//! than those that made the path, where branches meet; they too must go on to the end.

use std::f64::consts::PI;

use kin_runtime::JointKind;
use kin_runtime::prelude::*;
use kin_runtime::watch::{Factored, Factors};

use super::Worst;
use super::arms::{Ball, Oblique};
use crate::sample::Sampler;
use crate::skew::Skew;

/// Poses of a path.
pub const POSES: usize = 41;

/// What was found.
#[derive(Clone, Default, Debug, PartialEq)]
pub struct Findings {
    /// How many paths were led through no singular set, through one, two and three that meet.
    pub tries: [u64; 4],
    /// How many poses were followed.
    pub poses: u64,
    /// How many of these have a family for a solution.
    pub families: u64,
    /// How many paths end on other joint values than those that made them.
    pub others: u64,
    /// How many steps are more than four times as long as those of the joint values that made the path.
    pub long: u64,
    /// The largest step of a joint.
    pub step: Worst,
    /// How far forward kinematics misses the pose, in ε.
    pub residual: Worst,
    /// Number and pose of each flip.
    pub flips: Vec<(u64, usize)>,
    /// The same, of each pose that is told to be out of reach.
    pub blocked: Vec<(u64, usize)>,
}

impl Findings {
    /// The promises that are not kept: no flip, nothing out of reach, steps of less than 45°, residuals as of any solution.
    pub fn broken(&self) -> Vec<String> {
        let all = self.tries.iter().sum::<u64>();
        let told = |name: &str, list: &[(u64, usize)]| {
            (!list.is_empty()).then(|| format!("{name}: {} in {all} paths: {list:?}", list.len()))
        };
        let worst = |name: &str, worst: Worst, most: f64| {
            (worst.figure.is_nan() || worst.figure > most)
                .then(|| format!("{name}: {worst:?} is more than {most}"))
        };
        let lines = [
            told("flips", &self.flips),
            told("blocked", &self.blocked),
            worst("step", self.step, PI / 4.0),
            // What a solution may miss, and what a rotation may be off one.
            worst("residual", self.residual, 64.0 + 4.0),
        ];
        lines.into_iter().flatten().collect()
    }

    /// Both together.
    pub fn and(mut self, other: Findings) -> Findings {
        for (mine, more) in self.tries.iter_mut().zip(other.tries) {
            *mine += more;
        }
        self.poses += other.poses;
        self.families += other.families;
        self.others += other.others;
        self.long += other.long;
        self.step = self.step.and(other.step);
        self.residual = self.residual.and(other.residual);
        self.flips.extend(other.flips);
        self.blocked.extend(other.blocked);
        self
    }
}

/// One singular set: its factor of the determinant, and the joint that is brought onto it.
type Set = (fn(&Factors<f64>) -> Option<f64>, usize);

/// The sets of an arm with a wrist and of one with a spherical shoulder, in the order in which one is reached without leaving the
/// other.
const SETS: [[Set; 3]; 2] = [
    [
        (|f| f.elbow.or(Some(f.base)), 2),
        (|f| f.shoulder.or(f.elbow.is_none().then_some(f.base)), 1),
        (|f| f.wrist, 4),
    ],
    [
        (|f| f.elbow.or(Some(f.base)), 3),
        (|f| f.hand.or(f.elbow.is_none().then_some(f.base)), 4),
        (|f| f.bend, 1),
    ],
];

/// Brings one joint to where a factor vanishes, if it does so in the half turn or the reach that lies ahead.
fn onto<const N: usize, A: Factored<N>>(arm: &A, q: &mut Joints<f64, N>, (factor, joint): Set) -> bool {
    let at = |value: f64| {
        let mut q = *q;
        q[joint] = value;
        factor(&arm.factors(&q)).unwrap_or(f64::NAN)
    };
    let way = if A::JOINTS[joint].kind == JointKind::Prismatic { arm.reach() } else { PI };
    let (mut low, mut high) = (q[joint], q[joint] + way);
    let start = at(low);
    let product = start * at(high);
    if product > 0.0 || product.is_nan() {
        return false;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if start * at(middle) <= 0.0 { high = middle } else { low = middle }
    }
    // What is nought but for round-off is nought: most tables have their singular angles at whole quarter turns.
    let round = (high / (PI / 2.0)).round() * (PI / 2.0);
    q[joint] = if (high - round).abs() < 1e-12 { round } else { high };
    true
}

/// Joint values on the singular sets that are bits of `sets`.
fn aimed<const N: usize, A: Factored<N>>(arm: &A, sets: u64, random: &mut Sampler) -> Joints<f64, N> {
    loop {
        let mut q = Joints::from(random.angles::<N>());
        for (value, joint) in q.iter_mut().zip(A::JOINTS) {
            if joint.kind == JointKind::Prismatic {
                *value = random.between(-0.5, 0.5) * arm.reach();
            }
        }
        let mirrored = usize::from(arm.factors(&q).bend.is_some());
        let wanted = SETS[mirrored].iter().enumerate().filter(|(bit, _)| sets >> bit & 1 == 1);
        if wanted.fold(true, |all, (_, set)| all && onto(arm, &mut q, *set)) {
            return q;
        }
    }
}

/// A smooth path of joint values through `q`, which is its middle or between two of its poses.
fn smooth<const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<f64, N>,
    random: &mut Sampler,
) -> Vec<Joints<f64, N>> {
    let mut speed = Joints::<f64, N>::zeros();
    let mut bend = speed;
    for (joint, (speed, bend)) in speed.iter_mut().zip(bend.iter_mut()).enumerate() {
        let unit = if A::JOINTS[joint].kind == JointKind::Prismatic { 0.5 * arm.reach() } else { 1.0 };
        *speed = random.between(0.1, 0.6) * unit * if random.below(2) == 0 { 1.0 } else { -1.0 };
        *bend = random.between(-0.2, 0.2) * unit;
    }
    let off = [0.0, 0.0, random.between(-0.5, 0.5), 10_f64.powi(-(random.below(18) as i32))][random.below(4)];
    let middle = (POSES / 2) as f64;
    let time = |i: usize| (i as f64 - middle + off) / middle;
    (0..POSES).map(|i| q + speed * time(i) + bend * (time(i) * time(i))).collect()
}

/// How far joint values are apart, slides in reaches.
fn apart<const N: usize, A: Arm<N>>(arm: &A, a: &Joints<f64, N>, b: &Joints<f64, N>) -> f64 {
    let unit = |joint: usize| if A::JOINTS[joint].kind == JointKind::Prismatic { arm.reach() } else { 1.0 };
    (0..N).map(|joint| (a[joint] - b[joint]).abs() / unit(joint)).fold(0.0, f64::max)
}

/// The largest entry of the difference, lengths divided by the reach; of an arm of three joints only the place counts.
fn difference<const N: usize>(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let turned = if N == 6 { (a.rotation.matrix() - b.rotation.matrix()).amax() } else { 0.0 };
    turned.max((a.translation.vector - b.translation.vector).amax() / reach)
}

/// The joint values of a path, as the try with this number makes them.
pub fn path<const N: usize, A: Factored<N>>(arm: &A, sets: u64, random: &mut Sampler) -> Vec<Joints<f64, N>> {
    let q = aimed(arm, sets, random);
    smooth(arm, &q, random)
}

/// A path of poses.
fn follow<A: Factored<6> + InverseKinematics<6>>(
    arm: &A,
    at: (u64, u64),
    random: &mut Sampler,
    found: &mut Findings,
) {
    let made = path(arm, at.1, random);
    let poses = made.iter().map(|q| arm.fk(q));
    judge(arm, at, &made, arm.track(&made[0], poses).ahead(POSES), found);
}

/// A path of points.
fn follow_points<A: Factored<3> + PositionInverse<3>>(
    arm: &A,
    at: (u64, u64),
    random: &mut Sampler,
    found: &mut Findings,
) {
    let made = path(arm, at.1, random);
    let points = made.iter().map(|q| Point3::from(arm.fk(q).translation.vector));
    judge(arm, at, &made, arm.track_position(&made[0], points).ahead(POSES), found);
}

/// What became of a path.
fn judge<const N: usize, A: Arm<N>, B: Branch>(
    arm: &A,
    (trial, sets): (u64, u64),
    made: &[Joints<f64, N>],
    steps: impl Iterator<Item = Step<f64, N, B>>,
    found: &mut Findings,
) {
    found.tries[sets.count_ones() as usize] += 1;
    let mut before = made[0];
    for (index, step) in steps.enumerate() {
        found.poses += 1;
        let at = match step {
            Step::Continuous(at) => at,
            Step::Flip { .. } => {
                found.flips.push((trial, index));
                return;
            }
            Step::Blocked(_) => {
                found.blocked.push((trial, index));
                return;
            }
        };
        let missed = difference::<N>(&arm.fk(&at.q), &arm.fk(&made[index]), arm.reach());
        found.residual.see(missed / f64::EPSILON, trial);
        let step = apart(arm, &at.q, &before);
        found.step.see(step, trial);
        found.long += u64::from(index > 0 && step > 4.0 * apart(arm, &made[index], &made[index - 1]));
        found.families += u64::from(!at.solution.is_isolated());
        before = at.q;
    }
    found.others += u64::from(apart(arm, &before, &made[POSES - 1]) > 1e-6);
}

/// Which arm and which sets a try has; an arm of three joints has no wrist.
pub fn trial_of(trial: u64) -> (u64, u64) {
    let (arm, sets) = (trial % 9, trial / 9 % 8);
    (arm, if arm < 7 { sets } else { sets & 3 })
}

/// The generator of a try.
pub fn random_of(seed: u64, trial: u64) -> Sampler {
    Sampler::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(trial))
}

/// The tries from one number to another.
pub fn run(seed: u64, tries: std::ops::Range<u64>) -> Findings {
    let mut found = Findings::default();
    for trial in tries {
        let mut random = random_of(seed, trial);
        let (arm, sets) = trial_of(trial);
        let (at, random, found) = ((trial, sets), &mut random, &mut found);
        match arm {
            0 => follow(&robots::LabArm, at, random, found),
            1 => follow(&robots::Puma560, at, random, found),
            2 => follow(&robots::Kr6R700, at, random, found),
            3 => follow(&robots::Stanford, at, random, found),
            4 => follow(&Skew, at, random, found),
            5 => follow(&Oblique, at, random, found),
            6 => follow(&Ball, at, random, found),
            7 => follow_points(&robots::LabRrr, at, random, found),
            _ => follow_points(&robots::Al5d, at, random, found),
        }
    }
    found
}
