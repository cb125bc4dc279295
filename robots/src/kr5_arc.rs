//! KUKA KR 5 arc, six axes.
//!
//! Table and limits: `roboticstoolbox/models/DH/KR5.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a.

use kin_runtime::prelude::*;

dh! {
    /// KUKA KR 5 arc.
    pub struct Kr5Arc(standard, m, deg);

    | joint | theta | d      | a    | alpha | limits      |
    |-------|-------|--------|------|-------|-------------|
    | J1    | q     |  0.4   | 0.18 | -90   | -155 .. 155 |
    | J2    | q     |  0     | 0.6  |  0    | -180 ..  65 |
    | J3    | q     |  0     | 0.12 |  90   |  -15 .. 158 |
    | J4    | q     | -0.62  | 0    | -90   | -350 .. 350 |
    | J5    | q     |  0     | 0    |  90   | -130 .. 130 |
    | J6    | q     | -0.115 | 0    |  180  | -350 .. 350 |

    check [0, 0, 0, 0, 0, 0] => (0.9, 0, -0.335) zyx(0, 0, 180);
    check [20, -50, 35, 70, -40, 25] =>
        (0.8118856768254, 0.3694227951055, 0.2132611435341) zyx(130.9432637922, -31.42525404547, 143.1731907328);
}
