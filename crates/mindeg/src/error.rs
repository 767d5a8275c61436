//! Why there is no mesh.

use mindeg_delaunay::DelaunayError;
use mindeg_exact::{DegreeRange, LowerBound, Unsolved};
use mindeg_mesh::check::CheckError;
use mindeg_mesh::planar::BoundaryFaults;
use mindeg_mesh::{Cancelled, TriMeshError};

/// Why a domain, a model or a mesh has no mesh of the kind that was asked for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The reason in a sentence, with the place and a way out.
    #[error("{0}")]
    Refused(String),
    /// The domain constrains its degrees, which the formula does not take.
    #[error(
        "the domain has constraints on its degrees, which take the exact solver; leave out \
         outside_degree and max_degree for a mesh of least degree"
    )]
    Constrained,
    /// Windows do not keep the degree limits of single vertices, and the search did not decide about them.
    #[error(
        "no mesh was found that keeps the degree limits of single vertices, and the search did not decide \
         whether one exists; raise these limits"
    )]
    LimitsNotReached,
    /// The solver refuses it, or has proven that there is none.
    #[error(transparent)]
    Unsolved(#[from] Unsolved),
    /// Its points have no Delaunay triangulation to start from.
    #[error(transparent)]
    Delaunay(#[from] DelaunayError),
    /// The boundary is not simple.
    #[error("once its points are rounded to f64, the boundary is not simple: {0}")]
    Boundary(#[from] BoundaryFaults),
    /// The triangles are not a triangulation of the domain.
    #[error("the triangles are no mesh of the domain: {0}")]
    Triangles(#[from] CheckError),
    /// The triangles are not a mesh.
    #[error(transparent)]
    List(#[from] TriMeshError),
    /// The progress callback cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl MeshError {
    pub(crate) fn refused(sentence: impl ToString) -> Self {
        Self::Refused(sentence.to_string())
    }

    /// The formula does not take a domain.
    pub(crate) fn not_convex() -> Self {
        Self::refused(
            "the domain is not convex or has holes, which the formula does not take; use the solver",
        )
    }

    /// A triangle whose points are on a line, as far as their coordinates tell.
    pub(crate) fn no_area(triangle: [u32; 3]) -> Self {
        Self::Refused(format!(
            "triangle {triangle:?} is so thin that it has no area at the precision of its coordinates; use \
             fewer intervals or gentler spacing laws, or move the domain towards the origin"
        ))
    }

    /// No mesh within a degree limit was found, or none exists.
    pub(crate) fn not_reached(limit: u32, reached: u32, at_least: u32) -> Self {
        if limit < at_least {
            return Self::Refused(format!(
                "no mesh here has maximum degree {limit}: each has at least {at_least}, as mindeg degree proves; \
                 {reached} is reached"
            ));
        }
        Self::Refused(format!(
            "no mesh of maximum degree {limit} was found; {reached} is reached, and no mesh has less than \
             {at_least}"
        ))
    }

    /// A degree limit below that of any mesh of a domain with holes, with the proof.
    pub(crate) fn excluded(limit: u32, range: &DegreeRange) -> Self {
        let (reached, at_least) = (range.max_degree, range.lower_bound);
        let why = match &range.bounded_by {
            LowerBound::Refuted(refutation) => match refutation.clauses.len() {
                1 => format!("one clause refutes degree {}", at_least - 1),
                clauses => format!(
                    "{clauses} clauses refute degree {}, which mindeg degree --proof writes to a file",
                    at_least - 1
                ),
            },
            LowerBound::NoStrip => {
                "degree 4 takes a strip between two rings of as many vertices, and none lies inside"
                    .to_owned()
            }
            LowerBound::Apexes(bound) => format!(
                "{} boundary edges have only {} vertices as apexes",
                bound.edges.len(),
                bound.apexes.len()
            ),
            _ => "its edges have too many ends for its vertices".to_owned(),
        };
        let least = if reached == at_least {
            format!("the least is {reached}")
        } else {
            format!("the least is {at_least} or more, and {reached} is reached")
        };
        Self::Refused(format!("no mesh here has maximum degree {limit}: {why}; {least}"))
    }

    /// An error of a face of a model.
    pub(crate) fn of_face(face: usize, error: impl std::fmt::Display) -> Self {
        Self::Refused(format!("face {face}: {error}"))
    }
}

#[cfg(feature = "interior")]
impl From<mindeg_interior::InteriorError> for MeshError {
    fn from(error: mindeg_interior::InteriorError) -> Self {
        match error {
            mindeg_interior::InteriorError::Cancelled(cancelled) => cancelled.into(),
            error => Self::refused(error),
        }
    }
}
