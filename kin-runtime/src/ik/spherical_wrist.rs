//! Six joints, the last three axes through one point: the base puts that point in its place, the wrist turns the tool.
//!
//! ```text
//! pose ─► wrist centre ─► base figures ─► four (t1, t2, t3) ─► ³R₆ = ⁰R₃ᵀ·R ─► wrist ─► eight (t1 … t6) ─► checked q
//! ```

use crate::ik::base::Placed;
use crate::ik::target::{Target, accepted};
use crate::ik::wrist::Wrist;
use crate::ik::{ACCEPTED, ROUND_OFF, finite, given_out, sliding};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::private::SolveWrist;
use crate::solutions::{
    ArmPosture, Bend, Boundary, Branch, Free, JointSet, Margins, Posture, Reason, Slot, Solution, Solutions,
};
use nalgebra::SVector;

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
    let (sliding, base) = (sliding(&A::JOINTS), arm.base::<T>());
    let target = match Target::new(pose, &base) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let [t1, t2, ..] = hold;
    let placements = base.place(arm.wrist_centre(&target.pose), target.scale, [t1, t2]);
    let task = Task { arm, target, hold };
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for (count, posture) in ArmPosture::ALL.iter().enumerate() {
        let placement = posture.of(&placements);
        let mut earlier = ArmPosture::ALL.iter().take(count);
        let [noflip, flip] = match (placement, earlier.find(|earlier| earlier.of(&placements) == placement)) {
            (Err(reason), _) => [Slot::Empty(*reason); 2],
            (Ok(_), Some(same)) => {
                [Bend::NoFlip, Bend::Flip].map(|bend| once_more(&solutions, same.with(bend)))
            }
            (Ok(placed), None) => task.bend(*posture, placed),
        };
        solutions.put(posture.with(Bend::NoFlip), noflip);
        solutions.put(posture.with(Bend::Flip), flip);
    }
    solutions.merge(base.reach());
    solutions
}

/// The slot of a branch that differs from an earlier one only by its name.
fn once_more<T: Float>(solutions: &Solutions<T, 6, Posture>, earlier: Posture) -> Slot<T, 6, Posture> {
    match *solutions.get(earlier) {
        Slot::Solved(_) => Slot::Merged { with: earlier },
        merged_or_empty => merged_or_empty,
    }
}

/// What is asked of an arm: the pose, and row values for coordinates that it leaves free.
struct Task<'a, T: Float, A> {
    arm: &'a A,
    target: Target<T>,
    hold: [Option<T>; 6],
}

