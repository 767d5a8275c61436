//! Why a domain has no mesh of the kind that was asked for.

use mindeg_delaunay::DelaunayError;
use mindeg_exact::{ProblemError, Unsolved};
use mindeg_mesh::Cancelled;

use crate::boundary_mesh::MeshError;

/// Why a domain has no exact mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExactError {
    /// It is too large.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// No mesh keeps the limit for all vertices, or the work was cancelled.
    #[error(transparent)]
    Unsolved(#[from] Unsolved),
    /// No mesh keeps the degree limits that the domain gives these vertices, whatever the others
    /// may have. Without any one of these limits the others can be kept, unless there are more
    /// than the search had time for.
    #[error(
        "no mesh keeps the degree limits of {}; raise max_degree {}",
        vertex_list(vertices),
        if vertices.len() == 1 { "there" } else { "at one of them or more" }
    )]
    DegreeLimits {
        /// The vertices, in ascending order.
        vertices: Vec<u32>,
    },
    /// The least maximum degree is not known.
    #[error(
        "the least maximum degree is not known; {reached} is reached, and no mesh has less than \
         {at_least}"
    )]
    Gap {
        /// The maximum degree of some mesh.
        reached: u32,
        /// No mesh has a smaller one.
        at_least: u32,
    },
    /// Windows do not reach a degree limit, and whether any mesh keeps it is not known.
    #[error(
        "no mesh of maximum degree {max_degree} was found; {reached} is reached, and no mesh has \
         less than {at_least}"
    )]
    NotReached {
        /// The limit.
        max_degree: u32,
        /// The maximum degree of some mesh.
        reached: u32,
        /// No mesh has a smaller one.
        at_least: u32,
    },
    /// Windows do not keep the degree limits of single vertices.
    #[error(
        "no mesh was found that keeps the degree limits of single vertices; with holes, and where \
         too many vertices see each other, not all meshes are searched; raise these limits"
    )]
    LimitsNotReached,
    /// Its points have no Delaunay triangulation to start from.
    #[error(transparent)]
    Delaunay(#[from] DelaunayError),
    /// Its points are too close together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

impl From<Cancelled> for ExactError {
    fn from(cancelled: Cancelled) -> Self {
        Unsolved::from(cancelled).into()
    }
}

/// Vertices as a message lists them.
fn vertex_list(vertices: &[u32]) -> String {
    const MOST: usize = 8;
    let names: Vec<String> = vertices.iter().take(MOST).map(u32::to_string).collect();
    match vertices.len() {
        0 | 1 => format!("vertex {}", names.join("")),
        count @ 2..=MOST => {
            format!("vertices {} and {} together", names[..count - 1].join(", "), names[count - 1])
        }
        count => format!("vertices {}, … ({count} in all) together", names.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_list_of_vertices_is_cut() {
        assert_eq!(vertex_list(&[7]), "vertex 7");
        assert_eq!(vertex_list(&[1, 4, 7]), "vertices 1, 4 and 7 together");
        let many: Vec<u32> = (0..100).collect();
        assert_eq!(vertex_list(&many), "vertices 0, 1, 2, 3, 4, 5, 6, 7, … (100 in all) together");
    }
}
