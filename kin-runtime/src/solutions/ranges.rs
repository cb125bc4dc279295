//! Ranges of an angle on the circle: what limits leave of a family.

use crate::limits::wound;
use crate::math::{self, Float};

/// How many ranges are kept.
const MOST: usize = 16;

/// Inclusive ranges of an angle: the low end in [-π, π], -π of the whole circle alone, the high end at most one turn further.
/// Sixteen are kept at most, more than the joints of an arm can cut a circle into unless couplings turn one of them many times.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ranges<T> {
    list: [(T, T); MOST],
    count: usize,
}

impl<T: Float> Ranges<T> {
    /// No angle.
    pub fn none() -> Self {
        Self { list: [(T::lit(0.0), T::lit(0.0)); MOST], count: 0 }
    }

    /// Every angle.
    pub fn all() -> Self {
        Self::one(-math::half_turn::<T>(), math::half_turn())
    }

    /// One range, `low` any angle.
    pub fn one(low: T, high: T) -> Self {
        let mut ranges = Self::none();
        ranges.push(low, high);
        ranges
    }

    /// Adds a range, if there is room: a whole turn stands as -π .. π.
    pub(crate) fn push(&mut self, low: T, high: T) {
        let half = math::half_turn::<T>();
        let range = if high - low >= T::TURN.0 {
            (-half, half)
        } else {
            let start = math::wrap(low);
            (start, start + (high - low))
        };
        if let Some(place) = self.list.get_mut(self.count)
            && !math::is_nan(range.1 - range.0)
        {
            *place = range;
            self.count += 1;
        }
    }

    /// The ranges, in the order in which they were found.
    pub fn iter(&self) -> impl Iterator<Item = (T, T)> + '_ {
        self.list.iter().copied().take(self.count)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether an angle lies in one of them, but for whole turns.
    pub fn contains(&self, angle: T) -> bool {
        self.nearest(angle)
            .is_some_and(|nearest| math::abs(math::wrap(nearest - angle)) <= T::lit(8.0) * T::EPS)
    }

    /// The angle of the ranges that is nearest to another on the circle.
    pub fn nearest(&self, to: T) -> Option<T> {
        let mut best: Option<(T, T)> = None;
        for (low, high) in self.iter() {
            let (up, width) = (turned_up(to - low), high - low);
            let (at, off) = if up <= width {
                (to, T::lit(0.0))
            } else if up - width <= T::TURN.0 - up {
                (high, up - width)
            } else {
                (low, T::TURN.0 - up)
            };
            if best.is_none_or(|(_, least)| off < least) {
                best = Some((at, off));
            }
        }
        best.map(|(at, _)| at)
    }

    /// The angles that lie in both.
    #[must_use]
    pub fn and(&self, other: &Self) -> Self {
        let mut both = Self::none();
        for (low, high) in self.iter() {
            for (from, to) in other.iter() {
                if high - low >= T::TURN.0 {
                    both.push(from, to);
                    continue;
                }
                if to - from >= T::TURN.0 {
                    both.push(low, high);
                    continue;
                }
                for turn in [-1.0, 0.0, 1.0] {
                    let (from, to) = (wound(from, T::lit(turn)), wound(to, T::lit(turn)));
                    let (start, end) = (math::max(low, from), math::min(high, to));
                    if start <= end {
                        both.push(start, end);
                    }
                }
            }
        }
        both
    }
}

/// An angle in [0, 2π).
fn turned_up<T: Float>(angle: T) -> T {
    let angle = math::wrap(angle);
    if angle < T::lit(0.0) { angle + T::TURN.0 } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    #[test]
    fn what_two_sets_share_is_what_both_contain() {
        let mut random = Random(21);
        for _ in 0..2_000 {
            let mut draw = || {
                let mut set = Ranges::none();
                for _ in 0..2 {
                    let low = random.within(-9.0, 9.0);
                    set.push(low, low + random.within(0.0, 7.0));
                }
                set
            };
            let (a, b) = (draw(), draw());
            let both = a.and(&b);
            for _ in 0..20 {
                let x = random.angle();
                assert_eq!(both.contains(x), a.contains(x) && b.contains(x), "{x} in {a:?} and {b:?}");
                match both.nearest(x) {
                    Some(near) => assert!(a.contains(near) && b.contains(near)),
                    None => assert!(both.is_empty()),
                }
            }
        }
    }

    #[test]
    fn whole_circles_and_empty_sets() {
        assert!(Ranges::<f64>::none().is_empty() && Ranges::<f64>::none().nearest(1.0).is_none());
        assert!(Ranges::one(f64::NAN, 1.0).is_empty());
        let all = Ranges::<f64>::all();
        assert!(all.contains(3.0) && all.and(&all) == all && all.len() == 1);
        let point = Ranges::one(1.0, 1.0).and(&all);
        assert_eq!(point.nearest(-2.0), Some(1.0));
        // 170° .. 190° holds -175°.
        let back = Ranges::one(170_f32.to_radians(), 190_f32.to_radians());
        assert!(back.contains((-175_f32).to_radians()) && !back.contains(0.0));
    }
}
