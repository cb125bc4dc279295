//! KUKA KR 6 R900 sixx, six axes. Axis 1 points down.
//!
//! Joint origins, axes and limits: `kuka_kr6_support/urdf/kr6r900sixx_macro.xacro` of
//! <https://github.com/ros-industrial/kuka_experimental> at e78bbd15edb2, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// KUKA KR 6 R900 sixx.
    pub struct Kr6R900Sixx(standard, m, deg);

    | joint | theta  | d     | a      | alpha | limits      |
    |-------|--------|-------|--------|-------|-------------|
    | J1    | q      | -0.4  |  0.025 |  90   | -170 .. 170 |
    | J2    | q      |  0    |  0.455 |  0    | -190 ..  45 |
    | J3    | q + 90 |  0    | -0.035 | -90   | -120 .. 156 |
    | J4    | q      | -0.42 |  0     |  90   | -185 .. 185 |
    | J5    | q      |  0    |  0     | -90   | -120 .. 120 |
    | J6    | q      | -0.08 |  0     |  0    | -350 .. 350 |

    base: Rx(180);
    tool: Rx(180);

    check [0, 0, 0, 0, 0, 0] => (0.98, 0, 0.435) zyx(0, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (0.7389081072777, -0.2175175481321, 0.9239113941061) zyx(-76.80610304027, -17.75900071631, -64.45828060713);
}
