//! Answers in sentences, for terminals and pages alike.

mod change;
mod degree;
mod mesh;

pub use change::{lift_counts, limit, suggestion};
pub use degree::{certificate, degree, triangle_count};
pub use mesh::{higher_degree, standing};
