//! Six joints, three of whose axes meet: the other three, a base, put that point in its place, those three turn the tool.
//!
//! The page is the same whether the last three axes meet, a [wrist](crate::ik::spherical_wrist), or the first three, a
//! [shoulder](crate::ik::spherical_shoulder): seen from its tool the one arm is the other. A [`View`] says which joints are
//! which.

use crate::arm::{Arm, Joint, JointKind};
use crate::ik::base::{Placed, Placements};
use crate::ik::beyond;
use crate::ik::rim;
use crate::ik::settle::{add, improved, settle};
use crate::ik::straight::{self, Doubt};
use crate::ik::target::{Target, accepted, is_accepted};
use crate::ik::wrist::{Wrist, WristFamily};
use crate::ik::{Base, SETTLED, given_out, sliding};
use crate::math::{self, Float, Lanes, Real};
use crate::pose::{self, Jacobian, Joints, Pose};
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
    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6];
    /// The row values of commanded values.
    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6];

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
    let base = view.base::<T>();
    let target = match Target::new(pose, &base) {
        Ok(target) => target,
        Err(reason) => return Solutions::none(sliding(&V::Arm::JOINTS), reason),
    };
    let ([first, second, _], _) = V::apart(hold);
    let placements = base.place(view.centre(&target.pose), target.scale, [first, second]);
    solve_placed(view, target, &placements, hold)
}

/// All solutions, once it is known where the base can be.
pub(crate) fn solve_placed<T: Float, V: View>(
    view: &V,
    target: Target<T>,
    placements: &Placements<T>,
    hold: [Option<T>; 6],
) -> Solutions<T, 6, V::Branch> {
    let ([first, second, _], [outer, _, _]) = V::apart(hold);
    let task = Task { view, target, held: [first, second], outer };
    let base = view.base::<T>();
    let mut plans = [[Plan::Empty(Reason::NotFinite); 2]; 4];
    let mut doubts = [None; 4];
    let each = ArmPosture::ALL.iter().zip(&mut plans).zip(&mut doubts).enumerate();
    for (count, ((posture, both), doubt)) in each {
        let placement = posture.of(placements);
        let mut earlier = ArmPosture::ALL.iter().take(count);
        *both = match (placement, earlier.find(|earlier| earlier.of(placements) == placement)) {
            (Err(reason), _) => [Plan::Empty(V::reason(*reason)); 2],
            (Ok(_), Some(same)) => [Bend::NoFlip, Bend::Flip].map(|bend| Plan::Again(V::branch(*same, bend))),
            (Ok(placed), None) => task.bend(*posture, placed, doubt),
        };
    }
    let mut bent: Option<&Doubt<T>> = None;
    for (posture, both) in ArmPosture::ALL.iter().zip(&mut plans) {
        let Some(doubt) = posture.of(&doubts) else { continue };
        if !doubt.is_likeliest(view, &doubts) || bent.is_some_and(|bent| bent.is_like(doubt)) {
            continue;
        }
        match straight::straightened(view, &task.target, doubt) {
            Some((rows, family)) => {
                *both = task.family(*posture, &Placed { rows, ..doubt.placed }, family);
            }
            None => bent = Some(doubt),
        }
    }
    let rims = beyond::rims(&task, &base, placements, &plans);
    if let Some(rims) = &rims {
        beyond::replaced(&task, (&base, rims), placements, &mut plans);
    }
    rim::reached(&task, placements, &mut plans);
    // What small steps cannot bring nearer is no round-off of a figure in a plane: the arm does not reach the pose in this way.
    let is_compromise = |residual: T, free: &Free<6>| {
        let is_planar = !matches!(base, Base::General(_));
        is_planar && *free == Free::NOTHING && residual > T::lit(SETTLED) * T::EPS
    };
    let mut solutions = Solutions::none(sliding(&V::Arm::JOINTS), Reason::NotFinite);
    for (bend, flip) in [(Bend::NoFlip, false), (Bend::Flip, true)] {
        let plans = plans.each_ref().map(|[noflip, with]| if flip { with } else { noflip });
        let (q, residuals) = task.tried(plans);
        for (lane, (posture, plan)) in ArmPosture::ALL.iter().zip(plans).enumerate() {
            let branch = V::branch(*posture, bend);
            let slot = match plan {
                Plan::Try(_, margins, free) => {
                    let q = pose::column(q.each_ref().map(|value| value.lane(lane)));
                    let (q, residual) = task.polished(q, residuals.lane(lane));
                    match accepted(residual) {
                        Ok(residual) if is_compromise(residual, free) => {
                            Slot::Empty(Reason::Inaccurate { residual })
                        }
                        Ok(residual) => {
                            Slot::Solved(Solution { branch, q, residual, margins: *margins, free: *free })
                        }
                        Err(reason) => Slot::Empty(reason),
                    }
                }
                Plan::Again(with) => Slot::Merged { with: *with },
                Plan::Empty(reason) | Plan::Rim(_, _, reason) => Slot::Empty(*reason),
            };
            solutions.put(branch, slot);
        }
    }
    solutions.settle_mergers();
    if let Some(rims) = &rims {
        beyond::added(&task, (&base, rims), placements, &plans, &mut solutions);
    }
    solutions.merge(base.reach());
    solutions
}

