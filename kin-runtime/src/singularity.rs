//! How near an arm is to losing a direction of motion: singular values and manipulability of its Jacobian.
//!
//! The linear rows are divided by the arm's reach, and the columns of sliding joints multiplied by it, so that every entry is
//! per radian or per reach and the same arm in millimetres and in metres gives the same numbers: [`normalised`].
//! [`singular_values`] and [`determinant`] take a matrix as it is.

use crate::arm::{Arm, Joint, JointKind};
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
    /// Yoshikawa's manipulability √det(J·Jᵀ): the product of the singular values, of the first six if there are more.
    pub manipulability: T,
    /// How far the arm is from losing a direction: the smallest singular value, or the sixth if there are more.
    pub margin: T,
}

/// The dexterity of an arm at `q`, its Jacobian [`normalised`].
pub fn dexterity<T: Float, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>) -> Dexterity<T, N> {
    measured(&normalised(arm, q), 6)
}

/// The dexterity at `q` of an arm that is asked for a position only: the linear rows alone, [`normalised`]. At
/// most three singular values are not zero; the margin is the third.
pub fn position_dexterity<T: Float, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>) -> Dexterity<T, N> {
    measured(&linear(&normalised(arm, q)), 3)
}

/// The Jacobian at `q` with its linear rows divided by the arm's reach and the columns of sliding joints multiplied by it:
/// what the tool does in reaches and radians, for joints in radians and reaches.
pub fn normalised<T: Real, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>) -> Jacobian<T, N> {
    in_reaches(&arm.jacobian(q), &A::JOINTS, T::lit(arm.reach()))
}

/// A Jacobian normalised by a reach.
pub(crate) fn in_reaches<T: Real, const N: usize>(
    jacobian: &Jacobian<T, N>,
    joints: &[Joint; N],
    reach: T,
) -> Jacobian<T, N> {
    let mut columns = scaled(jacobian, reach).data.0;
    for (column, unit) in columns.iter_mut().zip(units(joints, reach)) {
        *column = column.map(|entry| entry * unit);
    }
    SMatrix::from_array_storage(ArrayStorage(columns))
}

/// What counts as one of each joint: a radian, or a reach of a slide.
pub(crate) fn units<T: Real, const N: usize>(joints: &[Joint; N], reach: T) -> [T; N] {
    joints.map(|joint| match joint.kind {
        JointKind::Revolute => T::lit(1.0),
        JointKind::Prismatic => reach,
    })
}

/// The linear rows alone, the others zero.
pub(crate) fn linear<T: Real, const N: usize>(jacobian: &Jacobian<T, N>) -> Jacobian<T, N> {
    let zero = T::lit(0.0);
    SMatrix::from_array_storage(ArrayStorage(
        jacobian.data.0.map(|[x, y, z, ..]| [x, y, z, zero, zero, zero]),
    ))
}

/// The determinant of a Jacobian of six columns, by elimination with the largest pivot of each column; `None` for any other
/// number of columns.
pub fn determinant<T: Float, const N: usize>(jacobian: &Jacobian<T, N>) -> Option<T> {
    let columns: [[T; 6]; 6] = jacobian.data.0.as_slice().try_into().ok()?;
    Some(eliminated(columns, 6, |x| x).unwrap_or(T::lit(0.0)))
}

/// The determinant of the linear rows of three columns; `None` for any other number of columns.
pub fn position_determinant<T: Float, const N: usize>(jacobian: &Jacobian<T, N>) -> Option<T> {
    let columns: [[T; 6]; 3] = jacobian.data.0.as_slice().try_into().ok()?;
    Some(eliminated(columns, 3, |x| x).unwrap_or(T::lit(0.0)))
}

