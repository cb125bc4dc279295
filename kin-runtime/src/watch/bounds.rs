//! How fast an arm's figures can change along a trajectory: bounds that hold for every instant of an interval.
//!
//! In units of the reach, every column of the normalised Jacobian is built of vectors carried by links. With S the sum of all
//! joint rates and A that of all accelerations (a slide's divided by the reach), a link turns with S at most; so a vector of
//! size g has a first derivative of gS and a second of g(2S² + A) at most, and a column (linear and angular part together) one
//! of √2·(2S² + A)·g. What turns the whole arm about does not count: singular values and determinants do not see it. With the
//! angular velocity Ω of any link taken off, the first derivative is J̇ - Ω × J, and the second gains 2S·S + S²·g at most.
//!
//! Joint rates are those of the rows of the table: couplings are read off the frames, which every arm has.

use super::factors::Factor;
use crate::arm::{Arm, JointKind};
use crate::dual::{self, Dual};
use crate::math::{self, Float};
use crate::pose::{self, Jacobian, Pose};
use crate::trajectory::Trajectory;

/// Bounds for one trajectory of one arm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Bounds<T> {
    /// S, with g in it: the largest sum of rates at any instant.
    rate: T,
    /// A, the same of accelerations.
    acceleration: T,
    /// g: the size of the longest lever in reaches; more than 1 only where a slide is beyond its range.
    lever: T,
    /// What couplings make of a bound on columns: the Frobenius norm of the sums of their columns.
    spread: T,
}

impl<T: Float> Bounds<T> {
    pub(super) fn new<const N: usize, A: Arm<N>>(arm: &A, trajectory: &Trajectory<T, N>) -> Self {
        let (zero, one, reach) = (T::lit(0.0), T::lit(1.0), T::lit(arm.reach()));
        let (mut turning, mut sliding) = ([zero; 2], [zero; 2]);
        let (mut beyond, mut spread) = (zero, zero);
        for (index, profile) in trajectory.profiles().enumerate() {
            let (rate, push) = (math::abs(profile.velocity()), math::abs(profile.acceleration()));
            let far = math::max(math::abs(profile.from()), math::abs(profile.to()));
            let mut sum = zero;
            for (kind, part) in coupled(arm, index) {
                let [rates, pushes] = if kind == JointKind::Revolute { &mut turning } else { &mut sliding };
                *rates += part * rate;
                *pushes += part * push;
                if kind == JointKind::Prismatic {
                    beyond += part * far;
                }
                sum += part;
            }
            spread = math::hypot(spread, sum);
        }
        let lever = one + beyond / reach;
        let ([rate, push], [slide, slide_push]) = (turning, sliding);
        Self {
            rate: lever * rate + slide / reach,
            acceleration: lever * push + slide_push / reach,
            lever,
            spread,
        }
    }

    /// S² and A together, as a vector's second derivative has them.
    fn second(&self) -> T {
        T::lit(2.0) * self.rate * self.rate + self.acceleration
    }

    /// How far the normalised Jacobian, but for a turn of the whole arm, can be from its value at the middle of an interval of
    /// that half width, and how far from the straight line that it sets out on: both in the Frobenius norm.
    pub(super) fn matrix<const N: usize>(&self, jacobian: &Jacobian<Dual<T>, N>, half: T) -> (T, T) {
        let curvature = self.second() + T::lit(3.0) * self.rate * self.rate;
        let bend = T::lit(core::f64::consts::SQRT_2) * self.spread * self.lever * curvature;
        let aside = T::lit(0.5) * bend * half * half;
        (slope(jacobian, self.rate) * half + aside, aside)
    }

    /// How far a factor can be from its value at the middle: a product of vectors.
    pub(super) fn factor(&self, factor: Factor, rate: T, half: T) -> T {
        let (degree, mut size) = (T::lit(factor.degree() as f64), T::lit(1.0));
        for _ in 0..factor.degree() {
            size *= self.lever;
        }
        let squares = degree * (degree - T::lit(1.0)) * self.rate * self.rate;
        let bend = size * (degree * self.second() + squares);
        math::abs(rate) * half + T::lit(0.5) * bend * half * half
    }
}

