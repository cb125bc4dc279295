//! Messages about `.dh` text, with the line they are about and the underlined part.

use crate::report::{At, Diagnostic, Report, Severity};
use std::fmt::Write;
use std::ops::Range;

/// All messages, in source order; `ranges` is the table of places that [`lex`](super::lex()) returned for `text`.
pub fn render(text: &str, ranges: &[Range<usize>], report: &Report) -> String {
    report.diagnostics().iter().map(|d| one(text, ranges, d)).collect::<Vec<_>>().join("\n")
}

fn one(text: &str, ranges: &[Range<usize>], diagnostic: &Diagnostic) -> String {
    let byte = |at: At| {
        usize::try_from(at.0).ok().and_then(|i| ranges.get(i)).cloned().unwrap_or(text.len()..text.len())
    };
    let start = byte(diagnostic.place.first).start.min(text.len());
    let end = byte(diagnostic.place.last).end.clamp(start, text.len());
    let before = text.get(..start).unwrap_or("");
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    let line_end = text.get(start..).and_then(|rest| rest.find('\n')).map_or(text.len(), |i| start + i);
    let number = before.matches('\n').count() + 1;
    let chars = |from: usize, to: usize| text.get(from..to).map_or(0, |s| s.chars().count());
    let column = chars(line_start, start) + 1;
    let carets = chars(start, end.min(line_end)).max(1);
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let margin = " ".repeat(number.to_string().len());
    let line = text.get(line_start..line_end).unwrap_or("").trim_end().replace('\t', " ");
    let mut out = String::new();
    // Writing to a String cannot fail.
    let _ = writeln!(out, "{severity}: {}", diagnostic.message);
    let _ = writeln!(out, "{margin}--> {number}:{column}");
    let _ = writeln!(out, "{number} | {line}");
    let _ = writeln!(out, "{margin} | {}{}", " ".repeat(column - 1), "^".repeat(carets));
    if let Some(help) = &diagnostic.help {
        let _ = writeln!(out, "{margin} = help: {help}");
    }
    out
}
