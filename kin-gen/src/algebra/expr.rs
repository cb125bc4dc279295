//! The graph in which code is built: hash-consed expressions, equal up to sign when their ids are.
//!
//! There is no optimiser after this: every simplification is a constructor here. Zero and one disappear, constants
//! fold exactly (their meaning is a polynomial of the ring, so nothing is rounded), signs move outwards, where they
//! are free, and the same operation on the same operands is the same node.

use std::collections::BTreeMap;

use super::ring::{Factor, Poly, Ring};
pub use super::turn::Turn;
use super::vector::Algebra;
use crate::chain::AngleSum;
use crate::number::Angle;

/// A node of the graph.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Id(pub u32);

/// A node with a sign: negation costs nothing and is never a node.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Term {
    /// The node.
    pub id: Id,
    /// Whether its negative is meant.
    pub negative: bool,
}

impl Term {
    /// The exact 0.
    pub const ZERO: Term = Term { id: Id(0), negative: false };
    /// The exact 1.
    pub const ONE: Term = Term { id: Id(1), negative: false };

    fn negated_if(self, negate: bool) -> Term {
        Term { id: self.id, negative: (self.negative != negate) && self != Term::ZERO }
    }
}

/// What a node is. Operands are always older than the node.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Node {
    /// 0.
    Zero,
    /// 1.
    One,
    /// A constant: an index into the constants of [`Exprs`].
    Constant(usize),
    /// A length parameter of the arm.
    Param(usize),
    /// The commanded value of a prismatic joint.
    Slide(usize),
    /// An entry of the given pose: `3·row + column` of the rotation, then 9, 10, 11 for the position.
    Entry(usize),
    /// The cosine of a turn: an index into the turns of [`Exprs`].
    Cos(usize),
    /// The sine of a turn.
    Sin(usize),
    /// a + b.
    Add(Id, Id),
    /// a - b.
    Sub(Id, Id),
    /// a·b.
    Mul(Id, Id),
}

/// Hash buckets of the graph: about as many as a large arm has nodes.
const BUCKETS: usize = 1024;

impl Node {
    /// Where to look for it: a fixed function, so that output never depends on a seed.
    fn bucket(self) -> usize {
        let (kind, a, b) = match self {
            Node::Zero => (0, 0, 0),
            Node::One => (1, 0, 0),
            Node::Constant(index) => (2, index, 0),
            Node::Param(index) => (3, index, 0),
            Node::Slide(index) => (4, index, 0),
            Node::Entry(index) => (5, index, 0),
            Node::Cos(turn) => (6, turn, 0),
            Node::Sin(turn) => (7, turn, 0),
            Node::Add(a, b) => (8, a.0 as usize, b.0 as usize),
            Node::Sub(a, b) => (9, a.0 as usize, b.0 as usize),
            Node::Mul(a, b) => (10, a.0 as usize, b.0 as usize),
        };
        (kind * 331 + a * 37 + b * 101) % BUCKETS
    }
}

/// A state of the graph to which it can be rolled back.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mark {
    nodes: usize,
    constants: usize,
    turns: usize,
}

/// The graph.
#[derive(Clone, Debug)]
pub struct Exprs {
    /// The ring in which constants have their meaning.
    pub ring: Ring,
    nodes: Vec<Node>,
    /// The newest node of each hash bucket, and for each node the next older one of its bucket: as nodes are only
    /// added and taken back at the end, rolling back restores both exactly.
    newest: Vec<Option<Id>>,
    older: Vec<Option<Id>>,
    constants: Vec<Poly>,
    turns: Vec<Turn>,
    labels: BTreeMap<Id, (String, Option<bool>)>,
}

impl Exprs {
    /// A graph with only 0 and 1.
    pub fn new(ring: Ring) -> Exprs {
        let mut exprs = Exprs {
            ring,
            nodes: Vec::new(),
            newest: vec![None; BUCKETS],
            older: Vec::new(),
            constants: Vec::new(),
            turns: Vec::new(),
            labels: BTreeMap::new(),
        };
        exprs.intern(Node::Zero);
        exprs.intern(Node::One);
        exprs
    }

