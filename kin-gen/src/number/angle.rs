//! Constant angles, whose multiples of π stay exact.

use super::real::turned;
use super::{Ratio, Real, Scalar};

/// The constant angle `pi · π + rad`, in radians.
///
/// As π is irrational, an angle with an exact radian part is written in one way only. The order is by `pi`, then by
/// `rad`: one to sort and look up by, not that of the values.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Angle {
    /// The exact multiple of π.
    pub pi: Ratio,
    /// What is added to it, in radians.
    pub rad: Scalar,
}

#[expect(clippy::should_implement_trait, reason = "the operations are checked, which operators cannot be")]
impl Angle {
    /// No angle.
    pub const fn zero() -> Angle {
        Angle { pi: Ratio::ZERO, rad: Scalar::zero() }
    }

    /// An angle in degrees. One with so many digits that its 180th part does not fit a ratio is kept in radians to
    /// 256 bits.
    pub fn from_degrees(degrees: Ratio) -> Angle {
        match degrees.checked_div(Ratio::integer(180)) {
            Some(pi) => Angle::from_pi(pi),
            None => {
                Angle::from_rad(Scalar::from(Real::from_ratio(degrees) * Real::pi() / Real::from_i64(180)))
            }
        }
    }

    /// A multiple of π.
    pub const fn from_pi(pi: Ratio) -> Angle {
        Angle { pi, rad: Scalar::zero() }
    }

    /// An angle in radians.
    pub const fn from_rad(rad: Scalar) -> Angle {
        Angle { pi: Ratio::ZERO, rad }
    }

    /// The sum; `None` if a part does not fit.
    pub fn add(self, other: Angle) -> Option<Angle> {
        Some(Angle { pi: self.pi.checked_add(other.pi)?, rad: self.rad.add(other.rad)? })
    }

    /// The difference; `None` if a part does not fit.
    pub fn sub(self, other: Angle) -> Option<Angle> {
        self.add(other.neg())
    }

    /// The same angle the other way round.
    pub fn neg(self) -> Angle {
        Angle { pi: self.pi.neg(), rad: self.rad.neg() }
    }

    /// So many times the angle; `None` if a part does not fit.
    pub fn times(self, count: i64) -> Option<Angle> {
        Some(Angle {
            pi: self.pi.checked_mul(Ratio::integer(count))?,
            rad: self.rad.mul(Scalar::from(count))?,
        })
    }

    /// Whether this is no angle at all; a full turn is one.
    pub fn is_zero(self) -> bool {
        self.pi.is_zero() && self.rad.is_zero()
    }

    /// The number of quarter turns, 0 to 3, if the angle is a whole number of them but for full turns.
    pub fn quarters(self) -> Option<i8> {
        if !self.rad.is_zero() {
            return None;
        }
        match self.pi.den() {
            1 => Some(2 * self.pi.num().rem_euclid(2) as i8),
            2 => Some(self.pi.num().rem_euclid(4) as i8),
            _ => None,
        }
    }

    /// The same direction with the multiple of π within (−1, 1]; the radian part stays.
    pub fn reduced(self) -> Angle {
        let (num, den) = (self.pi.num(), self.pi.den());
        let (turns, rest) = (num / den, num % den);
        let rest = match (turns % 2 == 0, rest) {
            (true, rest) => rest,
            (false, 0) => den,
            (false, rest) => rest - den * rest.signum(),
        };
        // A whole number taken away leaves a ratio in its lowest terms.
        Angle { pi: Ratio::new(rest, den).unwrap_or(self.pi), rad: self.rad }
    }

    /// Sine and cosine: exact for whole quarter turns, and of the same bits for angles that mirror each other in an
    /// axis or a diagonal, such as sin 50° and cos 40°.
    pub fn sin_cos(self) -> (Real, Real) {
        let (quarters, rest) = self.reduced().nearest_quarter();
        let size = rest.pi.abs();
        let (sine, cosine) = match (rest.rad.is_zero(), size.num(), size.den()) {
            (true, 0, _) => (Real::ZERO, Real::ONE),
            (true, 1, 4) => (root_of_quarters(2), root_of_quarters(2)),
            (true, 1, 6) => (root_of_quarters(1), root_of_quarters(3)),
            _ => return turned(quarters, rest.to_real().sin_cos()),
        };
        turned(quarters, (if rest.pi.signum() < 0 { -sine } else { sine }, cosine))
    }

    /// The nearest whole number of quarter turns to the multiple of π, which is reduced, and the rest.
    fn nearest_quarter(self) -> (u64, Angle) {
        let eighth = |count| Ratio::new(count, 4).is_some_and(|bound| self.pi.abs() > bound);
        let size = eighth(1) as i128 + eighth(3) as i128;
        let count = size * self.pi.signum() as i128;
        // Where the rest does not fit a ratio, the real numbers find the quarter by themselves.
        match Ratio::new(count, 2).and_then(|quarters| self.pi.checked_sub(quarters)) {
            Some(pi) => (count as u64, Angle { pi, rad: self.rad }),
            None => (0, self),
        }
    }

