//! Universal Robots UR5, six axes, three of them parallel.
//!
//! Table and limits: `roboticstoolbox/models/DH/UR5.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a. d1 = 0.089459 as printed
//! there; the maker prints 0.089159.

use kin_runtime::prelude::*;

dh! {
    /// Universal Robots UR5.
    pub struct Ur5(standard, m, rad);

    | joint | theta | d        | a        | alpha | limits        |
    |-------|-------|----------|----------|-------|---------------|
    | J1    | q     | 0.089459 |  0       |  pi/2 | -2*pi .. 2*pi |
    | J2    | q     | 0        | -0.42500 |  0    | -2*pi .. 2*pi |
    | J3    | q     | 0        | -0.39225 |  0    | -2*pi .. 2*pi |
    | J4    | q     | 0.10915  |  0       |  pi/2 | -2*pi .. 2*pi |
    | J5    | q     | 0.09465  |  0       | -pi/2 | -2*pi .. 2*pi |
    | J6    | q     | 0.0823   |  0       |  0    | -2*pi .. 2*pi |

    check [0, 0, 0, 0, 0, 0] => (-0.81725, -0.19145, -0.005191) zyx(0, 0, pi/2);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (-0.4969628644179, -0.3338709282436, 0.4549593001607) zyx(1.650517475489, -0.9171860705708, 0.5918474410747);
}
