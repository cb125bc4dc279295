//! The nearest that an arm comes to what is out of its reach.
//!
//! Joint 2 brings two points as near to each other as their heights along its axis and their distances from it differ, or,
//! where it slides, as they lie apart across its direction. So the least distance of the point that three joints carry from
//! a point in space is that of two plane curves: one is run through by joint 3, the other by joint 1 with the point taken
//! back. Both are sampled, and from the nearest pairs of samples a damped Newton method goes on in all three joints, with the
//! whole second derivative of the squared distance, because the distance is not small. The number of steps is bounded.
//!
//! An arm with a spherical shoulder is looked at from its tool: in the orientation asked for the shoulder's centre is as far from
//! where the last three joints bring it as the tool point is from where it is asked for. Two joints are three of which the first
//! has nothing to turn.
//!
//! What is given out are joint values and the pose that forward kinematics makes of them: it is reached by construction.

use crate::arm::{Arm, InverseKinematics};
use crate::ik::general::{Axis, GeneralBase, Sized, cross, largest, length, less, plus};
use crate::ik::sphere::View;
use crate::ik::target::{self, Target};
use crate::ik::wrist::Wrist;
use crate::ik::{given_out, spherical_shoulder, spherical_wrist};
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose, dot};
use crate::private::{SolvePair, SolvePosition, SolveShoulder, SolveWrist};
use crate::solutions::{Posture, Reason, ShoulderPosture};
use nalgebra::Point3;

/// Samples of each curve.
const SAMPLES: usize = 48;

/// Pairs of samples from which the search goes on.
const STARTS: usize = 4;

/// Steps of a search at most.
const STEPS: usize = 64;

/// How far, in sizes of the arm, a slide is looked at from where it passes axis 2: no farther does one have to go for a point within
/// the arm's size.
const TRAVEL: f64 = 4.0;

/// The nearest pose that an arm reaches, and how it does.
#[derive(Clone, Copy, Debug)]
pub struct Closest<T, const N: usize> {
    /// Joint values that reach it, angles in (-π, π]. Limits are not applied.
    pub q: Joints<T, N>,
    /// The pose: forward kinematics of `q`.
    pub pose: Pose<T>,
    /// The distance of the tool point from the one that was asked for: round-off if that is reached.
    pub by: T,
    /// The angle between the orientations, in radians: more than round-off only where an oblique wrist or shoulder cannot follow.
    pub turned: T,
}

/// An arm that knows the nearest pose to one that it cannot reach: six joints with an inverse.
pub trait ClosestPose<const N: usize>: Arm<N> {
    /// Of the poses in the orientation asked for, the one that is reached and whose tool point is nearest. Where an oblique
    /// wrist, or shoulder, cannot turn the tool so, there, it is turned about the wrist's centre, or the shoulder's, by the smallest
    /// angle that lets it follow, and by 64√ε more.
    ///
    /// The distance is the least there is, to round-off; a second minimum that is narrower than a 48th of a joint's range may
    /// be missed.
    ///
    /// # Errors
    /// What is wrong with the arm or the pose; a pose so far away that the arm is round-off of the distance is out of reach.
    fn closest<T: Float>(&self, pose: &Pose<T>) -> Result<Closest<T, N>, Reason<T>>;
}

/// An arm that knows the nearest position to one that its tool point cannot reach: two or three joints that are solved from one.
pub trait ClosestPoint<const N: usize>: Arm<N> {
    /// As [`ClosestPose::closest`], from a position; `turned` is zero.
    ///
    /// # Errors
    /// As there.
    fn closest_point<T: Float>(&self, p: &Point3<T>) -> Result<Closest<T, N>, Reason<T>>;
}

impl<A: InverseKinematics<6>> ClosestPose<6> for A
where
    A::Branch: Nearest<A>,
{
    fn closest<T: Float>(&self, pose: &Pose<T>) -> Result<Closest<T, 6>, Reason<T>> {
        A::Branch::nearest(self, pose)
    }
}

/// From which of its ends an arm of six joints is brought near, by the labels of its solutions.
pub trait Nearest<A> {
    /// As [`ClosestPose::closest`].
    ///
    /// # Errors
    /// As there.
    fn nearest<T: Float>(arm: &A, pose: &Pose<T>) -> Result<Closest<T, 6>, Reason<T>>;
}

