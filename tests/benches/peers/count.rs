//! Instructions, as valgrind's callgrind counts them: a number that does not depend on the machine's mood.
//!
//! This program runs itself under valgrind with so many elements and with twice as many; the difference is theirs alone.

use crate::data::COUNT;
use crate::ways::Way;
use std::process::{Command, ExitCode};

/// Elements of the shorter run.
const ELEMENTS: usize = 500;

/// At the least so many times as many instructions as this library: a tenth below what was counted when this was set.
const FLOORS: [(&str, &str, f64); 5] = [
    ("fk", "nalgebra, isometries", 3.3),
    ("fk", "rs-opw-kinematics", 2.9),
    ("fk and jacobian", "k", 13.5),
    ("fk and jacobian", "rs-opw-kinematics", 18.5),
    ("ik", "rs-opw-kinematics", 2.3),
];

/// What the run under valgrind does.
pub(crate) fn run(ways: &mut [Way], group: &str, name: &str, elements: &str) -> ExitCode {
    let way = ways.iter_mut().find(|way| way.group == group && way.name == name);
    let (Some(way), Ok(elements)) = (way, elements.parse::<usize>()) else { return ExitCode::FAILURE };
    (way.run)(0..elements.min(COUNT));
    ExitCode::SUCCESS
}

/// Instructions of one element, for each way; none without valgrind.
pub(crate) fn all(ways: &[Way]) -> Option<Vec<f64>> {
    ways.iter().map(one).collect()
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
        .ok()?;
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
    for (group, peer, floor) in FLOORS {
        let (Some(ours), Some(theirs)) = (count(group, "this library"), count(group, peer)) else {
            eprintln!("instructions were not counted: valgrind is needed");
            return ExitCode::FAILURE;
        };
        let ratio = theirs / ours;
        let verdict = if ratio >= floor { "" } else { "  LESS" };
        held &= ratio >= floor;
        println!(
            "{group}: {ours:.0} instructions, {peer} {ratio:.2} times as many, at least {floor}{verdict}"
        );
    }
    if held { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
