//! What is true: the arm as a row of exact elementary transforms.
//!
//! After [`check`]: every name is resolved, every unit is folded into the declared one, every value is exact
//! and finite, every quarter turn is known as such, each joint occurs exactly once and in order, the coupling can be
//! undone in integers. Nothing that was checked here is checked again.
//!
//! # The two conventions
//!
//! One row of a Denavit-Hartenberg table stands for four elementary transforms; their order is the convention:
//!
//! ```text
//! standard (Denavit and Hartenberg 1955, as in Paul 1981):  Rz(theta) Tz(d) Tx(a) Rx(alpha)
//! modified (Craig 1986), with the row's own alpha and a:    Rx(alpha) Tx(a) Rz(theta) Tz(d)
//! ```

mod check;
mod couple;
mod eval;
mod factors;
mod golden;
mod lengths;
mod listing;
mod measure;
mod names;
mod rows;
mod suspect;
mod value;

pub use crate::decl::{AngleUnit, Axis, Form, LengthUnit};
pub use check::check;

use crate::number::{Angle, Scalar};
use crate::report::Place;

/// A constant length of the arm: an atom of the algebra. Equal to another only if it is the same atom.
#[derive(Clone, PartialEq, Debug)]
pub struct Length {
    /// The name bound by `let`, else the field's name of the cell (`a2`, `d4`), else one made unique (`a2b`).
    pub name: String,
    /// Its exact value in the declared unit; never an exact zero.
    pub value: Scalar,
}

/// Whether a parameter is a length or an angle; its uses decide.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ParamKind {
    /// In the declared unit of length.
    Length,
    /// In radians at run time.
    Angle,
}

/// A `param`: an `f64` field of the generated struct.
#[derive(Clone, PartialEq, Debug)]
pub struct Param {
    /// The field's name.
    pub name: String,
    /// Length or angle.
    pub kind: ParamKind,
    /// Its nominal value: in the declared unit of length, or in radians.
    pub nominal: Scalar,
    /// Where it was declared.
    pub place: Place,
}

/// One term of a distance.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum LengthAtom {
    /// An index into [`Chain::lengths`].
    Constant(usize),
    /// An index into [`Chain::params`].
    Param(usize),
}

/// An integer combination of length atoms, sorted by atom, without zero coefficients; empty is exactly zero.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Distance(pub Vec<(i64, LengthAtom)>);

/// An exact constant angle plus an integer combination of angle parameters, sorted by parameter.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct AngleSum {
    /// The constant part.
    pub constant: Angle,
    /// Coefficients and indices into [`Chain::params`].
    pub params: Vec<(i64, usize)>,
}

/// What one elementary transform does about, or along, its axis.
#[derive(Clone, PartialEq, Debug)]
pub enum Motion {
    /// A constant rotation; never an exact zero.
    Turn(AngleSum),
    /// A constant translation; never an exact zero.
    Shift(Distance),
    /// A revolute joint: the angle is `offset + t`, or `offset - t` if reversed, `t` being the joint's row value.
    Revolute {
        /// The joint, counted from 0.
        joint: usize,
        /// Whether the cell says `-q`.
        reversed: bool,
        /// The constant part of the cell.
        offset: AngleSum,
    },
    /// A prismatic joint: the distance is `offset + t`, or `offset - t` if reversed.
    Prismatic {
        /// The joint, counted from 0.
        joint: usize,
        /// Whether the cell says `-q`.
        reversed: bool,
        /// The constant part of the cell.
        offset: Distance,
    },
}

/// One elementary transform of the chain.
#[derive(Clone, PartialEq, Debug)]
pub struct Element {
    /// About or along which axis of the current frame.
    pub axis: Axis,
    /// What it does.
    pub motion: Motion,
    /// The cell, or the factor of the chain form, that it comes from.
    pub place: Place,
}

/// The two kinds of joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointKind {
    /// Turns; values in radians.
    Revolute,
    /// Slides; values in the declared unit of length.
    Prismatic,
}

/// A joint and what the table says about it.
#[derive(Clone, PartialEq, Debug)]
pub struct Joint {
    /// As in the `joint` column, or `J1`, `J2`, ….
    pub name: String,
    /// Turning or sliding.
    pub kind: JointKind,
    /// Inclusive limits of q, in radians or the declared unit of length.
    pub limits: Option<(Scalar, Scalar)>,
    /// The row, or the factor of the chain form.
    pub place: Place,
}

/// What is true of a declared arm.
#[derive(Clone, PartialEq, Debug)]
pub struct Chain {
    /// The type's name.
    pub name: String,
    /// How it was written.
    pub form: Form,
    /// The unit of every length.
    pub length_unit: LengthUnit,
    /// The unit in which angles were written.
    pub angle_unit: AngleUnit,
    /// The constant lengths, in order of first use.
    pub lengths: Vec<Length>,
    /// The parameters, in order of declaration.
    pub params: Vec<Param>,
    /// The joints, in order.
    pub joints: Vec<Joint>,
    /// From the world to the first row: constants only.
    pub base: Vec<Element>,
    /// The rows, or the factors of the chain form, in order.
    pub elements: Vec<Element>,
    /// Frame i is the product of base and `elements[.. frames[i]]`; one entry for each joint.
    pub frames: Vec<usize>,
    /// From the last row to the tool point: constants only.
    pub tool: Vec<Element>,
    /// Row values from commanded ones: `t[i] = sum over j of couple[i][j] * q[j]`. The identity without `couple:`.
    pub couple: Vec<Vec<i64>>,
    /// The inverse of [`Chain::couple`], also in integers.
    pub uncouple: Vec<Vec<i64>>,
    /// The family demanded by `ik:`, if any.
    pub demanded: Option<crate::report::Spanned<String>>,
    /// The declaration as a reader wants to see it: its own text, with normal spacing.
    pub text: String,
    /// The declared name's place: where messages about the whole arm go.
    pub place: Place,
}
