//! `host [quick]`: prints the hash that every target must have.

#[path = "../../../src/bits.rs"]
mod bits;

fn main() {
    let quick = std::env::args().any(|argument| argument == "quick");
    println!("{:016x}", bits::hash(if quick { bits::QUICK } else { bits::POSES }));
}
