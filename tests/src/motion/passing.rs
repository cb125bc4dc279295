//! Crossings of thresholds along random trajectories, against a sampling that is thousands of times finer than the controller's.
//!
//! What the samples say is computed here: determinants by cofactors, and whether the smallest singular value is above a threshold
//! by whether JᵀJ - c²·1 has a Cholesky factor (A.-L. Cholesky 1910): neither is how the monitor does it.

use kin_runtime::pose::{Jacobian, Joints};
use kin_runtime::singularity::normalised;
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use kin_runtime::watch::{Crossing, Factor, Factored, Measure, Passage, Watch};

use super::Worst;
use crate::sample::Sampler;

/// The rate of a controller, in Hz.
const RATE: f64 = 20.0;

/// What was found.
#[derive(Clone, Default, Debug, PartialEq)]
pub struct Findings {
    /// How many trajectories, and how many fine samples.
    pub tries: u64,
    /// See `tries`.
    pub samples: u64,
    /// How many times the samples change sides.
    pub crossings: u64,
    /// How many passages the monitor found.
    pub passages: u64,
    /// Passages in pairs between two fine samples: what a finer sampling does not see.
    pub unseen: u64,
    /// Passages that only touch.
    pub touches: u64,
    /// The widest bracket of a passage, in parts of the duration; ten times its trial, and the number of its figure.
    pub widest: Worst,
    /// Trial, figure and time of each change that the monitor did not find.
    pub lost: Vec<(u64, usize, f64)>,
    /// The same, of each change that no passage of its own stands for: only a bracket wider than two samples, or a touch, covers it.
    pub blurred: Vec<(u64, usize, f64)>,
    /// The same, of each passage of the monitor between whose samples there is no change, nor a second passage.
    pub false_alarms: Vec<(u64, usize, f64)>,
}

impl Findings {
    /// Both together.
    pub fn and(mut self, other: Findings) -> Findings {
        self.tries += other.tries;
        self.samples += other.samples;
        self.crossings += other.crossings;
        self.passages += other.passages;
        self.unseen += other.unseen;
        self.touches += other.touches;
        self.widest = self.widest.and(other.widest);
        self.lost.extend(other.lost);
        self.blurred.extend(other.blurred);
        self.false_alarms.extend(other.false_alarms);
        self
    }
}

/// How many figures are watched.
const FIGURES: usize = 4;

/// On which side of its threshold each figure is: det J, the margin, the manipulability, the wrist's factor.
fn sides(jacobian: &Jacobian<f64, 6>, [det, margin, volume, wrist]: [f64; FIGURES]) -> [bool; FIGURES] {
    let c = &jacobian.data.0;
    let value = cofactors(c);
    let [x, y, z] = [3, 4, 5].map(|i| [c[i][3], c[i][4], c[i][5]]);
    [value > det, positive_definite(c, margin), value.abs() > volume, triple(x, y, z) > wrist]
}

fn triple([a, b, c]: [f64; 3], [d, e, f]: [f64; 3], [g, h, i]: [f64; 3]) -> f64 {
    a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
}

/// Laplace's expansion by the linear rows: the sum over all ways of choosing three columns for them.
fn cofactors(c: &[[f64; 6]; 6]) -> f64 {
    let mut sum = 0.0;
    for i in 0..4 {
        for j in i + 1..5 {
            for k in j + 1..6 {
                let mut rest = [0; 3];
                let mut count = 0;
                for m in 0..6 {
                    if m != i && m != j && m != k {
                        rest[count] = m;
                        count += 1;
                    }
                }
                let upper = [i, j, k].map(|m| [c[m][0], c[m][1], c[m][2]]);
                let lower = rest.map(|m| [c[m][3], c[m][4], c[m][5]]);
                let sign = if (i + j + k) % 2 == 1 { 1.0 } else { -1.0 };
                sum += sign * triple(upper[0], upper[1], upper[2]) * triple(lower[0], lower[1], lower[2]);
            }
        }
    }
    sum
}

/// Whether JᵀJ - c²·1 is positive definite: whether every singular value is above c.
fn positive_definite(columns: &[[f64; 6]; 6], c: f64) -> bool {
    let mut m = [[0.0; 6]; 6];
    for i in 0..6 {
        for j in 0..=i {
            m[i][j] = (0..6).map(|k| columns[i][k] * columns[j][k]).sum();
        }
        m[i][i] -= c * c;
    }
    for i in 0..6 {
        for j in 0..=i {
            let rest = m[i][j] - (0..j).map(|k| m[i][k] * m[j][k]).sum::<f64>();
            if i == j {
                if rest <= 0.0 {
                    return false;
                }
                m[i][i] = rest.sqrt();
            } else {
                m[i][j] = rest / m[j][j];
            }
        }
    }
    true
}

