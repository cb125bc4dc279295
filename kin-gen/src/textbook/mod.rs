//! What a textbook prints of an arm: link matrices, ⁰T₆, axes, Jacobian, the factors of its determinant.
//!
//! Programs are chosen to be cheap; what stands here is chosen to be read. The same plain product is taken in two
//! sets of angles. In the joints' *own* angles the link matrices are short. In *fused* angles, the partial sums
//! θ₂, θ₂ + θ₃, … along each run of parallel axes, positions and orientations are: c23 is a variable, not c2·c3 - s2·s3.
//! The sums are as many as the joints, and independent as these are, so that a normal form in them is one too.
//! Joint values are row values: `couple:` is not in these formulas.

mod basis;
mod determinant;

pub use determinant::{Determinant, Factor};

use crate::algebra::frame::axis_index;
use crate::algebra::ring::{Poly, Ring};
use crate::algebra::vector::{self, M3, V3};
use crate::chain::{Chain, Element, JointKind, Motion};
use crate::model::{Arm, Solver};
use basis::Basis;

/// An orientation and a position.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The rotation, by rows.
    pub rotation: M3<Poly>,
    /// The position.
    pub position: V3<Poly>,
}

/// The axis of a joint.
#[derive(Clone, Debug)]
pub struct JointAxis {
    /// Turning or sliding.
    pub kind: JointKind,
    /// Its direction.
    pub direction: V3<Poly>,
    /// A point on it.
    pub point: V3<Poly>,
}

/// The arm in one set of angles.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// What its polynomials are printed with.
    pub ring: Ring,
    /// For each name behind `c` and `s`: the joints, counted from 0, and the signs with which their angles are summed.
    pub angles: Vec<(String, Vec<(i64, usize)>)>,
    /// The base frame, then the frame at the end of each joint's row.
    pub frames: Vec<Frame>,
    /// The tool.
    pub tip: Frame,
    /// The axes.
    pub axes: Vec<JointAxis>,
    /// The point in which the last three axes meet, if the arm has a spherical wrist.
    pub wrist_centre: Option<V3<Poly>>,
}

/// Everything that is printed of an arm.
#[derive(Clone, Debug)]
pub struct Textbook {
    /// In the joints' own angles.
    pub own: Formulas,
    /// The matrix of each joint's rows, fixed rows before it included, then what follows the last joint if anything
    /// does; in the joints' own angles.
    pub links: Vec<Frame>,
    /// In fused angles.
    pub fused: Formulas,
    /// The geometric Jacobian in fused angles, column by column: z × (p - o), then z.
    pub jacobian: Vec<[Poly; 6]>,
    /// Its determinant, for a spherical wrist on three joints; for an arm of three joints that of its linear rows.
    pub determinant: Option<Determinant>,
}

/// The formulas of a derived arm; `None` if they exceed what can be represented.
pub fn of(chain: &Chain, arm: &Arm) -> Option<Textbook> {
    let mut own = Basis::own(chain)?;
    let links = links(&mut own, chain)?;
    let own = formulas(own, chain, arm)?;
    let mut fused = formulas(Basis::fused(chain)?, chain, arm)?;
    let jacobian = jacobian(&mut fused);
    let determinant = determinant::of(&own, &fused);
    let exhausted = own.ring.exhausted() || fused.ring.exhausted();
    (!exhausted).then_some(Textbook { own, links, fused, jacobian, determinant })
}

fn identity(ring: &Ring) -> Frame {
    Frame { rotation: vector::identity(ring), position: vector::origin(ring) }
}

