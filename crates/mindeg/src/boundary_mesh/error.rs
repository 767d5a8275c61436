//! Why a domain has no mesh.

use mindeg_mesh::Cancelled;
use mindeg_mesh::check::CheckError;
use mindeg_mesh::planar::BoundaryFaults;

/// Why a domain has no mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// Every candidate tried has a triangle that is not counter-clockwise once its points are
    /// rounded to f64.
    #[error(
        "triangle {triangle:?} is so thin that it has no area at the precision of its \
         coordinates; use fewer intervals or gentler spacing laws, or move the domain towards the \
         origin"
    )]
    NoArea {
        /// The vertices of a flat triangle.
        triangle: [u32; 3],
    },
    /// The domain [is constrained](mindeg_domain::Domain::is_constrained), which formulas ignore.
    #[error(
        "the domain has constraints on its degrees, which take the exact solver; leave out \
         outside_degree and max_degree for a mesh of least degree"
    )]
    Constrained,
    /// The domain is not convex, or has holes, and the formula takes neither.
    #[error(
        "the domain is not convex or has holes, which the formula does not take; use the solver"
    )]
    NotConvex,
    /// Rounding has moved points of the boundary onto or past each other.
    #[error("once its points are rounded to f64, the boundary is not simple: {0}")]
    Boundary(#[from] BoundaryFaults),
    /// The [`Progress`](mindeg_mesh::Progress) callback has cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The triangles given do not triangulate the domain's boundary.
    #[error("the triangles are no mesh of the domain: {0}")]
    Triangles(#[from] CheckError),
    /// The vertices of a triangle are all on one straight side, or on several that follow each other
    /// without a turn.
    #[error("the triangles are no mesh of the domain: triangle {triangle:?} is flat")]
    Flat {
        /// Its vertices.
        triangle: [u32; 3],
    },
}
