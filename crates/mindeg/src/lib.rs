//! Triangle meshes of domains, models and surfaces whose boundary stays as it is, with proven degrees and angles.
//!
//! For a solver, take [`interior::mesh`]: points inside bring large angles. For a patch that must keep its points, a [`Domain`]
//! and a [`Goal`] go in, and a mesh of its boundary points comes out: with the largest minimum angle under a degree limit, or of
//! the least maximum degree, which alone makes no good mesh.
//!
//! ```
//! use mindeg::{Domain, Goal, Progress, mesh};
//!
//! let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
//! let hole = [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0]];
//! let domain = Domain::from_rings([outline, hole])?;
//! let mesh = mesh(&domain, Goal::LeastDegree, Progress::NONE)?.mesh;
//! assert_eq!((mesh.max_degree(), mesh.vertex_count()), (4, 8));
//! for (vertex, point) in mesh.points().enumerate() {
//!     println!("{vertex} {} {}", point.x, point.y);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | for | call |
//! |---|---|
//! | a mesh with points inside | [`interior::mesh`]; [`interior::improve`] for a mesh of any program |
//! | all degrees and their largest angles | [`exact::trade_off`] |
//! | the faces of a model together | [`model::mesh_model`] |
//! | a surface meshed anew, closed or joined | [`remesh`], [`fill`], [`bridge`], [`stitch`], [`repair`] |
//! | a check of any mesh by code of its own | [`verify`] |
//! | files | the crates `mindeg-formats` (meshes) and `mindeg-outlines` (domains of other programs) |
//!
//! Vertices, sides and triangles have indices from 0; vertices and sides run counter-clockwise, vertex 0
//! is the first corner; triangles are counter-clockwise and y points up. Everything is f64, and
//! transcendental functions come from `libm`: the same input gives the same bits on every machine.
//!
//! # Features
//!
//! All are on by default.
//!
//! | feature | what it adds |
//! |---|---|
//! | `interior` | `interior`: meshes with interior points, and improving planar meshes |
//! | `json` | `Domain::from_json`, and the JSON Schema of domains and models |
//! | `parallel` | work shared among rayon's threads, with the same results |
//!
//! # Limits
//!
//! Without points inside, a boundary that is dense against the width of its domain has thin triangles, whatever the mesh. The formula
//! takes convex domains, of any size. On other domains the solver finds the least maximum degree with
//! its proof; where too many vertices see each other, it states the gap.

pub mod beside;
mod boundary_mesh;
pub mod bridge;
pub mod changes;
mod conflict;
mod degree;
mod degree_first;
mod error;
pub mod exact;
pub mod fill;
mod goal;
#[cfg(feature = "interior")]
pub mod interior;
mod keep_angle;
mod loops;
mod map;
mod meshed;
pub mod model;
mod points_inside;
mod posed;
mod regions;
#[cfg(feature = "interior")]
pub mod remesh;
pub mod repair;
mod searched;
#[cfg(feature = "interior")]
pub mod stitch;
mod trade_off;
pub mod verify;
mod windowed;

pub use boundary_mesh::{AngleRange, BoundaryMesh};
pub use error::MeshError;
pub use glam;
pub use goal::{GOALS, Goal, GoalKind, GoalValue, Optimized, is_by_formula, mesh};
pub use loops::{LoopDefect, Loops, MeshLoop};
pub use meshed::{FoundBy, Meshed};
pub use mindeg_domain::*;
pub use mindeg_mesh::{
    Bounds, Cancelled, Group, Line, Material, Mesh, Positions, Progress, Step, TriMesh,
    TriMeshError, Triangles, inspection, quality,
};

/// The README's example is compiled with the others.
#[cfg(all(doctest, feature = "json"))]
#[doc = include_str!("../../../README.md")]
struct Readme;
