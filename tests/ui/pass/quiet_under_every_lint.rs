//! Generated code does not trip its user's lints.
#![deny(warnings, missing_docs, missing_debug_implementations, missing_copy_implementations, rust_2018_idioms)]
#![deny(unused, unused_qualifications, unreachable_pub, single_use_lifetimes, trivial_casts, let_underscore_drop)]
#![deny(variant_size_differences, unused_results, non_ascii_idents, unsafe_code)]

use kin_runtime::prelude::*;

dh! {
    /// Unimation Puma 560.
    pub struct Puma(standard, m, deg);
    | joint | alpha |   a    |    d    | theta | limits      |
    | J1    |  90   | 0      | 26.45in | q     | -160 .. 160 |
    | J2    |   0   | 0.4318 | 0       | q     |  -45 .. 225 |
    | J3    | -90   | 0.0203 | 0.15005 | q     | -225 ..  45 |
    | J4    |  90   | 0      | 0.4318  | q     | -110 .. 170 |
    | J5    | -90   | 0      | 0       | q     | -100 .. 100 |
    | J6    |   0   | 0      | 0       | q     | -266 .. 266 |
}

dh! {
    /// Its private brother, of which nothing is used, with a parameter.
    struct Tooled(standard, m, deg);
    param flange = 0.1;
    | joint | alpha |   a    |    d    | theta |
    | J1    |  90   | 0      | 26.45in | q     |
    | J2    |   0   | 0.4318 | 0       | q     |
    | J3    | -90   | 0.0203 | 0.15005 | q     |
    | J4    |  90   | 0      | 0.4318  | q     |
    | J5    | -90   | 0      | 0       | q     |
    | J6    |   0   | 0      | flange  | q     |
}

dh! {
    /// A private arm without an inverse, whose place is taken by a sentence.
    struct Ur(standard, m, deg);
    | joint | alpha | a        | d        | theta |
    | J1    |  90   | 0        | 0.089159 | q     |
    | J2    |   0   | -0.425   | 0        | q     |
    | J3    |   0   | -0.39225 | 0        | q     |
    | J4    |  90   | 0        | 0.10915  | q     |
    | J5    | -90   | 0        | 0.09465  | q     |
    | J6    |   0   | 0        | 0.0823   | q     |
}

fn main() {
    assert!(Ur.reach() > 1.0);
    let pose = Puma.fk(&joints![0.1, -0.4, 0.2, 0.3, 0.9, -0.5]);
    assert!(Puma.ik(&pose).iter().count() > 0);
    assert_eq!(Tooled::default(), Tooled { flange: 0.1 });
}
