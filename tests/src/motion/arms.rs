//! Arms of kinds that nobody sells: declared for paths to be followed.

use kin_runtime::dh;

dh! {
    /// An elbow arm whose wrist axes stand at 60° to each other: not every rotation is reached.
    pub struct Oblique(standard, m, deg);

    | joint | theta |  d   |  a   | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.4  | 0.1  | -90   |
    | J2    | q     | 0    | 0.45 |   0   |
    | J3    | q     | 0    | 0.05 |  90   |
    | J4    | q     | 0.5  | 0    | -60   |
    | J5    | q     | 0    | 0    |  60   |
    | J6    | q     | 0.1  | 0    |   0   |
}

dh! {
    /// A shoulder like a ball, an elbow, and a hand of two axes.
    pub struct Ball(standard, m, deg);

    | joint | theta  | d    | a    | alpha |
    |-------|--------|------|------|-------|
    | J1    | q      | 0.3  | 0    | -90   |
    | J2    | q      | 0    | 0    | 90    |
    | J3    | q + 90 | 0.4  | 0    | -90   |
    | J4    | q      | 0    | 0.35 | 0     |
    | J5    | q      | 0.03 | 0    | 90    |
    | J6    | q      | 0.08 | 0    | 0     |
}