/// Carries a frame over one element.
fn step(basis: &mut Basis, frame: &mut Frame, element: &Element) -> Option<()> {
    let axis = axis_index(element.axis);
    match &element.motion {
        Motion::Turn(_) | Motion::Revolute { .. } => {
            let (cos, sin) = basis.cos_sin(&element.motion)?;
            let turn = vector::rotation(&mut basis.ring, axis, &cos, &sin);
            frame.rotation = vector::product(&mut basis.ring, &frame.rotation, &turn);
        }
        Motion::Shift(_) | Motion::Prismatic { .. } => {
            let length = basis.length(&element.motion);
            let direction = vector::column(&frame.rotation, axis);
            let way = vector::scale(&mut basis.ring, &length, &direction);
            frame.position = vector::add(&mut basis.ring, &frame.position, &way);
        }
    }
    Some(())
}

fn links(basis: &mut Basis, chain: &Chain) -> Option<Vec<Frame>> {
    let mut links = Vec::new();
    let mut start = 0;
    let ends = chain.frames.iter().copied().chain([chain.elements.len()]);
    for end in ends {
        let mut link = identity(&basis.ring);
        let rows = chain.elements.get(start..end).unwrap_or(&[]);
        let before = if links.is_empty() { chain.base.as_slice() } else { &[] };
        let after = if links.len() == chain.frames.len() { chain.tool.as_slice() } else { &[] };
        let mut any = false;
        for element in before.iter().chain(rows).chain(after) {
            step(basis, &mut link, element)?;
            any = true;
        }
        if any {
            links.push(link);
        }
        start = end;
    }
    Some(links)
}

fn formulas(mut basis: Basis, chain: &Chain, arm: &Arm) -> Option<Formulas> {
    let mut frame = identity(&basis.ring);
    for element in &chain.base {
        step(&mut basis, &mut frame, element)?;
    }
    let (mut frames, mut axes) = (vec![frame.clone()], Vec::new());
    for (index, element) in chain.elements.iter().enumerate() {
        if let Motion::Revolute { joint, reversed, .. } | Motion::Prismatic { joint, reversed, .. } =
            &element.motion
        {
            let direction = vector::column(&frame.rotation, axis_index(element.axis));
            axes.push(JointAxis {
                kind: chain.joints.get(*joint)?.kind,
                direction: if *reversed { vector::negate(&mut basis.ring, &direction) } else { direction },
                point: frame.position.clone(),
            });
        }
        step(&mut basis, &mut frame, element)?;
        frames.extend(chain.frames.iter().filter(|end| **end == index + 1).map(|_| frame.clone()));
    }
    for element in &chain.tool {
        step(&mut basis, &mut frame, element)?;
    }
    let wrist_centre = match (&arm.solver, frames.get(3)) {
        (Solver::Pose(solver), Some(third)) => {
            let local = solver
                .geometry
                .centre_in_frame3
                .each_ref()
                .map(|p| basis::translate(&arm.ring, &basis.ring, p));
            let [Some(x), Some(y), Some(z)] = local else { return None };
            let offset = vector::apply(&mut basis.ring, &third.rotation, &[x, y, z]);
            Some(vector::add(&mut basis.ring, &third.position, &offset))
        }
        _ => None,
    };
    Some(Formulas { ring: basis.ring, angles: basis.angles, frames, tip: frame, axes, wrist_centre })
}

/// The column of a joint for the velocity of a point.
fn column(ring: &mut Ring, axis: &JointAxis, point: &V3<Poly>) -> [Poly; 6] {
    let zero = vector::origin(ring);
    let (v, w) = match axis.kind {
        JointKind::Revolute => {
            let arm = vector::sub(ring, point, &axis.point);
            (vector::cross(ring, &axis.direction, &arm), axis.direction.clone())
        }
        JointKind::Prismatic => (axis.direction.clone(), zero),
    };
    let ([a, b, c], [x, y, z]) = (v, w);
    [a, b, c, x, y, z]
}

fn jacobian(formulas: &mut Formulas) -> Vec<[Poly; 6]> {
    let tip = formulas.tip.position.clone();
    formulas.axes.iter().map(|axis| column(&mut formulas.ring, axis, &tip)).collect()
}
