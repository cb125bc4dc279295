//! The frames of a chain, joints with parallel axes fused before they become sines.
//!
//! A *group* is a run of revolute joints with parallel (or opposite) axes. Inside a group nothing is multiplied out:
//! the rotation after its t-th joint is Rz of the pending sum of angles, so that cos(q2 + q3) appears because it was
//! never expanded. Between groups stands a constant rotation. Prismatic joints are translations and belong to the
//! stage that carries them.
//!
//! ```text
//! world ── shift, K ──► G₁ ── Rz(Θ₁) ──► A₁ ── shift, K ──► G₂ ── Rz(Θ₂) ──► A₂ … tip
//! ```

use super::expr::{Exprs, Term, Turn};
use super::vector::{self, M3, V3};
use crate::chain::{Axis, Chain, Distance, Element, LengthAtom, Motion};
use crate::number::Angle;
use crate::truth::Symbols;

/// One revolute joint inside its group.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The joint.
    pub joint: usize,
    /// The sum of angles from the group's frame up to and including this joint.
    pub turn: Turn,
    /// Whether the joint's row value turns negatively about the group's z.
    pub negative: bool,
    /// From this joint's axis to the next one's, in the frame after this joint.
    pub shift: V3<Term>,
}

/// A run of joints with parallel axes, along z of the group's frame.
#[derive(Clone, Debug)]
pub struct Group {
    /// Its joints.
    pub stages: Vec<Stage>,
    /// The orientation of this group's frame in the frame that comes before it.
    pub from_previous: M3<Term>,
}

/// Where something is fixed: in the frame after one joint, or in the world.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Carrier {
    /// Before every revolute joint.
    World,
    /// In the frame after stage `.1` of group `.0`.
    After(usize, usize),
}

/// A frame fixed in its carrier.
#[derive(Clone, Debug)]
pub struct Mark {
    /// What carries it.
    pub carrier: Carrier,
    /// Its orientation in the carrier.
    pub local: M3<Term>,
    /// Its origin, from the carrier's axis, in the carrier's frame.
    pub shift: V3<Term>,
}

/// A prismatic joint.
#[derive(Clone, Debug)]
pub struct Slide {
    /// The joint.
    pub joint: usize,
    /// What carries it.
    pub carrier: Carrier,
    /// The direction in which its row value grows, in the carrier's frame.
    pub direction: V3<Term>,
}

/// The frames of a stretch of the chain.
#[derive(Clone, Debug)]
pub struct Frames {
    /// From the world's origin to the first axis.
    pub base_shift: V3<Term>,
    /// The groups, in order.
    pub groups: Vec<Group>,
    /// The prismatic joints, in order.
    pub slides: Vec<Slide>,
    /// The frame at the end of each joint's row, in order of the joints.
    pub joints: Vec<Mark>,
    /// The frame at the end of the stretch.
    pub tip: Mark,
}

impl Frames {
    /// What can carry something, from the base to the tip.
    pub fn carriers(&self) -> impl Iterator<Item = Carrier> + '_ {
        let stages = |(group, stages): (usize, &Group)| {
            (0..stages.stages.len()).map(move |stage| Carrier::After(group, stage)).collect::<Vec<_>>()
        };
        self.groups.iter().enumerate().flat_map(stages)
    }
}

/// Which joint values the sines are of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Values {
    /// The caller's: `couple:` is applied.
    Commanded,
    /// The rows' own: what remains when the coupling is undone.
    Rows,
    /// All joints at zero, the offsets of their cells left out as well.
    Home,
}

/// The angle of a revolute joint.
pub fn joint_turn(chain: &Chain, values: Values, motion: &Motion) -> Option<Turn> {
    let Motion::Revolute { joint, reversed, offset } = motion else { return None };
    let row: Vec<(i64, usize)> = match values {
        Values::Home => return Some(Turn::default()),
        Values::Rows => vec![(1, *joint)],
        Values::Commanded => {
            chain.couple[*joint].iter().enumerate().filter(|(_, c)| **c != 0).map(|(j, c)| (*c, j)).collect()
        }
    };
    let offset = Turn { joints: Vec::new(), rest: offset.clone() };
    offset.plus(&Turn { joints: row, ..Turn::default() }, if *reversed { -1 } else { 1 })
}

