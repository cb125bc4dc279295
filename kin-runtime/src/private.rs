//! What generated code calls: no part of the public promise, and liable to change with the generator.

pub use crate::__dyn_arm as dyn_arm;
pub use crate::ik::wrist::Rows;
pub use crate::math::{abs, atan2, hypot};

use crate::arm::{Arm, SphericalWrist};
use crate::ik::wrist;
use crate::ik::{Base, Carrier, PairBase, Turns, Wrist};
use crate::math::{Float, Real};
use crate::pose::{self, Jacobian, Joints, Pose};
use crate::solutions::{ArmPosture, Branch, Elbow, Shoulder};
use nalgebra::{ArrayStorage, Matrix3, Point3, SMatrix};

/// What the solver knows of an angle of a program before its sine and cosine are taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Known {
    /// It is the angle of `wrist_turns` with this number.
    Wrist(usize),
    /// It is the row value of this joint.
    Row(usize),
    /// It is the sum of the row values of these joints.
    Sum(usize, usize),
    /// It is the row value of the first of these joints less that of the second.
    Difference(usize, usize),
    /// Nothing.
    Nothing,
}

/// What the solver of six-joint arms asks of an arm: its constants, and the ways into and out of its figures.
///
/// Row values are what the table's rows see: q itself unless `couple:` ties joints together.
pub trait SolveWrist<const N: usize>: SphericalWrist<N> {
    /// The constants of the first three joints.
    fn base<T: Float>(&self) -> Base<T>;
    /// The wrist centre in the shoulder frame.
    fn wrist_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3];
    /// The rotation that the wrist must produce once the first three joints are set.
    fn wrist_rotation<T: Real>(&self, rows: [T; 3], pose: &Pose<T>) -> Matrix3<T>;
    /// The commanded values of row values; without offsets, so that it takes differences too.
    fn command<T: Real>(&self, rows: [T; N]) -> [T; N];
    /// The row values of commanded values: the inverse of `command`.
    fn rows<T: Real>(&self, q: [T; N]) -> [T; N];

    /// Whether commanded values are others than row values.
    const COUPLED: bool = true;
    /// How many angles [`wrist_rotation`](SolveWrist::wrist_rotation) takes the sines and cosines of.
    const WRIST_TURNS: usize = 0;
    /// What is already known of them once the first three joints are set.
    const WRIST_KNOWN: [Known; 8] = [Known::Nothing; 8];
    /// How many forward kinematics does.
    const FK_TURNS: usize = 0;
    /// What is already known of the turns of forward kinematics once the wrist is solved.
    const FK_KNOWN: [Known; 8] = [Known::Nothing; 8];
    /// For an orthogonal wrist, where the methods below are its own: from its figure angles to row values.
    fn orthogonal_wrist<T: Float>(&self) -> Option<Rows<T>> {
        None
    }
    /// The angles of `wrist_rotation`; zero beyond.
    #[inline(always)]
    fn wrist_turns<T: Real>(&self, _: [T; 3]) -> [T; 8] {
        [T::lit(0.0); 8]
    }
    /// `wrist_rotation`, once their sines and cosines are known.
    #[inline(always)]
    fn wrist_turned<T: Real>(&self, rows: [T; 3], pose: &Pose<T>, _: &[T; 8], _: &[T; 8]) -> Matrix3<T> {
        self.wrist_rotation(rows, pose)
    }
    /// Rz(a)·Ry(b)·Rz(c) of the figure angles, by rows, from the rotation between frames 3 and 6.
    #[inline(always)]
    fn wrist_matrix<T: Real>(&self, r36: &Matrix3<T>) -> [[T; 3]; 3] {
        pose::matrix_rows(r36)
    }
    /// The angles of forward kinematics; zero beyond.
    #[inline(always)]
    fn fk_turns<T: Real>(&self, _: &Joints<T, N>) -> [T; 8] {
        [T::lit(0.0); 8]
    }
    /// Forward kinematics, once their sines and cosines are known.
    #[inline(always)]
    fn fk_turned<T: Real>(&self, q: &Joints<T, N>, _: &[T; 8], _: &[T; 8]) -> Pose<T> {
        self.fk(q)
    }
}

/// What the solver of arms with a spherical shoulder asks of one.
pub trait SolveShoulder<const N: usize>: Arm<N> {
    /// The constants of joints 6, 5 and 4, seen from the tool.
    fn base<T: Float>(&self) -> Base<T>;
    /// The centre of the shoulder in the frame of that base.
    fn shoulder_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3];
    /// The rotation that the shoulder must produce once joints 4, 5 and 6 are set.
    fn shoulder_rotation<T: Real>(&self, rows: [T; 3], pose: &Pose<T>) -> Matrix3<T>;
    /// The row values of joints 1, 2 and 3 that produce a rotation.
    fn shoulder_angles<T: Float>(&self, r03: &Matrix3<T>) -> Wrist<T>;
    /// The commanded values of row values; without offsets, so that it takes differences too.
    fn command<T: Real>(&self, rows: [T; N]) -> [T; N];
    /// The row values of commanded values: the inverse of `command`.
    fn rows<T: Real>(&self, q: [T; N]) -> [T; N];
}

