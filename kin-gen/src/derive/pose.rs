//! Forward kinematics, and the frames of all joints.

use super::{Deriver, STYLES, Style, planned_or};
use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::{Carrier, Frames, Mark};
use crate::algebra::vector::{self, M3, V3};
use crate::plan::{self, Planned, Wanted};

/// A pose as terms.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TermPose {
    /// The rotation, by rows.
    pub rotation: M3<Term>,
    /// The position.
    pub position: V3<Term>,
}

impl TermPose {
    /// The twelve outputs of a pose: `r11` … `r33`, `px`, `py`, `pz`, each with a suffix.
    pub fn outputs(&self, suffix: &str) -> Vec<(String, Term)> {
        let rotation = self.rotation.iter().flatten();
        rotation
            .chain(&self.position)
            .enumerate()
            .map(|(i, term)| (format!("{}{suffix}", crate::truth::entry_name(i)), *term))
            .collect()
    }
}

/// A length along a unit vector of some frame, kept apart from the rest of a reach for as long as that is cheaper.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The length.
    pub factor: Term,
    /// The unit vector, in the frame that the reach is seen in.
    pub vector: V3<Term>,
    /// What carries the unit vector, and the vector there.
    pub fixed: (Carrier, V3<Term>),
}

/// The tip as seen from some point: a vector, plus at most one part that is kept apart.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// What is multiplied in.
    pub whole: V3<Term>,
    /// What is not.
    pub part: Option<Part>,
}

impl Reach {
    const ZERO: Reach = Reach { whole: [Term::ZERO; 3], part: None };

    /// Everything multiplied in.
    pub fn total(&self, exprs: &mut Exprs) -> V3<Term> {
        match self.part {
            None => self.whole,
            Some(part) => {
                let length = vector::scale(exprs, &part.factor, &part.vector);
                vector::add(exprs, &self.whole, &length)
            }
        }
    }

    /// Whether nothing is multiplied in.
    pub fn is_only_part(&self) -> bool {
        self.whole.iter().all(|t| *t == Term::ZERO)
    }

    fn is_zero(&self) -> bool {
        self.part.is_none() && self.is_only_part()
    }

    /// A shift along one axis of its carrier is a part of its own.
    fn of(carrier: Carrier, shift: &V3<Term>) -> Reach {
        let nonzero: Vec<usize> = (0..3).filter(|i| shift[*i] != Term::ZERO).collect();
        match nonzero.as_slice() {
            [only] => {
                let mut vector = [Term::ZERO; 3];
                vector[*only] = Term::ONE;
                let part = Part { factor: shift[*only], vector, fixed: (carrier, vector) };
                Reach { part: Some(part), ..Reach::ZERO }
            }
            _ => Reach { whole: *shift, part: None },
        }
    }

    fn map(&self, d: &mut Deriver<'_>, f: impl Fn(&mut Deriver<'_>, &V3<Term>) -> V3<Term>) -> Reach {
        let whole = f(d, &self.whole);
        let part = self.part.map(|part| Part { vector: f(d, &part.vector), ..part });
        Reach { whole, part }
    }

    /// With a shift added; the part is multiplied in.
    fn plus(&self, d: &mut Deriver<'_>, carrier: Carrier, shift: &V3<Term>) -> Reach {
        if shift.iter().all(|t| *t == Term::ZERO) {
            return *self;
        }
        if self.is_zero() {
            return Reach::of(carrier, shift);
        }
        let whole = self.total(d.exprs);
        Reach { whole: vector::add(d.exprs, &whole, shift), part: None }
    }

    /// With a nearer reach added; the parts of both are multiplied in.
    fn with(&self, d: &mut Deriver<'_>, nearer: &Reach) -> Reach {
        let (farther, nearer) = (self.total(d.exprs), nearer.total(d.exprs));
        Reach { whole: vector::add(d.exprs, &farther, &nearer), part: None }
    }

    /// In the axes of the world, each share brought there by itself.
    pub fn in_world(&self, d: &mut Deriver<'_>, level: usize) -> V3<Term> {
        let whole = d.to_world(level, &self.whole, &position_name);
        match self.part {
            None => whole,
            Some(part) => {
                let length = part.in_world(d);
                vector::add(d.exprs, &whole, &length)
            }
        }
    }
}