/// The determinant of the first `size` entries of as many vectors, of plain numbers or of moving ones. After each step the
/// vectors lose their first entry, so that the next pivot is always in the first place.
///
/// Without a pivot the determinant is 0, but its rate is not known: then there is none.
pub(crate) fn eliminated<X: Real, T: Float, const N: usize>(
    mut vectors: [[X; 6]; N],
    size: usize,
    value: impl Fn(X) -> T,
) -> Option<X> {
    let lead = |[first, ..]: &[X; 6]| math::abs(value(*first));
    let mut product = X::lit(1.0);
    let mut rest: &mut [[X; 6]] = &mut vectors;
    for step in 1..=size {
        let (first, others) = rest.split_first_mut()?;
        for other in others.iter_mut() {
            if lead(other) > lead(first) {
                core::mem::swap(first, other);
                product = -product;
            }
        }
        let [pivot, ..] = *first;
        product = product * pivot;
        if step < size && lead(first).partial_cmp(&T::lit(0.0)) == Some(core::cmp::Ordering::Equal) {
            return None;
        }
        for other in others.iter_mut() {
            let [head, ..] = *other;
            let factor = head / pivot;
            for (x, y) in other.iter_mut().zip(first.iter()) {
                *x = *x - factor * *y;
            }
            other.rotate_left(1);
        }
        rest = others;
    }
    Some(product)
}

