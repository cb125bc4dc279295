//! Parameters are fields, with nominal values, documentation and a `Default`; a warning can be allowed.
#![allow(deprecated)]

use kin_runtime::prelude::*;

dh! {
    /// An arm whose tool can be changed.
    #[derive(PartialOrd, Default)]
    pub struct Lab(standard, m, deg);
    param tip = 0.1;
    param lean = 5;
    | joint | alpha     |  a    | d     | theta    |
    | J1    | 1.5708rad | 0     | 0.168 | q        |
    | J2    |  0        | 0.135 | 0     | q + lean |
    | J3    |  0        | tip   | 0     | q        |
}

fn main() {
    assert_eq!(Lab::default(), Lab::NOMINAL);
    assert_eq!(Lab::NOMINAL, Lab { tip: 0.1, lean: 5.0_f64.to_radians() });
    assert!(Lab { tip: 0.2, ..Lab::NOMINAL } > Lab::NOMINAL);
    let long = Lab { tip: 0.2, lean: 0.0 };
    let pose: Pose<f64> = long.fk(&joints![0.0, 0.0, 0.0]);
    assert!((pose.translation.vector.x - 0.335).abs() < 1e-15);
}
