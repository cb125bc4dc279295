//! `cargo run --release -p tests --bin reliability -- --poses 1e6 --seed 1`: millions of tries where solvers fail.
//!
//! Exit code 1 if a promised figure is missed, 2 if the program could not do what it was asked. Without `--no-report` it
//! writes RELIABILITY.md at the root of the workspace.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use tests::reliability::parts::parts;
use tests::reliability::report;
use tests::reliability::run::{Order, run};
use tests::reliability::tally::{Fault, Tally};

const HELP: &str = "\
Round trips through every structural family, most of them aimed at singular sets, and random bit patterns.

    cargo run --release -p tests --bin reliability -- [OPTIONS]

    --poses N         round trips of doubles for each of the 13 families, a tenth of that in single precision [1e6];
                      1e6 of each, 14.3 million in all, take a little over a minute on two cores
    --patterns N      random bit patterns, in all [ten times the poses]
    --seed N          where the random numbers start [1]
    --threads N       how many threads; the result does not depend on it [all]
    --resume FILE     keep what is done in FILE, and go on from there if it exists; a run that is
                      done goes on to more poses or patterns
    --report FILE     where to write the report [RELIABILITY.md of the workspace]
    --no-report       write none
    --again PART:N    run one try alone (as RELIABILITY.md names it) and print what was counted
    --help            this text

Numbers may be written as 1e8. Exit code 1: a figure was missed; 2: the order was not understood or a file failed.";

struct Arguments {
    order: Order,
    report: Option<PathBuf>,
    again: Option<String>,
}

fn number(text: &str) -> Result<u64, String> {
    let exponent = || {
        text.split_once('e').and_then(|(digits, power)| {
            let ten = 10_u64.checked_pow(power.parse().ok()?)?;
            digits.parse::<u64>().ok()?.checked_mul(ten)
        })
    };
    text.parse().ok().or_else(exponent).ok_or_else(|| format!("`{text}` is not a whole number"))
}

/// Nothing if only the help was asked for.
fn arguments() -> Result<Option<Arguments>, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let threads = thread::available_parallelism().map_or(1, Into::into);
    let mut order = Order { poses: 1_000_000, patterns: 0, seed: 1, threads, resume: None };
    let (mut patterns, mut report, mut again) = (None, Some(root.join("RELIABILITY.md")), None);
    let mut given = std::env::args().skip(1);
    while let Some(option) = given.next() {
        let mut value = || given.next().ok_or_else(|| format!("{option} needs a value"));
        match option.as_str() {
            "--help" | "-h" => return Ok(None),
            "--no-report" => report = None,
            "--poses" => order.poses = number(&value()?)?,
            "--patterns" => patterns = Some(number(&value()?)?),
            "--seed" => order.seed = number(&value()?)?,
            "--threads" => order.threads = number(&value()?)?.clamp(1, 1024) as usize,
            "--resume" => order.resume = Some(value()?.into()),
            "--report" => report = Some(value()?.into()),
            "--again" => again = Some(value()?),
            _ => return Err(format!("`{option}` is unknown; --help lists what there is")),
        }
    }
    order.patterns = patterns.unwrap_or(order.poses.saturating_mul(10));
    Ok(Some(Arguments { order, report, again }))
}

fn main() -> ExitCode {
    let done = match arguments() {
        Ok(Some(Arguments { order, again: Some(which), .. })) => once(&order, &which),
        Ok(Some(Arguments { order, report, .. })) => all(&order, report.as_deref()),
        Ok(None) => {
            println!("{HELP}");
            Ok(true)
        }
        Err(message) => Err(message.into()),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("reliability: {error}");
            ExitCode::from(2)
        }
    }
}

fn all(order: &Order, report: Option<&Path>) -> Result<bool, Box<dyn Error>> {
    let bar = ProgressBar::new(0);
    let style = "{msg:14} {wide_bar} {human_pos}/{human_len} {per_sec}, {eta} left";
    bar.set_style(ProgressStyle::with_template(style)?);
    bar.enable_steady_tick(Duration::from_millis(500));
    let start = Instant::now();
    let state = run(order, &bar)?;
    println!(
        "{}\n{:.1} s on {} threads",
        report::table(&state),
        start.elapsed().as_secs_f64(),
        order.threads
    );
    if let Some(file) = report {
        fs::write(file, report::markdown(&state))?;
    }
    let missed = report::all_missed(&state);
    missed.iter().for_each(|line| println!("MISSED  {line}"));
    Ok(missed.is_empty())
}

/// One try, told in full.
fn once(order: &Order, which: &str) -> Result<bool, Box<dyn Error>> {
    let (name, index) = which.rsplit_once(':').ok_or("--again takes PART:NUMBER")?;
    let all = parts(order.poses, order.patterns);
    let part = all.iter().find(|part| part.name == name).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|part| part.name.as_str()).collect();
        format!("there is no part `{name}`; there are {}", names.join(", "))
    })?;
    let mut tally = Tally::default();
    part.run(order.seed, number(index)?, &mut tally);
    println!("{}", serde_json::to_string_pretty(&tally)?);
    Ok(Fault::ALL.iter().all(|(fault, _)| tally.of(*fault).tries == 0))
}
