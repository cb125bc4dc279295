//! The programs of an arm with a spherical wrist.

use super::{PoseSolver, Work, flat, matrix_outputs, rotation_outputs};
use crate::algebra::frame::Values;
use crate::algebra::ring::Poly;
use crate::algebra::vector;
use crate::derive::wrist;
use crate::family::spherical_wrist::SphericalWrist;
use crate::program::Mismatch;
use crate::truth;

impl Work<'_> {
    pub(super) fn pose_solver(&mut self, geometry: SphericalWrist) -> Result<PoseSolver, Mismatch> {
        let apart = self.outers.base.general;
        let [arm, hand] = self.arm_and_hand();
        let start = self.exprs.mark();

        let frames = self.frames(Values::Rows, &hand)?;
        let raw_hand = self.raw(Values::Rows, &hand)?;
        let derived = wrist::r36(&mut self.exprs, &frames);
        let r36 = self.program("r36", &rotation_outputs(&derived), &flat(&raw_hand.tip.rotation))?;
        self.exprs.roll_back(start);

        let frames = self.frames(Values::Rows, &arm)?;
        let mut raw_arm = self.raw(Values::Rows, &arm)?.tip;
        if apart {
            raw_arm = truth::compose(&mut self.exprs.ring, &self.outers.base.pose, &raw_arm);
        }
        let after_frames = self.exprs.mark();
        let derived = wrist::r03(&mut self.exprs, &frames, &geometry.centre_in_frame3);
        let derived = self.placed(&derived, false);
        let ring = &mut self.exprs.ring;
        let centre = vector::apply(ring, &raw_arm.rotation, &geometry.centre_in_frame3);
        let centre = vector::add(ring, &raw_arm.position, &centre);
        let truth: Vec<Poly> = flat(&raw_arm.rotation).into_iter().chain(centre.clone()).collect();
        let r03 = self.program("r03", &derived.outputs(""), &truth)?;
        self.exprs.roll_back(after_frames);

        let unturned = vector::identity(&self.exprs.ring);
        let before = if apart { &self.outers.base.pose.rotation } else { &unturned };
        let derived = wrist::rotation_of_pose(&mut self.exprs, &frames, before, &geometry.tool_to_frame6);
        let given = self.given_rotation();
        let ring = &mut self.exprs.ring;
        let left = vector::product(ring, &vector::transpose(&raw_arm.rotation), &given);
        let truth = vector::product(ring, &left, &geometry.tool_to_frame6);
        let wrist_rotation = self.program("wrist_rotation", &matrix_outputs(&derived), &flat(&truth))?;
        self.exprs.roll_back(start);

        let frame = (&geometry.base.axes, &geometry.base.origin);
        let wrist_centre = self.point_program("wrist_centre", &geometry.centre_in_tool, frame)?;
        let wrist_matrix = self.matrix_program("wrist_matrix", &geometry.wrist)?;

        Ok(PoseSolver {
            geometry,
            r36,
            r03,
            wrist_centre,
            wrist_rotation,
            wrist_matrix,
            r36_meaning: raw_hand.tip.rotation,
            centre_meaning: centre,
        })
    }
}
