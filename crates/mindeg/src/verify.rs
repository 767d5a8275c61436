//! Whether any mesh is a triangulation of a domain, and whether its maximum degree is the least.
//!
//! [`triangulation`] matches the vertices of a mesh, from any program and in any order, to the boundary
//! points of a domain, and checks its triangles. [`optimality`] checks the proof of the least maximum
//! degree. Both decide by checkers that share no code with what makes meshes and proofs:
//! [`mindeg_mesh::check`], [`mindeg_exact::check`], [`mindeg_core::verify()`] and
//! [`Certificate::check`](mindeg_core::Certificate::check).
//!
//! ```
//! use mindeg::verify::{self, Optimality};
//! use mindeg::{Domain, Progress, Side, TriMesh, glam::DVec3};
//!
//! let domain = Domain::rectangle(2.0, 1.0, [2, 1, 1, 1].map(Side::count).into())?;
//! let points = [(0.0, 1.0), (1.0, 0.0), (2.0, 1.0), (0.0, 0.0), (2.0, 0.0)];
//! let points = points.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
//! let mesh = TriMesh::new(points, vec![[3, 1, 0], [1, 2, 0], [1, 4, 2]])?;
//! let verified = verify::triangulation(&mesh, &domain, None)?;
//! assert_eq!((verified.max_degree, verified.interior_points), (4, 0));
//! assert_eq!(verified.vertex_of, [3, 1, 4, 2, 0]);
//! let optimality = verify::optimality(&verified, &domain, Progress::NONE)?;
//! assert!(matches!(optimality, Optimality::Optimal { .. }));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`surface()`] compares a remesh with the part that it was made from.
//!
//! Limits: a mesh of a domain lies in the plane of x and y, or on the floor, the plane of x and z.

mod defect;
mod degrees;
mod fault;
mod joint;
mod map;
mod matching;
mod near;
mod optimality;
mod parts;
mod proof;
mod rules;
mod sides;
mod surface;
mod together;
mod triangulation;

pub use defect::MeshDefect;
pub use degrees::ProvenDegree;
pub use matching::{DEFAULT_TOLERANCE, MatchedPlane, VerifiedMesh};
pub use optimality::{Optimality, checked_proof, optimality, optimality_by};
pub use parts::triangulations;
pub use proof::Proof;
pub use rules::SurfaceRules;
pub use surface::{VerifiedSurface, surface};
pub use triangulation::triangulation;
