//! KUKA KR 16-2, six axes. Axis 1 points down.
//!
//! Joint origins, axes and limits: `kuka_kr16_support/urdf/kr16_2_macro.xacro` of
//! <https://github.com/ros-industrial/kuka_experimental> at e78bbd15edb2, `base_link` to `tool0`. The
//! Denavit-Hartenberg rows were derived from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// KUKA KR 16-2.
    pub struct Kr16(standard, m, deg);

    | joint | theta  | d      | a     | alpha | limits      |
    |-------|--------|--------|-------|-------|-------------|
    | J1    | q      | -0.675 | 0.26  |  90   | -185 .. 185 |
    | J2    | q      |  0     | 0.68  |  0    | -155 ..  35 |
    | J3    | q + 90 |  0     | 0.035 | -90   | -130 .. 154 |
    | J4    | q      | -0.67  | 0     |  90   | -350 .. 350 |
    | J5    | q      |  0     | 0     | -90   | -130 .. 130 |
    | J6    | q      | -0.158 | 0     |  0    | -350 .. 350 |

    base: Rx(180);
    tool: Rx(180);

    check [0, 0, 0, 0, 0, 0] => (1.768, 0, 0.64) zyx(0, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (1.405762165914, -0.4100951425197, 1.400389872626) zyx(-76.80610304027, -17.75900071631, -64.45828060713);
}
