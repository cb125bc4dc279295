//! Yaskawa Motoman GP25, six axes. Joint 3 turns against joint 2.
//!
//! Joint origins, axes and limits: `motoman_gp25_support/urdf/gp25_macro.xacro` of
//! <https://github.com/ros-industrial/motoman> at 433be15f6a27, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits), taking angles
//! that the file writes as rounded decimals of multiples of pi/12 as exact.

use kin_runtime::prelude::*;

dh! {
    /// Yaskawa Motoman GP25.
    pub struct Gp25(standard, m, deg);

    | joint | theta   | d      | a     | alpha | limits      |
    |-------|---------|--------|-------|-------|-------------|
    | J1    | q       |  0.505 |  0.15 | -90   | -180 .. 180 |
    | J2    | q + 90  |  0     | -0.76 |  180  | -105 .. 155 |
    | J3    | q       |  0     | -0.2  |  90   |  -86 .. 160 |
    | J4    | q       | -0.795 |  0    | -90   | -200 .. 200 |
    | J5    | q       |  0     |  0    |  90   | -155 .. 150 |
    | J6    | q + 180 | -0.1   |  0    |  0    | -455 .. 455 |

    tool: Rx(180);

    check [0, 0, 0, 0, 0, 0] => (1.045, 0, 1.465) zyx(180, -90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (-0.4807296233525, -0.239250034599, 1.877321371321) zyx(95.24839145363, -34.50164412179, 25.47753613302);
}
