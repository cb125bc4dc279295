//! KUKA KR 6 R700, six axes. Axis 1 points down.
//!
//! OPW parameters: `include/opw_kinematics/opw_parameters_examples.h` of
//! <https://github.com/Jmeyer1292/opw_kinematics> at 8a32bda8197c. The Denavit-Hartenberg rows were
//! derived from them; both give the same pose (50 digits). No limits are printed there.

use kin_runtime::prelude::*;

dh! {
    /// KUKA KR 6 R700.
    pub struct Kr6R700(standard, m, deg);

    | joint | theta  | d      | a      | alpha |
    |-------|--------|--------|--------|-------|
    | J1    | q      | -0.4   |  0.025 |  90   |
    | J2    | q      |  0     |  0.315 |  0    |
    | J3    | q + 90 |  0     | -0.035 | -90   |
    | J4    | q      | -0.365 |  0     |  90   |
    | J5    | q      |  0     |  0     | -90   |
    | J6    | q      | -0.08  |  0     |  0    |

    base: Rx(180);
    tool: Rx(180);

    check [0, 0, 0, 0, 0, 0] => (0.785, 0, 0.435) zyx(0, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (0.6044228835645, -0.1685689297519, 0.8024301245888) zyx(-76.80610304027, -17.75900071631, -64.45828060713);
}
