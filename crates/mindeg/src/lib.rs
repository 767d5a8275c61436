//! Meshes of a domain from its boundary points alone, with the least possible maximum degree.
//!
//! A [`Domain`] and a goal go in, a [`BoundaryMesh`] comes out: of least degree by a formula, at any
//! size, or with the largest minimum angle under a degree limit, by an exact search.
//!
//! ```
//! use mindeg::{BoundaryMesh, Domain};
//!
//! let domain = Domain::from_json(
//!     r#"{"rectangle": {"width": 4, "height": 3}, "sides": [
//!         {"intervals": 12}, {"intervals": 9}, {"intervals": 4}, {"intervals": 4}]}"#,
//! )?;
//! let mesh = BoundaryMesh::least_degree(&domain)?;
//! assert_eq!(mesh.max_degree(), 5);
//! for (vertex, point) in mesh.points().enumerate() {
//!     println!("{vertex} {} {}", point.x, point.y);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Vertices, sides and triangles count from 0; vertices and sides run counter-clockwise, vertex 0
//! is the first corner; triangles are counter-clockwise and y points up. Everything is f64, and
//! transcendental functions come from `libm`: the same input gives the same bits on every machine.
//!
//! # Limits
//!
//! Convex outlines with straight sides, in the plane. Triangles use boundary points only, so a
//! boundary that is dense against the width of its domain has thin triangles, whatever the mesh.

mod boundary_mesh;
pub mod exact;
mod goal;
mod keep_angle;

pub use boundary_mesh::{AngleRange, BoundaryMesh, DegreeHistograms, MeshError};
pub use glam;
pub use goal::{FoundBy, Goal, HigherDegree, Meshed, mesh};
pub use mindeg_domain::*;
pub use mindeg_mesh::{
    Bounds, Cancelled, Group, Line, Mesh, Positions, Progress, Step, TriMesh, TriMeshError,
    Triangles, inspection, quality,
};

/// The README's example is compiled with the others.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
