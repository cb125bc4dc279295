//! The IRB 2400 as others have it. Each is asked for the same poses before anything is timed.

use k::nalgebra as old;
use kin_runtime::prelude::*;
use nalgebra::{Isometry3, IsometryMatrix3, Matrix4, Rotation3, Translation3, UnitQuaternion, Vector3};
use robots::Irb2400;
use rs_opw_kinematics::jacobian::Jacobian as OpwJacobian;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::FRAC_PI_2;

/// The rows of the table: what is added to q, d, a, alpha.
const ROWS: [[f64; 4]; 6] = [
    [0.0, 0.615, 0.1, -FRAC_PI_2],
    [FRAC_PI_2, 0.0, -0.705, 0.0],
    [0.0, 0.0, -0.135, FRAC_PI_2],
    [0.0, 0.755, 0.0, -FRAC_PI_2],
    [0.0, 0.0, 0.0, FRAC_PI_2],
    [0.0, 0.085, 0.0, 0.0],
];

/// rs-opw-kinematics.
pub(crate) fn opw() -> OPWKinematics {
    OPWKinematics::new(Parameters::irb2400_10())
}

/// Its step for differences, as its documentation has it.
pub(crate) const OPW_STEP: f64 = 1e-6;

/// nalgebra's product of six isometries, each a joint's turn and the fixed rest of its row; rotations are quaternions.
pub(crate) struct Isometries([(f64, Isometry3<f64>); 6]);

impl Isometries {
    pub(crate) fn new() -> Self {
        Isometries(ROWS.map(|[offset, d, a, alpha]| {
            let twist = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), alpha);
            (offset, Isometry3::from_parts(Translation3::new(a, 0.0, d), twist))
        }))
    }

    pub(crate) fn fk(&self, q: &[f64; 6]) -> Isometry3<f64> {
        let mut pose = Isometry3::identity();
        for ((offset, rest), q) in self.0.iter().zip(q) {
            pose *= UnitQuaternion::from_axis_angle(&Vector3::z_axis(), q + offset) * rest;
        }
        pose
    }
}

/// The same with rotation matrices, which is what this library returns.
pub(crate) struct Rotations([(f64, IsometryMatrix3<f64>); 6]);

impl Rotations {
    pub(crate) fn new() -> Self {
        Rotations(ROWS.map(|[offset, d, a, alpha]| {
            let twist = Rotation3::from_axis_angle(&Vector3::x_axis(), alpha);
            (offset, IsometryMatrix3::from_parts(Translation3::new(a, 0.0, d), twist))
        }))
    }

    pub(crate) fn fk(&self, q: &[f64; 6]) -> IsometryMatrix3<f64> {
        let mut pose = IsometryMatrix3::identity();
        for ((offset, rest), q) in self.0.iter().zip(q) {
            pose *= Rotation3::from_axis_angle(&Vector3::z_axis(), q + offset) * rest;
        }
        pose
    }
}

/// nalgebra's product of six homogeneous matrices, each written out as textbooks do.
pub(crate) struct Matrices([([f64; 4], (f64, f64)); 6]);

impl Matrices {
    pub(crate) fn new() -> Self {
        Matrices(ROWS.map(|row| (row, row[3].sin_cos())))
    }

    pub(crate) fn fk(&self, q: &[f64; 6]) -> Matrix4<f64> {
        let mut pose = Matrix4::identity();
        for (([offset, d, a, _], (sa, ca)), q) in self.0.iter().zip(q) {
            let (s, c) = nalgebra::ComplexField::sin_cos(q + offset);
            pose *= Matrix4::new(
                c,
                -s * ca,
                s * sa,
                a * c,
                s,
                c * ca,
                -c * sa,
                a * s,
                0.0,
                *sa,
                *ca,
                *d,
                0.0,
                0.0,
                0.0,
                1.0,
            );
        }
        pose
    }
}

/// k: a chain of nodes, each a joint whose origin is the fixed rest of the row before.
pub(crate) struct Chain(k::SerialChain<f64>);

impl Chain {
    pub(crate) fn new() -> Self {
        let mut before = old::Isometry3::identity();
        let mut nodes: Vec<k::Node<f64>> = Vec::new();
        for (index, [offset, d, a, alpha]) in ROWS.into_iter().enumerate() {
            let turned = old::UnitQuaternion::from_axis_angle(&old::Vector3::z_axis(), offset);
            let origin = before * old::Isometry3::from_parts(old::Translation3::identity(), turned);
            let joint_type = k::JointType::Rotational { axis: old::Vector3::z_axis() };
            let name = format!("J{}", index + 1);
            nodes.push(k::NodeBuilder::new().name(&name).joint_type(joint_type).origin(origin).into_node());
            let twist = old::UnitQuaternion::from_axis_angle(&old::Vector3::x_axis(), alpha);
            before = old::Isometry3::from_parts(old::Translation3::new(a, 0.0, d), twist);
        }
        nodes.push(k::NodeBuilder::new().name("flange").origin(before).into_node());
        for pair in nodes.windows(2) {
            pair[1].set_parent(&pair[0]);
        }
        Chain(k::SerialChain::new_unchecked(k::Chain::from_root(nodes.swap_remove(0))))
    }

    pub(crate) fn fk(&self, q: &[f64; 6]) -> old::Isometry3<f64> {
        self.0.set_joint_positions_unchecked(q);
        self.0.end_transform()
    }

    pub(crate) fn jacobian(&self, q: &[f64; 6]) -> old::DMatrix<f64> {
        self.0.set_joint_positions_unchecked(q);
        k::jacobian(&self.0)
    }
}

/// Whether all that is timed is the same arm.
///
/// # Panics
/// Where one of them is not.
pub(crate) fn agree(samples: &[[f64; 6]]) {
    let (opw, isometries, rotations) = (opw(), Isometries::new(), Rotations::new());
    let (matrices, chain) = (Matrices::new(), Chain::new());
    for q in samples {
        let (pose, jacobian) = Irb2400.fk_jacobian(&Joints::from(*q));
        let same = |what: &str, difference: f64, within: f64| {
            assert!(difference < within, "{what} differs by {difference:e} at {q:?}");
        };
        let matrix = pose.to_homogeneous();
        same("isometries", (isometries.fk(q).to_homogeneous() - matrix).amax(), 1e-14);
        same("rotations", (rotations.fk(q).to_homogeneous() - matrix).amax(), 1e-14);
        same("matrices", (matrices.fk(q) - matrix).amax(), 1e-14);
        let [position] = pose.translation.vector.data.0;
        let theirs = opw.forward(q).translation.to_array();
        let apart = |a: [f64; 3]| a.iter().zip(position).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        same("rs-opw-kinematics", apart(theirs), 1e-14);
        let [theirs] = chain.fk(q).translation.vector.data.0;
        same("k", apart(theirs), 1e-14);
        let (by_opw, by_k) = (OpwJacobian::new(&opw, q, OPW_STEP), chain.jacobian(q));
        for row in 0..6 {
            for column in 0..6 {
                let ours = jacobian[(row, column)];
                same("the Jacobian of k", (by_k[(row, column)] - ours).abs(), 1e-13);
                same("the Jacobian of rs-opw", (by_opw.matrix().rows()[row][column] - ours).abs(), 1e-5);
            }
        }
    }
}