/// The figures of a Jacobian with that many rows that count.
pub(crate) fn measured<T: Float, const N: usize>(jacobian: &Jacobian<T, N>, rows: usize) -> Dexterity<T, N> {
    let singular_values = singular_values(jacobian);
    let (mut manipulability, mut margin) = (T::lit(1.0), T::lit(0.0));
    for value in pose::entries(&singular_values).into_iter().take(rows) {
        manipulability *= value;
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
    let mut values = decomposed(jacobian, [[]; N]).map(|direction| length(&direction.column));
    sort_falling(&mut values, |value| *value);
    pose::column(values)
}

/// One direction of a matrix: its column u·σ, and what turned the columns of the matrix into it.
#[derive(Clone, Copy)]
pub(crate) struct Direction<T, const M: usize> {
    pub(crate) column: [T; 6],
    pub(crate) turn: [T; M],
}

/// The directions of a Jacobian with all of v, the largest first.
pub(crate) fn directions<T: Float, const N: usize>(jacobian: &Jacobian<T, N>) -> [Direction<T, N>; N] {
    let mut unit = [[T::lit(0.0); N]; N];
    for (index, column) in unit.iter_mut().enumerate() {
        if let Some(one) = column.get_mut(index) {
            *one = T::lit(1.0);
        }
    }
    let mut sized = decomposed(jacobian, unit).map(|direction| (length(&direction.column), direction));
    sort_falling(&mut sized, |(size, _)| *size);
    sized.map(|(_, direction)| direction)
}

/// The directions of a Jacobian, in no order; `turns` is the unit matrix if v is wanted, else nothing.
fn decomposed<T: Float, const N: usize, const M: usize>(
    jacobian: &Jacobian<T, N>,
    turns: [[T; M]; N],
) -> [Direction<T, M>; N] {
    let mut directions = turns.map(|turn| Direction { column: [T::lit(0.0); 6], turn });
    for (direction, column) in directions.iter_mut().zip(jacobian.data.0) {
        direction.column = column;
    }
    for _ in 0..SWEEPS {
        if !sweep(&mut directions) {
            break;
        }
    }
    directions
}

/// Makes each pair of columns orthogonal once; whether any was not.
fn sweep<T: Float, const M: usize>(directions: &mut [Direction<T, M>]) -> bool {
    let mut turned = false;
    let mut rest = directions;
    while let Some((first, others)) = rest.split_first_mut() {
        for other in others.iter_mut() {
            turned |= orthogonalise(first, other);
        }
        rest = others;
    }
    turned
}

/// Turns two columns in their plane until they are orthogonal; whether they were not.
fn orthogonalise<T: Float, const M: usize>(a: &mut Direction<T, M>, b: &mut Direction<T, M>) -> bool {
    let (aa, bb) = (product(&a.column, &a.column), product(&b.column, &b.column));
    let ab = product(&a.column, &b.column);
    if math::abs(ab) <= T::EPS * math::sqrt(aa * bb) || math::is_nan(ab) {
        return false;
    }
    let zeta = (bb - aa) / (T::lit(2.0) * ab);
    let size = math::abs(zeta);
    // Beside a larger one 1 is lost, and its square may be too large a number.
    let root = size + if size < T::lit(1.0) / T::EPS { math::sqrt(T::lit(1.0) + size * size) } else { size };
    let t = if zeta < T::lit(0.0) { T::lit(-1.0) / root } else { T::lit(1.0) / root };
    let c = T::lit(1.0) / math::sqrt(T::lit(1.0) + t * t);
    let s = c * t;
    let both = a.column.iter_mut().chain(&mut a.turn).zip(b.column.iter_mut().chain(&mut b.turn));
    for (x, y) in both {
        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
    }
    true
}

pub(crate) fn product<T: Float>(a: &[T; 6], b: &[T; 6]) -> T {
    a.iter().zip(b).fold(T::lit(0.0), |sum, (x, y)| sum + *x * *y)
}

pub(crate) fn length<T: Float>(column: &[T; 6]) -> T {
    let (square, least) = (product(column, column), T::EPS * T::EPS * T::EPS * T::EPS);
    if square > least && square < T::lit(1.0) / least {
        return math::sqrt(square);
    }
    // What is lost of such squares may matter, or they are no numbers at all.
    column.iter().fold(T::lit(0.0), |sum, x| math::hypot(sum, *x))
}

/// Bubble sort, largest first: the list is short, and no index can fail.
fn sort_falling<X, T: Float>(items: &mut [X], size: impl Fn(&X) -> T) {
    for _ in 0..items.len() {
        let mut rest: &mut [X] = items;
        while let [a, b, ..] = rest {
            if size(a) < size(b) {
                core::mem::swap(a, b);
            }
            match rest.split_first_mut() {
                Some((_, others)) => rest = others,
                None => break,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{LAB_ARM, LabRrr, PUMA_560, Random};

    #[test]
    fn a_diagonal_matrix_shows_its_singular_values() {
        let column = |j: usize, x: f64| core::array::from_fn(|i| if i == j { x } else { 0.0 });
        let jacobian: Jacobian<f64, 4> =
            crate::private::jacobian([column(0, 2.0), column(3, -5.0), column(1, 0.0), column(5, 3.0)]);
        assert_eq!(pose::entries(&singular_values(&jacobian)), [5.0, 3.0, 2.0, 0.0]);
    }

    #[test]
    fn singular_values_are_those_of_the_products() {
        let mut random = Random(12);
        for _ in 0..200 {
            let columns = [(); 6].map(|()| [(); 6].map(|()| random.within(-1.0, 1.0)));
            let jacobian: Jacobian<f64, 6> = crate::private::jacobian(columns);
            let values = singular_values(&jacobian);
            // Independent of the algorithm: trace of JᵀJ and determinant of J.
            let squares = values.iter().fold(0.0, |sum, s| sum + s * s);
            assert!((squares - jacobian.norm_squared()).abs() < 1e-13);
            let product = values.iter().product::<f64>();
            assert!((product - jacobian.determinant().abs()).abs() < 1e-13);
            assert!(values.iter().zip(values.iter().skip(1)).all(|(a, b)| a >= b));
        }
    }

    #[test]
    fn columns_of_any_size_keep_their_singular_values() {
        let mut random = Random(14);
        let columns = [(); 6].map(|()| [(); 6].map(|()| random.within(-1.0, 1.0)));
        let values = singular_values::<f64, 6>(&crate::private::jacobian(columns));
        for scale in [1e-70, 1e-40, 1e-20, 1e40, 1e70] {
            let scaled = columns.map(|column| column.map(|x| scale * x));
            let scaled = singular_values::<f64, 6>(&crate::private::jacobian(scaled));
            assert!((scaled / scale - values).amax() < 1e-14, "{scale}: {scaled}");
        }
        // One column that is nothing beside the others leaves them as they are, and has its own part across them.
        let [a, b, ..] = columns;
        let two = singular_values::<f64, 2>(&crate::private::jacobian([a, b]));
        for tiny in [1e-18, 1e-70, 1e-120] {
            let pair = singular_values::<f64, 2>(&crate::private::jacobian([a, b.map(|x| tiny * x)]));
            let area = pair[0] * (pair[1] / tiny);
            assert!((area / (two[0] * two[1]) - 1.0).abs() < 1e-14, "{tiny}: {pair}");
        }
    }

    #[test]
    fn more_than_six_columns_leave_zeros() {
        let mut random = Random(13);
        let columns = [(); 7].map(|()| [(); 6].map(|()| random.within(-1.0, 1.0)));
        let values = singular_values::<f64, 7>(&crate::private::jacobian(columns));
        assert!(values[6] < 1e-15 && values[5] > 1e-3, "{values}");
    }

    #[test]
    fn singular_poses_have_no_margin_and_units_do_not_count() {
        // Seed 000, section 5: "z1 aligned with z4 is not a singularity" is refuted by the sixth singular value.
        let q = pose::column([0.3, 7.424_206_202_669_955, -12.136_595_183_054_645, 0.4, 0.9, -0.5]);
        let aligned = dexterity(&LAB_ARM, &q);
        assert!(aligned.margin < 1e-15 && aligned.singular_values[4] > 0.02, "{aligned:?}");
        let stretched = position_dexterity(&LabRrr, &pose::column([0.1, 0.2, 0.0]));
        assert!(stretched.margin < 1e-15 && stretched.manipulability < 1e-15);
        let bent = dexterity(&PUMA_560, &pose::column([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]));
        assert!(bent.margin > 0.01 && bent.manipulability > 1e-4);
        let product = bent.singular_values.iter().product::<f64>();
        assert!((bent.manipulability - product).abs() < 1e-15);
    }

    #[test]
    fn determinants_are_those_of_a_library_and_a_slide_has_no_unit() {
        let mut random = Random(15);
        for round in 0..500 {
            let mut columns = [(); 6].map(|()| [(); 6].map(|()| random.within(-1.0, 1.0)));
            if round % 5 == 0 {
                columns[3] = columns[1];
            }
            let jacobian: Jacobian<f64, 6> = crate::private::jacobian(columns);
            let known = jacobian.determinant();
            assert!(
                (determinant(&jacobian).unwrap() - known).abs() < 1e-14
                    && (round % 5 > 0 || known.abs() < 1e-15)
            );
            let three: Jacobian<f64, 3> = crate::private::jacobian([columns[0], columns[1], columns[2]]);
            let known = three.fixed_view::<3, 3>(0, 0).determinant();
            assert!(
                (position_determinant(&three).unwrap() - known).abs() < 1e-15
                    && determinant(&three).is_none()
            );
        }
        // A slide in metres and in millimetres.
        let slide = Joint { name: "J", kind: JointKind::Prismatic };
        let of = |unit: f64| {
            let column = [0.6, 0.0, 0.8, 0.0, 0.0, 0.0];
            let turn = [0.1 * unit, 0.2 * unit, 0.3 * unit, 0.0, 1.0, 0.0];
            let joints = [slide, Joint { kind: JointKind::Revolute, ..slide }];
            in_reaches(&crate::private::jacobian([column, turn]), &joints, 2.0 * unit)
        };
        assert!((of(1.0) - of(1000.0)).amax() < 1e-16);
    }

    #[test]
    fn wild_entries_end_in_bounded_time() {
        let mut random = Random(14);
        for _ in 0..1_000 {
            let columns = [(); 6].map(|()| [(); 6].map(|()| f64::from_bits(random.bits())));
            let _ = singular_values::<f64, 6>(&crate::private::jacobian(columns));
        }
    }
}
