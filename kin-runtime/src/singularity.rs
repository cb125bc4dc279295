//! How near an arm is to losing a direction of motion: singular values and manipulability of its Jacobian.
//!
//! The linear rows are divided by the arm's reach, so that rows of both kinds are per radian and the same arm in
//! millimetres and in metres gives the same numbers; [`singular_values`] alone takes a matrix as it is.

use crate::arm::Arm;
use crate::math::{self, Float, Real};
use crate::pose::{self, Jacobian, Joints};
use nalgebra::{ArrayStorage, SMatrix};

/// Sweeps over all pairs of columns; six columns are orthogonal to the last bit after five or six.
const SWEEPS: usize = 16;

/// What the Jacobian says about a configuration.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Dexterity<T, const N: usize> {
    /// The singular values, largest first. An arm of more than six joints has N - 6 zeros at the end.
    pub singular_values: Joints<T, N>,
    /// Yoshikawa's manipulability √det(J·Jᵀ): the product of the singular values (of the first six, if there are
    /// more).
    pub manipulability: T,
    /// The margin to the nearest singularity: the smallest singular value (the sixth, if there are more).
    pub margin: T,
}

/// The dexterity of an arm at `q`, linear rows divided by its reach.
pub fn dexterity<T: Float, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>) -> Dexterity<T, N> {
    let singular_values = singular_values(&scaled(&arm.jacobian(q), T::lit(arm.reach())));
    let (mut manipulability, mut margin) = (T::lit(1.0), T::lit(0.0));
    for value in pose::entries(&singular_values).into_iter().take(6) {
        manipulability = manipulability * value;
        margin = value;
    }
    Dexterity { singular_values, manipulability, margin }
}

/// A Jacobian with its linear rows divided by a length.
pub fn scaled<T: Real, const N: usize>(jacobian: &Jacobian<T, N>, length: T) -> Jacobian<T, N> {
    let columns =
        jacobian.data.0.map(|[vx, vy, vz, wx, wy, wz]| [vx / length, vy / length, vz / length, wx, wy, wz]);
    SMatrix::from_array_storage(ArrayStorage(columns))
}

/// The singular values of a Jacobian, largest first; zeros at the end where it has more than six columns.
///
/// One-sided Jacobi (Hestenes 1958): pairs of columns are turned until all are orthogonal; their lengths are the
/// singular values, small ones to high relative accuracy.
pub fn singular_values<T: Float, const N: usize>(jacobian: &Jacobian<T, N>) -> Joints<T, N> {
    let mut columns = jacobian.data.0;
    for _ in 0..SWEEPS {
        if !sweep(&mut columns) {
            break;
        }
    }
    let mut values = columns.map(|column| length(&column));
    sort_falling(&mut values);
    pose::column(values)
}

/// Makes each pair of columns orthogonal once; whether any was not.
fn sweep<T: Float, const N: usize>(columns: &mut [[T; 6]; N]) -> bool {
    let mut turned = false;
    let mut rest: &mut [[T; 6]] = columns;
    while let Some((first, others)) = rest.split_first_mut() {
        for other in others.iter_mut() {
            turned |= orthogonalise(first, other);
        }
        rest = others;
    }
    turned
}

/// Turns two columns in their plane until they are orthogonal; whether they were not.
fn orthogonalise<T: Float>(a: &mut [T; 6], b: &mut [T; 6]) -> bool {
    let (aa, bb, ab) = (product(a, a), product(b, b), product(a, b));
    if !(math::abs(ab) > T::EPS * math::sqrt(aa * bb)) {
        return false;
    }
    let zeta = (bb - aa) / (T::lit(2.0) * ab);
    let root = math::abs(zeta) + math::hypot(T::lit(1.0), zeta);
    let t = if zeta < T::lit(0.0) { T::lit(-1.0) / root } else { T::lit(1.0) / root };
    let c = T::lit(1.0) / math::hypot(T::lit(1.0), t);
    let s = c * t;
    for (x, y) in a.iter_mut().zip(b.iter_mut()) {
        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
    }
    true
}

fn product<T: Float>(a: &[T; 6], b: &[T; 6]) -> T {
    a.iter().zip(b).fold(T::lit(0.0), |sum, (x, y)| sum + *x * *y)
}

fn length<T: Float>(column: &[T; 6]) -> T {
    column.iter().fold(T::lit(0.0), |sum, x| math::hypot(sum, *x))
}

/// Bubble sort, largest first: the list is short, and no index can fail.
fn sort_falling<T: Float, const N: usize>(values: &mut [T; N]) {
    for _ in 0..N {
        let mut rest: &mut [T] = values;
        while let [a, b, ..] = rest {
            if *a < *b {
                (*a, *b) = (*b, *a);
            }
            match rest.split_first_mut() {
                Some((_, others)) => rest = others,
                None => break,
            }
        }
    }
}
