//! `cargo run --release -p tests --bin trig`: how far the trigonometric kernel is from correctly rounded values.
//!
//! Promised: sine and cosine within 1 unit in the last place, arctangent within 2, in both precisions, over at least
//! 10⁸ samples of each. Exit code 1 if it is not so. A first argument is another number of samples.

use std::process::ExitCode;

use tests::trig::{DRAWS, Draw, Errors, double, single};

/// The largest distances promised of sine, cosine and arctangent.
const PROMISED: [u64; 3] = [1, 1, 2];

fn main() -> ExitCode {
    let samples: u64 = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(100_000_000);
    let each = samples.div_ceil(DRAWS.len() as u64);
    println!(
        "largest distance from the nearest number (and how many of a million are not it), of {samples} samples"
    );
    let mut kept = true;
    for (precision, measure) in [("f64", double as fn(Draw, u64, u64) -> Errors), ("f32", single)] {
        println!("\n{precision:<22}{:>15}{:>15}{:>15}", "sin", "cos", "atan2");
        for (seed, (name, draw)) in DRAWS.iter().enumerate() {
            let errors = measure(*draw, each, seed as u64);
            let columns: Vec<String> = errors
                .largest
                .iter()
                .zip(errors.off)
                .map(|(largest, off)| format!("{:>15}", format!("{largest} ({})", off * 1_000_000 / each)))
                .collect();
            println!("{name:<22}{}", columns.concat());
            kept &= errors.largest.iter().zip(PROMISED).all(|(largest, promised)| *largest <= promised);
        }
    }
    println!("\n{}", if kept { "kept: 1, 1 and 2" } else { "MISSED: 1, 1 and 2 are promised" });
    if kept { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
