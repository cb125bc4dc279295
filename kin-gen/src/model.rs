//! The derived arm: its programs, each proved against the matrix product, and what its inverse solver is told.
//!
//! After [`derive()`]: every program equals the declaration's own product of elementary transforms as a polynomial, and
//! every constant in it is the double nearest to its exact value. The backends only print what stands here.

mod forward;
mod short;
mod shoulder;
mod spherical;
mod structures;

pub use structures::structures;

use crate::algebra::expr::{Exprs, Term};
use crate::algebra::frame::{self, Frames, Stretch, Values};
use crate::algebra::ring::{Poly, Ring};
use crate::algebra::vector::{self, M3, V3};
use crate::chain::{Chain, JointKind, LengthUnit, Motion, ParamKind};
use crate::derive::wrist;
use crate::family::spherical_shoulder::SphericalShoulder;
use crate::family::spherical_wrist::SphericalWrist;
use crate::family::{self, Inverse, position::Position, short::Short, wrist::Wrist};
use crate::number::Real;
use crate::program::{Mismatch, Program};
use crate::quantity::{Linear, Quantity};
use crate::truth::{self, Outers, Raw, Symbols};

/// A joint as the generated code lists it.
#[derive(Clone, PartialEq, Debug)]
pub struct JointFacts {
    /// Its name in the table.
    pub name: String,
    /// Turning or sliding.
    pub kind: JointKind,
    /// Inclusive limits in radians or the declared unit of length.
    pub limits: Option<(f64, f64)>,
}

/// A parameter as the generated code declares it.
#[derive(Clone, PartialEq, Debug)]
pub struct ParamFacts {
    /// The field's name.
    pub name: String,
    /// Length or angle.
    pub kind: ParamKind,
    /// Its nominal value, in the declared unit of length or in radians.
    pub nominal: f64,
}

/// The programs that every arm has.
#[derive(Clone, Debug)]
pub struct Forward {
    /// The tool's pose.
    pub fk: Program,
    /// The frame at the end of each joint's row.
    pub frames: Program,
    /// The geometric Jacobian.
    pub jacobian: Program,
    /// Both together.
    pub fk_jacobian: Program,
}

/// The programs that an inverse solver calls.
#[derive(Clone, Debug)]
pub enum Solver {
    /// For a pose.
    Pose(Box<PoseSolver>),
    /// For a pose, by a spherical shoulder.
    Shoulder(Box<ShoulderSolver>),
    /// For a pose, by two to five joints.
    Short(Box<ShortSolver>),
    /// For a position, and for a pose where there is one.
    Position(Box<PositionSolver>),
    /// None, and why not.
    None {
        /// One sentence, without a final full stop.
        reason: String,
        /// The element that causes it, by its index among the rows' elements, if one does.
        culprit: Option<usize>,
    },
}

/// What the spherical-wrist solver calls.
#[derive(Clone, Debug)]
pub struct PoseSolver {
    /// The recognised geometry.
    pub geometry: SphericalWrist,
    /// ³R₆ from the row values of joints 4 to 6.
    pub r36: Program,
    /// ⁰R₃ and the wrist centre from the row values of joints 1 to 3.
    pub r03: Program,
    /// The wrist centre of a given pose, in the shoulder frame.
    pub wrist_centre: Program,
    /// ³R₆ of a given pose, from the row values of joints 1 to 3.
    pub wrist_rotation: Program,
    /// The matrix from which the wrist angles are read, from ³R₆.
    pub wrist_matrix: Program,
    /// What [`PoseSolver::r36`] means.
    pub r36_meaning: M3<Poly>,
    /// The wrist centre in the base frame, as a function of the row values of joints 1 to 3.
    pub centre_meaning: V3<Poly>,
}

/// What the spherical-shoulder solver calls.
#[derive(Clone, Debug)]
pub struct ShoulderSolver {
    /// The recognised geometry.
    pub geometry: SphericalShoulder,
    /// The centre of the shoulder, seen from the tool of a given pose, in the frame of the geometry's base.
    pub shoulder_centre: Program,
    /// The rotation from the first row's frame to frame 3 of a given pose, from the row values of joints 4 to 6.
    pub shoulder_rotation: Program,
    /// The matrix from which the angles of the shoulder are read, from that rotation.
    pub shoulder_matrix: Program,
}

/// What the position solver calls.
#[derive(Clone, Debug)]
pub struct PositionSolver {
    /// The recognised geometry.
    pub geometry: Position,
    /// A given point in the shoulder frame.
    pub tool_point: Program,
    /// For a pose.
    pub pose: Option<ShortSolver>,
}

