//! Seven joints have infinitely many inverse solutions; the loop over them adds nothing to the message.
use kin_runtime::prelude::*;

dh! {
    pub struct Seven(standard, m, deg);
    | joint | alpha | a | d   | theta |
    | J1    | -90   | 0 | 0.3 | q     |
    | J2    |  90   | 0 | 0   | q     |
    | J3    |  90   | 0 | 0.4 | q     |
    | J4    | -90   | 0 | 0   | q     |
    | J5    | -90   | 0 | 0.4 | q     |
    | J6    |  90   | 0 | 0   | q     |
    | J7    |   0   | 0 | 0.1 | q     |
}

fn main() {
    let pose = Seven.fk(&joints![0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
    for solution in Seven.ik(&pose).iter() {
        println!("{:?}", solution.q);
    }
}
