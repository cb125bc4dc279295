//! RAWRobotics Orion 5.
//!
//! github:petercorke/robotics-toolbox-python@a9ed8d45e92a: src/roboticstoolbox/models/DH/Orion5.py.

use kin_runtime::prelude::*;

dh! {
    /// A waist and three parallel joints.
    pub struct Orion5(standard, m, deg);

    | joint | theta | d     | a         | alpha | limits      |
    |-------|-------|-------|-----------|-------|-------------|
    | J1    | q     | 0.053 | 0         | 90    |             |
    | J2    | q     | 0     | 0.170384  | 0     | 10 .. 122.5 |
    | J3    | q     | 0     | -0.136307 | 0     | 20 .. 340   |
    | J4    | q     | 0     | 0.126     | 0     | 45 .. 315   |

    base: Tx(0.030309);
    tool: Ry(90);

    check [0, 0, 0, 0] => (0.190386, 0, 0.053) within 1e-9;
    check [90, 90, 0, 0] => (0.030309, 0, 0.213077) within 1e-9;
}
