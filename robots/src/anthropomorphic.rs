//! The anthropomorphic arm with a y-z-y wrist of seed 001, as the chain that the report prints.
//!
//! The report prints no lengths. With d1 = 1, d2 = 3, d3 = 1, d4 = 1 and d5 = 1 the arm can reach the
//! point (4, 0, 0) of its figure 3, where its own inverse failed. [`Seed001Yzy`](crate::Seed001Yzy) reads
//! the same report with other lengths.

use kin_runtime::prelude::*;

dh! {
    /// The anthropomorphic arm of seed 001.
    pub struct Anthropomorphic(chain, m, rad);

    let d1 = 1; let d2 = 3; let d3 = 1; let d4 = 1; let d5 = 1;

    Rz(q) Tz(d1)  Rx(q) Ty(d2)  Rx(q) Ty(d3)  Ry(q) Ty(d4)  Rz(q) Ty(d5)  Ry(q);

    check [0, 0, 0, 0, 0, 0] => (0, 6, 1) zyx(0, 0, 0);
    check [0.3, -0.8, 0.6, 1.1, -0.7, 0.4] =>
        (-1.105581495018, 4.562858842754, -2.2640447577) zyx(-1.307885937467, 0.7349435732537, -1.29901544576);
}
