//! Solutions as serde stores them: the list of slots and the sliding joints.

use super::{Branch, JointSet, Reason, Slot, Solutions};
use crate::math::Float;
use core::fmt;
use core::marker::PhantomData;
use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

impl<T: Float + Serialize, const N: usize, B: Branch + Serialize> Serialize for Solutions<T, N, B> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(B::ALL.len() + 1)?;
        tuple.serialize_element(&self.sliding)?;
        for slot in self.slots() {
            tuple.serialize_element(slot)?;
        }
        tuple.end()
    }
}

impl<'de, T, const N: usize, B> Deserialize<'de> for Solutions<T, N, B>
where
    T: Float + Deserialize<'de>,
    B: Branch + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_tuple(B::ALL.len() + 1, List(PhantomData))
    }
}

/// Reads the sliding joints, then one slot for each branch.
struct List<T, const N: usize, B>(PhantomData<(T, B)>);

impl<'de, T, const N: usize, B> Visitor<'de> for List<T, N, B>
where
    T: Float + Deserialize<'de>,
    B: Branch + Deserialize<'de>,
{
    type Value = Solutions<T, N, B>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a joint set and {} solution slots", B::ALL.len())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
        let sliding: JointSet = seq.next_element()?.ok_or_else(|| de::Error::invalid_length(0, &self))?;
        let mut solutions = Solutions::none(sliding, Reason::NotFinite);
        for (count, branch) in B::ALL.iter().enumerate() {
            let slot: Slot<T, N, B> =
                seq.next_element()?.ok_or_else(|| de::Error::invalid_length(count + 1, &self))?;
            solutions.put(*branch, slot);
        }
        Ok(solutions)
    }
}

#[cfg(test)]
mod tests {
    use crate::pose::{self, Pose};
    use crate::sample::{LAB_ARM, STANFORD_ARM, Text};
    use crate::{Arm, Dexterity, Euler, EulerZyx, InverseKinematics, Limits, Posture, Solutions, dexterity};
    use serde::{Serialize, de::DeserializeOwned};

    fn survives<X: Serialize + DeserializeOwned + PartialEq + core::fmt::Debug>(value: &X) {
        let text = serde_json::to_string(value).unwrap();
        assert_eq!(&serde_json::from_str::<X>(&text).unwrap(), value, "{text}");
    }

    #[test]
    fn what_a_user_may_store_comes_back() {
        let q = pose::column([0.0, 0.3, 0.4, 0.5, 0.0, 0.6]);
        let pose: Pose<f64> = LAB_ARM.fk(&q);
        survives(&q);
        survives(&pose);
        survives::<Solutions<f64, 6, Posture>>(&LAB_ARM.ik(&pose));
        survives::<Solutions<f32, 6, Posture>>(
            &STANFORD_ARM.ik(&STANFORD_ARM.fk(&pose::column([0.5_f32; 6]))),
        );
        survives::<Solutions<f64, 6, Posture>>(
            &LAB_ARM.ik(&pose::from_rows(pose::rows(&pose).0, [1e3, 0.0, 0.0])),
        );
        survives::<Dexterity<f64, 6>>(&dexterity(&LAB_ARM, &q));
        survives::<Euler<f64>>(&EulerZyx::from_rotation(&pose.rotation));
        survives::<Limits<6>>(&LAB_ARM.limits());
        let short = serde_json::from_str::<Limits<6>>("[null, [0, 1]]");
        assert!(Text::of(&short.unwrap_err()).as_str().contains("6 joint ranges"));
    }
}
