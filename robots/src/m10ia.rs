//! Fanuc M-10iA, six axes. Joint 3 turns against joint 2.
//!
//! Joint origins, axes and limits: `fanuc_m10ia_support/urdf/m10ia_macro.xacro` of
//! <https://github.com/ros-industrial/fanuc> at 8fee5e30e535, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// Fanuc M-10iA.
    pub struct M10ia(standard, m, rad);

    | joint | theta    | d     | a     | alpha | limits        |
    |-------|----------|-------|-------|-------|---------------|
    | J1    | q        |  0.45 |  0.15 | -pi/2 | -3.14 .. 3.14 |
    | J2    | q + pi/2 |  0    | -0.6  |  pi   | -1.57 .. 2.79 |
    | J3    | q        |  0    | -0.2  |  pi/2 | -3.14 .. 4.61 |
    | J4    | q        | -0.64 |  0    | -pi/2 | -3.31 .. 3.31 |
    | J5    | q        |  0    |  0    |  pi/2 | -3.31 .. 3.31 |
    | J6    | q + pi   | -0.1  |  0    |  0    | -6.28 .. 6.28 |

    tool: Rx(pi);

    check [0, 0, 0, 0, 0, 0] => (0.89, 0, 1.25) zyx(pi, -pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (-0.295360017019, -0.1514628713033, 1.603109945255) zyx(1.71305372054, -0.6187955966755, 0.5270218594426);
}
