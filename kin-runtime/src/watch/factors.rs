//! The factors of det J: one for each kind of singular pose, with its sign.
//!
//! Where the last three axes meet, the Jacobian taken at the wrist centre has a block of zeros, and its determinant is that of
//! the wrist centre's motion under the first three joints times that of the last three axes (K. Waldron, S. Wang and
//! S. Bolin, "A study of the Jacobian matrix of serial manipulators", 1985). Where joints 2 and 3 move the wrist centre in a
//! plane at right angles to axis 2, the first splits again:
//!
//! * shoulder: the velocity of the wrist centre along axis 2 that joint 1 gives it, c₁·z₂;
//! * elbow: the area that its velocities under joints 2 and 3 span, z₂·(c₂ × c₃);
//! * wrist: the volume that the axes span, z₄·(z₅ × z₆).
//!
//! Where the first three axes meet it is the same from the other end, at the centre of the shoulder as the tool carries it:
//!
//! * hand: c₆·z₅;
//! * elbow: z₅·(c₅ × c₄);
//! * bend: z₁·(z₂ × z₃).
//!
//! All are normalised as in [`singularity`](crate::singularity): their product is the determinant of
//! [`normalised`](crate::singularity::normalised).

use crate::arm::{Arm, InverseKinematics, Joint, JointKind};
use crate::ik::Base;
use crate::math::Real;
use crate::pose::{self, Jacobian, Joints};
use crate::private::{SolvePosition, SolveShoulder, SolveWrist};
use crate::solutions::{Posture, ShoulderPosture};

/// The factors of the determinant of the normalised Jacobian. Each is zero where, and only where, the arm is in a singular
/// pose of its kind, and changes sign there if it is crossed.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Factors<T> {
    /// That of the three joints that carry the point where the other axes meet: shoulder, or hand, times elbow, where these are
    /// told apart.
    pub base: T,
    /// The wrist centre's distance from the plane through axis 1 in which both shoulders are one, times the sine of the angle
    /// between axes 1 and 2, in reaches; `None` if joints 2 and 3 do not work in a plane, and for a spherical shoulder.
    pub shoulder: Option<T>,
    /// The sine of the elbow times the lengths of both links, in squares of the reach; for a slide, its extension in reaches.
    /// `None` if the two joints about it do not work in a plane.
    pub elbow: Option<T>,
    /// The sine of the wrist's bend (times those of its twists, if they are no right angles); `None` for an arm without a
    /// wrist.
    pub wrist: Option<T>,
    /// Of a spherical shoulder: its centre's distance from the plane through axis 6 in which both hands are one, times the sine
    /// of the angle between axes 5 and 6, in reaches; `None` if joints 4 and 5 do not work in a plane, and for every other arm.
    pub hand: Option<T>,
    /// The sine of a spherical shoulder's bend, as the wrist's; `None` for every other arm.
    pub bend: Option<T>,
}

/// One of the factors.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Factor {
    /// Of the three joints that carry a point, together.
    Base,
    /// The first part of that.
    Shoulder,
    /// The second part of that.
    Elbow,
    /// Of the last three joints.
    Wrist,
    /// The first part of the base of an arm with a spherical shoulder.
    Hand,
    /// Of the first three joints of such an arm.
    Bend,
}

impl Factor {
    /// All of them.
    pub const ALL: [Factor; 6] =
        [Factor::Base, Factor::Shoulder, Factor::Elbow, Factor::Wrist, Factor::Hand, Factor::Bend];

    /// How many vectors its product has.
    pub(super) fn degree(self) -> usize {
        if matches!(self, Factor::Shoulder | Factor::Hand) { 2 } else { 3 }
    }
}

impl<T: Real> Factors<T> {
    /// One of them; `None` if the arm does not have it.
    pub fn get(&self, factor: Factor) -> Option<T> {
        match factor {
            Factor::Base => Some(self.base),
            Factor::Shoulder => self.shoulder,
            Factor::Elbow => self.elbow,
            Factor::Wrist => self.wrist,
            Factor::Hand => self.hand,
            Factor::Bend => self.bend,
        }
    }

    /// Their product: the determinant of the normalised Jacobian (of its linear rows, for an arm of three joints).
    pub fn determinant(&self) -> T {
        self.wrist.or(self.bend).map_or(self.base, |volume| self.base * volume)
    }
}

/// An arm whose determinant is known by its factors: those that have an inverse.
#[diagnostic::on_unimplemented(
    message = "the determinant of `{Self}` is not known by its factors",
    note = "it is for arms of six joints whose last, or first, three axes meet, and for arms of three joints; every arm \
            has `singularity::determinant`"
)]
pub trait Factored<const N: usize>: Arm<N> {
    /// The factors at `q`, in this order of computation on every target.
    fn factors<T: Real>(&self, q: &Joints<T, N>) -> Factors<T>;
}

impl<A: InverseKinematics<6>> Factored<6> for A
where
    A::Branch: Ends<A>,
{
    fn factors<T: Real>(&self, q: &Joints<T, 6>) -> Factors<T> {
        A::Branch::factors(self, q)
    }
}

/// From which of its ends an arm of six joints is solved, by the labels of its solutions.
pub trait Ends<A> {
    /// The factors at `q`.
    fn factors<T: Real>(arm: &A, q: &Joints<T, 6>) -> Factors<T>;
}

