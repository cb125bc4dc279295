//! The singularity monitor: ranges that hold, crossings that a finer sampling finds, factors that are those of det J.

use kin_runtime::pose::Joints;
use kin_runtime::prelude::*;
use kin_runtime::singularity::{determinant, normalised, position_determinant};
use kin_runtime::trajectory::{RateLimits, Shared, Trajectory};
use kin_runtime::watch::{Crossing, Factor, Factored, Measure, Passage, Watch};
use kin_runtime::{JointKind, dexterity};
use tests::motion::passing;
use tests::sample::Sampler;

dh! {
    /// Couplings as some wrists and parallelograms have them.
    struct Coupled(standard, m, deg);
    | joint | alpha |  a  |  d  | theta |
    |-------|-------|-----|-----|-------|
    | J1    |  90   | 0.1 | 0.4 | q     |
    | J2    |   0   | 0.5 | 0   | q     |
    | J3    |  90   | 0.1 | 0   | q     |
    | J4    | -90   | 0   | 0.6 | q     |
    | J5    |  90   | 0   | 0   | q     |
    | J6    |   0   | 0   | 0.1 | q     |
    couple: J3 -= J2, J5 -= J4, J6 -= 2*J5;
}

/// Without optimisation a search takes a second.
const SLOW: bool = cfg!(debug_assertions);

/// Trajectories of each arm.
const TRAJECTORIES: usize = if SLOW { 3 } else { 40 };

const MEASURES: [Measure; 3] = [Measure::Margin, Measure::Manipulability, Measure::Determinant];

/// Between random joint vectors; slides between 0 and the arm's reach.
fn between<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) -> Trajectory<f64, N> {
    let mut ends = [(); 2].map(|()| Joints::from(random.angles::<N>()));
    for q in &mut ends {
        for (joint, x) in A::JOINTS.iter().zip(q.iter_mut()) {
            if joint.kind == JointKind::Prismatic {
                *x = (*x + 3.2) / 6.4 * arm.reach();
            }
        }
    }
    let limits = RateLimits::uniform(random.between(0.5, 3.0), random.between(1.0, 9.0));
    let shared = if random.below(2) == 0 { Shared::Duration } else { Shared::Phases };
    Trajectory::new(&ends[0], &ends[1], &limits, shared).expect("ends and limits are sound")
}

/// The widest range, and the narrowest, in parts of what was needed.
fn ranges_hold<const N: usize, A: Arm<N>>(arm: &A, random: &mut Sampler) {
    for _ in 0..TRAJECTORIES {
        let trajectory = between(arm, random);
        let watch = Watch::new(arm, &trajectory);
        for _ in 0..10 {
            let width = trajectory.duration() * 10_f64.powf(random.between(-4.0, 0.0));
            let from = random.between(0.0, trajectory.duration() - width);
            for measure in MEASURES {
                let (low, high) = watch.range(measure, from, from + width);
                for k in 0..=20 {
                    let reading = watch.at(from + width * f64::from(k) / 20.0);
                    let value = match measure {
                        Measure::Margin => reading.dexterity.margin,
                        Measure::Manipulability => reading.dexterity.manipulability,
                        Measure::Determinant => {
                            reading.determinant.unwrap_or(reading.dexterity.manipulability)
                        }
                    };
                    assert!(low - 1e-13 <= value && value <= high + 1e-13, "{} {measure:?} {width}", A::NAME);
                }
            }
        }
    }
}

fn factors_hold<const N: usize, A: Factored<N>>(arm: &A, random: &mut Sampler) -> f64 {
    let mut tightest = f64::INFINITY;
    for _ in 0..TRAJECTORIES {
        let trajectory = between(arm, random);
        let watch = Watch::new(arm, &trajectory);
        for _ in 0..10 {
            let width = trajectory.duration() * 10_f64.powf(random.between(-4.0, 0.0));
            let from = random.between(0.0, trajectory.duration() - width);
            for factor in Factor::ALL {
                let Some((low, high)) = watch.factor_range(factor, from, from + width) else { continue };
                let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
                for k in 0..=20 {
                    let value = watch.factors(from + width * f64::from(k) / 20.0).get(factor).expect("known");
                    assert!(low - 1e-13 <= value && value <= high + 1e-13, "{} {factor:?} {width}", A::NAME);
                    (least, most) = (least.min(value), most.max(value));
                }
                if most - least > 1e-9 {
                    tightest = tightest.min((high - low) / (most - least));
                }
            }
        }
    }
    tightest
}

macro_rules! every_range {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        fn all_ranges(random: &mut Sampler) {
            $(ranges_hold(&robots::$Arm, random);)*
        }
    };
}
robots::for_each!(every_range);

