//! A family that the arm is said to belong to, and does not.
use kin_runtime::prelude::*;

dh! {
    pub struct Ur(standard, m, deg);
    | joint | alpha | a        | d        | theta |
    | J1    |  90   | 0        | 0.089159 | q     |
    | J2    |   0   | -0.425   | 0        | q     |
    | J3    |   0   | -0.39225 | 0        | q     |
    | J4    |  90   | 0        | 0.10915  | q     |
    | J5    | -90   | 0        | 0.09465  | q     |
    | J6    |   0   | 0        | 0.0823   | q     |
    ik: spherical_wrist;
}

fn main() {
    let _ = Ur.ik(&Ur.fk(&joints![0.1, 0.2, 0.3, 0.4, 0.5, 0.6]));
}