    /// What a node is.
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id.0 as usize]
    }

    /// The nodes, oldest first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The meaning of a constant.
    pub fn constant_meaning(&self, index: usize) -> &Poly {
        &self.constants[index]
    }

    /// A turn by its index.
    pub fn turn(&self, index: usize) -> &Turn {
        &self.turns[index]
    }

    fn intern(&mut self, node: Node) -> Id {
        let bucket = node.bucket();
        let mut next = self.newest[bucket];
        while let Some(id) = next {
            if self.nodes[id.0 as usize] == node {
                return id;
            }
            next = self.older[id.0 as usize];
        }
        let id = Id(self.nodes.len() as u32);
        self.nodes.push(node);
        self.older.push(self.newest[bucket]);
        self.newest[bucket] = Some(id);
        id
    }

    fn leaf(&mut self, node: Node) -> Term {
        Term { id: self.intern(node), negative: false }
    }

    /// The present state.
    pub fn mark(&self) -> Mark {
        Mark { nodes: self.nodes.len(), constants: self.constants.len(), turns: self.turns.len() }
    }

    /// Forgets everything made since the mark.
    pub fn roll_back(&mut self, mark: Mark) {
        while self.nodes.len() > mark.nodes {
            if let (Some(node), Some(older)) = (self.nodes.pop(), self.older.pop()) {
                self.newest[node.bucket()] = older;
            }
        }
        self.constants.truncate(mark.constants);
        self.turns.truncate(mark.turns);
        self.labels.split_off(&Id(mark.nodes as u32));
    }

    /// Suggests a textbook name for a computed value; the first suggestion stays.
    pub fn label(&mut self, term: Term, name: impl FnOnce() -> String) {
        if matches!(self.node(term.id), Node::Add(..) | Node::Sub(..) | Node::Mul(..)) {
            self.labels.entry(term.id).or_insert_with(|| (name(), Some(term.negative)));
        }
    }

    /// The same for a name that says nothing about the sign: along an axis whose direction is nobody's choice.
    pub fn label_up_to_sign(&mut self, term: Term, name: impl FnOnce() -> String) {
        if matches!(self.node(term.id), Node::Add(..) | Node::Sub(..) | Node::Mul(..)) {
            self.labels.entry(term.id).or_insert_with(|| (name(), None));
        }
    }

    /// The name suggested for a node, and whether it names the node's negative; either will do where that is not said.
    pub fn label_of(&self, id: Id) -> Option<(&str, Option<bool>)> {
        self.labels.get(&id).map(|(name, negative)| (name.as_str(), *negative))
    }

    /// Multiplications and additions made since the mark.
    pub fn work_since(&self, mark: Mark) -> usize {
        self.nodes[mark.nodes..]
            .iter()
            .filter(|n| matches!(n, Node::Add(..) | Node::Sub(..) | Node::Mul(..)))
            .count()
    }

    /// A constant with this meaning.
    pub fn constant(&mut self, meaning: Poly) -> Term {
        match meaning.as_unit() {
            Some(0) => return Term::ZERO,
            Some(unit) => return Term::ONE.negated_if(unit < 0),
            None => {}
        }
        // Two different lengths of equal value cancel; a single term never does.
        if meaning.len() > 1 && self.ring.vanishes(&meaning) {
            return Term::ZERO;
        }
        let negative = meaning.leads_negative();
        let meaning = if negative { meaning.neg() } else { meaning };
        let index = self.constants.iter().position(|c| *c == meaning).unwrap_or_else(|| {
            self.constants.push(meaning);
            self.constants.len() - 1
        });
        self.leaf(Node::Constant(index)).negated_if(negative)
    }

    /// A polynomial in constants and parameters.
    pub fn polynomial(&mut self, meaning: &Poly) -> Term {
        let mut sum = Term::ZERO;
        for (varying, coefficient) in self.ring.by_varying(meaning) {
            let mut term = self.constant(coefficient);
            // What is fixed in the arm varies with its parameters only.
            for factor in self.ring.factors_in(&varying).unwrap_or_default() {
                let factor = self.factor(factor);
                term = self.mul(term, factor);
            }
            sum = self.add(sum, term);
        }
        sum
    }

    fn factor(&mut self, factor: Factor) -> Term {
        let turn = |index| Turn {
            rest: AngleSum { params: vec![(1, index)], ..AngleSum::default() },
            ..Turn::default()
        };
        match factor {
            Factor::Length(index) => self.param(index),
            Factor::Cosine(index) => self.cos_sin(&turn(index)).0,
            Factor::Sine(index) => self.cos_sin(&turn(index)).1,
        }
    }

    /// A length parameter.
    pub fn param(&mut self, index: usize) -> Term {
        self.leaf(Node::Param(index))
    }

    /// The value of a prismatic joint.
    pub fn slide(&mut self, joint: usize) -> Term {
        self.leaf(Node::Slide(joint))
    }

    /// An entry of the given pose.
    pub fn entry(&mut self, index: usize) -> Term {
        self.leaf(Node::Entry(index))
    }

    /// Cosine and sine of a turn; quarter turns and signs come out of the argument.
    pub fn cos_sin(&mut self, turn: &Turn) -> (Term, Term) {
        if turn.is_constant() {
            let (cos, sin) = self.ring.constant_pair(turn.rest.constant);
            return (self.constant(cos), self.constant(sin));
        }
        let mut turn = turn.clone();
        let quarters = turn.rest.constant.quarters();
        if quarters.is_some() {
            turn.rest.constant = Angle::zero();
        }
        let negative = turn.leads_negative();
        if negative {
            // Negating a sum that was representable stays representable.
            turn = Turn::default().plus(&turn, -1).unwrap_or(turn);
        }
        let index = self.turns.iter().position(|t| *t == turn).unwrap_or_else(|| {
            self.turns.push(turn);
            self.turns.len() - 1
        });
        let cos = self.leaf(Node::Cos(index));
        let sin = self.leaf(Node::Sin(index)).negated_if(negative);
        match quarters.unwrap_or(0).rem_euclid(4) {
            0 => (cos, sin),
            1 => (sin.negated_if(true), cos),
            2 => (cos.negated_if(true), sin.negated_if(true)),
            _ => (sin, cos.negated_if(true)),
        }
    }

    /// The meaning of a term that is a constant.
    pub fn as_constant(&self, term: Term) -> Option<Poly> {
        let meaning = match self.node(term.id) {
            Node::Zero => Poly::zero(),
            Node::One => Poly::integer(1),
            Node::Constant(index) => self.constants[index].clone(),
            _ => return None,
        };
        Some(if term.negative { meaning.neg() } else { meaning })
    }

    /// The negative.
    pub fn neg(&self, a: Term) -> Term {
        a.negated_if(true)
    }

    /// The sum.
    pub fn add(&mut self, a: Term, b: Term) -> Term {
        if a == Term::ZERO {
            return b;
        }
        if b == Term::ZERO {
            return a;
        }
        if a.id == b.id && a.negative != b.negative {
            return Term::ZERO;
        }
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b)) {
            let sum = self.ring.add(&x, &y);
            return self.constant(sum);
        }
        let (first, second) = if a.id <= b.id { (a, b) } else { (b, a) };
        let node = if first.negative == second.negative {
            Node::Add(first.id, second.id)
        } else {
            Node::Sub(first.id, second.id)
        };
        self.leaf(node).negated_if(first.negative)
    }

    /// The difference.
    pub fn sub(&mut self, a: Term, b: Term) -> Term {
        self.add(a, b.negated_if(true))
    }

    /// The product.
    pub fn mul(&mut self, a: Term, b: Term) -> Term {
        let negative = a.negative != b.negative;
        if a == Term::ZERO || b == Term::ZERO {
            return Term::ZERO;
        }
        if a.id == Term::ONE.id {
            return Term { id: b.id, negative };
        }
        if b.id == Term::ONE.id {
            return Term { id: a.id, negative };
        }
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b)) {
            let product = self.ring.mul(&x, &y);
            return self.constant(product);
        }
        let (first, second) = if a.id <= b.id { (a.id, b.id) } else { (b.id, a.id) };
        self.leaf(Node::Mul(first, second)).negated_if(negative)
    }
}

impl Algebra for Exprs {
    type Value = Term;

    fn zero(&self) -> Term {
        Term::ZERO
    }

    fn one(&self) -> Term {
        Term::ONE
    }

    fn plus(&mut self, a: &Term, b: &Term) -> Term {
        self.add(*a, *b)
    }

    fn times(&mut self, a: &Term, b: &Term) -> Term {
        self.mul(*a, *b)
    }

    fn minus(&mut self, a: &Term) -> Term {
        self.neg(*a)
    }
}
