//! The elbow arm with a spherical wrist of seed 003: E. Mozhegova, "Fundamentals of Robotics: Assignment
//! 2".
//!
//! The chain of section 2 with the `Ry(90) Rz(90)` that section 3.1 uses and section 2 forgets (without
//! it joint 4 would be parallel to joints 2 and 3), l1 = 0.3, l2 = 1, l3 + l4 = 0.8 as in the printed
//! wrist position, l5 = l6 = 0 as in the printed ³R₆.

use kin_runtime::prelude::*;

dh! {
    /// The elbow arm with a spherical wrist of seed 003.
    pub struct ElbowWrist(chain, m, deg);

    let l1 = 0.3; let l2 = 1; let l3 = 0.5; let l4 = 0.3;

    Rz(q) Tz(l1) Rz(90) Rx(90)  Rz(q) Tx(l2)  Rz(q) Tx(l3) Ry(90) Rz(90)
    Rz(q) Tz(l4) Rx(-90) Rz(-180)  Rz(q) Rx(-90)  Rz(q);

    check [0, 0, 0, 0, 0, 0] => (0, 1.8, 0.3) zyx(90, 90, 0);
    check [20, -50, 35, 70, -40, 25] =>
        (-0.4841391820324, 1.330161470507, -0.673099679201) zyx(-126.8061030403, -17.75900071631, 115.5417193929);
}
