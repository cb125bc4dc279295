//! Forward kinematics, and the frames of all joints.

use super::{Deriver, STYLES, Style};
use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::{Carrier, Frames, Mark};
use crate::algebra::vector::{self, M3, V3};

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

/// A vector that is a length times a shorter expression, kept apart as long as that is cheaper.
#[derive(Clone, Copy, Debug)]
pub struct Scaled {
    /// The length.
    pub factor: Term,
    /// The direction.
    pub vector: V3<Term>,
}

impl Scaled {
    /// With the length multiplied in.
    pub fn whole(&self, exprs: &mut Exprs) -> V3<Term> {
        vector::scale(exprs, &self.factor, &self.vector)
    }

    fn of(v: &V3<Term>) -> Scaled {
        let nonzero: Vec<usize> = (0..3).filter(|i| v[*i] != Term::ZERO).collect();
        match nonzero.as_slice() {
            [only] => {
                let mut unit = [Term::ZERO; 3];
                unit[*only] = Term::ONE;
                Scaled { factor: v[*only], vector: unit }
            }
            _ => Scaled { factor: Term::ONE, vector: *v },
        }
    }

    fn is_zero(&self) -> bool {
        self.vector.iter().all(|t| *t == Term::ZERO)
    }
}

/// The tip as seen from each axis, in the frame of the axis's group.
pub struct Reaches {
    /// By group and stage.
    pub from_axis: Vec<Vec<Scaled>>,
    /// From the world's origin.
    pub from_world: V3<Term>,
}

/// Walks from the tip to the base: planar sums inside each group, turned by the group once.
pub fn reaches(d: &mut Deriver<'_>, tip: &Mark) -> Reaches {
    let frames = d.frames;
    let mut from_axis: Vec<Vec<Scaled>> =
        frames.groups.iter().map(|g| Vec::with_capacity(g.stages.len())).collect();
    let mut reach = Scaled::of(&[Term::ZERO; 3]);
    let (last_group, last_stage) = match tip.carrier {
        Carrier::World => return Reaches { from_axis, from_world: tip.shift },
        Carrier::After(group, stage) => (group, stage),
    };
    for group in (0..=last_group).rev() {
        let stages = &frames.groups[group].stages;
        let first = if group == last_group { last_stage } else { stages.len() - 1 };
        let mut in_group = Scaled::of(&[Term::ZERO; 3]);
        for stage in (0..=first).rev() {
            let is_tip = group == last_group && stage == last_stage;
            let shift = if is_tip { tip.shift } else { stages[stage].shift };
            // The far part turns with the whole group, the rest with the joints up to its own.
            let far = if stage + 1 == stages.len() { reach } else { Scaled::of(&[Term::ZERO; 3]) };
            let local = plus(d.exprs, &far, &shift);
            let joint = stages[stage].joint + 1;
            d.label(&local.vector, &|i| format!("p{}_{joint}", ["x", "y", "z"][i]), 0);
            let turned = Scaled { factor: local.factor, vector: d.turn(group, stage, &local.vector) };
            in_group = if in_group.is_zero() {
                turned
            } else {
                let whole = turned.whole(d.exprs);
                plus(d.exprs, &in_group, &whole)
            };
            // The world's level: the name already says from which axis the tip is seen.
            d.label(&in_group.vector, &|i| format!("w{joint}{}", ["x", "y", "z"][i]), 0);
            from_axis[group].insert(0, in_group);
        }
        let m = frames.groups[group].from_previous;
        reach = Scaled { factor: in_group.factor, vector: vector::apply(d.exprs, &m, &in_group.vector) };
    }
    let from_world = plus(d.exprs, &reach, &frames.base_shift).whole(d.exprs);
    Reaches { from_axis, from_world }
}

fn plus(exprs: &mut Exprs, a: &Scaled, b: &V3<Term>) -> Scaled {
    if b.iter().all(|t| *t == Term::ZERO) {
        return *a;
    }
    if a.is_zero() {
        return Scaled::of(b);
    }
    let whole = a.whole(exprs);
    Scaled { factor: Term::ONE, vector: vector::add(exprs, &whole, b) }
}

/// The tip's position as the sum of all shifts, each brought to the world by itself.
fn position_upwards(d: &mut Deriver<'_>, tip: &Mark) -> V3<Term> {
    let frames = d.frames;
    if tip.carrier == Carrier::World {
        return tip.shift;
    }
    let mut sum = frames.base_shift;
    for (group, stages) in frames.groups.iter().enumerate() {
        for (stage, joint) in stages.stages.iter().enumerate() {
            let here = Carrier::After(group, stage);
            if here > tip.carrier {
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
    let scaled = Scaled::of(v);
    let bring = |d: &mut Deriver<'_>, v: &V3<Term>| {
        let (level, v) = d.carry(carrier, v);
        d.to_world(level, &v, &position_name)
    };
    d.cheapest(&[
        &|d| {
            let direction = bring(d, &scaled.vector);
            vector::scale(d.exprs, &scaled.factor, &direction)
        },
        &|d| bring(d, v),
    ])
    .unwrap_or([Term::ZERO; 3])
}

fn position_name(row: usize) -> String {
    format!("p{}", ["x", "y", "z"][row])
}

/// The name of a rotation's entry.
pub fn rotation_name(row: usize, column: usize) -> String {
    format!("r{}{}", row + 1, column + 1)
}

/// The tip's position, the cheaper way.
pub fn position(d: &mut Deriver<'_>, tip: &Mark) -> V3<Term> {
    d.cheapest(&[&|d| reaches(d, tip).from_world, &|d| position_upwards(d, tip)]).unwrap_or([Term::ZERO; 3])
}

/// The pose of the tip, in the cheapest style.
pub fn fk(exprs: &mut Exprs, frames: &Frames) -> TermPose {
    cheapest_style(exprs, frames, |d| tip_pose(d, &frames.tip))
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
