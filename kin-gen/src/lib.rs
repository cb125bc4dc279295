//! From a Denavit-Hartenberg table to proved straight-line code.
//!
//! The whole compiler is [`expand`]; the modules, in order, are its stages:
//!
//! ```text
//! tokens ─► decl::grammar ─► Decl ─► chain::check ─► Chain ─► model::derive ─► Arm ─► back::rust ─► text
//!             what was written         what is true     frames, ring, family,    prints, decides nothing
//!                                                       programs, proof
//! ```
//!
//! * [`report`]: what went wrong, where, and the remedy
//! * [`number`]: exact rationals and angles; correctly rounded functions of constants
//! * [`decl`]: one grammar for the macro's tokens and for `.dh` text
//! * [`chain`]: the arm as exact elementary transforms
//! * [`algebra`]: the ring of the proof, the graph of the code
//! * [`truth`]: the plain matrix product, as polynomials
//! * [`plan`]: the cheapest of all equal derivations, for each structure
//! * [`mod@derive`]: from frames to expressions, by a plan where there is one
//! * [`family`]: which arms can be solved, and with what numbers
//! * [`program`], [`signs`], [`names`], [`eval`]: straight-line code, its signs, its names, its meaning
//! * [`model`]: all of it for one arm
//! * [`textbook`]: the formulas that are read, not run: link matrices, ⁰T₆, the factors of det J
//! * [`back`]: Rust, listings, MathML
//!
//! This crate depends on nothing, does no input or output, and never spells a place: it does not know who calls it.

pub mod algebra;
pub mod back;
pub mod chain;
pub mod decl;
pub mod derive;
pub mod eval;
pub mod family;
pub mod model;
pub mod names;
pub mod number;
pub mod plan;
pub mod program;
pub mod quantity;
pub mod report;
pub mod signs;
pub mod textbook;
pub mod truth;

use decl::Token;
use model::{Arm, ParamFacts};
use report::Report;

/// What the macro needs: everything but the struct item itself, as Rust text.
#[derive(Clone, Debug)]
pub struct Expansion {
    /// What is to be said about the declaration.
    pub report: Report,
    /// The derived arm's struct: its name and fields; `None` if nothing could be derived.
    pub shape: Option<Shape>,
    /// The items, with absolute paths under the given crate path; empty if nothing could be derived.
    pub items: String,
}

/// The generated struct.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Its name.
    pub name: String,
    /// Its fields, in order.
    pub params: Vec<ParamFacts>,
}

/// Tokens in, code and report out. `krate` is the path of the runtime, usually `::kin_runtime`.
pub fn expand(tokens: &[Token], krate: &str) -> Expansion {
    let (arm, report) = compile(tokens);
    match arm {
        Some(arm) => Expansion {
            report,
            items: back::rust::items(&arm, krate),
            shape: Some(Shape { name: arm.name, params: arm.params }),
        },
        None => Expansion { report, shape: None, items: String::new() },
    }
}

/// Tokens in, derived arm and report out; there is an arm exactly when the report has no errors.
pub fn compile(tokens: &[Token]) -> (Option<Arm>, Report) {
    let mut report = Report::new();
    let arm = compile_into(tokens, &mut report);
    (arm.filter(|_| !report.has_errors()), report)
}

fn compile_into(tokens: &[Token], report: &mut Report) -> Option<Arm> {
    let decl = decl::grammar::parse(tokens, report)?;
    let chain = chain::check(&decl, report)?;
    if let Some(demanded) = &chain.demanded
        && family::ALL.iter().all(|f| f.name != demanded.value)
    {
        let names: Vec<&str> = family::ALL.iter().map(|f| f.name).collect();
        let message = format!("there is no family `{}`", demanded.value);
        report.error_help(demanded.place, message, format!("the families are {}", names.join(", ")));
        return None;
    }
    match model::derive(&chain) {
        Ok(arm) => {
            if let (model::Solver::None { reason, culprit }, Some(demanded)) = (&arm.solver, &chain.demanded)
            {
                let place = culprit.and_then(|i| chain.elements.get(i)).map_or(demanded.place, |e| e.place);
                report.error(place, format!("this arm is no {}: {reason}", demanded.value));
            }
            Some(arm)
        }
        Err(mismatch) => {
            let help = match mismatch {
                program::Mismatch::TooLarge => {
                    "the proof grows with each joint and each angle that is no quarter turn; its size is bounded so that \
                     compiling ends: declare the arm in two parts, or with fewer odd angles"
                }
                _ => "this is an internal error of kin-gen, not a mistake in the table; please report it",
            };
            report.error_help(chain.place, format!("no proved code for {}: {mismatch}", chain.name), help);
            None
        }
    }
}

/// Text of a `.dh` file in, the checked chain out, or the rendered messages.
pub fn check_text(text: &str) -> Result<chain::Chain, String> {
    let (tokens, places, mut report) = decl::lex::lex(text);
    let chain = decl::grammar::parse(&tokens, &mut report).and_then(|decl| chain::check(&decl, &mut report));
    match chain {
        Some(chain) if !report.has_errors() => Ok(chain),
        _ => Err(decl::render(text, &places, &report)),
    }
}

/// Text of a `.dh` file in, derived arm out, or the rendered messages.
pub fn compile_text(text: &str) -> Result<Arm, String> {
    let (tokens, places, mut report) = decl::lex::lex(text);
    let (arm, more) = compile(&tokens);
    report.absorb(more);
    match arm {
        Some(arm) if !report.has_errors() => Ok(arm),
        _ => Err(decl::render(text, &places, &report)),
    }
}
