//! Which arms can be solved, and what their solver needs to know.
//!
//! A family recognises its figure in the arm's home position, where every axis is a line that the declaration fixes
//! exactly, and hands out plain numbers for the shared solver. Whether something is parallel or meets is decided
//! here, to within 64 ε of the reach, for every value of the parameters; what is refused is refused with a sentence
//! that names the axes and the distance.
//!
//! # Adding a family
//!
//! One file here (recognise, and what each solution needs), one page in the runtime's `ik` folder, one line in
//! [`ALL`], most specific first.

pub mod base;
pub mod general;
pub mod home;
pub mod pair;
pub mod position;
pub mod short;
pub mod spherical_shoulder;
pub mod spherical_wrist;
pub mod wrist;

use crate::algebra::ring::Ring;
use crate::chain::Chain;
use crate::truth::{Outers, Symbols};
use home::Home;

/// What a recognised family solves.
#[derive(Clone, Debug)]
pub enum Inverse {
    /// A pose, by a spherical wrist on a three-joint base.
    Pose(Box<spherical_wrist::SphericalWrist>),
    /// A pose, by a spherical shoulder under three joints of any kind.
    Shoulder(Box<spherical_shoulder::SphericalShoulder>),
    /// A pose, by two to five joints.
    Short(Box<short::Short>),
    /// A position, by two or three joints.
    Position(Box<position::Position>),
    /// Nothing, and why.
    None {
        /// One sentence, without a final full stop.
        reason: String,
        /// The element that causes it, by its index among the rows' elements, if one does.
        culprit: Option<usize>,
    },
}

/// Why a family does not hold.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// One sentence, without a final full stop.
    pub reason: String,
    /// The element that causes it, by its index among the rows' elements.
    pub culprit: Option<usize>,
}

impl Refusal {
    /// A refusal without a culprit.
    pub fn new(reason: impl Into<String>) -> Refusal {
        Refusal { reason: reason.into(), culprit: None }
    }
}

/// A family: its name in `ik:`, the number of joints it is about, and its recogniser.
pub struct Family {
    /// As written after `ik:`.
    pub name: &'static str,
    /// How many joints its arms have: from, to.
    pub joints: (usize, usize),
    recognise: fn(&mut Home<'_>) -> Result<Inverse, Refusal>,
}

/// All families, most specific first.
pub const ALL: [Family; 4] = [
    Family { name: "spherical_wrist", joints: (6, 6), recognise: spherical_wrist::recognise },
    Family { name: "spherical_shoulder", joints: (6, 6), recognise: spherical_shoulder::recognise },
    Family { name: "position", joints: (2, 3), recognise: position::recognise },
    Family { name: "short", joints: (2, 5), recognise: short::recognise },
];

/// The family that an arm belongs to, or the reason why it belongs to none.
///
/// The ring that comes back knows every constant that the geometry is made of.
pub fn recognise(chain: &Chain, symbols: &Symbols, ring: Ring, outers: &Outers) -> (Inverse, Ring) {
    let demanded = chain.demanded.as_ref().map(|d| d.value.as_str());
    let joints = chain.joints.len();
    let candidates = ALL.iter().filter(|f| match demanded {
        Some(name) => f.name == name,
        None => (f.joints.0..=f.joints.1).contains(&joints),
    });
    let mut refusals = Vec::new();
    let other = Refusal::new(format!(
        "inverse kinematics is derived for arms with two to six joints, this one has {joints}"
    ));
    for family in candidates {
        let (least, most) = family.joints;
        if !(least..=most).contains(&joints) {
            let range = if least == most { format!("{least}") } else { format!("{least} to {most}") };
            refusals.push(Refusal::new(format!(
                "the family {} has {range} joints, this arm has {joints}",
                family.name
            )));
            continue;
        }
        let Some(mut home) = Home::new(chain, symbols, ring.clone(), outers) else {
            refusals.push(Refusal::new("the exact geometry is too large to be represented"));
            break;
        };
        match (family.recognise)(&mut home) {
            Ok(inverse) => return (inverse, home.ring),
            Err(refusal) => refusals.push(refusal),
        }
    }
    let Refusal { reason, culprit } = together(refusals).unwrap_or(other);
    (Inverse::None { reason, culprit }, ring)
}

/// All refusals in one sentence, each once. The culprit is that of the most specific family: the arm was meant to be one.
fn together(refusals: Vec<Refusal>) -> Option<Refusal> {
    refusals.into_iter().reduce(|mut all, next| {
        if !all.reason.contains(&next.reason) {
            all.reason = format!("{}; {}", all.reason, next.reason);
        }
        all
    })
}
