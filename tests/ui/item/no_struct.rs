//! A declaration that is not a struct.
use kin_runtime::prelude::*;

dh! {
    pub enum Lab(standard, m, deg);
    | joint | alpha |  a   | d | theta |
    | J1    |  90   | 0    | 0.168 | q |
    | J2    |  0    | 0.135 | 0   | q |
    | J3    |  0    | 0.135 | 0   | q |
}

fn main() {}