/// The stretch of the chain that a program speaks of.
#[derive(Clone, Debug)]
pub struct Stretch<'a> {
    /// The elements, in order.
    pub elements: Vec<&'a Element>,
    /// After how many of them each joint's frame stands.
    pub frames: Vec<usize>,
}

/// The walk along a stretch.
struct Walk<'a> {
    chain: &'a Chain,
    values: Values,
    carrier: Carrier,
    local: M3<Term>,
    /// `Some((φ, flip))` while `local` is known to be Rz(φ), followed by a half turn about x if `flip`.
    planar: Option<(Turn, bool)>,
    shift: V3<Term>,
    base_shift: V3<Term>,
    groups: Vec<Group>,
    slides: Vec<Slide>,
}

/// Builds the frames of a stretch; `None` if an exact angle cannot be represented.
pub fn frames(exprs: &mut Exprs, chain: &Chain, values: Values, stretch: &Stretch<'_>) -> Option<Frames> {
    let mut walk = Walk {
        chain,
        values,
        carrier: Carrier::World,
        local: vector::identity(exprs),
        planar: Some((Turn::default(), false)),
        shift: vector::origin(exprs),
        base_shift: vector::origin(exprs),
        groups: Vec::new(),
        slides: Vec::new(),
    };
    let mut joints = Vec::new();
    for (index, element) in stretch.elements.iter().enumerate() {
        joints.extend(stretch.frames.iter().filter(|f| **f == index).map(|_| walk.mark()));
        walk.element(exprs, element)?;
    }
    let end = stretch.elements.len();
    joints.extend(stretch.frames.iter().filter(|f| **f >= end).map(|_| walk.mark()));
    let tip = walk.mark();
    Some(Frames { base_shift: walk.base_shift, groups: walk.groups, slides: walk.slides, joints, tip })
}

/// The index, 0 to 2, of an axis.
pub fn axis_index(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}

/// A distance as a term.
pub fn distance(exprs: &mut Exprs, names: &Symbols, distance: &Distance) -> Term {
    let mut sum = Term::ZERO;
    for &(coefficient, atom) in &distance.0 {
        let factor = exprs.constant(super::ring::Poly::integer(coefficient));
        let atom = match atom {
            LengthAtom::Constant(index) => {
                let meaning = names.length(&exprs.ring, index);
                exprs.constant(meaning)
            }
            LengthAtom::Param(index) => exprs.param(index),
        };
        let term = exprs.mul(factor, atom);
        sum = exprs.add(sum, term);
    }
    sum
}

