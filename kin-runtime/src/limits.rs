//! Joint limits: whether a value keeps them, which of its turns do, and if none by how much it passes them.

use crate::arm::JointKind;
use crate::math::{self, Float};

/// The most turns by which an angle is wound in either direction. Each turn costs the rounding of 2π, so that an angle
/// of a thousand turns has lost ten bits.
pub const TURNS: f64 = 1024.0;

/// The inclusive range of each joint: radians or the declared unit of length; `None` where the table gives none.
///
/// The range of a revolute joint may reach beyond ±π (`170 .. 190` degrees) and be longer than a turn: a value is inside
/// if some whole number of turns, [`TURNS`] at most, brings it there. An end may be infinite. A range with an end that is
/// not a number holds nothing, nor does a reversed one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Limits<const N: usize> {
    ranges: [Option<(f64, f64)>; N],
}

/// How a joint value stands to its range.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Standing<T> {
    /// Inside, or without a range.
    Within,
    /// Outside: the distance to the nearer end, positive; infinite for what is not a number.
    Passed(T),
}

/// Whole numbers of turns, from the first to the last; none if the first is larger.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Turns<T> {
    pub(crate) first: T,
    pub(crate) last: T,
}

impl<const N: usize> Limits<N> {
    /// No limit on any joint.
    pub const NONE: Self = Self { ranges: [None; N] };

    /// From one range for each joint.
    pub const fn new(ranges: [Option<(f64, f64)>; N]) -> Self {
        Self { ranges }
    }

    /// The range of a joint, counted from 0; `None` if it has none.
    pub fn range(&self, joint: usize) -> Option<(f64, f64)> {
        self.ranges.get(joint).copied().flatten()
    }

    /// The ranges, in order of the joints.
    pub fn ranges(&self) -> &[Option<(f64, f64)>; N] {
        &self.ranges
    }

    /// How `value` stands to the range of a joint, counted from 0.
    pub fn standing<T: Float>(&self, joint: usize, kind: JointKind, value: T) -> Standing<T> {
        match self.range(joint) {
            None => Standing::Within,
            Some((low, high)) => stands(T::lit(low), T::lit(high), kind, value),
        }
    }

    /// The values that are `value` but for whole turns and lie in the range of a joint, rising. A joint that is not
    /// bounded on both sides has infinitely many: then one stands for all, the least turned.
    pub fn representatives<T: Float>(
        &self,
        joint: usize,
        kind: JointKind,
        value: T,
    ) -> impl Iterator<Item = T> + use<T, N> {
        let (value, turns) = (principal(kind, value), self.counted(joint, kind, value));
        let mut next = turns.first;
        core::iter::from_fn(move || {
            let now = next;
            next += T::lit(1.0);
            (now <= turns.last).then(|| wound(value, now))
        })
    }

    /// The value that is `value` but for whole turns, lies in the range of a joint, and is nearest to `to`.
    pub fn nearest<T: Float>(&self, joint: usize, kind: JointKind, value: T, to: T) -> Option<T> {
        let (turns, value) = (self.allowed(joint, kind, value), principal(kind, value));
        let wished = match kind {
            JointKind::Prismatic => T::lit(0.0),
            JointKind::Revolute => Float::floor((to - value) / T::TURN.0 + T::lit(0.5)),
        };
        let wished = if math::is_nan(wished) { T::lit(0.0) } else { wished };
        (turns.first <= turns.last)
            .then(|| wound(value, math::max(turns.first, math::min(wished, turns.last))))
    }

    /// All turns that bring a value into the range of a joint.
    fn allowed<T: Float>(&self, joint: usize, kind: JointKind, value: T) -> Turns<T> {
        let (low, high) = self.range(joint).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        turns(T::lit(low), T::lit(high), kind, value)
    }

    /// The same, but one turn for all of a joint that is not bounded on both sides.
    pub(crate) fn counted<T: Float>(&self, joint: usize, kind: JointKind, value: T) -> Turns<T> {
        let all = self.allowed(joint, kind, value);
        let bounded = |(low, high): (f64, f64)| low.is_finite() && high.is_finite();
        if self.range(joint).is_some_and(bounded) || all.first > all.last {
            return all;
        }
        let least = math::max(all.first, math::min(T::lit(0.0), all.last));
        Turns { first: least, last: least }
    }
}

/// A value as it is wound from: an angle in (-π, π].
pub(crate) fn principal<T: Float>(kind: JointKind, value: T) -> T {
    match kind {
        JointKind::Prismatic => value,
        JointKind::Revolute => math::wrap(value),
    }
}

/// An angle with whole turns added.
pub(crate) fn wound<T: Float>(value: T, turns: T) -> T {
    (value + turns * T::TURN.0) + turns * T::TURN.1
}

