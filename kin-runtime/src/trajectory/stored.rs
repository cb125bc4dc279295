//! A trajectory as serde stores it: ends, ramps and duration, which are looked at when they come back.

use super::Trajectory;
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use serde::de::{self, Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

/// What is stored.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Trajectory")]
#[serde(bound(
    serialize = "T: nalgebra::Scalar + serde::Serialize",
    deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
))]
struct Stored<T, const N: usize> {
    from: Joints<T, N>,
    to: Joints<T, N>,
    ramp: Joints<T, N>,
    duration: T,
}

impl<T: Float + Serialize, const N: usize> Serialize for Trajectory<T, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Trajectory { from, to, ramp, duration } = *self;
        Stored { from, to, ramp, duration }.serialize(serializer)
    }
}

impl<'de, T: Float + Deserialize<'de>, const N: usize> Deserialize<'de> for Trajectory<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Stored { from, to, ramp, duration } = Stored::deserialize(deserializer)?;
        let trajectory = Trajectory { from, to, ramp, duration };
        if trajectory.holds_together() {
            Ok(trajectory)
        } else {
            Err(de::Error::custom("ends, ramps and duration are not those of a trajectory"))
        }
    }
}

impl<T: Float, const N: usize> Trajectory<T, N> {
    /// Whether every joint that has a way to go has a ramp in the first half of the duration, and every other none.
    fn holds_together(&self) -> bool {
        let half = self.duration * T::lit(0.5);
        let sound = super::sound(self.duration);
        let finite =
            |values: &Joints<T, N>| pose::entries(values).iter().all(|value| math::is_finite(*value));
        let ramped = self.profiles().all(|profile| {
            let still = profile.from.partial_cmp(&profile.to) == Some(core::cmp::Ordering::Equal);
            let ramp = profile.ramp;
            if still {
                !(ramp > T::lit(0.0) || ramp < T::lit(0.0))
            } else {
                ramp > T::lit(0.0) && ramp <= half
            }
        });
        sound && finite(&self.from) && finite(&self.to) && finite(&self.ramp) && ramped
    }
}
