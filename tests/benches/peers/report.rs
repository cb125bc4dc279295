//! PERFORMANCE.md: one run as a page.

use crate::clock::{self, ROUNDS};
use crate::data::COUNT;
use crate::ways::Way;
use crate::{TARGETS, Target};
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

/// Writes the page.
pub(crate) fn write(ways: &[Way], times: &[f64], counts: Option<&[f64]>) -> ExitCode {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../PERFORMANCE.md");
    match std::fs::write(&path, page(ways, times, counts)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", path.display());
            ExitCode::FAILURE
        }
    }
}

fn page(ways: &[Way], times: &[f64], counts: Option<&[f64]>) -> String {
    let mut text = format!(
        "# What it costs, beside others\n\n\
         Written by `cargo bench -p tests --bench peers -- --report`: one run on one machine, default release build, ABB IRB \
         2400, {COUNT} distinct random configurations, all ways in turn, medians of {ROUNDS} rounds. Ratios say more than \
         nanoseconds. Instructions are those of the same binary under callgrind; they do not depend on the machine's mood, \
         and their ratios are what CI holds (`-- --gate`).\n\n\
         nalgebra is built with libm, whose sines are faster here than std's. rs-opw-kinematics checks its inverse by \
         forward kinematics, as this library does; its Jacobian is a difference quotient. \"Each waiting for the last\" \
         is latency: every call takes an addition of what the one before gave, times nothing.\n\n"
    );
    for (index, row) in clock::rows(ways, times, counts).into_iter().enumerate() {
        let clock::Row { way, opens, time, count, slower, more } = row;
        let (group, name) = (way.group, way.name);
        if opens {
            let _ = writeln!(text, "| {group} | ns | × | instructions | × |\n|---|---|---|---|---|");
        }
        let counted = if count.is_nan() { "– | –".to_owned() } else { format!("{count:.0} | {more:.1}") };
        let _ = writeln!(text, "| {name} | {time:.0} | {slower:.1} | {counted} |");
        if ways.get(index + 1).is_none_or(|next| next.group != group) {
            text.push('\n');
        }
    }
    text.push_str("## What is asked for\n\n| | | peer | asked | found | |\n|---|---|---|---|---|---|\n");
    for target in &TARGETS {
        let Target { group, ours, peer, asked } = target;
        let (found, verdict) = match clock::ratio(ways, times, target) {
            Some(found) => (format!("{found:.1} ×"), if found >= *asked { "met" } else { "missed" }),
            None => (String::new(), "not on this machine"),
        };
        let _ = writeln!(text, "| {group} | {ours} | {peer} | {asked} × | {found} | {verdict} |");
    }
    text
}
