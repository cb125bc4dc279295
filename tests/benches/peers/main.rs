//! `cargo bench -p tests --bench peers`: forward kinematics, Jacobian and inverse beside those of others, in one run.
//!
//! First all ways interleaved, medians of many rounds, and instructions as valgrind counts them; then criterion, each way
//! alone. `-- --report` writes the first part to PERFORMANCE.md and leaves criterion out. `-- --gate` counts instructions
//! only and fails where a ratio to a peer has sunk: it does not depend on the machine's mood.

mod batches;
mod clock;
mod count;
mod data;
mod growth;
mod operations;
mod peers;
mod report;
mod ways;

use criterion::{Criterion, Throughput};
use std::process::ExitCode;
use std::rc::Rc;
use std::time::Duration;

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

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut ways = ways::all();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["--count", group, name, elements, ..] => return count::run(&mut ways, group, name, elements),
        ["--gate", ..] => return count::gate(&ways),
        _ => {}
    }
    let times = clock::medians(&mut ways);
    let counts = count::all(&ways);
    print!("{}", clock::table(&ways, &times, counts.as_deref()));
    for target in &TARGETS {
        let Target { group, ours, peer, asked } = target;
        match clock::ratio(&ways, &times, target) {
            Some(ratio) => println!("{group}: {ours} {ratio:.2} × {peer}, asked for {asked} ×"),
            None => println!("{group}: {ours} not on this machine"),
        }
    }
    let data = &Rc::new(data::Data::new());
    let mut grown = growth::joints();
    grown.extend(growth::solutions());
    grown.extend(growth::lengths(data));
    let growth = clock::medians(&mut grown);
    print!("{}", clock::table(&grown, &growth, None));
    if arguments.iter().any(|argument| argument == "--report") {
        let growth = report::Timed { ways: &grown, times: &growth, counts: None };
        return report::write(
            &report::Timed { ways: &ways, times: &times, counts: counts.as_deref() },
            &growth,
        );
    }
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    for way in &mut ways {
        let mut group = criterion.benchmark_group(way.group);
        group.throughput(Throughput::Elements(data::COUNT as u64)).sample_size(10);
        group.bench_function(way.name, |bencher| bencher.iter(|| (way.run)(0..data::COUNT)));
        group.finish();
    }
    criterion.final_summary();
    ExitCode::SUCCESS
}
