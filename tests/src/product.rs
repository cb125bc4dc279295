//! The plain product of the table's matrices.

use crate::dual::{Dual, Number};
use crate::expression::value;
use crate::reference::{Frame, Matrix4, Record};

/// A homogeneous matrix.
pub type Matrix<T> = [[T; 4]; 4];

/// The product of two matrices.
pub fn times<T: Number>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (1..4).fold(a[i][0] * b[0][j], |sum, k| sum + a[i][k] * b[k][j]))
    })
}

/// A translation.
pub fn shift<T: Number>(by: [T; 3]) -> Matrix<T> {
    std::array::from_fn(|i| {
        std::array::from_fn(
            |j| if j == 3 && i < 3 { by[i] } else { T::constant(f64::from(u8::from(i == j))) },
        )
    })
}

/// A rotation about axis 0, 1 or 2.
pub fn turn<T: Number>(axis: usize, angle: T) -> Matrix<T> {
    let (s, c) = angle.sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = shift([T::constant(0.0); 3]);
    (m[i][i], m[i][j], m[j][i], m[j][j]) = (c, -s, s, c);
    m
}

fn placed<T: Number>(frame: &Frame) -> Matrix<T> {
    let [x, y, z] = frame.xyz.each_ref().map(|text| T::constant(value(text)));
    let [roll, pitch, yaw] = frame.rpy.each_ref().map(|text| T::constant(value(text)));
    let turned = times(&times(&turn(2, yaw), &turn(1, pitch)), &turn(0, roll));
    times(&shift([x, y, z]), &turned)
}

/// The pose after the base and after each row.
fn walk<T: Number>(arm: &Record, q: &[T]) -> Vec<Matrix<T>> {
    let zero = T::constant(0.0);
    let mut joints = q.iter().copied();
    let mut next = |wanted: bool| if wanted { joints.next().unwrap_or(zero) } else { zero };
    let mut poses = vec![placed(&arm.base)];
    for row in &arm.rows {
        let theta = T::constant(value(&row.theta)) + next(row.kind == 'R');
        let d = T::constant(value(&row.d)) + next(row.kind == 'P');
        let screw = times(&turn(2, theta), &shift([zero, zero, d]));
        let along = shift([T::constant(value(&row.a)), zero, zero]);
        let twist = turn(0, T::constant(value(&row.alpha)));
        let matrix = match arm.convention.as_str() {
            "standard" => times(&screw, &times(&along, &twist)),
            _ => times(&times(&twist, &along), &screw),
        };
        let after = poses.last().map(|pose| times(pose, &matrix));
        poses.extend(after);
    }
    poses
}

fn product<T: Number>(arm: &Record, q: &[T]) -> Matrix<T> {
    let poses = walk(arm, q);
    times(&poses[poses.len() - 1], &placed(&arm.tool))
}

/// The frame at the end of each joint's own row, in the base frame.
pub fn frames(arm: &Record, q: &[f64]) -> Vec<Matrix4> {
    let after_rows = walk(arm, q).into_iter().skip(1);
    after_rows.zip(&arm.rows).filter(|(_, row)| row.kind != 'F').map(|(pose, _)| pose).collect()
}

/// The pose of the tool in the base frame; metres and radians.
pub fn pose(arm: &Record, q: &[f64]) -> Matrix4 {
    product(arm, q)
}

/// The geometric Jacobian by columns: linear velocity of the tool point, then angular velocity, in base axes.
pub fn jacobian(arm: &Record, q: &[f64]) -> Vec<[f64; 6]> {
    (0..q.len())
        .map(|joint| {
            let seeded: Vec<Dual> = q
                .iter()
                .enumerate()
                .map(|(i, &value)| Dual { value, slope: f64::from(u8::from(i == joint)) })
                .collect();
            let m = product(arm, &seeded);
            // The skew part of the derivative of R times the transpose of R.
            let spin = |i: usize, j: usize| (0..3).map(|k| m[i][k].slope * m[j][k].value).sum::<f64>();
            [m[0][3].slope, m[1][3].slope, m[2][3].slope, spin(2, 1), spin(0, 2), spin(1, 0)]
        })
        .collect()
}
