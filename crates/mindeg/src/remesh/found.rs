//! A remesh that was found, or why there is none.

use mindeg_interior::{RemeshError, RemeshReport};
use mindeg_mesh::distance::DistanceBound;
use mindeg_mesh::{Cancelled, TriMesh, TriMeshError, number};
use mindeg_surfaces::SurfaceError;

use crate::error::MeshError;
use crate::repair::Repairs;
use crate::verify::{MeshDefect, VerifiedSurface};

/// A mesh of a surface, and what it is like.
#[derive(Clone, Debug, PartialEq)]
pub struct RemeshedPart {
    /// The mesh. Its groups are those of the part.
    pub mesh: TriMesh,
    /// The result of the search: degrees, angles, and the corners that limit them.
    pub reached: RemeshReport,
    /// The findings of the checker.
    pub verified: VerifiedSurface,
    /// How far feature curves of the part are from those of the mesh, and back; `None` without curves.
    pub curves: Option<[DistanceBound; 2]>,
    /// The feature curves and corners of the part, and the patches between them.
    pub features: FeatureCounts,
    /// The repairs that came first, if they were wanted: the mesh is compared with the part after it.
    pub repairs: Option<Repairs>,
    /// The contents of the part that the mesh lacks, one phrase each.
    pub dropped: Vec<&'static str>,
    /// The tolerance that was asked for, with what rounding may add.
    pub(super) tolerance: Option<f64>,
}

/// The features of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeatureCounts {
    /// The curves, those of the boundary among them.
    pub curves: usize,
    /// The corners.
    pub corners: usize,
    /// The patches between curves.
    pub patches: usize,
}

impl RemeshedPart {
    /// Why the mesh may not take the place of the part: it is too far, crosses itself, or is turned over. Degrees and
    /// angles do not count.
    pub fn defects(&self) -> impl Iterator<Item = MeshDefect> + '_ {
        let defects = self.verified.defects.iter().filter(|defect| defect.kind != "degree");
        let curves = self.curves.iter().flatten();
        let farthest = curves.map(|bound| bound.upper).fold(0.0, f64::max);
        let is_far = |tolerance: &f64| farthest > *tolerance;
        let curves = self.tolerance.filter(is_far).map(|tolerance| {
            let message = format!(
                "feature curves are off by up to {}; the tolerance is {}",
                number(farthest),
                number(tolerance)
            );
            MeshDefect::new("features", message)
        });
        defects.cloned().chain(curves)
    }

    /// The farthest that any point is off, both ways, curves included: no point is farther.
    #[must_use]
    pub fn distance(&self) -> f64 {
        let VerifiedSurface { to_part, from_part, boundaries, .. } = &self.verified;
        let lines = [boundaries, &self.curves].into_iter().flatten().flatten();
        lines.chain([to_part, from_part]).map(|bound| bound.upper).fold(0.0, f64::max)
    }
}

/// Why a part was not meshed anew.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartError {
    /// The part cannot be repaired.
    #[error("the part cannot be repaired: {0}")]
    NotRepaired(MeshError),
    /// The part is no manifold surface.
    #[error("the part is no surface: {0}")]
    NoSurface(#[from] SurfaceError),
    /// A wish has no meaning.
    #[error("{0}")]
    BadOption(String),
    /// The search failed. This is a defect of mindeg.
    #[error(transparent)]
    Search(#[from] RemeshError),
    /// The result has more points than a mesh.
    #[error(transparent)]
    TooLarge(#[from] TriMeshError),
    /// The callback broke.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<MeshError> for PartError {
    fn from(error: MeshError) -> Self {
        match error {
            MeshError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => Self::NotRepaired(error),
        }
    }
}
