//! The Stanford arm of V. Scheinman: two turning joints, a slide, and a spherical wrist.
//!
//! Table and limits: `roboticstoolbox/models/DH/Stanford.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a. The toolbox names "Modelling,
//! trajectory calculation and servoing of a computer controlled arm", Stanford AIM-177, figure 2.3. q3 is
//! the extension of the slide in metres.

use kin_runtime::prelude::*;

dh! {
    /// The Stanford arm.
    pub struct Stanford(standard, m, deg);

    | joint | theta | d     | a      | alpha | limits       |
    |-------|-------|-------|--------|-------|--------------|
    | J1    | q     | 0.412 | 0      | -90   | -170 ..  170 |
    | J2    | q     | 0.154 | 0      |  90   | -170 ..  170 |
    | J3    | -90   | q     | 0.0203 |  0    | 12in .. 50in |
    | J4    | q     | 0     | 0      | -90   | -170 ..  170 |
    | J5    | q     | 0     | 0      |  90   |  -90 ..   90 |
    | J6    | q     | 0     | 0      |  0    | -170 ..  170 |

    check [0, 0, 0.5, 0, 0, 0] => (0, 0.1337, 0.912) zyx(-90, 0, 0);
    check [20, -50, 0.8, 70, -40, 25] =>
        (-0.621605141477, -0.08396520078443, 0.9262300877492) zyx(87.5436090139, -80.05062889864, -80.10335295459);
}
