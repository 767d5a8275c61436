//! Why a problem has no answer.

use mindeg_mesh::Cancelled;
use thiserror::Error;

/// Why a problem has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Unsolved {
    /// No triangulation keeps the degree limit for all vertices.
    #[error("no triangulation here has maximum degree {max_degree}; the least is {least}")]
    Infeasible {
        /// The limit.
        max_degree: u32,
        /// The smallest limit that some triangulation keeps.
        least: u32,
    },
    /// No triangulation keeps the degree limits of single vertices, however large the limit for
    /// all.
    #[error(
        "no triangulation keeps the degree limits of single vertices, whatever its maximum \
         degree; raise these limits"
    )]
    VertexLimits,
    /// More triples of vertices see each other than the problem allows.
    #[error(
        "more than {max_triples} triples of vertices see each other, the limit of exact work; \
         use windows, or raise the limit"
    )]
    TooLarge {
        /// The limit.
        max_triples: u64,
    },
    /// The domain has holes, or its boundary is not the ring 0, 1, 2, …
    #[error(
        "exact work needs a polygon without holes whose vertices are numbered along its boundary; \
         use windows"
    )]
    NotAPolygon,
    /// The progress callback cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
