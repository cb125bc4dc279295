//! Declares an arm from the table of a lab report and shows what the compiler made of it.
//!
//! ```sh
//! cargo run --release --example quickstart
//! ```

use kin_runtime::prelude::*;

dh! {
    /// The six-axis arm of a lab course, as its report prints it (seed 000). The limits are illustrative.
    pub struct LabArm(modified, mm, deg);

    let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;

    | joint | alpha |  a  |  d  | theta  | limits      |
    |-------|-------|-----|-----|--------|-------------|
    | J1    |   0   |  0  | d1  | q      | -170 .. 170 |
    |       |   0   | -a1 | d2  | 0      |             |
    | J2    |  90   |  0  | 0   | q      |             |
    | J3    |   0   |  a2 | 0   | q + 90 |             |
    | J4    | -90   |  a4 | 0   | q      |             |
    |       |   0   |  0  | d5  | 0      |             |
    | J5    |  90   |  0  | 0   | q      |             |
    | J6    | -90   |  0  | d6  | q      |             |

    check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);
}

fn main() {
    summary(&LabArm);
    let q = joints![0.1, 0.4, -0.2, 0.3, 0.9, -0.5];
    forward(&q);
    inverse(&q);
    in_words();
}

/// What can be said of any arm, its type forgotten.
fn summary(arm: &dyn kin_runtime::DynArm) {
    let unit = arm.length_unit();
    title(&format!("{}: {} joints, lengths in {unit}", arm.name(), arm.joints().len()));
    for (index, joint) in arm.joints().iter().enumerate() {
        let limits = match arm.limit(index) {
            Some((low, high)) => format!("{low:8.4} .. {high:7.4}"),
            None => "no limits".to_owned(),
        };
        println!("  {:<4} {:<10} {limits}", joint.name, format!("{:?}", joint.kind).to_lowercase());
    }
    println!("  reach {} {unit}: the sum of all lengths in the table", arm.size());
}

fn forward(q: &Joints<f64, 6>) {
    title("Forward kinematics");
    let (pose, jacobian) = LabArm.fk_jacobian(q);
    row("q", q.iter().copied());
    row("position", pose.translation.vector.iter().copied());
    println!("  orientation  {}", EulerZyx::from_rotation(&pose.rotation));

    title("Jacobian: linear velocity of the tool in mm per radian, then angular velocity");
    for (name, line) in ["vx", "vy", "vz", "wx", "wy", "wz"].into_iter().zip(jacobian.row_iter()) {
        row(name, line.iter().copied());
    }
    let found = kin_runtime::dexterity(&LabArm, q);
    println!(
        "  manipulability {:.4}, margin to the nearest singularity {:.4}",
        found.manipulability, found.margin
    );
}

fn inverse(q: &Joints<f64, 6>) {
    let pose = LabArm.fk(q);
    let solutions = LabArm.ik(&pose);
    title(&format!("Inverse kinematics of that pose: {} solutions", solutions.len()));
    print!("  {:<17}", "branch");
    for joint in 1..=6 {
        print!("{:>10}", format!("theta{joint}"));
    }
    println!("   misses the pose by");
    for solution in solutions.iter() {
        let back = LabArm.fk(&solution.q);
        let off = (back.to_homogeneous() - pose.to_homogeneous()).amax();
        print!("  {:<17}", solution.branch);
        for value in solution.q.iter() {
            print!("{value:10.4}");
        }
        println!("   {off:.1e}");
    }
    if let Some(nearest) = solutions.nearest(q) {
        let off = (nearest.q - q).amax();
        println!(
            "\n  Round trip: the joint values above come back as {}, {off:.1e} rad away.",
            nearest.branch
        );
    }
    let kept = solutions.within(&LabArm.limits());
    println!("  Within the limits: {} of {}.", kept.len(), solutions.len());
    for (branch, slot) in kept.branches() {
        if let Slot::Empty(reason @ Reason::Limit { .. }) = slot {
            println!("  {branch:<18} {reason}");
        }
    }
}

/// The examples of section 6 of the report.
fn in_words() {
    let quarter = std::f64::consts::FRAC_PI_2;
    // The gimbal-locked orientation that the report prints as (pi/4, -pi/2, -pi/4).
    let down = EulerZyx { z: 0.0, y: -quarter, x: 0.0 };
    let level = EulerZyx { z: 0.0, y: 0.0, x: 0.0 };
    for (name, position, orientation) in [
        ("6.1 default position", [-69.0, 0.0, 112.0], down),
        ("6.2 stretched forward", [-309.0, 0.0, 72.0], down),
        ("6.3 z1 aligned with z6", [0.0, 0.0, 300.0], level),
        ("6.4 z4 aligned with z6", [-10.0, 0.0, 371.0], level),
        ("6.5 just beyond the reach", [-30.0, 0.0, 372.52946438], level),
    ] {
        title(&format!(
            "Report, section {name}: ({}, {}, {}), {orientation}",
            position[0], position[1], position[2]
        ));
        let solutions = LabArm.ik(&orientation.at(position));
        println!("{solutions}");
    }
}

fn title(text: &str) {
    println!("\n{text}\n{}", "-".repeat(text.chars().count()));
}

fn row(name: &str, values: impl Iterator<Item = f64>) {
    print!("  {name:<10}");
    for value in values {
        print!("{value:12.4}");
    }
    println!();
}
