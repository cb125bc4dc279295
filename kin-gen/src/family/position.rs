//! Arms with two or three joints, solved for the position of the tool point, and for a pose where they reach it.

use super::base;
use super::home::Home;
use super::pair;
use super::short::{self, Carrier, Short};
use super::{Inverse, Refusal};

/// What the position solver needs.
#[derive(Clone, Debug)]
pub struct Position {
    /// The joints, carrying the tool point.
    pub carrier: Carrier,
    /// What the solver of poses needs.
    pub pose: Option<Short>,
}

/// Recognises an arm all of whose joints are needed to move the tool point.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    home.require_fixed_directions()?;
    let tip = home.tip.position.clone();
    let carrier = match home.axes.len() {
        3 => Carrier::Three(Box::new(base::recognise(home, &tip)?)),
        _ => Carrier::Two(Box::new(pair::recognise(home, &tip)?)),
    };
    let pose = short::short(home).ok();
    Ok(Inverse::Position(Box::new(Position { carrier, pose })))
}
