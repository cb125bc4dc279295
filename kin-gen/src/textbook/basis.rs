//! The angles in which formulas are written: the joints' own, or sums along runs of parallel axes.

use crate::algebra::frame::axis_index;
use crate::algebra::ring::{Poly, Ring, Var};
use crate::algebra::vector::{self, M3};
use crate::chain::{Chain, Distance, JointKind, LengthAtom, Motion, ParamKind};

/// A ring and what its variables stand for.
pub(super) struct Basis {
    pub(super) ring: Ring,
    /// For each pair of variables its suffix and the sum that it is of.
    pub(super) angles: Vec<(String, Vec<(i64, usize)>)>,
    /// For each joint: the signed pairs whose sum is its angle, or the variable of its slide.
    joints: Vec<Vec<(i64, Var)>>,
    lengths: Vec<Var>,
    params: Vec<Var>,
}

/// A run of parallel axes up to one of its joints.
struct Run {
    /// The sum of the run's angles.
    sum: Vec<(i64, usize)>,
    /// The direction in which the last joint turns, seen from the first one's.
    sign: i64,
}

impl Basis {
    /// The joints' own angles.
    pub(super) fn own(chain: &Chain) -> Option<Basis> {
        let alone = |joint: usize| Run { sum: vec![(1, joint)], sign: 1 };
        Basis::with(chain, (0..chain.joints.len()).map(alone).collect())
    }

    /// Partial sums along runs of parallel axes.
    pub(super) fn fused(chain: &Chain) -> Option<Basis> {
        let runs = runs(chain)?;
        Basis::with(chain, runs)
    }

    fn with(chain: &Chain, runs: Vec<Run>) -> Option<Basis> {
        let mut ring = Ring::new();
        let (mut angles, mut joints) = (Vec::new(), Vec::new());
        let mut pairs: Vec<Option<Var>> = Vec::new();
        for (joint, run) in runs.iter().enumerate() {
            if chain.joints.get(joint)?.kind == JointKind::Prismatic {
                pairs.push(None);
                joints.push(vec![(1, ring.free(format!("q{}", joint + 1)))]);
                continue;
            }
            let suffix = suffix(&run.sum);
            let pair = ring.pair(&suffix).0;
            angles.push((suffix, run.sum.clone()));
            pairs.push(Some(pair));
            // The joint's angle is this sum less the one before it in the run, in the joint's own direction.
            let before = run.sum.len().checked_sub(2).and_then(|i| run.sum.get(i)).map(|(_, j)| *j);
            let mut parts = vec![(run.sign, pair)];
            parts.extend(before.and_then(|j| pairs.get(j).copied().flatten()).map(|pair| (-run.sign, pair)));
            joints.push(parts);
        }
        let lengths = chain.lengths.iter().map(|l| ring.constant(l.name.clone(), l.value)).collect();
        let param = |(index, param): (usize, &crate::chain::Param)| match param.kind {
            ParamKind::Length => ring.param(param.name.clone(), index),
            ParamKind::Angle => ring.param_pair(&param.name, index).0,
        };
        let params = chain.params.iter().enumerate().map(param).collect();
        Some(Basis { ring, angles, joints, lengths, params })
    }

    /// Cosine and sine of what an element turns by; `None` where an exact angle cannot be represented.
    pub(super) fn cos_sin(&mut self, motion: &Motion) -> Option<(Poly, Poly)> {
        let (rest, joint) = match motion {
            Motion::Turn(rest) => (rest, None),
            Motion::Revolute { joint, reversed, offset } => (offset, Some((*joint, *reversed))),
            Motion::Shift(_) | Motion::Prismatic { .. } => return None,
        };
        let mut sum = self.ring.constant_pair(rest.constant);
        for (coefficient, param) in &rest.params {
            let pair = *self.params.get(*param)?;
            for _ in 0..coefficient.unsigned_abs() {
                sum = self.turned(&sum, pair, coefficient.signum());
            }
        }
        if let Some((joint, reversed)) = joint {
            let sign = if reversed { -1 } else { 1 };
            for (coefficient, pair) in self.joints.get(joint)?.clone() {
                sum = self.turned(&sum, pair, sign * coefficient);
            }
        }
        Some(sum)
    }

    /// The addition theorems.
    fn turned(&self, (c, s): &(Poly, Poly), pair: Var, sign: i64) -> (Poly, Poly) {
        let ring = &self.ring;
        let (cos, sin) = (ring.var(pair), ring.scale(&ring.var(Var(pair.0 + 1)), sign));
        (ring.sub(&ring.mul(c, &cos), &ring.mul(s, &sin)), ring.add(&ring.mul(s, &cos), &ring.mul(c, &sin)))
    }