impl Part {
    /// The direction in the axes of the world.
    pub fn direction(&self, d: &mut Deriver<'_>) -> V3<Term> {
        let (carrier, unit) = self.fixed;
        let (level, unit) = d.carry(carrier, &unit);
        d.to_world(level, &unit, &position_name)
    }

    fn in_world(&self, d: &mut Deriver<'_>) -> V3<Term> {
        let direction = self.direction(d);
        vector::scale(d.exprs, &self.factor, &direction)
    }
}

/// The tip as seen from each axis, in the frame of the axis's group.
pub struct Reaches {
    /// By group and stage.
    pub from_axis: Vec<Vec<Reach>>,
    /// From the world's origin.
    pub from_world: V3<Term>,
}

/// Walks from the tip to the base: planar sums inside each group, turned by the group once.
pub fn reaches(d: &mut Deriver<'_>, tip: &Mark) -> Reaches {
    let frames = d.frames;
    let mut from_axis: Vec<Vec<Reach>> =
        frames.groups.iter().map(|g| Vec::with_capacity(g.stages.len())).collect();
    let mut reach = Reach::ZERO;
    let (last_group, last_stage) = match tip.carrier {
        Carrier::World => return Reaches { from_axis, from_world: tip.shift },
        Carrier::After(group, stage) => (group, stage),
    };
    for group in (0..=last_group).rev() {
        let stages = &frames.groups[group].stages;
        let first = if group == last_group { last_stage } else { stages.len() - 1 };
        let mut in_group = Reach::ZERO;
        for stage in (0..=first).rev() {
            let carrier = Carrier::After(group, stage);
            let shift = if carrier == tip.carrier { tip.shift } else { stages[stage].shift };
            // The far part turns with the whole group, the rest with the joints up to its own.
            let far = if stage + 1 == stages.len() { reach } else { Reach::ZERO };
            let local = far.plus(d, carrier, &shift);
            let joint = stages[stage].joint + 1;
            d.label(&local.whole, &|i| format!("p{}_{joint}", ["x", "y", "z"][i]), 0);
            let turned = local.map(d, |d, v| d.turn(group, stage, v));
            in_group = if in_group.is_zero() { turned } else { in_group.with(d, &turned) };
            // The world's level: the name already says from which axis the tip is seen.
            d.label(&in_group.whole, &|i| format!("w{joint}{}", ["x", "y", "z"][i]), 0);
            from_axis[group].insert(0, in_group);
        }
        let m = frames.groups[group].from_previous;
        reach = in_group.map(d, |d, v| vector::apply(d.exprs, &m, v));
    }
    let whole = vector::add(d.exprs, &reach.whole, &frames.base_shift);
    let from_world = match reach.part {
        None => whole,
        Some(part) => {
            let length = part.in_world(d);
            vector::add(d.exprs, &whole, &length)
        }
    };
    Reaches { from_axis, from_world }
}

/// The tip's position as the sum of all shifts, each brought to the world by itself.
fn position_upwards(d: &mut Deriver<'_>, tip: &Mark) -> V3<Term> {
    let frames = d.frames;
    if tip.carrier == Carrier::World {
        return tip.shift;
    }
    let base = frames.base_shift;
    shifts_upwards(d, tip, Carrier::World, base)
}

/// The tip's position as that of a nearer point plus the shifts from there on, each brought to the world by itself.
fn position_in_two(d: &mut Deriver<'_>, tip: &Mark, turn_off: Carrier) -> V3<Term> {
    let Carrier::After(group, stage) = turn_off else { return position_upwards(d, tip) };
    let near =
        Mark { carrier: turn_off, local: tip.local, shift: d.frames.groups[group].stages[stage].shift };
    let near = reaches(d, &near).from_world;
    shifts_upwards(d, tip, turn_off, near)
}

/// Adds the shifts carried by what comes after `from`.
fn shifts_upwards(d: &mut Deriver<'_>, tip: &Mark, from: Carrier, mut sum: V3<Term>) -> V3<Term> {
    let frames = d.frames;
    for (group, stages) in frames.groups.iter().enumerate() {
        for (stage, joint) in stages.stages.iter().enumerate() {
            let here = Carrier::After(group, stage);
            if here > tip.carrier || here <= from {
                continue;
            }
            let shift = if here == tip.carrier { tip.shift } else { joint.shift };
            let step = to_world_scaled(d, here, &shift);
            sum = vector::add(d.exprs, &sum, &step);
        }
    }
    sum
}

