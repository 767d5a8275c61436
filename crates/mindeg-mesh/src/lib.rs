//! Any triangle mesh: its definition, its connectivity, and the quality of its triangles.
//!
//! [`Positions`] and [`Triangles`] together are a mesh, whether it is a formula or a list; a
//! [`TriMesh`] is a list, for example from a reader. [`quality`] measures triangles by Verdict's
//! definitions, [`inspection`] counts and names the contents and the defects of a mesh,
//! [`ear_clipping`] cuts polygons into triangles, [`check`] decides whether triangles triangulate
//! given rings.
//!
//! ```
//! use glam::DVec3;
//! use mindeg_mesh::TriMesh;
//! use mindeg_mesh::inspection::{Inspection, InspectionOptions};
//!
//! let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
//! let mesh = TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?;
//! let inspection = Inspection::of(&mesh, &InspectionOptions::default());
//! assert_eq!((inspection.max_degree(), inspection.quality.area), (3, 1.0));
//! # Ok::<(), mindeg_mesh::TriMeshError>(())
//! ```
//!
//! Vertices, triangles and groups count from 0. Triangles are counter-clockwise seen from their
//! front. Coordinates are f64 in the user's unit of length. Transcendental functions come from
//! `libm`, so the same input gives the same bits on every machine.

mod bounds;
mod box_tree;
mod by_name;
pub mod check;
mod connectivity;
pub mod crossing;
pub mod distance;
pub mod ear_clipping;
mod edges;
pub mod inspection;
mod mesh;
mod normals;
mod numbers;
pub mod parallel;
pub mod planar;
mod polygons;
mod progress;
pub mod quality;
mod random;
mod summary;
mod tri_mesh;
mod welding;
mod worst;
mod written;

pub use bounds::Bounds;
pub use box_tree::BoxTree;
pub use by_name::ByName;
pub use connectivity::boundary::BoundaryLoop;
pub use connectivity::disjoint_sets::DisjointSets;
pub use edges::{edges_of, sorted};
pub use mesh::{
    Group, Line, LineKind, Material, Mesh, NamedVertex, PeriodicLine, Positions, Triangles, filled,
};
pub use normals::vertex_normals;
pub use numbers::{coordinate, listed, number, percent, place, significant, steady_angle};
pub use polygons::{NonTriangles, Polygons};
pub use progress::{Cancelled, Counter, Progress, Step};
pub use random::Random;
pub use tri_mesh::{TriMesh, TriMeshError};
pub use welding::weld;
pub use written::Written;
