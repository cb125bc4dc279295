//! Two joints of any kind that carry a point: their axes as lines.

use super::Refusal;
use super::general::{self, Axis, Posed};
use super::home::Home;
use crate::algebra::ring::Poly;
use crate::algebra::vector::{M3, V3};
use crate::quantity::{Linear, Quantity};

/// Two joints and the point they carry.
#[derive(Clone, Debug)]
pub struct Pair {
    /// The orientation of the first row's frame in the world, by rows.
    pub axes: M3<Poly>,
    /// The origin, a point of axis 1, in the world.
    pub origin: V3<Poly>,
    /// The axes of joints 1 and 2.
    pub lines: [Axis; 2],
    /// The point at home, from the origin.
    pub carried: [Linear; 3],
    /// What is added to each row value to give the figure's.
    pub offsets: [Quantity; 2],
}

/// Recognises any two joints that move the point `carried` on a surface.
pub fn recognise(home: &mut Home<'_>, carried: &V3<Poly>) -> Result<Pair, Refusal> {
    let lines = [general::line(home, 0)?, general::line(home, 1)?];
    let point = general::from_first_axis(home, carried)?;
    if general::moves_on_a_curve(&Posed::of(&lines, &point, home.reach), home.reach) {
        return Err(Refusal::new(
            "the first two joints move the point that they carry on a curve only, whatever their values",
        ));
    }
    let offsets = [general::offset(home, 0), general::offset(home, 1)];
    let (axes, origin) = general::placed(home);
    Ok(Pair { axes, origin, lines, carried: point, offsets })
}
