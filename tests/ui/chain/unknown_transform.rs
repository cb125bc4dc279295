//! The chain form knows six transforms.
use kin_runtime::prelude::*;

dh! {
    pub struct Lab(chain, m, deg);
    Rz(q) Tz(0.168) Rx(90)  Rz(q) Tw(0.135)  Rz(q) Tx(0.135);
}

fn main() {
    let _ = Lab.fk(&joints![0.1, 0.2, 0.3]);
}
