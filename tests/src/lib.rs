//! Oracles: what the tests judge with.
//!
//! Nothing in here calls what it judges. Poses come from a plain product of 4×4 matrices, Jacobians from the same
//! product in dual numbers, both straight from the rows of `data/arms.json`, whose strings are evaluated here as well.
//! The scores of inverse solutions count as the reference's own scorer does. [`measured`] and [`structures`] judge
//! nothing: they say which arms are counted and which structures get plans; [`skew`] is an arm.
//!
//! ```text
//! data/*.json ► reference ► product (f64, dual) ► pose, Jacobian, reach
//!                    │
//!                    ├► score: solutions against the listed ones
//!                    └► dh: the same table as `.dh` text, for arms that `robots` does not declare
//! ```

pub mod bits;
pub mod declared;
pub mod dh;
pub mod dual;
pub mod expression;
pub mod interpreted;
pub mod invented;
pub mod markup;
pub mod measured;
pub mod mirrored;
pub mod motion;
pub mod polynomial;
pub mod pose;
pub mod product;
pub mod reference;
pub mod reliability;
pub mod sample;
pub mod score;
pub mod seeds;
pub mod skew;
pub mod structures;
pub mod trig;

/// The README's program, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
