//! What is A + B·cos t + C·sin t in the value of a joint that turns.

use crate::ik::FAMILY;
use crate::math::{self, Float};

/// A + B·cos t + C·sin t.
pub(super) struct Wave<T> {
    pub(super) mean: T,
    pub(super) cosine: T,
    pub(super) sine: T,
}

impl<T: Float> Wave<T> {
    /// From its values at nothing, a quarter turn and half a turn.
    pub(super) fn through([at_0, at_90, at_180]: [T; 3]) -> Self {
        let half = T::lit(0.5);
        let mean = (at_0 + at_180) * half;
        Wave { mean, cosine: (at_0 - at_180) * half, sine: at_90 - mean }
    }

    fn amplitude(&self) -> T {
        math::hypot(self.cosine, self.sine)
    }

    /// Its value.
    pub(super) fn at(&self, angle: T) -> T {
        let (sine, cosine) = math::sin_cos(angle);
        self.mean + self.cosine * cosine + self.sine * sine
    }

    /// The same less a constant.
    pub(super) fn less(&self, constant: T) -> Self {
        Wave { mean: self.mean - constant, ..*self }
    }

    /// The same wave, later by so much.
    pub(super) fn delayed(&self, by: T) -> Self {
        let (s, c) = math::sin_cos(by);
        let (cosine, sine) = (self.cosine * c - self.sine * s, self.cosine * s + self.sine * c);
        Wave { cosine, sine, ..*self }
    }

    /// Whether it is the same everywhere, but for round-off.
    pub(super) fn is_flat(&self) -> bool {
        self.amplitude() <= T::lit(FAMILY) * T::EPS
    }

    /// Whether it is nothing anywhere.
    pub(super) fn crosses(&self) -> bool {
        math::abs(self.mean) <= self.amplitude()
    }

    /// Where it is largest.
    pub(super) fn top(&self) -> T {
        math::atan2(self.sine, self.cosine)
    }

    /// Where it is nothing, or nearest to that, on one side of the top or the other.
    pub(super) fn zero(&self, far: bool) -> T {
        let (mean, amplitude) = (self.mean, self.amplitude());
        let aside = math::atan2(math::sqrt_or_zero((amplitude - mean) * (amplitude + mean)), -mean);
        math::wrap(if far { self.top() - aside } else { self.top() + aside })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    /// Three values tell a wave, which is nothing at its zeros, and largest at its top.
    #[test]
    fn waves_are_told_by_three_values() {
        let mut random = Random(7);
        let half = math::half_turn::<f64>();
        let mut crossing = 0;
        for _ in 0..1_000 {
            let [mean, cosine, sine] = [(); 3].map(|()| random.within(-1.0, 1.0));
            let wave = Wave { mean, cosine, sine };
            let same = Wave::through([0.0, 0.5 * half, half].map(|angle| wave.at(angle)));
            let (angle, constant) = (random.angle(), random.within(-1.0, 1.0));
            assert!((same.at(angle) - wave.at(angle)).abs() <= 8e-15);
            assert!((wave.delayed(0.7).at(angle) - wave.at(angle - 0.7)).abs() <= 8e-15);
            assert!((wave.less(constant).at(angle) - (wave.at(angle) - constant)).abs() <= 8e-15);
            assert!(wave.at(angle) <= wave.at(wave.top()) + 1e-15);
            if wave.crosses() {
                crossing += 1;
                for far in [false, true] {
                    // Beside its top a wave is as flat as a parabola, and its zeros are known to the root of its round-off.
                    assert!(wave.at(wave.zero(far)).abs() <= 1e-14, "{mean} {cosine} {sine}");
                }
            }
        }
        assert!(crossing > 400, "{crossing}");
    }
}
