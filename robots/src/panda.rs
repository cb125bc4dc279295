//! Franka Emika Panda, seven axes, with its hand: the tool frame stands 103 mm beyond the flange.
//!
//! Table and limits: `roboticstoolbox/models/DH/Panda.py` of Robotics Toolbox for Python,
//! <https://github.com/petercorke/robotics-toolbox-python> at a9ed8d45e92a.

use kin_runtime::prelude::*;

dh! {
    /// Franka Emika Panda with its hand.
    pub struct Panda(modified, m, rad);

    | joint | alpha | a       | d     | theta | limits             |
    |-------|-------|---------|-------|-------|--------------------|
    | J1    |  0    |  0      | 0.333 | q     | -2.8973 ..  2.8973 |
    | J2    | -pi/2 |  0      | 0     | q     | -1.7628 ..  1.7628 |
    | J3    |  pi/2 |  0      | 0.316 | q     | -2.8973 ..  2.8973 |
    | J4    |  pi/2 |  0.0825 | 0     | q     | -3.0718 .. -0.0698 |
    | J5    | -pi/2 | -0.0825 | 0.384 | q     | -2.8973 ..  2.8973 |
    | J6    |  pi/2 |  0      | 0     | q     | -0.0175 ..  3.7525 |
    | J7    |  pi/2 |  0.088  | 0.107 | q     | -2.8973 ..  2.8973 |

    tool: Tz(0.103) Rz(-pi/4);

    check [0, 0, 0, 0, 0, 0, 0] => (0.088, 0, 0.823) zyx(pi/4, 0, pi);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4, 0.5] =>
        (-0.2849171054308, -0.2371632095416, 0.6343038696769) zyx(-2.359661268614, -0.9735724627932, -0.05637812500294);
}
