//! From the frames of an arm to its shape.
//!
//! Three freedoms of a chain of frames change nothing but names, and are used up here: a quarter turn about an axis may
//! be counted to the joint or to what stands behind it; an origin may slide along its axis; a link's frame may be turned
//! so that its length lies along x. What the arm's own numbers are called in its shape is kept beside it.

use super::routes::Wanted;
use super::shape::{Direction, Group, Link, Shape};
use crate::algebra::expr::{Exprs, Term, Turn};
use crate::algebra::frame::{Carrier, Frames, Slide};
use crate::algebra::vector::{self, M3, V3};
use crate::number::{Angle, Ratio};

/// A joint of the shape.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its index in the arm.
    pub joint: usize,
    /// Whether its row value turns negatively about the axis.
    pub negative: bool,
    /// The sum of angles from the base of its group.
    pub turn: Turn,
    /// The lengths behind it, along x and y.
    pub link: [Term; 2],
}

/// Where a prismatic joint moves.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SlideDirection {
    /// In the world, before every joint that turns.
    World(V3<Term>),
    /// Along a direction of the shape, by its place among the shape's slides; or against it.
    Shape(usize, bool),
}

/// A shape and what it stands for in one arm.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// The shape.
    pub shape: Shape,
    /// The base of the shape, seen in the world, and what is to be added to positions.
    pub base: M3<Term>,
    /// See `base`.
    pub origin: V3<Term>,
    /// The frame at the tip, seen in the last frame of the shape.
    pub tip: M3<Term>,
    /// The joints that turn, in order.
    pub joints: Vec<Joint>,
    /// The offset along the axes of each group.
    pub offsets: Vec<Term>,
    /// The joints that slide: the joint, and its direction.
    pub slides: Vec<(usize, SlideDirection)>,
}

impl Fitted {
    /// The shape as a plan for these outputs is looked up: for a pose, slides are lengths like any other.
    pub fn shape_for(&self, wanted: Wanted) -> Shape {
        let mut shape = self.shape.clone();
        if wanted == Wanted::Pose {
            shape.slides.clear();
        }
        shape
    }

    /// Leaves the rotation.
    pub fn forget_lengths(&mut self) {
        for joint in &mut self.joints {
            joint.link = [Term::ZERO; 2];
        }
        self.offsets.fill(Term::ZERO);
        for group in &mut self.shape.groups {
            group.d = false;
            group.links.fill(Link::default());
        }
    }
}

/// The frames of an arm while they are being brought into shape.
struct Gauge<'a> {
    exprs: &'a mut Exprs,
    /// By group: its joints, each with the shift behind it.
    groups: Vec<Vec<(Joint, V3<Term>)>>,
    offsets: Vec<Term>,
    slides: Vec<Slide>,
    tip: M3<Term>,
}

/// The shape of these frames; `None` where two neighbouring axes stand neither parallel nor at right angles, or a slide
/// moves along no axis of its frame.
pub fn fit(exprs: &mut Exprs, frames: &Frames) -> Option<Fitted> {
    let count = frames.groups.len();
    let last = frames.groups.last()?.stages.len() - 1;
    if frames.tip.carrier != Carrier::After(count - 1, last) {
        return None;
    }
    let joint = |s: &crate::algebra::frame::Stage| {
        let joint =
            Joint { joint: s.joint, negative: s.negative, turn: s.turn.clone(), link: [Term::ZERO; 2] };
        (joint, s.shift)
    };
    let mut groups: Vec<Vec<(Joint, V3<Term>)>> =
        frames.groups.iter().map(|g| g.stages.iter().map(joint).collect()).collect();
    groups[count - 1][last].1 = frames.tip.shift;
    let offsets = vec![Term::ZERO; count];
    let mut gauge = Gauge { exprs, groups, offsets, slides: frames.slides.clone(), tip: frames.tip.local };
    for group in 0..count {
        let next = frames.groups.get(group + 1).map(|g| g.from_previous);
        gauge.group(group, next.as_ref())?;
    }
    let base = frames.groups[0].from_previous;
    let origin = gauge.origin(&base, &frames.base_shift);
    gauge.fitted(base, origin)
}