    /// What an element shifts by; 0 if it turns.
    pub(super) fn length(&self, motion: &Motion) -> Poly {
        match motion {
            Motion::Shift(distance) => self.distance(distance),
            Motion::Prismatic { joint, reversed, offset } => {
                let slide = self.joints.get(*joint).and_then(|parts| parts.first());
                let slide = slide.map_or_else(Poly::zero, |(_, var)| self.ring.var(*var));
                let slide = if *reversed { slide.neg() } else { slide };
                self.ring.add(&self.distance(offset), &slide)
            }
            Motion::Turn(_) | Motion::Revolute { .. } => Poly::zero(),
        }
    }

    fn distance(&self, distance: &Distance) -> Poly {
        distance.0.iter().fold(Poly::zero(), |sum, (coefficient, atom)| {
            let var = match atom {
                LengthAtom::Constant(index) => self.lengths.get(*index),
                LengthAtom::Param(index) => self.params.get(*index),
            };
            let atom = var.map_or_else(Poly::zero, |var| self.ring.var(*var));
            self.ring.add(&sum, &self.ring.scale(&atom, *coefficient))
        })
    }
}

/// A polynomial of another ring, by the names of its variables; `None` if one of them is not there.
pub(super) fn translate(from: &Ring, to: &Ring, poly: &Poly) -> Option<Poly> {
    let mut sum = Poly::zero();
    for part in from.parts(poly) {
        let mut product = Poly::integer(part.coefficient);
        for (name, exponent) in part.factors {
            let var = to.named(name)?;
            product = (0..exponent).fold(product, |product, _| to.mul(&product, &var));
        }
        sum = to.add(&sum, &product);
    }
    Some(sum)
}

/// `23`, or `2-3` where the second axis points the other way.
fn suffix(sum: &[(i64, usize)]) -> String {
    let name = |(coefficient, joint): &(i64, usize)| {
        format!("{}{}", if *coefficient < 0 { "-" } else { "" }, joint + 1)
    };
    sum.iter().map(name).collect()
}

/// For each joint the run of parallel axes that ends with it.
fn runs(chain: &Chain) -> Option<Vec<Run>> {
    let mut constants = Basis::own(chain)?;
    let mut runs: Vec<Run> = Vec::new();
    // The last turning joint: its index, its axis, and the constant rotation since.
    let mut last: Option<(usize, usize, M3<Poly>)> = None;
    for element in &chain.elements {
        let axis = axis_index(element.axis);
        match &element.motion {
            Motion::Turn(_) => {
                let (cos, sin) = constants.cos_sin(&element.motion)?;
                if let Some((_, _, since)) = &mut last {
                    let turn = vector::rotation(&mut constants.ring, axis, &cos, &sin);
                    *since = vector::product(&mut constants.ring, since, &turn);
                }
            }
            Motion::Shift(_) => {}
            Motion::Prismatic { joint, .. } => runs.push(Run { sum: vec![(1, *joint)], sign: 1 }),
            Motion::Revolute { joint, reversed, .. } => {
                let way = if *reversed { -1 } else { 1 };
                let before = last.as_ref().and_then(|(joint, along, since)| {
                    let turned = vector::column(since, axis);
                    let unit = turned.get(*along)?.as_unit().filter(|unit| unit.abs() == 1)?;
                    Some((runs.get(*joint)?, *joint, unit))
                });
                let run = match before {
                    Some((run, joint_before, unit)) => {
                        let sign = run.sign * unit * way * direction(chain, joint_before);
                        Run { sum: [run.sum.as_slice(), &[(sign, *joint)]].concat(), sign }
                    }
                    None => Run { sum: vec![(1, *joint)], sign: 1 },
                };
                runs.push(run);
                // The constant part of the cell turns about the joint's own axis and leaves it where it is.
                last = Some((*joint, axis, vector::identity(&constants.ring)));
            }
        }
    }
    Some(runs)
}

/// -1 if the joint's cell says `-q`.
fn direction(chain: &Chain, wanted: usize) -> i64 {
    let reversed = chain.elements.iter().any(
        |element| matches!(element.motion, Motion::Revolute { joint, reversed: true, .. } if joint == wanted),
    );
    if reversed { -1 } else { 1 }
}