/// The passages that the monitor finds of each figure.
fn watched<A: Factored<6>>(
    arm: &A,
    trajectory: &Trajectory<f64, 6>,
    at: [f64; FIGURES],
) -> [Vec<Crossing<f64, 6>>; FIGURES] {
    let watch = Watch::new(arm, trajectory);
    [
        watch.crossings(Measure::Determinant, at[0]).collect(),
        watch.crossings(Measure::Margin, at[1]).collect(),
        watch.crossings(Measure::Manipulability, at[2]).collect(),
        watch.factor_crossings(Factor::Wrist, at[3]).collect(),
    ]
}

/// One trajectory of one arm, sampled so many times finer than a controller samples it.
fn judge<A: Factored<6>>(arm: &A, random: &mut Sampler, trial: u64, finer: u64, found: &mut Findings) {
    let ends = [(); 2].map(|()| Joints::<f64, 6>::from(random.angles()));
    let limits = RateLimits::uniform(random.between(4.0, 16.0), random.between(20.0, 200.0));
    let shared = if random.below(2) == 0 { Shared::Duration } else { Shared::Phases };
    let trajectory = Trajectory::new(&ends[0], &ends[1], &limits, shared).expect("sound ends and limits");
    // Thresholds that the figures do pass: values that they have somewhere on the way, or 0.
    let watch = Watch::new(arm, &trajectory);
    let mut place = || watch.at(random.between(0.0, trajectory.duration()));
    let (one, two) = (place(), place());
    let wrist = watch.factors(one.state.time).wrist.expect("a wrist");
    let zero = random.below(2) == 0;
    let thresholds = [
        if zero { 0.0 } else { one.determinant.expect("six joints") },
        one.dexterity.margin,
        two.dexterity.manipulability,
        if zero { 0.0 } else { wrist },
    ];
    let passages = watched(arm, &trajectory, thresholds);
    found.tries += 1;

    let step = 1.0 / (RATE * finer as f64);
    let count = (trajectory.duration() / step) as u64;
    let mut changes: [Vec<f64>; FIGURES] = Default::default();
    let mut before = None;
    for k in 0..=count {
        let q = trajectory.at(k as f64 * step).q;
        let now = sides(&normalised(arm, &q), thresholds);
        if let Some(before) = before.replace(now) {
            for (figure, changes) in changes.iter_mut().enumerate() {
                if before[figure] != now[figure] {
                    changes.push(k as f64 * step);
                }
            }
        }
    }
    found.samples += count + 1;
    for (figure, (changes, passages)) in changes.iter().zip(&passages).enumerate() {
        compare((trial, figure), step, changes, passages, &trajectory, found);
    }
}

/// Matches changes of side between samples with passages between times.
fn compare(
    (trial, figure): (u64, usize),
    step: f64,
    changes: &[f64],
    passages: &[Crossing<f64, 6>],
    trajectory: &Trajectory<f64, 6>,
    found: &mut Findings,
) {
    found.crossings += changes.len() as u64;
    // Round-off of the samples themselves, where a figure is flat.
    let blur = 1e-7 * trajectory.duration();
    let inside = |change: f64, crossing: &Crossing<f64, 6>| {
        crossing.between.1 >= change - step - blur && crossing.between.0 <= change + blur
    };
    let own = |change: f64, crossing: &Crossing<f64, 6>| {
        let narrow = crossing.between.1 - crossing.between.0 <= 2.0 * step;
        narrow && crossing.passage != Passage::Touches && inside(change, crossing)
    };
    for change in changes {
        if !passages.iter().any(|crossing| inside(*change, crossing)) {
            found.lost.push((trial, figure, *change));
        } else if !passages.iter().any(|crossing| own(*change, crossing)) {
            found.blurred.push((trial, figure, *change));
        }
    }
    for crossing in passages {
        if crossing.passage == Passage::Touches {
            found.touches += 1;
            continue;
        }
        found.passages += 1;
        found.widest.see(
            (crossing.between.1 - crossing.between.0) / trajectory.duration(),
            10 * trial + figure as u64,
        );
        if changes.iter().any(|change| inside(*change, crossing)) {
            continue;
        }
        let near = |other: &&Crossing<f64, 6>| (other.time - crossing.time).abs() <= step + blur;
        if passages.iter().filter(near).count() > 1 {
            found.unseen += 1;
        } else if crossing.time + step < trajectory.duration() {
            found.false_alarms.push((trial, figure, crossing.time));
        }
    }
}

/// The tries from one number to another, each sampled so many times finer than at 20 Hz.
pub fn run(seed: u64, tries: std::ops::Range<u64>, finer: u64) -> Findings {
    let mut found = Findings::default();
    for trial in tries {
        let mut random = Sampler::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(trial));
        match trial % 4 {
            0 => judge(&robots::Puma560, &mut random, trial, finer, &mut found),
            1 => judge(&robots::LabArm, &mut random, trial, finer, &mut found),
            2 => judge(&robots::ElbowWrist, &mut random, trial, finer, &mut found),
            _ => judge(&robots::Irb2400, &mut random, trial, finer, &mut found),
        }
    }
    found
}
