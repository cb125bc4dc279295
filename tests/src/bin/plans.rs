//! `cargo run --release -p tests --bin plans`: makes the plans that ship with kin-gen.
//!
//! Writes `kin-gen/src/plan/plans.txt`. The search is deterministic: made again, the file is the same.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use kin_gen::plan::shape::Shape;
use kin_gen::plan::{self, Wanted};

const HELP: &str = "\
Searches the cheapest derivation for every structure that tests::structures lists, and writes them all down.

    cargo run --release -p tests --bin plans -- [OPTIONS]

    --only SHAPE      print the plans of one shape, such as 'd. dxx d. . .', instead of writing the file
    --out FILE        where to write the plans [kin-gen/src/plan/plans.txt of the workspace]
    --threads N       how many threads; the result does not depend on it [all]
    --list            print the structures and stop
    --help            this text

The file is compiled into kin-gen: build again afterwards. Three minutes of one core in all, half of them for seven joints.";

struct Arguments {
    only: Option<Shape>,
    out: PathBuf,
    threads: usize,
    list: bool,
}

/// Nothing if only the help was asked for.
fn arguments() -> Result<Option<Arguments>, String> {
    let out = Path::new(env!("CARGO_MANIFEST_DIR")).join("../kin-gen/src/plan/plans.txt");
    let threads = thread::available_parallelism().map_or(1, Into::into);
    let mut arguments = Arguments { only: None, out, threads, list: false };
    let mut given = std::env::args().skip(1);
    while let Some(option) = given.next() {
        let mut value = || given.next().ok_or_else(|| format!("{option} needs a value"));
        match option.as_str() {
            "--help" | "-h" => return Ok(None),
            "--list" => arguments.list = true,
            "--out" => arguments.out = value()?.into(),
            "--only" => {
                let shape = value()?;
                arguments.only = Some(Shape::parse(&shape).ok_or(format!("`{shape}` is not a shape"))?);
            }
            "--threads" => {
                let count = value()?;
                arguments.threads =
                    count.parse().map_err(|_| format!("`{count}` is not a number of threads"))?;
            }
            _ => return Err(format!("`{option}` is unknown; --help lists what there is")),
        }
    }
    Ok(Some(arguments))
}

fn main() -> ExitCode {
    let done = match arguments() {
        Ok(Some(arguments)) => run(&arguments),
        Ok(None) => {
            println!("{HELP}");
            Ok(())
        }
        Err(message) => Err(message.into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("plans: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let wanted: Vec<(Wanted, Shape)> = match &arguments.only {
        Some(shape) => plan::WANTED.map(|wanted| (wanted, shape.clone())).into(),
        None => tests::structures::all(),
    };
    if arguments.list {
        wanted.iter().for_each(|(wanted, shape)| println!("{} {shape}", wanted.word()));
        return Ok(());
    }
    let text = make(&wanted, arguments.threads)?;
    match arguments.only {
        Some(_) => print!("{text}"),
        None => std::fs::write(&arguments.out, text)?,
    }
    Ok(())
}

/// All plans, each thread taking the next one that is left; long ones first, so that no thread ends with a long one.
fn make(wanted: &[(Wanted, Shape)], threads: usize) -> Result<String, Box<dyn Error>> {
    let bar = ProgressBar::new(wanted.len() as u64);
    bar.set_style(ProgressStyle::with_template("{msg:40} {wide_bar} {pos}/{len} {elapsed}, {eta} left")?);
    bar.enable_steady_tick(Duration::from_millis(500));
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by_key(|index| std::cmp::Reverse(wanted[*index].1.joints().count()));
    let next = AtomicUsize::new(0);
    let made = Mutex::new(vec![None; wanted.len()]);
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, 256) {
            scope.spawn(|| {
                while let Some(index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let (wanted, shape) = &wanted[*index];
                    let text = plan::make(shape, *wanted);
                    bar.set_message(format!("{} {shape}", wanted.word()));
                    bar.inc(1);
                    if let Ok(mut made) = made.lock() {
                        made[*index] = text.map(|text| plan::shipped::entry(*wanted, shape, &text));
                    }
                }
            });
        }
    });
    bar.finish_and_clear();
    let made = made.into_inner().map_err(|error| error.to_string())?;
    let entries = made.into_iter().zip(wanted).map(|(entry, (wanted, shape))| {
        entry.ok_or_else(|| format!("no plan was found of {} {shape}", wanted.word()))
    });
    Ok(entries.collect::<Result<String, String>>()?)
}