impl Walk<'_> {
    fn mark(&self) -> Mark {
        Mark { carrier: self.carrier, local: self.local, shift: self.shift }
    }

    fn element(&mut self, exprs: &mut Exprs, element: &Element) -> Option<()> {
        let axis = axis_index(element.axis);
        let names = Symbols::of(self.chain);
        match &element.motion {
            Motion::Turn(sum) => self.turn(exprs, axis, &Turn { joints: Vec::new(), rest: sum.clone() })?,
            Motion::Shift(length) => {
                let length = distance(exprs, &names, length);
                self.translate(exprs, axis, length);
            }
            Motion::Prismatic { joint, reversed, offset } => {
                let offset = distance(exprs, &names, offset);
                let slide = exprs.slide(*joint);
                let value = if *reversed { exprs.sub(offset, slide) } else { exprs.add(offset, slide) };
                let direction = vector::column(&self.local, axis);
                let direction = if *reversed { vector::negate(exprs, &direction) } else { direction };
                self.slides.push(Slide { joint: *joint, carrier: self.carrier, direction });
                self.translate(exprs, axis, value);
            }
            Motion::Revolute { joint, reversed, .. } => {
                let turn = joint_turn(self.chain, self.values, &element.motion)?;
                self.revolute(exprs, axis, *joint, *reversed, &turn)?;
            }
        }
        Some(())
    }

    fn translate(&mut self, exprs: &mut Exprs, axis: usize, length: Term) {
        let direction = vector::column(&self.local, axis);
        let step = vector::scale(exprs, &length, &direction);
        self.shift = vector::add(exprs, &self.shift, &step);
    }

    fn turn(&mut self, exprs: &mut Exprs, axis: usize, turn: &Turn) -> Option<()> {
        let (cos, sin) = exprs.cos_sin(turn);
        let rotation = vector::rotation(exprs, axis, &cos, &sin);
        self.local = vector::product(exprs, &self.local, &rotation);
        let half = turn.is_constant() && turn.rest.constant.quarters() == Some(2);
        self.planar = match (self.planar.take(), axis) {
            (Some((angle, flip)), 2) => Some((angle.plus(turn, if flip { -1 } else { 1 })?, flip)),
            (Some((angle, flip)), 0) if half => Some((angle, !flip)),
            // A half turn about y is one about z, then one about x.
            (Some((angle, flip)), 1) if half => Some((angle.plus(turn, if flip { -1 } else { 1 })?, !flip)),
            _ => None,
        };
        if self.planar.is_none() {
            self.planar = planar_quarter(&self.local);
        }
        Some(())
    }

    fn revolute(
        &mut self,
        exprs: &mut Exprs,
        axis: usize,
        joint: usize,
        reversed: bool,
        turn: &Turn,
    ) -> Option<()> {
        // A turn about x or y is one about z between two cyclic exchanges of the axes.
        let to_axis = cyclic(exprs, axis);
        let entering = vector::product(exprs, &self.local, &to_axis);
        let planar = if axis == 2 { self.planar.clone() } else { planar_quarter(&entering) };
        let zero = vector::origin(exprs);
        let shift = std::mem::replace(&mut self.shift, zero);
        let fused = match (self.carrier, planar) {
            (Carrier::After(group, stage), Some((between, flip))) => Some((group, stage, between, flip)),
            _ => None,
        };
        let (flip, stage_turn) = match &fused {
            Some((group, stage, between, flip)) => {
                let so_far = self.groups[*group].stages[*stage].turn.plus(between, 1)?;
                (*flip, so_far.plus(turn, if *flip { -1 } else { 1 })?)
            }
            None => (false, turn.clone()),
        };
        match self.carrier {
            Carrier::World => self.base_shift = shift,
            Carrier::After(group, stage) => self.groups[group].stages[stage].shift = shift,
        }
        if fused.is_none() {
            self.groups.push(Group { stages: Vec::new(), from_previous: entering });
        }
        let group = self.groups.len() - 1;
        let stages = &mut self.groups[group].stages;
        stages.push(Stage { joint, turn: stage_turn, negative: reversed != flip, shift: zero });
        self.carrier = Carrier::After(group, stages.len() - 1);
        let half = half_turn_about_x(exprs, flip);
        self.local = vector::product(exprs, &half, &vector::transpose(&to_axis));
        self.planar = if axis == 2 { Some((Turn::default(), flip)) } else { planar_quarter(&self.local) };
        Some(())
    }
}

/// The rotation that takes z to the given axis and permutes the others cyclically.
fn cyclic(exprs: &Exprs, axis: usize) -> M3<Term> {
    let columns = [0, 1, 2].map(|i| vector::unit(exprs, (i + axis + 1) % 3));
    vector::from_columns(&columns[0], &columns[1], &columns[2])
}

fn half_turn_about_x(exprs: &Exprs, flip: bool) -> M3<Term> {
    let mut m = vector::identity(exprs);
    if flip {
        m[1][1] = exprs.neg(m[1][1]);
        m[2][2] = exprs.neg(m[2][2]);
    }
    m
}

/// Whether a signed permutation is a quarter turn about z, with or without a half turn about x after it.
fn planar_quarter(m: &M3<Term>) -> Option<(Turn, bool)> {
    let unit = |t: Term| (t.id == Term::ONE.id).then_some(t.negative);
    let flip = unit(m[2][2])?;
    let quarters = match (unit(m[0][0]), unit(m[1][0])) {
        (Some(false), _) => 0,
        (_, Some(false)) => 1,
        (Some(true), _) => 2,
        (_, Some(true)) => 3,
        (None, None) => return None,
    };
    let angle = Angle::from_pi(crate::number::Ratio::new(quarters, 2)?);
    Some((Turn::constant(angle), flip))
}
