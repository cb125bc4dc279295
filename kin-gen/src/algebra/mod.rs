//! Exact algebra: the ring in which equality is decided, and the graph in which code is built.
//!
//! * [`ring`]: polynomials over the integers in lengths, constant pairs and one (cos, sin) pair for each joint.
//!   Equal normal forms are equal functions. `arithmetic` is what is done with them.
//! * [`expr`]: hash-consed expressions; every simplification is a constructor there.
//! * [`vector`]: three-vectors and matrices of either.
//! * [`frame`]: the frames of a chain, joints with parallel axes fused before they become sines.

mod arithmetic;
mod content;
pub mod expr;
pub mod frame;
mod monomial;
mod poly;
pub mod ring;
mod show;
#[cfg(test)]
mod tests;
mod turn;
pub mod vector;

pub use show::Part;
