//! Six joints, the first three axes through one point: a spherical wrist's arm, solved from its tool.
//!
//! ```text
//! pose ─► shoulder seen from the tool ─► figures of joints 6, 5, 4 ─► four (t6, t5, t4) ─► ⁰R₃ = R·³R₆ᵀ ─► shoulder ─► eight
//! ```
//!
//! The last three joints may be any base: joint 6 takes the part of joint 1, 5 that of 2, 4 that of 3. Coordinates that a
//! singular pose leaves free take the mirrored convention: joint 6 the value 0, joints 1 and 3 an equal share of their sum or
//! difference.

use crate::ik::sphere::{self, View};
use crate::ik::wrist::Wrist;
use crate::ik::{Base, finite};
use crate::math::{Float, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveShoulder;
use crate::solutions::{
    ArmPosture, Bend, Boundary, Free, Loose, Margins, Reason, ShoulderPosture, Solutions,
};
use nalgebra::Matrix3;

/// All solutions; free coordinates by the convention.
pub fn solve<T: Float, A: SolveShoulder<6>>(arm: &A, pose: &Pose<T>) -> Solutions<T, 6, ShoulderPosture> {
    sphere::solve(&FromTool(arm), pose, [None; 6])
}

/// All solutions; free coordinates keep their values in `hold`, those that are not finite take the convention's.
pub fn solve_holding<T: Float, A: SolveShoulder<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &Joints<T, 6>,
) -> Solutions<T, 6, ShoulderPosture> {
    sphere::solve(&FromTool(arm), pose, finite(arm.rows(pose::entries(hold))))
}

/// The arm as its tool sees it.
pub(super) struct FromTool<'a, A>(pub(super) &'a A);

impl<A: SolveShoulder<6>> View for FromTool<'_, A> {
    type Arm = A;
    type Branch = ShoulderPosture;

    fn arm(&self) -> &A {
        self.0
    }

    fn base<T: Float>(&self) -> Base<T> {
        self.0.base()
    }

    fn centre<T: Float>(&self, pose: &Pose<T>) -> [T; 3] {
        self.0.shoulder_centre(pose)
    }

    fn rotation<T: Float>(&self, [t6, t5, t4]: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        self.0.shoulder_rotation([t4, t5, t6], pose)
    }

    fn angles<T: Float>(&self, rotation: &Matrix3<T>) -> Wrist<T> {
        self.0.shoulder_angles(rotation)
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        self.0.command(rows)
    }

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        self.0.rows(q)
    }

    fn joined<T>([t6, t5, t4]: [T; 3], [t1, t2, t3]: [T; 3]) -> [T; 6] {
        [t1, t2, t3, t4, t5, t6]
    }

    fn apart<T>([t1, t2, t3, t4, t5, t6]: [T; 6]) -> ([T; 3], [T; 3]) {
        ([t6, t5, t4], [t1, t2, t3])
    }

    fn joint(base: u8) -> u8 {
        5_u8.saturating_sub(base)
    }

    fn branch(base: ArmPosture, bend: Bend) -> ShoulderPosture {
        ShoulderPosture::seen(base, bend)
    }

    fn margins<T>(hand: T, elbow: T, bend: T) -> Margins<T> {
        Margins { shoulder: bend, elbow, wrist: Some(hand) }
    }

    fn free(hand: Option<Loose<6>>, elbow: Option<Loose<6>>, shoulder: Option<Loose<6>>) -> Free<6> {
        Free { shoulder, elbow, wrist: hand }
    }

    fn reason<T>(reason: Reason<T>) -> Reason<T> {
        let Reason::OutOfReach { by, towards, .. } = reason else { return reason };
        let towards = match towards {
            Boundary::Cylinder => Boundary::HandCylinder,
            Boundary::WristCone => Boundary::ShoulderCone,
            other => other,
        };
        Reason::OutOfReach { by, towards, theta1: None }
    }
}
