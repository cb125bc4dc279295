//! For which instructions a batch is compiled, and which of them the machine has.
//!
//! The loops are the same in all of them, over plain arrays; compilers make vectors of those, as wide as they may. Nothing is
//! contracted to fused multiply-additions, though the machines that are asked for have them: the bits are the same.

use super::run::Work;

/// Sets of instructions that batches are compiled for, the narrowest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum Instructions {
    /// Those of the rest of the program.
    Baseline,
    /// x86-64-v3: AVX2, four doubles in a register. With the feature `std`.
    Avx2,
    /// x86-64-v4: AVX-512, eight doubles in a register. With the feature `std`.
    Avx512,
}

impl Instructions {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];
    pub(super) const WIDEST: Self = Self::Avx512;

    /// Whether this machine has them, and this build asks it.
    pub fn are_here(self) -> bool {
        match self {
            Instructions::Baseline => true,
            #[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
            Instructions::Avx2 => pulp::x86::V3::try_new().is_some(),
            #[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
            Instructions::Avx512 => pulp::x86::V4::try_new().is_some(),
            #[cfg(not(all(feature = "std", target_arch = "x86_64", any(unix, windows))))]
            Instructions::Avx2 | Instructions::Avx512 => false,
        }
    }
}

/// Does the work with the widest instructions that are here.
pub(super) fn run(work: impl Work, at_most: Instructions) {
    #[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
    {
        use pulp::Simd;
        use pulp::x86::{V3, V4};
        if at_most >= Instructions::Avx512
            && let Some(wide) = V4::try_new()
        {
            return Simd::vectorize(wide, Compiled(work));
        }
        if at_most >= Instructions::Avx2
            && let Some(wide) = V3::try_new()
        {
            return Simd::vectorize(wide, Compiled(work));
        }
    }
    #[cfg(not(all(feature = "std", target_arch = "x86_64", any(unix, windows))))]
    let _ = at_most;
    work.run();
}

/// Work that pulp compiles for a set of instructions.
#[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
struct Compiled<W>(W);

#[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
impl<W: Work> pulp::WithSimd for Compiled<W> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.0.run();
    }
}
