//! Velocities about the axis of a group: z × w for every stretch of lengths w behind the axis.

use super::Routes;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, V3};

/// By frame: vectors by first step and step behind the last, and the same for a unit of one step alone.
struct Rates {
    of: Vec<Vec<Vec<V3<Poly>>>>,
    of_unit: Vec<Vec<V3<Poly>>>,
}

impl Routes<'_> {
    /// The axis of a group, in a frame before it or in the one after it.
    fn axis(&self, i: usize, group: usize) -> V3<Poly> {
        if i > group { vector::unit(&self.graph.ring, 2) } else { vector::column(self.after(i, group), 2) }
    }

    /// All velocities about the axis of one group, with the ways to them.
    pub(super) fn rates(&mut self, group: usize, shifts: &[Vec<Vec<V3<Poly>>>]) {
        let (count, first) = (self.steps.len(), self.start[group][0]);
        let mut rates = Rates {
            of: vec![vec![vec![V3::default(); count + 1]; count + 1]; group + 2],
            of_unit: vec![vec![V3::default(); count]; group + 2],
        };
        let axis = self.axis(group, group);
        for step in first..count {
            let along = self.steps[step].along;
            let unit = self.direction(group, along);
            let unit = vector::cross(&mut self.graph.ring, &axis, &unit);
            for i in 0..group + 2 {
                rates.of_unit[i][step] = self.carried(group, i, &unit);
            }
            for end in step + 1..=count {
                let own = vector::cross(&mut self.graph.ring, &axis, &shifts[group][step][end]);
                for i in 0..group + 2 {
                    rates.of[i][step][end] = self.carried(group, i, &own);
                }
            }
        }
        for i in 0..group + 2 {
            for step in (first..count).filter(|step| i <= self.carrier(*step)).collect::<Vec<_>>() {
                self.ways_to_unit(&rates, group, i, step);
                for end in step + 1..=count {
                    self.ways_to_rate(&rates, shifts, group, i, step, end);
                }
            }
        }
    }

    fn ways_to_unit(&mut self, rates: &Rates, group: usize, i: usize, step: usize) {
        let (along, length) = (self.steps[step].along, self.steps[step].length);
        let unit = &rates.of_unit[i][step];
        self.worth.extend(unit.iter().cloned());
        self.scale(&rates.of[i][step][step + 1], length, unit);
        let direction = self.direction(i, along);
        self.cross(unit, &self.axis(i, group), &direction);
        for middle in i + 1..=self.carrier(step).min(group + 1) {
            let left = self.after(i, middle - 1).clone();
            self.apply(unit, &left, &rates.of_unit[middle][step]);
        }
    }

    fn ways_to_rate(
        &mut self,
        rates: &Rates,
        shifts: &[Vec<Vec<V3<Poly>>>],
        group: usize,
        i: usize,
        step: usize,
        end: usize,
    ) {
        let rate = &rates.of[i][step][end];
        let seen_in = self.seen_in(i);
        if end == self.steps.len() {
            let joint = (0..=self.last(group)).rev().find(|j| self.start[group][*j] <= step);
            let number = self.number(group, joint.unwrap_or(0));
            self.vector(rate, |row| format!("v{number}{row}{seen_in}"));
        } else {
            self.worth.extend(rate.iter().cloned());
        }
        let axis = self.axis(i, group);
        self.cross(rate, &axis, &shifts[i][step][end]);
        // An offset along the axis makes no difference.
        if step == self.start[group][0] && self.shape.groups[group].d {
            self.cross(rate, &axis, &shifts[i][step - 1][end]);
        }
        for middle in i + 1..=self.carrier(step).min(group + 1) {
            let left = self.after(i, middle - 1).clone();
            self.apply(rate, &left, &rates.of[middle][step][end]);
        }
        for split in step + 1..end {
            self.add(rate, &rates.of[i][step][split], &rates.of[i][split][end]);
        }
    }

    /// The columns of the Jacobian: for each joint the velocity and the axis, then the direction of each slide.
    pub(super) fn columns(&mut self, shifts: &[Vec<Vec<V3<Poly>>>]) -> Vec<Poly> {
        let mut columns = Vec::new();
        for (group, joint) in self.shape.joints().collect::<Vec<_>>() {
            let w = self.shift(shifts, group, self.start[group][joint]);
            let axis = self.axis(group, group);
            let rate = vector::cross(&mut self.graph.ring, &axis, &w);
            columns.extend(self.carried(group, 0, &rate));
            columns.extend(self.axis(0, group));
        }
        for slide in &self.shape.slides {
            columns.extend(self.direction(0, *slide));
        }
        columns
    }
}
