//! Five mistakes, five messages, and none about the rest of the program.
use kin_runtime::prelude::*;

dh! {
    /// An arm with five mistakes.
    pub struct Lab(modified, mm, deg);
    let upper = 120;
    | joint | alpha |  a    |  d  | theta  | limits      |
    |-------|-------|-------|-----|--------|-------------|
    | J1    |   0   |  0    | 47  | q      | 170 .. -170 |
    | J2    |  90mm |  0    | 0   | q      |             |
    | J3    |   0   | uper  | 0   | q + 90 |             |
    | J4    | -90   | 20deg | 130 | q      |             |
    | J5    |  90   |  0    | 0   | q      |             |
    | J6    | -90   |  0    | q   | q      |             |
}

fn main() {
    let pose = Lab.fk(&joints![0.1, 0.4, -0.2, 0.3, 0.9, -0.5]);
    let jacobian = Lab.jacobian(&joints![0.1, 0.4, -0.2, 0.3, 0.9, -0.5]);
    for solution in Lab.ik(&pose).iter() {
        println!("{} {:?} {jacobian}", solution.branch, solution.q);
    }
}
