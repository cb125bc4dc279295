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
    /// Whether this is a lane of a batch, alone in a loop over the lanes: compilers make vectors of such a loop if there is
    /// no branch in it.
    pub(crate) const ALONE: bool = L == 1;

    /// The sines and cosines of these angles, as [`Real::sin_cos`]; where the lane is alone, as
    /// [`Float::sin_cos_straight`].
    #[inline(always)]
    pub(crate) fn turned(self) -> [Self; 2] {
        if Self::ALONE {
            let (mut sine, mut cosine) = (self, self);
            for (sine, cosine) in sine.0.iter_mut().zip(&mut cosine.0) {
                (*sine, *cosine) = T::sin_cos_straight(*sine);
            }
            return [sine, cosine];
        }
        let (sines, cosines) = T::sin_cos_all(self.0);
        [Lanes(sines), Lanes(cosines)]
    }

    /// The angles of the plane vectors (x, y), as [`Float::atan2`]; where the lane is alone, as [`Float::atan2_straight`].
    #[inline(always)]
    pub(crate) fn directed(y: Self, x: Self) -> Self {
        if !Self::ALONE {
            return Self::atan2(y, x);
        }
        let mut angle = y;
        for (angle, x) in angle.0.iter_mut().zip(x.0) {
            *angle = T::atan2_straight(*angle, x);
        }
        angle
    }

    /// The angles of the plane vectors (x, y), as [`Float::atan2`].
    #[inline(always)]
    pub fn atan2(y: Self, x: Self) -> Self {
        Lanes(T::atan2_all(y.0, x.0))
    }

    /// The angles of two lots of plane vectors, in less time than one after the other where both fit side by side.
    #[inline(always)]
    pub(crate) fn directed_both(
        [Lanes(a), Lanes(b)]: [Self; 2],
        [Lanes(c), Lanes(d)]: [Self; 2],
    ) -> [Self; 2] {
        if Self::ALONE {
            return [Self::directed(Lanes(a), Lanes(c)), Self::directed(Lanes(b), Lanes(d))];
        }
        let (mut angles, x) = ([a, b], [c, d]);
        T::atan2_each(angles.as_flattened_mut(), x.as_flattened());
        angles.map(Lanes)
    }

    /// Several lots of angles in (-π, π], as [`wrap`](super::wrap): mostly they are, and one look is enough.
    #[inline(always)]
    pub fn wrap_all<const K: usize>(mut angles: [Self; K]) -> [Self; K] {
        let mut most = Lanes::splat(T::lit(0.0));
        for angle in &angles {
            most = most.greatest(angle.abs());
        }
        let (mut inside, half) = (true, super::half_turn());
        for most in most.0 {
            inside &= most < half;
        }
        if !inside {
            for angle in &mut angles {
                *angle = angle.wrap();
            }
        }
        angles
    }

    /// The same angles in (-π, π], as [`wrap`](super::wrap).
    #[inline(always)]
    pub fn wrap(self) -> Self {
        Lanes(super::wrap_all(self.0))
    }

    /// The lesser of two numbers, lane by lane; the second where they have no order.
    #[inline(always)]
    pub fn least(mut self, other: Self) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = super::min(*x, y);
        }
        self
    }

    /// The absolute values.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(super::abs)
    }

    /// The greater of two numbers, lane by lane; the second where they have no order.
    #[inline(always)]
    pub fn greatest(mut self, other: Self) -> Self {
        for (x, y) in self.0.iter_mut().zip(other.0) {
            *x = super::max(*x, y);
        }
        self
    }

    /// 1 where something does not hold, 0 where it does: a number, of which compilers make vectors.
    #[inline(always)]
    pub(crate) fn unless(self, holds: impl Fn(T) -> bool) -> Self {
        self.map(
            #[inline(always)]
            |x| if holds(x) { T::lit(0.0) } else { T::lit(1.0) },
        )
    }

    /// What a function makes of each lane.
    #[inline(always)]
    pub fn map(mut self, f: impl Fn(T) -> T) -> Self {
        for x in &mut self.0 {
            *x = f(*x);
        }
        self
    }

    /// One of the lanes; zero where there is none of that number.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> T {
        self.0.get(lane).copied().unwrap_or_else(|| T::lit(0.0))
    }

    /// One of the lanes alone; zero where there is none of that number.
    #[inline(always)]
    pub(crate) fn one(&self, lane: usize) -> Lanes<T, 1> {
        Lanes([self.lane(lane)])
    }

    /// Whether no lane is less or greater than the other's: of numbers, that they are the same.
    #[inline(always)]
    pub(crate) fn is(&self, other: Self) -> bool {
        // And not `==`, which compilers know of the same number only where it is known to be one.
        self.0.iter().zip(&other.0).all(|(x, y)| {
            let (less, greater) = (x < y, x > y);
            !(less | greater)
        })
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
