//! The slip of seed 004's first table: the joint's variable under `alpha`.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(standard, m, deg);
    | joint | alpha |  a   | d | theta |
    | J1    |  90   | 0    | 0.168 | q |
    | J2    |  q    | 0.135 | 0   | 0 |
    | J3    |  0    | 0.135 | 0   | q |
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
