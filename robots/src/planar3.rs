//! The planar arm of three links of textbooks.
//!
//! github:petercorke/robotics-toolbox-python@a9ed8d45e92a: src/roboticstoolbox/models/DH/Planar3.py.

use kin_runtime::prelude::*;

dh! {
    /// Three links of one metre in the plane. A position alone leaves one joint free; a pose has two solutions.
    pub struct Planar3(standard, m, deg);

    | joint | theta | d | a | alpha |
    |-------|-------|---|---|-------|
    | J1    | q     | 0 | 1 | 0     |
    | J2    | q     | 0 | 1 | 0     |
    | J3    | q     | 0 | 1 | 0     |

    check [0, 0, 0] => (3, 0, 0);
    check [90, -90, 90] => (1, 2, 0) zyx(90, 0, 0);
}
