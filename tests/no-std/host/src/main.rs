//! `host [quick|all]`: prints the hashes that every target must have, one of them if it is named.

#[path = "../../../src/bits/mod.rs"]
mod bits;

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("quick") => println!("{:016x}", bits::hash(bits::QUICK)),
        Some("all") => println!("{:016x}", bits::hash(bits::POSES)),
        _ => {
            println!("{:016x} {:016x}", bits::hash(bits::POSES), bits::aimed::hash_aimed(bits::aimed::AIMED))
        }
    }
}
