//! The parts of a run: each structural family in both number formats, and all arms with wild bits.

use std::panic::{AssertUnwindSafe, catch_unwind};

use kin_runtime::Base;
use kin_runtime::prelude::*;
use kin_runtime::private::{SolvePosition, SolveWrist};

use super::aim::Sights;
use super::subject::{ByPoint, ByPose, Subject, Tried};
use super::tally::Tally;
use super::trial::Try;
use crate::sample::Sampler;

/// What is done with one try of one arm.
type Run = fn(&Sights, u64, &mut Sampler, &mut Tally);

/// One declared arm.
#[derive(Clone, Copy)]
struct Entry {
    name: &'static str,
    family: &'static str,
    sights: Sights,
    round_trips: [Run; 2],
    wild: [Run; 2],
}

/// A kind of try, with the arms over which it is spread.
pub struct Part {
    /// Its name: family and number format.
    pub name: String,
    /// Whether it tries bit patterns; otherwise round trips.
    pub wild: bool,
    /// The number format: `f64` or `f32`.
    pub format: &'static str,
    /// How many tries.
    pub tries: u64,
    arms: Vec<(&'static str, Sights, Run)>,
}

impl Part {
    /// The names of its arms.
    pub fn arms(&self) -> impl Iterator<Item = &'static str> {
        self.arms.iter().map(|(name, _, _)| *name)
    }

    /// The try of that number: a function of seed, part and number, and of nothing else.
    pub fn run(&self, seed: u64, index: u64, tally: &mut Tally) {
        let Some((name, sights, run)) = self.arms.get((index % self.arms.len().max(1) as u64) as usize)
        else {
            return;
        };
        let stream = self.name.bytes().fold(seed, |hash, byte| Sampler::new(hash ^ u64::from(byte)).bits());
        let start = Sampler::new(stream ^ index).bits();
        let mut part = Tally::default();
        let all = AssertUnwindSafe(|| run(sights, index, &mut Sampler::new(start), &mut part));
        if catch_unwind(all).is_ok() {
            tally.merge(part);
        } else {
            tally.tries += 1;
            tally.panics += 1;
            tally.panicked.add(1.0, index, name, || vec![format!("{start:#x}")]);
        }
    }
}

/// All parts: so many round trips of doubles per family, a tenth of that of singles, and so many bit patterns.
pub fn parts(poses: u64, patterns: u64) -> Vec<Part> {
    let arms = arms();
    let mut families: Vec<&'static str> = arms.iter().map(|arm| arm.family).collect();
    families.sort_unstable();
    families.dedup();
    let mut parts = Vec::new();
    for (which, format, share) in [(0, "f64", 1), (1, "f32", 10)] {
        for family in &families {
            let own = arms.iter().filter(|arm| arm.family == *family);
            parts.push(Part {
                name: format!("{family}-{format}"),
                wild: false,
                format,
                tries: poses / share,
                arms: own.map(|arm| (arm.name, arm.sights, arm.round_trips[which])).collect(),
            });
        }
    }
    for (which, format) in [(0, "f64"), (1, "f32")] {
        parts.push(Part {
            name: format!("bits-{format}"),
            wild: true,
            format,
            tries: patterns / 2,
            arms: arms.iter().map(|arm| (arm.name, arm.sights, arm.wild[which])).collect(),
        });
    }
    parts
}

fn entry<const N: usize, S: Subject<N>>(subject: &S, round_trips: [Run; 2], wild: [Run; 2]) -> Entry {
    let family = if !S::TURNS {
        "position"
    } else if matches!(subject.figures(), Base::Elbow(_)) {
        "elbow"
    } else if matches!(subject.figures(), Base::Telescope(_)) {
        "telescope"
    } else {
        "other"
    };
    Entry { name: S::NAME, family, sights: subject.sights(), round_trips, wild }
}

macro_rules! runs {
    ($N:literal, $kind:expr, $method:ident) => {
        [
            |sights, index, random, tally| {
                let subject = Tried(A::default(), $kind);
                Try { subject: &subject, sights, index }.$method::<f64, $N>(random, tally)
            },
            |sights, index, random, tally| {
                let subject = Tried(A::default(), $kind);
                Try { subject: &subject, sights, index }.$method::<f32, $N>(random, tally)
            },
        ]
    };
}

fn from_pose<A: SolveWrist<6> + InverseKinematics<6> + Default>() -> Entry {
    let subject = Tried(A::default(), ByPose);
    entry(&subject, runs!(6, ByPose, round_trip), runs!(6, ByPose, wild))
}

fn from_position<A: SolvePosition<3> + PositionInverse<3> + Default>() -> Entry {
    let subject = Tried(A::default(), ByPoint);
    entry(&subject, runs!(3, ByPoint, round_trip), runs!(3, ByPoint, wild))
}

macro_rules! subject {
    ($Arm:ident pose) => {
        Some(from_pose::<robots::$Arm>())
    };
    ($Arm:ident position) => {
        Some(from_position::<robots::$Arm>())
    };
    // Arms of other families are tried by tests of their own.
    ($Arm:ident $other:ident) => {
        None
    };
}

macro_rules! entries {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        /// Every arm of `robots` with a spherical wrist or three joints that carry its tool.
        fn arms() -> Vec<Entry> {
            [$(subject!($Arm $inverse)),*].into_iter().flatten().collect()
        }
    };
}
robots::for_each!(entries);
