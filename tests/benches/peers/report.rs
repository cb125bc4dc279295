//! PERFORMANCE.md: one run as a page.

use crate::batches::LENGTH;
use crate::clock::{self, ROUNDS};
use crate::data::COUNT;
use crate::python::{Beside, Row};
use crate::ways::Way;
use crate::wider::{LEVEL, Wider};
use crate::{TARGETS, Target, WIDER, operations};
use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

/// Ways, and what they took.
#[derive(Clone, Copy)]
pub(crate) struct Timed<'a> {
    pub(crate) ways: &'a [Way],
    pub(crate) times: &'a [f64],
    pub(crate) counts: Option<&'a [f64]>,
}

/// Something that not every machine has, or why it is not there.
type Found<T> = Result<T, Box<dyn Error>>;

/// All of a run.
pub(crate) struct Run<'a> {
    pub(crate) beside: Timed<'a>,
    pub(crate) growth: Timed<'a>,
    pub(crate) python: &'a Found<Beside>,
    /// None if nobody asked for it.
    pub(crate) wider: Option<&'a Found<Wider>>,
}

/// Writes the page.
pub(crate) fn write(run: &Run<'_>) -> ExitCode {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../PERFORMANCE.md");
    match std::fs::write(&path, page(run)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", path.display());
            ExitCode::FAILURE
        }
    }
}

fn page(run: &Run<'_>) -> String {
    let mut text = format!(
        "# What it costs, beside others\n\n\
         Written by `cargo bench -p tests --bench peers -- --report`: one run on one machine, default release build, ABB IRB \
         2400, {COUNT} distinct random configurations, all ways in turn, medians of {ROUNDS} rounds. Ratios say more than \
         nanoseconds. Instructions are those of the same binary under callgrind; they do not depend on the machine's mood, \
         and their ratios are what CI holds (`-- --gate`).\n\n\
         nalgebra is built with libm, whose sines are faster here than std's. rs-opw-kinematics checks its inverse by \
         forward kinematics, as this library does; its Jacobian is a difference quotient. \"Each waiting for the last\" \
         is latency: every call takes an addition of what the one before gave, times nothing. A single inverse takes AVX2 where \
         the machine has it, whatever the program is built for. Batches are of {LENGTH} \
         configurations on one core into places that stay in the cache, by the instructions that they may use at most, poses \
         and Jacobians in stretches of thousands; what slices cost that no cache holds stands below. callgrind knows no \
         AVX-512.\n\n"
    );
    tables(&mut text, &run.beside);
    let wider = run.wider.and_then(|found| found.as_ref().ok()).map(|wider| Timed {
        ways: &run.beside.ways[..wider.times.len()],
        times: &wider.times,
        counts: wider.counts.as_deref(),
    });
    text.push_str("## What is asked for\n\n| | | peer | asked | found | |\n|---|---|---|---|---|---|\n");
    targets(&mut text, &TARGETS, "", Some(&run.beside));
    targets(&mut text, &WIDER, &format!(", both built for {LEVEL}"), wider.as_ref());
    let _ = write!(text, "\n## Both built for {LEVEL}\n\n");
    match (run.wider, &wider) {
        (_, Some(timed)) => {
            let _ = write!(
                text,
                "Single calls use no instructions but those that the program is built for, except `ik`, which asks for AVX2. \
                 The same ways, all of them built with `-C target-cpu={LEVEL}`, in a run of their own (`-- --report --v3`).\n\n"
            );
            tables(&mut text, timed);
        }
        (Some(Err(error)), _) => {
            let _ = write!(text, "Not in this run: {error}.\n\n");
        }
        _ => text.push_str("Not in this run, which was made without `--v3`.\n\n"),
    }
    text.push_str("## Beside libraries of Python\n\n");
    python(&mut text, run.python);
    text.push_str(
        "## How cost grows\n\nEach group beside its own first line; of one arm where no joints are told. Angles beyond 25,000 rad, \
         some 4,000 turns, take a slow way: quarter turns are taken off in integers, with as many bits of 2/π as it takes.\n\n",
    );
    tables(&mut text, &run.growth);
    text.push_str("## Operations\n\n");
    text.push_str(&operations::table());
    text
}

/// Lines of what is asked for and what is found.
fn targets(text: &mut String, targets: &[Target], built: &str, timed: Option<&Timed<'_>>) {
    for target in targets {
        let Target { group, ours, peer, asked } = target;
        let found = timed.map(|timed| clock::ratio(timed.ways, timed.times, target));
        let (found, verdict) = match found {
            Some(Some(found)) => (format!("{found:.1} ×"), if found >= *asked { "met" } else { "missed" }),
            Some(None) => (String::new(), "not on this machine"),
            None => (String::new(), "not in this run"),
        };
        let _ = writeln!(text, "| {group}{built} | {ours} | {peer} | {asked} × | {found} | {verdict} |");
    }
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

/// A table for each group that a library of Python has.
fn python(text: &mut String, found: &Found<Beside>) {
    text.push_str(
        "Pinocchio, EAIK and ssik, from PyPI, in turn with this library, which is called from Rust; the same configurations and \
         poses. What Python's call costs is most of what some of them take, and no fault of theirs: beside the time of a call \
         stands what is left of it without the time of a call through the same binding that does next to nothing. Where that \
         is the same call for an arm of one joint, the work of that joint is taken off too. Poses and Jacobians are required to \
         agree with this library's to 1e-12 in every entry, of all configurations; of inverses it is told how many of this \
         library's solutions are found, and the residual by a plain product of matrices. To install them: `python3 -m venv \
         peers && peers/bin/pip install pin eaik ssik`, then `-- --report --python peers/bin/python`.\n\n",
    );
    let beside = match found {
        Ok(beside) => beside,
        Err(error) => {
            let _ = write!(text, "Not installed where this run was made: {error}.\n\n");
            return;
        }
    };
    for (group, ours) in &beside.ours {
        let _ = writeln!(
            text,
            "| {group}, from Python {} | call, ns | × | taken off, ns | left, ns | × | taken off | answers |\n\
             |---|---|---|---|---|---|---|---|\n\
             | this library, from Rust | {ours:.0} | 1.0 | – | {ours:.0} | 1.0 | – | – |",
            beside.python
        );
        for Row { library, called, empty } in beside.rows.iter().filter(|row| row.library.group == *group) {
            let left = called - empty;
            let _ = writeln!(
                text,
                "| {} | {called:.0} | {:.1} | {empty:.0} | {left:.0} | {:.1} | {} | {} |",
                library.name,
                called / ours,
                left / ours,
                library.taken_off,
                library.agreement
            );
        }
        text.push('\n');
    }
    for missing in &beside.missing {
        let _ = write!(text, "{missing}.\n\n");
    }
}
