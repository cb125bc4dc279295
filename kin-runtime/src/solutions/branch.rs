//! The labels of the solution slots.

use core::array;
use core::fmt;

/// A way of reaching a pose. Every branch has its own slot in [`Solutions`](crate::Solutions), always the same one.
pub trait Branch: Copy + PartialEq + fmt::Debug + fmt::Display + 'static {
    /// One value for each branch.
    type Slots<X>: AsRef<[X]> + AsMut<[X]>;

    /// All branches, in the order of the slots.
    const ALL: &'static [Self];

    /// Whether the arm is solved from its tool, as one with a spherical shoulder is: then the shoulder's
    /// [margin](crate::Margins) is an angle and the wrist's a length.
    const MIRRORED: bool = false;

    /// One value for each branch, made in the order of the slots.
    fn slots<X>(make: impl FnMut(Self) -> X) -> Self::Slots<X>;

    /// The value of this branch.
    fn of<X>(self, slots: &Self::Slots<X>) -> &X;

    /// The value of this branch, to be changed.
    fn of_mut<X>(self, slots: &mut Self::Slots<X>) -> &mut X;
}

/// On which side of the first axis the arm stands. On a [general base](crate::ik::general): which of the two ways of joint 1,
/// or the order of joint 3's value among the two with the same [`Elbow`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shoulder {
    /// The wrist centre lies on the side to which the common normal of axes 1 and 2 points.
    Right,
    /// The other side: the arm reaches over its back.
    Left,
}

/// On which side of the line from shoulder to wrist the elbow is. On a [general base](crate::ik::general): which of the two ways
/// of joint 3, or which sign of the Jacobian's determinant: it stays until the arm passes through a singular pose.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Elbow {
    /// Towards the positive first axis (of an arm that reaches away from that axis). A sliding third joint: extended. Of two
    /// joints that carry a point: the second bent positively.
    Up,
    /// The other side. A sliding third joint: pulled through.
    Down,
}

/// The sign of the wrist's bend.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Bend {
    /// Bent positively about axis 5.
    NoFlip,
    /// Bent negatively; axes 4 and 6 half a turn from where they were.
    Flip,
}

/// The eight branches of a six-joint arm with a spherical wrist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Posture {
    /// Which side of the first axis.
    pub shoulder: Shoulder,
    /// Which side of the line to the wrist.
    pub elbow: Elbow,
    /// Which sign of the wrist.
    pub wrist: Bend,
}

/// The four branches of the first three joints.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ArmPosture {
    /// Which side of the first axis.
    pub shoulder: Shoulder,
    /// Which side of the line to the wrist.
    pub elbow: Elbow,
}

impl ArmPosture {
    const fn new(shoulder: Shoulder, elbow: Elbow) -> Self {
        Self { shoulder, elbow }
    }

    /// The one of four values, in the order of the slots, that belongs to this branch.
    pub(crate) fn pick<X>(self, [ru, rd, lu, ld]: [X; 4]) -> X {
        match (self.shoulder, self.elbow) {
            (Shoulder::Right, Elbow::Up) => ru,
            (Shoulder::Right, Elbow::Down) => rd,
            (Shoulder::Left, Elbow::Up) => lu,
            (Shoulder::Left, Elbow::Down) => ld,
        }
    }

    /// With one of the two wrists.
    pub const fn with(self, wrist: Bend) -> Posture {
        Posture { shoulder: self.shoulder, elbow: self.elbow, wrist }
    }
}

impl Posture {
    /// Without the wrist.
    pub const fn arm(self) -> ArmPosture {
        ArmPosture { shoulder: self.shoulder, elbow: self.elbow }
    }

    /// The one of eight values, in the order of the slots, that belongs to this branch.
    fn pick<X>(self, [run, ruf, rdn, rdf, lun, luf, ldn, ldf]: [X; 8]) -> X {
        let (noflip, flip) = self.arm().pick([(run, ruf), (rdn, rdf), (lun, luf), (ldn, ldf)]);
        match self.wrist {
            Bend::NoFlip => noflip,
            Bend::Flip => flip,
        }
    }
}

impl Branch for ArmPosture {
    type Slots<X> = [X; 4];

    const ALL: &'static [Self] = &[
        Self::new(Shoulder::Right, Elbow::Up),
        Self::new(Shoulder::Right, Elbow::Down),
        Self::new(Shoulder::Left, Elbow::Up),
        Self::new(Shoulder::Left, Elbow::Down),
    ];

    fn slots<X>(mut make: impl FnMut(Self) -> X) -> [X; 4] {
        array::from_fn(|slot| {
            make(Self {
                shoulder: if slot & 2 == 0 { Shoulder::Right } else { Shoulder::Left },
                elbow: if slot & 1 == 0 { Elbow::Up } else { Elbow::Down },
            })
        })
    }

    fn of<X>(self, slots: &[X; 4]) -> &X {
        self.pick(slots.each_ref())
    }

    fn of_mut<X>(self, slots: &mut [X; 4]) -> &mut X {
        self.pick(slots.each_mut())
    }
}

/// The two ways of two joints that carry a point.
impl Branch for Elbow {
    type Slots<X> = [X; 2];

    const ALL: &'static [Self] = &[Self::Up, Self::Down];

    fn slots<X>(mut make: impl FnMut(Self) -> X) -> [X; 2] {
        [make(Self::Up), make(Self::Down)]
    }

