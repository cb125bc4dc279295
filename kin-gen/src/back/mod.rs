//! Backends: each prints a derived arm in one language, and decides nothing.
//!
//! # Adding a backend
//!
//! One file here, with a function from [`crate::model::Arm`] to text; one line in [`ALL`]; one line of the conformance
//! suite, which holds what the text computes against [`crate::eval`].

pub mod infix;
pub mod listing;
pub mod mathml;
pub mod rust;

use crate::model::Arm;

/// A backend: its name on command lines, and its printer.
pub struct Backend {
    /// Its name.
    pub name: &'static str,
    /// Prints an arm.
    pub print: fn(&Arm) -> String,
}

/// All backends.
pub const ALL: [Backend; 3] = [
    Backend { name: "listing", print: listing::print },
    Backend { name: "mathml", print: mathml::print },
    Backend { name: "rust", print: |arm| rust::items(arm, "::kin_runtime") },
];
