//! Why a problem cannot be posed or has no answer.

use mindeg_mesh::Cancelled;
use thiserror::Error;

/// The most boundary vertices of a convex polygon, 4,096.
///
/// Time grows with the cube of the number of vertices and memory with its square.
pub const MAX_VERTICES: u32 = 4096;

/// Why a problem cannot be posed or has no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Unsolved {
    /// The input does not make a problem, or the work is too large: where, and how to mend it.
    #[error("{0}")]
    Refused(String),
    /// A convex polygon with more vertices than [`MAX_VERTICES`].
    #[error(
        "found {vertices} boundary vertices; exact work takes at most {MAX_VERTICES}; use fewer \
         intervals, or the formula of least degree, which takes any number"
    )]
    TooManyVertices {
        /// Their number.
        vertices: u32,
    },
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
        "more than {max_triples} triples of vertices see each other, the limit of exact work; take \
         fewer points, or a degree that is reached without a proof"
    )]
    TooLarge {
        /// The limit.
        max_triples: u64,
    },
    /// The domain has holes, and this needs a polygon without; [`Cover`](crate::Cover) decides about those with.
    #[error(
        "this search takes a polygon without holes; with holes, the search for the least degree decides"
    )]
    NotAPolygon,
    /// Every triangulation of a loop, or strip between loops, has an excluded edge.
    #[error("every triangulation here needs an edge that exists already")]
    Excluded,
    /// The search of a domain with holes took all its steps, or has too many triangles.
    #[error(
        "the search did not decide whether a triangulation keeps the limits; raise these limits, take \
         fewer points, or let it take more steps"
    )]
    Undecided,
    /// The progress callback cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl Unsolved {
    /// The refusal with this sentence.
    pub(crate) fn refused(sentence: impl Into<String>) -> Self {
        Self::Refused(sentence.into())
    }
}