/// What the solver of short arms calls.
#[derive(Clone, Debug)]
pub struct ShortSolver {
    /// The recognised geometry.
    pub geometry: Short,
    /// The carried point of a given pose, in the frame of the joints that carry it.
    pub carried_point: Program,
    /// The rotation from which the turns are read, of a given pose, from the row values of the joints before them.
    pub rest: Program,
}

/// A derived arm.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The type's name.
    pub name: String,
    /// The declaration's own text.
    pub text: String,
    /// The declared unit of length.
    pub length_unit: LengthUnit,
    /// The joints, in order.
    pub joints: Vec<JointFacts>,
    /// The parameters, in order.
    pub params: Vec<ParamFacts>,
    /// Σ|a| + |d| of all rows and the tool, plus prismatic travel.
    pub reach: Quantity,
    /// Row values from commanded values, in integers.
    pub couple: Vec<Vec<i64>>,
    /// Commanded values from row values, in integers.
    pub uncouple: Vec<Vec<i64>>,
    /// Forward kinematics and Jacobian.
    pub forward: Forward,
    /// The inverse.
    pub solver: Solver,
    /// What the polynomials of this arm are printed with.
    pub ring: Ring,
    /// What the ring's variables stand for.
    pub symbols: Symbols,
    /// Its base and tool, as the truth of its programs has them.
    pub outers: Outers,
}

/// Derives and proves everything; `Err` is an internal error of this crate or an arm too large to be proved.
pub fn derive(chain: &Chain) -> Result<Arm, Mismatch> {
    let symbols = Symbols::of(chain);
    let mut ring = symbols.ring(chain);
    let outers = truth::outers(&mut ring, &symbols, chain).ok_or(Mismatch::TooLarge)?;
    let (inverse, ring) = family::recognise(chain, &symbols, ring, &outers);
    let mut work = Work { chain, symbols, outers, exprs: Exprs::new(ring) };
    let forward = work.forward()?;
    let solver = match inverse {
        Inverse::Pose(geometry) => Solver::Pose(Box::new(work.pose_solver(*geometry)?)),
        Inverse::Shoulder(geometry) => Solver::Shoulder(Box::new(work.shoulder_solver(*geometry)?)),
        Inverse::Short(geometry) => Solver::Short(Box::new(work.short_solver(*geometry)?)),
        Inverse::Position(geometry) => Solver::Position(Box::new(work.position_solver(*geometry)?)),
        Inverse::None { reason, culprit } => Solver::None { reason, culprit },
    };
    Ok(Arm {
        name: chain.name.clone(),
        text: chain.text.clone(),
        length_unit: chain.length_unit,
        joints: chain.joints.iter().map(joint_facts).collect(),
        params: chain
            .params
            .iter()
            .map(|p| ParamFacts { name: p.name.clone(), kind: p.kind, nominal: p.nominal.to_f64() })
            .collect(),
        reach: reach(chain, &work.symbols, &work.exprs.ring),
        couple: chain.couple.clone(),
        uncouple: chain.uncouple.clone(),
        forward,
        solver,
        ring: work.exprs.ring,
        symbols: work.symbols,
        outers: work.outers,
    })
}

fn joint_facts(joint: &crate::chain::Joint) -> JointFacts {
    let limits = joint.limits.map(|(low, high)| (low.to_f64(), high.to_f64()));
    JointFacts { name: joint.name.clone(), kind: joint.kind, limits }
}

/// One arm being derived.
struct Work<'a> {
    chain: &'a Chain,
    symbols: Symbols,
    outers: Outers,
    exprs: Exprs,
}

