//! Rotations: R_ik·R_kj for each frame k on the way, and cofactors, since the inverse of a rotation is its transpose.

use super::Routes;
use crate::algebra::ring::{Poly, Var};
use crate::algebra::vector::{self, M3, V3};

/// A vector at the base of a group, seen in the frame before it: Rx(90°), except at the base of the arm.
pub(super) fn before(group: usize, v: &V3<Poly>) -> V3<Poly> {
    let [x, y, z] = v.clone();
    if group == 0 { [x, y, z] } else { [x, z.neg(), y] }
}

impl Routes<'_> {
    /// All orientations, and the ways to those that something stands in.
    pub(super) fn turns(&mut self) {
        let count = self.shape.groups.len();
        self.turned = vec![vec![Vec::new(); count]; count];
        let each = |i| (i..count).map(move |group| (i, group));
        for (i, group) in (0..count).flat_map(each) {
            for joint in 0..self.shape.groups[group].links.len() {
                let m = self.orientation(i, group, joint);
                self.turned[i][group].push(m);
            }
        }
        for (i, group) in (0..count).flat_map(each) {
            for (joint, link) in self.shape.groups[group].links.iter().enumerate() {
                if joint == self.last(group) || link.x || link.y {
                    self.ways_to_turn(i, group, joint);
                }
            }
        }
    }

    fn orientation(&mut self, i: usize, group: usize, joint: usize) -> M3<Poly> {
        let cos = self.angles[group][joint];
        let ring = &mut self.graph.ring;
        let (c, s) = (ring.var(cos), ring.var(Var(cos.0 + 1)));
        let own = vector::rotation(ring, 2, &c, &s);
        let columns = [0, 1, 2].map(|j| before(group, &vector::column(&own, j)));
        let own = vector::from_columns(&columns[0], &columns[1], &columns[2]);
        if group == i {
            return own;
        }
        let up_to = self.after(i, group - 1).clone();
        vector::product(&mut self.graph.ring, &up_to, &own)
    }

    fn ways_to_turn(&mut self, i: usize, group: usize, joint: usize) {
        let m = self.turned[i][group][joint].clone();
        let frame = self.number(group, joint);
        for (column, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let seen_in = self.seen_in(i);
            self.vector(&vector::column(&m, column), |row| format!("{letter}{frame}{row}{seen_in}"));
        }
        for middle in i + 1..=group {
            let left = self.after(i, middle - 1).clone();
            let right = self.turned[middle][group][joint].clone();
            for column in 0..3 {
                self.apply(&vector::column(&m, column), &left, &vector::column(&right, column));
            }
            // The same by rows, so that a row can change its derivation as one.
            let (left, right) = (left, vector::transpose(&right));
            for row in 0..3 {
                self.apply(&m[row], &right, &left[row]);
            }
        }
        if group > i && joint == self.last(group) {
            self.cofactors(&m);
            self.cofactors(&vector::transpose(&m));
        }
    }

    /// Each column is the product of the two others.
    fn cofactors(&mut self, m: &M3<Poly>) {
        for column in 0..3 {
            let (c, d) = ((column + 1) % 3, (column + 2) % 3);
            for row in 0..3 {
                let (r, s) = ((row + 1) % 3, (row + 2) % 3);
                let products = [(m[r][c].clone(), m[s][d].clone()), (m[r][d].neg(), m[s][c].clone())];
                self.graph.sum_of_products(&m[row][column], &products, true);
            }
            self.graph.close();
        }
    }
}
