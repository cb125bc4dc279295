//! The six-axis arm of seed 000: M. Madeira and M. T. Parreira, "Direct and Inverse Kinematics of Serial
//! Manipulators", first laboratory assignment, Instituto Superior Tecnico, Lisbon, March 2019.
//!
//! Table 3.1 as printed, with its two fixed rows (the auxiliary frames 2' and 5'), in millimetres. The
//! report prints no limits ("excluding its physical limitations"), so that those of J1 are illustrative.
//! The first pose is that of section 6.1.

use kin_runtime::prelude::*;

dh! {
    /// The six-axis arm of the 2019 lab report (seed 000), in millimetres.
    pub struct LabArm(modified, mm, deg);

    let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;

    | joint | alpha |  a  |  d  | theta  | limits      |
    |-------|-------|-----|-----|--------|-------------|
    | J1    |   0   |  0  | d1  | q      | -170 .. 170 |
    |       |   0   | -a1 | d2  | 0      |             |
    | J2    |  90   |  0  | 0   | q      |             |
    | J3    |   0   |  a2 | 0   | q + 90 |             |
    | J4    | -90   |  a4 | 0   | q      |             |
    |       |   0   |  0  | d5  | 0      |             |
    | J5    |  90   |  0  | 0   | q      |             |
    | J6    | -90   |  0  | d6  | q      |             |

    check [0, 0, 0, 0, 0, 0] => (-69, 0, 112) zyx(45, -90, -45);
    check [20, -50, 35, 70, -40, 25] =>
        (-93.44605592604, -15.37074218574, 64.94770070345) zyx(76.80610304027, 17.75900071631, -64.45828060713);
}
