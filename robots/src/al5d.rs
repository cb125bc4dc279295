//! Lynxmotion AL5D, without its wrist.
//!
//! github:petercorke/robotics-toolbox-python@a9ed8d45e92a: src/roboticstoolbox/models/DH/AL5D.py, its first three rows.

use kin_runtime::prelude::*;

dh! {
    /// A hobby arm: waist, shoulder, elbow.
    pub struct Al5d(modified, m, rad);

    | joint | alpha | a       | d        | theta      | limits         |
    |-------|-------|---------|----------|------------|----------------|
    | J1    | pi    | 0       | -0.06858 | q + pi/2   | -pi/2 .. pi/2  |
    | J2    | pi/2  | 0.002   | 0        | q + pi     | -pi/2 .. pi/2  |
    | J3    | pi    | 0.14679 | 0        | q - 0.0427 | -pi/2 .. pi/2  |

    tool: Tx(0.07719);
}
