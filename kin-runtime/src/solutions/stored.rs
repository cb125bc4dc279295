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
