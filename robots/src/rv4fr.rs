//! Mitsubishi RV-4FR, six axes.
//!
//! Screw axes and limits: module `ssik.prebuilt.mitsubishi.rv4fr_ik` of the ssik 8.2.0 wheel on PyPI,
//! taken there from a URDF, `rv4fr_base` to `rv4fr_hand_flange`. The Denavit-Hartenberg rows were derived
//! from them; both give the same pose (50 digits).

use kin_runtime::prelude::*;

dh! {
    /// Mitsubishi RV-4FR.
    pub struct Rv4fr(standard, m, deg);

    | joint | theta   | d     | a      | alpha | limits      |
    |-------|---------|-------|--------|-------|-------------|
    | J1    | q       | 0.35  |  0     | -90   | -240 .. 240 |
    | J2    | q + 90  | 0     | -0.235 |  0    | -120 .. 120 |
    | J3    | q + 90  | 0     |  0.05  | -90   |    0 .. 161 |
    | J4    | q       | 0.275 |  0     |  90   | -200 .. 200 |
    | J5    | q       | 0     |  0     | -90   | -120 .. 120 |
    | J6    | q + 180 | 0.085 |  0     |  0    | -360 .. 360 |

    check [0, 0, 0, 0, 0, 0] => (-0.05, 0, 0.945) zyx(0, 0, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (-0.2966683996396, -0.1626154137396, 0.811802282714) zyx(130.9432637922, -31.42525404547, -36.82680926717);
}