impl<A: SolveWrist<6>> Nearest<A> for Posture {
    fn nearest<T: Float>(arm: &A, pose: &Pose<T>) -> Result<Closest<T, 6>, Reason<T>> {
        seen(&spherical_wrist::FromBase(arm), pose)
    }
}

impl<A: SolveShoulder<6>> Nearest<A> for ShoulderPosture {
    fn nearest<T: Float>(arm: &A, pose: &Pose<T>) -> Result<Closest<T, 6>, Reason<T>> {
        seen(&spherical_shoulder::FromTool(arm), pose)
    }
}

/// The nearest pose of an arm, seen from the end at which its base is.
fn seen<T: Float, V: View>(view: &V, pose: &Pose<T>) -> Result<Closest<T, 6>, Reason<T>> {
    let (arm, base) = (view.arm(), view.base::<T>());
    let target = Target::new(pose, &base)?;
    let rows = base.lines().closest(view.centre(&target.pose));
    let sphere = followed(view, rows, &target.pose).map_err(V::reason)?;
    let q = given_out(view.command(V::joined(rows, sphere)), &V::Arm::JOINTS);
    Ok(told(arm, q, &target.pose))
}

impl<A: SolvePosition<3>> ClosestPoint<3> for A {
    fn closest_point<T: Float>(&self, p: &Point3<T>) -> Result<Closest<T, 3>, Reason<T>> {
        let base = self.base::<T>();
        let wanted = point(p, base.is_finite(), base.reach())?;
        Ok(put(self, self.command(base.lines().closest(self.tool_point(p))), wanted))
    }
}

impl<A: SolvePair<2>> ClosestPoint<2> for A {
    fn closest_point<T: Float>(&self, p: &Point3<T>) -> Result<Closest<T, 2>, Reason<T>> {
        let base = self.base::<T>();
        let wanted = point(p, base.is_finite(), base.reach)?;
        Ok(put(self, self.command(base.closest(self.tool_point(p))), wanted))
    }
}

/// The coordinates of a point that can be asked for.
fn point<T: Float>(p: &Point3<T>, finite: bool, reach: T) -> Result<[T; 3], Reason<T>> {
    let wanted = pose::entries(&p.coords);
    if finite { target::size(&wanted, reach).map(|_| wanted) } else { Err(Reason::NotAnArm) }
}

/// Where commanded values put the tool, in whatever orientation.
fn put<T: Float, const N: usize, A: Arm<N>>(arm: &A, values: [T; N], wanted: [T; 3]) -> Closest<T, N> {
    let q = given_out(values, &A::JOINTS);
    let (rotation, _) = pose::rows(&arm.fk(&q));
    told(arm, q, &pose::from_rows(rotation, wanted))
}

/// The pose of joint values and how far it is from another.
fn told<T: Float, const N: usize, A: Arm<N>>(arm: &A, q: Joints<T, N>, wanted: &Pose<T>) -> Closest<T, N> {
    let pose = arm.fk(&q);
    let ((rotation, [x, y, z]), (other, [a, b, c])) = (pose::rows(&pose), pose::rows(wanted));
    let by = math::hypot(math::hypot(x - a, y - b), z - c);
    Closest { q, pose, by, turned: pose::angle_between(&rotation, &other) }
}

