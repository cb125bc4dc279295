//! What the solvers are judged by, without the rest of the workspace: a change to them is tested in a minute or two.
//!
//! These are tests of the `tests` member, which needs every arm to be built first, with the few arms that they ask for. There
//! they are run with all others, and so not here unless this target is named: `cargo test -p kin-runtime --test solvers`.

#![allow(unreachable_pub, reason = "these files are crates and modules elsewhere")]

extern crate self as robots;
extern crate self as tests;

#[path = "../../tests/src/bits/mod.rs"]
#[allow(dead_code, reason = "written for other targets too")]
pub mod bits;
#[path = "../../tests/src/sample.rs"]
#[allow(dead_code, reason = "written for other tests too")]
pub mod sample;
/// What is asked of the scorer.
pub mod score {
    use std::f64::consts::{PI, TAU};

    /// An angle brought into (-π, π].
    pub fn wrap(angle: f64) -> f64 {
        let turned = (angle + PI) % TAU;
        if turned <= 0.0 { turned + PI } else { turned - PI }
    }
}
#[path = "../../tests/src/skew.rs"]
pub mod skew;

/// The arms, under their names in `robots`.
macro_rules! arms {
    ($($Arm:ident $path:literal $file:ident;)*) => {
        $(#[path = $path] mod $file; pub use $file::$Arm;)*
    };
}

arms! {
    Al5d "../../robots/src/al5d.rs" al5d;
    Cobra600 "../../robots/src/cobra600.rs" cobra600;
    ElbowWrist "../../robots/src/elbow_wrist.rs" elbow_wrist;
    Irb2400 "../../robots/src/irb2400.rs" irb2400;
    Kr6R700 "../../robots/src/kr6r700.rs" kr6r700;
    LabArm "../../robots/src/lab_arm.rs" lab_arm;
    LabRrr "../../robots/src/lab_rrr.rs" lab_rrr;
    Orion5 "../../robots/src/orion5.rs" orion5;
    Planar3 "../../robots/src/planar3.rs" planar3;
    Puma560 "../../robots/src/puma560.rs" puma560;
    Stanford "../../robots/src/stanford.rs" stanford;
    TwoLink "../../robots/src/two_link.rs" two_link;
}

#[path = "../../tests/tests/bits.rs"]
mod bits_of_results;
#[path = "../../tests/tests/census.rs"]
mod census;
#[path = "../../tests/tests/choice.rs"]
mod choice;
#[path = "../../tests/tests/closest.rs"]
mod closest;
#[path = "../../tests/tests/general.rs"]
mod general;
#[path = "../../tests/tests/short.rs"]
mod short;
#[path = "../../tests/tests/track.rs"]
mod track;
