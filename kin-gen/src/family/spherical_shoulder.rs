//! Arms with six joints whose first three axes meet: a spherical wrist's arm, seen from its tool.
//!
//! Nothing but the sense of every motion changes when an arm is looked at from its other end. The last three joints carry
//! the centre of the shoulder as a base carries a wrist centre, joint 6 first; the shoulder turns the tool by what rotation
//! remains. No arm is both: a wrist centre carried by a shoulder alone moves on a sphere.

use super::base::{self, Base};
use super::home::Home;
use super::wrist::{Triple, Wrist};
use super::{Inverse, Refusal};
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};

/// What the spherical-shoulder solver needs.
#[derive(Clone, Debug)]
pub struct SphericalShoulder {
    /// Joints 6, 5 and 4, carrying the centre of the shoulder. Its frame stands in that of the tool.
    pub base: Base,
    /// Joints 1, 2 and 3: read from the rotation between the first row's frame and frame 3.
    pub shoulder: Wrist,
    /// The centre of the shoulder in the world.
    pub centre: V3<Poly>,
    /// From the tool's orientation back to frame 6: ⁰R₆ = R·this.
    pub tool_to_frame6: M3<Poly>,
}

/// Recognises the family.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    home.require_fixed_directions()?;
    let triple = Triple { first: 0, name: "shoulder" };
    let centre = triple.centre(home)?;
    let base = home.seen_from_tool(|home| base::recognise(home, &centre)).map_err(|refusal| Refusal {
        reason: format!("seen from the tool, {}", refusal.reason),
        ..refusal
    })?;
    let (frame3, frame6) = (home.frames[2].rotation.clone(), home.frames[5].rotation.clone());
    let start = vector::identity(&home.ring);
    let shoulder = triple.angles(home, &start, &frame3);
    let (tip, world) = (home.tip.clone(), home.base.clone());
    let tool_to_frame6 = vector::product(&mut home.ring, &vector::transpose(&tip.rotation), &frame6);
    let turned = vector::apply(&mut home.ring, &world.rotation, &centre);
    let centre = vector::add(&mut home.ring, &world.position, &turned);
    Ok(Inverse::Shoulder(Box::new(SphericalShoulder { base, shoulder, centre, tool_to_frame6 })))
}