/// A vector brought to the world: whole, or as a direction that is then multiplied by its length.
fn to_world_scaled(d: &mut Deriver<'_>, carrier: Carrier, v: &V3<Term>) -> V3<Term> {
    let by_part = |d: &mut Deriver<'_>| match Reach::of(carrier, v).part {
        Some(part) => part.in_world(d),
        None => whole_to_world(d, carrier, v),
    };
    d.cheapest(&[&by_part, &|d| whole_to_world(d, carrier, v)]).unwrap_or([Term::ZERO; 3])
}

fn whole_to_world(d: &mut Deriver<'_>, carrier: Carrier, v: &V3<Term>) -> V3<Term> {
    let (level, v) = d.carry(carrier, v);
    d.to_world(level, &v, &position_name)
}

fn position_name(row: usize) -> String {
    format!("p{}", ["x", "y", "z"][row])
}

/// The name of a rotation's entry.
pub fn rotation_name(row: usize, column: usize) -> String {
    format!("r{}{}", row + 1, column + 1)
}

/// One way of deriving a vector.
type Way<'w> = dyn Fn(&mut Deriver<'_>) -> V3<Term> + 'w;

/// The tip's position, the cheapest way.
pub fn position(d: &mut Deriver<'_>, tip: &Mark) -> V3<Term> {
    let carriers: Vec<Carrier> = d.frames.carriers().filter(|c| *c < tip.carrier).collect();
    let in_two: Vec<_> =
        carriers.iter().map(|c| move |d: &mut Deriver<'_>| position_in_two(d, tip, *c)).collect();
    let whole = |d: &mut Deriver<'_>| reaches(d, tip).from_world;
    let upwards = |d: &mut Deriver<'_>| position_upwards(d, tip);
    let mut ways: Vec<&Way> = vec![&whole, &upwards];
    ways.extend(in_two.iter().map(|way| way as &Way));
    d.cheapest(&ways).unwrap_or([Term::ZERO; 3])
}

/// The pose of the tip.
pub fn fk(exprs: &mut Exprs, frames: &Frames) -> TermPose {
    planned_or(
        exprs,
        |exprs| by_plan(plan::planned(exprs, frames, Wanted::Pose)?),
        |exprs| cheapest_style(exprs, frames, |d| tip_pose(d, &frames.tip)),
    )
}

/// The pose of a plan, and whether it is the structure's own.
pub fn by_plan(planned: Planned) -> Option<(TermPose, bool)> {
    let (rotation, position) = planned.pose?;
    Some((TermPose { rotation, position }, planned.own))
}

/// The pose of a frame.
pub fn tip_pose(d: &mut Deriver<'_>, tip: &Mark) -> TermPose {
    let rotation = d.rotation(tip, &rotation_name);
    let position = position(d, tip);
    TermPose { rotation, position }
}

/// The frames at the ends of all joints' rows.
pub fn all_frames(exprs: &mut Exprs, frames: &Frames) -> Vec<TermPose> {
    cheapest_style(exprs, frames, |d| {
        let each = frames.joints.iter().map(|mark| {
            let rotation = d.rotation(mark, &rotation_name);
            let position = position_upwards(d, mark);
            TermPose { rotation, position }
        });
        each.collect()
    })
}

/// Derives in every style, keeps the cheapest.
pub fn cheapest_style<T>(exprs: &mut Exprs, frames: &Frames, derive: impl Fn(&mut Deriver<'_>) -> T) -> T {
    let start = exprs.mark();
    let mut best: Option<(usize, Style)> = None;
    for style in STYLES {
        derive(&mut Deriver::new(exprs, frames, style));
        let work = exprs.work_since(start);
        exprs.roll_back(start);
        if best.is_none_or(|(least, _)| work < least) {
            best = Some((work, style));
        }
    }
    let style = best.map_or(Style::Descend, |(_, style)| style);
    derive(&mut Deriver::new(exprs, frames, style))
}
