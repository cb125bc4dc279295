//! Robot-arm kinematics that the compiler derives.
#![no_std]

pub mod arm;
pub mod dynamic;
pub mod geometry;
pub mod ik;
pub mod limits;
pub mod math;
pub mod pose;
#[doc(hidden)]
pub mod private;
#[cfg(test)]
mod sample;
pub mod singularity;
pub mod solutions;

pub use arm::{Arm, InverseKinematics, Joint, JointKind, LengthUnit, PositionInverse, SphericalWrist};
pub use dh_macro::dh;
pub use dynamic::{DynArm, DynError, DynOutcome, DynSlot, Inverse};
pub use ik::{Base, ElbowBase, TelescopeBase, Wrist, WristFamily};
pub use limits::{Limits, Standing};
pub use math::{Float, Real};
pub use nalgebra::{Matrix3, Point3};
pub use pose::{Euler, EulerZyx, GimbalLock, Jacobian, Joints, Pose};
pub use singularity::{Dexterity, dexterity, position_dexterity};
pub use solutions::{
    ArmPosture, Bend, Boundary, Branch, Constraint, Elbow, Family, JointSet, Posture, Reason, Shoulder,
    Singularity, Slot, Solution, Solutions,
};

/// What a program that declares and uses arms wants in scope.
pub mod prelude {
    pub use crate::{
        Arm, ArmPosture, Bend, Branch, Elbow, Euler, EulerZyx, Family, Float, InverseKinematics, Jacobian,
        Joints, Limits, Pose, PositionInverse, Posture, Real, Reason, Shoulder, Slot, Solution, Solutions,
        SphericalWrist, dh, joints,
    };
    pub use nalgebra::{Matrix3, Point3};
}
