//! Operations of the derived programs beside the best of other generators: what `cargo run --release -p tests --bin counts`
//! prints, of the six arms that all were measured with.

use std::fmt::Write;
use tests::measured::{self, ARMS};

/// A line for each arm and program.
pub(crate) fn table() -> String {
    let mut text = String::from(
        "Multiplications/additions; sines and cosines, as `cargo run --release -p tests --bin counts` has them. The fewest of \
         others are those of sympy, SymForce, CasADi, SYMORO+, SymPyBotics and Pinocchio; what was aimed for is proved minimal \
         or the best that was known.\n\n\
         | arm | program | this library | aimed for | fewest of others |\n|---|---|---|---|---|\n",
    );
    for measured in &ARMS {
        let arm = measured::derived(measured.table);
        let peers = measured.peers.iter().map(|[mul, add]| format!("{mul}/{add}"));
        let mut peers = peers.chain(std::iter::repeat("–".to_owned()));
        for (program, (name, [mul, add, trig])) in measured::programs(&arm).iter().zip(measured.promised) {
            assert_eq!(program.name, *name, "the same order");
            let (cost, peer) = (program.cost(), peers.next().unwrap_or_default());
            let (arm, ours) = (&arm.name, format!("{}/{};{}", cost.mul, cost.add, cost.trig));
            let _ = writeln!(text, "| {arm} | {name} | {ours} | {mul}/{add};{trig} | {peer} |");
        }
    }
    text
}
