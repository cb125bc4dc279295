//! `cargo run --release -p tests --bin counts`: what the derived programs cost.
//!
//! A line for each arm and output: multiplications, additions, sines and cosines. The six arms that other generators were
//! measured with come first. An addition inside a sum of angles counts; a negation, and an output that is 0 or ±1, does
//! not.

fn main() {
    print!("{}", tests::measured::counts());
}
