//! Tasks 5 and 6: a synchronised trajectory at 20 Hz, and the check for singularities along it.

use kin_runtime::prelude::*;
use kin_runtime::trajectory::{RateLimits, Shape, Shared, State, Trajectory};

use super::super::parts::{Mistake, named};
use super::check;
use crate::html::{Page, Table, number, rough};
use crate::model::Model;
use crate::picture::{Look, Picture};
use crate::plot::{Plot, Series};
use crate::view::View;

/// From here to there, the third and sixth joint a short way only, so that both profiles occur; θ5 passes through 0.
const FROM: [f64; 6] = [-0.9, 0.3, -0.9, 0.6, 0.85, 0.1];
const TO: [f64; 6] = [0.83, 1.0, -1.1, -0.5, -0.45, 0.3];
/// Radians per second, and per second squared.
const VELOCITY: f64 = 1.0;
const ACCELERATION: f64 = 2.0;
/// The controller's rate, in Hz.
pub(super) const RATE: f64 = 20.0;

fn trajectory(shared: Shared) -> Option<Trajectory<f64, 6>> {
    let limits = RateLimits::uniform(VELOCITY, ACCELERATION);
    Trajectory::new(&Joints::from(FROM), &Joints::from(TO), &limits, shared).ok()
}

pub(super) fn tasks(page: &mut Page, model: &Model) {
    page.section("tasks-5-6", "Tasks 4–6: Jacobian, synchronised trajectory, singularity check");
    page.text(
        "Task 4, the Jacobian, is derived above. Task 5 moves all six joints between two poses in one time.",
    );
    let Some(trajectory) = trajectory(Shared::Duration) else { return };
    profiles(page, &trajectory);
    curves(page, model, &trajectory);
    check::task(page, &trajectory);
}

fn profiles(page: &mut Page, trajectory: &Trajectory<f64, 6>) {
    page.part("Task 5: the profiles");
    page.text(&format!(
        "From {} to {} rad, at most {VELOCITY} rad/s and {ACCELERATION} rad/s². A joint alone would need the time of the third \
         column; all take {} s, which no synchronised motion within these limits undercuts.",
        named("θ", &FROM),
        named("θ", &TO),
        number(trajectory.duration(), 4)
    ));
    let mut table = Table::new(&[
        "joint",
        "δ<sub>q</sub>, rad",
        "alone, s",
        "its own profile",
        "τ as printed, s",
        "τ true, s",
        "ramp here, s",
        "speed here, rad/s",
    ]);
    for (joint, profile) in trajectory.profiles().enumerate() {
        let way = (TO[joint] - FROM[joint]).abs();
        let triangular = (way * ACCELERATION).sqrt() <= VELOCITY;
        let (printed, tau) = match triangular {
            true => (way / VELOCITY, (way / ACCELERATION).sqrt()),
            false => (VELOCITY / ACCELERATION, VELOCITY / ACCELERATION),
        };
        let alone = if triangular { 2.0 * tau } else { way / VELOCITY + tau };
        let shape = if triangular { "triangular" } else { "trapezoidal" };
        table.row(
            "profile",
            vec![
                format!("{}", joint + 1),
                number(way, 4),
                number(alone, 4),
                shape.to_owned(),
                number(printed, 4),
                number(tau, 4),
                if profile.shape() == Shape::Still {
                    "at rest".to_owned()
                } else {
                    number(profile.ramp(), 4)
                },
                number(profile.velocity().abs(), 4),
            ],
        );
    }
    page.table(&table);
}

/// The samples of the trajectory, the exact end included.
fn samples(trajectory: &Trajectory<f64, 6>) -> Vec<State<f64, 6>> {
    trajectory.samples(RATE).map(Iterator::collect).unwrap_or_default()
}

/// One curve for each joint.
fn plot_of(label: &str, all: &[State<f64, 6>], value: impl Fn(&State<f64, 6>, usize) -> f64) -> Plot {
    (0..6).fold(Plot::new("time, s", label), |plot, joint| {
        let points = all.iter().map(|state| (state.time, value(state, joint))).collect();
        plot.series(Series::new(format!("joint {}", joint + 1), points))
    })
}

