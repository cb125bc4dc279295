//! For which instructions loops are compiled, and which of them the machine has.
//!
//! The loops are the same in all of them, over plain arrays; compilers make vectors of those, as wide as they may. Nothing is
//! contracted to fused multiply-additions, though the machines that are asked for have them: the bits are the same.

/// Sets of instructions that loops over lanes are compiled for, the narrowest first.
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
    pub(crate) const WIDEST: Self = Self::Avx512;

    /// Whether a register of theirs holds four doubles, or more.
    pub(crate) const fn are_wide(self) -> bool {
        cfg!(target_feature = "avx2") || !matches!(self, Instructions::Baseline)
    }

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

/// Does something with the widest instructions that are here, which it is told. It must be inlined all the way, to be compiled
/// for each of them.
#[inline(always)]
pub(crate) fn run<R>(task: impl FnOnce(Instructions) -> R, at_most: Instructions) -> R {
    #[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
    {
        use pulp::Simd;
        use pulp::x86::{V3, V4};
        if at_most >= Instructions::Avx512
            && let Some(wide) = V4::try_new()
        {
            return Simd::vectorize(wide, Compiled(task, Instructions::Avx512));
        }
        if at_most >= Instructions::Avx2
            && let Some(wide) = V3::try_new()
        {
            return Simd::vectorize(wide, Compiled(task, Instructions::Avx2));
        }
    }
    #[cfg(not(all(feature = "std", target_arch = "x86_64", any(unix, windows))))]
    let _ = at_most;
    task(Instructions::Baseline)
}

/// What pulp compiles for a set of instructions.
#[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
struct Compiled<F>(F, Instructions);

#[cfg(all(feature = "std", target_arch = "x86_64", any(unix, windows)))]
impl<R, F: FnOnce(Instructions) -> R> pulp::WithSimd for Compiled<F> {
    type Output = R;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> R {
        (self.0)(self.1)
    }
}
