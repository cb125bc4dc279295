//! From frames to expressions: which equal derivation of each wanted function is the cheapest.
//!
//! A vector fixed in some frame can be brought to the world in many exactly equal ways: turned down frame by frame, or
//! combined from the columns of any frame on the way, which other vectors may already have paid for. For most arms a plan
//! of [`crate::plan`] says how. For an arm whose structure has none, [`Deriver`] does it in one [`Style`]: each wanted set
//! of outputs is derived in every style and order that its file lists, and the cheapest is kept. Nothing is approximated
//! and nothing is believed: the result is proved afterwards.
//!
//! * [`pose`]: forward kinematics and all frames
//! * [`jacobian`]: the geometric Jacobian, alone and with the pose
//! * [`wrist`]: ³R₆, ⁰R₃ with the wrist centre, and what inverse kinematics asks of a pose

pub mod jacobian;
pub mod pose;
pub mod wrist;

use crate::algebra::expr::{Exprs, Mark as GraphMark, Term};
use crate::algebra::frame::{Carrier, Frames, Mark};
use crate::algebra::vector::{self, M3, V3};

/// What the structure's own plan yields; where there is only a plan of a larger structure, that or the styles, whichever
/// is cheaper.
pub fn planned_or<T>(
    exprs: &mut Exprs,
    by_plan: impl Fn(&mut Exprs) -> Option<(T, bool)>,
    by_style: impl Fn(&mut Exprs) -> T,
) -> T {
    let start = exprs.mark();
    let mut work = usize::MAX;
    match by_plan(exprs) {
        Some((planned, true)) => return planned,
        Some(_) => work = exprs.work_since(start),
        None => {}
    }
    exprs.roll_back(start);
    let styled = by_style(exprs);
    if exprs.work_since(start) <= work {
        return styled;
    }
    exprs.roll_back(start);
    match by_plan(exprs) {
        Some((planned, _)) => planned,
        None => styled,
    }
}

/// How vectors are brought to the world.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Style {
    /// Turned down frame by frame.
    Descend,
    /// Combined from the columns of their own frame, which are built from the world upwards.
    Columns,
    /// Whichever adds least to what is already there.
    Greedy,
}

/// All styles, in the order in which they are tried; the first of equals wins.
pub const STYLES: [Style; 3] = [Style::Descend, Style::Columns, Style::Greedy];

/// The orientations on the way from the world: 0 is the world, 2g+1 the frame of group g, 2g+2 the frame after it.
type Level = usize;

/// Derives vectors over one graph.
pub struct Deriver<'a> {
    /// The graph.
    pub exprs: &'a mut Exprs,
    /// The frames.
    pub frames: &'a Frames,
    style: Style,
    /// Columns of orientations in the world, as far as they are known.
    columns: Vec<((Level, usize), V3<Term>)>,
}

