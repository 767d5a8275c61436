//! What a mesh is chosen for: the one place that decides between the formula and the solver.

use mindeg_domain::Domain;
use mindeg_mesh::Progress;

use crate::boundary_mesh::BoundaryMesh;
use crate::exact::{self, ExactError};

/// What a mesh is chosen for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Goal {
    /// The least maximum degree, at any size; of the candidates that the construction gives, the
    /// one with the largest minimum angle. A [constrained](Domain::is_constrained) domain takes
    /// the solver.
    #[default]
    LeastDegree,
    /// The largest minimum angle of all meshes whose degrees are within a limit, by the solver.
    LargestAngle {
        /// The limit on the total degree of every vertex; the least that is possible if `None`.
        max_degree: Option<u32>,
    },
}

/// A mesh, and the least degree to compare it with.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// The mesh.
    pub mesh: BoundaryMesh,
    /// The least maximum total degree that any mesh of the domain has.
    pub least_max_degree: u32,
}

/// The mesh of a domain that a goal asks for.
///
/// O(n) time for a formula; [`exact`] has what the solver takes.
///
/// # Errors
///
/// Points so close together that triangles have no area; for the solver, a domain that is too
/// large and limits that no mesh keeps; and a `progress` callback that cancels.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Goal, Progress, Side, mesh};
///
/// let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
/// let formula = mesh(&domain, Goal::LeastDegree, Progress::NONE)?.mesh;
/// let best = mesh(&domain, Goal::LargestAngle { max_degree: None }, Progress::NONE)?.mesh;
/// assert_eq!((formula.max_degree(), best.max_degree()), (5, 5));
/// assert!(best.angle_range().min > formula.angle_range().min);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh(domain: &Domain, goal: Goal, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    let least_max_degree = exact::least_max_degree(domain, progress)?;
    let mesh = match goal {
        Goal::LeastDegree if !domain.is_constrained() => {
            BoundaryMesh::of_formula(domain, progress)?
        }
        Goal::LeastDegree => exact::mesh(domain, least_max_degree, progress)?.mesh,
        Goal::LargestAngle { max_degree } => {
            exact::mesh(domain, max_degree.unwrap_or(least_max_degree), progress)?.mesh
        }
    };
    Ok(Meshed { mesh, least_max_degree })
}
