//! The number that every target must compute; `tests/no-std/bits.sh` computes it on the others.

use tests::bits::aimed::{AIMED, hash_aimed};
use tests::bits::{POSES, QUICK, hash};

/// The hashes of the file: quick, all, aimed.
const GOLDEN: &str = include_str!("../no-std/golden.txt");

#[test]
fn this_host_has_the_same_bits() {
    let found = [hash(QUICK), hash(POSES), hash_aimed(AIMED)].map(|hash| format!("{hash:016x}"));
    assert_eq!(
        found.join(" "),
        GOLDEN.trim(),
        "results have changed; if that is meant, these are the new numbers of tests/no-std/golden.txt"
    );
}
