//! Where things are: poses, joint vectors, Jacobians and Euler angles by name.

use crate::math::{self, Float, Lanes, Real};
use core::fmt;
use nalgebra::{ArrayStorage, IsometryMatrix3, Matrix3, Rotation3, SMatrix, SVector, Translation, Vector3};

/// A position and an orientation: nalgebra's isometry with a rotation matrix. Lengths are in the arm's declared unit.
pub type Pose<T> = IsometryMatrix3<T>;

/// One value for each joint: radians for a revolute joint, the declared length unit for a prismatic one.
pub type Joints<T, const N: usize> = SVector<T, N>;

/// The geometric Jacobian: rows vx vy vz ωx ωy ωz in base axes, at the tool point; one column for each joint.
pub type Jacobian<T, const N: usize> = SMatrix<T, 6, N>;

/// A joint vector from its values: `joints![0.1, 0.4, -0.2]`. The length of the list is the number of joints.
#[macro_export]
macro_rules! joints {
    ($($value:expr),* $(,)?) => { $crate::private::joints([$($value),*]) };
}

/// The orientation Rz(z)·Ry(y)·Rx(x), its angles by name (nalgebra's `euler_angles` returns roll, pitch and yaw, which
/// are these in the opposite order). Also known as Z-Y-X angles about moving axes.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EulerZyx<T> {
    /// About z, first; in (-π, π].
    pub z: T,
    /// About the turned y; in [-π/2, π/2].
    pub y: T,
    /// About the twice turned x; in (-π, π].
    pub x: T,
}

/// What an orientation says about its Z-Y-X angles: three angles, or a gimbal lock.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Euler<T> {
    /// The one triple with y strictly between -π/2 and π/2.
    Regular(EulerZyx<T>),
    /// y is ±π/2: the axes of z and x coincide, and only a sum or a difference of these two angles is known.
    GimbalLock(GimbalLock<T>),
}

/// A gimbal lock: infinitely many triples (z, y, x) give the same orientation.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GimbalLock<T> {
    /// Whether y = +π/2; otherwise y = -π/2.
    pub up: bool,
    /// x - z if `up`, x + z otherwise; in (-π, π].
    pub turn: T,
}

impl<T: Float> EulerZyx<T> {
    /// The angles of an orientation.
    ///
    /// It is a gimbal lock if x-axis and base z-axis agree within 64 ε. Otherwise x is taken from what z, already
    /// rounded, leaves over, so that the triple gives the orientation back however near the lock is.
    pub fn from_rotation(rotation: &Rotation3<T>) -> Euler<T> {
        let [[r11, r21, r31], [r12, r22, _], [r13, r23, _]] = rotation.matrix().data.0;
        let cos_y = math::hypot(r11, r21);
        if cos_y <= T::lit(64.0) * T::EPS {
            // Rz(z)·Ry(±π/2)·Rx(x): its second column is (sin(x - z), cos(x - z), 0) or (-sin(x + z), cos(x + z), 0).
            let up = r31 < T::lit(0.0);
            let turn = math::wrap(math::atan2(if up { r12 } else { -r12 }, r22));
            return Euler::GimbalLock(GimbalLock { up, turn });
        }
        let z = math::atan2(r21, r11);
        let (sz, cz) = math::sin_cos(z);
        let y = math::atan2(-r31, cz * r11 + sz * r21);
        let x = math::atan2(sz * r13 - cz * r23, cz * r22 - sz * r12);
        Euler::Regular(EulerZyx { z: math::wrap(z), y, x: math::wrap(x) })
    }

    /// The orientation Rz(z)·Ry(y)·Rx(x).
    pub fn to_rotation(&self) -> Rotation3<T> {
        let (sz, cz) = math::sin_cos(self.z);
        let (sy, cy) = math::sin_cos(self.y);
        let (sx, cx) = math::sin_cos(self.x);
        Rotation3::from_matrix_unchecked(matrix3([
            [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx],
        ]))
    }

    /// The pose with this orientation at (x, y, z).
    pub fn at(&self, position: [T; 3]) -> Pose<T> {
        Pose { rotation: self.to_rotation(), translation: Translation { vector: Vector3::from(position) } }
    }
}

impl<T: Float> Euler<T> {
    /// One triple that gives the orientation: the regular one, or the member of the lock with z = 0.
    pub fn any(&self) -> EulerZyx<T> {
        match self {
            Euler::Regular(angles) => *angles,
            Euler::GimbalLock(lock) => lock.member(T::lit(0.0)),
        }
    }
}

impl<T: Float> GimbalLock<T> {
    /// The triple with the given z.
    pub fn member(&self, z: T) -> EulerZyx<T> {
        let quarter = math::half_turn::<T>() * T::lit(0.5);
        let (y, x) = if self.up { (quarter, self.turn + z) } else { (-quarter, self.turn - z) };
        EulerZyx { z, y, x: math::wrap(x) }
    }
}

