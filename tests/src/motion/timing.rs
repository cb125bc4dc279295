//! Random trajectories: whether they keep their limits, arrive, and are as short as bang-bang control lets them be.

use kin_runtime::pose::Joints;
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};

use super::Worst;
use crate::sample::Sampler;

/// Joints of a random trajectory.
const N: usize = 6;

/// What was found.
#[derive(Clone, Copy, Default, Debug, PartialEq)]
pub struct Findings {
    /// How many trajectories.
    pub tries: u64,
    /// Joints that moved in a triangle, in a trapezoid, and not at all.
    pub shapes: [u64; 3],
    /// By how much a velocity, relative to its limit, passed it.
    pub velocity: Worst,
    /// The same for an acceleration.
    pub acceleration: Worst,
    /// By how many units in the last place the end was missed.
    pub end: Worst,
    /// By how much a duration differed from the optimum, relative to it: longer, and shorter.
    pub longer: Worst,
    /// See `longer`.
    pub shorter: Worst,
    /// How far positions are from the integral of the velocities, and these from that of the accelerations: relative to the way
    /// and the size of the ends, and to the peak.
    pub drift: Worst,
}

impl Findings {
    /// Both together.
    pub fn and(self, other: Findings) -> Findings {
        let [a, b, c] = self.shapes;
        let [x, y, z] = other.shapes;
        Findings {
            tries: self.tries + other.tries,
            shapes: [a + x, b + y, c + z],
            velocity: self.velocity.and(other.velocity),
            acceleration: self.acceleration.and(other.acceleration),
            end: self.end.and(other.end),
            longer: self.longer.and(other.longer),
            shorter: self.shorter.and(other.shorter),
            drift: self.drift.and(other.drift),
        }
    }

    /// The promises that are not kept: limits to 1e-12, the end to one unit, durations to 1e-9, all relative.
    pub fn broken(&self) -> Vec<String> {
        let figures = [
            ("velocity", self.velocity, 1e-12),
            ("acceleration", self.acceleration, 1e-12),
            ("end", self.end, 1.0),
            ("longer", self.longer, 1e-9),
            ("shorter", self.shorter, 1e-12),
            ("drift", self.drift, 1e-12),
        ];
        let bad = figures.iter().filter(|(_, worst, most)| worst.figure.is_nan() || worst.figure > *most);
        bad.map(|(name, worst, most)| format!("{name}: {worst:?} is more than {most:e}")).collect()
    }
}

/// One joint: where from, where to, and its limits.
#[derive(Clone, Copy, Debug)]
struct Task {
    from: f64,
    to: f64,
    velocity: f64,
    acceleration: f64,
}

impl Task {
    fn random(random: &mut Sampler) -> Task {
        let mut power = |low: f64, high: f64| 10_f64.powf(random.between(low, high));
        let (velocity, acceleration) = (power(-3.0, 3.0), power(-3.0, 3.0));
        // Ways of all sizes; those at the border of triangle and trapezoid, where a root loses its digits; and none.
        let border = velocity * velocity / acceleration;
        let tiny = power(-17.0, -6.0);
        let any = power(-12.0, 4.0);
        let way = match random.below(8) {
            0 => 0.0,
            1 => border,
            2 => border * (1.0 + tiny),
            3 => border * (1.0 - tiny),
            _ => any,
        };
        let from = if random.below(3) == 0 { 0.0 } else { random.between(-3.0, 3.0) };
        let to = if random.below(2) == 0 { from + way } else { from - way };
        Task { from, to, velocity, acceleration }
    }

    fn way(&self) -> f64 {
        (self.to - self.from).abs()
    }
}

/// How far one gets in a time, from rest to rest: the area under the largest velocity that both ramps and the limit allow.
fn reached(time: f64, velocity: f64, acceleration: f64) -> f64 {
    let peak = velocity.min(0.5 * acceleration * time);
    peak * (time - peak / acceleration)
}

