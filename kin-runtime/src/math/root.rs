//! Square roots, correctly rounded: by the processor's instruction where there is one.
//!
//! On several processors libm writes that instruction out in assembly: one number at a time, and on x86-64 in a form that costs a
//! hundred times as much among the wider instructions of x86-64-v3. With the feature `std` compilers see a root, and have several
//! side by side.

#[cfg(not(all(feature = "std", any(unix, windows))))]
pub(super) use libm::{sqrt as double, sqrtf as single};

/// The square root of a double.
#[cfg(all(feature = "std", any(unix, windows)))]
#[inline(always)]
pub(super) fn double(x: f64) -> f64 {
    pulp::Simd::sqrt_f64s(pulp::Scalar::new(), x)
}

/// The square root of a single.
#[cfg(all(feature = "std", any(unix, windows)))]
#[inline(always)]
pub(super) fn single(x: f32) -> f32 {
    pulp::Simd::sqrt_f32s(pulp::Scalar::new(), x)
}

/// Whether compilers see a root, so that a loop with one can become a loop over vectors.
pub(crate) const VISIBLE: bool = cfg!(all(feature = "std", any(unix, windows)));
