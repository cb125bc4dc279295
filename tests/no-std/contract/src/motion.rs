//! The tasks of motion: trajectories, the singularity monitor, velocities and forces.

use core::hint::black_box;

use kin_runtime::prelude::*;
use kin_runtime::rates::{Damping, acceleration, jacobian_rate, position_rates, rates, torques, twist};
use kin_runtime::singularity::{determinant, normalised, position_determinant, scaled, singular_values};
use kin_runtime::trajectory::{RateLimits, Route, Shared, Ticks, ToolLimits, ToolPath, Trajectory};
use kin_runtime::watch::{Factor, Factored, Measure, Watch};
use robots::{LabArm, LabRrr, Panda, Puma560};

use crate::tasks::{Ball, Inputs, Number, Run};

fn number(x: f64) -> Number {
    black_box(<Number as Real>::lit(x))
}

/// Trajectories and routes of joints, and straight lines and arcs of the tool: made, read and sampled.
pub fn trajectory(inputs: &mut Inputs, measure: Run<'_>) {
    let stops = [inputs.joints::<6>(), inputs.joints::<6>(), inputs.joints::<6>()];
    let [from, to, third] = &stops;
    let limits = RateLimits::uniform(number(1.0), number(2.0));
    measure(&mut || {
        let sync = black_box(Shared::Phases);
        let long = Trajectory::lasting(from, to, &limits, sync, number(1e3));
        for trajectory in [Trajectory::new(from, to, black_box(&limits), sync), long].into_iter().flatten() {
            let _ = black_box((
                trajectory.duration(),
                trajectory.from(),
                trajectory.to(),
                trajectory.at(number(0.3)),
            ));
            if let Some(profile) = trajectory.profile(black_box(7)).or_else(|| trajectory.profiles().next()) {
                black_box((
                    profile.from(),
                    profile.to(),
                    profile.ramp(),
                    profile.braking(),
                    profile.duration(),
                ));
                black_box((
                    profile.velocity(),
                    profile.acceleration(),
                    profile.shape(),
                    profile.at(number(0.3)),
                ));
            }
            let slowed = trajectory.slowed(number(1.5));
            if let Ok(samples) = trajectory.samples(number(20.0)) {
                black_box((samples.size_hint(), slowed.is_ok()));
                samples.take(8).for_each(|state| _ = black_box(state));
            }
        }
        if let Ok(route) = Route::new(black_box(&stops), &limits, sync) {
            black_box(route.duration());
            route.legs().for_each(|leg| _ = black_box((leg, leg.at(number(2.0)))));
            route.samples(number(20.0)).into_iter().flatten().take(8).for_each(|state| _ = black_box(state));
        }
        Ticks::new(number(20.0), number(0.3)).into_iter().flatten().for_each(|time| _ = black_box(time));
        let [from, through, to] = [from, third, to].map(|q| LabArm.fk(q));
        let arc = ToolPath::arc(&from, through.translation.vector.into(), &to);
        let limits = ToolLimits {
            velocity: number(100.0),
            acceleration: number(200.0),
            spin: number(1.0),
            spin_acceleration: number(2.0),
        };
        for path in [ToolPath::line(&from, &to), arc].into_iter().flatten() {
            black_box((path.length(), path.turn(), path.radius(), path.pose(number(0.4))));
            let Ok(motion) = path.timed(&limits) else { continue };
            let _ = black_box((motion.duration(), motion.path(), motion.progress(), motion.at(number(0.4))));
            motion.poses(number(20.0)).into_iter().flatten().take(8).for_each(|pose| _ = black_box(pose));
        }
    });
}

/// How many of a kind are run: the linker must allow for all of them, and one tells what they take.
fn some() -> usize {
    black_box(1)
}

/// What is watched of an arm with factors.
fn watched<A: Factored<N>, const N: usize>(arm: &A, trajectory: &Trajectory<Number, N>) {
    let watch = Watch::new(arm, trajectory);
    // No figure is as large as that: one range is looked at. What a search takes is a multiple.
    let far = number(1e3);
    for factor in Factor::ALL.iter().take(some()) {
        let _ =
            black_box((watch.factors(number(0.1)).get(*factor), watch.factors(number(0.1)).determinant()));
        let _ = black_box(watch.factor_range(*factor, number(0.1), number(0.2)));
        watch.factor_crossings(*factor, far).for_each(|crossing| _ = black_box(crossing));
        watch.factor_spells(*factor, -far).for_each(|spell| _ = black_box(spell));
    }
}

/// What is watched of any arm.
fn figures<A: Arm<N>, const N: usize>(watch: &Watch<'_, A, Number, N>) {
    let far = number(1e3);
    black_box(watch.trajectory().duration());
    watch.readings(number(20.0)).into_iter().flatten().take(2).for_each(|reading| _ = black_box(reading));
    let measures = [Measure::Margin, Measure::Manipulability, Measure::Determinant];
    for measure in measures.into_iter().take(some()) {
        black_box(watch.range(measure, number(0.1), number(0.2)));
        watch.crossings(measure, far).for_each(|crossing| _ = black_box(crossing));
        watch.spells(measure, -far).for_each(|spell| _ = black_box(spell));
    }
}

/// The singularity monitor of every kind of arm and every figure; what is run is the Puma's: two readings, and a range, a search for
/// crossings and one for spells of the smallest singular value and of a factor.
pub fn watch(inputs: &mut Inputs, measure: Run<'_>) {
    fn between<const N: usize>(inputs: &mut Inputs) -> Option<Trajectory<Number, N>> {
        let (from, to) = (inputs.joints::<N>(), inputs.joints::<N>());
        let limits = RateLimits::uniform(number(1.0), number(2.0));
        Trajectory::new(&from, &to, &limits, Shared::Duration).ok()
    }
    let (three, six, seven) = (between::<3>(inputs), between::<6>(inputs), between::<7>(inputs));
    measure(&mut || {
        if let (Some(three), Some(six), Some(seven)) = (&three, &six, &seven) {
            watched(&Puma560, six);
            figures(&Watch::new(&Puma560, six));
            if some() > 1 {
                watched(&LabRrr, three);
                watched(&Ball, six);
                figures(&Watch::of_position(&LabRrr, three));
                figures(&Watch::new(&Panda, seven));
            }
        }
    });
}

/// Rates for a twist and for a velocity, the twist back, torques, J̇, the tool's acceleration; the figures of a Jacobian.
pub fn velocity(inputs: &mut Inputs, measure: Run<'_>) {
    let (q, speed, push) = (inputs.joints::<6>(), inputs.joints::<6>(), inputs.joints::<6>());
    let (arm, seven) = (inputs.joints::<3>(), inputs.joints::<7>());
    measure(&mut || {
        let (q, speed, push, seven) = (black_box(&q), black_box(&speed), black_box(&push), black_box(&seven));
        let given = twist(&Puma560, q, speed);
        for damping in black_box([Damping::default(), Damping::none()]) {
            let _ = black_box((rates(&Puma560, q, &given, &damping), rates(&Panda, seven, &given, &damping)));
            let _ = black_box(position_rates(&LabRrr, black_box(&arm), &arm, &damping));
        }
        let _ = black_box((torques(&Puma560, q, push), jacobian_rate(&Puma560, q, speed)));
        black_box(acceleration(&Puma560, q, speed, push));
        let (jacobian, three) = (normalised(&Puma560, q), normalised(&LabRrr, &arm));
        let _ = black_box((determinant(&jacobian), position_determinant(&three), singular_values(&jacobian)));
        black_box(scaled(&jacobian, number(2.0)));
    });
}
