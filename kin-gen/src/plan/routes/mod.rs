//! From a shape to the graph of its values: every way that this crate knows to derive them.
//!
//! Frame `i` of a shape stands after `i` groups, at the base of group `i`; frame 0 is the world's. Ways come from
//! these families of identities:
//!
//! * `turns`: a rotation is the product of two parts of it, split anywhere; an entry of it is its own cofactor
//! * `shifts`: a vector is the sum of its parts, and can be turned from any frame on the way into any other
//! * `rates`: the tip's velocity about an axis is z × w, in any frame, for w from any point of the axis
//! * `splits`: a value is A·cos + B·sin + C of each of its angles, and A·l + C of each of its lengths

#![allow(
    clippy::needless_range_loop,
    reason = "frames and steps are numbers of the shape, and index several tables at once"
)]

mod rates;
mod shifts;
mod splits;
mod turns;

use super::graph::{Graph, Signed};
use super::shape::{Direction, Shape};
use crate::algebra::ring::{Poly, Ring, Var};
use crate::algebra::vector::{self, M3, V3};

/// Which outputs a plan is for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Wanted {
    /// The rotation by rows, then the position.
    Pose,
    /// For each joint the velocity of the tip, then the axis; then the direction of each slide.
    Jacobian,
    /// The outputs of both.
    Both,
}

/// All of them.
pub const WANTED: [Wanted; 3] = [Wanted::Pose, Wanted::Jacobian, Wanted::Both];

impl Wanted {
    /// As a word.
    pub fn word(self) -> &'static str {
        match self {
            Wanted::Pose => "pose",
            Wanted::Jacobian => "jacobian",
            Wanted::Both => "both",
        }
    }
}

/// One length of the shape.
struct Step {
    /// The group in which it stands.
    group: usize,
    /// In which direction.
    along: Direction,
    /// The variable.
    length: Var,
}

/// Most values of a graph: beyond it no further splits are looked for.
const MOST_VALUES: usize = 60_000;

/// A graph being built.
pub struct Routes<'a> {
    shape: &'a Shape,
    /// The graph.
    pub graph: Graph,
    /// What is wanted, in the order of [`Wanted`].
    pub outputs: Vec<Signed>,
    /// The cosine of each joint's angle, by group; its sine is the next variable.
    angles: Vec<Vec<Var>>,
    /// The lengths, from the base to the tip; that along a group's axis comes first in its group.
    steps: Vec<Step>,
    /// The first step behind each joint.
    start: Vec<Vec<usize>>,
    /// By frame, group and joint in it: the orientation after that joint, seen in a frame before it.
    turned: Vec<Vec<Vec<M3<Poly>>>>,
    /// The values that are worth splitting.
    worth: Vec<Poly>,
}

