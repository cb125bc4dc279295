//! Six joints, three of whose axes meet: the other three, a base, put that point in its place, those three turn the tool.
//!
//! The page is the same whether the last three axes meet, a [wrist](crate::ik::spherical_wrist), or the first three, a
//! [shoulder](crate::ik::spherical_shoulder): seen from its tool the one arm is the other. A [`View`] says which joints are
//! which.

use crate::arm::Arm;
use crate::ik::base::Placed;
use crate::ik::target::{Target, accepted};
use crate::ik::wrist::Wrist;
use crate::ik::{ACCEPTED, Base, ROUND_OFF, given_out, sliding};
use crate::math::{self, Float};
use crate::pose::Pose;
use crate::solutions::{
    ArmPosture, Bend, Boundary, Branch, Free, JointSet, Loose, Margins, Reason, Slot, Solution, Solutions,
};
use nalgebra::{Matrix3, SVector};

/// An arm from the end at which its base is: joints of the base are counted from there, those of the sphere as in the arm.
pub(crate) trait View {
    /// The arm itself.
    type Arm: Arm<6>;
    /// The labels of its slots.
    type Branch: Branch;

    /// The arm itself.
    fn arm(&self) -> &Self::Arm;
    /// The base.
    fn base<T: Float>(&self) -> Base<T>;
    /// The point that the base must reach, in the base's frame.
    fn centre<T: Float>(&self, pose: &Pose<T>) -> [T; 3];
    /// The rotation that the sphere must produce, once the base's row values are set.
    fn rotation<T: Float>(&self, base: [T; 3], pose: &Pose<T>) -> Matrix3<T>;
    /// The row values that produce a rotation.
    fn angles<T: Float>(&self, rotation: &Matrix3<T>) -> Wrist<T>;
    /// The commanded values of row values.
    fn command<T: Float>(&self, rows: [T; 6]) -> [T; 6];

    /// All row values, from those of the base and of the sphere.
    fn joined<T>(base: [T; 3], sphere: [T; 3]) -> [T; 6];
    /// The values of the base and of the sphere, from all of them.
    fn apart<T>(rows: [T; 6]) -> ([T; 3], [T; 3]);
    /// The joint of the arm that is this one of the base.
    fn joint(base: u8) -> u8;
    /// The label of a way of the base with a way of the sphere.
    fn branch(base: ArmPosture, bend: Bend) -> Self::Branch;
    /// The margins of base and sphere.
    fn margins<T>(first: T, second: T, bend: T) -> Margins<T>;
    /// What the base's first two joints and the sphere leave free.
    fn free(first: Option<Loose<6>>, second: Option<Loose<6>>, bend: Option<Loose<6>>) -> Free<6>;
    /// A reason of the base or the sphere in the arm's own terms.
    fn reason<T>(reason: Reason<T>) -> Reason<T>;
}

/// All solutions; free coordinates keep the row values of `hold`, or take those of the convention.
pub(crate) fn solve<T: Float, V: View>(
    view: &V,
    pose: &Pose<T>,
    hold: [Option<T>; 6],
) -> Solutions<T, 6, V::Branch> {
    let (sliding, base) = (sliding(&V::Arm::JOINTS), view.base::<T>());
    let target = match Target::new(pose, &base) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding, reason),
    };
    let ([first, second, _], [outer, _, _]) = V::apart(hold);
    let held = [first, second];
    let placements = base.place(view.centre(&target.pose), target.scale, held);
    let task = Task { view, target, held, outer };
    let mut solutions = Solutions::none(sliding, Reason::NotFinite);
    for (count, posture) in ArmPosture::ALL.iter().enumerate() {
        let placement = posture.of(&placements);
        let mut earlier = ArmPosture::ALL.iter().take(count);
        let [noflip, flip] = match (placement, earlier.find(|earlier| earlier.of(&placements) == placement)) {
            (Err(reason), _) => [Slot::Empty(V::reason(*reason)); 2],
            (Ok(_), Some(same)) => {
                [Bend::NoFlip, Bend::Flip].map(|bend| once_more(&solutions, V::branch(*same, bend)))
            }
            (Ok(placed), None) => task.bend(*posture, placed),
        };
        solutions.put(V::branch(*posture, Bend::NoFlip), noflip);
        solutions.put(V::branch(*posture, Bend::Flip), flip);
    }
    solutions.merge(base.reach());
    solutions
}

/// The slot of a branch that differs from an earlier one only by its name.
fn once_more<T: Float, B: Branch>(solutions: &Solutions<T, 6, B>, earlier: B) -> Slot<T, 6, B> {
    match *solutions.get(earlier) {
        Slot::Solved(_) => Slot::Merged { with: earlier },
        merged_or_empty => merged_or_empty,
    }
}

/// What is asked of an arm: the pose, and row values for coordinates that it leaves free.
struct Task<'a, T: Float, V> {
    view: &'a V,
    target: Target<T>,
    /// For the base's first two joints.
    held: [Option<T>; 2],
    /// For the sphere's first.
    outer: Option<T>,
}

