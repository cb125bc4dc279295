//! Axes that miss a common point by 0.13 mm, and the cell that causes it.
use kin_runtime::prelude::*;

dh! {
    pub struct Puma(standard, m, deg);
    | joint | alpha |   a    |    d    | theta |
    | J1    |  90   | 0      | 26.45in | q     |
    | J2    |   0   | 0.4318 | 0       | q     |
    | J3    | -90   | 0.0203 | 0.15005 | q     |
    | J4    |  90   | 0      | 0.4318  | q     |
    | J5    | -90   | 0      | 0.13mm  | q     |
    | J6    |   0   | 0      | 0       | q     |
    ik: spherical_wrist;
}

fn main() {
    let q = joints![0.1, -0.4, 0.2, 0.3, 0.9, -0.5];
    println!("{}", Puma.ik(&Puma.fk(&q)).iter().count());
}
