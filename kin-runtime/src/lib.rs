//! Robot-arm kinematics that the compiler derives from the table on paper: no `std`, no allocation, no panic.
//!
//! Paste a Denavit-Hartenberg table into [`dh!`] and the type it declares has forward kinematics, the Jacobian and, where
//! the last or the first three axes meet, every inverse solution; so it has for two to five joints of which two or three carry a
//! point that the others leave in its place. This page is the tour; the grammar of the table is told at [`dh!`].
//!
//! # An arm
//!
//! ```
//! use kin_runtime::prelude::*;
//!
//! dh! {
//!     /// The six-axis arm of a lab report, in millimetres.
//!     pub struct LabArm(modified, mm, deg);
//!
//!     let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;
//!
//!     | joint | alpha |  a  |  d  | theta  | limits      |
//!     |-------|-------|-----|-----|--------|-------------|
//!     | J1    |   0   |  0  | d1  | q      | -170 .. 170 |
//!     |       |   0   | -a1 | d2  | 0      |             |
//!     | J2    |  90   |  0  | 0   | q      |             |
//!     | J3    |   0   |  a2 | 0   | q + 90 |             |
//!     | J4    | -90   |  a4 | 0   | q      |             |
//!     |       |   0   |  0  | d5  | 0      |             |
//!     | J5    |  90   |  0  | 0   | q      |             |
//!     | J6    | -90   |  0  | d6  | q      |             |
//!
//!     check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);
//! }
//!
//! // Joint values in radians, lengths in the declared unit; poses and matrices are nalgebra's.
//! let q = joints![0.1, 0.4, -0.2, 0.3, 0.9, -0.5];
//! let pose = LabArm.fk(&q);
//! let velocity = LabArm.jacobian(&q) * joints![0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
//! assert!(velocity.fixed_rows::<3>(0).norm() < 1e-13); // the last joint turns the tool on the spot
//!
//! // All solutions, labelled, checked by forward kinematics, and the one that was put in is among them.
//! let solutions = LabArm.ik(&pose);
//! for solution in &solutions {
//!     assert!((LabArm.fk(&solution.q).translation.vector - pose.translation.vector).norm() < 1e-12);
//! }
//! let nearest = solutions.nearest(&q).expect("the pose is one of the arm's");
//! assert!((nearest.q - q).amax() < 1e-14);
//!
//! // The solution nearest to where the arm is, wound as its joints are.
//! let turned = q + joints![0.0, 0.0, 0.0, 0.0, 0.0, std::f64::consts::TAU];
//! let near = LabArm.ik_near(&pose, &turned).expect("the pose is one of the arm's");
//! assert!((near.q - turned).amax() < 1e-14);
//!
//! // What is out of reach has a nearest pose that is not.
//! let far = EulerZyx { z: 0.3, y: 0.2, x: 0.1 }.at([500.0, 100.0, 200.0]);
//! let closest = LabArm.closest(&far).expect("a pose like any other");
//! assert!(LabArm.ik(&far).is_empty() && !LabArm.ik(&closest.pose).is_empty() && closest.by > 200.0);
//!
//! // Limits are not applied until asked for; a slot that they empty says which joint and by how much. Of a family this judges
//! // the member that the slot holds: `Family::member_within` finds one that is inside, `ik_near_within` asks for it.
//! for (branch, slot) in solutions.within(&LabArm.limits()).branches() {
//!     if let Slot::Empty(Reason::Limit { joint: 0, by }) = slot {
//!         assert!(*by > 0.0, "{branch}");
//!     }
//! }
//! ```
//!
//! # Every slot says what became of it
//!
//! [`Solutions`] has one [`Slot`] for each branch ([`Posture`]: shoulder, elbow, wrist; [`ShoulderPosture`] where the first
//! three axes meet), always in the same order: solved,
//! merged with another, or empty with its [`Reason`].
//!
//! ```
//! # use kin_runtime::prelude::*;
//! # dh! { pub struct LabArm(modified, mm, deg);
//! #     | joint | alpha |  a  |  d  | theta  |
//! #     | J1    |   0   |  0  | 47  | q      |
//! #     |       |   0   | -30 | 45  | 0      |
//! #     | J2    |  90   |  0  | 0   | q      |
//! #     | J3    |   0   | 120 | 0   | q + 90 |
//! #     | J4    | -90   |  20 | 130 | q      |
//! #     | J5    |  90   |  0  | 0   | q      |
//! #     | J6    | -90   |  0  | 29  | q      |
//! # }
//! use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
//!
//! // Stretched forward: with its first joint turned round the arm is 59 mm short.
//! let level = EulerZyx { z: FRAC_PI_4, y: -FRAC_PI_2, x: -FRAC_PI_4 };
//! let stretched = LabArm.ik(&level.at([-309.0, 0.0, 72.0]));
//! assert_eq!(stretched.len(), 4);
//! let shortest = stretched.slots().iter().find_map(|slot| match slot {
//!     Slot::Empty(Reason::OutOfReach { by, .. }) => Some(*by),
//!     _ => None,
//! });
//! assert!((shortest.unwrap() - 59.115027).abs() < 1e-6);
//! assert!(stretched.to_string().starts_with("for theta1 = 3.1416, the coordinates inserted are out of reach: 59.115027"));
//!
//! // At rest axes 4 and 6 coincide: one of the solutions is a family, and any member of it can be had.
//! let rest = level.at([-69.0, 0.0, 112.0]);
//! let solutions = LabArm.ik(&rest);
//! let family = solutions.iter().find_map(|solution| solution.family()).unwrap();
//! assert_eq!(family.to_string(), "theta4 + theta6 = 0.0000");
//! let Slot::Solved(member) = family.member(&LabArm, &rest, 0.5) else { panic!() };
//! assert!((member.q - joints![0.0, 0.0, 0.0, 0.5, 0.0, -0.5]).amax() < 1e-14);
//! ```
//!
//! # Generic code, and arms without their type
//!
//! [`Arm`], [`InverseKinematics`], [`PositionInverse`] and [`SphericalWrist`] are what generic code asks for; numbers are
//! [`Real`] for what goes forward and [`Float`] (`f32`, `f64`) for what goes back. [`DynArm`] is an arm behind a reference.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use kin_runtime::dexterity;
//!
//! fn margin<const N: usize>(arm: &impl Arm<N>, q: &Joints<f64, N>) -> f64 {
//!     dexterity(arm, q).margin
//! }
//! ```
//!
//! # What holds
//!
//! * Every solution was checked: forward kinematics returns to the pose within 64 ε, relative to the arm's reach, on planar bases
//!   and of short arms within 16 ε; what misses is a slot with [`Reason::Inaccurate`]. Two solutions of an answer differ by more
//!   than 1e-7 (`f32`: 7√ε).
//! * Windows for round-off are a few ε of the reach. A pose on the boundary is reached; one that misses it by more is
//!   out of reach, by the distance that the reason tells.
//! * No input panics, loops for long, or comes back as a NaN in a solution. The only trigonometric functions are those of
//!   [`math`]: the same bits on every target.
//!
//! # The modules
//!
//! [`arm`] the traits · [`pose`] poses, joint vectors, Euler angles · [`geometry`] the figures that solutions are spelled
//! with · [`ik`] the solvers, one page each · [`solutions`] what they give back · [`limits`] · [`track`] paths of poses ·
//! [`trajectory`] motions in time · [`watch`] their singular poses · [`rates`] velocity and force ·
//! [`batch`] slices of configurations and poses · [`singularity`] · [`dual`] rates of change · [`dynamic`] arms behind
//! references · [`math`] numbers.
//!
//! The feature `std`, a default, lets roots stand side by side, and on x86-64 inverses and batches find the widest instructions of
//! the machine; where there is no operating system it does nothing. `rayon` lets batches have all threads of the machine. The feature
//! `serde` makes poses, joint vectors, solutions, reasons, postures, limits and trajectories storable.
#![no_std]

