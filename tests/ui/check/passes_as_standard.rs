//! The table of seed 004 under the other convention: the pose tells.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(modified, m, deg);
    | joint | alpha |  a   | d | theta |
    | J1    |  90   | 0    | 0.168 | q |
    | J2    |  0    | 0.135 | 0   | q |
    | J3    |  0    | 0.135 | 0   | q |
    check [0, 90, 0] => (0, 0, 0.438);
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
