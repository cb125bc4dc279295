//! Straight lines and circular arcs of the tool.
//!
//! The tool point runs along the line or the arc while the tool turns about one fixed axis, the two in proportion; a trapezoidal
//! or triangular profile gives the time, so that no limit of [`ToolLimits`] is passed. On an arc of radius r the acceleration has
//! a part v²/r towards the centre: of all profiles whose ramp a and cruise v keep a² + v⁴/r² within the square of the limit, the
//! shortest is taken.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use kin_runtime::trajectory::{ToolLimits, ToolPath, TrajectoryError};
//!
//! fn straight<A: InverseKinematics<6>>(arm: &A, q: &Joints<f64, 6>, to: &Pose<f64>) -> Result<usize, TrajectoryError<f64>> {
//!     let limits = ToolLimits { velocity: 0.2, acceleration: 0.5, spin: 1.0, spin_acceleration: 2.0 };
//!     let motion = ToolPath::line(&arm.fk(q), to)?.timed(&limits)?;
//!     let steps = arm.track(q, motion.poses(20.0)?);
//!     Ok(steps.filter(|step| !matches!(step, Step::Continuous(_))).count())
//! }
//! ```

use super::profile::Need;
use super::{Ticks, Trajectory, TrajectoryError, positive, sound};
use crate::ik::target::orthonormal;
use crate::math::{self, Float};
use crate::pose::{self, Pose};
use nalgebra::Vector3;

/// The largest velocities and accelerations of the tool.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ToolLimits<T> {
    /// Of the tool point: the declared unit of length per second.
    pub velocity: T,
    /// Of the tool point, along the path and towards the centre of an arc together: per second squared.
    pub acceleration: T,
    /// Of the tool's orientation: radians per second.
    pub spin: T,
    /// Radians per second squared.
    pub spin_acceleration: T,
}

/// A way of the tool point.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Way<T> {
    Line {
        /// From start to end.
        way: [T; 3],
    },
    Arc {
        centre: [T; 3],
        /// From the centre to the start, and at right angles to it in the sense of travel: both as long as the radius.
        radii: [[T; 3]; 2],
        radius: T,
        angle: T,
    },
}

/// A way of the tool from one pose to another, without times.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ToolPath<T: Float> {
    from: Pose<T>,
    to: Pose<T>,
    way: Way<T>,
    length: T,
    /// The axis about which the tool turns, in base axes, and the whole angle.
    axis: [T; 3],
    turn: T,
}

/// A way of the tool with its times.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ToolMotion<T: Float> {
    path: ToolPath<T>,
    /// From 0 to 1.
    progress: Trajectory<T, 1>,
}

/// Where the tool is at one time, and how it moves.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ToolState<T: Float> {
    /// Seconds from the start.
    pub time: T,
    /// Where the tool is, in the base frame.
    pub pose: Pose<T>,
    /// The velocity of the tool point, in base axes.
    pub linear: Vector3<T>,
    /// The angular velocity of the tool, in base axes.
    pub angular: Vector3<T>,
}

impl<T: Float> ToolPath<T> {
    /// The straight line between two poses.
    ///
    /// # Errors
    /// [`BadPose`](TrajectoryError::BadPose).
    pub fn line(from: &Pose<T>, to: &Pose<T>) -> Result<Self, TrajectoryError<T>> {
        let way = less(pose::rows(to).1, pose::rows(from).1);
        Self::new(from, to, Way::Line { way }, size(way))
    }

    /// The arc of the circle from one pose through a point to another pose.
    ///
    /// # Errors
    /// [`BadPose`](TrajectoryError::BadPose); the three points lie on one line, or two of them are the same.
    pub fn arc(from: &Pose<T>, through: [T; 3], to: &Pose<T>) -> Result<Self, TrajectoryError<T>> {
        let start = pose::rows(from).1;
        let (a, b) = (less(through, start), less(pose::rows(to).1, start));
        let (a_size, b_size) = (size(a), size(b));
        let normal = cross(a, b);
        let area = size(normal);
        // The centre is known to ε divided by this sine.
        let bent = area > math::sqrt(T::EPS) * a_size * b_size;
        if !bent {
            return Err(TrajectoryError::BadPose);
        }
        let axis = normal.map(|x| x / area);
        // The centre of the circle through 0, a and b: (|a|²·b - |b|²·a) × (a × b) / 2|a × b|².
        let difference = less(b.map(|x| x * a_size * a_size), a.map(|x| x * b_size * b_size));
        let offset = cross(difference, axis).map(|x| x / (area + area));
        let centre = plus(start, offset);
        let first = offset.map(|x| -x);
        let second = cross(axis, first);
        let end = less(b, offset);
        let angle = math::atan2(pose::dot(&end, &second), pose::dot(&end, &first));
        let angle = if angle > T::lit(0.0) { angle } else { angle + T::TURN.0 };
        let radius = size(first);
        let way = Way::Arc { centre, radii: [first, second], radius, angle };
        Self::new(from, to, way, radius * angle)
    }

