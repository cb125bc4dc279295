//! The numeric examples of the four lab reports, recomputed with 50 digits (`data/seeds_truth.json`).

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::reference::{Matrix4, read};

/// The parts of the truth that are numbers.
#[derive(Deserialize, Debug)]
pub struct Truth {
    /// The six-axis lab arm.
    pub seed000: Seed000,
    /// The three-joint lab arm.
    pub seed004: Seed004,
}

/// The six-axis lab arm.
#[derive(Deserialize, Debug)]
pub struct Seed000 {
    /// Forward kinematics of the truncated solutions of section 6.1.
    pub fk_of_truncated: Vec<Truncated>,
    /// The inverse examples of section 6.
    pub ik: BTreeMap<String, Example>,
    /// A pose with z1 aligned with z4, which the report says is not singular.
    pub z1_aligned_z4: Aligned,
    /// The wrist centre on z1 with a general orientation.
    pub wrist_on_z1_general_orientation: Aligned,
}

/// One printed forward pose.
#[derive(Deserialize, Debug)]
pub struct Truncated {
    /// The joint values, as printed.
    pub q: [f64; 6],
    /// Position in millimetres and ZYX angles, as printed.
    pub printed: [f64; 6],
    /// The position in millimetres.
    pub truth_xyz_mm: [String; 3],
    /// The angles about z, y and x.
    pub truth_zyx: [String; 3],
}

/// One inverse example.
#[derive(Deserialize, Debug)]
pub struct Example {
    /// The pose, in metres.
    #[serde(rename = "T")]
    pub pose: Matrix4,
    /// Every isolated solution.
    pub isolated: Vec<[f64; 6]>,
    /// The printed rows.
    pub printed_check: Vec<PrintedRow>,
}

/// One printed solution.
#[derive(Deserialize, Debug)]
pub struct PrintedRow {
    /// The joint values, as printed.
    pub q: [f64; 6],
}

/// A configuration and its singular values.
#[derive(Deserialize, Debug)]
pub struct Aligned {
    /// The joint values.
    pub q: [f64; 6],
    /// The singular values of the Jacobian in metres and radians.
    pub singular_values: [f64; 6],
}

/// The three-joint lab arm.
#[derive(Deserialize, Debug)]
pub struct Seed004 {
    /// for_kin(0.5, 0.5, -0.5).
    #[serde(rename = "for_kin(0.5,0.5,-0.5)")]
    pub for_kin: ForKin,
    /// The four solutions for that point.
    #[serde(rename = "true position IK (all)")]
    pub solutions: Vec<[f64; 3]>,
}

/// The report's test of its forward kinematics.
#[derive(Deserialize, Debug)]
pub struct ForKin {
    /// The position with 20 digits.
    pub truth: [String; 3],
    /// As printed.
    pub printed: [f64; 3],
}

/// Reads the truth.
pub fn truth() -> Truth {
    read("seeds_truth.json")
}