#[test]
fn figures_stay_in_their_ranges() {
    let mut random = Sampler::new(81);
    all_ranges(&mut random);
    ranges_hold(&Coupled, &mut random);
    let mut tightest = f64::INFINITY;
    for _ in 0..4 {
        tightest = tightest.min(factors_hold(&robots::Puma560, &mut random));
        factors_hold(&robots::Stanford, &mut random);
        factors_hold(&robots::LabRrr, &mut random);
        factors_hold(&robots::Rv4fr, &mut random);
        factors_hold(&Coupled, &mut random);
    }
    // Where a figure moves evenly its range is hardly wider than need be.
    assert!(tightest < 1.1, "{tightest}");
}

fn product<A: Factored<6>>(arm: &A, random: &mut Sampler) {
    for _ in 0..300 {
        let q = between(arm, random).to().to_owned();
        let (factors, whole) = (arm.factors(&q), determinant(&normalised(arm, &q)).expect("six joints"));
        assert!((factors.determinant() - whole).abs() < 1e-14, "{}: {factors:?} {whole}", A::NAME);
        assert!((whole.abs() - dexterity(arm, &q).manipulability).abs() < 1e-14);
        if let (Some(shoulder), Some(elbow)) = (factors.shoulder, factors.elbow) {
            assert_eq!(factors.base, shoulder * elbow);
        }
    }
}

#[test]
fn factors_are_those_of_the_determinant() {
    let mut random = Sampler::new(82);
    product(&robots::Puma560, &mut random);
    product(&robots::LabArm, &mut random);
    product(&robots::ElbowWrist, &mut random);
    product(&robots::Stanford, &mut random);
    product(&robots::Kr6R700, &mut random);
    product(&robots::Gp7, &mut random);
    product(&Coupled, &mut random);
    for _ in 0..300 {
        let q = Joints::from(random.angles());
        let whole = position_determinant(&normalised(&robots::LabRrr, &q)).expect("three joints");
        let factors = robots::LabRrr.factors(&q);
        assert!((factors.determinant() - whole).abs() < 1e-15 && factors.wrist.is_none());
    }
}

/// Each factor is what the solver's margins measure in its own terms.
#[test]
fn factors_vanish_with_the_margins_of_solutions() {
    let (arm, mut random) = (robots::Puma560, Sampler::new(83));
    for _ in 0..300 {
        let q = Joints::from(random.angles());
        let factors = arm.factors(&q);
        let solutions = arm.ik(&arm.fk(&q));
        let Some(solution) = solutions.nearest(&q).filter(|s| (s.q - q).amax() < 1e-9) else { continue };
        let (margins, reach) = (solution.margins, arm.reach());
        let [shoulder, elbow, wrist] = [factors.shoulder, factors.elbow, factors.wrist].map(Option::unwrap);
        assert!((shoulder.abs() - margins.shoulder / reach).abs() < 1e-12);
        let links = 0.4318 * 0.0203_f64.hypot(0.4318) / (reach * reach);
        assert!((elbow.abs() - links * margins.elbow.sin()).abs() < 1e-12);
        assert!((wrist.abs() - margins.wrist.unwrap().sin()).abs() < 1e-12);
    }
}

#[test]
fn a_wrist_that_passes_straight_is_found_at_its_time() {
    // Joint 5 alone goes through 0: the time is that of its profile, 0.4 of the way at full speed.
    let (from, to) = (joints![0.3, -0.8, 0.6, 0.4, -0.4, 0.2], joints![0.3, -0.8, 0.6, 0.4, 0.6, 0.2]);
    let limits = RateLimits::uniform(0.5, 1.0);
    let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration).expect("sound");
    let watch = Watch::new(&robots::Puma560, &trajectory);
    let all: Vec<_> = watch.factor_crossings(Factor::Wrist, 0.0).collect();
    let [crossing] = all.as_slice() else { panic!("{all:?}") };
    // 1/2·0.5²/1 rad on the ramp of 0.5 s, and 0.275 rad at 0.5 rad/s.
    assert!((crossing.time - 1.05_f64).abs() < 1e-9 && f64::abs(crossing.q[4]) < 1e-9, "{crossing:?}");
    assert_eq!(crossing.to_string(), "t = 1.050000 s: the wrist factor falls below 0");
    let signs: Vec<_> = watch.crossings(Measure::Determinant, 0.0).map(|c| (c.passage, c.time)).collect();
    assert!(matches!(signs.as_slice(), [(_, time)] if f64::abs(time - 1.05) < 1e-9), "{signs:?}");
    // The smallest singular value only touches 0, and no threshold is passed by what only touches it.
    let touches: Vec<_> = watch.crossings(Measure::Margin, 0.0).collect();
    assert!(touches.iter().all(|c| c.passage == Passage::Touches) && touches.len() == 1, "{touches:?}");

    let spells: Vec<_> = watch.factor_spells(Factor::Wrist, 0.1).collect();
    let [spell] = spells.as_slice() else { panic!("{spells:?}") };
    let aside = 0.1_f64.asin() / 0.5;
    assert!((spell.from - 1.05 + aside).abs() < 1e-9 && (spell.to - 1.05 - aside).abs() < 1e-9, "{spell:?}");
    assert!(spell.least < 1e-9 && (spell.at - 1.05).abs() < 1e-6, "{spell:?}");
    let words = spell.to_string();
    assert!(
        words.starts_with("SINGULARITY: from t = 0.850 s to t = 1.250 s the wrist is nearly straight"),
        "{words}"
    );
}

