//! What is asked of the bench on its command line.

use std::path::PathBuf;

pub(crate) const HELP: &str = "\
Forward kinematics, Jacobian and inverse of the IRB 2400 beside those of others, in one run.

    cargo bench -p tests --bench peers -- [OPTIONS]

    --report           write the run to PERFORMANCE.md, and leave criterion out; some minutes
    --python PATH      with --report: the interpreter whose Pinocchio, EAIK and ssik are timed as well
                       [the variable PYTHON, else python3]
    --v3               with --report: build this bench once more for x86-64-v3, and time that too
    --gate             count instructions under valgrind only, and fail where a ratio to a peer has sunk
    --help             this text

Without --report or --gate criterion follows, and has the options that it always has. The libraries of Python:

    python3 -m venv peers && peers/bin/pip install pin eaik ssik
    cargo bench -p tests --bench peers -- --report --v3 --python peers/bin/python";

/// What to do.
pub(crate) enum Task {
    Help,
    /// One way over so many elements, under valgrind.
    Count {
        group: String,
        name: String,
        elements: String,
    },
    Gate,
    /// The rows of single calls, as JSON.
    Rows,
    Report {
        python: PathBuf,
        v3: bool,
    },
    /// The run by the clock, then criterion with its own options.
    Criterion,
}

/// Reads the command line.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn task(mut given: impl Iterator<Item = String>) -> Result<Task, String> {
    let python = std::env::var_os("PYTHON").filter(|python| !python.is_empty());
    let mut python = python.map_or_else(|| PathBuf::from("python3"), PathBuf::from);
    let (mut report, mut v3, mut chosen) = (false, false, None);
    while let Some(option) = given.next() {
        let mut value = || given.next().ok_or(format!("{option} needs a value"));
        match option.as_str() {
            "--help" | "-h" => return Ok(Task::Help),
            "--gate" => return Ok(Task::Gate),
            "--rows" => return Ok(Task::Rows),
            "--count" => return Ok(Task::Count { group: value()?, name: value()?, elements: value()? }),
            "--report" => report = true,
            "--v3" => (v3, chosen) = (true, Some(option)),
            "--python" => (python, chosen) = (value()?.into(), Some(option)),
            // Cargo's own, and criterion's.
            _ => {}
        }
    }
    match chosen {
        _ if report => Ok(Task::Report { python, v3 }),
        Some(option) => Err(format!("{option} is for --report; --help lists what there is")),
        None => Ok(Task::Criterion),
    }
}