impl<T: Float, V: View> Task<'_, T, V> {
    /// The two slots of one placement of the wrist centre.
    fn bend(&self, posture: ArmPosture, placed: &Placed<T>) -> [Slot<T, 6, V::Branch>; 2] {
        let (rows, wrist) = self.reached(placed);
        let wrist = self.decided(rows, wrist);
        let first = placed.shoulder_free.then(|| self.moving(rows, &wrist, 0));
        let second = placed.elbow_free.then(|| self.moving(rows, &wrist, 1));
        let slot = |bend, wrist_rows, margin, line| {
            let margins = V::margins(placed.shoulder, placed.elbow, margin);
            let free = V::free(first, second, line);
            self.checked(V::branch(posture, bend), V::joined(rows, wrist_rows), margins, free)
        };
        match wrist {
            Wrist::Two { noflip, flip, margin, .. } => {
                [slot(Bend::NoFlip, noflip, margin, None), slot(Bend::Flip, flip, margin, None)]
            }
            Wrist::Family(family) => {
                let member = self.outer.map_or_else(|| family.even(), |first| family.member(first));
                let merged = Slot::Merged { with: V::branch(posture, Bend::NoFlip) };
                match slot(Bend::NoFlip, member, T::lit(0.0), Some(self.line(family.difference))) {
                    Slot::Empty(reason) => [Slot::Empty(reason); 2],
                    solved => [solved, merged],
                }
            }
            Wrist::OutOfReach { by } => {
                let [t1, ..] = rows;
                let reason = Reason::OutOfReach { by, towards: Boundary::WristCone, theta1: Some(t1) };
                [Slot::Empty(V::reason(reason)); 2]
            }
        }
    }

    /// Two ways that are one family but for round-off of the base become that family, if its members reach the pose.
    /// All of them turn the tool alike, so that one speaks for the rest; what it leaves is for their own round-off.
    fn decided(&self, rows: [T; 3], wrist: Wrist<T>) -> Wrist<T> {
        let Wrist::Two { doubt: Some(family), .. } = wrist else { return wrist };
        let straight = self.view.command(V::joined(rows, family.member(T::lit(0.0))));
        let residual = self.target.missed_by(&self.view.arm().fk(&given_out(straight, &V::Arm::JOINTS)));
        let within = residual <= T::lit(ACCEPTED - ROUND_OFF) * T::EPS;
        if within { Wrist::Family(family) } else { wrist }
    }

    fn wrist(&self, rows: [T; 3]) -> Wrist<T> {
        self.view.angles(&self.view.rotation(rows, &self.target.pose))
    }

    /// What the wrist makes of a placement. An oblique wrist may not reach where a free joint stands by convention;
    /// then fifteen other values of that joint are tried.
    fn reached(&self, placed: &Placed<T>) -> ([T; 3], Wrist<T>) {
        let convention = self.wrist(placed.rows);
        let [t1, t2, t3] = placed.rows;
        let [held1, held2] = self.held;
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
        branch: V::Branch,
        rows: [T; 6],
        margins: Margins<T>,
        free: Free<6>,
    ) -> Slot<T, 6, V::Branch> {
        let q = given_out(self.view.command(rows), &V::Arm::JOINTS);
        match accepted(self.target.missed_by(&self.view.arm().fk(&q))) {
            Ok(residual) => Slot::Solved(Solution { branch, q, residual, margins, free }),
            Err(reason) => Slot::Empty(reason),
        }
    }

    /// The direction in which the joints may go when the sphere's outer axes coincide: whole numbers, because couplings are.
    fn line(&self, difference: bool) -> Loose<6> {
        let back = if difference { 1.0 } else { -1.0 };
        let steps = self.view.command(V::joined([0.0; 3], [1.0, 0.0, back]));
        Loose::Line(SVector::from(steps.map(|step: f64| step as i8)))
    }

    /// The joints that move when the base's free joint `of` does, told from two other members of the family.
    ///
    /// Seen from beyond the base the tool then turns about the axis of that joint. If this is one of the sphere's own axes, the
    /// sphere's joint of that axis alone makes up for it, or its outer two share it where they coincide. Otherwise all three
    /// move, even if one of them has its old value in a member.
    fn moving(&self, rows: [T; 3], wrist: &Wrist<T>, of: u8) -> Loose<6> {
        let joint = V::joint(of);
        let mut set = JointSet::EMPTY.with(usize::from(joint));
        let Some(here) = any_way(wrist) else { return Loose::Follow { joint, moving: set } };
        let mut turned = JointSet::EMPTY;
        for step in [0.1, 2.0] {
            let mut other = rows;
            if let Some(value) = other.get_mut(usize::from(of)) {
                *value += T::lit(step);
            }
            let Some(there) = any_way(&self.wrist(other)) else { continue };
            turned = different(turned, here, there);
            let command = |rows, wrist| self.view.command(V::joined(rows, wrist));
            set = different(set, command(rows, here), command(other, there));
        }
        if turned.len() == 3 || (turned.len() == 2 && turned.contains(1)) {
            let (zero, one) = (T::lit(0.0), T::lit(1.0));
            for sphere in [[one, zero, zero], [zero, one, zero], [zero, zero, one]] {
                set = different(set, self.view.command(V::joined([zero; 3], sphere)), [zero; 6]);
            }
        }
        Loose::Follow { joint, moving: set }
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