#[test]
fn what_stays_on_a_threshold_ends_in_bounded_time() {
    // The wrist is straight from beginning to end, while every other joint moves.
    let (from, to) = (joints![0.3, -0.8, 0.6, 0.4, 0.0, 0.2], joints![-0.3, -0.1, 1.1, 0.9, 0.0, -1.2]);
    let limits = RateLimits::uniform(1.0, 2.0);
    let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration).expect("sound");
    let watch = Watch::new(&robots::Puma560, &trajectory);
    let touched: Vec<_> = watch.factor_crossings(Factor::Wrist, 0.0).collect();
    assert!(
        matches!(touched.as_slice(), [c] if c.passage == Passage::Touches && c.between == (0.0, trajectory.duration()))
    );
    let spells: Vec<_> = watch.spells(Measure::Margin, 1e-6).collect();
    assert!(
        matches!(spells.as_slice(), [s] if s.from == 0.0 && s.to == trajectory.duration() && s.least < 1e-15)
    );
    // Only joint 1 moves: singular values stay, though J does not.
    let to = joints![1.3, -0.8, 0.6, 0.4, 0.5, 0.2];
    let from = joints![-0.3, -0.8, 0.6, 0.4, 0.5, 0.2];
    let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration).expect("sound");
    let watch = Watch::new(&robots::Puma560, &trajectory);
    let (margin, elbow) = (watch.at(0.0).dexterity.margin, watch.factors(0.0).elbow.expect("an elbow"));
    let beside = [1.0, 1.0 + 1e-12, 1.0 - 1e-12, f64::NAN, f64::INFINITY];
    for by in beside {
        assert!(watch.factor_crossings(Factor::Elbow, elbow * by).all(|c| c.passage == Passage::Touches));
    }
    // Singular values cost a hundred times as much, and most without optimisation.
    for by in beside.into_iter().skip(if SLOW { 3 } else { 0 }) {
        assert!(watch.crossings(Measure::Margin, margin * by).all(|c| c.passage == Passage::Touches));
    }
    // Nothing moves.
    let still = Trajectory::new(&from, &from, &limits, Shared::Duration).expect("sound");
    let watch = Watch::new(&robots::Puma560, &still);
    assert_eq!(watch.crossings(Measure::Margin, margin).count(), 0);
    assert_eq!(watch.spells(Measure::Margin, 2.0 * margin).count(), 1);
}

/// Times at which a figure turns, found by plain search: where three samples have the least, or the most, in the middle.
fn turns(duration: f64, figure: &impl Fn(f64) -> f64) -> Vec<(f64, bool)> {
    let step = duration / 400.0;
    let mut found = Vec::new();
    for k in 1..400 {
        let [a, b, c] = [k - 1, k, k + 1].map(|k| figure(f64::from(k) * step));
        for (least, turns) in [(true, b < a && b < c), (false, b > a && b > c)] {
            let (mut low, mut high) = (f64::from(k - 1) * step, f64::from(k + 1) * step);
            for _ in 0..if turns { 100 } else { 0 } {
                let third = (high - low) / 3.0;
                let earlier = figure(low + third) < figure(high - third);
                if earlier == least { high -= third } else { low += third }
            }
            if turns {
                found.push((low, least));
            }
        }
    }
    found
}