/// The turns that bring a value into a range.
fn turns<T: Float>(low: T, high: T, kind: JointKind, value: T) -> Turns<T> {
    let (zero, one, most) = (T::lit(0.0), T::lit(1.0), T::lit(TURNS));
    let none = Turns { first: one, last: zero };
    let value = principal(kind, value);
    if math::is_nan(low) || math::is_nan(high) || !math::is_finite(value) {
        return none;
    }
    let (low, high) = (low - slack(low, high), high + slack(low, high));
    match kind {
        JointKind::Prismatic if low <= value && value <= high => Turns { first: zero, last: zero },
        JointKind::Prismatic => none,
        JointKind::Revolute => {
            // Quotients may be off by one at an end; the angles themselves decide.
            let clamped = |turns: T| math::max(-most, math::min(turns, most));
            let mut first = clamped(Float::floor((low - value) / T::TURN.0));
            let mut last = clamped(Float::floor((high - value) / T::TURN.0) + one);
            for _ in 0..2 {
                first += if wound(value, first) < low { one } else { zero };
                last -= if wound(value, last) > high { one } else { zero };
            }
            if wound(value, first) < low || wound(value, last) > high { none } else { Turns { first, last } }
        }
    }
}

/// The end of a range and a solution that lies exactly on it were rounded apart by this much: one of -π and π, say.
fn slack<T: Float>(low: T, high: T) -> T {
    let size = |end: T| if math::is_finite(end) { math::abs(end) } else { T::lit(0.0) };
    T::lit(8.0) * T::EPS * (T::lit(1.0) + math::max(size(low), size(high)))
}

/// How a value stands to one range.
fn stands<T: Float>(low: T, high: T, kind: JointKind, value: T) -> Standing<T> {
    let inside = turns(low, high, kind, value);
    if inside.first <= inside.last {
        return Standing::Within;
    }
    let passed = match kind {
        JointKind::Prismatic => math::max(low - value, value - high),
        JointKind::Revolute => {
            // Of all values with this direction, those nearest to the middle of the range decide.
            let middle = (low + high) * T::lit(0.5);
            math::abs(math::wrap(value - middle)) - (high - low) * T::lit(0.5)
        }
    };
    let infinite = math::is_nan(passed) || !math::is_finite(value);
    Standing::Passed(if infinite { T::lit(f64::INFINITY) } else { math::max(passed, slack(low, high)) })
}

#[cfg(feature = "serde")]
mod stored {
    //! A range list is stored as a sequence; serde's derive has no arrays of const length.
    use super::Limits;
    use core::fmt;
    use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
    use serde::ser::{Serialize, SerializeTuple, Serializer};

    impl<const N: usize> Serialize for Limits<N> {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let mut tuple = serializer.serialize_tuple(N)?;
            for range in &self.ranges {
                tuple.serialize_element(range)?;
            }
            tuple.end()
        }
    }

    impl<'de, const N: usize> Deserialize<'de> for Limits<N> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            struct Ranges<const N: usize>;
            impl<'de, const N: usize> Visitor<'de> for Ranges<N> {
                type Value = Limits<N>;
                fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    write!(f, "{N} joint ranges")
                }
                fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Limits<N>, A::Error> {
                    let mut limits = Limits::NONE;
                    for (i, range) in limits.ranges.iter_mut().enumerate() {
                        *range = seq.next_element()?.ok_or_else(|| de::Error::invalid_length(i, &self))?;
                    }
                    Ok(limits)
                }
            }
            deserializer.deserialize_tuple(N, Ranges)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn a_range_through_half_a_turn_holds_both_signs() {
        let limits = Limits::new([Some((170_f64.to_radians(), 190_f64.to_radians())), None]);
        let stand = |deg: f64| limits.standing(0, JointKind::Revolute, deg.to_radians());
        assert_eq!(stand(175.0), Standing::Within);
        assert_eq!(stand(-175.0), Standing::Within);
        assert_eq!(stand(190.0), Standing::Within);
        assert_eq!(stand(-170.0), Standing::Within);
        match stand(-165.0) {
            Standing::Passed(by) => assert!((by - 5_f64.to_radians()).abs() < 1e-12),
            Standing::Within => panic!(),
        }
        assert_eq!(limits.standing(1, JointKind::Revolute, 100.0), Standing::Within);
    }

    #[test]
    fn ends_are_inside_and_a_slide_does_not_wrap() {
        let limits = Limits::new([Some((-PI, PI)), Some((0.0, 1.0))]);
        assert_eq!(limits.standing(0, JointKind::Revolute, PI), Standing::Within);
        assert_eq!(limits.standing(1, JointKind::Prismatic, 1.0), Standing::Within);
        assert_eq!(limits.standing(1, JointKind::Prismatic, 1.0 + 2.0 * PI), Standing::Passed(2.0 * PI));
        assert_eq!(limits.standing(1, JointKind::Prismatic, -0.25_f32), Standing::Passed(0.25));
    }
}
