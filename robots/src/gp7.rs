//! Yaskawa Motoman GP7, six axes. Joint 3 turns against joint 2.
//!
//! Joint origins, axes and limits: `motoman_gp7_support/urdf/gp7_macro.xacro` of
//! <https://github.com/ros-industrial/motoman> at 433be15f6a27, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits), taking angles
//! that the file writes as rounded decimals of multiples of pi/12 as exact.

use kin_runtime::prelude::*;

dh! {
    /// Yaskawa Motoman GP7.
    pub struct Gp7(standard, m, rad);

    | joint | theta    | d     | a      | alpha | limits            |
    |-------|----------|-------|--------|-------|-------------------|
    | J1    | q        |  0.33 |  0.04  | -pi/2 | -2.9670 .. 2.9670 |
    | J2    | q + pi/2 |  0    | -0.445 |  pi   | -1.1344 .. 2.5307 |
    | J3    | q        |  0    | -0.04  |  pi/2 | -1.2217 .. 3.3161 |
    | J4    | q        | -0.44 |  0     | -pi/2 | -3.3161 .. 3.3161 |
    | J5    | q        |  0    |  0     |  pi/2 | -2.3561 .. 2.3561 |
    | J6    | q + pi   | -0.08 |  0     |  0    | -6.2944 .. 6.2944 |

    tool: Rx(pi);

    check [0, 0, 0, 0, 0, 0] => (0.56, 0, 0.815) zyx(pi, -pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (-0.1874475853645, -0.1060621821382, 1.13675478367) zyx(1.71305372054, -0.6187955966755, 0.5270218594426);
}