/// Row values of the wrist for a pose, or for the nearest orientation that it can follow: axis 6 turned towards axis 4 or away. Of a
/// shoulder, axis 3 towards axis 1 or away.
fn followed<T: Float, V: View>(view: &V, rows: [T; 3], wanted: &Pose<T>) -> Result<[T; 3], Reason<T>> {
    let any = |pose: &Pose<T>| match view.angles(&view.rotation(rows, pose)) {
        Wrist::Two { noflip, .. } => Ok(noflip),
        Wrist::Family(family) => Ok(family.even()),
        Wrist::OutOfReach { by, rim } => Err((by, rim)),
    };
    let (missing, [a, b, c]) = match any(wanted) {
        Ok(angles) => return Ok(angles),
        Err(beyond) => beyond,
    };
    let turned = |sphere| {
        let q = given_out(view.command(V::joined(rows, sphere)), &V::Arm::JOINTS);
        let (rotation, _) = pose::rows(&view.arm().fk(&q));
        rotation
    };
    let (on_rim, quarter) = (turned([a, b, c]), math::half_turn::<T>() * T::lit(0.5));
    // What a quarter turn of a joint does to the tool is a quarter turn about the joint's axis.
    let axis = |sphere| {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] =
            pose::product(&turned(sphere), &pose::transposed(&on_rim));
        [zy - yz, xz - zx, yx - xy].map(|twice| twice * T::lit(0.5))
    };
    // On the rim the three axes lie in one plane.
    let normal = cross(axis([a + quarter, b, c]), axis([a, b, c + quarter]));
    let size = math::max(length(normal), T::EPS);
    let normal = Axis { slides: false, direction: normal.map(|x| x / size), point: [T::lit(0.0); 3] };
    let (rotation, position) = pose::rows(wanted);
    // On the rim itself round-off would decide, which a stretched elbow magnifies to its square root.
    let enough = missing + T::lit(64.0) * math::sqrt(T::EPS);
    for angle in [enough, -enough] {
        let columns = pose::transposed(&rotation).map(|column| normal.turned(column, angle));
        if let Ok(angles) = any(&pose::from_rows(pose::transposed(&columns), position)) {
            return Ok(angles);
        }
    }
    Err(Reason::OutOfReach { by: missing, towards: crate::Boundary::WristCone, theta1: None })
}

/// A pair of samples: the squared distance and the values of joints 1 and 3.
#[derive(Clone, Copy)]
struct Pair<T> {
    square: T,
    first: T,
    third: T,
}

impl<T: Float> GeneralBase<T> {
    /// The row values that bring the carried point nearest to `p`.
    pub(super) fn closest(&self, p: [T; 3]) -> [T; 3] {
        let sized = self.sized(p, self.reach);
        let mut best: Option<([T; 3], T)> = None;
        for start in sized.starts().into_iter().flatten() {
            let (values, miss) =
                sized.searched([start.first, sized.second(start.first, start.third), start.third]);
            if best.is_none_or(|(_, least)| miss < least) {
                best = Some((values, miss));
            }
        }
        let values = best.map_or([T::lit(0.0); 3], |(values, _)| values);
        self.rows(values, self.reach)
    }
}

impl<T: Float> Sized<T> {
    /// Value number `sample` of a joint that moves a point: over a turn, or over the travel of a slide.
    fn value(&self, axis: &Axis<T>, point: [T; 3], sample: usize) -> T {
        let share = T::lit(sample as f64 / SAMPLES as f64 - 0.5);
        if !axis.slides {
            return share * T::TURN.0;
        }
        // As far again as the point is away; closer together where the slide passes axis 2, to whose sides there is one minimum each.
        let [_, second, _] = &self.axes;
        let across = plus(axis.direction, second.direction, -dot(&axis.direction, &second.direction));
        let passed = -dot(&across, &second.arm(point)) / math::max(dot(&across, &across), T::EPS);
        let (far, share) = (T::lit(TRAVEL) + largest(self.point), share * T::lit(2.0));
        passed + far * share * math::abs(share)
    }

    /// What joint 2 cannot change of a point.
    fn kept(&self, point: [T; 3]) -> [T; 3] {
        let [_, second, _] = &self.axes;
        let arm = second.arm(point);
        if second.slides {
            return arm;
        }
        let along = dot(&second.direction, &less(point, second.point));
        [along, math::sqrt(dot(&arm, &arm)), T::lit(0.0)]
    }

    /// Joint 2, once the others are set: what brings the two points nearest to each other.
    fn second(&self, first: T, third: T) -> T {
        let [one, two, three] = &self.axes;
        let (from, to) = (three.moved(self.carried, third), one.moved(self.point, -first));
        if two.slides {
            return dot(&two.direction, &less(to, from));
        }
        let (arm, goal) = (two.arm(from), two.arm(to));
        math::atan2(dot(&two.direction, &cross(arm, goal)), dot(&arm, &goal))
    }

