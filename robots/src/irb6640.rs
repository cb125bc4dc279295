//! ABB IRB 6640-185/2.8, six axes.
//!
//! Joint origins, axes and limits: `abb_irb6640_support/urdf/irb6640_185_280_macro.xacro` of
//! <https://github.com/ros-industrial/abb> at 77db19bdb098, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits), taking angles
//! that the file writes as rounded decimals of multiples of pi/12 as exact.

use kin_runtime::prelude::*;

dh! {
    /// ABB IRB 6640-185/2.8.
    pub struct Irb6640(standard, m, rad);

    | joint | theta    | d     | a      | alpha | limits           |
    |-------|----------|-------|--------|-------|------------------|
    | J1    | q        | 0.78  |  0.32  | -pi/2 | -2.967 ..  2.967 |
    | J2    | q + pi/2 | 0     | -1.075 |  0    | -1.134 .. 1.4855 |
    | J3    | q        | 0     | -0.2   |  pi/2 | -3.142 ..  1.222 |
    | J4    | q        | 1.392 |  0     | -pi/2 | -5.236 ..  5.236 |
    | J5    | q        | 0     |  0     |  pi/2 | -2.094 ..  2.094 |
    | J6    | q        | 0.2   |  0     |  0    | -6.283 ..  6.283 |

    check [0, 0, 0, 0, 0, 0] => (1.912, 0, 2.055) zyx(0, pi/2, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (1.000418233068, 0.1892710015503, 2.089188834969) zyx(1.249351500586, -0.1453554496954, 1.111840439597);
}