/// What the solver of three-joint arms asks of an arm.
pub trait SolvePosition<const N: usize>: Arm<N> {
    /// The constants of the three joints.
    fn base<T: Float>(&self) -> Base<T>;
    /// The tool point in the shoulder frame.
    fn tool_point<T: Real>(&self, p: &Point3<T>) -> [T; 3];
    /// The commanded values of row values; without offsets, so that it takes differences too.
    fn command<T: Real>(&self, rows: [T; N]) -> [T; N];
    /// The row values of commanded values: the inverse of `command`.
    fn rows<T: Real>(&self, q: [T; N]) -> [T; N];
}

/// The labels of joints that carry a point.
pub trait Carried: Branch {
    /// As the posture of a base.
    fn base(self) -> ArmPosture;
}

impl Carried for ArmPosture {
    fn base(self) -> ArmPosture {
        self
    }
}

impl Carried for Elbow {
    fn base(self) -> ArmPosture {
        ArmPosture { shoulder: Shoulder::Right, elbow: self }
    }
}

/// What the solver of two-joint arms asks of an arm.
pub trait SolvePair<const N: usize>: Arm<N> {
    /// The constants of the two joints.
    fn base<T: Float>(&self) -> PairBase<T>;
    /// The tool point in the frame of the two joints.
    fn tool_point<T: Real>(&self, p: &Point3<T>) -> [T; 3];
    /// The commanded values of row values; without offsets, so that it takes differences too.
    fn command<T: Real>(&self, rows: [T; N]) -> [T; N];
    /// The row values of commanded values: the inverse of `command`.
    fn rows<T: Real>(&self, q: [T; N]) -> [T; N];
}

/// What the solver of poses asks of an arm of two to five joints.
pub trait SolveShort<const N: usize>: Arm<N> {
    /// How many joints carry the point.
    const CARRIERS: usize;
    /// The joints that carry the point, then those that turn the tool.
    const ORDER: [usize; N];
    /// The constants of the joints that carry the point.
    fn carrier<T: Float>(&self) -> Carrier<T>;
    /// The carried point in their frame.
    fn carried_point<T: Real>(&self, pose: &Pose<T>) -> [T; 3];
    /// The rotation that the turns must produce once the others are set.
    fn rest<T: Real>(&self, rows: [T; N], pose: &Pose<T>) -> Matrix3<T>;
    /// The joints that turn the tool.
    fn turns<T: Float>(&self) -> Turns<T>;
    /// The commanded values of row values; without offsets, so that it takes differences too.
    fn command<T: Real>(&self, rows: [T; N]) -> [T; N];
    /// The row values of commanded values: the inverse of `command`.
    fn rows<T: Real>(&self, q: [T; N]) -> [T; N];
}

/// A pose from the rows of its rotation and its position.
#[inline(always)]
pub fn pose<T: Real>(rotation: [[T; 3]; 3], position: [T; 3]) -> Pose<T> {
    pose::from_rows(rotation, position)
}

/// The rows of a pose's rotation, and its position.
pub fn entries<T: Real>(pose: &Pose<T>) -> ([[T; 3]; 3], [T; 3]) {
    pose::rows(pose)
}

/// A Jacobian from its columns (vx, vy, vz, ωx, ωy, ωz).
#[inline(always)]
pub fn jacobian<T: Real, const N: usize>(columns: [[T; 6]; N]) -> Jacobian<T, N> {
    SMatrix::from_array_storage(ArrayStorage(columns))
}

/// A joint vector from its values.
#[inline(always)]
pub const fn joints<T, const N: usize>(values: [T; N]) -> Joints<T, N> {
    SMatrix::from_array_storage(ArrayStorage([values]))
}

/// A matrix from its rows.
#[inline(always)]
pub fn matrix<T: Real>(rows: [[T; 3]; 3]) -> Matrix3<T> {
    pose::matrix3(rows)
}

/// The rows of a matrix.
pub fn matrix_rows<T: Real>(matrix: &Matrix3<T>) -> [[T; 3]; 3] {
    pose::matrix_rows(matrix)
}

/// A point from its coordinates.
pub fn point<T: Real>(coordinates: [T; 3]) -> Point3<T> {
    Point3 { coords: pose::column(coordinates) }
}

/// The coordinates of a point.
pub fn point_entries<T: Real>(point: &Point3<T>) -> [T; 3] {
    pose::entries(&point.coords)
}

/// An orthogonal wrist: m = Rz(a)·Ry(b)·Rz(c), by rows; row values are the angles less their offsets, or the offsets
/// less the angles where reversed.
pub fn zyz<T: Float>(m: [[T; 3]; 3], offset: [T; 3], reversed: [bool; 3]) -> Wrist<T> {
    wrist::zyz(m, &Rows { offset, reversed })
}

/// An oblique wrist: m = Rz(a)·K4·Rz(b)·K5·Rz(c), all by rows.
pub fn oblique<T: Float>(
    m: [[T; 3]; 3],
    k4: [[T; 3]; 3],
    k5: [[T; 3]; 3],
    offset: [T; 3],
    reversed: [bool; 3],
) -> Wrist<T> {
    wrist::oblique(m, k4, k5, &Rows { offset, reversed })
}
