//! From what is written to what is true.
//!
//! ```text
//! Decl ─ names ─► Scope          every `let` and `param` has a typed, exact value
//!      ─ rows / factors ─►       every cell is an elementary transform; zeros are gone; lengths are atoms
//!      ─ couple ─►               integer matrices, inverse to each other
//!      ─ golden ─► Chain         every `check` holds
//! ```

use super::couple::couple;
use super::lengths::Lengths;
use super::names::{Scope, name_is_free};
use super::rows::{Parts, Rows, assemble};
use super::{Chain, Element, Form, Joint, factors, golden};
use crate::decl::Decl;
use crate::report::Report;

/// The most joints: a longer arm is a list of arms.
const MAX_JOINTS: usize = 16;

/// The arm itself, read in order: elements, joints, frames, and a table's rows for reading them otherwise.
#[derive(Default)]
struct Body {
    elements: Vec<Element>,
    joints: Vec<Joint>,
    frames: Vec<usize>,
    rows: Vec<Parts>,
}

/// Checks a declaration. There is a chain only if `report`, which also holds what the parser said, has no errors.
pub fn check(decl: &Decl, report: &mut Report) -> Option<Chain> {
    name_is_free(&decl.name.value, decl.name.place, report);
    let mut scope = Scope::new(decl, report);
    let mut lengths = Lengths::default();
    let form = decl.form.unwrap_or(Form::Modified);
    let base = factors::fixed(&decl.base, "base", &mut scope, &mut lengths, report);
    let body = body(decl, form, &mut scope, &mut lengths, report);
    let tool = factors::fixed(&decl.tool, "tool", &mut scope, &mut lengths, report);
    count_joints(decl, &body.joints, report);
    let (forth, back) =
        if decl.whole { couple(&decl.couples, &body.joints, report) } else { Default::default() };
    let params = scope.finished_params(report);
    if report.has_errors() {
        return None;
    }
    let chain = Chain {
        name: decl.name.value.clone(),
        form,
        length_unit: scope.length_unit,
        angle_unit: scope.angle_unit,
        lengths: lengths.list,
        params,
        joints: body.joints,
        base,
        elements: body.elements,
        frames: body.frames,
        tool,
        couple: forth,
        uncouple: back,
        demanded: decl.demanded.clone(),
        text: decl.to_string(),
        place: decl.name.place,
    };
    golden::golden(&chain, &body.rows, &decl.checks, &mut scope, report);
    scope.unused(report);
    (!report.has_errors()).then_some(chain)
}

/// The table or the factors, whichever the header promises.
fn body(decl: &Decl, form: Form, scope: &mut Scope<'_>, lengths: &mut Lengths, report: &mut Report) -> Body {
    let mut body = Body::default();
    if let (Some(table), Some(factor)) = (&decl.table, decl.factors.first()) {
        let place = if decl.form == Some(Form::Chain) { table.place } else { factor.place };
        let help = "fixed transforms before the first row go to `base:`, those after the last to `tool:`";
        report.error_help(place, "an arm is written as a table or as factors, not as both", help);
    } else if let (Some(Form::Chain), Some(table)) = (decl.form, &decl.table) {
        let help = "write `standard` or `modified` instead of `chain` in the header";
        report.error_help(table.place, "a table needs a convention", help);
    } else if let (Some(Form::Standard | Form::Modified), Some(factor)) = (decl.form, decl.factors.first()) {
        let help = format!("write `chain` instead of `{}` in the header", form.word());
        report.error_help(factor.place, "factors are the chain form, but the header promises a table", help);
    }
    if let Some(table) = &decl.table {
        let mut rows = Rows { table, form, scope, lengths, joints: Vec::new(), parts: Vec::new() };
        rows.read(report);
        let (joints, parts) = (rows.joints, rows.parts);
        let (elements, frames) = assemble(&parts, form);
        body = Body { elements, joints, frames, rows: parts };
    } else if !decl.factors.is_empty() {
        let (elements, joints, frames) = factors::chain(&decl.factors, scope, lengths, report);
        body = Body { elements, joints, frames, rows: Vec::new() };
    }
    body
}

fn count_joints(decl: &Decl, joints: &[Joint], report: &mut Report) {
    if joints.is_empty() && decl.whole && !report.has_errors() {
        let help = if decl.form == Some(Form::Chain) {
            "write factors with q, such as `Rz(q) Tx(0.3)`"
        } else {
            "write a table with q in theta (revolute) or d (prismatic)"
        };
        report.error_help(decl.name.place, format!("`{}` has no joints", decl.name.value), help);
    }
    if let Some(extra) = joints.get(MAX_JOINTS) {
        let message = format!("this is joint {} of at most {MAX_JOINTS}", MAX_JOINTS + 1);
        report.error_help(extra.place, message, "declare two arms and multiply their poses");
    }
}
