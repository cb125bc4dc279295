//! The programs of an arm with a spherical shoulder.

use super::{ShoulderSolver, Work, coordinates, flat, matrix_outputs};
use crate::algebra::frame::{Stretch, Values};
use crate::algebra::vector;
use crate::derive::wrist;
use crate::family::spherical_shoulder::SphericalShoulder;
use crate::program::{Mismatch, Program};

impl Work<'_> {
    pub(super) fn shoulder_solver(
        &mut self,
        geometry: SphericalShoulder,
    ) -> Result<ShoulderSolver, Mismatch> {
        let shoulder_centre = self.centre_program(&geometry)?;
        let shoulder_rotation = self.rotation_program(&geometry)?;
        let shoulder_matrix = self.matrix_program("shoulder_matrix", &geometry.shoulder)?;
        Ok(ShoulderSolver { geometry, shoulder_centre, shoulder_rotation, shoulder_matrix })
    }

    /// A point fixed in the world, seen from the given pose: Rᵀ·(centre - p), in the frame of the base.
    fn centre_program(&mut self, geometry: &SphericalShoulder) -> Result<Program, Mismatch> {
        let start = self.exprs.mark();
        let base = &geometry.base;
        let derived =
            wrist::point_seen_from_pose(&mut self.exprs, &geometry.centre, &base.axes, &base.origin);
        let given = self.given_rotation();
        let position = [9, 10, 11].map(|i| self.symbols.entry(&self.exprs.ring, i));
        let ring = &mut self.exprs.ring;
        let from_tool = vector::sub(ring, &geometry.centre, &position);
        let seen = vector::apply(ring, &vector::transpose(&given), &from_tool);
        let from_origin = vector::sub(ring, &seen, &base.origin);
        let truth = vector::apply(ring, &vector::transpose(&base.axes), &from_origin);
        let program = self.program("shoulder_centre", &coordinates(derived), &truth)?;
        self.exprs.roll_back(start);
        Ok(program)
    }

    /// ⁰R₃ = Bᵀ·R·Q·³R₆ᵀ, with B the base's turn and Q what leads from the tool back to frame 6.
    fn rotation_program(&mut self, geometry: &SphericalShoulder) -> Result<Program, Mismatch> {
        let chain = self.chain;
        let start = self.exprs.mark();
        let third = chain.frames.get(2).copied().unwrap_or(0);
        let sixth = chain.frames.get(5).copied().unwrap_or(chain.elements.len());
        let hand = Stretch { elements: chain.elements[third..sixth].iter().collect(), frames: Vec::new() };
        let frames = self.frames(Values::Rows, &hand)?;
        let raw = self.raw(Values::Rows, &hand)?;
        let before = self.outers.base.pose.rotation.clone();
        let derived = wrist::rotation_before(&mut self.exprs, &frames, &before, &geometry.tool_to_frame6);
        let given = self.given_rotation();
        let ring = &mut self.exprs.ring;
        let left = vector::product(ring, &vector::transpose(&before), &given);
        let whole = vector::product(ring, &left, &geometry.tool_to_frame6);
        let truth = vector::product(ring, &whole, &vector::transpose(&raw.tip.rotation));
        let program = self.program("shoulder_rotation", &matrix_outputs(&derived), &flat(&truth))?;
        self.exprs.roll_back(start);
        Ok(program)
    }
}
