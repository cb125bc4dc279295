//! Every message about a declaration: what is wrong, under which part of the text, and the remedy.
//!
//! A line of what is expected reads `line:column severity [underlined] message`, followed by its remedy.

mod form;
mod names;
mod statements;
mod table;
mod values;

use kin_gen::chain;
use kin_gen::decl::{lex, parse};
use kin_gen::report::{At, Severity};

/// All messages about `text` (its first line break belongs to the test, not to the text) are `expected`.
#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said(text.trim_start_matches('\n')), expected.trim_matches('\n'));
}

fn said(text: &str) -> String {
    let (tokens, ranges, mut report) = lex(text);
    let decl = parse(&tokens, &mut report);
    let chain = decl.and_then(|decl| chain::check(&decl, &mut report));
    assert_eq!(chain.is_none(), report.has_errors(), "there is a chain exactly where there is no error");
    let lines = report.diagnostics().into_iter().map(|d| {
        let place = |at: At| ranges.get(at.0 as usize).cloned().unwrap_or(text.len()..text.len());
        let (start, end) = (place(d.place.first).start, place(d.place.last).end);
        let before = &text[..start];
        let (line, column) =
            (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
        let severity = if d.severity == Severity::Error { "error" } else { "warning" };
        let underlined = text[start..end].split_whitespace().collect::<Vec<_>>().join(" ");
        let help = d.help.as_ref().map_or(String::new(), |help| format!("\n    {help}"));
        format!("{line}:{column} {severity} [{underlined}] {}{help}", d.message)
    });
    lines.collect::<Vec<_>>().join("\n")
}
