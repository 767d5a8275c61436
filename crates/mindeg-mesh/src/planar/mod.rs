//! Rings of points in the plane: whether they are simple and how they nest, and where they turn.
//!
//! [`nesting`] is the one proof that rings are simple and apart, [`turn`] the one decision whether
//! a boundary is straight at a point.

mod sweep;
mod turning;

pub use sweep::{Fault, Nesting, nesting};
pub use turning::{LEAST_TURN, Turn, turn};
