//! What is counted: sums and worst cases, the same in whatever order the parts are put together.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// How many of the worst cases are kept of each kind.
const KEPT: usize = 5;

/// A case that can be run again: the arm, the number of the try, and the joint values or pose entries as bit patterns.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug)]
pub struct Case {
    /// How bad, as bits, so that storing it loses nothing; compared as a number.
    badness: u64,
    /// The number of the try.
    pub index: u64,
    /// The arm's name.
    pub arm: String,
    /// What went in, as hexadecimal bit patterns.
    pub bits: Vec<String>,
}

impl Case {
    /// How bad it is.
    pub fn badness(&self) -> f64 {
        f64::from_bits(self.badness)
    }

    fn comes_before(&self, other: &Case) -> bool {
        let (a, b) = (self.badness(), other.badness());
        a > b || (a == b && self.index < other.index)
    }
}

/// The worst cases of one kind, the worst first; of two equals the earlier try.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug, Default)]
pub struct Worst(pub Vec<Case>);

impl Worst {
    /// Whether a case that is so bad would be kept.
    pub fn takes(&self, badness: f64, index: u64) -> bool {
        self.0
            .get(KEPT - 1)
            .is_none_or(|last| badness > last.badness() || (badness == last.badness() && index < last.index))
    }

    /// Keeps a case if it belongs here; `bits` is asked for only then.
    pub fn add(&mut self, badness: f64, index: u64, arm: &str, bits: impl FnOnce() -> Vec<String>) {
        // A NaN is worse than any number.
        let badness = if badness.is_nan() { f64::INFINITY } else { badness };
        if self.takes(badness, index) {
            self.insert(Case { badness: badness.to_bits(), index, arm: arm.to_owned(), bits: bits() });
        }
    }

    fn insert(&mut self, case: Case) {
        let at = self.0.iter().position(|held| case.comes_before(held)).unwrap_or(self.0.len());
        self.0.insert(at, case);
        self.0.truncate(KEPT);
    }

    fn merge(&mut self, other: Worst) {
        other.0.into_iter().for_each(|case| self.insert(case));
    }

    /// How bad the worst is; 0 if there is none.
    pub fn badness(&self) -> f64 {
        self.0.first().map_or(0.0, Case::badness)
    }
}

/// What must not happen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// A pose came back empty.
    Empty,
    /// The joint values are not among the solutions, nor any that the pose cannot tell from them; the badness is their distance over
    /// the one allowed.
    Lost,
    /// A solution misses the pose by more than is promised; the badness is by how many ε.
    Inexact,
    /// Two solutions are one.
    Twice,
    /// A solution is not finite or has an angle outside (-π, π], or there are more of them than there can be.
    Malformed,
    /// It panicked.
    Panicked,
}

impl Fault {
    /// All of them, with their names.
    pub const ALL: [(Fault, &'static str); 6] = [
        (Fault::Empty, "empty"),
        (Fault::Lost, "lost"),
        (Fault::Inexact, "inexact"),
        (Fault::Twice, "twice"),
        (Fault::Malformed, "malformed"),
        (Fault::Panicked, "panicked"),
    ];
}

/// In how many tries something happened.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug, Default)]
pub struct Count {
    /// In so many.
    pub tries: u64,
    /// By arm.
    pub arms: BTreeMap<String, u64>,
    /// The worst of them.
    pub worst: Worst,
}

impl Count {
    /// Once more.
    pub fn add(&mut self, badness: f64, index: u64, arm: &str, bits: impl FnOnce() -> Vec<String>) {
        self.tries += 1;
        match self.arms.get_mut(arm) {
            Some(tries) => *tries += 1,
            None => _ = self.arms.insert(arm.to_owned(), 1),
        }
        self.worst.add(badness, index, arm, bits);
    }

    fn merge(&mut self, other: Count) {
        self.tries += other.tries;
        for (arm, tries) in other.arms {
            *self.arms.entry(arm).or_default() += tries;
        }
        self.worst.merge(other.worst);
    }
}

/// The figures of one kind of try.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug, Default)]
pub struct Tally {
    /// Tries.
    pub tries: u64,
    /// Solutions that came back.
    pub solutions: u64,
    /// Tries with a family among their solutions.
    pub families: u64,
    /// What must be nothing, in the order of [`Fault::ALL`].
    faults: [Count; 6],
    /// Tries whose pose, being rounded, does not determine the joints within the tolerance asked for: others that it cannot tell from
    /// them came back. The badness is as for those that are lost.
    pub blurred: Count,
    /// Of those that came back within the tolerance, the farthest: their distance over the one allowed.
    pub strayed: Worst,
    /// The worst residuals, in ε.
    pub residual: Worst,
}

impl Tally {
    /// How often this happened.
    pub fn of(&self, fault: Fault) -> &Count {
        &self.faults[fault as usize]
    }

    /// The same, to count on.
    pub fn of_mut(&mut self, fault: Fault) -> &mut Count {
        &mut self.faults[fault as usize]
    }

    /// What went wrong, in words: nothing where nothing did.
    pub fn complaints(&self) -> Vec<String> {
        let faults = Fault::ALL.iter().map(|(fault, what)| (what, self.of(*fault)));
        faults
            .filter(|(_, count)| count.tries > 0)
            .map(|(what, count)| format!("{what}: {count:?}"))
            .collect()
    }

    /// How many tries had this arm any fault in, one of two faults counting twice.
    pub fn faults_of(&self, arm: &str) -> u64 {
        self.faults.iter().filter_map(|count| count.arms.get(arm)).sum()
    }

    /// Both together.
    pub fn merge(&mut self, other: Tally) {
        self.tries += other.tries;
        self.solutions += other.solutions;
        self.families += other.families;
        self.faults.iter_mut().zip(other.faults).for_each(|(count, more)| count.merge(more));
        self.blurred.merge(other.blurred);
        self.strayed.merge(other.strayed);
        self.residual.merge(other.residual);
    }
}

#[test]
fn the_order_of_the_parts_does_not_matter() {
    let part = |first: u64| {
        let mut tally = Tally::default();
        for index in first..first + 20 {
            let badness = (index * 7 % 11) as f64;
            tally.tries += 1;
            tally.residual.add(badness, index, "arm", || vec![format!("{index:x}")]);
            tally.of_mut(Fault::Lost).add(badness, index, "arm", || vec![format!("{index:x}")]);
        }
        tally
    };
    let (mut forwards, mut backwards) = (Tally::default(), Tally::default());
    [0, 20, 40].into_iter().for_each(|first| forwards.merge(part(first)));
    [40, 0, 20].into_iter().for_each(|first| backwards.merge(part(first)));
    assert_eq!(forwards, backwards);
    assert_eq!(forwards.residual.badness(), 10.0);
    assert_eq!((forwards.of(Fault::Lost).tries, forwards.faults_of("arm")), (60, 60));
}
