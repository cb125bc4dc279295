//! Many numbers as one: a [`Real`] whose operations act on each lane.
//!
//! A plain array. Compilers make vectors of it, as wide as the target has them, and every lane has the bits that its
//! number alone would have.

use super::{Float, Real};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `L` numbers side by side. `arm.fk::<Lanes<f64, 8>>(…)` is eight configurations at once, joint by joint.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lanes<T, const L: usize>(pub [T; L]);

impl<T: Copy, const L: usize> Lanes<T, L> {
    /// The same number in every lane.
    #[inline(always)]
    pub const fn splat(x: T) -> Self {
        Lanes([x; L])
    }
}

impl<T: Float, const L: usize> Lanes<T, L> {
    /// The angles of the plane vectors (x, y), as [`Float::atan2`].
    #[inline(always)]
    pub fn atan2(y: Self, x: Self) -> Self {
        Lanes(T::atan2_all(y.0, x.0))
    }

    /// The same angles in (-π, π], as [`wrap`](super::wrap).
    #[inline(always)]
    pub fn wrap(self) -> Self {
        Lanes(super::wrap_all(self.0))
    }

    /// One of the lanes; zero where there is none of that number.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> T {
        self.0.get(lane).copied().unwrap_or_else(|| T::lit(0.0))
    }

    /// Sets one of the lanes, if there is one of that number.
    #[inline(always)]
    pub fn put(&mut self, lane: usize, value: T) {
        if let Some(place) = self.0.get_mut(lane) {
            *place = value;
        }
    }
}

/// An operation of two numbers, lane by lane.
macro_rules! lanewise {
    ($($operation:ident, $method:ident, $sign:tt;)*) => {$(
        impl<T: Real, const L: usize> $operation for Lanes<T, L> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for (x, y) in self.0.iter_mut().zip(other.0) {
                    *x = *x $sign y;
                }
                self
            }
        }
    )*};
}

lanewise! { Add, add, +; Sub, sub, -; Mul, mul, *; Div, div, /; }

impl<T: Real, const L: usize> Neg for Lanes<T, L> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for x in &mut self.0 {
            *x = -*x;
        }
        self
    }
}

impl<T: Real, const L: usize> Real for Lanes<T, L> {
    #[inline(always)]
    fn lit(x: f64) -> Self {
        Lanes::splat(T::lit(x))
    }
    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for x in &mut self.0 {
            *x = Real::sqrt(*x);
        }
        self
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sines, cosines) = T::sin_cos_lanes(self.0);
        (Lanes(sines), Lanes(cosines))
    }
}

impl<T, const L: usize> From<[T; L]> for Lanes<T, L> {
    fn from(lanes: [T; L]) -> Self {
        Lanes(lanes)
    }
}
