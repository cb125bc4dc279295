//! Libraries of Python beside this one, in the same run: `python.py` has them and is told, stretch by stretch, what to time.
//!
//! A call from Python costs more than most of what is called. Of each library two numbers are told: what a call takes, and
//! what is left without the time of a call through the same binding that does next to nothing.

use crate::clock::{self, STRETCH, Turn};
use crate::data::Data;
use crate::ways::Way;
use kin_runtime::prelude::*;
use robots::Irb2400;
use serde::Deserialize;
use std::cell::RefCell;
use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// What there is to time, as `python.py` says it.
#[derive(Deserialize)]
pub(crate) struct Library {
    pub(crate) group: String,
    pub(crate) name: String,
    /// What the call does whose time is taken off.
    pub(crate) taken_off: String,
    /// How its answers agree with ours.
    pub(crate) agreement: String,
}

#[derive(Deserialize)]
struct Hello {
    python: String,
    ways: Vec<Library>,
    missing: Vec<String>,
}

/// One line of a table.
pub(crate) struct Row {
    pub(crate) library: Library,
    /// Nanoseconds of a call.
    pub(crate) called: f64,
    /// Nanoseconds of a call that does next to nothing.
    pub(crate) empty: f64,
}

/// What a run has found.
pub(crate) struct Beside {
    /// The version of Python.
    pub(crate) python: String,
    /// Group, and nanoseconds of this library in the same rounds.
    pub(crate) ours: Vec<(&'static str, f64)>,
    pub(crate) rows: Vec<Row>,
    /// What is not installed, or did not agree.
    pub(crate) missing: Vec<String>,
}

/// Times what an interpreter has, in turn with this library.
///
/// # Errors
/// Where the interpreter does not start, or stops.
pub(crate) fn beside(interpreter: &Path, ways: &mut [Way], data: &Data) -> Result<Beside, Box<dyn Error>> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("configurations.f64");
    std::fs::write(&file, records(data)?)?;
    let (server, Hello { python, ways: libraries, missing }) = Server::start(interpreter, &file)?;
    let server = &RefCell::new(server);
    let asked = |way: &&mut Way| {
        way.name == "this library" && libraries.iter().any(|library| library.group == way.group)
    };
    let ours: Vec<&mut Way> = ways.iter_mut().filter(asked).collect();
    let groups: Vec<&'static str> = ours.iter().map(|way| way.group).collect();
    let mut turns: Vec<Turn<'_>> = ours.into_iter().map(Turn::from).collect();
    for index in 0..libraries.len() {
        for call in ["call", "empty"] {
            turns.push(Turn {
                stretch: STRETCH,
                time: Box::new(move |which| server.borrow_mut().time(index, call, which.start, which.len())),
            });
        }
    }
    let times = clock::in_turn(turns);
    if times.iter().any(|time| time.is_nan()) {
        return Err("the interpreter stopped".into());
    }
    let (own, theirs) = times.split_at(groups.len());
    let (pairs, _) = theirs.as_chunks::<2>();
    let rows = libraries.into_iter().zip(pairs);
    Ok(Beside {
        python,
        ours: groups.into_iter().zip(own.iter().copied()).collect(),
        rows: rows.map(|(library, &[called, empty])| Row { library, called, empty }).collect(),
        missing,
    })
}

/// What `python.py` reads: of each configuration six angles, pose and Jacobian row by row, how many inverse solutions there
/// are, and room for eight of them.
fn records(data: &Data) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut bytes = Vec::new();
    for (q, pose) in data.joints.iter().zip(&data.poses) {
        let (matrix, jacobian) = (pose.to_homogeneous(), Irb2400.jacobian(q));
        let solutions = Irb2400.ik(pose);
        let mut numbers: Vec<f64> = q.iter().copied().collect();
        numbers.extend(matrix.transpose().iter());
        numbers.extend(jacobian.transpose().iter());
        numbers.push(solutions.len() as f64);
        let solved = solutions.iter().flat_map(|solution| solution.q.iter().copied().collect::<Vec<f64>>());
        numbers.extend(solved.chain(std::iter::repeat(0.0)).take(8 * 6));
        numbers.iter().try_for_each(|number| bytes.write_all(&number.to_le_bytes()))?;
    }
    Ok(bytes)
}

/// `python.py`, running.
struct Server {
    child: Child,
    requests: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Server {
    fn start(interpreter: &Path, file: &Path) -> Result<(Server, Hello), Box<dyn Error>> {
        let mut child = Command::new(interpreter)
            .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/python.py"))
            .arg(file)
            .env("OMP_NUM_THREADS", "1")
            .env("OPENBLAS_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: {error}", interpreter.display()))?;
        let (requests, answers) = (child.stdin.take(), child.stdout.take().ok_or("no output")?);
        let mut server = Server { child, requests, answers: BufReader::new(answers) };
        let mut hello = String::new();
        server.answers.read_line(&mut hello)?;
        let hello = serde_json::from_str(&hello).map_err(|error| format!("python.py: {error}"))?;
        Ok((server, hello))
    }

    /// Nanoseconds of a stretch; NaN once the interpreter has stopped.
    fn time(&mut self, way: usize, call: &str, start: usize, length: usize) -> f64 {
        let mut ask = || {
            writeln!(self.requests.as_mut()?, "{way} {call} {start} {length}").ok()?;
            let mut line = String::new();
            self.answers.read_line(&mut line).ok()?;
            line.trim().parse().ok()
        };
        ask().unwrap_or(f64::NAN)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It ends where its requests do.
        drop(self.requests.take());
        let _ = self.child.wait();
    }
}
