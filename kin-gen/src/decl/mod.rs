//! What is written: the declaration as its author typed it, every part with its place.
//!
//! ```text
//! text   ─ lex ─┐
//!               ├► tokens ─ grammar ─► Decl      nothing is resolved or computed here: a `Decl` may still name
//! macro tokens ─┘                                unknown lengths, divide by zero or add degrees to metres
//! ```
//!
//! One grammar serves both sources. It is written by hand and bounded ([`MAX_TOKENS`], [`MAX_NESTING`], …), so that
//! no input overflows the stack of the compiler that runs it; after a mistake it goes on at the next cell, row or
//! `;`, so that all mistakes are told at once. What could not be read stands in the `Decl` as a hole (`None`,
//! [`Content::Bad`]) about which nobody complains a second time.

mod cursor;
pub mod expr;
pub mod grammar;
pub mod lex;
pub(crate) mod nearest;
mod print;
mod render;
mod statement;
mod table;

pub use expr::{Expr, Function, Node, Sign, Unit};
pub use grammar::parse;
pub use lex::{Kind, Token, lex};
pub use render::render;

use crate::report::{Place, Spanned};

/// The longest declaration, in tokens: thirty times the largest arm anyone has printed.
pub const MAX_TOKENS: usize = 16_384;
/// The deepest nesting of parentheses in an expression.
pub const MAX_NESTING: usize = 64;
/// The most rows of a table, or factors of a chain.
pub const MAX_ROWS: usize = 128;
/// The most statements of each kind.
pub const MAX_STATEMENTS: usize = 512;

/// An axis of the current frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis.
    Z,
}

/// How the declaration is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// A table in the standard convention.
    Standard,
    /// A table in the modified convention.
    Modified,
    /// A row of elementary transforms.
    Chain,
}

impl Form {
    /// The word of the header.
    pub fn word(self) -> &'static str {
        match self {
            Form::Standard => "standard",
            Form::Modified => "modified",
            Form::Chain => "chain",
        }
    }
}

/// The declared unit of length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LengthUnit {
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
    /// Inches.
    Inch,
}

impl LengthUnit {
    /// The word of the header, and the suffix of a literal.
    pub fn word(self) -> &'static str {
        match self {
            LengthUnit::Metre => "m",
            LengthUnit::Centimetre => "cm",
            LengthUnit::Millimetre => "mm",
            LengthUnit::Inch => "in",
        }
    }

    /// Its exact size in tenths of a millimetre.
    pub fn tenths_of_millimetre(self) -> i64 {
        match self {
            LengthUnit::Metre => 10_000,
            LengthUnit::Centimetre => 100,
            LengthUnit::Millimetre => 10,
            LengthUnit::Inch => 254,
        }
    }
}

/// The declared unit of angle; at run time angles are always radians.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AngleUnit {
    /// Degrees.
    Degree,
    /// Radians.
    Radian,
}

impl AngleUnit {
    /// The word of the header, and the suffix of a literal.
    pub fn word(self) -> &'static str {
        match self {
            AngleUnit::Degree => "deg",
            AngleUnit::Radian => "rad",
        }
    }
}

/// A whole declaration. What is missing or could not be read has been reported by the parser.
#[derive(Clone, PartialEq, Debug)]
pub struct Decl {
    /// The type's name.
    pub name: Spanned<String>,
    /// The convention.
    pub form: Option<Form>,
    /// The unit of bare lengths.
    pub length_unit: Option<LengthUnit>,
    /// The unit of bare angles.
    pub angle_unit: Option<AngleUnit>,
    /// `let` and `param`, in order.
    pub bindings: Vec<Binding>,
    /// The table, where there is one.
    pub table: Option<Table>,
    /// The factors of the chain form, in order.
    pub factors: Vec<Factor>,
    /// From the world to the first row.
    pub base: Vec<Factor>,
    /// From the last row to the tool point.
    pub tool: Vec<Factor>,
    /// The couplings, in order.
    pub couples: Vec<Couple>,
    /// The golden poses, in order.
    pub checks: Vec<Check>,
    /// The family demanded by `ik:`.
    pub demanded: Option<Spanned<String>>,
    /// Whether no row and no factor was lost to a mistake, so that counting joints makes sense.
    pub whole: bool,
}

