//! Answers in sentences, for terminals and pages alike.

mod change;
mod degree;
mod interior;
mod mesh;
mod trade_off;

pub use change::{lift_counts, limit, suggestion};
pub use degree::{certificate, degree, triangle_count};
pub use interior::angles_and_degrees;
pub use mesh::{higher_degree, mesh, standing};
pub use trade_off::{knee, trade_off};
