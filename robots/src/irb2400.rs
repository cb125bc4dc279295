//! ABB IRB 2400, six axes.
//!
//! Joint origins, axes and limits: `abb_irb2400_support/urdf/irb2400_macro.xacro` of
//! <https://github.com/ros-industrial/abb> at 77db19bdb098, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits), taking angles
//! that the file writes as rounded decimals of multiples of pi/12 as exact.

use kin_runtime::prelude::*;

dh! {
    /// ABB IRB 2400.
    pub struct Irb2400(standard, m, rad);

    | joint | theta    | d     | a      | alpha | limits            |
    |-------|----------|-------|--------|-------|-------------------|
    | J1    | q        | 0.615 |  0.1   | -pi/2 | -3.1416 .. 3.1416 |
    | J2    | q + pi/2 | 0     | -0.705 |  0    | -1.7453 .. 1.9199 |
    | J3    | q        | 0     | -0.135 |  pi/2 | -1.0472 .. 1.1345 |
    | J4    | q        | 0.755 |  0     | -pi/2 |   -3.49 ..   3.49 |
    | J5    | q        | 0     |  0     |  pi/2 | -2.0944 .. 2.0944 |
    | J6    | q        | 0.085 |  0     |  0    | -6.9813 .. 6.9813 |

    check [0, 0, 0, 0, 0, 0] => (0.94, 0, 1.455) zyx(0, pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (0.3642420240153, 0.06159054700823, 1.425741504663) zyx(1.249351500586, -0.1453554496954, 1.111840439597);
}
