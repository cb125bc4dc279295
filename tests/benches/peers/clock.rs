//! Time: rounds of all ways in turn, so that the machine's moods touch all of them alike.

use crate::Target;
use crate::data::COUNT;
use crate::ways::Way;
use std::fmt::Write;
use std::ops::Range;
use std::time::Instant;

/// Rounds; of each stretch of elements the median counts.
pub(crate) const ROUNDS: usize = 25;
/// Elements of a stretch, unless a way has longer ones: so few that it is over before the machine turns to something else.
pub(crate) const STRETCH: usize = 256;

/// What is timed in its turn: so many elements in one go, by a clock of its own.
pub(crate) struct Turn<'a> {
    pub(crate) stretch: usize,
    /// How many nanoseconds these of the elements take.
    pub(crate) time: Box<dyn FnMut(Range<usize>) -> f64 + 'a>,
}

impl<'a> From<&'a mut Way> for Turn<'a> {
    fn from(way: &'a mut Way) -> Self {
        let time = |which| {
            let clock = Instant::now();
            (way.run)(which);
            clock.elapsed().as_secs_f64() * 1e9
        };
        Turn { stretch: way.stretch, time: Box::new(time) }
    }
}

/// The median time of one element in nanoseconds, for each way: the mean over all its stretches.
pub(crate) fn medians(ways: &mut [Way]) -> Vec<f64> {
    in_turn(ways.iter_mut().map(Turn::from).collect())
}

/// The same for whatever is timed.
pub(crate) fn in_turn(mut turns: Vec<Turn<'_>>) -> Vec<f64> {
    let mut times: Vec<_> = turns.iter().map(|turn| vec![[0.0; ROUNDS]; COUNT / turn.stretch]).collect();
    for round in 0..ROUNDS {
        for start in (0..COUNT).step_by(STRETCH) {
            for (turn, times) in turns.iter_mut().zip(&mut times) {
                let length = turn.stretch;
                if start.is_multiple_of(length) {
                    times[start / length][round] = (turn.time)(start..start + length) / length as f64;
                }
            }
        }
    }
    let median = |mut rounds: [f64; ROUNDS]| {
        rounds.sort_by(f64::total_cmp);
        rounds[ROUNDS / 2]
    };
    let mean = |turn: Vec<[f64; ROUNDS]>| {
        let stretches = turn.len();
        turn.into_iter().map(median).sum::<f64>() / stretches as f64
    };
    times.into_iter().map(mean).collect()
}

/// What one way takes, beside the first of its group.
pub(crate) struct Row<'a> {
    pub(crate) way: &'a Way,
    /// Whether it is the first of its group.
    pub(crate) opens: bool,
    /// Nanoseconds.
    pub(crate) time: f64,
    /// Instructions; NaN if they were not counted.
    pub(crate) count: f64,
    /// How many times the first one's time.
    pub(crate) slower: f64,
    /// How many times the first one's instructions.
    pub(crate) more: f64,
}

/// All ways beside the first of their groups, in order.
pub(crate) fn rows<'a>(ways: &'a [Way], times: &[f64], counts: Option<&[f64]>) -> Vec<Row<'a>> {
    let mut first = (0.0, 0.0);
    let mut group = "";
    let row = |(index, (way, time)): (usize, (&'a Way, &f64))| {
        let count = counts.map_or(f64::NAN, |counts| counts[index]);
        let opens = way.group != group;
        if opens {
            (group, first) = (way.group, (*time, count));
        }
        // Instructions that valgrind does not know are not counted; those of the next way are the measure then.
        if first.1.is_nan() {
            first.1 = count;
        }
        Row { way, opens, time: *time, count, slower: time / first.0, more: count / first.1 }
    };
    ways.iter().zip(times).enumerate().map(row).collect()
}

/// A table for the terminal: time, instructions, and how many times this library's they are.
pub(crate) fn table(ways: &[Way], times: &[f64], counts: Option<&[f64]>) -> String {
    let mut text = String::new();
    for Row { way, opens, time, count, slower, more } in rows(ways, times, counts) {
        let (group, name) = (way.group, way.name);
        if opens {
            let _ = writeln!(text, "\n{group:<38}{:>10}{:>8}{:>15}{:>8}", "time", "", "instructions", "");
        }
        let counted = if count.is_nan() { String::new() } else { format!("{count:>15.0}{more:>7.2}×") };
        let _ = writeln!(text, "  {name:<36}{time:>7.1} ns{slower:>7.2}×{counted}");
    }
    text.push('\n');
    text
}

/// How many times faster this library is than a peer; nothing if one of them was not timed on this machine.
pub(crate) fn ratio(ways: &[Way], times: &[f64], target: &Target) -> Option<f64> {
    let time = |name: &str| {
        let mut all = ways.iter().zip(times);
        all.find(|(way, _)| way.group == target.group && way.name == name).map(|(_, time)| *time)
    };
    Some(time(target.peer)? / time(target.ours)?)
}