impl Gauge<'_> {
    /// Brings the links of one group into shape, and the step to the next one.
    fn group(&mut self, group: usize, next: Option<&M3<Term>>) -> Option<()> {
        let last = self.groups[group].len() - 1;
        if let Some(next) = next {
            let (behind, before) = quarters(self.exprs, next)?;
            self.turn(group, last, behind)?;
            for (joint, _) in &mut self.groups[group + 1] {
                joint.turn = joint.turn.plus(&quarter_turn(before)?, 1)?;
            }
            // At Rx(90°) to each other, the next axis lies along -y.
            let y = std::mem::replace(&mut self.groups[group][last].1[1], Term::ZERO);
            self.offsets[group + 1] = self.exprs.sub(self.offsets[group + 1], y);
        }
        for joint in 0..=last {
            let [x, y, z] = self.groups[group][joint].1;
            self.offsets[group] = self.exprs.add(self.offsets[group], z);
            if x == Term::ZERO && y != Term::ZERO && (joint < last || next.is_none()) {
                self.turn(group, joint, 1)?;
                if next.is_none() && joint == last {
                    self.tip = turned_back(self.exprs, 1, &self.tip);
                }
            }
            let [x, y, _] = self.groups[group][joint].1;
            self.groups[group][joint].0.link = [x, y];
        }
        Some(())
    }

    /// Counts so many quarter turns behind a joint to the joint itself: vectors behind it turn back.
    fn turn(&mut self, group: usize, joint: usize, quarters: i128) -> Option<()> {
        let (own, shift) = &mut self.groups[group][joint];
        own.turn = own.turn.plus(&quarter_turn(quarters)?, 1)?;
        *shift = vector_turned_back(self.exprs, quarters, shift);
        for slide in self.slides.iter_mut().filter(|s| s.carrier == Carrier::After(group, joint)) {
            slide.direction = vector_turned_back(self.exprs, quarters, &slide.direction);
        }
        Some(())
    }

    /// What remains of the base's shift when the part along the first axis is counted to the first offset.
    fn origin(&mut self, base: &M3<Term>, shift: &V3<Term>) -> V3<Term> {
        let axis = vector::column(base, 2);
        let Some(along) = axis.iter().position(|t| t.id == Term::ONE.id) else { return *shift };
        let mut origin = *shift;
        let z = std::mem::replace(&mut origin[along], Term::ZERO);
        let z = self.exprs.mul(z, axis[along]);
        self.offsets[0] = self.exprs.add(self.offsets[0], z);
        origin
    }

    fn fitted(self, base: M3<Term>, origin: V3<Term>) -> Option<Fitted> {
        let is = |t: Term| t != Term::ZERO;
        let link = |(joint, _): &(Joint, _)| Link { x: is(joint.link[0]), y: is(joint.link[1]) };
        let group =
            |(group, d): (&Vec<_>, &Term)| Group { d: is(*d), links: group.iter().map(link).collect() };
        let mut shape =
            Shape { groups: self.groups.iter().zip(&self.offsets).map(group).collect(), slides: Vec::new() };
        let mut slides = Vec::new();
        for slide in &self.slides {
            let direction = match slide.carrier {
                Carrier::World => SlideDirection::World(slide.direction),
                Carrier::After(group, joint) => {
                    let is_last = joint + 1 == self.groups[group].len() && group + 1 < self.groups.len();
                    let (along, negative) = along(group, joint, is_last, &slide.direction)?;
                    shape.slides.push(along);
                    SlideDirection::Shape(shape.slides.len() - 1, negative)
                }
            };
            slides.push((slide.joint, direction));
        }
        let joints = self.groups.into_iter().flatten().map(|(joint, _)| joint).collect();
        Some(Fitted { shape, base, origin, tip: self.tip, joints, offsets: self.offsets, slides })
    }
}

/// The direction of a shape that a unit vector behind a joint is, and whether it is its negative.
fn along(group: usize, joint: usize, before_next: bool, v: &V3<Term>) -> Option<(Direction, bool)> {
    let axis = v.iter().position(|t| t.id == Term::ONE.id)?;
    if v.iter().filter(|t| **t != Term::ZERO).count() != 1 {
        return None;
    }
    let negative = v[axis].negative;
    Some(match axis {
        0 => (Direction::X(group, joint), negative),
        1 if before_next => (Direction::Axis(group + 1), !negative),
        1 => (Direction::Y(group, joint), negative),
        _ => (Direction::Axis(group), negative),
    })
}

/// The numbers of quarter turns before and behind: m = Rz(before)·Rx(90°)·Rz(behind).
fn quarters(exprs: &mut Exprs, m: &M3<Term>) -> Option<(i128, i128)> {
    // The axis of the next group is (sin, -cos, 0) of the first turn.
    let first = match [m[0][2], m[1][2], m[2][2]] {
        [Term::ZERO, y, Term::ZERO] if y.id == Term::ONE.id => {
            if y.negative {
                0
            } else {
                2
            }
        }
        [x, Term::ZERO, Term::ZERO] if x.id == Term::ONE.id => {
            if x.negative {
                3
            } else {
                1
            }
        }
        _ => return None,
    };
    let rest = turned_back(exprs, first, m);
    // Rx(90°)·Rz(θ) has the first column (cos, 0, sin).
    let second = match [rest[0][0], rest[2][0]] {
        [c, Term::ZERO] if c.id == Term::ONE.id => {
            if c.negative {
                2
            } else {
                0
            }
        }
        [Term::ZERO, s] if s.id == Term::ONE.id => {
            if s.negative {
                3
            } else {
                1
            }
        }
        _ => return None,
    };
    Some((first, second))
}

fn quarter_turn(quarters: i128) -> Option<Turn> {
    Some(Turn::constant(Angle::from_pi(Ratio::new(quarters, 2)?)))
}

fn vector_turned_back(exprs: &Exprs, quarters: i128, v: &V3<Term>) -> V3<Term> {
    (0..quarters).fold(*v, |[x, y, z], _| [y, exprs.neg(x), z])
}

fn turned_back(exprs: &Exprs, quarters: i128, m: &M3<Term>) -> M3<Term> {
    let columns = [0, 1, 2].map(|j| vector_turned_back(exprs, quarters, &vector::column(m, j)));
    vector::from_columns(&columns[0], &columns[1], &columns[2])
}
