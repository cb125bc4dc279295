//! The tasks of the lab report of seed 003 with its arm: inverse kinematics along a way, a synchronised trajectory at 20 Hz, the
//! check for singular poses, velocities and torques.
//!
//! ```sh
//! cargo run --release -p robots --example motion
//! ```

use kin_runtime::prelude::*;
use kin_runtime::rates::{Damping, Twist, Wrench, rates, torques};
use kin_runtime::trajectory::{RateLimits, Shared, ToolLimits, ToolPath, Trajectory, TrajectoryError};
use kin_runtime::watch::{Factor, Measure, Watch};
use robots::ElbowWrist;

/// The frequency of the report's controller.
const HERTZ: f64 = 20.0;

fn main() -> Result<(), TrajectoryError<f64>> {
    let from = joints![-0.9, 0.3, -0.9, 0.6, 0.85, 0.1];
    let to = joints![0.83, 1.0, -1.1, -0.5, -0.45, 0.3];

    println!("Task 5: all joints from one pose to another in one time, at most 1 rad/s and 2 rad/s²\n");
    let limits = RateLimits::uniform(1.0, 2.0);
    let trajectory = Trajectory::new(&from, &to, &limits, Shared::Duration)?;
    let line = Trajectory::new(&from, &to, &limits, Shared::Phases)?;
    println!("  {:.4} s; in shared phases {:.4} s", trajectory.duration(), line.duration());
    for (joint, profile) in trajectory.profiles().enumerate() {
        println!(
            "  theta{}: {:<11} ramps of {:.4} s, {:7.4} rad/s between",
            joint + 1,
            profile.shape(),
            profile.ramp(),
            profile.velocity()
        );
    }

    println!("\nTasks 2 and 3: the poses of that way, and the solutions closest to where the arm is\n");
    let poses = trajectory.samples(HERTZ)?.map(|state| ElbowWrist.fk(&state.q));
    let stops = ElbowWrist.track(&from, poses).counted();
    for (stop, state) in stops.zip(trajectory.samples(HERTZ)?).step_by(5) {
        if let Step::Continuous(at) = &stop.step {
            println!("  t = {:5.3} s  {:<12} {}", state.time, stop.count.to_string(), at.solution);
        }
    }

    println!("\nTask 6: singular poses on the way\n");
    let watch = Watch::new(&ElbowWrist, &trajectory);
    for reading in watch.readings(HERTZ)?.step_by(5) {
        println!(
            "  t = {:5.3} s  det J = {:9.6}  smallest singular value {:.6}",
            reading.state.time,
            reading.determinant.unwrap_or(0.0),
            reading.dexterity.margin
        );
    }
    watch.crossings(Measure::Determinant, 0.0).for_each(|crossing| println!("  {crossing}"));
    watch.factor_spells(Factor::Wrist, 0.1).for_each(|spell| println!("  {spell}"));

    println!("\nVelocity and force: the tool down at 0.1 m/s from the start, and pressed down with 20 N\n");
    let down = Twist::from([0.0, 0.0, -0.1, 0.0, 0.0, 0.0]);
    for (name, q) in [("start", from), ("straight wrist", joints![0.0, 0.6, -1.0, 0.0, 0.0, 0.2])] {
        match rates(&ElbowWrist, &q, &down, &Damping::default()) {
            Ok(found) => println!(
                "  {name}: rates {:.4?}, damping {:.4}, missed {:.1e}",
                found.velocity.as_slice(),
                found.damping,
                found.missed
            ),
            Err(error) => println!("  {name}: {error}"),
        }
        let held = torques(&ElbowWrist, &q, &Wrench::from([0.0, 0.0, -20.0, 0.0, 0.0, 0.0]));
        println!("  {name}: torques {:.4?} Nm", held.as_slice());
    }

    println!("\nA straight line of the tool between the same poses, at most 0.5 m/s and 1 m/s²\n");
    let path = ToolPath::line(&ElbowWrist.fk(&from), &ElbowWrist.fk(&to))?;
    let tool = ToolLimits { velocity: 0.5, acceleration: 1.0, spin: 1.0, spin_acceleration: 2.0 };
    let motion = path.timed(&tool)?;
    let steps: Vec<_> = ElbowWrist.track(&from, motion.poses(HERTZ)?).collect();
    let going = steps.iter().filter(|step| matches!(step, Step::Continuous(_))).count();
    println!(
        "  {:.4} m in {:.4} s: {going} of {} steps without a jump",
        path.length(),
        motion.duration(),
        steps.len()
    );
    Ok(())
}
