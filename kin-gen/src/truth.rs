//! What must hold: the plain matrix product of the declaration, as polynomials.
//!
//! Nothing here is clever, on purpose. The elementary transforms are multiplied one by one, in the order in which they
//! were written; every program that is emitted is expanded into the same ring and compared with this.

use crate::algebra::expr::Turn;
use crate::algebra::frame::{Stretch, Values, axis_index, joint_turn};
use crate::algebra::ring::{Poly, Ring, Var};
use crate::algebra::vector::{self, M3, V3};
use crate::chain::{Chain, Distance, Element, JointKind, LengthAtom, Motion, ParamKind};
use crate::number::Angle;

/// Which variable of the ring stands for what. A function of the chain's shape alone.
#[derive(Clone, Debug)]
pub struct Symbols {
    joints: Vec<(JointKind, Var)>,
    /// For each joint the constant that its cell adds to it, unless that is a multiple of a quarter turn: the joint's
    /// pair is of the sum, so that an offset of 33.2 degrees does not double the terms of every polynomial.
    shifts: Vec<Angle>,
    lengths: Vec<Var>,
    params: Vec<(ParamKind, Var)>,
    entries: Var,
}

impl Symbols {
    /// The layout: joints first, so that polynomials print in the order of the joints, then lengths, parameters, and
    /// the twelve entries of a given pose.
    pub fn of(chain: &Chain) -> Symbols {
        let mut next = 0usize;
        let mut take = |count: usize| {
            next += count;
            // Past the last variable the ring is exhausted, and says so; any index will do.
            Var((next - count).min(255) as u8)
        };
        Symbols {
            joints: chain
                .joints
                .iter()
                .map(|joint| match joint.kind {
                    JointKind::Revolute => (joint.kind, take(2)),
                    JointKind::Prismatic => (joint.kind, take(1)),
                })
                .collect(),
            shifts: (0..chain.joints.len()).map(|joint| shift(chain, joint)).collect(),
            lengths: chain.lengths.iter().map(|_| take(1)).collect(),
            params: chain
                .params
                .iter()
                .map(|param| match param.kind {
                    ParamKind::Length => (param.kind, take(1)),
                    ParamKind::Angle => (param.kind, take(2)),
                })
                .collect(),
            entries: take(12),
        }
    }

    /// The ring with these variables.
    pub fn ring(&self, chain: &Chain) -> Ring {
        let mut ring = Ring::new();
        for (index, (kind, _)) in self.joints.iter().enumerate() {
            match kind {
                JointKind::Revolute => {
                    ring.pair(&(index + 1).to_string());
                }
                JointKind::Prismatic => {
                    ring.free(format!("q{}", index + 1));
                }
            }
        }
        for length in &chain.lengths {
            ring.constant(length.name.clone(), length.value);
        }
        for (index, param) in chain.params.iter().enumerate() {
            match param.kind {
                ParamKind::Length => {
                    ring.param(param.name.clone(), index);
                }
                ParamKind::Angle => {
                    ring.param_pair(&param.name, index);
                }
            }
        }
        for index in 0..12 {
            ring.free(entry_name(index));
        }
        ring
    }

    /// A constant length.
    pub fn length(&self, ring: &Ring, index: usize) -> Poly {
        self.lengths.get(index).map_or_else(Poly::zero, |v| ring.var(*v))
    }

    /// A parameter that is a length.
    pub fn param(&self, ring: &Ring, index: usize) -> Poly {
        self.params.get(index).map_or_else(Poly::zero, |(_, v)| ring.var(*v))
    }

