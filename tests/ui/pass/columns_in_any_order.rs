//! Columns in any order, by any of their names, inside a function.
use kin_runtime::prelude::*;

fn main() {
    dh! {
        struct Usual(modified, mm, deg);
        | joint | alpha | a   | d  | theta  |
        | J1    | 0     | 0   | 47 | q      |
        | J2    | 90    | -30 | 0  | q - 90 |
        | J3    | 0     | 120 | 5  | q      |
    }
    dh! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        struct Other(mm, modified, deg);
        | theta_i | r   | i | d_i | alpha_i |
        |:--------|----:|---|-----|---------|
        | q1      | 0   | 1 | 47  | 0       |
        | q2 - 90 | -30 | 2 | 0   | 90      |
        | q3      | 120 | 3 | 5   | 0       |
    }
    let q = joints![0.3, -0.2, 0.7];
    assert_eq!(Usual.fk(&q), Other.fk(&q));
}
