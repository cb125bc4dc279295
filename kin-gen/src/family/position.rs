//! Arms with three joints, solved for the position of the tool point.

use super::base::{self, Base};
use super::home::Home;
use super::{Inverse, Refusal};

/// What the position solver needs.
#[derive(Clone, Debug)]
pub struct Position {
    /// The base, carrying the tool point.
    pub base: Base,
}

/// Recognises a three-joint arm whose figure is a base.
pub fn recognise(home: &mut Home<'_>) -> Result<Inverse, Refusal> {
    home.require_fixed_directions()?;
    let tip = home.tip.position.clone();
    let base = base::recognise(home, &tip)?;
    Ok(Inverse::Position(Box::new(Position { base })))
}
