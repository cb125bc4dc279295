//! Omron Adept Cobra 600, a SCARA.
//!
//! github:petercorke/robotics-toolbox-python@a9ed8d45e92a: src/roboticstoolbox/models/DH/Cobra600.py.

use kin_runtime::prelude::*;

dh! {
    /// Two links, a quill that slides and turns.
    pub struct Cobra600(standard, m, deg);

    | joint | theta | d     | a     | alpha | limits     |
    |-------|-------|-------|-------|-------|------------|
    | J1    | q     | 0.387 | 0.325 | 0     | -50 .. 50  |
    | J2    | q     | 0     | 0.275 | 180   | -88 .. 88  |
    | J3    | 0     | q     | 0     | 0     | 0 .. 0.210 |
    | J4    | q     | 0     | 0     | 0     |            |

    check [0, 0, 0, 0] => (0.6, 0, 0.387) zyx(0, 0, 180);
    check [90, 0, 0.1, 0] => (0, 0.6, 0.287) zyx(90, 0, 180);
}
