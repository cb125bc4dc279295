//! Inverse kinematics: one page for each family, and what they share.
//!
//! * [`base`]: the first three joints put the wrist centre (or the tool point) in its place, by named figures (`planar`).
//! * [`general`]: any other three joints, by where two conics meet: [`conic`], `sheaf` where neither is flat, and
//!   [`quartic`] for its roots; `refine` closes what round-off has left open.
//! * [`wrist`]: the last three joints turn the tool, by look-up of the entries of ³R₆.
//! * `straight`: a wrist that round-off of the base has bent, led back to where it is straight.
//! * `rim`: an oblique wrist that the same round-off has put beyond its cone; `beyond`, where a joint of the base is all but free, what
//!   is on the other side of that.
//! * [`spherical_wrist`]: both together, for six-joint arms. Far from singular poses all branches are solved at once, by programs
//!   that know no branch: `elbow`, then `bends`, for `placements`, in a loop over those of one pose (`side`) or over the
//!   poses of a batch (`abreast`). `figure` is the angles there, which come with their sines.
//! * [`spherical_shoulder`]: the same arms seen from the other end, where the first three axes meet.
//! * [`position`]: the base alone, for three-joint arms; [`pair`], for those of two.
//! * [`short`]: poses of arms with two to five joints; `freed`, where the place of the point leaves joints free; `attempt`, what steps
//!   make of what was read.
//! * `settle`: joint values led onto a pose by small steps in all joints, where figures collapse.
//! * `sphere`: what arms with a spherical wrist and with a spherical shoulder have in common; `lines`: a base in a plane as three axes.
//! * `wave`: what a turning joint makes of a direction.
//! * [`closest`]: the nearest that a base comes to what it does not reach.
//! * [`target`]: what is asked of a pose before anything is solved, and of a solution before it is given out.
//!
//! A new family is a page here that works on a plain struct of constants, a hidden trait in [`private`](crate::private)
//! through which generated code hands over that struct, and its recognition in kin-gen.
//!
//! # Round-off
//!
//! Four windows decide, each a multiple of ε times the size of what is compared (the arm's reach, or the pose's
//! distance from the base if that is larger):
//!
//! * [`ROUND_OFF`]: a figure that closes but for this counts as just touching, and is clamped there; one that is
//!   smaller than this has collapsed, and leaves its angle free;
//! * [`FAMILY`]: a wrist bent by less than this leaves the sum or the difference of its outer angles free;
//! * [`DOUBTFUL`]: a wrist bent by less than this may do so, and where the first three joints magnify round-off a larger bend;
//! * [`ACCEPTED`]: forward kinematics of a solution must come back to the pose within this.

mod abreast;
mod attempt;
pub mod base;
mod bends;
mod beyond;
pub mod closest;
pub mod conic;
mod elbow;
mod figure;
mod freed;
pub mod general;
mod lines;
pub mod pair;
mod placements;
mod planar;
pub mod position;
pub mod quartic;
mod refine;
mod rim;
pub(crate) mod settle;
mod sheaf;
pub mod short;
mod side;
mod sphere;
pub mod spherical_shoulder;
pub mod spherical_wrist;
mod straight;
pub mod target;
mod wave;
pub mod wrist;

#[cfg(test)]
mod tests;

pub use base::{Base, ElbowBase, TelescopeBase};
pub use general::{Axis, GeneralBase};
pub use pair::PairBase;
pub use position::Carrier;
pub use short::Turns;
pub use wrist::{Wrist, WristFamily};

use crate::arm::{Joint, JointKind};
use crate::math::{self, Float};
use crate::pose::{self, Joints};
use crate::solutions::JointSet;

/// Round-off of a figure, in units of ε times the size. A pose that is exactly on the boundary comes out within 3; one
/// that misses it by a thousand times as much must not be called reachable.
pub const ROUND_OFF: f64 = 8.0;

/// The bend of a wrist whose axes 4 and 6 count as coinciding, in units of ε: the rounding of the first three joints
/// is in it. All members of the family then reach the pose within [`ACCEPTED`].
pub const FAMILY: f64 = 32.0;

/// A bend that may be round-off wherever the first three joints stand, in units of ε. Near a stretched elbow, or where the
/// shoulders meet, they magnify that of the wrist centre and a larger one may be (`straight`). Forward kinematics of the
/// family's members decides.
pub const DOUBTFUL: f64 = 64.0;

/// The largest residual of a solution that is given out, in units of ε.
pub const ACCEPTED: f64 = 64.0;

/// What joint values may miss, in units of ε, that small steps have led to a pose: what misses by more may be a compromise on a pose
/// that the arm does not reach in this way.
pub(crate) const SETTLED: f64 = 16.0;

/// A joint vector to give out: angles in (-π, π], lengths as they are.
pub(crate) fn given_out<T: Float, const N: usize>(mut q: [T; N], joints: &[Joint; N]) -> Joints<T, N> {
    for (value, joint) in q.iter_mut().zip(joints) {
        if joint.kind == JointKind::Revolute {
            *value = math::wrap(*value);
        }
    }
    pose::column(q)
}

/// The values to hold on to: one that is not finite is none.
fn finite<T: Float, const N: usize>(hold: [T; N]) -> [Option<T>; N] {
    hold.map(|value| Some(value).filter(|value| math::is_finite(*value)))
}

/// The joints whose values are lengths.
pub(crate) fn sliding<const N: usize>(joints: &[Joint; N]) -> JointSet {
    let slides = joints.iter().enumerate().filter(|(_, joint)| joint.kind == JointKind::Prismatic);
    slides.fold(JointSet::EMPTY, |set, (joint, _)| set.with(joint))
}
