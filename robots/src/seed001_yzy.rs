//! Seed 001 read as the anthropomorphic arm with spherical wrist of B. Siciliano, L. Sciavicco, L.
//! Villani and G. Oriolo, "Robotics: Modelling, Planning and Control", Springer 2009, to which the report
//! refers.
//!
//! The report prints no lengths: here d2 = 1, d3 + d4 = 1, d5 = 1, and d1 = 0 as in the report's inverse.
//! [`Anthropomorphic`](crate::Anthropomorphic) is the chain as printed.

use kin_runtime::prelude::*;

dh! {
    /// Seed 001 read as a textbook arm of unit lengths.
    pub struct Seed001Yzy(standard, m, rad);

    | joint | theta    | d | a | alpha |
    |-------|----------|---|---|-------|
    | J1    | q        | 0 | 0 |  pi/2 |
    | J2    | q        | 0 | 1 |  0    |
    | J3    | q + pi/2 | 0 | 0 |  pi/2 |
    | J4    | q        | 1 | 0 | -pi/2 |
    | J5    | q        | 0 | 0 |  pi/2 |
    | J6    | q        | 1 | 0 |  0    |

    check [0, 0, 0, 0, 0, 0] => (3, 0, 0) zyx(pi, -pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (2.092870708304, 1.248373889364, -1.354365913625) zyx(-0.6493515005862, 0.1453554496954, -2.029752213993);
}
