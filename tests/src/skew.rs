//! A declared arm that several tests ask for.

use kin_runtime::dh;

dh! {
    /// No two neighbouring axes of the base meet, are parallel or stand at right angles: a quartic.
    pub struct Skew(standard, m, deg);

    | joint | theta | d    | a    | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.3  | 0.15 | 60    |
    | J2    | q     | 0.1  | 0.45 | 75    |
    | J3    | q     | -0.2 | 0.25 | 110   |
    | J4    | q     | 0.3  | 0    | -90   |
    | J5    | q     | 0    | 0    | 90    |
    | J6    | q     | 0.1  | 0    | 0     |
}
