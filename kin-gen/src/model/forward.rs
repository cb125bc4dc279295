//! Forward kinematics, frames and Jacobian, each alone and the first and the last together.

use super::{Forward, Work, flat};
use crate::algebra::frame::{Frames, Stretch, Values};
use crate::algebra::ring::Poly;
use crate::algebra::vector;
use crate::chain::Element;
use crate::derive::jacobian::{self, Column};
use crate::derive::pose::{self, TermPose};
use crate::derive::wrist;
use crate::program::Mismatch;
use crate::truth;

impl Work<'_> {
    pub(super) fn forward(&mut self) -> Result<Forward, Mismatch> {
        let frames = self.whole_frames()?;
        let chain = self.chain;
        let ring = &mut self.exprs.ring;
        let raw = truth::whole(ring, &self.symbols, chain, Values::Commanded, &self.outers);
        let raw = raw.ok_or(Mismatch::TooLarge)?;
        let columns = truth::jacobian(&self.exprs.ring, &self.symbols, chain, &raw);
        let columns: Vec<Poly> = columns.into_iter().flatten().collect();
        let tip = pose_polys(&raw.tip);
        let start = self.exprs.mark();

        let derived = pose::fk(&mut self.exprs, &frames);
        let derived = self.placed(&derived, true);
        let fk = self.program("fk", &derived.outputs(""), &tip)?;
        self.exprs.roll_back(start);

        let derived = pose::all_frames(&mut self.exprs, &frames);
        let derived: Vec<TermPose> = derived.iter().map(|frame| self.placed(frame, false)).collect();
        let named = |(i, pose): (usize, &TermPose)| pose.outputs(&format!("_{}", i + 1));
        let outputs: Vec<_> = derived.iter().enumerate().flat_map(named).collect();
        let truth: Vec<Poly> = raw.frames.iter().flat_map(pose_polys).collect();
        let all_frames = self.program("frames", &outputs, &truth)?;
        self.exprs.roll_back(start);

        let derived = jacobian::jacobian(&mut self.exprs, &frames, &chain.couple);
        let derived = self.placed_columns(derived);
        let jacobian = self.program("jacobian", &jacobian::outputs(&derived), &columns)?;
        self.exprs.roll_back(start);

        let (derived, derived_columns) = jacobian::fk_jacobian(&mut self.exprs, &frames, &chain.couple);
        let derived = self.placed(&derived, true);
        let derived_columns = self.placed_columns(derived_columns);
        let truth: Vec<Poly> = tip.into_iter().chain(columns).collect();
        let outputs = jacobian::pose_outputs(&derived, &derived_columns);
        let fk_jacobian = self.program("fk_jacobian", &outputs, &truth)?;
        self.exprs.roll_back(start);
        Ok(Forward { fk, frames: all_frames, jacobian, fk_jacobian })
    }

    /// The frames of the chain up to the tool point. A general base stands apart; of a general tool only its point is
    /// in them.
    pub(super) fn whole_frames(&mut self) -> Result<Frames, Mismatch> {
        let chain = self.chain;
        let own = |elements: &'_ [Element], apart: bool| if apart { Vec::new() } else { elements.to_vec() };
        let base = own(&chain.base, self.outers.base.general);
        let tool = own(&chain.tool, self.outers.tool.general);
        let elements = base.iter().chain(&chain.elements).chain(&tool).collect();
        let stretch = Stretch { elements, frames: chain.frames.iter().map(|f| f + base.len()).collect() };
        let mut frames = self.frames(Values::Commanded, &stretch)?;
        if self.outers.tool.general {
            let point = wrist::constants(&mut self.exprs, &self.outers.tool.pose.position);
            let offset = vector::apply(&mut self.exprs, &frames.tip.local, &point);
            frames.tip.shift = vector::add(&mut self.exprs, &frames.tip.shift, &offset);
        }
        Ok(frames)
    }

    /// A derived pose with the base, and the turn of the tool, where these stand apart.
    pub(super) fn placed(&mut self, pose: &TermPose, with_tool: bool) -> TermPose {
        let mut pose = *pose;
        if with_tool && self.outers.tool.general {
            let turn = wrist::constant_matrix(&mut self.exprs, &self.outers.tool.pose.rotation);
            pose.rotation = vector::product(&mut self.exprs, &pose.rotation, &turn);
        }
        if self.outers.base.general {
            let turn = wrist::constant_matrix(&mut self.exprs, &self.outers.base.pose.rotation);
            let point = wrist::constants(&mut self.exprs, &self.outers.base.pose.position);
            pose.rotation = vector::product(&mut self.exprs, &turn, &pose.rotation);
            let turned = vector::apply(&mut self.exprs, &turn, &pose.position);
            pose.position = vector::add(&mut self.exprs, &point, &turned);
        }
        pose
    }

    fn placed_columns(&mut self, columns: Vec<Column>) -> Vec<Column> {
        if !self.outers.base.general {
            return columns;
        }
        let turn = wrist::constant_matrix(&mut self.exprs, &self.outers.base.pose.rotation);
        let place = |[a, b, c, x, y, z]: Column| {
            let [a, b, c] = vector::apply(&mut self.exprs, &turn, &[a, b, c]);
            let [x, y, z] = vector::apply(&mut self.exprs, &turn, &[x, y, z]);
            [a, b, c, x, y, z]
        };
        columns.into_iter().map(place).collect()
    }
}

fn pose_polys(pose: &truth::RawPose) -> Vec<Poly> {
    flat(&pose.rotation).into_iter().chain(pose.position.clone()).collect()
}
