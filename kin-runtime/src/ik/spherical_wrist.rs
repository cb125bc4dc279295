//! Six joints, the last three axes through one point: the base puts that point in its place, the wrist turns the tool.
//!
//! ```text
//! pose ─► wrist centre ─► base figures ─► four (t1, t2, t3) ─► ³R₆ = ⁰R₃ᵀ·R ─► wrist ─► eight (t1 … t6) ─► checked q
//! ```

use crate::ik::side;
use crate::ik::sphere::{self, View};
use crate::ik::target::Target;
use crate::ik::wrist::Wrist;
use crate::ik::{Base, finite, sliding};
use crate::math::{Float, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::solutions::{ArmPosture, Bend, Free, Loose, Margins, Posture, Reason, Solutions};
use nalgebra::Matrix3;

/// All solutions; free coordinates by the convention of seed 000.
pub fn solve<T: Float, A: SolveWrist<6>>(arm: &A, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, [None; 6])
}

/// All solutions; free coordinates keep their values in `hold`, those that are not finite take the convention's.
pub fn solve_holding<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &Joints<T, 6>,
) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, finite(arm.rows(pose::entries(hold))))
}

fn solve_choosing<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: [Option<T>; 6],
) -> Solutions<T, 6, Posture> {
    let base = arm.base::<T>();
    let target = match Target::new(pose, &base) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding(&A::JOINTS), reason),
    };
    if let Base::Elbow(base) = &base
        && let Some(solutions) = side::regular(arm, &target, base)
    {
        return solutions;
    }
    let [t1, t2, ..] = hold;
    let placements = base.place(arm.wrist_centre(&target.pose), target.scale, [t1, t2]);
    sphere::solve_placed(&FromBase(arm), target, &placements, hold)
}

/// The arm as it stands.
struct FromBase<'a, A>(&'a A);

impl<A: SolveWrist<6>> View for FromBase<'_, A> {
    type Arm = A;
    type Branch = Posture;

    fn arm(&self) -> &A {
        self.0
    }

    fn base<T: Float>(&self) -> Base<T> {
        self.0.base()
    }

    fn centre<T: Float>(&self, pose: &Pose<T>) -> [T; 3] {
        self.0.wrist_centre(pose)
    }

    fn rotation<T: Float>(&self, base: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        self.0.wrist_rotation(base, pose)
    }

    fn angles<T: Float>(&self, rotation: &Matrix3<T>) -> Wrist<T> {
        self.0.wrist_angles(rotation)
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        self.0.command(rows)
    }

    fn joined<T>([t1, t2, t3]: [T; 3], [t4, t5, t6]: [T; 3]) -> [T; 6] {
        [t1, t2, t3, t4, t5, t6]
    }

    fn apart<T>([t1, t2, t3, t4, t5, t6]: [T; 6]) -> ([T; 3], [T; 3]) {
        ([t1, t2, t3], [t4, t5, t6])
    }

    fn joint(base: u8) -> u8 {
        base
    }

    fn branch(base: ArmPosture, bend: Bend) -> Posture {
        base.with(bend)
    }

    fn margins<T>(shoulder: T, elbow: T, bend: T) -> Margins<T> {
        Margins { shoulder, elbow, wrist: Some(bend) }
    }

    fn free(shoulder: Option<Loose<6>>, elbow: Option<Loose<6>>, wrist: Option<Loose<6>>) -> Free<6> {
        Free { shoulder, elbow, wrist }
    }

    fn reason<T>(reason: Reason<T>) -> Reason<T> {
        reason
    }
}
