//! A parameter is a length or an angle; its uses decide, and must agree. Its field exists all the same.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(standard, m, deg);
    param reach = 0.135;
    | joint | alpha |  a    | d     | theta     |
    | J1    |  90   | 0     | 0.168 | q         |
    | J2    |  0    | reach | 0     | q         |
    | J3    |  0    | 0.135 | 0     | q + reach |
}

fn main() {
    let lab = Lab { reach: 0.2, ..Lab::NOMINAL };
    let _ = lab.fk(&joints![0.1, 0.2, 0.3]);
}
