//! Figure angles with their sines and cosines, through all that becomes of them until they are joint values.
//!
//! A figure gives the direction of an angle, and a direction of known length is sine and cosine at once. What is rounded on the
//! way to a joint value is known too: by the arctangent ([`Float::atan2_straight`]), as the joint's zero is taken off, as a turn
//! is, as two values are added. With δ the value that is given out less the angle of the direction, an angle of some ε,
//!
//! ```text
//! sin(φ + δ) = sin φ + δ·cos φ        cos(φ + δ) = cos φ - δ·sin φ
//! ```
//!
//! are to the last bits the sine and the cosine of the value that is given out: what forward kinematics of it needs, at the price
//! of two products in place of two polynomials. Without a branch, as all that loops over placements or poses.
//!
//! The differences are those of T. J. Dekker, A floating-point technique for extending the available precision, 1971, and of
//! D. E. Knuth, The Art of Computer Programming 2, 4.2.2.

use crate::math::{self, Float};

/// A figure angle in [-π, π], and what rounding has taken off it: its sine and cosine are those of the sum.
#[derive(Clone, Copy)]
pub(super) struct Figure<T> {
    pub(super) angle: T,
    pub(super) lost: T,
    pub(super) sine: T,
    pub(super) cosine: T,
}

impl<T: Float> Figure<T> {
    /// The angle of the direction (x, y); `per` is one over its length.
    #[inline(always)]
    pub(super) fn of([y, x]: [T; 2], per: T) -> Self {
        let (angle, lost) = T::atan2_straight(y, x);
        Figure { angle, lost, sine: y * per, cosine: x * per }
    }

    /// The angle of the direction (x, y), which does not point downwards and is one long but for some ε.
    #[inline(always)]
    pub(super) fn above([y, x]: [T; 2]) -> Self {
        let (angle, lost) = T::atan2_above(y, x);
        Figure { angle, lost, sine: y, cosine: x }.unit()
    }

    /// Twice the angle of the direction (x, y), which points forwards and upwards; `per` is one over the length of the direction
    /// of twice the angle, `double`.
    #[inline(always)]
    pub(super) fn twice([y, x]: [T; 2], double: [T; 2], per: T) -> Self {
        let ((angle, lost), [sine, cosine]) = (T::atan2_above(y, x), double);
        Figure { angle: angle + angle, lost: lost + lost, sine: sine * per, cosine: cosine * per }.unit()
    }

    /// The same with sine and cosine of a length that is known to some ε alone: one step of Newton's for 1/√(s² + c²) squares
    /// what is left of them.
    #[inline(always)]
    pub(super) fn unit(self) -> Self {
        let Figure { sine, cosine, .. } = self;
        let per = T::lit(1.5) - T::lit(0.5) * (sine * sine + cosine * cosine);
        Figure { sine: sine * per, cosine: cosine * per, ..self }
    }

    /// The angle the other way.
    #[inline(always)]
    pub(super) fn negated(self) -> Self {
        Figure { angle: -self.angle, lost: -self.lost, sine: -self.sine, cosine: self.cosine }
    }

    /// The angle with this sign, 1 or -1.
    #[inline(always)]
    pub(super) fn signed(self, sign: T) -> Self {
        Figure { angle: self.angle * sign, lost: self.lost * sign, sine: self.sine * sign, ..self }
    }

    /// The opposite direction.
    #[inline(always)]
    pub(super) fn opposite(self) -> Self {
        let (half, rest) = (math::half_turn::<T>(), T::TURN.1 * T::lit(0.5));
        let (half, rest) = if self.angle > T::lit(0.0) { (half, rest) } else { (-half, -rest) };
        let angle = self.angle - half;
        // Half a turn is the larger: the difference is exact.
        let lost = self.angle - (angle + half);
        Figure { angle, lost: self.lost + (lost - rest), sine: -self.sine, cosine: -self.cosine }
    }

    /// The row value of a joint with this zero.
    #[inline(always)]
    pub(super) fn row(self, zero: &Zero<T>) -> Row<T> {
        let figure = if zero.reversed { self.negated() } else { self };
        let (value, lost) = zero.value(figure.angle);
        let (sine, cosine) = zero.seen(figure.sine, figure.cosine);
        Row { value, sine, cosine }.moved(lost - figure.lost)
    }
}

/// Where a joint's figure angle is when its row value is 0.
pub(super) struct Zero<T> {
    /// The figure angle there, or less that where the figure angle falls as the row value rises.
    at: T,
    reversed: bool,
    /// What it has beyond the number, its sine and its cosine.
    rest: T,
    sine: T,
    cosine: T,
}

impl<T: Float> Zero<T> {
    /// Of an offset that is zero or more than round-off, and at most half a turn.
    #[inline(always)]
    pub(super) fn new(offset: T, reversed: bool) -> Self {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let (half, rest) = (math::half_turn::<T>(), T::TURN.1 * T::lit(0.5));
        let at = if reversed { -offset } else { offset };
        let (size, sign) = if at < zero { (-at, -one) } else { (at, one) };
        // A number that is some quarters of a turn stands for them.
        let (rest, sine, cosine) = if size == zero {
            (zero, zero, one)
        } else if size == half * T::lit(0.5) {
            (rest * T::lit(0.5), one, zero)
        } else if size == half {
            (rest, zero, -one)
        } else {
            let (sine, cosine) = T::sin_cos_straight(size);
            (zero, sine, cosine)
        };
        Zero { at, reversed, rest: rest * sign, sine: sine * sign, cosine }
    }

