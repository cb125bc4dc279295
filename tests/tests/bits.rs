//! The number that every target must compute; `tests/no-std/bits.sh` computes it on the others.

use tests::bits::{POSES, QUICK, hash};

/// The hashes of the file, `quick` and `all`.
const GOLDEN: &str = include_str!("../no-std/golden.txt");

#[test]
fn this_host_has_the_same_bits() {
    let (quick, all) = GOLDEN.trim().split_once(' ').expect("two hashes");
    let found = (format!("{:016x}", hash(QUICK)), format!("{:016x}", hash(POSES)));
    assert_eq!(
        (found.0.as_str(), found.1.as_str()),
        (quick, all),
        "results have changed; if that is meant, these are the new numbers of tests/no-std/golden.txt"
    );
}
