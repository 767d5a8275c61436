//! Interior points for a fixed boundary.
#![cfg_attr(test, allow(clippy::float_cmp))]

mod array_mesh;
mod edge_tree;
mod energy;
mod exact;
mod fixed;
mod generate;
mod goal;
mod improve;
pub mod limits;
mod near;
mod operations;
mod optimise;
mod options;
mod order;
mod outline;
mod packing;
mod report;
#[cfg(test)]
mod samples;
mod size;
mod smooth;
mod trial;
mod triangle;
mod verdict;

pub use generate::{InteriorMesh, generate};
pub use improve::{Improved, Keep, improve};
pub use options::{Fixed, InteriorError, Options, Prefer, Progress, SizeAt};
pub use outline::{Outline, OutlineError};
pub use report::{Report, Violation};