impl<T: Float, A: SolveWrist<6>> Task<'_, T, A> {
    /// The two slots of one placement of the wrist centre.
    fn bend(&self, posture: ArmPosture, placed: &Placed<T>) -> [Slot<T, 6, Posture>; 2] {
        let (rows, wrist) = self.reached(placed);
        let wrist = self.decided(rows, wrist);
        let shoulder = placed.shoulder_free.then(|| self.moving(rows, &wrist, 0));
        let elbow = placed.elbow_free.then(|| self.moving(rows, &wrist, 1));
        let slot = |bend, wrist_rows, margin, line| {
            let margins = Margins { shoulder: placed.shoulder, elbow: placed.elbow, wrist: Some(margin) };
            let free = Free { shoulder, elbow, wrist: line };
            self.checked(posture.with(bend), joined(rows, wrist_rows), margins, free)
        };
        match wrist {
            Wrist::Two { noflip, flip, margin, .. } => {
                [slot(Bend::NoFlip, noflip, margin, None), slot(Bend::Flip, flip, margin, None)]
            }
            Wrist::Family(family) => {
                let [_, _, _, held, _, _] = self.hold;
                let member = held.map_or_else(|| family.even(), |t4| family.member(t4));
                let merged = Slot::Merged { with: posture.with(Bend::NoFlip) };
                match slot(Bend::NoFlip, member, T::lit(0.0), Some(self.line(family.difference))) {
                    Slot::Empty(reason) => [Slot::Empty(reason); 2],
                    solved => [solved, merged],
                }
            }
            Wrist::OutOfReach { by } => {
                let [t1, ..] = rows;
                [Slot::Empty(Reason::OutOfReach { by, towards: Boundary::WristCone, theta1: Some(t1) }); 2]
            }
        }
    }

    /// Two ways that are one family but for round-off of the base become that family, if its members reach the pose.
    /// All of them turn the tool alike, so that one speaks for the rest; what it leaves is for their own round-off.
    fn decided(&self, rows: [T; 3], wrist: Wrist<T>) -> Wrist<T> {
        let Wrist::Two { doubt: Some(family), .. } = wrist else { return wrist };
        let straight = self.arm.command(joined(rows, family.member(T::lit(0.0))));
        let residual = self.target.missed_by(&self.arm.fk(&given_out(straight, &A::JOINTS)));
        let within = residual <= T::lit(ACCEPTED - ROUND_OFF) * T::EPS;
        if within { Wrist::Family(family) } else { wrist }
    }

    fn wrist(&self, rows: [T; 3]) -> Wrist<T> {
        self.arm.wrist_angles(&self.arm.wrist_rotation(rows, &self.target.pose))
    }

    /// What the wrist makes of a placement. An oblique wrist may not reach where a free joint stands by convention;
    /// then fifteen other values of that joint are tried.
    fn reached(&self, placed: &Placed<T>) -> ([T; 3], Wrist<T>) {
        let convention = self.wrist(placed.rows);
        let [t1, t2, t3] = placed.rows;
        let [held1, held2, ..] = self.hold;
        let free = (placed.shoulder_free && held1.is_none()) || (placed.elbow_free && held2.is_none());
        if free && matches!(convention, Wrist::OutOfReach { .. }) {
            for turn in 1..16 {
                let step = math::half_turn::<T>() * T::lit(0.125 * f64::from(turn));
                let turned = if placed.shoulder_free && held1.is_none() {
                    [math::wrap(t1 + step), t2, t3]
                } else {
                    [t1, math::wrap(t2 + step), t3]
                };
                let wrist = self.wrist(turned);
                if !matches!(wrist, Wrist::OutOfReach { .. }) {
                    return (turned, wrist);
                }
            }
        }
        (placed.rows, convention)
    }

    /// The joint values that command these row values, if forward kinematics confirms them.
    fn checked(
        &self,
        branch: Posture,
        rows: [T; 6],
        margins: Margins<T>,
        free: Free<6>,
    ) -> Slot<T, 6, Posture> {
        let q = given_out(self.arm.command(rows), &A::JOINTS);
        match accepted(self.target.missed_by(&self.arm.fk(&q))) {
            Ok(residual) => Slot::Solved(Solution { branch, q, residual, margins, free }),
            Err(reason) => Slot::Empty(reason),
        }
    }

    /// The direction in which the joints may go when axes 4 and 6 coincide: whole numbers, because couplings are.
    fn line(&self, difference: bool) -> SVector<i8, 6> {
        let back = if difference { 1.0 } else { -1.0 };
        SVector::from(self.arm.command([0.0, 0.0, 0.0, 1.0, 0.0, back]).map(|step: f64| step as i8))
    }

    /// The joints that move when the free joint `of` does, told from two other members of the family.
    ///
    /// Seen from frame 3 the tool then turns about the axis of that joint. If this is axis 4, 5 or 6 itself, the wrist's joint
    /// of that axis alone makes up for it, or 4 and 6 share it where they coincide. Otherwise all three move, even if one of
    /// them has its old value in a member.
    fn moving(&self, rows: [T; 3], wrist: &Wrist<T>, of: usize) -> JointSet {
        let mut set = JointSet::EMPTY.with(of);
        let Some(here) = any_way(wrist) else { return set };
        let mut turned = JointSet::EMPTY;
        for step in [0.1, 2.0] {
            let mut other = rows;
            if let Some(value) = other.get_mut(of) {
                *value += T::lit(step);
            }
            let Some(there) = any_way(&self.wrist(other)) else { continue };
            turned = different(turned, here, there);
            let command = |rows, wrist| self.arm.command(joined(rows, wrist));
            set = different(set, command(rows, here), command(other, there));
        }
        if turned.len() == 3 || (turned.len() == 2 && turned.contains(1)) {
            for wrist in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                set = different(set, self.arm.command(joined([0.0; 3], wrist)), [0.0; 6]);
            }
        }
        set
    }
}

/// One of the ways of a wrist, if it has any.
fn any_way<T: Float>(wrist: &Wrist<T>) -> Option<[T; 3]> {
    match wrist {
        Wrist::Two { noflip, .. } => Some(*noflip),
        Wrist::Family(family) => Some(family.even()),
        Wrist::OutOfReach { .. } => None,
    }
}

/// The set, and the joints whose angles differ by more than what a family's round-off makes of them.
fn different<T: Float, const N: usize>(set: JointSet, a: [T; N], b: [T; N]) -> JointSet {
    a.into_iter().zip(b).enumerate().fold(set, |set, (joint, (a, b))| {
        let apart = math::abs(math::wrap(a - b)) > T::lit(64.0) * math::sqrt(T::EPS);
        if apart { set.with(joint) } else { set }
    })
}

fn joined<T>([t1, t2, t3]: [T; 3], [t4, t5, t6]: [T; 3]) -> [T; 6] {
    [t1, t2, t3, t4, t5, t6]
}