impl<T: Float> fmt::Display for EulerZyx<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(4);
        let [z, y, x] = [self.z, self.y, self.x].map(|angle| plain(angle, digits));
        write!(f, "zyx({z:.digits$}, {y:.digits$}, {x:.digits$})")
    }
}

impl<T: Float> fmt::Display for Euler<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(4);
        match self {
            Euler::Regular(angles) => write!(f, "{angles:.digits$}"),
            Euler::GimbalLock(lock) => {
                let (y, sign) = if lock.up { ("pi/2", '-') } else { ("-pi/2", '+') };
                write!(f, "gimbal lock: y = {y}, x {sign} z = {:.digits$}", plain(lock.turn, digits))
            }
        }
    }
}

/// Zero for what the given number of decimals would show as `-0.0000`.
pub(crate) fn plain<T: Float>(value: T, digits: usize) -> T {
    let half_unit = (0..digits.min(16)).fold(0.5, |unit, _| unit * 0.1);
    if math::abs(value) < T::lit(half_unit) { T::lit(0.0) } else { value }
}

/// A pose from the rows of its rotation matrix and its position.
#[inline(always)]
pub(crate) fn from_rows<T: Real>(rotation: [[T; 3]; 3], position: [T; 3]) -> Pose<T> {
    Pose {
        rotation: Rotation3::from_matrix_unchecked(matrix3(rotation)),
        translation: Translation { vector: column(position) },
    }
}

/// The rows of the rotation matrix, and the position.
#[inline(always)]
pub(crate) fn rows<T: Real>(pose: &Pose<T>) -> ([[T; 3]; 3], [T; 3]) {
    let [position] = pose.translation.vector.data.0;
    (matrix_rows(pose.rotation.matrix()), position)
}

/// One of several poses.
#[inline(always)]
pub(crate) fn one<T: Float, const L: usize>(poses: &Pose<Lanes<T, L>>, lane: usize) -> Pose<T> {
    let ([[a, d, g], [b, e, h], [c, f, i]], [[x, y, z]]) =
        (&poses.rotation.matrix().data.0, &poses.translation.vector.data.0);
    let row = |x: &Lanes<T, L>, y: &Lanes<T, L>, z: &Lanes<T, L>| [x.lane(lane), y.lane(lane), z.lane(lane)];
    from_rows([row(a, b, c), row(d, e, f), row(g, h, i)], row(x, y, z))
}

/// Poses as one whose numbers are lanes.
#[inline(always)]
pub(crate) fn gathered<T: Float, const L: usize>(poses: &[Pose<T>; L]) -> Pose<Lanes<T, L>> {
    let zero = Lanes::splat(T::lit(0.0));
    let (mut rotation, mut position) = ([[zero; 3]; 3], [zero; 3]);
    for (lane, pose) in poses.iter().enumerate() {
        let (rows, point) = rows(pose);
        for (lanes, values) in rotation.iter_mut().zip(rows) {
            for (lanes, value) in lanes.iter_mut().zip(values) {
                lanes.put(lane, value);
            }
        }
        for (lanes, value) in position.iter_mut().zip(point) {
            lanes.put(lane, value);
        }
    }
    from_rows(rotation, position)
}

/// A matrix from its rows.
#[inline(always)]
pub(crate) fn matrix3<T: Real>([[a, b, c], [d, e, f], [g, h, i]]: [[T; 3]; 3]) -> Matrix3<T> {
    Matrix3::from_array_storage(ArrayStorage([[a, d, g], [b, e, h], [c, f, i]]))
}

/// The rows of a matrix.
#[inline(always)]
pub(crate) fn matrix_rows<T: Real>(matrix: &Matrix3<T>) -> [[T; 3]; 3] {
    let [[a, d, g], [b, e, h], [c, f, i]] = matrix.data.0;
    [[a, b, c], [d, e, f], [g, h, i]]
}

/// A column from its entries.
#[inline(always)]
pub(crate) fn column<T, const N: usize>(entries: [T; N]) -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([entries]))
}

/// The entries of a column.
#[inline(always)]
pub(crate) fn entries<T: Copy, const N: usize>(column: &SVector<T, N>) -> [T; N] {
    let [entries] = column.data.0;
    entries
}

/// The product of two matrices given by rows.
pub(crate) fn product<T: Real>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let [b1, b2, b3] = transposed(b);
    a.map(|row| [dot(&row, &b1), dot(&row, &b2), dot(&row, &b3)])
}

/// The transposed matrix, by rows.
pub(crate) fn transposed<T: Real>([[a, b, c], [d, e, f], [g, h, i]]: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    [[*a, *d, *g], [*b, *e, *h], [*c, *f, *i]]
}