/// The promise where a figure only just reaches a threshold: by more than round-off, two crossings, each by itself; if it stays away
/// by more, none; in between both or none, and touches at most. No bracket is wider than round-off makes it.
fn just_reaches<const N: usize, A: Arm<N>>(arm: &A, oriented: bool, random: &mut Sampler) -> usize {
    let trajectory = between(arm, random);
    let watch = if oriented { Watch::new(arm, &trajectory) } else { Watch::of_position(arm, &trajectory) };
    let mut judged = 0;
    for measure in [Measure::Margin, Measure::Manipulability] {
        let figure = |time: f64| {
            let dexterity = watch.at(time).dexterity;
            if measure == Measure::Margin { dexterity.margin } else { dexterity.manipulability }
        };
        let turns = turns(trajectory.duration(), &figure);
        for (index, (at, least)) in turns.iter().copied().enumerate().take(if SLOW { 1 } else { 2 }) {
            // Up to the turns before and after it; both farther from the threshold than the largest step below.
            let (before, after) = (index.checked_sub(1).and_then(|k| turns.get(k)), turns.get(index + 1));
            let (start, end) = (before.map_or(0.0, |t| t.0), after.map_or(trajectory.duration(), |t| t.0));
            let turn = figure(at);
            if turn < 1e-6 || [start, end].iter().any(|time| (figure(*time) - turn).abs() < 2e-6) {
                continue;
            }
            judged += 1;
            for power in [6, 14, 9, 12, 15].into_iter().take(if SLOW { 2 } else { 5 }) {
                for by in [10_f64.powi(-power), -(10_f64.powi(-power))] {
                    let threshold = if least { turn + by } else { turn - by };
                    let here = |c: &Crossing<f64, N>| c.time > start && c.time < end;
                    let passages: Vec<_> = watch.crossings(measure, threshold).filter(here).collect();
                    let told = format!("{} {measure:?} {threshold} ± {by:e} at {at}: {passages:?}", A::NAME);
                    let wide = passages.iter().map(|c| c.between.1 - c.between.0).fold(0.0, f64::max);
                    assert!(wide <= 1e-5 * trajectory.duration(), "{told}");
                    let (sure, touches): (Vec<_>, Vec<_>) =
                        passages.iter().map(|c| c.passage).partition(|p| *p != Passage::Touches);
                    let both = if least {
                        [Passage::Falls, Passage::Rises]
                    } else {
                        [Passage::Rises, Passage::Falls]
                    };
                    assert!(sure == both || sure.is_empty(), "{told}");
                    assert!(power > 12 || sure.is_empty() == (by < 0.0), "{told}");
                    assert!(power > 9 || touches.is_empty(), "{told}");
                }
            }
        }
    }
    judged
}

#[test]
fn what_only_just_reaches_a_threshold_is_told_to_round_off() {
    let (mut random, mut judged) = (Sampler::new(84), 0);
    while judged < if SLOW { 2 } else { 25 } {
        judged += just_reaches(&robots::Irb2400, false, &mut random);
        judged += just_reaches(&robots::Cobra600, true, &mut random);
        if !SLOW {
            judged += just_reaches(&robots::Puma560, true, &mut random);
            judged += just_reaches(&Coupled, true, &mut random);
            judged += just_reaches(&robots::Panda, true, &mut random);
        }
    }
}

#[test]
fn a_start_on_the_threshold_opens_a_spell_or_none() {
    let limits = RateLimits::uniform(1.0, 2.0);
    let bent = |q5: f64| joints![0.3, -0.8, 0.6, 0.4, q5, 0.2];
    for (from, to, spells) in [(0.5, 0.1, 1), (0.5, 0.9, 1), (0.1, 0.5, 1), (0.1, 0.9, 1), (0.9, 0.6, 0)] {
        let trajectory = Trajectory::new(&bent(from), &bent(to), &limits, Shared::Duration).expect("sound");
        let watch = Watch::new(&robots::Puma560, &trajectory);
        let found: Vec<_> = watch.factor_spells(Factor::Wrist, 0.5_f64.sin()).collect();
        assert_eq!(found.len(), spells, "{from} {to} {found:?}");
        let lasting: f64 = found.iter().map(|spell| spell.to - spell.from).sum();
        let share = if to < 0.5 || from < 0.5 { 1.0 } else { 0.0 };
        assert!(
            lasting <= share * trajectory.duration() + 1e-5 && lasting >= 0.4 * share * trajectory.duration()
        );
    }
}

#[test]
fn no_crossing_of_a_finer_sampling_is_lost() {
    let tries = if SLOW { 8 } else { 100 };
    let found = passing::run(1, 0..tries, if SLOW { 100 } else { 1_000 });
    println!("{found:?}");
    assert_eq!(found.broken(), Vec::<String>::new(), "{found:?}");
    assert!(found.crossings > 2 * tries, "{found:?}");
}