/// What is to become of one slot.
#[derive(Clone, Copy)]
pub(super) enum Plan<T: Float, B> {
    /// Row values that forward kinematics may confirm, and what is known of them.
    Try([T; 6], Margins<T>, Free<6>),
    /// What becomes of another slot: the two branches differ by their names only.
    Again(B),
    /// It stays empty.
    Empty(Reason<T>),
    /// It stays empty unless the bend that is missing is round-off of the base: the row values, the sphere's at the rim of its
    /// cone.
    Rim([T; 6], T, Reason<T>),
}

/// What is asked of an arm: the pose, and row values for coordinates that it leaves free.
pub(super) struct Task<'a, T: Float, V> {
    pub(super) view: &'a V,
    pub(super) target: Target<T>,
    /// For the base's first two joints.
    held: [Option<T>; 2],
    /// For the sphere's first.
    outer: Option<T>,
}

impl<T: Float, V: View> Task<'_, T, V> {
    /// The two slots of one placement of the wrist centre, and whether they may be one family but for round-off of the base.
    fn bend(
        &self,
        posture: ArmPosture,
        placed: &Placed<T>,
        doubt: &mut Option<Doubt<T>>,
    ) -> [Plan<T, V::Branch>; 2] {
        let (rows, wrist) = self.reached(placed);
        let placed = &Placed { rows, ..*placed };
        match wrist {
            Wrist::Two { noflip, flip, margin, doubt: family } => {
                *doubt = family.and_then(|family| Doubt::of(margin, family, placed, &self.view.base()));
                let free = self.free(placed, noflip, None);
                let margins = V::margins(placed.shoulder, placed.elbow, margin);
                [noflip, flip].map(|sphere| Plan::Try(V::joined(rows, sphere), margins, free))
            }
            Wrist::Family(family) => self.family(posture, placed, family),
            Wrist::OutOfReach { by, rim } => {
                let [t1, ..] = rows;
                let reason = Reason::OutOfReach { by, towards: Boundary::WristCone, theta1: Some(t1) };
                [Plan::Rim(V::joined(rows, rim), by, V::reason(reason)); 2]
            }
        }
    }

    /// The two slots of a family of the sphere.
    fn family(
        &self,
        posture: ArmPosture,
        placed: &Placed<T>,
        family: WristFamily<T>,
    ) -> [Plan<T, V::Branch>; 2] {
        let member = self.outer.map_or_else(|| family.even(), |first| family.member(first));
        let free = self.free(placed, member, Some(self.line(family.difference)));
        let margins = V::margins(placed.shoulder, placed.elbow, T::lit(0.0));
        let same = Plan::Again(V::branch(posture, Bend::NoFlip));
        [Plan::Try(V::joined(placed.rows, member), margins, free), same]
    }

    /// What a placement leaves free, and the sphere, of which one way is known.
    pub(super) fn free(&self, placed: &Placed<T>, sphere: [T; 3], line: Option<Loose<6>>) -> Free<6> {
        let first = placed.shoulder_free.then(|| self.moving(placed.rows, sphere, 0));
        let second = placed.elbow_free.then(|| self.moving(placed.rows, sphere, 1));
        V::free(first, second, line)
    }

    pub(super) fn wrist(&self, rows: [T; 3]) -> Wrist<T> {
        self.view.angles(&self.view.rotation(rows, &self.target.pose))
    }

    /// Whether a placement leaves joints 1 and 2 of the base free, with nothing to hold on to.
    pub(super) fn at_will(&self, placed: &Placed<T>) -> [bool; 2] {
        let [held1, held2] = self.held;
        [placed.shoulder_free && held1.is_none(), placed.elbow_free && held2.is_none()]
    }

    /// What the wrist makes of a placement. An oblique wrist may not reach where a free joint stands by convention;
    /// then fifteen other values of that joint are tried, for one that reaches or else for the one that misses least.
    fn reached(&self, placed: &Placed<T>) -> ([T; 3], Wrist<T>) {
        let ([t1, t2, t3], [first, second]) = (placed.rows, self.at_will(placed));
        let (mut rows, mut wrist) = (placed.rows, self.wrist(placed.rows));
        if !(first || second) {
            return (rows, wrist);
        }
        for turn in 1..16 {
            let Wrist::OutOfReach { by: least, .. } = wrist else { break };
            let step = math::half_turn::<T>() * T::lit(0.125 * f64::from(turn));
            let turned =
                if first { [math::wrap(t1 + step), t2, t3] } else { [t1, math::wrap(t2 + step), t3] };
            let there = self.wrist(turned);
            if !matches!(there, Wrist::OutOfReach { by, .. } if by >= least) {
                (rows, wrist) = (turned, there);
            }
        }
        (rows, wrist)
    }

    /// The joint values that command the planned row values, joint by joint, and how far forward kinematics of them misses
    /// the pose.
    fn tried(&self, plans: [&Plan<T, V::Branch>; 4]) -> ([Four<T>; 6], Four<T>) {
        // Where nothing is to be tried stand zeros.
        let rows = plans.map(|plan| if let Plan::Try(rows, ..) = plan { *rows } else { [T::lit(0.0); 6] });
        let q = commanded(&V::Arm::JOINTS, self.view.command(transposed(rows)));
        let reached = self.view.arm().fk(&pose::column(q));
        (q, self.target.missed_by_all(&reached))
    }

    /// A solution that misses the pose by more than the rounding of its figures, brought nearer by small steps if they can.
    fn polished(&self, q: Joints<T, 6>, missed: T) -> (Joints<T, 6>, T) {
        let is_rough = missed > T::lit(SETTLED) * T::EPS && is_accepted(missed);
        if is_rough { self.smoothed(q, missed) } else { (q, missed) }
    }

    #[inline(never)]
    fn smoothed(&self, q: Joints<T, 6>, missed: T) -> (Joints<T, 6>, T) {
        let (q, missed) = improved(self.view.arm(), &self.target, (q, missed));
        if missed <= T::lit(SETTLED) * T::EPS {
            return (q, missed);
        }
        // No step comes nearer at once; some that need not may in the end.
        match settle(self.view.arm(), &self.target.pose, &q) {
            Some((settled, less)) if less < missed => {
                (given_out(pose::entries(&settled), &V::Arm::JOINTS), less)
            }
            _ => (q, missed),
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
    fn moving(&self, rows: [T; 3], here: [T; 3], of: u8) -> Loose<6> {
        let joint = V::joint(of);
        let mut set = JointSet::EMPTY.with(usize::from(joint));
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

/// How the tool moves with row values: what these move is what the commanded joints move that they take.
pub(super) fn motion<T: Float, V: View>(view: &V, jacobian: &Jacobian<T, 6>, rows: [T; 6]) -> [T; 6] {
    let mut sum = [T::lit(0.0); 6];
    for (column, share) in jacobian.data.0.iter().zip(view.command(rows)) {
        if share != T::lit(0.0) {
            add(&mut sum, column, share);
        }
    }
    sum
}

/// A value for each of four placements.
type Four<T> = Lanes<T, 4>;

/// Joint by joint what came placement by placement.
fn transposed<T>([a, b, c, d]: [[T; 6]; 4]) -> [Four<T>; 6] {
    let ([a1, a2, a3, a4, a5, a6], [b1, b2, b3, b4, b5, b6]) = (a, b);
    let ([c1, c2, c3, c4, c5, c6], [d1, d2, d3, d4, d5, d6]) = (c, d);
    [
        Lanes([a1, b1, c1, d1]),
        Lanes([a2, b2, c2, d2]),
        Lanes([a3, b3, c3, d3]),
        Lanes([a4, b4, c4, d4]),
        Lanes([a5, b5, c5, d5]),
        Lanes([a6, b6, c6, d6]),
    ]
}

/// Commanded values with their angles in (-π, π].
fn commanded<T: Float>(joints: &[Joint; 6], mut q: [Four<T>; 6]) -> [Four<T>; 6] {
    for (value, joint) in q.iter_mut().zip(joints) {
        if joint.kind == JointKind::Revolute {
            *value = value.wrap();
        }
    }
    q
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