pub mod arm;
pub mod batch;
mod choice;
pub mod dual;
pub mod dynamic;
pub mod geometry;
pub mod ik;
pub mod limits;
pub mod math;
pub mod pose;
#[doc(hidden)]
pub mod private;
pub mod rates;
#[cfg(test)]
mod sample;
pub mod singularity;
pub mod solutions;
pub mod track;
pub mod trajectory;
pub mod watch;
mod widths;

pub use arm::{Arm, InverseKinematics, Joint, JointKind, LengthUnit, PositionInverse, SphericalWrist};
pub use batch::{Batch, BatchError};
pub use dh_macro::dh;
pub use dual::Dual;
pub use dynamic::{DynArm, DynError, DynOutcome, DynSlot, Inverse};
pub use ik::closest::{Closest, ClosestPoint, ClosestPose};
pub use ik::{
    Axis, Base, Carrier, ElbowBase, GeneralBase, PairBase, TelescopeBase, Turns, Wrist, WristFamily,
};
pub use limits::{Limits, Standing};
pub use math::{Float, Lanes, Real};
pub use nalgebra::{Matrix3, Point3};
pub use pose::{Euler, EulerZyx, GimbalLock, Jacobian, Joints, Pose};
pub use singularity::{Dexterity, dexterity, position_dexterity};
pub use solutions::{
    ArmPosture, Bend, Boundary, Branch, Constraint, Elbow, Family, Hand, JointSet, Margins, Posture, Ranges,
    Reason, Shoulder, ShoulderPosture, Singularity, Slot, Solution, Solutions, Winding, Windings,
};
pub use track::{ByPoint, Cause, Census, Step, Stop, Track};
pub use trajectory::{RateLimits, Route, ToolLimits, ToolPath, Trajectory, TrajectoryError};
pub use watch::{Factor, Factored, Factors, Measure, Watch};

/// What a program that declares and uses arms wants in scope.
pub mod prelude {
    pub use crate::{
        Arm, ArmPosture, Batch, Bend, Boundary, Branch, Cause, ClosestPoint, ClosestPose, Constraint, Elbow,
        Euler, EulerZyx, Family, Float, Hand, InverseKinematics, Jacobian, Joints, Limits, Margins, Pose,
        PositionInverse, Posture, Real, Reason, Shoulder, ShoulderPosture, Singularity, Slot, Solution,
        Solutions, SphericalWrist, Step, Winding, dh, joints,
    };
    // Once more without their names: an arm that is itself called `Arm` hides the name, not the methods.
    pub use crate::{
        Arm as _, Batch as _, InverseKinematics as _, PositionInverse as _, SphericalWrist as _,
    };
    pub use nalgebra::{Matrix3, Point3};
}