fn curves(page: &mut Page, model: &Model, trajectory: &Trajectory<f64, 6>) {
    let all = samples(trajectory);
    page.text(&format!(
        "At {RATE} Hz that is {} samples; the last is the end itself, at {} s, not the next multiple of 50 ms.",
        all.len(),
        number(all.last().map_or(0.0, |state| state.time), 6)
    ));
    let values = plot_of("joint values, rad", &all, |s, j| s.q[j]);
    let speeds = plot_of("velocity, rad/s", &all, |s, j| s.velocity[j])
        .level(VELOCITY, "limit")
        .level(-VELOCITY, "limit");
    let mut held = Plot::new("time, s", "acceleration, rad/s²");
    for joint in 0..6 {
        let points = all.iter().map(|state| (state.time, state.acceleration[joint])).collect();
        held = held.series(Series::new(format!("joint {}", joint + 1), points).stepped());
    }
    held = held.level(ACCELERATION, "limit").level(-ACCELERATION, "limit");
    let phases = self::trajectory(Shared::Phases).map(|t| samples(&t)).unwrap_or_default();
    let together = plot_of("velocity, rad/s", &phases, |s, j| s.velocity[j]);
    page.figure(
        "figure-trajectory",
        &[
            (values.draw(480.0, 310.0, "clip-q", "Joint values over time"), String::new()),
            (speeds.draw(480.0, 310.0, "clip-v", "Velocities over time"), String::new()),
            (held.draw(480.0, 310.0, "clip-a", "Accelerations over time"), String::new()),
            (
                together.draw(480.0, 310.0, "clip-phases", "Velocities over time, phases shared"),
                "The same motion with shared phases: all joints speed up and slow down together.".to_owned(),
            ),
        ],
        "The trajectory, sampled at 20 Hz.",
    );
    let end = model.body(&TO);
    let course: Vec<[f64; 3]> = (0..=120)
        .map(|k| trajectory.at(trajectory.duration() * f64::from(k) / 120.0))
        .map(|state| model.body(state.q.as_slice()).tip.origin)
        .collect();
    let mut picture = Picture::new(View::from(-25.0, 26.0), model.reach(), "m").arm(&end, Look::Solid);
    for part in [0.0, 0.35, 0.5, 0.65] {
        let state = trajectory.at(part * trajectory.duration());
        picture = picture.arm(&model.body(state.q.as_slice()), Look::Ghost);
    }
    let picture = picture.path(course, "path").target(end.tip.origin);
    page.figure(
        "figure-motion",
        &[(picture.draw(440.0, "The arm along its trajectory"), String::new())],
        "The arm on its way, and the course of the tool point.",
    );
}

/// The switching time of the triangular profile.
pub(super) fn triangle() -> Mistake {
    let (mut worst, mut count) = (0.0f64, 0);
    for joint in 0..6 {
        let way = (TO[joint] - FROM[joint]).abs();
        if (way * ACCELERATION).sqrt() <= VELOCITY {
            count += 1;
            // Up for τ, down for τ: the joint goes q̈·τ².
            let tau = way / VELOCITY;
            worst = worst.max((ACCELERATION * tau * tau - way).abs() / way);
        }
    }
    Mistake {
        key: "triangle",
        place: "5.1, triangular profile",
        printed: "τ = δ<sub>q</sub>/q̇<sub>max</sub>".to_owned(),
        truth: "τ = √(δ<sub>q</sub>/q̈<sub>max</sub>)".to_owned(),
        consequence: format!(
            "of the trajectory above {count} joints alone are triangular; with the printed τ one misses its end by {} of \
             its way",
            rough(worst)
        ),
    }
}

/// The start of the cruise.
pub(super) fn cruise() -> Mistake {
    let tau = VELOCITY / ACCELERATION;
    Mistake {
        key: "cruise",
        place: "5.1, trapezoidal profile, τ &lt; t ≤ T",
        printed: "q = q<sub>0</sub> + q̇ (t − τ)".to_owned(),
        truth: "q = q(τ) + q̇ (t − τ), with q(τ) = q<sub>0</sub> + q̈<sub>max</sub> τ²/2".to_owned(),
        consequence: format!(
            "each joint that cruises jumps back by {} rad at τ",
            rough(0.5 * ACCELERATION * tau * tau)
        ),
    }
}