    /// The variable of a parameter that is a length.
    pub fn length_params(&self) -> impl Iterator<Item = (usize, Var)> + '_ {
        self.params
            .iter()
            .enumerate()
            .filter(|(_, (kind, _))| *kind == ParamKind::Length)
            .map(|(i, (_, v))| (i, *v))
    }

    /// The value of a prismatic joint.
    pub fn slide(&self, ring: &Ring, joint: usize) -> Poly {
        self.joints.get(joint).map_or_else(Poly::zero, |(_, v)| ring.var(*v))
    }

    /// An entry of the given pose.
    pub fn entry(&self, ring: &Ring, index: usize) -> Poly {
        ring.var(Var(self.entries.0.saturating_add(index as u8)))
    }

    /// Cosine and sine of a sum of angles, expanded by the addition theorems.
    pub fn cos_sin(&self, ring: &mut Ring, turn: &Turn) -> (Poly, Poly) {
        let unshifted = turn.joints.iter().try_fold(turn.rest.constant, |constant, (coefficient, joint)| {
            let shift = self.shifts.get(*joint).copied().unwrap_or_default();
            constant.sub(shift.times(*coefficient)?)
        });
        let Some(constant) = unshifted else {
            ring.exhaust();
            return (Poly::zero(), Poly::zero());
        };
        let mut sum = ring.constant_pair(constant);
        let params = turn.rest.params.iter().filter_map(|(c, i)| self.params.get(*i).map(|(_, v)| (*c, *v)));
        let joints = turn.joints.iter().filter_map(|(c, j)| self.joints.get(*j).map(|(_, v)| (*c, *v)));
        for (coefficient, cosine) in joints.chain(params).collect::<Vec<_>>() {
            let cos = ring.var(cosine);
            let sin = ring.var(Var(cosine.0 + 1));
            let sin = if coefficient < 0 { sin.neg() } else { sin };
            for _ in 0..coefficient.unsigned_abs() {
                if ring.exhausted() {
                    break;
                }
                let (c, s) = sum;
                sum = (
                    ring.sub(&ring.mul(&c, &cos), &ring.mul(&s, &sin)),
                    ring.add(&ring.mul(&s, &cos), &ring.mul(&c, &sin)),
                );
            }
        }
        sum
    }

    /// A distance.
    pub fn distance(&self, ring: &Ring, distance: &Distance) -> Poly {
        distance.0.iter().fold(Poly::zero(), |sum, &(coefficient, atom)| {
            let atom = match atom {
                LengthAtom::Constant(index) => self.length(ring, index),
                LengthAtom::Param(index) => self.param(ring, index),
            };
            ring.add(&sum, &ring.scale(&atom, coefficient))
        })
    }

    /// The derivative by the value of one joint.
    pub fn derivative(&self, ring: &Ring, poly: &Poly, joint: usize) -> Poly {
        match self.joints.get(joint) {
            Some((JointKind::Revolute, cos)) => ring.derivative_by_angle(poly, *cos),
            Some((JointKind::Prismatic, var)) => ring.derivative(poly, *var),
            None => Poly::zero(),
        }
    }
}

/// The constant part of a revolute joint's cell, in the sense of the row value; 0 for quarter turns.
fn shift(chain: &Chain, joint: usize) -> Angle {
    for element in &chain.elements {
        if let Motion::Revolute { joint: found, reversed, offset } = &element.motion
            && *found == joint
            && offset.constant.quarters().is_none()
        {
            return if *reversed { offset.constant.neg() } else { offset.constant };
        }
    }
    Angle::zero()
}

/// The name of an entry of a given pose: `r11` … `r33` by rows, then `px`, `py`, `pz`.
pub fn entry_name(index: usize) -> String {
    match index {
        0..=8 => format!("r{}{}", index / 3 + 1, index % 3 + 1),
        _ => format!("p{}", ["x", "y", "z"][(index - 9).min(2)]),
    }
}

/// A pose as polynomials.
#[derive(Clone, Debug)]
pub struct RawPose {
    /// The rotation, by rows.
    pub rotation: M3<Poly>,
    /// The position.
    pub position: V3<Poly>,
}

