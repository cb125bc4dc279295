//! Pictures, plots and pages of arms that `dh!` declares.
//!
//! ```text
//! an arm's table ─► model ─► picture (links, joints, frames)    ─┐
//!                     │  └─► section (workspace)                 ├─► svg ─► html ─► pages
//!                     ├─► exact (true values)      plot ─────────┘            ▲
//!                     └─► formulas (MathML from the algebra) ─────────────────┘
//! ```
//!
//! A drawing stands alone ([`svg::Svg::standalone`]) or on a page ([`html::Page`]); colours are names of one style sheet, so
//! that both follow the reader's light or dark screen and the printer. Lengths are in the arm's own unit, angles in radians.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use report::{model::Model, picture::{Look, Picture}, view::View};
//! use robots::Puma560;
//!
//! let model = Model::of(Puma560::TABLE)?;
//! let q = [0.3, -0.9, 0.4, 0.0, 0.8, 0.2];
//! let pose = Puma560.fk(&Joints::from(q));
//! // All solutions over one another, seen from the front right, slightly from above.
//! let target = [pose.translation.x, pose.translation.y, pose.translation.z];
//! let mut picture = Picture::new(View::from(-55.0, 20.0), model.reach(), "m").target(target);
//! for solution in &Puma560.ik(&pose) {
//!     picture = picture.arm(&model.body(solution.q.as_slice()), Look::Ghost);
//! }
//! let file = picture.arm(&model.body(&q), Look::Solid).draw(480.0, "Puma 560").standalone();
//! assert!(file.starts_with("<svg"));
//! # Ok::<(), report::model::ModelError>(())
//! ```

pub mod exact;
pub mod formulas;
pub mod html;
pub mod model;
pub mod pages;
pub mod picture;
pub mod plot;
pub mod section;
pub mod svg;
pub mod view;
