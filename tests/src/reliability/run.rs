//! A run: parts cut into blocks, blocks spread over threads, what is done kept in a file.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use indicatif::ProgressBar;
use serde::{Deserialize, Serialize};

use super::parts::{Part, parts};
use super::tally::Tally;

/// Tries that a thread takes at once.
const CHUNK: u64 = 1 << 10;
/// Tries between two states on file.
const BLOCK: u64 = 1 << 20;

/// What to do, and with how many hands.
#[derive(Clone, Debug)]
pub struct Order {
    /// Round trips of doubles for each family.
    pub poses: u64,
    /// Bit patterns in all.
    pub patterns: u64,
    /// Where the random numbers start.
    pub seed: u64,
    /// How many threads.
    pub threads: usize,
    /// Where the state is kept.
    pub resume: Option<PathBuf>,
}

/// What was done of one part.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug, Default)]
pub struct Done {
    /// So many tries, from the first on.
    pub tries: u64,
    /// What came of them.
    pub tally: Tally,
}

/// What was done of a run.
#[derive(Clone, PartialEq, Serialize, Deserialize, Debug)]
pub struct State {
    /// Its seed.
    pub seed: u64,
    /// Its round trips of doubles for each family.
    pub poses: u64,
    /// Its bit patterns.
    pub patterns: u64,
    /// Its parts by name.
    pub parts: BTreeMap<String, Done>,
}

impl State {
    /// A run that was interrupted, one of fewer tries, or one that has not begun: tries are the same whatever comes after them.
    ///
    /// # Errors
    /// The file cannot be read, or belongs to a run of another seed or of more tries.
    fn begin(order: &Order) -> io::Result<State> {
        let Order { seed, poses, patterns, .. } = *order;
        let parts = match order.resume.as_deref().map(fs::read_to_string) {
            None => BTreeMap::new(),
            Some(Err(error)) if error.kind() == io::ErrorKind::NotFound => BTreeMap::new(),
            Some(text) => {
                let state: State = serde_json::from_str(&text?)?;
                if state.seed != seed || state.poses > poses || state.patterns > patterns {
                    let State { seed, poses, patterns, .. } = state;
                    let what =
                        format!("the file to resume has seed {seed}, {poses} poses and {patterns} patterns");
                    return Err(io::Error::other(what));
                }
                state.parts
            }
        };
        Ok(State { seed, poses, patterns, parts })
    }

    /// What there is to do.
    pub fn asked(&self) -> Vec<Part> {
        parts(self.poses, self.patterns)
    }

    /// Written beside the file and then moved onto it, so that an interruption leaves the last state whole.
    fn keep(&self, file: &Path) -> io::Result<()> {
        let beside = file.with_extension("new");
        fs::write(&beside, serde_json::to_string(self)?)?;
        fs::rename(beside, file)
    }
}

/// Does all parts and tells what came of them.
///
/// # Errors
/// The file to resume cannot be read or written.
pub fn run(order: &Order, bar: &ProgressBar) -> io::Result<State> {
    let mut state = State::begin(order)?;
    let parts = state.asked();
    bar.set_length(parts.iter().map(|part| part.tries).sum());
    let before = state.parts.values().map(|done| done.tries).sum();
    bar.set_position(before);
    bar.reset_eta();
    for part in &parts {
        bar.set_message(part.name.clone());
        let mut done = state.parts.remove(&part.name).unwrap_or_default();
        while done.tries < part.tries {
            let end = part.tries.min(done.tries + BLOCK);
            done.tally.merge(block(part, order, done.tries, end, bar));
            done.tries = end;
            state.parts.insert(part.name.clone(), done.clone());
            if let Some(file) = &order.resume {
                state.keep(file)?;
            }
        }
        state.parts.insert(part.name.clone(), done);
    }
    bar.finish_and_clear();
    Ok(state)
}

/// The tries first … end - 1 of a part.
fn block(part: &Part, order: &Order, first: u64, end: u64, bar: &ProgressBar) -> Tally {
    let (next, total) = (AtomicU64::new(first), Mutex::new(Tally::default()));
    let work = || {
        let mut own = Tally::default();
        loop {
            let start = next.fetch_add(CHUNK, Ordering::Relaxed);
            if start >= end {
                break;
            }
            let stop = end.min(start + CHUNK);
            (start..stop).for_each(|index| part.run(order.seed, index, &mut own));
            bar.inc(stop - start);
        }
        // Nobody panics while holding it: tries that panic are caught.
        if let Ok(mut total) = total.lock() {
            total.merge(own);
        }
    };
    thread::scope(|scope| {
        (0..order.threads.max(1)).for_each(|_| {
            scope.spawn(work);
        });
    });
    total.into_inner().unwrap_or_default()
}