impl<A: SolveWrist<6>> Ends<A> for Posture {
    fn factors<T: Real>(arm: &A, q: &Joints<T, 6>) -> Factors<T> {
        let [one, two, three, four, five, six] =
            by_rows(&arm.jacobian(q), |row| SolveWrist::command(arm, row));
        let [j1, j2, j3, ..] = A::JOINTS;
        let velocities = [one, two, three].map(at(to_tool([four, five, six])));
        let of_base = carried(arm, [j1, j2, j3], velocities, two.1, &SolveWrist::base::<f64>(arm));
        Factors { wrist: Some(pose::dot(&four.1, &cross(five.1, six.1))), ..of_base }
    }
}

impl<A: SolveShoulder<6>> Ends<A> for ShoulderPosture {
    fn factors<T: Real>(arm: &A, q: &Joints<T, 6>) -> Factors<T> {
        let [one, two, three, four, five, six] =
            by_rows(&arm.jacobian(q), |row| SolveShoulder::command(arm, row));
        let [.., j4, j5, j6] = A::JOINTS;
        let velocities = [six, five, four].map(at(to_tool([one, two, three])));
        let of_base = carried(arm, [j6, j5, j4], velocities, five.1, &SolveShoulder::base::<f64>(arm));
        let bend = Some(pose::dot(&one.1, &cross(two.1, three.1)));
        Factors { shoulder: None, hand: of_base.shoulder, bend, ..of_base }
    }
}

impl<A: SolvePosition<3>> Factored<3> for A {
    fn factors<T: Real>(&self, q: &Joints<T, 3>) -> Factors<T> {
        let columns = by_rows(&self.jacobian(q), |row| self.command(row));
        let [_, (_, second), _] = columns;
        carried(self, A::JOINTS, columns.map(|(linear, _)| linear), second, &self.base::<f64>())
    }
}

/// The linear and the angular part of a column.
type Column<T> = ([T; 3], [T; 3]);

/// The columns of a Jacobian with respect to row values.
fn by_rows<T: Real, const N: usize>(
    jacobian: &Jacobian<T, N>,
    command: impl Fn([T; N]) -> [T; N],
) -> [Column<T>; N] {
    let (zero, columns) = (T::lit(0.0), jacobian.data.0);
    let mut rows = [([zero; 3], [zero; 3]); N];
    for (index, row) in rows.iter_mut().enumerate() {
        let mut unit = [zero; N];
        if let Some(one) = unit.get_mut(index) {
            *one = T::lit(1.0);
        }
        for ([vx, vy, vz, wx, wy, wz], part) in columns.into_iter().zip(command(unit)) {
            row.0 = plus(row.0, [vx, vy, vz].map(|x| x * part));
            row.1 = plus(row.1, [wx, wy, wz].map(|x| x * part));
        }
    }
    rows
}

/// The velocity of the point from which the tool point is d away.
fn at<T: Real>(offset: [T; 3]) -> impl Fn(Column<T>) -> [T; 3] {
    move |(linear, angular)| less(linear, cross(angular, offset))
}

/// From the point where three axes meet to the tool point: d with vᵢ = zᵢ × d for each of their columns, so that the sum of
/// d - zᵢ(zᵢ·d) is that of vᵢ × zᵢ. Two of the axes never have the same direction: the matrix of that has an inverse.
fn to_tool<T: Real>(meeting: [Column<T>; 3]) -> [T; 3] {
    let zero = T::lit(0.0);
    let (mut m, mut right) = ([[zero; 3]; 3], [zero; 3]);
    for (v, z) in meeting {
        right = plus(right, cross(v, z));
        let size = pose::dot(&z, &z);
        let [x, y, w] = z;
        let [mx, my, mz] = m;
        m = [
            plus(mx, less([size, zero, zero], z.map(|e| e * x))),
            plus(my, less([zero, size, zero], z.map(|e| e * y))),
            plus(mz, less([zero, zero, size], z.map(|e| e * w))),
        ];
    }
    let [a, b, c] = m;
    let volume = pose::dot(&a, &cross(b, c));
    [cross(b, c), cross(c, a), cross(a, b)]
        .into_iter()
        .zip(right)
        .fold([zero; 3], |sum, (side, x)| plus(sum, side.map(|e| e * x / volume)))
}

/// The factors of three joints that carry a point, from the velocities that they give to it; `axis` is that of the second.
fn carried<T: Real, const N: usize, A: Arm<N>>(
    arm: &A,
    joints: [Joint; 3],
    mut velocities: [[T; 3]; 3],
    axis: [T; 3],
    base: &Base<f64>,
) -> Factors<T> {
    let reach = T::lit(arm.reach());
    for (velocity, joint) in velocities.iter_mut().zip(joints) {
        if joint.kind == JointKind::Revolute {
            *velocity = velocity.map(|x| x / reach);
        }
    }
    let [first, second, third] = velocities;
    let area = cross(second, third);
    let whole = Factors {
        base: pose::dot(&first, &area),
        shoulder: None,
        elbow: None,
        wrist: None,
        hand: None,
        bend: None,
    };
    match base {
        Base::Elbow(_) | Base::Telescope(_) => {
            let (shoulder, elbow) = (pose::dot(&first, &axis), pose::dot(&axis, &area));
            Factors { base: shoulder * elbow, shoulder: Some(shoulder), elbow: Some(elbow), ..whole }
        }
        Base::General(_) => whole,
    }
}

fn plus<T: Real>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a + x, b + y, c + z]
}

fn less<T: Real>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [a - x, b - y, c - z]
}

fn cross<T: Real>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
