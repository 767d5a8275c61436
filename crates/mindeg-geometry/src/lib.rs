//! Convex domains, where their boundary points lie, and how good the meshes on them are.
//!
//! The crate `mindeg-core` triangulates a convex polygon from interval counts alone. Here the
//! counts get a shape: a [`Domain`] is a rectangle or a convex polygon whose sides are divided
//! by [`Spacing`] laws, a [`Mesh`] its triangulation of least maximum degree on the actual
//! points, and [`quality`] says what its triangles are worth.
//!
//! ```
//! use mindeg_geometry::{Domain, Mesh};
//!
//! let domain = Domain::from_json(
//!     r#"{"rectangle": {"width": 4, "height": 3}, "sides": [
//!         {"intervals": 12}, {"intervals": 9}, {"intervals": 4}, {"intervals": 4}]}"#,
//! )?;
//! let mesh = Mesh::least_degree(&domain)?;
//! assert_eq!(mesh.max_degree(), 5);
//! for (vertex, point) in mesh.points().enumerate() {
//!     println!("{vertex} {} {}", point.x, point.y);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Vertices, sides and triangles are numbered as in the core: from 0, counter-clockwise, vertex 0
//! at the first corner. y points up. Points are formulas like the triangles, so nothing here
//! grows with the number of vertices unless a function says so.
//!
//! # Numbers
//!
//! Everything is f64. Transcendental functions come from the `libm` crate, so that the same input
//! gives the same bits on every machine.
//!
//! # Limits
//!
//! Convex outlines with straight sides, in the plane. Triangles use boundary points only, so a
//! boundary that is dense against the width of its domain has thin triangles, whatever the plan.

pub mod export;
pub mod import;
mod mesh;

pub use mesh::{AngleRange, DegreeHistograms, Mesh, MeshError};
pub use mindeg_domain::*;
pub use mindeg_mesh::{Bounds, Progress, Watch, inspection, quality, unwatched};

/// The README's example is compiled with the others.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
