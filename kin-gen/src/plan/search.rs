//! The search for the cheapest closed set: simulated annealing over which way each value is computed.
//!
//! Every value remembers one way. Those reached from the outputs through the remembered ways are alive, and the cost
//! is their number. A move gives one value another way, or all components of a vector at once: a vector that changes
//! its derivation component by component would first have to become dearer. What a move no longer reaches dies but keeps
//! its memory. Moves that close a circle, or nest cofactors, are taken back. The numbers of moves and seeds are fixed and
//! all arithmetic is in integers, so that the result is a function of the graph.

use super::graph::{Graph, Id, Kind, Way};
use super::random::Random;

/// What of a graph can be computed and is of use.
#[derive(Debug)]
pub struct Space {
    /// The ways of each value; none for leaves and for what is of no use.
    pub ways: Vec<Vec<Way>>,
    outputs: Vec<Id>,
    /// Ways that belong together: pairs of a value and one of its ways.
    bundles: Vec<Vec<(Id, u32)>>,
    /// For each value the bundles it is in.
    member: Vec<Vec<u32>>,
}

/// A way for each value, and what computing the outputs by them costs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Solution {
    /// For each value the index of its way.
    pub choice: Vec<u32>,
    /// Multiplications.
    pub mul: usize,
    /// Additions.
    pub add: usize,
}

impl Solution {
    /// What is compared: all operations, then the additions.
    pub fn cost(&self) -> (usize, usize) {
        (self.mul + self.add, self.add)
    }
}

/// No place, no level.
const NONE: u32 = u32::MAX;

impl Space {
    /// The part of the graph that these outputs can be computed from.
    pub fn new(graph: &Graph, outputs: impl Iterator<Item = Id>) -> Space {
        let mut outputs: Vec<Id> = outputs.filter(|o| !graph.leaf[*o]).collect();
        outputs.sort_unstable();
        outputs.dedup();
        let computable = computable(graph);
        let usable = |way: &&Way| way.operands.iter().all(|o| computable[*o]);
        let mut reached = vec![false; graph.count()];
        let mut stack = outputs.clone();
        while let Some(id) = stack.pop() {
            if !std::mem::replace(&mut reached[id], true) {
                stack.extend(graph.ways[id].iter().filter(usable).flat_map(|w| w.operands));
            }
        }
        let of = |id: Id| match reached[id] && !graph.leaf[id] {
            true => graph.ways[id].iter().filter(usable).copied().collect(),
            false => Vec::new(),
        };
        let ways: Vec<Vec<Way>> = (0..graph.count()).map(of).collect();
        let mut bundles: Vec<Vec<(Id, u32)>> = graph.bundles.iter().map(|b| indices(&ways, b)).collect();
        bundles.sort_unstable();
        bundles.dedup();
        let mut member = vec![Vec::new(); graph.count()];
        for (index, bundle) in bundles.iter().enumerate() {
            for (id, _) in bundle {
                member[*id].push(index as u32);
            }
        }
        Space { ways, outputs, bundles, member }
    }

    /// The best of several runs.
    pub fn search(&self, seeds: std::ops::Range<u64>, moves: u32) -> Option<Solution> {
        seeds.map(|seed| self.anneal(seed, moves)).min_by_key(Solution::cost)
    }

    /// One run.
    pub fn anneal(&self, seed: u64, moves: u32) -> Solution {
        let mut random = Random::new(seed);
        let mut state = State::new(self, &mut random);
        let mut best = state.solution();
        for turn in 0..moves {
            state.step(&mut random, chance(turn, moves));
            if state.cost() < best.cost() {
                best = state.solution();
            }
        }
        best
    }
}

/// Which values can be computed from leaves at all.
fn computable(graph: &Graph) -> Vec<bool> {
    let mut good = graph.leaf.clone();
    loop {
        let mut changed = false;
        for id in 0..graph.count() {
            if !good[id] && graph.ways[id].iter().any(|w| w.operands.iter().all(|o| good[*o])) {
                good[id] = true;
                changed = true;
            }
        }
        if !changed {
            return good;
        }
    }
}

/// A bundle in terms of the ways that are left, one for each value.
fn indices(ways: &[Vec<Way>], bundle: &[(Id, Way)]) -> Vec<(Id, u32)> {
    let index = |(id, way): &(Id, Way)| Some((*id, ways[*id].iter().position(|w| w == way)? as u32));
    let mut indices: Vec<(Id, u32)> = bundle.iter().filter_map(index).collect();
    indices.sort_unstable();
    indices.dedup_by_key(|(id, _)| *id);
    indices
}

/// The chance of a move that costs one operation more, in 2⁻³²: from 0.37 down to almost nothing.
fn chance(turn: u32, moves: u32) -> u64 {
    let left = u64::from(moves - turn);
    let moves = u64::from(moves);
    let start = 1_590_000_000;
    start * left / moves * (moves + left) / (2 * moves)
}

/// The state of a run.
struct State<'a> {
    space: &'a Space,
    choice: Vec<u32>,
    /// How often each value is used.
    uses: Vec<u32>,
    /// The values that are alive, and where each of them stands among them.
    live: Vec<Id>,
    place: Vec<u32>,
    mul: usize,
    /// Marks of the last check: twice its number for what is done, one less for what is under way.
    mark: Vec<u32>,
    checks: u32,
    nested: Vec<bool>,
    /// What the present move has changed.
    log: Vec<(Id, u32)>,
}

