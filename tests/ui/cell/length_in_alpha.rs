//! An angle column takes angles.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(standard, m, deg);
    | joint | alpha |  a   | d | theta |
    | J1    |  90mm | 0    | 0.168 | q |
    | J2    |  0    | 0.135 | 0   | q |
    | J3    |  0    | 0.135 | 0   | q |
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
