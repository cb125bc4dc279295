//! A plan as text: straight-line code over the leaves of a shape.
//!
//! ```text
//! [pose . .]
//! x2y=s1*c2
//! y2x=-c1*s2
//! =k1 y2x 0 …
//! ```
//!
//! Leaves are `c1` and `s1`, cosine and sine of the (fused) angle of joint 1, `x1` and `y1`, the lengths behind it, and
//! `d1`, the offset along the axes of group 1. A name that is not `k` and a number says what the value is; joints in it
//! are counted from the first of the shape. What follows `~` only keeps names apart.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::graph::{Graph, Id, Kind, ONE, Signed, ZERO};
use super::search::{Solution, Space};

/// A signed name; `0` and `1` name themselves.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Operand<'a> {
    /// The name.
    pub name: &'a str,
    /// Whether the negative is meant.
    pub negative: bool,
}

/// One line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Line<'a> {
    /// What it is called.
    pub name: &'a str,
    /// What is done.
    pub kind: Kind,
    /// With what, both signs left apart.
    pub operands: [&'a str; 2],
    /// Whether the negative of that is meant.
    pub negative: bool,
}

/// A plan, read.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Recipe<'a> {
    /// The lines, operands first.
    pub lines: Vec<Line<'a>>,
    /// What is wanted.
    pub outputs: Vec<Operand<'a>>,
}

impl<'a> Recipe<'a> {
    /// Reads the lines behind a header, up to and including that of the outputs.
    pub fn parse(text: &'a str) -> Option<Recipe<'a>> {
        let mut recipe = Recipe::default();
        for line in text.lines() {
            let (name, value) = line.split_once('=')?;
            if name.is_empty() {
                recipe.outputs = value.split(' ').map(operand).collect();
                return Some(recipe);
            }
            let Operand { name: value, negative } = operand(value);
            let sign = value.find(['*', '+', '-'])?;
            let kind = match value.as_bytes().get(sign) {
                Some(b'*') => Kind::Mul,
                Some(b'+') => Kind::Add,
                _ => Kind::Sub,
            };
            let (left, right) = (value.get(..sign)?, value.get(sign + 1..)?);
            recipe.lines.push(Line { name, kind, operands: [left, right], negative });
        }
        None
    }
}

fn operand(text: &str) -> Operand<'_> {
    match text.strip_prefix('-') {
        Some(name) => Operand { name, negative: true },
        None => Operand { name: text, negative: false },
    }
}

/// A minus sign before a line means the negative of all of it: `-a+b` is -(a + b).
impl fmt::Display for Line<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let operation = match self.kind {
            Kind::Mul => '*',
            Kind::Add => '+',
            Kind::Sub => '-',
        };
        let sign = if self.negative { "-" } else { "" };
        write!(f, "{}={sign}{}{operation}{}", self.name, self.operands[0], self.operands[1])
    }
}

/// Writes down what a search has found.
pub struct Writer<'a> {
    graph: &'a Graph,
    space: &'a Space,
    solution: &'a Solution,
    text: String,
    names: BTreeMap<Id, (String, bool)>,
    taken: BTreeSet<String>,
    fresh: usize,
}

impl<'a> Writer<'a> {
    /// With nothing written yet.
    pub fn new(graph: &'a Graph, space: &'a Space, solution: &'a Solution) -> Writer<'a> {
        Writer {
            graph,
            space,
            solution,
            text: String::new(),
            names: BTreeMap::new(),
            taken: BTreeSet::new(),
            fresh: 0,
        }
    }

    /// The text of the plan, with the line of the outputs.
    pub fn write(mut self, outputs: &[Signed]) -> String {
        let outputs: Vec<String> = outputs
            .iter()
            .map(|output| {
                let (name, negative) = self.computed(output.id);
                let minus = if negative != output.negative && output.id != ZERO { "-" } else { "" };
                format!("{minus}{name}")
            })
            .collect();
        self.text.push_str(&format!("={}\n", outputs.join(" ")));
        self.text
    }

    /// The name of a value, written before if need be, and whether it names the value's negative.
    fn computed(&mut self, id: Id) -> (String, bool) {
        if let Some(known) = self.names.get(&id) {
            return known.clone();
        }
        let way = self.space.ways[id].get(self.solution.choice[id] as usize);
        let Some(way) = way else { return (self.leaf(id), false) };
        let [(a, minus_a), (b, minus_b)] = way.operands.map(|o| self.computed(o));
        let (name, named_negative) = self.name(id);
        // The value is ±(a·b) or ±(a ± b) of the canonical operands; what stands in the text may be their negatives.
        let kind = match (way.kind, minus_a == minus_b) {
            (Kind::Mul, _) => Kind::Mul,
            (Kind::Add, true) | (Kind::Sub, false) => Kind::Add,
            _ => Kind::Sub,
        };
        let flipped = if way.kind == Kind::Mul { minus_a != minus_b } else { minus_a };
        let mut negative = way.negative != flipped;
        negative ^= named_negative;
        let (mut left, mut right) = (a, b);
        if kind == Kind::Sub && negative {
            (left, right, negative) = (right, left, false);
        }
        let line = Line { name: &name, kind, operands: [&left, &right], negative };
        self.text.push_str(&format!("{line}\n"));
        self.names.insert(id, (name.clone(), named_negative));
        (name, named_negative)
    }

    fn leaf(&self, id: Id) -> String {
        match (id, self.graph.poly(id)) {
            (ZERO, _) | (_, None) => "0".to_owned(),
            (ONE, _) => "1".to_owned(),
            (_, Some(poly)) => self.graph.ring.show(poly).to_string(),
        }
    }

    fn name(&mut self, id: Id) -> (String, bool) {
        let Some((name, negative)) = self.graph.names[id].clone() else {
            self.fresh += 1;
            return (format!("k{}", self.fresh), false);
        };
        let mut unique = name.clone();
        let mut count = 1;
        while !self.taken.insert(unique.clone()) {
            count += 1;
            unique = format!("{name}~{count}");
        }
        (unique, negative)
    }
}
