//! Limits the wrong way round.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(standard, m, deg);
    | joint | alpha |  a   | d | theta | limits |
    | J1    |  90   | 0    | 0.168 | q | -170 .. 170 |
    | J2    |  0    | 0.135 | 0   | q | 90 .. -90 |
    | J3    |  0    | 0.135 | 0   | q | |
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