impl<'a> Deriver<'a> {
    /// Without anything derived yet.
    pub fn new(exprs: &'a mut Exprs, frames: &'a Frames, style: Style) -> Deriver<'a> {
        Deriver { exprs, frames, style, columns: Vec::new() }
    }

    /// Tries each way and keeps the one that adds the fewest operations.
    pub fn cheapest<T>(&mut self, ways: &[&dyn Fn(&mut Self) -> T]) -> Option<T> {
        let mut best: Option<(usize, usize)> = None;
        if ways.len() > 1 {
            for (index, way) in ways.iter().enumerate() {
                let (mark, known) = self.mark();
                way(self);
                let work = self.exprs.work_since(mark);
                self.roll_back((mark, known));
                if best.is_none_or(|(least, _)| work < least) {
                    best = Some((work, index));
                }
            }
        }
        let index = best.map_or(0, |(_, index)| index);
        ways.get(index).map(|way| way(self))
    }

    fn mark(&self) -> (GraphMark, usize) {
        (self.exprs.mark(), self.columns.len())
    }

    fn roll_back(&mut self, (mark, known): (GraphMark, usize)) {
        self.exprs.roll_back(mark);
        self.columns.truncate(known);
    }

    /// A vector's components named `{name}x_{frame}` and so on; in the world without the frame.
    pub fn label(&mut self, v: &V3<Term>, name: &dyn Fn(usize) -> String, level: Level) {
        let seen_from = match level {
            0 => String::new(),
            _ => {
                let group = &self.frames.groups[(level - 1) / 2];
                let stage = if !level.is_multiple_of(2) { group.stages.first() } else { group.stages.last() };
                match stage.map_or(0, |s| s.joint + usize::from(level.is_multiple_of(2))) {
                    0 => String::new(),
                    joint => format!("_{joint}"),
                }
            }
        };
        for (i, term) in v.iter().enumerate() {
            self.exprs.label(*term, || format!("{}{seen_from}", name(i)));
        }
    }

    /// Rz of the turn at `stage` of `group`, applied.
    pub fn turn(&mut self, group: usize, stage: usize, v: &V3<Term>) -> V3<Term> {
        let turn = self.frames.groups[group].stages[stage].turn.clone();
        let [x, y, z] = *v;
        if x == Term::ZERO && y == Term::ZERO {
            return *v;
        }
        let (c, s) = self.exprs.cos_sin(&turn);
        let on = &mut *self.exprs;
        let (cx, sy) = (on.mul(c, x), on.mul(s, y));
        let (sx, cy) = (on.mul(s, x), on.mul(c, y));
        [on.sub(cx, sy), on.add(sx, cy), z]
    }

    /// Rz of the turn, undone.
    pub fn turn_back(&mut self, group: usize, stage: usize, v: &V3<Term>) -> V3<Term> {
        let [x, y, z] = *v;
        let minus_y = self.exprs.neg(y);
        let [x, y, z] = self.turn(group, stage, &[x, minus_y, z]);
        [x, self.exprs.neg(y), z]
    }

    /// One level down.
    fn down(&mut self, level: Level, v: &V3<Term>) -> V3<Term> {
        let group = (level - 1) / 2;
        if level.is_multiple_of(2) {
            let last = self.frames.groups[group].stages.len() - 1;
            self.turn(group, last, v)
        } else {
            let m = self.frames.groups[group].from_previous;
            vector::apply(self.exprs, &m, v)
        }
    }

    /// A vector, given in the orientation of `level`, in the axes of the world.
    pub fn to_world(&mut self, level: Level, v: &V3<Term>, name: &dyn Fn(usize) -> String) -> V3<Term> {
        if let Some(axis) = unit_axis(v) {
            return self.column(level, axis, name);
        }
        self.by_style(level, v, name)
    }

    fn by_style(&mut self, level: Level, v: &V3<Term>, name: &dyn Fn(usize) -> String) -> V3<Term> {
        match self.style {
            Style::Descend => self.descend(level, 0, v, name),
            Style::Columns => self.combine(level, v),
            Style::Greedy => {
                let mut best = (usize::MAX, 0);
                for split in 0..=level {
                    let mark = self.mark();
                    self.split(level, split, v, name);
                    let work = self.exprs.work_since(mark.0);
                    self.roll_back(mark);
                    if work < best.0 {
                        best = (work, split);
                    }
                }
                self.split(level, best.1, v, name)
            }
        }
    }

    /// Turned down to the level `split`, combined there.
    fn split(
        &mut self,
        level: Level,
        split: Level,
        v: &V3<Term>,
        name: &dyn Fn(usize) -> String,
    ) -> V3<Term> {
        let at_split = self.descend(level, split, v, name);
        self.combine(split, &at_split)
    }

    fn descend(&mut self, from: Level, to: Level, v: &V3<Term>, name: &dyn Fn(usize) -> String) -> V3<Term> {
        let mut v = *v;
        for level in (to + 1..=from).rev() {
            v = self.down(level, &v);
            if level.is_multiple_of(2) || level == 1 {
                self.label(&v, name, level - 1);
            }
        }
        v
    }

    /// The columns of `level` times the components of `v`.
    fn combine(&mut self, level: Level, v: &V3<Term>) -> V3<Term> {
        let mut sum = vector::origin(self.exprs);
        for (axis, component) in v.iter().enumerate() {
            if *component != Term::ZERO {
                let column = self.column_upwards(level, axis);
                let part = vector::scale(self.exprs, component, &column);
                sum = vector::add(self.exprs, &sum, &part);
            }
        }
        sum
    }

    fn known(&self, level: Level, axis: usize) -> Option<V3<Term>> {
        self.columns.iter().find(|(key, _)| *key == (level, axis)).map(|(_, v)| *v)
    }

    /// A column of the orientation of `level`, in the style of this derivation, remembered.
    pub fn column(&mut self, level: Level, axis: usize, name: &dyn Fn(usize) -> String) -> V3<Term> {
        if let Some(column) = self.known(level, axis) {
            return column;
        }
        let e = vector::unit(self.exprs, axis);
        let column = match self.style {
            Style::Columns => self.column_upwards(level, axis),
            _ => self.by_style_unit(level, &e, name),
        };
        self.label(&column, name, 0);
        self.columns.push(((level, axis), column));
        column
    }

    fn by_style_unit(&mut self, level: Level, e: &V3<Term>, name: &dyn Fn(usize) -> String) -> V3<Term> {
        if self.style == Style::Descend || level == 0 {
            return self.descend(level, 0, e, name);
        }
        // A unit vector cannot be combined at its own level: that would be itself.
        let mut best = (usize::MAX, 0);
        for split in 0..level {
            let mark = self.mark();
            self.split(level, split, e, name);
            let work = self.exprs.work_since(mark.0);
            self.roll_back(mark);
            if work < best.0 {
                best = (work, split);
            }
        }
        self.split(level, best.1, e, name)
    }

    /// A column built from the columns one level below.
    fn column_upwards(&mut self, level: Level, axis: usize) -> V3<Term> {
        if let Some(column) = self.known(level, axis) {
            return column;
        }
        let e = vector::unit(self.exprs, axis);
        if level == 0 {
            return e;
        }
        let below = self.down(level, &e);
        let column = self.combine(level - 1, &below);
        if level.is_multiple_of(2) {
            let frame = self.frames.groups[level / 2 - 1].stages.last().map_or(0, |s| s.joint + 1);
            let letter = ["x", "y", "z"][axis];
            self.label(&column, &|row| format!("{letter}{frame}{}", ["x", "y", "z"][row]), 0);
        }
        self.columns.push(((level, axis), column));
        column
    }

    /// The level of the frame that carries something, and how to bring a vector of the carrier there.
    pub fn carry(&mut self, carrier: Carrier, v: &V3<Term>) -> (Level, V3<Term>) {
        match carrier {
            Carrier::World => (0, *v),
            Carrier::After(group, stage) if stage + 1 == self.frames.groups[group].stages.len() => {
                (2 * group + 2, *v)
            }
            Carrier::After(group, stage) => (2 * group + 1, self.turn(group, stage, v)),
        }
    }

    /// The rotation of a frame, column by column in the world: two columns and their product, or all three.
    pub fn rotation(&mut self, mark: &Mark, name: &dyn Fn(usize, usize) -> String) -> M3<Term> {
        let mark = mark.clone();
        let one = |d: &mut Self, axis: usize| {
            let v = vector::column(&mark.local, axis);
            let (level, v) = d.carry(mark.carrier, &v);
            d.to_world(level, &v, &|row| name(row, axis))
        };
        let by_product = |d: &mut Self, missing: usize| {
            let (a, b) = ((missing + 1) % 3, (missing + 2) % 3);
            let mut columns = [[Term::ZERO; 3]; 3];
            columns[a] = one(d, a);
            columns[b] = one(d, b);
            columns[missing] = vector::cross(d.exprs, &columns[a], &columns[b]);
            columns
        };
        let columns = self.cheapest(&[
            &|d| [one(d, 0), one(d, 1), one(d, 2)],
            &|d| by_product(d, 1),
            &|d| by_product(d, 0),
            &|d| by_product(d, 2),
        ]);
        let [x, y, z] = columns.unwrap_or([[Term::ZERO; 3]; 3]);
        vector::from_columns(&x, &y, &z)
    }
}

/// The axis of a vector that is exactly a positive unit vector.
fn unit_axis(v: &V3<Term>) -> Option<usize> {
    let ones = v.iter().filter(|t| **t == Term::ONE).count();
    let zeros = v.iter().filter(|t| **t == Term::ZERO).count();
    (ones == 1 && zeros == 2).then(|| v.iter().position(|t| *t == Term::ONE)).flatten()
}
