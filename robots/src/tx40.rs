//! Staubli TX40, six axes, its elbow 35 mm beside the shoulder.
//!
//! OPW parameters: `include/opw_kinematics/opw_parameters_examples.h` of
//! <https://github.com/Jmeyer1292/opw_kinematics> at 8a32bda8197c. The Denavit-Hartenberg rows were
//! derived from them; both give the same pose (50 digits). No limits are printed there.

use kin_runtime::prelude::*;

dh! {
    /// Staubli TX40.
    pub struct Tx40(standard, m, deg);

    | joint | theta  | d     | a      | alpha |
    |-------|--------|-------|--------|-------|
    | J1    | q      | 0.32  |  0     | -90   |
    | J2    | q + 90 | 0     | -0.225 |  0    |
    | J3    | q      | 0.035 |  0     |  90   |
    | J4    | q      | 0.225 |  0     | -90   |
    | J5    | q      | 0     |  0     |  90   |
    | J6    | q      | 0.065 |  0     |  0    |

    check [0, 0, 0, 0, 0, 0] => (0.29, 0.035, 0.545) zyx(0, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (0.08543880168622, 0.02656220807219, 0.5495519351468) zyx(76.80610304027, -17.75900071631, 64.45828060713);
}
