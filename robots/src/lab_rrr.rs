//! The three-joint arm of seed 004, "Laboratory 1: Forward and Inverse Kinematics": the table of its
//! preparation.
//!
//! d = 0.168 and l = 0.13335 metres, as on its page of parameter values; the "final" table of the report
//! lost d. The first pose is the report's own test, for_kin([0.5, 0.5, -0.5]), printed there to five
//! decimals.

use kin_runtime::prelude::*;

dh! {
    /// The three-joint arm of seed 004.
    pub struct LabRrr(standard, m, rad);

    let d = 0.168; let l = 0.13335;

    | i | a_i | alpha_i | d_i | theta_i |
    |---|-----|---------|-----|---------|
    | 1 | 0   | pi/2    | d   | q1      |
    | 2 | l   | 0       | 0   | q2      |
    | 3 | l   | 0       | 0   | q3      |

    check [0.5, 0.5, -0.5] => (0.21973, 0.12004, 0.23193) within 1e-5;
    check [0, 0, 0] => (0.2667, 0, 0.168) zyx(0, 0, pi/2);
    check [0.3, -0.8, 0.6] => (0.213611058744, 0.06607764378702, 0.04584801001703) zyx(0.3, 0.2, pi/2);
}
