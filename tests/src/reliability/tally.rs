//! What is counted: sums and worst cases, the same in whatever order the parts are put together.

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
    /// Keeps a case if it belongs here; `bits` is asked for only then.
    pub fn add(&mut self, badness: f64, index: u64, arm: &str, bits: impl FnOnce() -> Vec<String>) {
        // A NaN is worse than any number.
        let badness = if badness.is_nan() { f64::INFINITY } else { badness };
        let last = self.0.get(KEPT - 1);
        if last
            .is_none_or(|last| badness > last.badness() || (badness == last.badness() && index < last.index))
        {
            self.insert(Case { badness: badness.to_bits(), index, arm: arm.to_owned(), bits: bits() });
        }
    }

    fn insert(&mut self, case: Case) {
        let at = self.0.iter().position(|held| case.comes_before(held)).unwrap_or(self.0.len());
        self.0.insert(at, case);
        self.0.truncate(KEPT);
    }

    /// How bad the worst is; 0 if there is none.
    pub fn badness(&self) -> f64 {
        self.0.first().map_or(0.0, Case::badness)
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
    /// Tries whose pose came back empty.
    pub empty: Worst,
    /// How many those were.
    pub empties: u64,
    /// Tries whose joint values are not among the solutions; the badness is their distance over the one allowed.
    pub lost: Worst,
    /// How many those were.
    pub losses: u64,
    /// Of those that are not lost, the farthest: their distance over the one allowed.
    pub strayed: Worst,
    /// Tries whose pose, being rounded, does not determine the joints within the tolerance asked for: another vector in
    /// the same place came back. The badness is as for `lost`.
    pub blurred: Worst,
    /// How many those were.
    pub blurs: u64,
    /// Pairs of solutions that are one.
    pub twice: Worst,
    /// In how many tries.
    pub twices: u64,
    /// Tries with a solution outside (-π, π], not finite, or more solutions than there are branches.
    pub malformed: Worst,
    /// How many those were.
    pub malformeds: u64,
    /// Tries that panicked.
    pub panicked: Worst,
    /// How many those were.
    pub panics: u64,
    /// The worst residuals, in ε.
    pub residual: Worst,
}

impl Tally {
    /// Both together.
    pub fn merge(&mut self, other: Tally) {
        self.tries += other.tries;
        self.solutions += other.solutions;
        self.families += other.families;
        self.empties += other.empties;
        self.losses += other.losses;
        self.blurs += other.blurs;
        self.twices += other.twices;
        self.malformeds += other.malformeds;
        self.panics += other.panics;
        let lists = [
            (&mut self.empty, other.empty),
            (&mut self.lost, other.lost),
            (&mut self.strayed, other.strayed),
            (&mut self.blurred, other.blurred),
            (&mut self.twice, other.twice),
            (&mut self.malformed, other.malformed),
            (&mut self.panicked, other.panicked),
            (&mut self.residual, other.residual),
        ];
        for (list, more) in lists {
            more.0.into_iter().for_each(|case| list.insert(case));
        }
    }

    /// What must be nothing, each with its name and its cases.
    pub fn faults(&self) -> [(&'static str, u64, &Worst); 5] {
        [
            ("empty", self.empties, &self.empty),
            ("lost", self.losses, &self.lost),
            ("twice", self.twices, &self.twice),
            ("malformed", self.malformeds, &self.malformed),
            ("panicked", self.panics, &self.panicked),
        ]
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
        }
        tally
    };
    let (mut forwards, mut backwards) = (Tally::default(), Tally::default());
    [0, 20, 40].into_iter().for_each(|first| forwards.merge(part(first)));
    [40, 0, 20].into_iter().for_each(|first| backwards.merge(part(first)));
    assert_eq!(forwards, backwards);
    assert_eq!(forwards.residual.badness(), 10.0);
}
