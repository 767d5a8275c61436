//! Why a model has no mesh.

use mindeg_delaunay::DelaunayError;
use mindeg_exact::ProblemError;
use mindeg_mesh::planar::BoundaryFaults;
use mindeg_mesh::{Cancelled, TriMeshError};

use crate::goal::{GOALS, Goal, GoalKind, GoalValue};

/// Why a model has no mesh. Faces count from 0.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ModelMeshError {
    /// The goal is not for models.
    #[error("{0}")]
    Goal(String),
    /// Rounding has moved points of a face's boundary onto or past each other.
    #[error("face {face}: {source}")]
    Boundary {
        /// The face.
        face: usize,
        /// Where.
        source: BoundaryFaults,
    },
    /// A face has no Delaunay triangulation.
    #[error("face {face}: {source}")]
    Delaunay {
        /// The face.
        face: usize,
        /// Why; its vertices are those of the face.
        source: DelaunayError,
    },
    /// A triangulation of a face does not hold exactly.
    #[error("face {face}: {source}")]
    Face {
        /// The face.
        face: usize,
        /// Why; its vertices are those of the face.
        source: ProblemError,
    },
    /// A face cannot be filled with interior points.
    #[cfg(feature = "interior")]
    #[error("face {face}: {source}")]
    Interior {
        /// The face.
        face: usize,
        /// Why; its vertices are those of the face.
        source: mindeg_interior::InteriorError,
    },
    /// The mesh is too large.
    #[error(transparent)]
    Mesh(#[from] TriMeshError),
    /// The progress callback has cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl ModelMeshError {
    pub(super) fn of_goal(goal: Goal) -> Self {
        let others = GOALS.iter().filter(|kind| kind.models && kind.value != GoalValue::Nothing);
        let instead = others.map(GoalKind::option).collect::<Vec<_>>().join(" or ");
        let option = goal.kind_and_value().0.option();
        Self::Goal(format!("{option} is for domains; for a model give {instead}"))
    }
}
