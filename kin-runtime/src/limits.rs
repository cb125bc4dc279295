//! Joint limits: whether a value keeps them, and if not by how much it passes them.

use crate::arm::JointKind;
use crate::math::{self, Float};

/// The inclusive range of each joint: radians or the declared unit of length; `None` where the table gives none.
///
/// The range of a revolute joint may reach beyond ±π (`170 .. 190` degrees): a value is inside if some whole number of
/// turns brings it there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Limits<const N: usize> {
    ranges: [Option<(f64, f64)>; N],
}

/// How a joint value stands to its range.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Standing<T> {
    /// Inside, or without a range.
    Within,
    /// Outside: the distance to the nearer end.
    Passed(T),
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
}

/// How a value stands to one range.
fn stands<T: Float>(low: T, high: T, kind: JointKind, value: T) -> Standing<T> {
    // The end of a range and a solution that lies exactly on it were rounded apart: one of -π and π, say.
    let slack = T::lit(8.0) * T::EPS * (T::lit(1.0) + math::max(math::abs(low), math::abs(high)));
    let passed = match kind {
        JointKind::Prismatic => math::max(low - value, value - high),
        JointKind::Revolute => {
            // Of all values with this direction, those nearest to the middle of the range decide.
            let middle = (low + high) * T::lit(0.5);
            math::abs(math::wrap(value - middle)) - (high - low) * T::lit(0.5)
        }
    };
    if passed <= slack { Standing::Within } else { Standing::Passed(passed) }
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
