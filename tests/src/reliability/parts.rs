//! The parts of a run: each structural family in both number formats, and all arms with wild bits.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;

use kin_runtime::prelude::*;
use kin_runtime::private::{SolvePair, SolvePosition, SolveShort, SolveShoulder, SolveWrist};

use super::aim::Sights;
use super::subject::{ByPoint, ByPose, ByTool, Family, Few, Subject, Tried, Two};
use super::tally::{Fault, Tally};
use super::trial::Try;
use crate::sample::Sampler;

/// What is done with one try of one arm.
type Run = fn(&Entry, u64, &mut Sampler, &mut Tally);

/// One declared arm as it is tried.
struct Entry {
    name: &'static str,
    family: Family,
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
    /// The worst residual that is promised, in ε of the reach.
    pub promised: f64,
    arms: Vec<(&'static Entry, Run)>,
}

impl Part {
    /// The names of its arms.
    pub fn arms(&self) -> impl Iterator<Item = &'static str> {
        self.arms.iter().map(|(arm, _)| arm.name)
    }

    /// The kinds of singular poses that its arms are aimed at.
    pub fn kinds(&self) -> BTreeSet<&'static str> {
        self.arms.iter().flat_map(|(arm, _)| arm.sights.kinds()).collect()
    }

    /// How many of its arms are aimed at a kind of singular poses.
    pub fn aimed(&self, kind: &str) -> usize {
        self.arms.iter().filter(|(arm, _)| arm.sights.kinds().contains(&kind)).count()
    }

    /// The try of that number: a function of seed, part and number, and of nothing else.
    pub fn run(&self, seed: u64, index: u64, tally: &mut Tally) {
        let Some((arm, run)) = self.arms.get((index % self.arms.len().max(1) as u64) as usize) else {
            return;
        };
        let stream = self.name.bytes().fold(seed, |hash, byte| Sampler::new(hash ^ u64::from(byte)).bits());
        let start = Sampler::new(stream ^ index).bits();
        let before = tally.tries;
        let all = AssertUnwindSafe(|| run(arm, index, &mut Sampler::new(start), tally));
        if catch_unwind(all).is_err() {
            tally.tries = before + 1;
            tally.of_mut(Fault::Panicked).add(1.0, index, arm.name, || vec![format!("{start:#x}")]);
        }
    }
}

/// All parts: so many round trips of doubles per family, a tenth of that of singles, and so many bit patterns.
pub fn parts(poses: u64, patterns: u64) -> Vec<Part> {
    static ARMS: OnceLock<Vec<Entry>> = OnceLock::new();
    let arms = ARMS.get_or_init(|| robots().into_iter().chain(invented()).collect());
    let mut families: Vec<Family> = arms.iter().map(|arm| arm.family).collect();
    families.sort_by_key(|family| family.name);
    families.dedup_by_key(|family| family.name);
    let mut parts = Vec::new();
    for (which, format, share) in [(0, "f64", 1), (1, "f32", 10)] {
        for family in &families {
            let own = arms.iter().filter(|arm| arm.family.name == family.name);
            parts.push(Part {
                name: format!("{}-{format}", family.name),
                wild: false,
                format,
                tries: poses / share,
                promised: family.promised,
                arms: own.map(|arm| (arm, arm.round_trips[which])).collect(),
            });
        }
    }
    for (which, format) in [(0, "f64"), (1, "f32")] {
        parts.push(Part {
            name: format!("bits-{format}"),
            wild: true,
            format,
            tries: patterns / 2,
            promised: f64::INFINITY,
            arms: arms.iter().map(|arm| (arm, arm.wild[which])).collect(),
        });
    }
    parts
}

macro_rules! runs {
    ($kind:ident, $method:ident) => {
        [
            |arm: &Entry, index, random: &mut Sampler, tally: &mut Tally| {
                let subject = Tried(A::default(), $kind);
                Try { subject: &subject, sights: &arm.sights, family: arm.family, index }
                    .$method::<f64, N>(random, tally)
            },
            |arm: &Entry, index, random: &mut Sampler, tally: &mut Tally| {
                let subject = Tried(A::default(), $kind);
                Try { subject: &subject, sights: &arm.sights, family: arm.family, index }
                    .$method::<f32, N>(random, tally)
            },
        ]
    };
}

macro_rules! entries_of {
    ($($name:ident $kind:ident: $Solve:ident $Inverse:ident;)*) => { $(
        fn $name<const N: usize, A: $Solve<N> + $Inverse<N> + Default>() -> Entry
        where
            Tried<A, $kind>: Subject<N>,
        {
            let subject = Tried(A::default(), $kind);
            let (family, sights) = (subject.family(), subject.sights());
            let (round_trips, wild) = (runs!($kind, round_trip), runs!($kind, wild));
            Entry { name: A::NAME, family, sights, round_trips, wild }
        }
    )* };
}
entries_of! {
    from_pose ByPose: SolveWrist InverseKinematics;
    from_tool ByTool: SolveShoulder InverseKinematics;
    from_few Few: SolveShort InverseKinematics;
    from_point ByPoint: SolvePosition PositionInverse;
    from_two Two: SolvePair PositionInverse;
}

/// What is tried of an arm with an inverse of this kind: a position and a pose where it has both.
macro_rules! subjects {
    ($Arm:ty, pose) => {
        vec![from_pose::<6, $Arm>()]
    };
    ($Arm:ty, shoulder) => {
        vec![from_tool::<6, $Arm>()]
    };
    ($Arm:ty, short) => {
        vec![from_few::<_, $Arm>()]
    };
    ($Arm:ty, position) => {
        vec![from_point::<3, $Arm>(), from_few::<3, $Arm>()]
    };
    ($Arm:ty, pair) => {
        vec![from_two::<2, $Arm>(), from_few::<2, $Arm>()]
    };
    ($Arm:ty, none) => {
        vec![]
    };
}

macro_rules! of_robots {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        /// Every arm of `robots` with an inverse.
        fn robots() -> Vec<Entry> {
            [$(subjects!(robots::$Arm, $inverse)),*].into_iter().flatten().collect()
        }
    };
}
robots::for_each!(of_robots);

macro_rules! of_invented {
    ($($Arm:ident $inverse:ident $place:tt;)*) => {
        /// Every invented arm.
        fn invented() -> Vec<Entry> {
            [$(subjects!(crate::invented::$Arm, $inverse)),*].into_iter().flatten().collect()
        }
    };
}
crate::each_invented!(of_invented);
