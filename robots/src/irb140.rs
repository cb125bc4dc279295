//! ABB IRB 140, six axes.
//!
//! Table and limits: `roboticstoolbox/models/DH/IRB140.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a.

use kin_runtime::prelude::*;

dh! {
    /// ABB IRB 140.
    pub struct Irb140(standard, m, deg);

    | joint | theta | d     | a     | alpha | limits      |
    |-------|-------|-------|-------|-------|-------------|
    | J1    | q     | 0.352 | 0.070 | -90   | -180 .. 180 |
    | J2    | q     | 0     | 0.360 |  0    | -100 .. 100 |
    | J3    | q     | 0     | 0     | -90   | -220 ..  60 |
    | J4    | q     | 0.380 | 0     |  90   | -200 .. 200 |
    | J5    | q     | 0     | 0     | -90   | -120 .. 120 |
    | J6    | q     | 0.065 | 0     |  0    | -400 .. 400 |

    check [0, 0, 0, 0, 0, 0] => (0.43, 0, -0.093) zyx(0, 0, 180);
    check [20, -50, 35, 70, -40, 25] =>
        (0.4141556382967, 0.1089591300639, 0.216326475061) zyx(-90.94326379222, -31.42525404547, -143.1731907328);
}
