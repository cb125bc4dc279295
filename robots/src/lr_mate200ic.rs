//! Fanuc LR Mate 200iC, six axes. Joint 3 turns against joint 2.
//!
//! Joint origins, axes and limits: `fanuc_lrmate200ic_support/urdf/lrmate200ic_macro.xacro` of
//! <https://github.com/ros-industrial/fanuc> at 8fee5e30e535, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// Fanuc LR Mate 200iC.
    pub struct LrMate200ic(standard, m, rad);

    | joint | theta    | d     | a      | alpha | limits            |
    |-------|----------|-------|--------|-------|-------------------|
    | J1    | q        |  0.33 |  0.075 | -pi/2 | -2.9671 .. 2.9671 |
    | J2    | q + pi/2 |  0    | -0.3   |  pi   | -1.0472 .. 2.4435 |
    | J3    | q        |  0    | -0.075 |  pi/2 | -2.4784 .. 4.0143 |
    | J4    | q        | -0.32 |  0     | -pi/2 | -3.3161 .. 3.3161 |
    | J5    | q        |  0    |  0     |  pi/2 | -2.0944 .. 2.0944 |
    | J6    | q + pi   | -0.08 |  0     |  0    | -6.2832 .. 6.2832 |

    tool: Rx(pi);

    check [0, 0, 0, 0, 0, 0] => (0.475, 0, 0.705) zyx(pi, -pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (-0.1070752837036, -0.08120011576995, 0.9234271932172) zyx(1.71305372054, -0.6187955966755, 0.5270218594426);
}