/// The rows of the table that a commanded joint moves, and how many units of each it moves by: the relative motion of frames.
fn coupled<T: Float, const N: usize, A: Arm<N>>(arm: &A, joint: usize) -> [(JointKind, T); N] {
    let (zero, mut unit) = (T::lit(0.0), [T::lit(0.0); N]);
    if let Some(rate) = unit.get_mut(joint) {
        *rate = T::lit(1.0);
    }
    let frames = arm.frames(&dual::moving(&pose::column([zero; N]), &pose::column(unit)));
    let (mut before, mut parts) = (Motion::rest(), A::JOINTS.map(|joint| (joint.kind, zero)));
    for ((kind, part), frame) in parts.iter_mut().zip(&frames) {
        let now = Motion::of(frame);
        *part = now.beyond(&before, *kind);
        before = now;
    }
    parts
}

/// How a frame moves.
struct Motion<T> {
    place: [T; 3],
    velocity: [T; 3],
    spin: [T; 3],
}

impl<T: Float> Motion<T> {
    /// That of the base.
    fn rest() -> Self {
        let none = [T::lit(0.0); 3];
        Self { place: none, velocity: none, spin: none }
    }

    fn of(frame: &Pose<Dual<T>>) -> Self {
        let (rotation, position) = pose::rows(frame);
        let (now, change) =
            (rotation.map(|row| row.map(|x| x.value)), rotation.map(|row| row.map(|x| x.rate)));
        let [[_, _, y], [z, _, _], [_, x, _]] = pose::product(&change, &pose::transposed(&now));
        Self { place: position.map(|x| x.value), velocity: position.map(|x| x.rate), spin: [x, y, z] }
    }

    /// How fast it turns, or slides, with respect to another.
    fn beyond(&self, other: &Self, kind: JointKind) -> T {
        let less = |[a, b, c]: [T; 3], [x, y, z]: [T; 3]| [a - x, b - y, c - z];
        let size = |[a, b, c]: [T; 3]| math::hypot(math::hypot(a, b), c);
        if kind == JointKind::Revolute {
            return size(less(self.spin, other.spin));
        }
        let ([a, b, c], [x, y, z]) = (other.spin, less(self.place, other.place));
        let carried = [b * z - c * y, c * x - a * z, a * y - b * x];
        size(less(less(self.velocity, other.velocity), carried))
    }
}

/// The norm of J̇, or of what is left of it when a turn of no more than `most` is taken off: the smallest of some. For each column
/// that is the least turn that moves its axis as it moves.
fn slope<T: Float, const N: usize>(jacobian: &Jacobian<Dual<T>, N>, most: T) -> T {
    let (columns, zero) = (&jacobian.data.0, T::lit(0.0));
    let mut least = without(columns, [zero; 3]);
    for [_, _, _, x, y, z] in columns {
        let ([a, b, c], [d, e, f]) = ([x.value, y.value, z.value], [x.rate, y.rate, z.rate]);
        let size = a * a + b * b + c * c;
        let turn = [b * f - c * e, c * d - a * f, a * e - b * d].map(|x| x / size);
        // Couplings can make an axis of little more than nothing, and its turn large or no number.
        let [x, y, z] = turn;
        if math::hypot(math::hypot(x, y), z) <= most {
            least = math::min(without(columns, turn), least);
        }
    }
    least
}

/// The Frobenius norm of J̇ - Ω × J.
fn without<T: Float>(columns: &[[Dual<T>; 6]], [x, y, z]: [T; 3]) -> T {
    let mut sum = T::lit(0.0);
    for [a, b, c, d, e, f] in columns {
        for [a, b, c] in [[a, b, c], [d, e, f]] {
            let rest = [
                a.rate - (y * c.value - z * b.value),
                b.rate - (z * a.value - x * c.value),
                c.rate - (x * b.value - y * a.value),
            ];
            sum = rest.into_iter().fold(sum, |sum, entry| sum + entry * entry);
        }
    }
    math::sqrt(sum)
}
