//! `cargo run --release -p tests --bin motion -- --trajectories 1e6 --crossings 1e4 --paths 1e6`: motion judged by the million.
//!
//! Trajectories against their limits and an independent optimum; the singularity monitor against a sampling that is 10,000 times
//! finer than 20 Hz; paths of poses through singular sets against the joint values that made them. Exit code 1 if a promise is not kept, 2 if the order was not understood.

use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use indicatif::{ProgressBar, ProgressStyle};
use tests::motion::{passing, timing, tracking};

const HELP: &str = "\
    --trajectories N  random trajectories against their limits and an independent optimum [1e6]
    --crossings N     random trajectories whose crossings are looked for [1e4]
    --paths N         random paths through singular poses that are followed [1e6]
    --finer N         how many times finer than 20 Hz the crossings are sampled [1e4]
    --seed N          where the random numbers start [1]
    --threads N       how many threads; the result does not depend on it [all]";

/// Tries that a thread takes at once.
const BLOCK: u64 = 16;

struct Order {
    trajectories: u64,
    crossings: u64,
    paths: u64,
    finer: u64,
    seed: u64,
    threads: usize,
}

/// Nothing if the help was asked for.
fn order() -> Result<Option<Order>, String> {
    let threads = thread::available_parallelism().map_or(1, Into::into);
    let mut order = Order {
        trajectories: 1_000_000,
        crossings: 10_000,
        paths: 1_000_000,
        finer: 10_000,
        seed: 1,
        threads,
    };
    let mut given = std::env::args().skip(1);
    while let Some(option) = given.next() {
        if option == "--help" {
            return Ok(None);
        }
        let text = given.next().ok_or_else(|| format!("{option} needs a value"))?;
        let number = text.parse::<f64>().ok().filter(|x| *x >= 0.0 && x.fract() == 0.0 && *x < 1e15);
        let number = number.ok_or_else(|| format!("`{text}` is not a whole number"))? as u64;
        match option.as_str() {
            "--trajectories" => order.trajectories = number,
            "--crossings" => order.crossings = number,
            "--paths" => order.paths = number,
            "--finer" => order.finer = number.max(1),
            "--seed" => order.seed = number,
            "--threads" => order.threads = number.clamp(1, 1024) as usize,
            _ => return Err(format!("`{option}` is unknown; --help lists what there is")),
        }
    }
    Ok(Some(order))
}

/// All tries, in blocks that the threads take as they come; added up in the order of the blocks.
fn spread<F: Default + Send>(
    (name, tries, threads): (&'static str, u64, usize),
    run: impl Fn(std::ops::Range<u64>) -> F + Sync,
    and: impl Fn(F, F) -> F,
) -> F {
    let bar = ProgressBar::new(tries).with_message(name);
    if let Ok(style) = ProgressStyle::with_template("{msg:13} {wide_bar} {human_pos}/{human_len}, {eta} left")
    {
        bar.set_style(style);
    }
    let next = AtomicU64::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let start = next.fetch_add(BLOCK, Ordering::Relaxed);
            if start >= tries {
                return done;
            }
            let end = (start + BLOCK).min(tries);
            done.push((start, run(start..end)));
            bar.inc(end - start);
        }
    };
    let mut done: Vec<(u64, F)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("a try panicked")).collect()
    });
    bar.finish_and_clear();
    done.sort_by_key(|(start, _)| *start);
    done.into_iter().map(|(_, found)| found).fold(F::default(), and)
}

fn main() -> ExitCode {
    let order = match order() {
        Ok(Some(order)) => order,
        Ok(None) => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Err(message) => {
            eprintln!("motion: {message}");
            return ExitCode::from(2);
        }
    };
    let timed = spread(
        ("trajectories", order.trajectories, order.threads),
        |tries| timing::run(order.seed, tries),
        timing::Findings::and,
    );
    println!("trajectories: {timed:#?}");
    let passed = spread(
        ("crossings", order.crossings, order.threads),
        |tries| passing::run(order.seed, tries, order.finer),
        passing::Findings::and,
    );
    println!("crossings: {passed:#?}");
    let followed = spread(
        ("paths", order.paths, order.threads),
        |tries| tracking::run(order.seed, tries),
        tracking::Findings::and,
    );
    println!("paths: {followed:#?}");
    let broken = [timed.broken(), passed.broken(), followed.broken()].concat();
    broken.iter().for_each(|line| println!("MISSED  {line}"));
    if broken.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