    fn of<X>(self, [up, down]: &[X; 2]) -> &X {
        match self {
            Self::Up => up,
            Self::Down => down,
        }
    }

    fn of_mut<X>(self, [up, down]: &mut [X; 2]) -> &mut X {
        match self {
            Self::Up => up,
            Self::Down => down,
        }
    }
}

impl Branch for Posture {
    type Slots<X> = [X; 8];

    const ALL: &'static [Self] = &[
        ArmPosture::new(Shoulder::Right, Elbow::Up).with(Bend::NoFlip),
        ArmPosture::new(Shoulder::Right, Elbow::Up).with(Bend::Flip),
        ArmPosture::new(Shoulder::Right, Elbow::Down).with(Bend::NoFlip),
        ArmPosture::new(Shoulder::Right, Elbow::Down).with(Bend::Flip),
        ArmPosture::new(Shoulder::Left, Elbow::Up).with(Bend::NoFlip),
        ArmPosture::new(Shoulder::Left, Elbow::Up).with(Bend::Flip),
        ArmPosture::new(Shoulder::Left, Elbow::Down).with(Bend::NoFlip),
        ArmPosture::new(Shoulder::Left, Elbow::Down).with(Bend::Flip),
    ];

    #[inline(always)]
    fn slots<X>(mut make: impl FnMut(Self) -> X) -> [X; 8] {
        let [right, left] = [Shoulder::Right, Shoulder::Left];
        let [up, down] = [Elbow::Up, Elbow::Down];
        let mut make = |shoulder, elbow, wrist| make(Self { shoulder, elbow, wrist });
        // One by one, and not from their numbers: every slot is then written in its place, by code that knows its name.
        [
            make(right, up, Bend::NoFlip),
            make(right, up, Bend::Flip),
            make(right, down, Bend::NoFlip),
            make(right, down, Bend::Flip),
            make(left, up, Bend::NoFlip),
            make(left, up, Bend::Flip),
            make(left, down, Bend::NoFlip),
            make(left, down, Bend::Flip),
        ]
    }

    fn of<X>(self, slots: &[X; 8]) -> &X {
        self.pick(slots.each_ref())
    }

    fn of_mut<X>(self, slots: &mut [X; 8]) -> &mut X {
        self.pick(slots.each_mut())
    }
}

impl fmt::Display for Shoulder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Shoulder::Right => "right",
            Shoulder::Left => "left",
        })
    }
}

impl fmt::Display for Elbow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Elbow::Up => "up",
            Elbow::Down => "down",
        })
    }
}

impl fmt::Display for Bend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Bend::NoFlip => "noflip",
            Bend::Flip => "flip",
        })
    }
}

impl fmt::Display for ArmPosture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // One literal for each branch, so that width and alignment apply to the whole label.
        f.pad(match (self.shoulder, self.elbow) {
            (Shoulder::Right, Elbow::Up) => "right/up",
            (Shoulder::Right, Elbow::Down) => "right/down",
            (Shoulder::Left, Elbow::Up) => "left/up",
            (Shoulder::Left, Elbow::Down) => "left/down",
        })
    }
}

impl fmt::Display for Posture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match (self.shoulder, self.elbow, self.wrist) {
            (Shoulder::Right, Elbow::Up, Bend::NoFlip) => "right/up/noflip",
            (Shoulder::Right, Elbow::Up, Bend::Flip) => "right/up/flip",
            (Shoulder::Right, Elbow::Down, Bend::NoFlip) => "right/down/noflip",
            (Shoulder::Right, Elbow::Down, Bend::Flip) => "right/down/flip",
            (Shoulder::Left, Elbow::Up, Bend::NoFlip) => "left/up/noflip",
            (Shoulder::Left, Elbow::Up, Bend::Flip) => "left/up/flip",
            (Shoulder::Left, Elbow::Down, Bend::NoFlip) => "left/down/noflip",
            (Shoulder::Left, Elbow::Down, Bend::Flip) => "left/down/flip",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Text;

    fn keeps_its_order<B: Branch>() {
        let slots = B::slots(|branch| branch);
        for (branch, slot) in B::ALL.iter().zip(slots.as_ref()) {
            assert!(branch == slot && branch.of(&slots) == branch);
        }
        let mut marked = B::slots(|_| false);
        for branch in B::ALL {
            *branch.of_mut(&mut marked) = true;
        }
        assert!(marked.as_ref().iter().all(|&seen| seen) && marked.as_ref().len() == B::ALL.len());
    }

    #[test]
    fn slots_follow_the_list_of_branches() {
        keeps_its_order::<Posture>();
        keeps_its_order::<ArmPosture>();
        keeps_its_order::<Elbow>();
    }

    #[test]
    fn labels_are_the_three_words() {
        for posture in Posture::ALL {
            let words = [Text::of(&posture.shoulder), Text::of(&posture.elbow), Text::of(&posture.wrist)];
            let label = Text::of(posture);
            assert!(label.as_str().split('/').eq(words.iter().map(Text::as_str)), "{posture}");
            assert!(label.as_str().starts_with(Text::of(&posture.arm()).as_str()));
        }
        assert_eq!(Text::of(&format_args!("[{:>12}]", Bend::Flip)).as_str(), "[        flip]");
    }
}
