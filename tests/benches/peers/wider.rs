//! The same when all is built for x86-64-v3, instructions that batches find for themselves but single calls do not: this program
//! builds and runs itself once more.

use crate::clock;
use crate::count;
use crate::data::Data;
use crate::ways::{self, Way};
use kin_runtime::batch::Instructions;
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::rc::Rc;

/// The instructions, as rustc names them.
pub(crate) const LEVEL: &str = "x86-64-v3";

/// What a way took there.
#[derive(Deserialize, Serialize)]
struct Row {
    group: String,
    name: String,
    time: f64,
    instructions: Option<f64>,
}

/// Times and instructions of the first ways, those of single calls.
pub(crate) struct Wider {
    pub(crate) times: Vec<f64>,
    pub(crate) counts: Option<Vec<f64>>,
}

/// What the second build does: its rows as JSON.
pub(crate) fn tell() -> ExitCode {
    let mut ways = ways::single(&Rc::new(Data::new()));
    let times = clock::medians(&mut ways);
    let counts = count::all(&ways);
    let row = |(index, (way, time)): (usize, (&Way, &f64))| Row {
        group: way.group.to_owned(),
        name: way.name.to_owned(),
        time: *time,
        instructions: counts.as_ref().map(|counts| counts[index]).filter(|count| !count.is_nan()),
    };
    let rows: Vec<Row> = ways.iter().zip(&times).enumerate().map(row).collect();
    match serde_json::to_string(&rows) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Builds and runs this program for the instructions, beside its own build.
///
/// # Errors
/// Where the machine does not have them, or the build fails.
pub(crate) fn measure(ways: &[Way]) -> Result<Wider, Box<dyn Error>> {
    if !Instructions::Avx2.are_here() {
        return Err("this machine does not have these instructions".into());
    }
    let executable = std::env::current_exe()?;
    let target = executable.ancestors().nth(3).ok_or("this program does not stand in a target folder")?;
    let output =
        Command::new(std::env::var_os("CARGO").map_or_else(|| PathBuf::from("cargo"), PathBuf::from))
            .args(["bench", "--locked", "-p", "tests", "--bench", "peers", "--target-dir"])
            .arg(target.join(LEVEL))
            .args(["--", "--rows"])
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env("RUSTFLAGS", format!("-C target-cpu={LEVEL}"))
            .stderr(Stdio::inherit())
            .output()?;
    if !output.status.success() {
        return Err("the build for these instructions failed".into());
    }
    let rows: Vec<Row> = serde_json::from_slice(&output.stdout)?;
    let same = |(row, way): (&Row, &Way)| row.group == way.group && row.name == way.name;
    if !rows.iter().zip(ways).all(same) {
        return Err("the second build has other ways".into());
    }
    let counts: Vec<f64> = rows.iter().map(|row| row.instructions.unwrap_or(f64::NAN)).collect();
    let counted = counts.iter().any(|count| !count.is_nan());
    Ok(Wider { times: rows.iter().map(|row| row.time).collect(), counts: counted.then_some(counts) })
}
