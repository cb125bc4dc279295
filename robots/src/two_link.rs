//! The two-link arm of textbooks, in a vertical plane.
//!
//! github:petercorke/robotics-toolbox-python@a9ed8d45e92a: src/roboticstoolbox/models/DH/TwoLink.py.

use kin_runtime::prelude::*;

dh! {
    /// Two links of one metre, turned upright by its base.
    pub struct TwoLink(standard, m, deg);

    | joint | theta | d | a | alpha |
    |-------|-------|---|---|-------|
    | J1    | q     | 0 | 1 | 0     |
    | J2    | q     | 0 | 1 | 0     |

    base: Rx(90);

    check [0, 0] => (2, 0, 0) zyx(0, 0, 90);
    check [90, -90] => (1, 0, 1) zyx(0, 0, 90);
}
