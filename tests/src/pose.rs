//! Poses side by side.

use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3};

use crate::reference::Matrix4;

/// How far apart two poses are.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Difference {
    /// The largest difference of a coordinate.
    pub position: f64,
    /// The largest difference of an entry of the rotation matrix.
    pub rotation: f64,
}

impl Difference {
    /// The larger of the two, lengths divided by `reach`.
    pub fn relative(self, reach: f64) -> f64 {
        // A plain `max` would drop a NaN, which is the worst difference there is.
        let position = self.position / reach;
        if position.is_nan() || position > self.rotation { position } else { self.rotation }
    }
}

/// Compares two poses entry by entry; NaN if an entry is.
pub fn difference(a: &Matrix4, b: &Matrix4) -> Difference {
    let worst = |columns: std::ops::Range<usize>| {
        let entries = (0..3).flat_map(|i| columns.clone().map(move |j| (a[i][j] - b[i][j]).abs()));
        entries.fold(0.0, |worst: f64, x| if x.is_nan() || x > worst { x } else { worst })
    };
    Difference { position: worst(3..4), rotation: worst(0..3) }
}

/// The homogeneous matrix of a pose, its lengths multiplied by `scale`.
pub fn matrix(pose: &IsometryMatrix3<f64>, scale: f64) -> Matrix4 {
    let (r, p) = (pose.rotation.matrix(), &pose.translation.vector);
    let row = |i: usize| [r[(i, 0)], r[(i, 1)], r[(i, 2)], p[i] * scale];
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}

/// The pose of a homogeneous matrix, its lengths multiplied by `scale`; the rotation is taken as it is.
pub fn isometry(m: &Matrix4, scale: f64) -> IsometryMatrix3<f64> {
    let rotation = Matrix3::from_fn(|i, j| m[i][j]);
    let shift = Translation3::new(m[0][3] * scale, m[1][3] * scale, m[2][3] * scale);
    IsometryMatrix3::from_parts(shift, Rotation3::from_matrix_unchecked(rotation))
}

/// The pose with position (x, y, z) and rotation Rz(z) Ry(y) Rx(x), as reports print it, by a plain product.
pub fn from_zyx(position: [f64; 3], angles: [f64; 3]) -> IsometryMatrix3<f64> {
    use crate::product::{shift, times, turn};
    let turned = times(&times(&turn(2, angles[0]), &turn(1, angles[1])), &turn(0, angles[2]));
    isometry(&times(&shift(position), &turned), 1.0)
}
