//! KUKA KR 150 R3100-2, six axes. Axis 1 points down.
//!
//! Joint origins, axes and limits: `kuka_kr150_support/urdf/kr150r3100_2_macro.xacro` of
//! <https://github.com/ros-industrial/kuka_experimental> at e78bbd15edb2, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// KUKA KR 150 R3100-2.
    pub struct Kr150R3100(standard, m, deg);

    | joint | theta  | d      | a      | alpha | limits      |
    |-------|--------|--------|--------|-------|-------------|
    | J1    | q      | -0.645 |  0.33  |  90   | -185 .. 185 |
    | J2    | q      |  0     |  1.35  |  0    | -140 ..  -5 |
    | J3    | q + 90 |  0     | -0.115 | -90   | -120 .. 168 |
    | J4    | q      | -1.42  |  0     |  90   | -350 .. 350 |
    | J5    | q      |  0     |  0     | -90   | -125 .. 125 |
    | J6    | q      | -0.215 |  0     |  0    | -350 .. 350 |

    base: Rx(180);
    tool: Rx(180);

    check [0, 0, 0, 0, 0, 0] => (3.315, 0, 0.76) zyx(0, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (2.568870304444, -0.7967929904252, 2.246048268143) zyx(-76.80610304027, -17.75900071631, -64.45828060713);
}
