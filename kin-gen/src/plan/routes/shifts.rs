//! Vectors along the arm: from the base to the tip every stretch of its lengths, in every frame up to the one that
//! carries its first length.

use super::Routes;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, V3};
use crate::plan::shape::Direction;

impl Routes<'_> {
    /// The deepest frame in which a length, and all that come after it, are seen without turning back.
    pub(super) fn carrier(&self, step: usize) -> usize {
        let group = self.steps[step].group;
        match self.steps[step].along {
            Direction::X(_, joint) | Direction::Y(_, joint) if joint != self.last(group) => group,
            _ => group + 1,
        }
    }

    /// By frame, first step and step behind the last: the vectors, with the ways to them.
    pub(super) fn shifts(&mut self) -> Vec<Vec<Vec<V3<Poly>>>> {
        let (count, frames) = (self.steps.len(), self.shape.groups.len() + 1);
        let mut all = vec![vec![vec![V3::default(); count + 1]; count + 1]; frames];
        for (i, seen) in all.iter_mut().enumerate() {
            for (first, vectors) in seen.iter_mut().enumerate().take(count) {
                if i <= self.carrier(first) {
                    self.sums(i, first, vectors);
                }
            }
        }
        for i in 0..frames {
            for first in (0..count).filter(|first| i <= self.carrier(*first)).collect::<Vec<_>>() {
                for end in first + 1..=count {
                    self.ways_to_shift(&all, i, first, end);
                }
            }
        }
        all
    }

    fn sums(&mut self, i: usize, first: usize, vectors: &mut [V3<Poly>]) {
        let mut sum = V3::default();
        for end in first + 1..=self.steps.len() {
            let (along, length) = (self.steps[end - 1].along, self.steps[end - 1].length);
            let unit = self.direction(i, along);
            let factor = self.graph.ring.var(length);
            let term = vector::scale(&mut self.graph.ring, &factor, &unit);
            sum = vector::add(&mut self.graph.ring, &sum, &term);
            vectors[end] = sum.clone();
            if end == first + 1 {
                self.scale(&sum, length, &unit);
            }
        }
    }

    fn ways_to_shift(&mut self, all: &[Vec<Vec<V3<Poly>>>], i: usize, first: usize, end: usize) {
        let v = &all[i][first][end];
        let from = self.behind(first);
        let seen_in = self.seen_in(i);
        match end == self.steps.len() {
            true if first == 0 && i == 0 => self.vector(v, |row| format!("p{row}")),
            true => self.vector(v, |row| format!("w{from}{row}{seen_in}")),
            false => self.vector(v, |row| format!("l{from}{row}{seen_in}")),
        }
        for middle in i + 1..=self.carrier(first) {
            let left = self.after(i, middle - 1).clone();
            self.apply(v, &left, &all[middle][first][end]);
        }
        for split in first + 1..end {
            self.add(v, &all[i][first][split], &all[i][split][end]);
        }
    }

    /// The joint behind which a step stands.
    pub(super) fn behind(&self, step: usize) -> usize {
        match self.steps[step].along {
            Direction::Axis(group) => self.number(group, 0),
            Direction::X(group, joint) | Direction::Y(group, joint) => self.number(group, joint),
        }
    }
}
