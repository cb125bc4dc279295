//! A mistake that a macro passes on stands where its caller wrote it.
use kin_runtime::prelude::*;

macro_rules! planar {
    ($name:ident, $upper:expr, $fore:literal) => {
        dh! {
            struct $name(standard, mm, deg);
            | joint | alpha | a      | d | theta |
            | J1    | 0     | $upper | 0 | q     |
            | J2    | 0     | $fore  | 0 | q     |
        }
    };
}

planar!(Good, 100 + 20, 150);
planar!(Bad, 100 + 20deg, 150);

fn main() {
    let q = joints![0.0, 0.0];
    println!("{} {}", Good.fk(&q), Bad.fk(&q));
}
