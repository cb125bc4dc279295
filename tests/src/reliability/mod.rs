//! Reliability: millions of tries, most of them where solvers fail, and what became of them.
//!
//! ```text
//! seed, part, number ► aim (joint values) ► trial (there and back) ► tally ► report
//!                                           wild (any bits)      ►
//! ```
//!
//! A try is a function of the seed, its part and its number: results do not depend on threads, on the order, or on where
//! a run was interrupted. [`run`] spreads the tries over threads and keeps what has been done in a file; `subject` makes
//! arms that are solved from a pose and arms that are solved from a position one; [`parts`] says what there is to do.

pub mod aim;
pub mod lines;
pub mod parts;
pub mod report;
pub mod run;
pub mod subject;
pub mod tally;
pub mod trial;
pub mod way;
pub mod wild;