    /// The nearest pairs of samples, each nearer than its neighbours on the third joint's curve; the best first.
    fn starts(&self) -> [Option<Pair<T>>; STARTS] {
        let [one, _, three] = &self.axes;
        let mut goals = [(T::lit(0.0), [T::lit(0.0); 3]); SAMPLES];
        for (sample, goal) in goals.iter_mut().enumerate() {
            let back = self.value(one, self.point, sample);
            *goal = (-back, self.kept(one.moved(self.point, back)));
        }
        let mut pairs = [Pair { square: T::lit(0.0), first: T::lit(0.0), third: T::lit(0.0) }; SAMPLES];
        for (sample, pair) in pairs.iter_mut().enumerate() {
            pair.third = self.value(three, self.carried, sample);
            let here = self.kept(three.moved(self.carried, pair.third));
            for (other, (first, goal)) in goals.iter().enumerate() {
                let way = less(*goal, here);
                let square = dot(&way, &way);
                if other == 0 || square < pair.square {
                    (pair.square, pair.first) = (square, *first);
                }
            }
        }
        let before = pairs.iter().cycle().skip(SAMPLES - 1);
        let after = pairs.iter().cycle().skip(1);
        let mut best = [None; STARTS];
        for ((pair, before), after) in pairs.iter().zip(before).zip(after) {
            if pair.square <= before.square && pair.square <= after.square {
                insert(&mut best, *pair);
            }
        }
        best
    }

    /// The nearest place around some figure values, and how far it is.
    fn searched(&self, mut values: [T; 3]) -> ([T; 3], T) {
        let [one, two, three] = &self.axes;
        let mut stance = self.stance(values, false);
        let mut square = dot(&stance.missed, &stance.missed);
        let mut damping = T::lit(1e-3);
        for _ in 0..STEPS {
            let ([j1, j2, j3], e) = (stance.velocities, stance.missed);
            let [_, v2, _] = values;
            let slope = [dot(&j1, &e), dot(&j2, &e), dot(&j3, &e)];
            // A turning joint bends the way of the points beyond it; a sliding one does not.
            let bent = |axis: &crate::Axis<T>, direction: [T; 3], velocity: [T; 3]| {
                if axis.slides { T::lit(0.0) } else { dot(&cross(direction, velocity), &e) }
            };
            let (z1, z2, z3) = (one.direction, two.direction, two.turned(three.direction, v2));
            let row = |a: [T; 3], b: [T; 3], bend: T| dot(&a, &b) - bend;
            let (xx, xy, xz) = (
                row(j1, j1, bent(one, z1, j1)),
                row(j1, j2, bent(one, z1, j2)),
                row(j1, j3, bent(one, z1, j3)),
            );
            let (yy, yz) = (row(j2, j2, bent(two, z2, j2)), row(j2, j3, bent(two, z2, j3)));
            let zz = row(j3, j3, bent(three, z3, j3));
            let size = math::abs(xx) + math::abs(yy) + math::abs(zz) + T::EPS;
            let more = damping * size;
            let step = solved([[xx + more, xy, xz], [xy, yy + more, yz], [xz, yz, zz + more]], slope);
            let ([a, b, c], [d1, d2, d3]) = (values, step);
            let next = [a + d1, b + d2, c + d3];
            let there = self.stance(next, false);
            let now = dot(&there.missed, &there.missed);
            if now < square {
                (values, stance, square) = (next, there, now);
                damping *= T::lit(0.0625);
            } else if damping > T::lit(1e6) || largest(step) <= T::EPS {
                break;
            } else {
                damping = math::max(damping * T::lit(16.0), T::EPS);
            }
        }
        (values, math::sqrt(square))
    }
}

/// Keeps the best pairs in rising order.
fn insert<T: Float>(best: &mut [Option<Pair<T>>; STARTS], pair: Pair<T>) {
    let mut carried = pair;
    for place in best {
        match place {
            None => {
                *place = Some(carried);
                return;
            }
            Some(held) if carried.square < held.square => core::mem::swap(held, &mut carried),
            Some(_) => {}
        }
    }
}

/// The solution of three equations by Cramer's rule; nothing where they have none.
fn solved<T: Float>([r0, r1, r2]: [[T; 3]; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    let (k0, k1, k2) = (cross(r1, r2), cross(r2, r0), cross(r0, r1));
    let determinant = dot(&r0, &k0);
    let ([a, b, c], [d, e, f], [g, h, i]) = (k0, k1, k2);
    let step = [a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z].map(|s| s / determinant);
    if step.iter().all(|s| math::is_finite(*s)) { step } else { [T::lit(0.0); 3] }
}
