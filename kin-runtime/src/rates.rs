//! Velocity and force: joint rates for a twist, twists from rates, torques from a wrench, and how the Jacobian itself changes.
//!
//! A [`Twist`] is the linear velocity of the tool point and the angular velocity of the tool, a [`Wrench`] the force at that point
//! and the moment; both in base axes. Lengths are in the declared unit, angles in radians, times in seconds.
//!
//! # Near a singular pose
//!
//! In the directions u of the normalised Jacobian's singular values σ, [`rates`] gives v·(u·t)/σ, which is exact; a direction with
//! σ below [`Damping::below`] gives v·(u·t)·σ/(σ² + λ²) instead, with λ² rising smoothly from 0 to [`Damping::most`]² where σ is
//! 0 (Y. Nakamura and H. Hanafusa, "Inverse kinematic solutions with singularity robustness", 1986; A. Maciejewski and C. Klein,
//! "Numerical filtering for the operation of robotic manipulators through kinematically singular configurations", 1988). What
//! other directions ask for is met exactly; how much was damped, and what of the twist is missed, is told.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use kin_runtime::rates::{Damping, Wrench, rates, torques};
//!
//! fn descend<A: Arm<6>>(arm: &A, q: &Joints<f64, 6>) -> Option<Joints<f64, 6>> {
//!     let down = joints![0.0, 0.0, -0.1, 0.0, 0.0, 0.0];
//!     let found = rates(arm, q, &down, &Damping::default()).ok()?;
//!     // What each motor holds while the tool is pressed with 20 N.
//!     let _held = torques(arm, q, &Wrench::from([0.0, 0.0, -20.0, 0.0, 0.0, 0.0]));
//!     (found.damping == 0.0).then_some(found.velocity)
//! }
//! ```

use crate::arm::Arm;
use crate::dual::{self, Dual};
use crate::math::{self, Float};
use crate::pose::{self, Jacobian, Joints};
use crate::singularity::{Direction, directions, in_reaches, length, linear, product, units};
use core::fmt;
use nalgebra::{SVector, Vector3};

/// Linear, then angular velocity, in base axes: what J·q̇ is.
pub type Twist<T> = SVector<T, 6>;

/// Force, then moment about the tool point, in base axes. A moment is in units of force times the declared unit of length.
pub type Wrench<T> = SVector<T, 6>;

/// How joint rates are kept bounded near a singular pose; singular values are those of the
/// [normalised](crate::singularity::normalised) Jacobian.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Damping<T> {
    /// Directions with a singular value of at least this are not damped.
    pub below: T,
    /// λ in a direction that is lost altogether. Of a unit twist it makes rates of 1/(2λ) at most.
    pub most: T,
}

/// Joint rates, and how far they are from what was asked for.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Rates<T, const N: usize> {
    /// Of the joints: radians, or the declared unit of length, per second. Of all that give the same twist the least.
    pub velocity: Joints<T, N>,
    /// The largest λ that was used; 0 if nothing was damped.
    pub damping: T,
    /// The largest entry of what of the twist is missed, linear entries in reaches: by damping, or because fewer than six joints
    /// cannot make it.
    pub missed: T,
    /// The smallest singular value.
    pub margin: T,
}

/// Why there are no joint rates.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RateError<T> {
    /// A joint value, an entry of the twist or a length of the arm is not finite, or the rates are beyond the number type.
    NotFinite,
    /// The pose is singular to the last bits, and no damping was allowed.
    Singular {
        /// The smallest singular value.
        margin: T,
    },
}

impl<T: Float> Damping<T> {
    /// None at all: every direction exact, and an error in a singular pose.
    pub fn none() -> Self {
        Self { below: T::lit(0.0), most: T::lit(0.0) }
    }

    /// λ² of a direction.
    fn squared(&self, value: T) -> T {
        let share = value / self.below;
        if value < self.below { (T::lit(1.0) - share * share) * self.most * self.most } else { T::lit(0.0) }
    }
}

/// Below 0.01, by 0.005 at most: for arms with margins of about 0.1.
impl<T: Float> Default for Damping<T> {
    fn default() -> Self {
        Self { below: T::lit(0.01), most: T::lit(0.005) }
    }
}

/// The twist that joint rates give the tool: J·q̇.
pub fn twist<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    velocity: &Joints<T, N>,
) -> Twist<T> {
    applied(&arm.jacobian(q), velocity)
}

/// The joint rates that give the tool a twist.
///
/// # Errors
/// [`RateError::NotFinite`]; [`RateError::Singular`] with [`Damping::none`] alone.
pub fn rates<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    twist: &Twist<T>,
    damping: &Damping<T>,
) -> Result<Rates<T, N>, RateError<T>> {
    let reach = T::lit(arm.reach());
    solved::<T, N, A>(
        &in_reaches(&arm.jacobian(q), &A::JOINTS, reach),
        in_parts(twist, reach),
        (6, reach),
        damping,
    )
}

/// The joint rates that give the tool point a velocity, its orientation left to itself.
///
/// # Errors
/// As [`rates`].
pub fn position_rates<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    velocity: &Vector3<T>,
    damping: &Damping<T>,
) -> Result<Rates<T, N>, RateError<T>> {
    let (reach, zero) = (T::lit(arm.reach()), T::lit(0.0));
    let jacobian = linear(&in_reaches(&arm.jacobian(q), &A::JOINTS, reach));
    let [x, y, z] = pose::entries(velocity);
    let twist = in_parts(&pose::column([x, y, z, zero, zero, zero]), reach);
    solved::<T, N, A>(&jacobian, twist, (3, reach), damping)
}