    /// Whether row values are the figure angles.
    #[inline(always)]
    pub(super) fn is_none(&self) -> bool {
        (self.at == T::lit(0.0)) & !self.reversed
    }

    /// The row value of a figure angle, in (-π, π], and what is too much of it.
    #[inline(always)]
    fn value(&self, figure: T) -> (T, T) {
        let zero = T::lit(0.0);
        if self.at == zero {
            // Minus half a turn alone changes, to what is less than half an ε away from it.
            return (math::without_minus_half(figure), zero);
        }
        let value = figure - self.at;
        let back = value - figure;
        let lost = (figure - (value - back)) - (self.at + back);
        let (value, over) = if self.at > zero { math::wrap_up(value) } else { math::wrap_down(value) };
        (value, (over - lost) + self.rest)
    }

    /// Sine and cosine of the row value of a figure angle.
    #[inline(always)]
    fn seen(&self, sine: T, cosine: T) -> (T, T) {
        let zero = T::lit(0.0);
        if self.sine == zero {
            if self.cosine > zero { (sine, cosine) } else { (-sine, -cosine) }
        } else if self.cosine == zero {
            if self.sine > zero { (-cosine, sine) } else { (cosine, -sine) }
        } else {
            (sine * self.cosine - cosine * self.sine, cosine * self.cosine + sine * self.sine)
        }
    }
}

/// A row value with its sine and cosine.
#[derive(Clone, Copy)]
pub(super) struct Row<T> {
    pub(super) value: T,
    pub(super) sine: T,
    pub(super) cosine: T,
}

impl<T: Float> Row<T> {
    /// The value as it is, which is by so much more than what sine and cosine are of.
    #[inline(always)]
    fn moved(self, by: T) -> Self {
        Row { sine: self.sine + self.cosine * by, cosine: self.cosine - self.sine * by, ..self }
    }

    /// The other way.
    #[inline(always)]
    pub(super) fn negated(self) -> Self {
        Row { value: -self.value, sine: -self.sine, ..self }
    }

    /// The sum of two values, as it is rounded.
    #[inline(always)]
    pub(super) fn plus(self, other: Self) -> Self {
        let value = self.value + other.value;
        let back = value - self.value;
        let lost = (self.value - (value - back)) + (other.value - back);
        let sine = self.sine * other.cosine + self.cosine * other.sine;
        let cosine = self.cosine * other.cosine - self.sine * other.sine;
        Row { value, sine, cosine }.moved(-lost)
    }
}

/// The values of three joints.
#[inline(always)]
pub(super) fn values<T: Float>([a, b, c]: &[Row<T>; 3]) -> [T; 3] {
    [a.value, b.value, c.value]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::wrist::row_value;
    use crate::sample::Random;
    use core::f64::consts::{FRAC_PI_2, PI};

    /// By how many ε at most sines and cosines miss those of the values that they come with: of row values, and of sums of two.
    fn worst<T: Float>(judged: impl Fn(T) -> f64) -> [f64; 2] {
        let (mut random, mut worst) = (Random(5), [0.0_f64; 2]);
        let judge = |row: Row<T>, worst: &mut f64| {
            let (sine, cosine) = math::sin_cos(judged(row.value));
            let missed = (judged(row.sine) - sine).abs().max((judged(row.cosine) - cosine).abs());
            *worst = worst.max(missed / judged(T::EPS));
        };
        for _ in 0..20_000 {
            let offset = match (random.within(0.0, 4.0), random.coin()) {
                (kind, _) if kind < 1.0 => 0.0,
                (kind, up) if kind < 2.0 => {
                    if up {
                        FRAC_PI_2
                    } else {
                        -FRAC_PI_2
                    }
                }
                (kind, up) if kind < 3.0 => {
                    if up {
                        PI
                    } else {
                        -PI
                    }
                }
                _ => random.within(-PI, PI),
            };
            let (offset, reversed) = (T::lit(offset), random.coin());
            let [y, x] = [T::lit(random.within(-1.0, 1.0)), T::lit(random.within(-1.0, 1.0))];
            let per = T::lit(1.0) / math::sqrt(x * x + y * y);
            let (zero, figure) = (Zero::new(offset, reversed), Figure::of([y, x], per));
            let upper = Figure::above([math::abs(y) * per, x * per]);
            let [y, x] = [math::abs(y), math::abs(x)];
            let twice = Figure::twice([y, x], [(x + x) * y, (x - y) * (x + y)], per * per);
            for figure in
                [figure, figure.opposite(), figure.negated(), upper, twice, twice.signed(T::lit(-1.0))]
            {
                let row = figure.row(&zero);
                assert!(
                    row.value == row_value(figure.angle, offset, reversed),
                    "{:?} {offset:?}",
                    figure.angle
                );
                judge(row, &mut worst[0]);
            }
            judge(twice.row(&zero).negated().plus(upper.row(&zero)), &mut worst[1]);
        }
        worst
    }

    #[test]
    fn sines_are_those_of_the_values_that_are_given_out() {
        // Without one of the corrections rows would be more than 2 away, and sums more than 3.
        for [row, sum] in [worst::<f32>(f64::from), worst::<f64>(|x| x)] {
            assert!(row < 1.9 && sum < 2.6, "{row} {sum}");
        }
    }
}
