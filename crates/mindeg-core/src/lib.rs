//! The triangulation of a convex polygon's boundary points with the least possible maximum
//! degree, as a formula.
#![no_std]

extern crate alloc;

mod boundary;

pub use boundary::{Boundary, BoundaryError, MAX_VERTICES};
