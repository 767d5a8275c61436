//! Other triangulations of the same boundary points.

pub mod reference;

pub use reference::{NoTriangulation, Reference, Timed, tie_count};