impl<'a> State<'a> {
    fn new(space: &'a Space, random: &mut Random) -> State<'a> {
        let count = space.ways.len();
        let mut state = State {
            space,
            choice: first_choice(space, random),
            uses: vec![0; count],
            live: Vec::new(),
            place: vec![NONE; count],
            mul: 0,
            mark: vec![0; count],
            checks: 0,
            nested: vec![false; count],
            log: Vec::new(),
        };
        for output in &space.outputs {
            state.acquire(*output);
        }
        state
    }

    fn cost(&self) -> (usize, usize) {
        (self.live.len(), self.live.len() - self.mul)
    }

    fn solution(&self) -> Solution {
        Solution { choice: self.choice.clone(), mul: self.mul, add: self.live.len() - self.mul }
    }

    fn way(&self, id: Id) -> Option<&'a Way> {
        self.space.ways[id].get(self.choice[id] as usize)
    }

    fn acquire(&mut self, id: Id) {
        self.uses[id] += 1;
        if self.uses[id] == 1
            && let Some(way) = self.way(id)
        {
            self.mul += usize::from(way.kind == Kind::Mul);
            self.place[id] = self.live.len() as u32;
            self.live.push(id);
            way.operands.into_iter().for_each(|o| self.acquire(o));
        }
    }

    fn release(&mut self, id: Id) {
        self.uses[id] -= 1;
        if self.uses[id] == 0
            && let Some(way) = self.way(id)
        {
            self.mul -= usize::from(way.kind == Kind::Mul);
            let place = std::mem::replace(&mut self.place[id], NONE) as usize;
            self.live.swap_remove(place);
            if let Some(moved) = self.live.get(place) {
                self.place[*moved] = place as u32;
            }
            way.operands.into_iter().for_each(|o| self.release(o));
        }
    }

    /// Gives a value another way.
    fn switch(&mut self, id: Id, to: u32) {
        let old = self.way(id);
        self.choice[id] = to;
        if self.uses[id] > 0
            && let (Some(old), Some(new)) = (old, self.way(id))
        {
            self.mul += usize::from(new.kind == Kind::Mul);
            self.mul -= usize::from(old.kind == Kind::Mul);
            new.operands.into_iter().for_each(|o| self.acquire(o));
            old.operands.into_iter().for_each(|o| self.release(o));
        }
    }

    fn set(&mut self, id: Id, to: u32) {
        let old = self.choice[id];
        if old != to {
            self.log.push((id, old));
            self.switch(id, to);
        }
    }

    fn set_bundle(&mut self, bundle: u32) {
        let space = self.space;
        for &(id, way) in &space.bundles[bundle as usize] {
            self.set(id, way);
        }
    }

    /// One move, taken back unless it is cheaper or lucky.
    fn step(&mut self, random: &mut Random, chance: u64) {
        if self.live.is_empty() {
            return;
        }
        let before = self.live.len();
        self.log.clear();
        self.change(random);
        if self.log.is_empty() {
            return;
        }
        let dearer = self.live.len().saturating_sub(before);
        let lucky = (0..dearer).all(|_| random.bits() >> 32 < chance);
        if !lucky || !self.is_sound() {
            while let Some((id, way)) = self.log.pop() {
                self.switch(id, way);
            }
        }
    }

    fn change(&mut self, random: &mut Random) {
        let space = self.space;
        let id = self.live[random.below(self.live.len())];
        let kind = random.below(4);
        let bundles = &space.member[id];
        if kind == 0 || bundles.is_empty() {
            return self.set(id, random.below(space.ways[id].len()) as u32);
        }
        let bundle = bundles[random.below(bundles.len())];
        if kind > 1 {
            // What would come alive with it may have an outdated memory.
            let ways = &space.bundles[bundle as usize];
            let (member, way) = ways[random.below(ways.len())];
            let operand = space.ways[member][way as usize].operands[random.below(2)];
            let bundles = &space.member[operand];
            if self.uses[operand] == 0 && !bundles.is_empty() {
                self.set_bundle(bundles[random.below(bundles.len())]);
            }
        }
        self.set_bundle(bundle);
    }

    /// Whether what is alive can be put in order, and no cofactor is made from another one.
    fn is_sound(&mut self) -> bool {
        self.checks += 1;
        let space = self.space;
        space.outputs.iter().all(|output| self.visit(*output))
    }

    fn visit(&mut self, id: Id) -> bool {
        let done = 2 * self.checks;
        if self.mark[id] >= done - 1 {
            return self.mark[id] == done;
        }
        let Some(way) = self.way(id) else { return true };
        self.mark[id] = done - 1;
        let mut nested = false;
        for operand in way.operands {
            if !self.visit(operand) {
                return false;
            }
            nested |= self.nested[operand];
        }
        if nested && way.cofactor {
            return false;
        }
        self.nested[id] = nested || way.cofactor;
        self.mark[id] = done;
        true
    }
}

/// A random way for each value, from values that were computable before it, so that there is no circle.
fn first_choice(space: &Space, random: &mut Random) -> Vec<u32> {
    let count = space.ways.len();
    let mut level: Vec<u32> = space.ways.iter().map(|w| if w.is_empty() { 0 } else { NONE }).collect();
    let mut choice = vec![0; count];
    for round in 1.. {
        let mut reached = Vec::new();
        for (id, ways) in space.ways.iter().enumerate().filter(|(id, _)| level[*id] == NONE) {
            let ready = |w: &Way| !w.cofactor && w.operands.iter().all(|o| level[*o] < round);
            let ways: Vec<usize> = (0..ways.len()).filter(|w| ready(&ways[*w])).collect();
            if !ways.is_empty() {
                choice[id] = ways[random.below(ways.len())] as u32;
                reached.push(id);
            }
        }
        if reached.is_empty() {
            break;
        }
        for id in reached {
            level[id] = round;
        }
    }
    choice
}