/// The angle between two rotations given by rows, in radians: how far one is turned to be the other, about whatever axis.
pub(crate) fn angle_between<T: Float>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> T {
    let apart = a.iter().flatten().zip(b.iter().flatten());
    let square = apart.fold(T::lit(0.0), |sum, (a, b)| sum + (*a - *b) * (*a - *b));
    // The Frobenius norm of the difference is √8 times the sine of half the angle.
    let sine = math::min(math::sqrt(square * T::lit(0.125)), T::lit(1.0));
    let cosine = math::sqrt_or_zero((T::lit(1.0) - sine) * (T::lit(1.0) + sine));
    T::lit(2.0) * math::atan2(sine, cosine)
}

/// The scalar product.
#[inline(always)]
pub(crate) fn dot<T: Real>([a, b, c]: &[T; 3], [x, y, z]: &[T; 3]) -> T {
    *a * *x + *b * *y + *c * *z
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Random, Text, about_z};
    use core::f64::consts::{FRAC_PI_2, PI};

    fn difference(a: &Rotation3<f64>, b: &Rotation3<f64>) -> f64 {
        (a.matrix() - b.matrix()).amax()
    }

    #[test]
    fn euler_angles_give_the_orientation_back_however_near_the_lock_is() {
        let mut random = Random(11);
        for count in 0..2_000 {
            let away = if count % 4 == 0 {
                random.within(-1.5, 1.5)
            } else {
                [1e-3, 1e-9, 0.0][count % 3] * random.within(0.0, 1.0)
            };
            let y = if count % 4 == 0 { away } else { FRAC_PI_2 - away };
            let angles =
                EulerZyx { z: random.angle(), y: if random.coin() { y } else { -y }, x: random.angle() };
            let rotation = angles.to_rotation();
            let found = EulerZyx::from_rotation(&rotation);
            assert!(difference(&found.any().to_rotation(), &rotation) < 1e-14, "{angles:?} {found:?}");
            if let Euler::Regular(found) = found
                && y.abs() < 1.5
            {
                assert!((math::wrap(found.z - angles.z)).abs() < 1e-13 && (found.y - angles.y).abs() < 1e-13);
                assert!(found.y.abs() <= FRAC_PI_2);
            }
        }
    }

    #[test]
    fn a_gimbal_lock_knows_the_sum_or_the_difference() {
        for (y, up, turn) in [(FRAC_PI_2, true, 0.2 - 0.5), (-FRAC_PI_2, false, 0.2 + 0.5)] {
            let rotation = EulerZyx { z: 0.5, y, x: 0.2 }.to_rotation();
            let Euler::GimbalLock(lock) = EulerZyx::from_rotation(&rotation) else { panic!() };
            assert!(lock.up == up && (lock.turn - turn).abs() < 1e-15, "{lock:?}");
            for z in [0.0, 0.5, -3.0] {
                assert!(difference(&lock.member(z).to_rotation(), &rotation) < 1e-15);
            }
            assert!((lock.member(0.5).x - 0.2).abs() < 1e-15);
        }
        // Section 6.1 of seed 000 prints the member z = pi/4, x = -pi/4.
        let printed = EulerZyx { z: PI / 4.0, y: -FRAC_PI_2, x: -PI / 4.0 };
        let lock = EulerZyx::from_rotation(&printed.to_rotation());
        assert_eq!(Text::of(&lock).as_str(), "gimbal lock: y = -pi/2, x + z = 0.0000");
        assert_eq!(Text::of(&printed).as_str(), "zyx(0.7854, -1.5708, -0.7854)");
    }

    #[test]
    fn angles_go_by_name_and_nalgebra_has_them_backwards() {
        let angles = EulerZyx { z: 0.3_f32, y: 0.2, x: 0.1 };
        let (roll, pitch, yaw) = angles.to_rotation().euler_angles();
        assert!(
            (roll - angles.x).abs() < 1e-6
                && (pitch - angles.y).abs() < 1e-6
                && (yaw - angles.z).abs() < 1e-6
        );
        let pose = angles.at([1.0, 2.0, 3.0]);
        assert_eq!(rows(&pose).1, [1.0, 2.0, 3.0]);
        assert_eq!(
            matrix_rows(&matrix3([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]))[1],
            [4.0, 5.0, 6.0]
        );
        assert_eq!(crate::joints![0.5, 1.0], column([0.5, 1.0]));
    }

    #[test]
    fn what_is_turned_by_an_angle_is_that_far_away() {
        let mut random = Random(17);
        for angle in [0.0, 1e-17, 1e-12, 1e-7, 1e-3, 0.5, 1.5, 3.0, PI - 1e-3, PI] {
            for _ in 0..50 {
                let (from, about) = (random.rotation(), random.rotation());
                let turned = product(&about, &product(&about_z(angle), &transposed(&about)));
                let found = angle_between(&product(&turned, &from), &from);
                // Beside half a turn the sine of half the angle says least: to the root of round-off.
                let most = if angle > 3.1 { 1e-7 } else { 1e-14 };
                assert!(math::abs(found - angle) <= most, "{found} for {angle}");
            }
        }
    }
}
