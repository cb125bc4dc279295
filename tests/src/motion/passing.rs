//! Crossings of thresholds along random trajectories, against a sampling that is thousands of times finer than the controller's.
//!
//! What the samples say is computed in [`super::sides`], in no way that the monitor knows.

use kin_runtime::Arm;
use kin_runtime::pose::Joints;
use kin_runtime::singularity::normalised;
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use kin_runtime::watch::{Crossing, Factor, Factored, Measure, Passage, Reading, Watch};

use super::Worst;
use super::sides::Figure;
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
    /// The widest bracket of a passage, in parts of the duration.
    pub widest: Worst,
    /// Trial, figure and time of each change that the monitor did not find.
    pub lost: Vec<(u64, Figure, f64)>,
    /// The same, of each change that no passage of its own stands for: only a bracket wider than two samples, a touch, or one that goes the
    /// other way, covers it.
    pub blurred: Vec<(u64, Figure, f64)>,
    /// The same, of each passage of the monitor between whose samples there is no change, nor a second passage.
    pub false_alarms: Vec<(u64, Figure, f64)>,
}

impl Findings {
    /// The promises that are not kept: every change of side has a passage of its own, in a narrow bracket, and every passage is one.
    pub fn broken(&self) -> Vec<String> {
        let told = |name: &str, list: &[(u64, Figure, f64)]| {
            (!list.is_empty())
                .then(|| format!("{name}: {} of {} changes: {list:?}", list.len(), self.crossings))
        };
        let lists = [("lost", &self.lost), ("blurred", &self.blurred), ("false alarms", &self.false_alarms)];
        lists.into_iter().filter_map(|(name, list)| told(name, list)).collect()
    }

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

/// A figure, its threshold, and the passages that the monitor finds.
type Watched<const N: usize> = (Figure, f64, Vec<Crossing<f64, N>>);

/// A random trajectory; as fast as it is so that the samples are few.
fn random_trajectory<const N: usize>(random: &mut Sampler) -> Trajectory<f64, N> {
    let ends = [(); 2].map(|()| Joints::<f64, N>::from(random.angles()));
    let limits = RateLimits::uniform(random.between(4.0, 16.0), random.between(20.0, 200.0));
    let shared = if random.below(2) == 0 { Shared::Duration } else { Shared::Phases };
    Trajectory::new(&ends[0], &ends[1], &limits, shared).expect("sound ends and limits")
}

/// The margin and the manipulability, at thresholds that they do pass: values that they have somewhere on the way.
fn values<const N: usize, A: Arm<N>>(
    watch: &Watch<'_, A, f64, N>,
    random: &mut Sampler,
) -> [(Reading<f64, N>, Watched<N>); 2] {
    let mut place = || watch.at(random.between(0.0, watch.trajectory().duration()));
    let (one, two) = (place(), place());
    let (margin, volume) = (one.dexterity.margin, two.dexterity.manipulability);
    [
        (one, (Figure::Margin, margin, watch.crossings(Measure::Margin, margin).collect())),
        (two, (Figure::Manipulability, volume, watch.crossings(Measure::Manipulability, volume).collect())),
    ]
}

/// All figures of an arm with a spherical wrist: the determinant and the wrist's factor at 0 too.
fn wristed<A: Factored<6>>(arm: &A, random: &mut Sampler, trial: u64, finer: u64, found: &mut Findings) {
    let trajectory = random_trajectory(random);
    let watch = Watch::new(arm, &trajectory);
    let [(place, margin), (_, volume)] = values(&watch, random);
    let wrist = watch.factors(place.state.time).wrist.expect("a wrist");
    let det = if random.below(2) == 0 { 0.0 } else { place.determinant.expect("six joints") };
    let wrist = if random.below(2) == 0 { 0.0 } else { wrist };
    let det = (Figure::Determinant, det, watch.crossings(Measure::Determinant, det).collect());
    let wrist = (Figure::Wrist, wrist, watch.factor_crossings(Factor::Wrist, wrist).collect());
    judge(&watch, arm, 6, &[det, margin, volume, wrist], (trial, finer), found);
}

/// What an arm has whose Jacobian is not square.
fn oblong<const N: usize, A: Arm<N>>(
    arm: &A,
    rows: usize,
    random: &mut Sampler,
    (trial, finer): (u64, u64),
    found: &mut Findings,
) {
    let trajectory = random_trajectory(random);
    let watch = if rows == 6 { Watch::new(arm, &trajectory) } else { Watch::of_position(arm, &trajectory) };
    let watched = values(&watch, random).map(|(_, watched)| watched);
    judge(&watch, arm, rows, &watched, (trial, finer), found);
}

/// Samples a trajectory so many times finer than a controller does.
fn judge<const N: usize, A: Arm<N>>(
    watch: &Watch<'_, A, f64, N>,
    arm: &A,
    rows: usize,
    watched: &[Watched<N>],
    (trial, finer): (u64, u64),
    found: &mut Findings,
) {
    let step = 1.0 / (RATE * finer as f64);
    let trajectory = watch.trajectory();
    let count = (trajectory.duration() / step) as u64;
    let mut changes = vec![Vec::new(); watched.len()];
    let mut before = vec![None; watched.len()];
    for k in 0..=count {
        let jacobian = normalised(arm, &trajectory.at(k as f64 * step).q);
        for (index, (figure, threshold, _)) in watched.iter().enumerate() {
            let now = figure.above(&jacobian.data.0, rows, *threshold);
            if before[index].replace(now).is_some_and(|before| before != now) {
                changes[index].push((k as f64 * step, now));
            }
        }
    }
    found.tries += 1;
    found.samples += count + 1;
    for (changes, (figure, _, passages)) in changes.iter().zip(watched) {
        compare((trial, *figure), step, changes, passages, trajectory, found);
    }
}

/// Matches changes of side between samples with passages between times.
fn compare<const N: usize>(
    (trial, figure): (u64, Figure),
    step: f64,
    changes: &[(f64, bool)],
    passages: &[Crossing<f64, N>],
    trajectory: &Trajectory<f64, N>,
    found: &mut Findings,
) {
    found.crossings += changes.len() as u64;
    // Round-off of the samples themselves, where a figure is flat.
    let blur = 1e-7 * trajectory.duration();
    let inside = |change: f64, crossing: &Crossing<f64, N>| {
        crossing.between.1 >= change - step - blur && crossing.between.0 <= change + blur
    };
    let own = |change: f64, rises: bool, crossing: &Crossing<f64, N>| {
        let narrow = crossing.between.1 - crossing.between.0 <= 2.0 * step;
        let passage = if rises { Passage::Rises } else { Passage::Falls };
        narrow && crossing.passage == passage && inside(change, crossing)
    };
    for (change, rises) in changes {
        if !passages.iter().any(|crossing| inside(*change, crossing)) {
            found.lost.push((trial, figure, *change));
        } else if !passages.iter().any(|crossing| own(*change, *rises, crossing)) {
            found.blurred.push((trial, figure, *change));
        }
    }
    for crossing in passages {
        if crossing.passage == Passage::Touches {
            found.touches += 1;
            continue;
        }
        found.passages += 1;
        found.widest.see((crossing.between.1 - crossing.between.0) / trajectory.duration(), trial);
        if changes.iter().any(|(change, _)| inside(*change, crossing)) {
            continue;
        }
        let near = |other: &&Crossing<f64, N>| (other.time - crossing.time).abs() <= step + blur;
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
        match trial % 6 {
            0 => wristed(&robots::Puma560, &mut random, trial, finer, &mut found),
            1 => wristed(&robots::LabArm, &mut random, trial, finer, &mut found),
            2 => wristed(&robots::ElbowWrist, &mut random, trial, finer, &mut found),
            3 => wristed(&robots::Irb2400, &mut random, trial, finer, &mut found),
            4 => oblong(&robots::Panda, 6, &mut random, (trial, finer), &mut found),
            _ => oblong(&robots::Irb2400, 3, &mut random, (trial, finer), &mut found),
        }
    }
    found
}