    fn new(from: &Pose<T>, to: &Pose<T>, way: Way<T>, length: T) -> Result<Self, TrajectoryError<T>> {
        let sides = [from, to].map(|end| orthonormal(pose::rows(end).0));
        let [Ok(start), Ok(end)] = sides else { return Err(TrajectoryError::BadPose) };
        let finite = |end: &Pose<T>| pose::rows(end).1.iter().all(|x| math::is_finite(*x));
        if !(finite(from) && finite(to) && math::is_finite(length)) {
            return Err(TrajectoryError::BadPose);
        }
        let (axis, turn) = turn_of(&pose::product(&end, &pose::transposed(&start)));
        Ok(Self { from: *from, to: *to, way, length, axis, turn })
    }

    /// How far the tool point goes, along the path.
    pub fn length(&self) -> T {
        self.length
    }

    /// The angle by which the tool turns, in [0, π].
    pub fn turn(&self) -> T {
        self.turn
    }

    /// The radius of the arc; `None` for a line.
    pub fn radius(&self) -> Option<T> {
        match self.way {
            Way::Line { .. } => None,
            Way::Arc { radius, .. } => Some(radius),
        }
    }

    /// The pose at a part of the way: the start at 0, the end at 1, both exactly, and beyond them.
    pub fn pose(&self, part: T) -> Pose<T> {
        if part >= T::lit(1.0) {
            return self.to;
        }
        if part <= T::lit(0.0) || math::is_nan(part) {
            return self.from;
        }
        let (rotation, start) = pose::rows(&self.from);
        let position = match self.way {
            Way::Line { way } => plus(start, way.map(|x| x * part)),
            Way::Arc { centre, radii: [first, second], angle, .. } => {
                let (s, c) = math::sin_cos(angle * part);
                plus(centre, plus(first.map(|x| x * c), second.map(|x| x * s)))
            }
        };
        pose::from_rows(pose::product(&about(self.axis, self.turn * part), &rotation), position)
    }

    /// The derivative of the position with respect to the part of the way.
    fn tangent(&self, part: T) -> [T; 3] {
        match self.way {
            Way::Line { way } => way,
            Way::Arc { radii: [first, second], angle, .. } => {
                let (s, c) = math::sin_cos(angle * part);
                plus(first.map(|x| -x * s * angle), second.map(|x| x * c * angle))
            }
        }
    }

    /// The shortest motion along the path, at rest at both ends.
    ///
    /// # Errors
    /// [`BadLimit`](TrajectoryError::BadLimit) (of "joint" 0 for the tool point, 1 for the orientation) or
    /// [`OutOfRange`](TrajectoryError::OutOfRange).
    pub fn timed(&self, limits: &ToolLimits<T>) -> Result<ToolMotion<T>, TrajectoryError<T>> {
        let pairs = [(limits.velocity, limits.acceleration), (limits.spin, limits.spin_acceleration)];
        if let Some(joint) = pairs.iter().position(|(v, a)| !(positive(*v) && positive(*a))) {
            return Err(TrajectoryError::BadLimit { joint });
        }
        let zero = T::lit(0.0);
        let mut need = Need::nothing(zero);
        if self.length > zero {
            let (velocity, acceleration) = self.along(limits.velocity, limits.acceleration);
            need = need.with(Need::of(self.length, velocity, acceleration));
        }
        if self.turn > zero {
            need = need.with(Need::of(self.turn, limits.spin, limits.spin_acceleration));
        }
        let duration = need.duration();
        let moves = self.length > zero || self.turn > zero;
        if !sound(duration) || (moves && duration <= zero) {
            return Err(TrajectoryError::OutOfRange);
        }
        let ramp = if moves { need.ramp(duration) } else { zero };
        let [from, to, ramp] = [zero, T::lit(1.0), ramp].map(|x| pose::column([x]));
        Ok(ToolMotion { path: *self, progress: Trajectory { from, to, ramp, duration } })
    }

    /// The cruise and the ramp along the path that leave room for the acceleration towards the centre.
    ///
    /// With the ramp √(a² - v⁴/r²) the duration L/v + v/ramp has the slope -L/v² + (a² + v⁴/r²)/ramp³, which rises with v: its
    /// root is bracketed by 0 and the velocity at which the trapezoid becomes a triangle, v⁴·(1/L² + 1/r²) = a².
    fn along(&self, velocity: T, acceleration: T) -> (T, T) {
        let Way::Arc { radius, .. } = self.way else { return (velocity, acceleration) };
        let triangle = math::sqrt(acceleration) * math::sqrt(self.length)
            / math::sqrt(math::hypot(T::lit(1.0), self.length / radius));
        let inward = |v: T| v * (v / radius) / acceleration;
        let share = |v: T| math::sqrt_or_zero((T::lit(1.0) - inward(v)) * (T::lit(1.0) + inward(v)));
        let slope = |v: T| {
            let (part, ramp) = (inward(v), share(v));
            (T::lit(1.0) + part * part) / (ramp * ramp * ramp) - self.length / v / v * acceleration
        };
        let (mut low, mut high) = (T::lit(0.0), math::min(velocity, triangle));
        if slope(high) > T::lit(0.0) {
            for _ in 0..64 {
                let middle = (low + high) * T::lit(0.5);
                if slope(middle) > T::lit(0.0) { high = middle } else { low = middle }
            }
        }
        (high, acceleration * share(high))
    }
}

