//! The labels of arms with a spherical shoulder: those of a wrist and its base, read from the tool.

use super::{ArmPosture, Bend, Branch, Elbow, Shoulder};
use core::{array, fmt};

/// On which side of the last axis the arm stands, for an arm with a spherical shoulder. Where joints 6, 5 and 4 are a
/// [general base](crate::ik::general), as [`Shoulder`] says of one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Hand {
    /// The centre of the shoulder lies on the side to which the common normal of axes 6 and 5 points.
    Right,
    /// The other side.
    Left,
}

/// The eight branches of a six-joint arm with a spherical shoulder.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ShoulderPosture {
    /// Which sign of the shoulder: bent positively or negatively about axis 2.
    pub shoulder: Bend,
    /// Which side of the line from the hand to the shoulder, axis 6 pointing up.
    pub elbow: Elbow,
    /// Which side of the last axis.
    pub hand: Hand,
}

impl ShoulderPosture {
    /// The branch whose last three joints, seen from the tool, are a base in this posture.
    pub(crate) const fn seen(hand: ArmPosture, shoulder: Bend) -> Self {
        let ArmPosture { shoulder: side, elbow } = hand;
        let hand = match side {
            Shoulder::Right => Hand::Right,
            Shoulder::Left => Hand::Left,
        };
        Self { shoulder, elbow, hand }
    }

    /// The posture of the last three joints as a base, seen from the tool.
    const fn base(self) -> ArmPosture {
        let shoulder = match self.hand {
            Hand::Right => Shoulder::Right,
            Hand::Left => Shoulder::Left,
        };
        ArmPosture { shoulder, elbow: self.elbow }
    }

    /// The one of eight values, in the order of the slots, that belongs to this branch.
    fn pick<X>(self, [nur, nul, ndr, ndl, fur, ful, fdr, fdl]: [X; 8]) -> X {
        let (noflip, flip) = self.base().pick([(nur, fur), (ndr, fdr), (nul, ful), (ndl, fdl)]);
        match self.shoulder {
            Bend::NoFlip => noflip,
            Bend::Flip => flip,
        }
    }

    const fn new(shoulder: Bend, elbow: Elbow, hand: Hand) -> Self {
        Self { shoulder, elbow, hand }
    }
}

impl Branch for ShoulderPosture {
    type Slots<X> = [X; 8];

    const ALL: &'static [Self] = &[
        Self::new(Bend::NoFlip, Elbow::Up, Hand::Right),
        Self::new(Bend::NoFlip, Elbow::Up, Hand::Left),
        Self::new(Bend::NoFlip, Elbow::Down, Hand::Right),
        Self::new(Bend::NoFlip, Elbow::Down, Hand::Left),
        Self::new(Bend::Flip, Elbow::Up, Hand::Right),
        Self::new(Bend::Flip, Elbow::Up, Hand::Left),
        Self::new(Bend::Flip, Elbow::Down, Hand::Right),
        Self::new(Bend::Flip, Elbow::Down, Hand::Left),
    ];

    const MIRRORED: bool = true;

    fn slots<X>(mut make: impl FnMut(Self) -> X) -> [X; 8] {
        array::from_fn(|slot| {
            make(Self {
                shoulder: if slot & 4 == 0 { Bend::NoFlip } else { Bend::Flip },
                elbow: if slot & 2 == 0 { Elbow::Up } else { Elbow::Down },
                hand: if slot & 1 == 0 { Hand::Right } else { Hand::Left },
            })
        })
    }

    fn of<X>(self, slots: &[X; 8]) -> &X {
        self.pick(slots.each_ref())
    }

    fn of_mut<X>(self, slots: &mut [X; 8]) -> &mut X {
        self.pick(slots.each_mut())
    }
}

impl fmt::Display for Hand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Hand::Right => "right",
            Hand::Left => "left",
        })
    }
}

impl fmt::Display for ShoulderPosture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // One literal for each branch, so that width and alignment apply to the whole label.
        f.pad(self.pick([
            "noflip/up/right",
            "noflip/up/left",
            "noflip/down/right",
            "noflip/down/left",
            "flip/up/right",
            "flip/up/left",
            "flip/down/right",
            "flip/down/left",
        ]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Text;

    #[test]
    fn slots_labels_and_branches_agree() {
        let slots = ShoulderPosture::slots(|branch| branch);
        for (branch, slot) in ShoulderPosture::ALL.iter().zip(&slots) {
            assert!(branch == slot && branch.of(&slots) == branch);
            assert_eq!(ShoulderPosture::seen(branch.base(), branch.shoulder), *branch);
            let words = [Text::of(&branch.shoulder), Text::of(&branch.elbow), Text::of(&branch.hand)];
            assert!(Text::of(branch).as_str().split('/').eq(words.iter().map(Text::as_str)), "{branch}");
        }
        let mut marked = ShoulderPosture::slots(|_| 0);
        for branch in ShoulderPosture::ALL {
            *branch.of_mut(&mut marked) += 1;
        }
        assert_eq!(marked, [1; 8]);
    }
}
