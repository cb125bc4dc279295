//! Exports `hash` and `aimed`, the numbers that every target must have.

#[allow(dead_code, reason = "the short figure is for interpreters")]
#[path = "../../../src/bits/mod.rs"]
mod bits;

/// The hash of all poses.
#[unsafe(no_mangle)]
pub extern "C" fn hash() -> u64 {
    bits::hash(bits::POSES)
}

/// The hash of poses aimed at singular sets.
#[unsafe(no_mangle)]
pub extern "C" fn aimed() -> u64 {
    bits::aimed::hash_aimed(bits::aimed::AIMED)
}