impl<'a> Routes<'a> {
    /// The graph for these outputs of a shape.
    pub fn of(shape: &'a Shape, wanted: Wanted) -> Routes<'a> {
        let mut routes = Routes::leaves(shape);
        routes.turns();
        let shifts = routes.shifts();
        let mut outputs: Vec<Poly> = Vec::new();
        if wanted != Wanted::Jacobian {
            let last = shape.groups.len().saturating_sub(1);
            outputs.extend(routes.after(0, last).iter().flatten().cloned());
            outputs.extend(routes.shift(&shifts, 0, 0));
        }
        if wanted != Wanted::Pose {
            for group in 0..shape.groups.len() {
                routes.rates(group, &shifts);
            }
            outputs.extend(routes.columns(&shifts));
        }
        routes.splits();
        routes.outputs = outputs.iter().map(|p| routes.graph.value(p)).collect();
        routes
    }

    fn leaves(shape: &'a Shape) -> Routes<'a> {
        let mut ring = Ring::unbounded();
        let mut joints = 1..;
        let mut pair = |_| joints.next().map_or(Var(0), |joint| ring.pair(&joint.to_string()).0);
        let angles: Vec<Vec<Var>> =
            shape.groups.iter().map(|group| group.links.iter().map(&mut pair).collect()).collect();
        let (mut steps, mut start, mut joint) = (Vec::new(), Vec::new(), 0);
        for (group, links) in shape.groups.iter().enumerate() {
            let mut step = |name: String, along| steps.push(Step { group, along, length: ring.free(name) });
            if links.d {
                step(format!("d{}", group + 1), Direction::Axis(group));
            }
            let mut counts = Vec::new();
            for (index, link) in links.links.iter().enumerate() {
                joint += 1;
                counts.push([link.x, link.y]);
                if link.x {
                    step(format!("x{joint}"), Direction::X(group, index));
                }
                if link.y {
                    step(format!("y{joint}"), Direction::Y(group, index));
                }
            }
            let lengths = counts.iter().flatten().filter(|has| **has).count();
            let mut first = steps.len() - lengths;
            start.push(Vec::new());
            for has in counts {
                start[group].push(first);
                first += has.iter().filter(|has| **has).count();
            }
        }
        let mut graph = Graph::new(ring);
        let given = angles.iter().flatten().flat_map(|cos| [*cos, Var(cos.0 + 1)]);
        for var in given.chain(steps.iter().map(|s| s.length)).collect::<Vec<_>>() {
            let leaf = graph.ring.var(var);
            graph.leaf(&leaf);
        }
        Routes {
            shape,
            graph,
            outputs: Vec::new(),
            angles,
            steps,
            start,
            turned: Vec::new(),
            worth: Vec::new(),
        }
    }

    /// The last joint of a group.
    fn last(&self, group: usize) -> usize {
        self.shape.groups[group].links.len() - 1
    }

    /// The number of a joint of the shape, from 1.
    fn number(&self, group: usize, joint: usize) -> usize {
        self.shape.joints().position(|j| j == (group, joint)).map_or(0, |index| index + 1)
    }

    /// The frame after a group, seen in frame `i`.
    fn after(&self, i: usize, group: usize) -> &M3<Poly> {
        &self.turned[i][group][self.last(group)]
    }

    /// Where a vector's component is seen: nothing for the world, `_4` for the frame that turns with joint 4.
    fn seen_in(&self, frame: usize) -> String {
        match frame.checked_sub(1) {
            None => String::new(),
            Some(group) => format!("_{}", self.number(group, self.last(group))),
        }
    }

    /// A vector of frame `from`, seen in frame `to`.
    fn carried(&mut self, from: usize, to: usize, v: &V3<Poly>) -> V3<Poly> {
        if from == to {
            return v.clone();
        }
        let turn = if to < from {
            self.after(to, from - 1).clone()
        } else {
            vector::transpose(self.after(from, to - 1))
        };
        vector::apply(&mut self.graph.ring, &turn, v)
    }

    /// A direction of the shape, seen in frame `i`.
    fn direction(&mut self, i: usize, along: Direction) -> V3<Poly> {
        let (group, joint, column) = match along {
            Direction::Axis(group) => (group, self.last(group), 2),
            Direction::X(group, joint) => (group, joint, 0),
            Direction::Y(group, joint) => (group, joint, 1),
        };
        if i > group {
            let own = vector::column(&self.turned[group][group][joint], column);
            return self.carried(group, i, &own);
        }
        vector::column(&self.turned[i][group][joint], column)
    }

    /// The vector from the first step on to the tip; `first` may stand behind the last one.
    fn shift(&self, shifts: &[Vec<Vec<V3<Poly>>>], frame: usize, first: usize) -> V3<Poly> {
        let count = self.steps.len();
        if first < count { shifts[frame][first][count].clone() } else { Default::default() }
    }

    /// Says that `of` is the matrix times the vector.
    fn apply(&mut self, of: &V3<Poly>, m: &M3<Poly>, v: &V3<Poly>) {
        for (of, row) in of.iter().zip(m) {
            let products = [0, 1, 2].map(|j| (row[j].clone(), v[j].clone()));
            self.graph.sum_of_products(of, &products, false);
        }
        self.graph.close();
    }

    /// Says that `of` is the sum of two vectors.
    fn add(&mut self, of: &V3<Poly>, a: &V3<Poly>, b: &V3<Poly>) {
        let one = Poly::integer(1);
        for i in 0..3 {
            let terms = [(one.clone(), a[i].clone()), (one.clone(), b[i].clone())];
            self.graph.sum_of_products(&of[i], &terms, false);
        }
        self.graph.close();
    }

    /// Says that `of` is a multiple of a vector.
    fn scale(&mut self, of: &V3<Poly>, length: Var, v: &V3<Poly>) {
        let length = self.graph.ring.var(length);
        for i in 0..3 {
            self.graph.sum_of_products(&of[i], &[(length.clone(), v[i].clone())], false);
        }
        self.graph.close();
    }

    /// Says that `of` is the product of two vectors.
    fn cross(&mut self, of: &V3<Poly>, a: &V3<Poly>, b: &V3<Poly>) {
        for (of, (i, j)) in of.iter().zip([(1, 2), (2, 0), (0, 1)]) {
            let products = [(a[i].clone(), b[j].clone()), (a[j].neg(), b[i].clone())];
            self.graph.sum_of_products(of, &products, false);
        }
        self.graph.close();
    }

    /// Registers a vector that something may be derived from, and calls its components.
    fn vector(&mut self, v: &V3<Poly>, name: impl Fn(&str) -> String) {
        for (component, letter) in v.iter().zip(["x", "y", "z"]) {
            self.graph.value(component);
            self.graph.name(component, || name(letter));
            self.worth.push(component.clone());
        }
    }
}
