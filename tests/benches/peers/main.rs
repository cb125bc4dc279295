//! `cargo bench -p tests --bench peers`: forward kinematics, Jacobian and inverse beside those of others, in one run.
//!
//! First all ways interleaved, medians of many rounds, and instructions as valgrind counts them; then criterion, each way
//! alone. `-- --report` writes the first part to PERFORMANCE.md and leaves criterion out. `-- --gate` counts instructions
//! only and fails where a ratio to a peer has sunk: it does not depend on the machine's mood.

mod clock;
mod count;
mod data;
mod peers;
mod report;
mod ways;

use criterion::{Criterion, Throughput};
use std::process::ExitCode;
use std::time::Duration;

/// What is asked for: so many times faster than that peer, by the clock.
pub(crate) const TARGETS: [(&str, &str, f64); 5] = [
    ("fk", "rs-opw-kinematics", 4.0),
    ("fk", "nalgebra, isometries", 2.8),
    ("fk and jacobian", "k", 12.0),
    ("fk and jacobian", "rs-opw-kinematics", 22.0),
    ("ik", "rs-opw-kinematics", 8.0),
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
    for (group, peer, target) in TARGETS {
        let ratio = clock::ratio(&ways, &times, group, peer);
        println!("{group}: {ratio:.2} × {peer}, asked for {target} ×");
    }
    if arguments.iter().any(|argument| argument == "--report") {
        return report::write(&ways, &times, counts.as_deref());
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
