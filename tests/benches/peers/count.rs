//! Instructions, as valgrind's callgrind counts them: a number that does not depend on the machine's mood.
//!
//! This program runs itself under valgrind with so many elements and with twice as many; the difference is theirs alone.

use crate::data::COUNT;
use crate::ways::Way;
use crate::{Target, target};
use std::process::{Command, ExitCode};

/// Elements of the shorter run.
const ELEMENTS: usize = 500;

/// At the least so many times as many instructions as this library: a tenth below what was counted when this was set.
const FLOORS: [Target; 7] = [
    target("fk", "this library", "nalgebra, isometries", 3.3),
    target("fk", "this library", "rs-opw-kinematics", 2.9),
    target("fk and jacobian", "this library", "k", 15.0),
    target("fk and jacobian", "this library", "rs-opw-kinematics", 20.7),
    target("ik", "this library", "rs-opw-kinematics", 13.8),
    target("fk, batch", "this library, AVX2", "nalgebra, isometries", 6.1),
    target("ik, batch", "this library, AVX2", "rs-opw-kinematics", 16.0),
];

/// What the run under valgrind does.
pub(crate) fn run(ways: &mut [Way], group: &str, name: &str, elements: &str) -> ExitCode {
    let way = ways.iter_mut().find(|way| way.group == group && way.name == name);
    let (Some(way), Ok(elements)) = (way, elements.parse::<usize>()) else { return ExitCode::FAILURE };
    (way.run)(0..elements.min(COUNT));
    ExitCode::SUCCESS
}

/// Instructions of one element, for each way; NaN where valgrind does not know them, none without valgrind.
pub(crate) fn all(ways: &[Way]) -> Option<Vec<f64>> {
    let counts: Vec<f64> = ways.iter().map(|way| one(way).unwrap_or(f64::NAN)).collect();
    counts.iter().any(|count| !count.is_nan()).then_some(counts)
}

fn one(way: &Way) -> Option<f64> {
    let [once, twice] = [ELEMENTS, 2 * ELEMENTS].map(|elements| under_valgrind(way, elements));
    Some((twice? as f64 - once? as f64) / ELEMENTS as f64)
}

fn under_valgrind(way: &Way, elements: usize) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().ok()?)
        .args(["--count", way.group, way.name, &elements.to_string()])
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find_map(|line| line.split_once("Collected : "))?;
    line.1.trim().parse().ok()
}

/// Whether every ratio to a peer is still what it was.
pub(crate) fn gate(ways: &[Way]) -> ExitCode {
    let count = |group: &str, name: &str| {
        ways.iter().find(|way| way.group == group && way.name == name).and_then(one)
    };
    let mut held = true;
    for Target { group, ours, peer, asked } in FLOORS {
        let (Some(few), Some(many)) = (count(group, ours), count(group, peer)) else {
            eprintln!(
                "{group}, {ours}: instructions were not counted: valgrind is needed, and a machine that has them"
            );
            return ExitCode::FAILURE;
        };
        let ratio = many / few;
        let verdict = if ratio >= asked { "" } else { "  LESS" };
        held &= ratio >= asked;
        println!(
            "{group}: {ours} {few:.0} instructions, {peer} {ratio:.2} times as many, at least {asked}{verdict}"
        );
    }
    if held { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
