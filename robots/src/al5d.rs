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

    check [0, 0, 0] => (0, 0.221909640813858, 0.0718750114933824) within 1e-12;
    check [0.5, 0.3, -0.4] => (0.0935337619631028, 0.171212402839035, 0.164161411579249) within 1e-12;
}
