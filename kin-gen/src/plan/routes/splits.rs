//! Splits of single values: A·cos + B·sin + C on one angle, A·l + C on one length.

use std::collections::BTreeSet;

use super::{MOST_VALUES, Routes};
use crate::algebra::ring::{Poly, Var};
use crate::plan::graph::Id;

/// With more joints than these, values are split only on their first and their last angle: splits on those between
/// have been seen to save one operation in a hundred, and make the graph three times as large.
const MOST_JOINTS: usize = 6;

impl Routes<'_> {
    /// Splits everything that is worth it, and the parts again, short polynomials first, until nothing new appears.
    pub(super) fn splits(&mut self) {
        let (mut queue, mut queued) = (BTreeSet::new(), BTreeSet::new());
        let worth = std::mem::take(&mut self.worth);
        self.queue(&worth, &mut queue, &mut queued);
        while let Some((_, id)) = queue.pop_first() {
            if self.graph.count() >= MOST_VALUES {
                break;
            }
            if let Some(poly) = self.graph.poly(id).cloned() {
                let parts = self.split(&poly);
                self.queue(&parts, &mut queue, &mut queued);
            }
        }
    }

    fn queue(&self, polys: &[Poly], queue: &mut BTreeSet<(usize, Id)>, queued: &mut BTreeSet<Id>) {
        for poly in polys {
            if let Some(value) = self.graph.find(poly)
                && !self.graph.leaf[value.id]
                && queued.insert(value.id)
            {
                queue.insert((poly.len(), value.id));
            }
        }
    }

    /// All splits of one value; the parts.
    fn split(&mut self, poly: &Poly) -> Vec<Poly> {
        let one = Poly::integer(1);
        let mut parts = Vec::new();
        let angles: Vec<Var> = self.angles.iter().flatten().copied().collect();
        let split = |cos| Some((cos, self.graph.ring.split_by_angle(poly, cos)?));
        let mut splits: Vec<(Var, [Poly; 3])> = angles.into_iter().filter_map(split).collect();
        splits.retain(|(_, [a, b, _])| !a.is_zero() || !b.is_zero());
        if self.angles.iter().flatten().count() > MOST_JOINTS && splits.len() > 2 {
            splits.drain(1..splits.len() - 1);
        }
        for (cos, [a, b, c]) in splits {
            parts.extend([a.clone(), b.clone(), c.clone()]);
            let (cosine, sine) = (self.graph.ring.var(cos), self.graph.ring.var(Var(cos.0 + 1)));
            self.graph.sum_of_products(poly, &[(cosine, a), (sine, b), (c, one.clone())], false);
            self.graph.close();
        }
        for length in self.steps.iter().map(|s| s.length).collect::<Vec<_>>() {
            let Some([a, c]) = self.graph.ring.split(poly, length) else { continue };
            if a.is_zero() {
                continue;
            }
            parts.extend([a.clone(), c.clone()]);
            let length = self.graph.ring.var(length);
            self.graph.sum_of_products(poly, &[(length, a), (c, one.clone())], false);
            self.graph.close();
        }
        parts
    }
}