/// The plain product of a stretch of the chain.
#[derive(Clone, Debug)]
pub struct Raw {
    /// For each joint of the stretch: its index, the direction in which it moves, a point on its axis.
    pub axes: Vec<(usize, V3<Poly>, V3<Poly>)>,
    /// The frame at the end of each joint's row.
    pub frames: Vec<RawPose>,
    /// The end of the stretch.
    pub tip: RawPose,
}

/// Multiplies a stretch out; `None` if an exact angle cannot be represented.
pub fn walk(
    ring: &mut Ring,
    symbols: &Symbols,
    chain: &Chain,
    values: Values,
    stretch: &Stretch<'_>,
) -> Option<Raw> {
    let mut pose = RawPose { rotation: vector::identity(ring), position: vector::origin(ring) };
    let (mut axes, mut frames) = (Vec::new(), Vec::new());
    for (index, element) in stretch.elements.iter().enumerate() {
        frames.extend(stretch.frames.iter().filter(|f| **f == index).map(|_| pose.clone()));
        let axis = axis_index(element.axis);
        let direction = vector::column(&pose.rotation, axis);
        let along =
            |reversed: bool| if reversed { direction.clone().map(|x| x.neg()) } else { direction.clone() };
        match &element.motion {
            Motion::Turn(sum) => {
                let turn = Turn { joints: Vec::new(), rest: sum.clone() };
                pose.rotation = turned(ring, symbols, &pose.rotation, axis, &turn);
            }
            Motion::Revolute { joint, reversed, .. } => {
                axes.push((*joint, along(*reversed), pose.position.clone()));
                let turn = joint_turn(chain, values, &element.motion)?;
                pose.rotation = turned(ring, symbols, &pose.rotation, axis, &turn);
            }
            Motion::Shift(length) => {
                let length = symbols.distance(ring, length);
                let step = vector::scale(ring, &length, &direction);
                pose.position = vector::add(ring, &pose.position, &step);
            }
            Motion::Prismatic { joint, reversed, offset } => {
                axes.push((*joint, along(*reversed), pose.position.clone()));
                if values != Values::Home {
                    let slide = symbols.slide(ring, *joint);
                    let offset = symbols.distance(ring, offset);
                    let length =
                        if *reversed { ring.sub(&offset, &slide) } else { ring.add(&offset, &slide) };
                    let step = vector::scale(ring, &length, &direction);
                    pose.position = vector::add(ring, &pose.position, &step);
                }
            }
        }
    }
    frames.extend(stretch.frames.iter().filter(|f| **f >= stretch.elements.len()).map(|_| pose.clone()));
    Some(Raw { axes, frames, tip: pose })
}

/// `m` times the rotation by `turn` about one axis: two columns mix, the third stays.
fn turned(ring: &mut Ring, symbols: &Symbols, m: &M3<Poly>, axis: usize, turn: &Turn) -> M3<Poly> {
    let (cos, sin) = symbols.cos_sin(ring, turn);
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut result = m.clone();
    for (row, new) in m.iter().zip(result.iter_mut()) {
        new[next] = ring.add(&ring.mul(&row[next], &cos), &ring.mul(&row[last], &sin));
        new[last] = ring.sub(&ring.mul(&row[last], &cos), &ring.mul(&row[next], &sin));
    }
    result
}

/// The geometric Jacobian with respect to the commanded values, one column for each joint: the derivative of the tip's
/// position, then the angular velocity, both in the axes of the world.
pub fn jacobian(ring: &Ring, symbols: &Symbols, chain: &Chain, raw: &Raw) -> Vec<[Poly; 6]> {
    (0..chain.joints.len())
        .map(|column| {
            let mut out: [Poly; 6] = Default::default();
            for (i, p) in raw.tip.position.iter().enumerate() {
                out[i] = symbols.derivative(ring, p, column);
            }
            for (joint, direction, _) in &raw.axes {
                if chain.joints[*joint].kind == JointKind::Revolute {
                    for (i, z) in direction.iter().enumerate() {
                        let share = ring.scale(z, chain.couple[*joint][column]);
                        out[3 + i] = ring.add(&out[3 + i], &share);
                    }
                }
            }
            out
        })
        .collect()
}

