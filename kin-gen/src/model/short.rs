//! The programs of an arm with two to five joints that is solved for a pose.

use super::{ShortSolver, Work, flat, matrix_outputs};
use crate::algebra::frame::{Stretch, Values};
use crate::algebra::vector;
use crate::chain::Element;
use crate::derive::wrist;
use crate::family::short::{self, Short};
use crate::program::{Mismatch, Program};
use crate::truth;

impl Work<'_> {
    pub(super) fn short_solver(&mut self, geometry: Short) -> Result<ShortSolver, Mismatch> {
        let frame = geometry.carrier.frame();
        let carried_point = self.point_program("carried_point", &geometry.point_in_tool, frame)?;
        let rest = self.rest_program(&geometry)?;
        Ok(ShortSolver { geometry, carried_point, rest })
    }

    /// Fᵀ·(⁰Rₖᵀ·Bᵀ·R·Q)·G: what is left of a given rotation R behind frame k, after which the turns begin.
    fn rest_program(&mut self, geometry: &Short) -> Result<Program, Mismatch> {
        let chain = self.chain;
        let start = self.exprs.mark();
        let before = short::frame_before(&geometry.order, geometry.carriers);
        let end = chain.frames.get(before).copied().unwrap_or(chain.elements.len());
        let apart = self.outers.base.general;
        let base: &[Element] = if apart { &[] } else { &chain.base };
        let arm =
            Stretch { elements: base.iter().chain(&chain.elements[..end]).collect(), frames: Vec::new() };
        let frames = self.frames(Values::Rows, &arm)?;
        let mut raw = self.raw(Values::Rows, &arm)?.tip;
        if apart {
            raw = truth::compose(&mut self.exprs.ring, &self.outers.base.pose, &raw);
        }
        let unturned = vector::identity(&self.exprs.ring);
        let outer = if apart { self.outers.base.pose.rotation.clone() } else { unturned };
        let turns = &geometry.turns;
        let after = vector::product(&mut self.exprs.ring, &geometry.tool_to_last, &turns.after);
        let derived = wrist::rotation_of_pose(&mut self.exprs, &frames, &outer, &after);
        let seen = wrist::constant_matrix(&mut self.exprs, &vector::transpose(&turns.before));
        let derived = vector::product(&mut self.exprs, &seen, &derived);
        let given = self.given_rotation();
        let ring = &mut self.exprs.ring;
        let left = vector::product(ring, &vector::transpose(&raw.rotation), &given);
        let right = vector::product(ring, &left, &after);
        let truth = vector::product(ring, &vector::transpose(&turns.before), &right);
        let program = self.program("rest", &matrix_outputs(&derived), &flat(&truth))?;
        self.exprs.roll_back(start);
        Ok(program)
    }
}