/// `let name = value;` or `param name = value;`.
#[derive(Clone, PartialEq, Debug)]
pub struct Binding {
    /// Whether it is a `param`.
    pub param: bool,
    /// The name.
    pub name: Spanned<String>,
    /// The value; `None` if it could not be read.
    pub value: Option<Expr>,
}

/// One elementary transform: `Rz(q + 90)`, `Tx(l2)`.
#[derive(Clone, PartialEq, Debug)]
pub struct Factor {
    /// Whether it turns about the axis rather than shifting along it.
    pub turn: bool,
    /// The axis of the current frame.
    pub axis: Axis,
    /// The angle or distance; `None` if it could not be read.
    pub argument: Option<Expr>,
    /// The whole factor.
    pub place: Place,
}

/// The columns of a table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Column {
    /// The joint's name; empty for a fixed row.
    Joint,
    /// The twist.
    Alpha,
    /// The length of the common normal.
    A,
    /// The offset along the joint axis.
    D,
    /// The joint angle.
    Theta,
    /// The range of q.
    Limits,
    /// A column whose header could not be understood.
    Unknown,
}

impl Column {
    /// The usual header.
    pub fn header(self) -> &'static str {
        match self {
            Column::Joint => "joint",
            Column::Alpha => "alpha",
            Column::A => "a",
            Column::D => "d",
            Column::Theta => "theta",
            Column::Limits => "limits",
            Column::Unknown => "?",
        }
    }
}

/// A Markdown table.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// Each column and how its header spells it.
    pub columns: Vec<(Column, String)>,
    /// The rows; each has one cell for each column.
    pub rows: Vec<Row>,
    /// The header row.
    pub place: Place,
}

/// One row of the table.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// The cells, in the order of the columns.
    pub cells: Vec<Cell>,
    /// The whole row.
    pub place: Place,
}

/// One cell of the table.
#[derive(Clone, PartialEq, Debug)]
pub struct Cell {
    /// What it holds.
    pub content: Content,
    /// Its tokens; of an empty cell, the bar that closes it.
    pub place: Place,
}

/// What a cell holds.
#[derive(Clone, PartialEq, Debug)]
pub enum Content {
    /// Nothing.
    Empty,
    /// A joint's name or number.
    Name(String),
    /// A value.
    Value(Expr),
    /// Limits.
    Range(Expr, Expr),
    /// Something that was reported.
    Bad,
}

/// `couple: J3 -= 2*J2;`.
#[derive(Clone, PartialEq, Debug)]
pub struct Couple {
    /// The joint on the left.
    pub target: Spanned<String>,
    /// Whether it is `-=` rather than `+=`.
    pub subtract: bool,
    /// The joints on the right, with integer coefficients.
    pub value: Expr,
    /// The whole statement.
    pub place: Place,
}

/// `check [q…] => (x, y, z) zyx(α, β, γ) within tolerance;`.
#[derive(Clone, PartialEq, Debug)]
pub struct Check {
    /// The commanded joint values.
    pub joints: Vec<Expr>,
    /// The expected position.
    pub position: [Expr; 3],
    /// The expected orientation Rz(α)·Ry(β)·Rx(γ).
    pub zyx: Option<[Expr; 3]>,
    /// The tolerance.
    pub within: Option<Expr>,
    /// The brackets with the joint values.
    pub joints_place: Place,
    /// The whole statement.
    pub place: Place,
}

/// Whether a name stands for a joint variable: `q`, `q3`, `q_3`, `theta3`, `theta_3`.
pub fn is_joint_variable(name: &str) -> bool {
    name == "q" || joint_number(name).is_some()
}

/// The 3 of `q3` and its like.
pub fn joint_number(name: &str) -> Option<u32> {
    let rest = name.strip_prefix("theta").or_else(|| name.strip_prefix('q'))?;
    let digits = rest.strip_prefix('_').unwrap_or(rest);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    digits.parse().ok()
}
