//! An arm may have the name of something in the prelude, its joints and parameters too.
use kin_runtime::prelude::*;

dh! {
    /// An arm called arm.
    pub struct Arm(standard, m, deg);
    param data = 0.1;
    | joint | alpha |  a   | d     | theta |
    | fk    |  90   | 0    | 0.168 | q     |
    | self_ |  0    | 0.13 | 0     | q     |
    | T     |  0    | data | 0     | q     |
}

dh! {
    /// A pose.
    struct Pose(chain, mm, rad);
    let s1 = 3; let c23 = 4; let q_ = 5;
    Rz(q) Tz(s1)  Rz(q) Tx(c23)  Rz(q) Tx(q_);
}

fn main() {
    let q = joints![0.0, 0.0, 0.0];
    assert_eq!(Arm::default().ik_position(&Arm::default().fk(&q).translation.vector.into()).iter().count(), 2);
    assert_eq!(Pose.fk(&q).translation.vector.x, 9.0);
}