/// The shortest time in which all of the ways are gone, by bisection; `together` if each joint must be in proportion.
fn optimum(tasks: &[Task; N], sync: Shared) -> f64 {
    let moving = || tasks.iter().filter(|task| task.way() > 0.0);
    let least = |limit: fn(&Task) -> f64| moving().map(|t| limit(t) / t.way()).fold(f64::INFINITY, f64::min);
    let arrived = |time: f64| match sync {
        Shared::Duration => moving().all(|t| reached(time, t.velocity, t.acceleration) >= t.way()),
        Shared::Phases => reached(time, least(|t| t.velocity), least(|t| t.acceleration)) >= 1.0,
    };
    if moving().next().is_none() {
        return 0.0;
    }
    let mut high = 1e-9;
    while !arrived(high) {
        high *= 2.0;
    }
    let mut low = 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if arrived(middle) { high = middle } else { low = middle }
    }
    high
}

/// The distance between two numbers in units in the last place of the second.
fn units(a: f64, b: f64) -> f64 {
    if a.to_bits() == b.to_bits() {
        0.0
    } else {
        (a - b).abs() / (b.abs() * f64::EPSILON).max(f64::MIN_POSITIVE)
    }
}

/// One trajectory.
fn judge(trial: u64, seed: u64, found: &mut Findings) {
    let mut random = Sampler::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(trial));
    let tasks: [Task; N] = std::array::from_fn(|_| Task::random(&mut random));
    let sync = if random.below(2) == 0 { Shared::Duration } else { Shared::Phases };
    let column = |of: fn(&Task) -> f64| Joints::<f64, N>::from_iterator(tasks.iter().map(of));
    let limits = RateLimits { velocity: column(|t| t.velocity), acceleration: column(|t| t.acceleration) };
    let trajectory = Trajectory::new(&column(|t| t.from), &column(|t| t.to), &limits, sync)
        .unwrap_or_else(|error| panic!("{trial}: {error}"));
    found.tries += 1;
    let (duration, best) = (trajectory.duration(), optimum(&tasks, sync));
    if best > 0.0 {
        found.longer.see((duration - best) / best, trial);
        found.shorter.see((best - duration) / best, trial);
    }
    for (joint, task) in tasks.iter().enumerate() {
        let profile = trajectory.profile(joint).expect("a joint");
        found.shapes[profile.shape() as usize] += 1;
        // The instants at which something changes, those beside them, and some between.
        let mut times = vec![0.0, profile.ramp(), profile.braking(), duration, 0.5 * duration];
        times.extend(times.clone().iter().flat_map(|t: &f64| [t.next_up(), t.next_down().max(0.0)]));
        times.extend((0..16).map(|_| random.between(0.0, duration.max(f64::MIN_POSITIVE))));
        times.sort_by(f64::total_cmp);
        let states: Vec<_> = times.iter().map(|time| trajectory.at(*time)).collect();
        let (scale, peak) = (task.way() + task.from.abs() + task.to.abs(), profile.velocity().abs());
        for state in &states {
            found.velocity.see(state.velocity[joint].abs() / task.velocity - 1.0, trial);
            found.acceleration.see(state.acceleration[joint].abs() / task.acceleration - 1.0, trial);
        }
        // Velocities are linear from one instant to the next, so that the trapezoidal rule is exact.
        for pair in states.windows(2) {
            let step = pair[1].time - pair[0].time;
            let way = 0.5 * step * (pair[0].velocity[joint] + pair[1].velocity[joint]);
            if scale > 0.0 {
                found.drift.see((pair[1].q[joint] - pair[0].q[joint] - way).abs() / scale, trial);
            }
            let rise = step * pair[0].acceleration[joint];
            if peak > 0.0 && pair[1].time < duration {
                let off = (pair[1].velocity[joint] - pair[0].velocity[joint] - rise).abs();
                // A ramp can be so steep that the rounding of the time itself moves the velocity.
                let blur = 4.0
                    * f64::EPSILON
                    * duration
                    * pair[0].acceleration[joint].abs().max(pair[1].acceleration[joint].abs());
                found.drift.see((off - blur) / peak, trial);
            }
        }
        found.end.see(units(trajectory.at(duration).q[joint], task.to), trial);
        found.end.see(trajectory.at(duration).velocity[joint].abs(), trial);
    }
}

/// The tries from one number to another.
pub fn run(seed: u64, tries: std::ops::Range<u64>) -> Findings {
    let mut found = Findings::default();
    for trial in tries {
        judge(trial, seed, &mut found);
    }
    found
}
