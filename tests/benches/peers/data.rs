//! What all ways are asked: distinct random configurations of the IRB 2400, and the poses that they reach.

use kin_runtime::prelude::*;
use robots::Irb2400;
use rs_opw_kinematics::glam::{DMat3, DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::Pose as OpwPose;
use tests::sample::Sampler;

/// So many that no branch predictor learns them by heart.
pub(crate) const COUNT: usize = 16_384;

/// The same configurations and poses, as each library takes them.
pub(crate) struct Data {
    pub(crate) q: Vec<[f64; 6]>,
    pub(crate) joints: Vec<Joints<f64, 6>>,
    pub(crate) poses: Vec<Pose<f64>>,
    pub(crate) opw_poses: Vec<OpwPose>,
}

impl Data {
    pub(crate) fn new() -> Self {
        let mut sampler = Sampler::new(17);
        let q: Vec<[f64; 6]> = (0..COUNT).map(|_| sampler.angles()).collect();
        let joints: Vec<Joints<f64, 6>> = q.iter().map(|q| Joints::from(*q)).collect();
        let poses: Vec<Pose<f64>> = joints.iter().map(|q| Irb2400.fk(q)).collect();
        let opw_poses = poses.iter().map(opw_pose).collect();
        Data { q, joints, poses, opw_poses }
    }
}

fn opw_pose(pose: &Pose<f64>) -> OpwPose {
    let [position] = pose.translation.vector.data.0;
    let columns = pose.rotation.matrix().data.0.map(DVec3::from_array);
    let rotation = DQuat::from_mat3(&DMat3::from_cols(columns[0], columns[1], columns[2]));
    OpwPose::from_parts(DVec3::from_array(position), rotation)
}
