//! Exports `hash`, the number that every target must have.

#[path = "../../../src/bits.rs"]
mod bits;

/// The hash of all poses.
#[unsafe(no_mangle)]
pub extern "C" fn hash() -> u64 {
    bits::hash(bits::POSES)
}

/// The hash of the first few.
#[unsafe(no_mangle)]
pub extern "C" fn quick() -> u64 {
    bits::hash(bits::QUICK)
}
