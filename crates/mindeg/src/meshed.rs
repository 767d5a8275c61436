//! A mesh with how it was found, so that what is proven of it can be told.
//!
//! Limits: the figures are those that were worked out on the way to the mesh.

use crate::boundary_mesh::BoundaryMesh;

/// How a mesh was found, and so what is proven of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundBy {
    /// The formula: its maximum degree is the least possible; of the candidates that were tried, it
    /// has the largest minimum angle.
    Formula,
    /// The search: its minimum angle is the largest possible within its degree limit, and for
    /// [`Goal::KeepAngle`](crate::Goal::KeepAngle) no smaller limit keeps the share.
    Search,
    /// Windows: it has at least this share of Delaunay's minimum angle; its maximum degree is an
    /// upper bound.
    Windows {
        /// The share, 0 to 1.
        share: f64,
    },
    /// The search for the least degree alone: a larger minimum angle may be possible with it.
    Exhaustive,
    /// A zig-zag, the only kind of mesh of degree 4: a larger minimum angle may be possible with it.
    ZigZag,
}

/// A mesh, and the degrees and angles to compare it with.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// The mesh.
    pub mesh: BoundaryMesh,
    /// The least maximum total degree that any mesh of the domain has, if that is proven; else no mesh
    /// has less.
    pub least_max_degree: u32,
    /// Whether some mesh is known to have this degree.
    pub is_least_proven: bool,
    /// How it was found.
    pub found_by: FoundBy,
    /// The minimum angle of a Delaunay triangulation, in degrees, if that was worked out.
    pub delaunay_min_angle: Option<f64>,
}

impl Meshed {
    /// The same mesh with what another work on the domain says of the least degree and of Delaunay's angle.
    pub(crate) fn with_bound_of(self, other: &Self) -> Self {
        let least_max_degree = self.least_max_degree.max(other.least_max_degree);
        let is_known = |meshed: &Self| {
            meshed.is_least_proven && meshed.least_max_degree == least_max_degree
                || meshed.mesh.max_total_degree() == least_max_degree
        };
        let delaunay_min_angle = self.delaunay_min_angle.or(other.delaunay_min_angle);
        let is_least_proven = is_known(&self) || is_known(other);
        Self { is_least_proven, least_max_degree, delaunay_min_angle, ..self }
    }
}
