//! The reference arms and their cases, as `data/README.md` describes them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::expression::value;

/// A pose as the data writes it, the last row 0 0 0 1 included.
pub type Matrix4 = [[f64; 4]; 4];

/// One arm of `arms.json`: facts, lengths in metres, angles in radians.
#[derive(Clone, Deserialize, Debug)]
pub struct Record {
    /// The name, also of the file with its cases.
    pub name: String,
    /// `standard` or `modified`.
    pub convention: String,
    /// The number of joints.
    pub dof: usize,
    /// From the world to the first row.
    pub base: Frame,
    /// The rows.
    pub rows: Vec<Row>,
    /// From the last row to the tool point.
    pub tool: Frame,
    /// The limits of each joint, where the source has them.
    pub limits: Option<Vec<Option<[String; 2]>>>,
    /// What the geometry is like.
    pub family: Family,
}

/// A fixed transform, read as in URDF: `T(xyz) Rz(rpy[2]) Ry(rpy[1]) Rx(rpy[0])`.
#[derive(Clone, Deserialize, Debug)]
pub struct Frame {
    /// The translation.
    pub xyz: [String; 3],
    /// Roll, pitch and yaw.
    pub rpy: [String; 3],
}

/// One row of the table.
#[derive(Clone, Deserialize, Debug)]
pub struct Row {
    /// `R` (q adds to theta), `P` (q adds to d) or `F` (fixed).
    #[serde(rename = "type")]
    pub kind: char,
    /// The angle about z.
    pub theta: String,
    /// The offset along z.
    pub d: String,
    /// The length of the common normal.
    pub a: String,
    /// The twist.
    pub alpha: String,
}

/// What the geometry of an arm is like.
#[derive(Clone, Deserialize, Debug)]
pub struct Family {
    /// Its name.
    pub name: String,
}

/// The cases of one arm.
#[derive(Clone, Deserialize, Debug)]
pub struct Cases {
    /// Forward kinematics and Jacobian.
    pub fk: Vec<Forward>,
    /// Inverse kinematics.
    pub ik: Vec<Inverse>,
}

/// One forward case: 50-digit arithmetic rounded to doubles.
#[derive(Clone, Deserialize, Debug)]
pub struct Forward {
    /// The joint values.
    pub q: Vec<f64>,
    /// The pose of the tool.
    #[serde(rename = "T")]
    pub pose: Matrix4,
    /// The Jacobian, six rows, linear ones first, printed to 15 digits.
    #[serde(rename = "J")]
    pub jacobian: [Vec<f64>; 6],
}

/// One inverse case.
#[derive(Clone, Deserialize, Debug)]
pub struct Inverse {
    /// What is special about the pose.
    pub kind: String,
    /// `pose` or `position`.
    pub task: String,
    /// The pose to reach.
    pub pose: Matrix4,
    /// Every isolated solution.
    pub solutions: Vec<Vec<f64>>,
    /// The smallest singular value at each of them.
    pub sigma_min: Vec<f64>,
    /// Singular isolated solutions.
    #[serde(default)]
    pub double_roots: Vec<Vec<f64>>,
    /// One-parameter sets.
    #[serde(default)]
    pub families: Vec<OneParameter>,
    /// The relative shift across the limit of reach.
    pub rel_eps: Option<f64>,
    /// The joints that are ill determined.
    #[serde(default)]
    pub near_moving: Vec<usize>,
}

/// A one-parameter set of solutions.
#[derive(Clone, Deserialize, Debug)]
pub struct OneParameter {
    /// One of them.
    pub member: Vec<f64>,
    /// The joints that stay, and their values.
    pub fixed: BTreeMap<usize, f64>,
    /// The joints that move.
    pub moving: Vec<usize>,
}

/// Reads a file of `tests/data`.
///
/// # Panics
///
/// Where the file is missing or not what it should be: the data is part of the tests.
pub fn read<T: for<'a> Deserialize<'a>>(path: impl AsRef<Path>) -> T {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/data")).join(path);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// All arms of the reference.
pub fn arms() -> Vec<Record> {
    read("arms.json")
}

/// The arm of that name.
///
/// # Panics
///
/// Where there is none.
pub fn arm(name: &str) -> Record {
    arms().into_iter().find(|arm| arm.name == name).unwrap_or_else(|| panic!("no arm {name}"))
}

impl Record {
    /// Its cases.
    pub fn cases(&self) -> Cases {
        read(format!("cases/{}.json", self.name))
    }

    /// The kinds of its joints: `R` or `P`.
    pub fn kinds(&self) -> Vec<char> {
        self.rows.iter().map(|row| row.kind).filter(|&kind| kind != 'F').collect()
    }

    /// The evaluated limits of joint `i`.
    pub fn limits_of(&self, i: usize) -> Option<(f64, f64)> {
        let [lower, upper] = self.limits.as_ref()?.get(i)?.as_ref()?;
        Some((value(lower), value(upper)))
    }

    /// The sum of |a| + |d| of the rows and of the lengths of the tool, by which lengths are scaled.
    pub fn reach(&self) -> f64 {
        let rows: f64 = self.rows.iter().map(|row| value(&row.a).abs() + value(&row.d).abs()).sum();
        rows + self.tool.xyz.iter().map(|x| value(x).abs()).sum::<f64>()
    }
}