impl<T: Float> ToolMotion<T> {
    /// How long it takes, in seconds.
    pub fn duration(&self) -> T {
        self.progress.duration()
    }

    /// The way.
    pub fn path(&self) -> &ToolPath<T> {
        &self.path
    }

    /// The part of the way over time, from 0 to 1.
    pub fn progress(&self) -> &Trajectory<T, 1> {
        &self.progress
    }

    /// Where the tool is at a time from the start, and how it moves; at rest before the start and after the end.
    pub fn at(&self, time: T) -> ToolState<T> {
        let state = self.progress.at(time);
        let ([part], [rate]) = (pose::entries(&state.q), pose::entries(&state.velocity));
        let linear = self.path.tangent(part).map(|x| x * rate);
        let angular = self.path.axis.map(|x| x * self.path.turn * rate);
        ToolState {
            time: state.time,
            pose: self.path.pose(part),
            linear: pose::column(linear),
            angular: pose::column(angular),
        }
    }

    /// The poses at 0, 1/rate, 2/rate, … seconds and at the end, for a [`track`](crate::InverseKinematics::track).
    ///
    /// # Errors
    /// [`BadTime`](TrajectoryError::BadTime) for a rate (in Hz) that is not positive and finite.
    pub fn poses(&self, rate: T) -> Result<ToolPoses<T>, TrajectoryError<T>> {
        Ok(ToolPoses { motion: *self, ticks: Ticks::new(rate, self.duration())? })
    }
}

/// The poses of a tool motion at a steady rate, the end included.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ToolPoses<T: Float> {
    motion: ToolMotion<T>,
    ticks: Ticks<T>,
}

impl<T: Float> Iterator for ToolPoses<T> {
    type Item = Pose<T>;

    fn next(&mut self) -> Option<Pose<T>> {
        self.ticks.next().map(|time| self.motion.at(time).pose)
    }
}

fn plus<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a + x, b + y, c + z]
}

fn less<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a - x, b - y, c - z]
}

fn cross<T: Float>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn size<T: Float>([a, b, c]: [T; 3]) -> T {
    math::hypot(math::hypot(a, b), c)
}

/// The rotation about a unit axis (O. Rodrigues 1840).
fn about<T: Float>([x, y, z]: [T; 3], angle: T) -> [[T; 3]; 3] {
    let (half_s, half_c) = math::sin_cos(angle * T::lit(0.5));
    let (s, back) = (T::lit(2.0) * half_s * half_c, T::lit(2.0) * half_s * half_s);
    let c = T::lit(1.0) - back;
    [
        [c + back * x * x, back * x * y - s * z, back * x * z + s * y],
        [back * x * y + s * z, c + back * y * y, back * y * z - s * x],
        [back * x * z - s * y, back * y * z + s * x, c + back * z * z],
    ]
}

/// Axis and angle, in [0, π], of a rotation: by way of the quaternion whose largest entry is a root (S. Shepperd, "Quaternion
/// from rotation matrix", 1978), so that half a turn keeps its digits.
fn turn_of<T: Float>([[a, b, c], [d, e, f], [g, h, i]]: &[[T; 3]; 3]) -> ([T; 3], T) {
    let (a, b, c, d, e, f, g, h, i) = (*a, *b, *c, *d, *e, *f, *g, *h, *i);
    let one = T::lit(1.0);
    // Each row is the quaternion (w, x, y, z) times four times the entry that it is named for.
    let candidates = [
        [one + a + e + i, h - f, c - g, d - b],
        [h - f, one + a - e - i, b + d, c + g],
        [c - g, b + d, one - a + e - i, f + h],
        [d - b, c + g, f + h, one - a - e + i],
    ];
    let [[ww, ..], [_, xx, ..], [_, _, yy, _], [.., zz]] = candidates;
    let [by_w, by_x, by_y, by_z] = candidates;
    let [w, x, y, z] = match () {
        () if ww >= xx && ww >= yy && ww >= zz => by_w,
        () if xx >= yy && xx >= zz => by_x,
        () if yy >= zz => by_y,
        () => by_z,
    };
    let [w, x, y, z] = if w < T::lit(0.0) { [-w, -x, -y, -z] } else { [w, x, y, z] };
    let sine = size([x, y, z]);
    if sine <= T::lit(0.0) {
        return ([T::lit(0.0), T::lit(0.0), one], T::lit(0.0));
    }
    ([x / sine, y / sine, z / sine], T::lit(2.0) * math::atan2(sine, w))
}
