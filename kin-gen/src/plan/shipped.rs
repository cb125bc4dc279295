//! The plans that ship with this crate.
//!
//! A plan depends on a shape only, and the shapes of real arms are few. `plans.txt` holds the plans of all common ones,
//! and for each grouping of joints one of a shape with every length: a shape that is not there takes the plan of one
//! that has more lengths, with zeros for those it lacks. `cargo run --release -p tests --bin plans` makes the file.
//!
//! ```text
//! [1234 jacobian d. dxx d. . .]     the number of bytes up to the next header, what is wanted, the shape
//! x4y=s1*c4                         see `recipe`
//! ```

use super::routes::Wanted;
use super::shape::{Group, Shape};

/// The plans.
const PLANS: &str = include_str!("plans.txt");

/// A plan as it ships.
#[derive(Clone, Copy, Debug)]
pub struct Shipped {
    /// What is wanted, as a word.
    pub wanted: &'static str,
    /// For which shape.
    pub shape: &'static str,
    /// How, for [`super::recipe::Recipe::parse`].
    pub text: &'static str,
}

/// All of them, in the order of the file.
pub fn all() -> impl Iterator<Item = Shipped> {
    let mut rest = PLANS;
    std::iter::from_fn(move || {
        let (header, behind) = rest.strip_prefix('[')?.split_once("]\n")?;
        let (length, header) = header.split_once(' ')?;
        let (wanted, shape) = header.split_once(' ')?;
        let length = length.parse().ok()?;
        rest = behind.get(length..)?;
        Some(Shipped { wanted, shape, text: behind.get(..length)? })
    })
}

/// A plan as an entry of the file.
pub fn entry(wanted: Wanted, shape: &Shape, text: &str) -> String {
    format!("[{} {} {shape}]\n{text}", text.len(), wanted.word())
}

/// The plan of a shape, and whether it is this shape's own: else it is that of the smallest shape with more lengths.
pub fn find(wanted: Wanted, shape: &Shape) -> Option<(Shipped, bool)> {
    let (word, name) = (wanted.word(), shape.to_string());
    let of_kind = || all().filter(|plan| plan.wanted == word);
    if let Some(own) = of_kind().find(|plan| plan.shape == name) {
        return Some((own, true));
    }
    let excess = |plan: Shipped| {
        let larger = Shape::parse(plan.shape)?;
        (larger.slides == shape.slides && covers(&larger, shape)).then(|| (lengths(&larger), plan))
    };
    let (_, plan) = of_kind().filter_map(excess).min_by_key(|(lengths, _)| *lengths)?;
    Some((plan, false))
}

/// Whether the first has the same joints as the second and at least its lengths.
fn covers(larger: &Shape, shape: &Shape) -> bool {
    let covered = |(large, small): (&Group, &Group)| {
        let links = large.links.iter().zip(&small.links);
        (large.d || !small.d)
            && large.links.len() == small.links.len()
            && links.clone().all(|(large, small)| (large.x || !small.x) && (large.y || !small.y))
    };
    larger.groups.len() == shape.groups.len() && larger.groups.iter().zip(&shape.groups).all(covered)
}

fn lengths(shape: &Shape) -> usize {
    let of = |group: &Group| {
        usize::from(group.d) + group.links.iter().map(|l| usize::from(l.x) + usize::from(l.y)).sum::<usize>()
    };
    shape.groups.iter().map(of).sum()
}
