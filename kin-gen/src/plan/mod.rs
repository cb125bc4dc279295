//! Choosing the cheapest of all exactly equal derivations.
//!
//! ```text
//! Frames ─► gauge ─► Shape ─► routes ─► Graph ─► search ─► Solution ─► recipe ─► plans.txt     once, by a command
//!                      └────────────── shipped ◄──────────────────────────────────────┘
//!                                         └─► replay over the arm's own numbers ─► terms     for each arm
//! ```
//!
//! A vector can be brought to the world by many exactly equal ways, and which of them is the cheapest depends on what
//! else is wanted: the columns of one rotation serve the next, a product needed for the pose is there for the Jacobian.
//! [`routes`] writes down all ways for one structure, [`search`] picks the smallest set of values that is closed under the
//! ways picked. This takes a second or two for six joints and ten for seven, far too long for a macro, but depends on nothing
//! but the structure, so plans ship with this crate. Nothing is believed: what comes of a plan is proved like
//! everything else.
//!
//! * [`shape`], [`gauge`]: what a plan depends on, and how the frames of an arm are brought into that form
//! * [`graph`], [`routes`]: values, and all ways to compute them
//! * [`random`], [`search`]: the cheapest closed set
//! * [`recipe`], [`shipped`]: plans as text
//! * [`replay`]: a plan carried out for one arm

pub mod gauge;
pub mod graph;
pub mod random;
pub mod recipe;
pub mod replay;
pub mod routes;
pub mod search;
pub mod shape;
pub mod shipped;

pub use gauge::fit;
pub use replay::{Planned, planned, planned_turn};
pub use routes::{WANTED, Wanted};

use recipe::Writer;
use routes::Routes;
use search::Space;
use shape::Shape;

/// How often the search begins anew: with seven joints it is stuck more often, by a tenth of the operations.
fn runs(shape: &Shape) -> u64 {
    if shape.joints().count() > 6 { 16 } else { 4 }
}

/// How many moves a run has: for a large graph more of them for each value.
fn moves(values: usize) -> u32 {
    u32::try_from(100 * values + values * values / 25).unwrap_or(u32::MAX)
}

/// Makes the plan of a shape, as text. Takes a second for six joints, ten for seven.
pub fn make(shape: &Shape, wanted: Wanted) -> Option<String> {
    make_with(shape, wanted, runs(shape), moves)
}

/// The same with another effort: so many runs, and a number of moves for a number of values; `None` without any run.
pub fn make_with(shape: &Shape, wanted: Wanted, runs: u64, moves: impl Fn(usize) -> u32) -> Option<String> {
    let routes = Routes::of(shape, wanted);
    let space = Space::new(&routes.graph, routes.outputs.iter().map(|o| o.id));
    let best = space.search(0..runs, moves(routes.graph.count()))?;
    Some(Writer::new(&routes.graph, &space, &best).write(&routes.outputs))
}
