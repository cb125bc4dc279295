//! The number that every target must compute; `tests/no-std/bits.sh` computes it on the others.

use tests::bits::aimed::{AIMED, hash_aimed};
use tests::bits::{POSES, QUICK, hash};

/// The hashes of the file: quick, all, aimed.
const GOLDEN: &str = include_str!("../no-std/golden.txt");

/// The hashes that the file has in these places are those that are computed here.
fn same(places: std::ops::Range<usize>, found: &[u64]) {
    let golden: Vec<_> = GOLDEN.split_whitespace().collect();
    let found: Vec<_> = found.iter().map(|hash| format!("{hash:016x}")).collect();
    assert_eq!(
        found, golden[places],
        "results have changed; if that is meant, these are the new numbers of tests/no-std/golden.txt"
    );
}

#[test]
fn this_host_has_the_same_bits() {
    same(0..2, &[hash(QUICK), hash(POSES)]);
}

#[test]
fn this_host_has_the_same_bits_at_singular_poses() {
    same(2..3, &[hash_aimed(AIMED)]);
}
