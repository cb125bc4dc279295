//! Six joints, the last three axes through one point: the base puts that point in its place, the wrist turns the tool.
//!
//! ```text
//! pose ─► wrist centre ─► base figures ─► four (t1, t2, t3) ─► ³R₆ = ⁰R₃ᵀ·R ─► wrist ─► eight (t1 … t6) ─► checked q
//! ```

use crate::ik::abreast::Abreast;
use crate::ik::placements::Elbowed;
use crate::ik::sphere::{self, View};
use crate::ik::target::Target;
use crate::ik::wrist::{Rows, Wrist};
use crate::ik::{Base, ElbowBase, finite, side, sliding};
use crate::math::{self, Float, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::solutions::{ArmPosture, Bend, Free, Loose, Margins, Posture, Reason, Solutions};
use crate::widths::{self, Instructions};
use nalgebra::Matrix3;

/// All solutions; free coordinates by the convention.
pub fn solve<T: Float, A: SolveWrist<6>>(arm: &A, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, &[None; 6])
}

/// All solutions; free coordinates keep their values in `hold`, those that are not finite take the convention's.
pub fn solve_holding<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &Joints<T, 6>,
) -> Solutions<T, 6, Posture> {
    solve_choosing(arm, pose, &finite(arm.rows(pose::entries(hold))))
}

/// All solutions of many poses, for batches: side by side where the arm has an elbow and an orthogonal wrist.
#[inline(always)]
pub fn solve_each<T: Float, A: SolveWrist<6>>(
    arm: &A,
    poses: &[Pose<T>],
    places: &mut [Option<Solutions<T, 6, Posture>>],
) {
    // Where loops do not become vectors nothing is won.
    if math::ROOT_IS_VISIBLE
        && poses.len() >= ABREAST
        && let (Base::Elbow(base), Some(offsets)) = (arm.base::<T>(), arm.orthogonal_wrist::<T>())
        && is_usual(arm, &base, &offsets)
    {
        let (chunks, rest) = poses.as_chunks::<ABREAST>();
        let (chunks_of_places, rest_of_places) = places.as_chunks_mut::<ABREAST>();
        let (mut abreast, elbowed) = (Abreast::new(), Elbowed { arm, base: &base, wrist: &offsets });
        for (poses, places) in chunks.iter().zip(chunks_of_places) {
            abreast.solve(&elbowed, poses, places);
            // What is near a singular pose, or out of reach, comes by itself.
            for (pose, place) in poses.iter().zip(places).filter(|(_, place)| place.is_none()) {
                *place = Some(solve(arm, pose));
            }
        }
        one_by_one(arm, rest, rest_of_places);
    } else {
        one_by_one(arm, poses, places);
    }
}

/// Whether the constants of an arm are of a size for which nothing needs a branch: offsets for the row values, turns for their
/// sines, lengths so that no product of three distances overflows (what a product of four makes of the longest, forward
/// kinematics rejects). Compilers know it of an arm without parameters.
#[inline(always)]
fn is_usual<T: Float, A: SolveWrist<6>>(arm: &A, base: &ElbowBase<T>, wrist: &Rows<T>) -> bool {
    let (zero, none) = (T::lit(0.0), [T::lit(0.0); 6]);
    let offset = |offset: &T| {
        let size = math::abs(*offset);
        // A smaller one is lost beside half a turn: a row value would come out as minus half a turn.
        size == zero || (size >= T::lit(64.0) * T::EPS && size <= math::half_turn())
    };
    let turn = |turn: &T| math::abs(*turn) <= T::lit(1e3);
    let longest = base.reach / T::EPS;
    base.offset.iter().chain(&wrist.offset).all(offset)
        && arm.wrist_turns([zero; 3]).iter().chain(&arm.fk_turns(&pose::column(none))).all(turn)
        && math::is_finite(longest * longest * longest * T::lit(64.0))
}

/// Poses abreast in a batch: a register of the widest machines.
const ABREAST: usize = 8;

#[inline(always)]
fn one_by_one<T: Float, A: SolveWrist<6>>(
    arm: &A,
    poses: &[Pose<T>],
    places: &mut [Option<Solutions<T, 6, Posture>>],
) {
    for (pose, place) in poses.iter().zip(places) {
        *place = Some(solve(arm, pose));
    }
}

fn solve_choosing<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &[Option<T>; 6],
) -> Solutions<T, 6, Posture> {
    // A register of these holds four placements; wider ones would be half empty.
    widths::run(
        #[inline(always)]
        |_| solve_here(arm, pose, hold),
        Instructions::Avx2,
    )
}

/// The same with the instructions of the caller, into which it is inlined as far as poses are regular.
#[inline(always)]
fn solve_here<T: Float, A: SolveWrist<6>>(
    arm: &A,
    pose: &Pose<T>,
    hold: &[Option<T>; 6],
) -> Solutions<T, 6, Posture> {
    let base = arm.base::<T>();
    let target = match Target::new(pose, &base) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding(&A::JOINTS), reason),
    };
    if let (Base::Elbow(base), Some(offsets)) = (&base, arm.orthogonal_wrist::<T>())
        && is_usual(arm, base, &offsets)
        && let Some(solutions) = side::regular(&Elbowed { arm, base, wrist: &offsets }, &target)
    {
        return solutions;
    }
    singular(arm, &target, hold)
}

/// All solutions of a pose that may be near a singular one, or of an arm that is not usual.
#[inline(never)]
fn singular<T: Float, A: SolveWrist<6>>(
    arm: &A,
    target: &Target<T>,
    hold: &[Option<T>; 6],
) -> Solutions<T, 6, Posture> {
    let [t1, t2, ..] = *hold;
    let placements = arm.base().place(arm.wrist_centre(&target.pose), target.scale, [t1, t2]);
    sphere::solve_placed(&FromBase(arm), *target, &placements, *hold)
}

/// The arm as it stands.
pub(super) struct FromBase<'a, A>(pub(super) &'a A);

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

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        self.0.rows(q)
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