impl Work<'_> {
    fn frames(&mut self, values: Values, stretch: &Stretch<'_>) -> Result<Frames, Mismatch> {
        frame::frames(&mut self.exprs, self.chain, values, stretch).ok_or(Mismatch::TooLarge)
    }

    fn raw(&mut self, values: Values, stretch: &Stretch<'_>) -> Result<Raw, Mismatch> {
        truth::walk(&mut self.exprs.ring, &self.symbols, self.chain, values, stretch)
            .ok_or(Mismatch::TooLarge)
    }

    /// The program of these outputs, proved.
    fn program(
        &mut self,
        name: &'static str,
        outputs: &[(String, Term)],
        truth: &[Poly],
    ) -> Result<Program, Mismatch> {
        let program = Program::flatten(name, &self.exprs, outputs);
        program.prove(&mut self.exprs.ring, &self.symbols, truth)?;
        Ok(program)
    }

    fn position_solver(&mut self, geometry: Position) -> Result<PositionSolver, Mismatch> {
        let zero = vector::origin(&self.exprs.ring);
        let tool_point = self.point_program("tool_point", &zero, geometry.carrier.frame())?;
        let pose = match geometry.pose.clone() {
            Some(short) => Some(self.short_solver(short)?),
            None => None,
        };
        Ok(PositionSolver { geometry, tool_point, pose })
    }

    /// A point fixed in the given pose, in a frame of which the orientation and the origin are given.
    fn point_program(
        &mut self,
        name: &'static str,
        local: &V3<Poly>,
        (axes, origin): (&M3<Poly>, &V3<Poly>),
    ) -> Result<Program, Mismatch> {
        let start = self.exprs.mark();
        let derived = wrist::point_of_pose(&mut self.exprs, local, axes, origin);
        let given = self.given_rotation();
        let position = [9, 10, 11].map(|i| self.symbols.entry(&self.exprs.ring, i));
        let ring = &mut self.exprs.ring;
        let offset = vector::apply(ring, &given, local);
        let point = vector::add(ring, &position, &offset);
        let from_origin = vector::sub(ring, &point, origin);
        let truth = vector::apply(ring, &vector::transpose(axes), &from_origin);
        let program = self.program(name, &coordinates(derived), &truth)?;
        self.exprs.roll_back(start);
        Ok(program)
    }

    /// The matrix from which the angles of three axes through one point are read, from a given rotation.
    fn matrix_program(&mut self, name: &'static str, wrist: &Wrist) -> Result<Program, Mismatch> {
        let start = self.exprs.mark();
        let derived = wrist::framed(&mut self.exprs, &wrist.before, &wrist.after);
        let given = self.given_rotation();
        let ring = &mut self.exprs.ring;
        let left = vector::product(ring, &vector::transpose(&wrist.before), &given);
        let truth = vector::product(ring, &left, &wrist.after);
        let program = self.program(name, &matrix_outputs(&derived), &flat(&truth))?;
        self.exprs.roll_back(start);
        Ok(program)
    }

    fn given_rotation(&self) -> M3<Poly> {
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| self.symbols.entry(&self.exprs.ring, 3 * i + j)))
    }
}

fn flat<T: Clone>(m: &M3<T>) -> Vec<T> {
    m.iter().flatten().cloned().collect()
}

/// `r11` … `r33`.
fn rotation_outputs(m: &M3<Term>) -> Vec<(String, Term)> {
    flat(m).into_iter().enumerate().map(|(i, term)| (truth::entry_name(i), term)).collect()
}

/// `m11` … `m33`: what is made from a given rotation, whose own entries are `r11` … `r33`.
fn matrix_outputs(m: &M3<Term>) -> Vec<(String, Term)> {
    flat(m).into_iter().enumerate().map(|(i, term)| (format!("m{}{}", i / 3 + 1, i % 3 + 1), term)).collect()
}

/// `x`, `y`, `z`.
fn coordinates(v: V3<Term>) -> Vec<(String, Term)> {
    ["x", "y", "z"].iter().zip(v).map(|(name, term)| ((*name).to_owned(), term)).collect()
}

/// Σ|a| + |d| of all rows and the tool, plus prismatic travel (the larger limit); one unit where that is nothing.
fn reach(chain: &Chain, symbols: &Symbols, ring: &Ring) -> Quantity {
    let mut constant = Real::ZERO;
    let mut forms = Vec::new();
    for element in chain.elements.iter().chain(&chain.tool) {
        let distance = match &element.motion {
            Motion::Shift(distance) => distance.clone(),
            Motion::Prismatic { joint, offset, .. } => {
                if let Some((low, high)) = chain.joints.get(*joint).and_then(|j| j.limits) {
                    let (low, high) = (low.to_real().abs(), high.to_real().abs());
                    constant = constant + if low > high { low } else { high };
                }
                offset.clone()
            }
            Motion::Turn(_) | Motion::Revolute { .. } => continue,
        };
        match Linear::of(ring, &symbols.distance(ring, &distance)) {
            Some(form) => match form.as_constant() {
                Some(value) => constant = constant + value.abs(),
                None => forms.push(form),
            },
            None => continue,
        }
    }
    // The same for an arm without a size of its own as in `Chain::reach`.
    if constant.is_zero() && forms.is_empty() {
        constant = chain.reach().to_real();
    }
    Quantity::SumOfAbsolutes(constant, forms)
}
