//! Arms with six joints whose last three axes meet, on a three-joint base.
//!
//! The wrist centre is carried by the first three joints alone, so position and orientation separate (Pieper 1968):
//! the base is solved for the wrist centre, the wrist for what rotation remains.

use super::base::{self, Base};
use super::home::Home;
use super::wrist::{Triple, Wrist};
use super::{Inverse, Refusal};
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};

/// What the spherical-wrist solver needs.
#[derive(Clone, Debug)]
pub struct SphericalWrist {
    /// The base, carrying the wrist centre.
    pub base: Base,
    /// The wrist.
    pub wrist: Wrist,
    /// The wrist centre in frame 3.
    pub centre_in_frame3: V3<Poly>,
    /// The wrist centre in the tool's frame.
    pub centre_in_tool: V3<Poly>,
    /// From the tool's orientation back to frame 6: ⁰R₆ = R·this.
    pub tool_to_frame6: M3<Poly>,
}

/// Recognises the family.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    home.require_fixed_directions()?;
    let triple = Triple { first: 3, name: "wrist" };
    let centre = triple.centre(home)?;
    let base = base::recognise(home, &centre)?;
    let (frame3, frame6) = (home.frames[2].rotation.clone(), home.frames[5].rotation.clone());
    let wrist = triple.angles(home, &frame3, &frame6);
    let centre_in_frame3 = seen_from(home, &centre, 2);
    let tip = home.tip.clone();
    let from_tip = vector::sub(&mut home.ring, &centre, &tip.position);
    let centre_in_tool = vector::apply(&mut home.ring, &vector::transpose(&tip.rotation), &from_tip);
    // Behind joint 6 nothing moves: what lies between the tool and frame 6 is the same in every position.
    let tool_to_frame6 = vector::product(&mut home.ring, &vector::transpose(&tip.rotation), &frame6);
    Ok(Inverse::Pose(Box::new(SphericalWrist {
        base,
        wrist,
        centre_in_frame3,
        centre_in_tool,
        tool_to_frame6,
    })))
}

/// A point in the coordinates of one joint's frame.
fn seen_from(home: &mut Home<'_>, point: &V3<Poly>, joint: usize) -> V3<Poly> {
    let frame = home.frames[joint].clone();
    let offset = vector::sub(&mut home.ring, point, &frame.position);
    vector::apply(&mut home.ring, &vector::transpose(&frame.rotation), &offset)
}
