//! A plan carried out over the numbers of one arm.

use std::collections::BTreeMap;

use super::gauge::{self, Fitted, SlideDirection};
use super::graph::Kind;
use super::recipe::{Operand, Recipe};
use super::routes::Wanted;
use super::shipped;
use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::Frames;
use crate::algebra::vector::{self, M3, V3};

/// A pose: the rotation by rows, and the position.
pub type Pose = (M3<Term>, V3<Term>);

/// What a plan yields, in the axes of the world.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The pose of the tip, if that was wanted.
    pub pose: Option<Pose>,
    /// If the Jacobian was wanted, for each joint its index, the velocity of the tip and the axis.
    pub columns: Vec<(usize, V3<Term>, V3<Term>)>,
    /// Whether the plan is this structure's own and nothing had to be done around it: there is no better one.
    pub own: bool,
}

/// Carries out the plan of these frames; `None` if there is none.
pub fn planned(exprs: &mut Exprs, frames: &Frames, wanted: Wanted) -> Option<Planned> {
    let fitted = gauge::fit(exprs, frames)?;
    carried_out(exprs, &fitted, wanted)
}

/// The same for the rotation alone: the lengths of the frames are left out.
pub fn planned_turn(exprs: &mut Exprs, frames: &Frames) -> Option<Planned> {
    let mut fitted = gauge::fit(exprs, frames)?;
    fitted.forget_lengths();
    carried_out(exprs, &fitted, Wanted::Pose)
}

fn carried_out(exprs: &mut Exprs, fitted: &Fitted, wanted: Wanted) -> Option<Planned> {
    let (plan, own) = shipped::find(wanted, &fitted.shape_for(wanted))?;
    let outputs = outputs(exprs, fitted, &Recipe::parse(plan.text)?)?;
    let mut outputs = outputs.into_iter();
    let mut next = || Some([outputs.next()?, outputs.next()?, outputs.next()?]);
    let mut pose = None;
    if wanted != Wanted::Jacobian {
        let rotation = [next()?, next()?, next()?];
        pose = Some(placed(exprs, fitted, &rotation, &next()?));
    }
    let mut columns = Vec::new();
    if wanted != Wanted::Pose {
        for joint in &fitted.joints {
            let [velocity, axis] = [next()?, next()?].map(|v| {
                let v = vector::apply(exprs, &fitted.base, &v);
                if joint.negative { vector::negate(exprs, &v) } else { v }
            });
            columns.push((joint.joint, velocity, axis));
        }
        let directions: Vec<V3<Term>> = fitted.shape.slides.iter().map_while(|_| next()).collect();
        for (joint, direction) in &fitted.slides {
            let direction = match direction {
                SlideDirection::World(direction) => *direction,
                SlideDirection::Shape(index, negative) => {
                    let v = vector::apply(exprs, &fitted.base, directions.get(*index)?);
                    if *negative { vector::negate(exprs, &v) } else { v }
                }
            };
            columns.push((*joint, direction, [Term::ZERO; 3]));
        }
    }
    let own = own && is_quarter_turn(&fitted.base) && is_quarter_turn(&fitted.tip);
    Some(Planned { pose, columns, own })
}

fn is_quarter_turn(m: &M3<Term>) -> bool {
    m.iter().flatten().all(|t| *t == Term::ZERO || t.id == Term::ONE.id)
}

/// In the world, with the frame at the tip.
fn placed(exprs: &mut Exprs, fitted: &Fitted, rotation: &M3<Term>, position: &V3<Term>) -> Pose {
    let rotation = vector::product(exprs, &fitted.base, rotation);
    let rotation = vector::product(exprs, &rotation, &fitted.tip);
    let position = vector::apply(exprs, &fitted.base, position);
    (rotation, vector::add(exprs, &position, &fitted.origin))
}

fn outputs(exprs: &mut Exprs, fitted: &Fitted, recipe: &Recipe<'_>) -> Option<Vec<Term>> {
    let names = leaves(exprs, fitted);
    let mut terms: BTreeMap<&str, Term> = names.iter().map(|(name, term)| (name.as_str(), *term)).collect();
    for line in &recipe.lines {
        let [a, b] = [*terms.get(line.operands[0])?, *terms.get(line.operands[1])?];
        let value = match line.kind {
            Kind::Mul => exprs.mul(a, b),
            Kind::Add => exprs.add(a, b),
            Kind::Sub => exprs.sub(a, b),
        };
        let value = if line.negative { exprs.neg(value) } else { value };
        if let Some(name) = label(line.name, fitted) {
            // Which way the axes of a shape point is nobody's choice.
            exprs.label_up_to_sign(value, || name);
        }
        terms.insert(line.name, value);
    }
    let output = |Operand { name, negative }: &Operand<'_>| {
        let term = *terms.get(name)?;
        Some(if *negative { exprs.neg(term) } else { term })
    };
    recipe.outputs.iter().map(output).collect()
}

/// What the leaves of a plan are in this arm; lengths that it lacks are 0.
fn leaves(exprs: &mut Exprs, fitted: &Fitted) -> Vec<(String, Term)> {
    let mut leaves = vec![("0".to_owned(), Term::ZERO), ("1".to_owned(), Term::ONE)];
    for (index, joint) in fitted.joints.iter().enumerate() {
        let number = index + 1;
        let (cos, sin) = exprs.cos_sin(&joint.turn);
        let values = [("c", cos), ("s", sin), ("x", joint.link[0]), ("y", joint.link[1])];
        leaves.extend(values.map(|(letter, term)| (format!("{letter}{number}"), term)));
    }
    let offsets = fitted.offsets.iter().enumerate();
    leaves.extend(offsets.map(|(group, term)| (format!("d{}", group + 1), *term)));
    leaves
}

/// The name of a line with the arm's own numbers of its joints; `None` if it says nothing.
fn label(name: &str, fitted: &Fitted) -> Option<String> {
    let name = name.split('~').next().unwrap_or(name);
    let mut label = String::new();
    let mut number = 0;
    for c in name.chars().chain(['\0']) {
        match c.to_digit(10) {
            Some(digit) => number = 10 * number + digit as usize,
            None => {
                if number > 0 {
                    label.push_str(&(fitted.joints.get(number - 1)?.joint + 1).to_string());
                    number = 0;
                }
                if c != '\0' {
                    label.push(c);
                }
            }
        }
    }
    (!name.starts_with('k')).then_some(label)
}
