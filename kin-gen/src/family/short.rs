//! Arms with two to five joints, solved for a pose: the first two or three carry a point that the others leave in its place.
//!
//! That point is the tool point where no joint is left, any point of the last axis where one is, and where two are left the point
//! in which their axes meet. A slide that comes last, parallel to the axis before it, may come before it as well.

use super::base::{self, Base};
use super::home::Home;
use super::pair::{self, Pair};
use super::wrist::{self, Triple};
use super::{Inverse, Refusal};
use crate::algebra::ring::Poly;
use crate::algebra::vector::{self, M3, V3};
use crate::chain::JointKind;
use crate::number::Real;
use crate::quantity::Quantity;

/// The joints that carry the point.
#[derive(Clone, Debug)]
pub enum Carrier {
    /// Three of them: through space.
    Three(Box<Base>),
    /// Two: on a surface.
    Two(Box<Pair>),
}

impl Carrier {
    /// The orientation, by rows, and the origin of the frame in which it is measured.
    pub fn frame(&self) -> (&M3<Poly>, &V3<Poly>) {
        match self {
            Carrier::Three(base) => (&base.axes, &base.origin),
            Carrier::Two(pair) => (&pair.axes, &pair.origin),
        }
    }
}

/// The joints that turn the tool: m = Fᵀ·R·G is Rz(a), or Rz(a)·K·Rz(b), or 1.
#[derive(Clone, Debug)]
pub struct Turns {
    /// F, by rows.
    pub before: M3<Poly>,
    /// G, by rows.
    pub after: M3<Poly>,
    /// K, where there are two.
    pub between: Option<[[Real; 3]; 3]>,
    /// What is added to each row value to give the angle in m.
    pub offsets: Vec<Quantity>,
}

/// What the solver of short arms needs.
#[derive(Clone, Debug)]
pub struct Short {
    /// The joints that carry the point.
    pub carrier: Carrier,
    /// How many they are.
    pub carriers: usize,
    /// The joints of the carrier, then those that turn the tool.
    pub order: Vec<usize>,
    /// The point in the tool's frame.
    pub point_in_tool: V3<Poly>,
    /// The joints that turn the tool.
    pub turns: Turns,
    /// From the tool's orientation back to the last frame: ⁰Rₙ = R·this.
    pub tool_to_last: M3<Poly>,
}

/// Recognises an arm that is solved for a pose alone.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    Ok(Inverse::Short(Box::new(short(home)?)))
}

/// As few turns as there can be: three joints carry the point if they move it through space, else two.
pub(super) fn short(home: &mut Home<'_>) -> Result<Short, Refusal> {
    home.require_fixed_directions()?;
    let joints = home.axes.len();
    let order = order(home);
    let mut first = None;
    for carriers in [3, 2] {
        if carriers > joints || joints - carriers > 2 {
            continue;
        }
        match with_carriers(home, carriers, &order) {
            Ok(short) => return Ok(short),
            Err(refusal) => first = first.or(Some(refusal)),
        }
    }
    Err(first.unwrap_or_else(|| Refusal::new("none of its points is carried by two or three joints alone")))
}

/// The joints in the order in which they are solved.
fn order(home: &Home<'_>) -> Vec<usize> {
    let mut order: Vec<usize> = (0..home.axes.len()).collect();
    if let [.., turn, slide] = home.axes.as_slice()
        && (turn.kind, slide.kind) == (JointKind::Revolute, JointKind::Prismatic)
        && base::parallel(&turn.numbers, &slide.numbers)
    {
        let last = order.len() - 1;
        order.swap(last - 1, last);
    }
    order
}

fn with_carriers(home: &mut Home<'_>, carriers: usize, order: &[usize]) -> Result<Short, Refusal> {
    let turning = &order[carriers..];
    if let Some(slide) = turning.iter().find(|i| home.axes[**i].kind == JointKind::Prismatic) {
        return Err(Refusal::new(format!("joint {} slides where only turns can be made up for", slide + 1)));
    }
    let point = match turning {
        [] => home.tip.position.clone(),
        [joint] => home.axes[*joint].point.clone(),
        [first, ..] => Triple { first: *first, name: "wrist" }.meeting_of_two(home)?,
    };
    let carrier = home.in_order(order, |home| match carriers {
        3 => Ok(Carrier::Three(Box::new(base::recognise(home, &point)?))),
        _ => Ok(Carrier::Two(Box::new(pair::recognise(home, &point)?))),
    })?;
    let joints = home.axes.len();
    let tip = home.tip.clone();
    let from_tip = vector::sub(&mut home.ring, &point, &tip.position);
    let back = vector::transpose(&tip.rotation);
    let point_in_tool = vector::apply(&mut home.ring, &back, &from_tip);
    let end = home.frames[joints - 1].rotation.clone();
    let tool_to_last = vector::product(&mut home.ring, &back, &end);
    let turns = turns(home, turning, &end);
    Ok(Short { carrier, carriers, order: order.to_vec(), point_in_tool, turns, tool_to_last })
}

/// Where the turns begin: the frame before the first of them, or the last one.
pub fn frame_before(order: &[usize], carriers: usize) -> usize {
    order.get(carriers).copied().unwrap_or(order.len()).saturating_sub(1)
}

fn turns(home: &mut Home<'_>, turning: &[usize], end: &M3<Poly>) -> Turns {
    let before = turning.first().copied().unwrap_or(home.axes.len()) - 1;
    let from = vector::transpose(&home.frames[before].rotation);
    let at_home = vector::product(&mut home.ring, &from, end);
    let bases: Vec<[[Real; 3]; 3]> = turning
        .iter()
        .map(|joint| {
            let direction = home.direction(*joint);
            let seen = vector::apply(&mut home.ring, &from, &direction);
            wrist::basis(&seen.map(|p| home.ring.value(&p).to_real()))
        })
        .collect();
    let one = vector::identity(&home.ring);
    let mut poly = |basis: Option<&[[Real; 3]; 3]>| {
        basis.map_or_else(|| one.clone(), |basis| wrist::numbers_to_polys(home, basis))
    };
    let (before, last) = (poly(bases.first()), poly(bases.last()));
    let after = vector::product(&mut home.ring, &vector::transpose(&at_home), &last);
    let between = match bases.as_slice() {
        [a, b] => Some(wrist::relative(a, b)),
        _ => None,
    };
    let offsets = turning.iter().map(|i| Quantity::angle(home.axes[*i].offset.clone(), &[])).collect();
    Turns { before, after, between, offsets }
}
