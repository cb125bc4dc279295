//! Unimation Puma 560, six axes. Frame 6 stands at the wrist centre.
//!
//! Table and limits: `roboticstoolbox/models/DH/Puma560.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a. The toolbox names P. Corke
//! and B. Armstrong-Helouvry, "A search for consensus among model parameters reported for the PUMA 560
//! robot", ICRA 1994, pp. 1608-1613, and for the limits Wang and Chen, IEEE Transactions on Robotics and
//! Automation 7(4), 1991, p. 489.

use kin_runtime::prelude::*;

dh! {
    /// Unimation Puma 560.
    pub struct Puma560(standard, m, deg);

    | joint | theta | d       | a      | alpha | limits      |
    |-------|-------|---------|--------|-------|-------------|
    | J1    | q     | 26.45in | 0      |  90   | -160 .. 160 |
    | J2    | q     | 0       | 0.4318 |  0    |  -45 .. 225 |
    | J3    | q     | 0.15005 | 0.0203 | -90   | -225 ..  45 |
    | J4    | q     | 0.4318  | 0      |  90   | -110 .. 170 |
    | J5    | q     | 0       | 0      | -90   | -100 .. 100 |
    | J6    | q     | 0       | 0      |  0    | -266 .. 266 |

    check [0, 0, 0, 0, 0, 0] => (0.4521, -0.15005, 1.10363) zyx(0, 0, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (0.4355811533112, -0.001141300347382, 0.7528847546373) zyx(130.9432637922, 31.42525404547, 36.82680926717);
}
