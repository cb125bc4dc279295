//! `cargo bench -p tests --bench peers`: forward kinematics, Jacobian and inverse beside those of others, in one run.
//!
//! First all ways interleaved, medians of many rounds, and instructions as valgrind counts them; then criterion, each way
//! alone. `-- --report` writes the first part to PERFORMANCE.md and leaves criterion out; then libraries of Python are timed
//! beside this one as well, where they are installed. `-- --gate` counts instructions only and fails where a ratio to a peer has
//! sunk: it does not depend on the machine's mood. `-- --help` has the rest.

mod batches;
mod clock;
mod count;
mod data;
mod growth;
mod operations;
mod options;
mod peers;
mod python;
mod report;
mod ways;
mod wider;

use criterion::{Criterion, Throughput};
use data::Data;
use options::Task;
use std::process::ExitCode;
use std::rc::Rc;
use std::time::Duration;
use ways::Way;

/// What is asked for: so many times faster than a peer, by the clock.
pub(crate) struct Target {
    pub(crate) group: &'static str,
    pub(crate) ours: &'static str,
    pub(crate) peer: &'static str,
    pub(crate) asked: f64,
}

const fn target(group: &'static str, ours: &'static str, peer: &'static str, asked: f64) -> Target {
    Target { group, ours, peer, asked }
}

pub(crate) const TARGETS: [Target; 9] = [
    target("fk", "this library", "rs-opw-kinematics", 4.0),
    target("fk", "this library", "nalgebra, isometries", 2.8),
    target("fk and jacobian", "this library", "k", 12.0),
    target("fk and jacobian", "this library", "rs-opw-kinematics", 22.0),
    target("ik", "this library", "rs-opw-kinematics", 8.0),
    target("fk, batch", "this library, AVX2", "nalgebra, isometries", 5.0),
    target("fk, batch", "this library, AVX-512", "nalgebra, isometries", 8.0),
    target("ik, batch", "this library, AVX2", "rs-opw-kinematics", 20.0),
    target("ik, batch", "this library, AVX-512", "rs-opw-kinematics", 25.0),
];

/// The same when both are built for x86-64-v3.
pub(crate) const WIDER: [Target; 1] = [target("ik", "this library", "rs-opw-kinematics", 16.0)];

fn main() -> ExitCode {
    let task = match options::task(std::env::args().skip(1)) {
        Ok(Task::Help) => {
            println!("{}", options::HELP);
            return ExitCode::SUCCESS;
        }
        Ok(Task::Rows) => return wider::tell(),
        Ok(task) => task,
        Err(message) => {
            eprintln!("peers: {message}");
            return ExitCode::from(2);
        }
    };
    let data = &Rc::new(Data::new());
    let mut ways = ways::all(data);
    match &task {
        Task::Count { group, name, elements } => return count::run(&mut ways, group, name, elements),
        Task::Gate => return count::gate(&ways),
        _ => {}
    }
    eprintln!("all in turn, {} rounds", clock::ROUNDS);
    let times = clock::medians(&mut ways);
    eprintln!("instructions, under valgrind");
    let counts = count::all(&ways);
    print!("{}", clock::table(&ways, &times, counts.as_deref()));
    for target in &TARGETS {
        let Target { group, ours, peer, asked } = target;
        match clock::ratio(&ways, &times, target) {
            Some(ratio) => println!("{group}: {ours} {ratio:.2} × {peer}, asked for {asked} ×"),
            None => println!("{group}: {ours} not on this machine"),
        }
    }
    eprintln!("how cost grows");
    let mut grown = growth::all(data);
    let growth = clock::medians(&mut grown);
    print!("{}", clock::table(&grown, &growth, None));
    let Task::Report { python, v3 } = task else { return criterion(&mut ways) };
    eprintln!("libraries of Python");
    let python = python::beside(&python, &mut ways, data);
    let wider = v3.then(|| {
        eprintln!("built for {}", wider::LEVEL);
        wider::measure(&ways)
    });
    report::write(&report::Run {
        beside: report::Timed { ways: &ways, times: &times, counts: counts.as_deref() },
        growth: report::Timed { ways: &grown, times: &growth, counts: None },
        python: &python,
        wider: wider.as_ref(),
    })
}

/// Each way alone.
fn criterion(ways: &mut [Way]) -> ExitCode {
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    for way in ways {
        let mut group = criterion.benchmark_group(way.group);
        group.throughput(Throughput::Elements(data::COUNT as u64)).sample_size(10);
        group.bench_function(way.name, |bencher| bencher.iter(|| (way.run)(0..data::COUNT)));
        group.finish();
    }
    criterion.final_summary();
    ExitCode::SUCCESS
}
