//! A decimal near a quarter turn is not one; that is a warning, made an error here.
#![deny(deprecated)]

use kin_runtime::prelude::*;

dh! {
    pub struct Lab(standard, m, rad);
    | joint | alpha |  a   | d | theta |
    | J1    | 1.5708 | 0    | 0.168 | q |
    | J2    |  0    | 0.135 | 0   | q |
    | J3    |  0    | 0.135 | 0   | q |
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