/// A constant frame outside the joints: the base or the tool.
#[derive(Clone, Debug)]
pub struct Outer {
    /// The frame.
    pub pose: RawPose,
    /// Whether it is turned by more than quarter turns and one other turn about an axis. Then its entries are constants
    /// of their own, each with its exact value: nothing about them is used but that they are what they are, and
    /// polynomials stay small.
    pub general: bool,
}

/// The base and the tool.
#[derive(Clone, Debug)]
pub struct Outers {
    /// From the world to the first row.
    pub base: Outer,
    /// From the last row to the tool point.
    pub tool: Outer,
}

/// Makes the outer frames of an arm; `None` if an exact angle cannot be represented.
pub fn outers(ring: &mut Ring, symbols: &Symbols, chain: &Chain) -> Option<Outers> {
    let base = outer(ring, symbols, chain, &chain.base, "base")?;
    Some(Outers { base, tool: outer(ring, symbols, chain, &chain.tool, "tool")? })
}

/// A turn about one axis leaves five entries of a rotation 0 or ±1.
const ENTRIES_OF_ONE_TURN: usize = 4;

fn outer(
    ring: &mut Ring,
    symbols: &Symbols,
    chain: &Chain,
    elements: &[Element],
    name: &str,
) -> Option<Outer> {
    let stretch = Stretch { elements: elements.iter().collect(), frames: Vec::new() };
    let pose = walk(ring, symbols, chain, Values::Home, &stretch)?.tip;
    let rotation = pose.rotation.iter().flatten();
    // With a parameter in it there is no value to stand for it.
    let constant = rotation.clone().chain(&pose.position).all(|entry| ring.is_constant(entry));
    let turned = rotation.clone().filter(|entry| entry.as_unit().is_none()).count();
    if !constant || turned <= ENTRIES_OF_ONE_TURN {
        return Some(Outer { pose, general: false });
    }
    let mut named = |entry: &Poly, suffix: String| {
        if entry.as_unit().is_some() || ring.is_length(entry) {
            return entry.clone();
        }
        let value = ring.value(entry);
        let var = ring.constant(format!("{name}{suffix}"), value);
        ring.var(var)
    };
    let rotation =
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| named(&pose.rotation[i][j], format!("{}{}", i + 1, j + 1))));
    let position = [0, 1, 2].map(|i| named(&pose.position[i], format!("_{}", ["x", "y", "z"][i])));
    Some(Outer { pose: RawPose { rotation, position }, general: true })
}

/// One frame after another.
pub fn compose(ring: &mut Ring, first: &RawPose, then: &RawPose) -> RawPose {
    let offset = vector::apply(ring, &first.rotation, &then.position);
    RawPose {
        rotation: vector::product(ring, &first.rotation, &then.rotation),
        position: vector::add(ring, &first.position, &offset),
    }
}

/// The whole chain, base and tool included; `None` if an exact angle cannot be represented.
pub fn whole(
    ring: &mut Ring,
    symbols: &Symbols,
    chain: &Chain,
    values: Values,
    outers: &Outers,
) -> Option<Raw> {
    let rows = Stretch { elements: chain.elements.iter().collect(), frames: chain.frames.clone() };
    let raw = walk(ring, symbols, chain, values, &rows)?;
    let base = &outers.base.pose;
    let mut axes = Vec::new();
    for (joint, direction, point) in raw.axes {
        let from_base = vector::apply(ring, &base.rotation, &point);
        let direction = vector::apply(ring, &base.rotation, &direction);
        axes.push((joint, direction, vector::add(ring, &base.position, &from_base)));
    }
    let frames = raw.frames.iter().map(|frame| compose(ring, base, frame)).collect();
    let flange = compose(ring, base, &raw.tip);
    Some(Raw { axes, frames, tip: compose(ring, &flange, &outers.tool.pose) })
}
