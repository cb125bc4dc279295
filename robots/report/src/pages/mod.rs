//! The pages: one module for each of the four lab reports.

pub mod elbow_wrist;
pub mod lab_arm;
pub mod lab_rrr;
mod parts;
mod sample;
pub mod yzy;

use crate::html::Page;
use crate::model::ModelError;

/// A page that can be written.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// The name of its file, without ending.
    pub file: &'static str,
    /// What it is about.
    pub title: &'static str,
    /// Writes it.
    pub write: fn() -> Result<Page, ModelError>,
}

/// All of them.
pub const ALL: [Report; 4] = [
    Report { file: "seed-000", title: "Six-axis lab arm (Lisbon, 2019)", write: lab_arm::page },
    Report { file: "seed-001", title: "Anthropomorphic arm with a y-z-y wrist", write: yzy::page },
    Report {
        file: "seed-003",
        title: "Elbow arm with a spherical wrist: tracking and trajectories",
        write: elbow_wrist::page,
    },
    Report { file: "seed-004", title: "Three-joint lab arm", write: lab_rrr::page },
];