/// The torques (forces, for sliding joints) that hold a wrench which the tool exerts: Jᵀ·w, by the principle of virtual work.
/// They are in units of force times the declared unit of length; the weight of the arm is not in them.
pub fn torques<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    wrench: &Wrench<T>,
) -> Joints<T, N> {
    let wrench = pose::entries(wrench);
    pose::column(arm.jacobian(q).data.0.map(|column| product(&column, &wrench)))
}

/// J̇: how the Jacobian changes while the joints move, exactly but for round-off.
pub fn jacobian_rate<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    velocity: &Joints<T, N>,
) -> Jacobian<T, N> {
    let moving = arm.jacobian(&dual::moving(q, velocity));
    crate::private::jacobian(moving.data.0.map(|column| column.map(|entry: Dual<T>| entry.rate)))
}

/// The acceleration of the tool, linear then angular: J·q̈ + J̇·q̇.
pub fn acceleration<T: Float, const N: usize, A: Arm<N>>(
    arm: &A,
    q: &Joints<T, N>,
    velocity: &Joints<T, N>,
    acceleration: &Joints<T, N>,
) -> Twist<T> {
    let moving = arm.jacobian(&dual::moving(q, velocity));
    let (mut sum, rates) = ([T::lit(0.0); 6], pose::entries(velocity).into_iter());
    for ((column, rate), push) in moving.data.0.into_iter().zip(rates).zip(pose::entries(acceleration)) {
        for (sum, entry) in sum.iter_mut().zip(column) {
            *sum += entry.value * push + entry.rate * rate;
        }
    }
    pose::column(sum)
}

/// A matrix times a column.
fn applied<T: Float, const N: usize>(jacobian: &Jacobian<T, N>, velocity: &Joints<T, N>) -> Twist<T> {
    let mut sum = [T::lit(0.0); 6];
    for (column, rate) in jacobian.data.0.into_iter().zip(pose::entries(velocity)) {
        for (sum, entry) in sum.iter_mut().zip(column) {
            *sum += entry * rate;
        }
    }
    pose::column(sum)
}

/// A twist with its linear entries in reaches.
fn in_parts<T: Float>(twist: &Twist<T>, reach: T) -> Twist<T> {
    let [x, y, z, a, b, c] = pose::entries(twist);
    pose::column([x / reach, y / reach, z / reach, a, b, c])
}

/// Joint rates in the directions of a normalised Jacobian.
fn solved<T: Float, const N: usize, A: Arm<N>>(
    jacobian: &Jacobian<T, N>,
    twist: Twist<T>,
    (rows, reach): (usize, T),
    damping: &Damping<T>,
) -> Result<Rates<T, N>, RateError<T>> {
    let finite =
        jacobian.data.0.iter().flatten().chain(twist.data.0.iter().flatten()).all(|x| math::is_finite(*x));
    if !finite {
        return Err(RateError::NotFinite);
    }
    let zero = T::lit(0.0);
    let directions = directions(jacobian);
    let counted = directions.get(..rows.min(N)).unwrap_or(&[]);
    let margin = counted.last().map_or(zero, |direction| length(&direction.column));
    let most = counted.iter().fold(zero, |most, d| math::max(damping.squared(length(&d.column)), most));
    let lost = T::lit(64.0) * T::EPS;
    let undamped = |d: &Direction<T, N>| damping.squared(length(&d.column)) <= lost * lost;
    if counted.iter().any(|d| length(&d.column) <= lost && undamped(d)) {
        return Err(RateError::Singular { margin });
    }
    let mut velocity = steered(counted, &twist, damping, &|_| true);
    // What round-off left over is given back once, in the directions that are exact.
    let rest = left(jacobian, &velocity, &twist);
    for (sum, more) in velocity.iter_mut().zip(steered(counted, &rest, damping, &undamped)) {
        *sum += more;
    }
    let missed = left(jacobian, &velocity, &twist)
        .data
        .0
        .iter()
        .flatten()
        .fold(zero, |most, x| math::max(math::abs(*x), most));
    for (rate, unit) in velocity.iter_mut().zip(units(&A::JOINTS, reach)) {
        *rate *= unit;
    }
    if !velocity.iter().chain([&missed]).all(|x| math::is_finite(*x)) {
        return Err(RateError::NotFinite);
    }
    Ok(Rates { velocity: pose::column(velocity), damping: math::sqrt(most), missed, margin })
}

/// The rates that the directions of some kind give for a twist.
fn steered<T: Float, const N: usize>(
    directions: &[Direction<T, N>],
    twist: &Twist<T>,
    damping: &Damping<T>,
    keep: &impl Fn(&Direction<T, N>) -> bool,
) -> [T; N] {
    let mut velocity = [T::lit(0.0); N];
    for direction in directions.iter().filter(|direction| keep(direction)) {
        let size = length(&direction.column);
        let part = product(&direction.column, &pose::entries(twist));
        let amount = part / (size * size + damping.squared(size));
        for (sum, turn) in velocity.iter_mut().zip(direction.turn) {
            *sum += amount * turn;
        }
    }
    velocity
}

/// What joint rates leave of a twist.
fn left<T: Float, const N: usize>(
    jacobian: &Jacobian<T, N>,
    velocity: &[T; N],
    twist: &Twist<T>,
) -> Twist<T> {
    let mut rest = pose::entries(twist);
    for (rest, reached) in rest.iter_mut().zip(pose::entries(&applied(jacobian, &pose::column(*velocity)))) {
        *rest -= reached;
    }
    pose::column(rest)
}

impl<T: Float> fmt::Display for RateError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RateError::NotFinite => f.write_str("a joint value, the twist or the arm itself is not finite"),
            RateError::Singular { margin } => {
                write!(f, "the pose is singular: the smallest singular value is {margin:.3e}")
            }
        }
    }
}

impl<T: Float> core::error::Error for RateError<T> {}