    /// The value in radians, not reduced, to 256 bits however much of the two parts cancels.
    pub fn to_real(self) -> Real {
        let (num, den) = (Real::from_i128(self.pi.num()), Real::from_i128(self.pi.den()));
        match self.rad {
            // Products of two numbers of 127 bits are exact; so the sum is one of exact numbers.
            Scalar::Exact(rad) => {
                let (a, b) = (Real::from_i128(rad.num()), Real::from_i128(rad.den()));
                Real::pi_times_plus(num * b, a * den) / (den * b)
            }
            Scalar::Real(rad) => Real::pi_times_plus(num, rad * den) / den,
        }
    }

    /// The nearest double to the value in radians, not reduced.
    pub fn to_f64(self) -> f64 {
        self.to_real().to_f64()
    }
}

/// `√(n/4)`, correctly rounded.
fn root_of_quarters(count: i128) -> Real {
    Ratio::new(count, 4).map_or(Real::ZERO, |square| Real::from_ratio(square).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(value: i64) -> Real {
        Real::from_i64(value)
    }

    fn ratio(num: i128, den: i128) -> Ratio {
        Ratio::new(num, den).unwrap()
    }

    fn exact(num: i128, den: i128) -> Scalar {
        Scalar::Exact(ratio(num, den))
    }

    #[test]
    fn quarter_turns_are_known() {
        let degrees = |value| Angle::from_degrees(Ratio::integer(value));
        for (value, quarters) in
            [(0, 0), (90, 1), (180, 2), (270, 3), (360, 0), (-90, 3), (-180, 2), (-450, 3), (990, 3)]
        {
            assert_eq!(degrees(value).quarters(), Some(quarters), "{value}°");
            let (sine, cosine) = degrees(value).sin_cos();
            let table = [(0, 1), (1, 0), (0, -1), (-1, 0)][quarters as usize];
            assert_eq!((sine, cosine), (whole(table.0), whole(table.1)), "{value}°");
        }
        assert_eq!(degrees(45).quarters(), None);
        assert_eq!(Angle::from_pi(ratio(i128::MAX, 2)).quarters(), Some(3));
        assert_eq!(Angle::from_rad(Scalar::one()).quarters(), None);
        assert_eq!(Angle::from_rad(Scalar::Real(Real::from_f64(1e-60).unwrap())).quarters(), Some(0));
    }

    #[test]
    fn angles_are_reduced_to_the_half_open_turn() {
        let max = i128::MAX;
        for (pi, reduced) in [
            (ratio(1, 1), ratio(1, 1)),
            (ratio(-1, 1), ratio(1, 1)),
            (ratio(3, 2), ratio(-1, 2)),
            (ratio(-3, 2), ratio(1, 2)),
            (ratio(2, 1), Ratio::ZERO),
            (ratio(-7, 3), ratio(-1, 3)),
            (ratio(7, 2), ratio(-1, 2)),
            (ratio(max, 1), Ratio::ONE),
            (ratio(1 - max, 1), Ratio::ZERO),
            (ratio(max, max - 1), ratio(2 - max, max - 1)),
            (ratio(-max, max - 1), ratio(max - 2, max - 1)),
            (ratio(1 - max, max), ratio(1 - max, max)),
        ] {
            let rad = exact(1, 7);
            assert_eq!(Angle { pi, rad }.reduced(), Angle { pi: reduced, rad }, "{pi}");
        }
    }

    #[test]
    fn angles_add_and_compare_exactly() {
        let third = Angle::from_degrees(Ratio::integer(60));
        assert_eq!(third.times(3), Some(Angle::from_pi(Ratio::ONE)));
        assert_eq!(third.sub(third), Some(Angle::zero()));
        assert_eq!(third.add(third.neg()).map(Angle::is_zero), Some(true));
        assert_eq!(Angle::from_pi(ratio(i128::MAX, 1)).times(2), None);
        assert_eq!(Angle::default(), Angle::zero());
        assert!(!Angle::from_degrees(Ratio::integer(360)).is_zero());
        let mut keys = [third.neg(), Angle::from_rad(Scalar::one()), third, Angle::zero()];
        keys.sort();
        assert_eq!(keys, [third.neg(), Angle::zero(), Angle::from_rad(Scalar::one()), third]);
        // 180 does not divide it within the range: radians then, as near as can be.
        let long = ratio(i128::MAX, 1 << 122);
        let expected = Real::from_ratio(long) * Real::pi() / whole(180);
        assert_eq!(Angle::from_degrees(long).to_real(), expected);
        assert_eq!(Angle::from_degrees(Ratio::integer(90)).to_f64(), std::f64::consts::FRAC_PI_2);
        assert_eq!(Angle::from_degrees(Ratio::integer(720)).to_f64(), 4.0 * std::f64::consts::PI);
    }

    #[test]
    fn mirrored_angles_have_the_same_bits() {
        let sin_cos = |degrees: i128| Angle::from_degrees(ratio(degrees, 10)).sin_cos();
        for tenths in -1800..=1800 {
            let (sine, cosine) = sin_cos(tenths);
            assert_eq!(sin_cos(-tenths), (-sine, cosine));
            assert_eq!(sin_cos(1800 - tenths), (sine, -cosine));
            assert_eq!(sin_cos(900 - tenths), (cosine, sine));
            assert!((sine * sine + cosine * cosine - Real::ONE).is_negligible());
        }
        let half = Real::ONE / whole(2);
        assert_eq!(
            (sin_cos(300).0, sin_cos(600).1, sin_cos(1500).0, sin_cos(-1200).1),
            (half, half, half, -half)
        );
        assert_eq!(sin_cos(450).0, sin_cos(450).1);
    }
}
