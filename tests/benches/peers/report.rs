//! PERFORMANCE.md: one run as a page.

use crate::batches::LENGTH;
use crate::clock::{self, ROUNDS};
use crate::data::COUNT;
use crate::ways::Way;
use crate::{TARGETS, Target, operations};
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

/// Ways, and what they took.
pub(crate) struct Timed<'a> {
    pub(crate) ways: &'a [Way],
    pub(crate) times: &'a [f64],
    pub(crate) counts: Option<&'a [f64]>,
}

/// Writes the page.
pub(crate) fn write(beside: &Timed<'_>, growth: &Timed<'_>) -> ExitCode {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../PERFORMANCE.md");
    match std::fs::write(&path, page(beside, growth)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", path.display());
            ExitCode::FAILURE
        }
    }
}

fn page(beside: &Timed<'_>, growth: &Timed<'_>) -> String {
    let mut text = format!(
        "# What it costs, beside others\n\n\
         Written by `cargo bench -p tests --bench peers -- --report`: one run on one machine, default release build, ABB IRB \
         2400, {COUNT} distinct random configurations, all ways in turn, medians of {ROUNDS} rounds. Ratios say more than \
         nanoseconds. Instructions are those of the same binary under callgrind; they do not depend on the machine's mood, \
         and their ratios are what CI holds (`-- --gate`).\n\n\
         nalgebra is built with libm, whose sines are faster here than std's. rs-opw-kinematics checks its inverse by \
         forward kinematics, as this library does; its Jacobian is a difference quotient. \"Each waiting for the last\" \
         is latency: every call takes an addition of what the one before gave, times nothing. Batches are of {LENGTH} \
         configurations on one core into places that stay in the cache, by the instructions that they may use at most, poses \
         and Jacobians in stretches of thousands; what slices cost that no cache holds stands below. callgrind knows no \
         AVX-512.\n\n"
    );
    tables(&mut text, beside);
    text.push_str("## What is asked for\n\n| | | peer | asked | found | |\n|---|---|---|---|---|---|\n");
    for target in &TARGETS {
        let Target { group, ours, peer, asked } = target;
        let (found, verdict) = match clock::ratio(beside.ways, beside.times, target) {
            Some(found) => (format!("{found:.1} ×"), if found >= *asked { "met" } else { "missed" }),
            None => (String::new(), "not on this machine"),
        };
        let _ = writeln!(text, "| {group} | {ours} | {peer} | {asked} × | {found} | {verdict} |");
    }
    text.push_str("\n## How cost grows\n\nEach group beside its own first line; of one arm where no joints are told.\n\n");
    tables(&mut text, growth);
    text.push_str("## Operations\n\n");
    text.push_str(&operations::table());
    text
}

/// A table for each group.
fn tables(text: &mut String, Timed { ways, times, counts }: &Timed<'_>) {
    let (titles, rules) = if counts.is_some() { (" instructions | × |", "---|---|") } else { ("", "") };
    for (index, row) in clock::rows(ways, times, *counts).into_iter().enumerate() {
        let clock::Row { way, opens, time, count, slower, more } = row;
        let (group, name) = (way.group, way.name);
        if opens {
            let _ = writeln!(text, "| {group} | ns | × |{titles}\n|---|---|---|{rules}");
        }
        let counted = match counts {
            Some(_) if count.is_nan() => " – | – |".to_owned(),
            Some(_) => format!(" {count:.0} | {more:.1} |"),
            None => String::new(),
        };
        let _ = writeln!(text, "| {name} | {time:.0} | {slower:.1} |{counted}");
        if ways.get(index + 1).is_none_or(|next| next.group != group) {
            text.push('\n');
        }
    }
}
