//! A domain's exact meshes: the best one under a degree limit, and the whole trade-off between degree
//! and angle, as the solver of [`mindeg_exact`] finds them on the domain's points under the domain's
//! own constraints.
//!
//! Degrees here are total: external degrees count.
//!
//! Limits: those of the solver, [`MAX_VERTICES`](mindeg_exact::MAX_VERTICES) boundary vertices
//! above all.

use std::cmp::Reverse;

use glam::DVec2;
use mindeg_delaunay::DelaunayError;
use mindeg_domain::Domain;
use mindeg_exact::{Optimum, Problem, ProblemError, Unsolved, best_angle};
use mindeg_mesh::Progress;

use crate::boundary_mesh::{BoundaryMesh, MeshError, convex};
use crate::conflict;

/// A mesh with the largest minimum angle under a degree limit.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactMesh {
    /// The limit on the total degree of every vertex.
    pub max_degree: u32,
    /// The minimum angle of the mesh, in degrees, as the solver compares it: to 36 bits.
    pub min_angle: f64,
    /// The mesh.
    pub mesh: BoundaryMesh,
}

/// What every degree buys on a domain; [`trade_off`] finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    domain: Domain,
    meshes: Vec<ExactMesh>,
    delaunay_min_angle: f64,
}

impl TradeOff {
    /// The domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// A mesh for every maximum degree, from the least possible one to the first with which the
    /// minimum angle is as large as with any. At least one.
    #[must_use]
    pub fn meshes(&self) -> &[ExactMesh] {
        &self.meshes
    }

    /// The minimum angle of a Delaunay triangulation, in degrees: the largest there is. The last
    /// mesh has it unless degree limits of single vertices rule that out.
    #[must_use]
    pub fn delaunay_min_angle(&self) -> f64 {
        self.delaunay_min_angle
    }

    /// How much of that a mesh has, 0 to 1.
    #[must_use]
    pub fn share(&self, exact: &ExactMesh) -> f64 {
        exact.min_angle / self.delaunay_min_angle
    }
}

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
    /// Its points have no Delaunay triangulation to start from.
    #[error(transparent)]
    Delaunay(#[from] DelaunayError),
    /// Its points are too close together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The least maximum degree of all meshes of a domain; O(k) for k sides unless the domain is
/// constrained.
///
/// # Errors
///
/// A domain that is constrained and too large, or whose own degree limits no mesh keeps.
///
/// # Example
///
/// ```
/// use mindeg::{Progress, exact};
/// use mindeg::Domain;
///
/// let domain = Domain::from_json(
///     r#"{"rectangle": {"width": 4, "height": 3}, "size": 1, "sides": [
///         {}, {}, {"outside_degree": 3}, {}]}"#,
/// )?;
/// assert_eq!(exact::least_max_degree(&domain, Progress::NONE)?, 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_max_degree(domain: &Domain, progress: Progress<'_>) -> Result<u32, ExactError> {
    if !domain.is_constrained() {
        return Ok(mindeg_core::least_max_degree(convex(domain)?));
    }
    let problem = problem(domain)?;
    mindeg_exact::least_max_degree(&problem, progress)
        .map_err(|error| unsolved(domain, error, progress))
}

/// The mesh with the largest minimum angle in which no total degree is above `max_degree`, nor
/// above the degree limits of the domain.
///
/// See [`best_angle`] for the choice among several, time and memory.
///
/// # Errors
///
/// A domain that is too large, degree limits that no mesh keeps, a cancelled `progress`, or points
/// so close together that triangles have no area.
///
/// # Example
///
/// ```
/// use mindeg::{Progress, exact};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let exact = exact::mesh(&domain, 5, Progress::NONE)?;
/// assert_eq!(exact.mesh.max_degree(), 5);
/// assert!((exact.min_angle - 6.340).abs() < 5e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh(
    domain: &Domain,
    max_degree: u32,
    progress: Progress<'_>,
) -> Result<ExactMesh, ExactError> {
    let problem = problem(domain)?;
    let best = best_angle(&problem, max_degree, progress);
    placed(domain, best.map_err(|error| unsolved(domain, error, progress))?)
}

/// The best mesh for every maximum degree.
///
/// # Errors
///
/// As [`mesh()`].
///
/// # Example
///
/// ```
/// use mindeg::{Progress, exact};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let trade_off = exact::trade_off(&domain, Progress::NONE)?;
/// let [four, five] = trade_off.meshes() else { panic!("degrees 4 and 5") };
/// assert_eq!((four.max_degree, five.max_degree), (4, 5));
/// assert_eq!(five.min_angle, trade_off.delaunay_min_angle());
/// assert!((trade_off.share(four) - 0.463).abs() < 5e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trade_off(domain: &Domain, progress: Progress<'_>) -> Result<TradeOff, ExactError> {
    trade_off_until(domain, |_, _| false, progress)
}

/// The [`trade_off`] up to the first mesh for which `is_enough` is true of its minimum angle and of
/// Delaunay's, in degrees.
///
/// # Errors
///
/// As [`mesh()`].
pub fn trade_off_until(
    domain: &Domain,
    mut is_enough: impl FnMut(f64, f64) -> bool,
    progress: Progress<'_>,
) -> Result<TradeOff, ExactError> {
    let problem = problem(domain)?;
    let mut is_enough = |optimum: &Optimum, most: f64| is_enough(optimum.min_angle, most);
    let answer = mindeg_exact::trade_off_until(&problem, &mut is_enough, progress)
        .map_err(|error| unsolved(domain, error, progress))?;
    let meshes = answer.optima.into_iter().map(|optimum| placed(domain, optimum));
    Ok(TradeOff {
        domain: domain.clone(),
        meshes: meshes.collect::<Result<_, _>>()?,
        delaunay_min_angle: answer.unlimited_min_angle,
    })
}

/// The domain as the solver takes it.
fn problem(domain: &Domain) -> Result<Problem, ExactError> {
    let boundary = convex(domain)?;
    // The solver refuses a number of vertices too large for the memory of one point each.
    if boundary.vertex_count() > mindeg_exact::MAX_VERTICES {
        return Err(ProblemError::TooManyVertices { vertices: boundary.vertex_count() }.into());
    }
    let points: Vec<DVec2> = domain.placement().points().collect();
    let mut problem = Problem::new(boundary, &points)?;
    constrain(&mut problem, domain);
    Ok(problem)
}

/// Tells the solver the domain's constraints.
pub(crate) fn constrain(problem: &mut Problem, domain: &Domain) {
    set_external_degrees(problem, domain);
    for (vertex, limit) in degree_limits(domain) {
        problem.set_degree_limit(vertex, limit);
    }
}

fn set_external_degrees(problem: &mut Problem, domain: &Domain) {
    if domain.is_constrained() {
        for vertex in 0..domain.rings().vertex_count() {
            problem.set_external_degree(vertex, domain.external_degree(vertex));
        }
    }
}

/// The vertices with a degree limit, and the limits.
fn degree_limits(domain: &Domain) -> Vec<(u32, u32)> {
    if !domain.is_constrained() {
        return Vec::new();
    }
    let vertices = 0..domain.rings().vertex_count();
    vertices.filter_map(|vertex| Some((vertex, domain.degree_limit(vertex)?))).collect()
}

/// Why the solver has no answer, with the vertices whose degree limits no mesh keeps together.
fn unsolved(domain: &Domain, error: Unsolved, progress: Progress<'_>) -> ExactError {
    if error != Unsolved::VertexLimits {
        return error.into();
    }
    match vertices_in_conflict(domain, progress) {
        Ok(vertices) => ExactError::DegreeLimits { vertices },
        Err(error) => error,
    }
}

/// Vertices whose degree limits no mesh keeps together, where those of all conflict.
fn vertices_in_conflict(domain: &Domain, progress: Progress<'_>) -> Result<Vec<u32>, ExactError> {
    let points: Vec<DVec2> = domain.placement().points().collect();
    let mut plain = Problem::new(convex(domain)?, &points)?;
    set_external_degrees(&mut plain, domain);
    let conflict = |limits: &[(u32, u32)]| {
        let mut problem = plain.clone();
        limits.iter().for_each(|&(vertex, limit)| problem.set_degree_limit(vertex, limit));
        match mindeg_exact::least_max_degree(&problem, progress) {
            Ok(_) => Ok(false),
            Err(Unsolved::VertexLimits) => Ok(true),
            Err(error) => Err(error),
        }
    };
    let tries = most_tries(domain.rings().vertex_count());
    let found = conflict::smallest(degree_limits(domain), tries, conflict)?;
    let mut vertices: Vec<u32> = found.into_iter().map(|(vertex, _)| vertex).collect();
    vertices.sort_unstable();
    Ok(vertices)
}

/// The most times that the search for a conflict solves the problem, in O(n³) time each.
fn most_tries(vertex_count: u32) -> u64 {
    const TRIES: u64 = 64;
    /// Up to this many vertices a try takes some milliseconds.
    const SMALL: u64 = 256;
    TRIES * SMALL.pow(3) / u64::from(vertex_count).max(SMALL).pow(3)
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

fn placed(domain: &Domain, optimum: Optimum) -> Result<ExactMesh, ExactError> {
    let Optimum { max_degree, min_angle, mut triangles, .. } = optimum;
    // Every triangle cuts off the vertices from its smallest to its largest. Sorted like that,
    // what one cuts off follows on it, and neighbours mostly share an edge.
    triangles.sort_unstable_by_key(|&[first, _, last]| (first, Reverse(last)));
    Ok(ExactMesh { max_degree, min_angle, mesh: BoundaryMesh::with_triangles(domain, triangles)? })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::{Constraints, Outline, Rectangle, Side, VertexConstraint};

    /// A square with two intervals to a side, in which some vertices have a degree limit.
    fn limited(limits: &[(u32, u32)]) -> Domain {
        let outline = Outline::Rectangle(Rectangle::new(1.0, 1.0));
        let vertices = limits.iter().map(|&(vertex, limit)| VertexConstraint {
            vertex,
            external_degree: 0,
            degree_limit: Some(limit),
        });
        let constraints = Constraints { sides: Vec::new(), vertices: vertices.collect() };
        Domain::constrained(outline, vec![Side::count(2); 4], constraints).unwrap()
    }

    #[test]
    fn limits_that_conflict_are_named() {
        let message = |limits: &[(u32, u32)]| {
            least_max_degree(&limited(limits), Progress::NONE).unwrap_err().to_string()
        };
        let all = [0, 1, 2, 3, 4, 5, 6, 7].map(|vertex| (vertex, 3));
        assert_eq!(
            message(&all),
            "no mesh keeps the degree limits of vertices 1, 3, 5 and 7 together; raise max_degree at \
             one of them or more"
        );

        let Err(ExactError::DegreeLimits { vertices }) =
            least_max_degree(&limited(&all), Progress::NONE)
        else {
            panic!("the limits conflict")
        };
        for left_out in &vertices {
            let rest: Vec<_> =
                vertices.iter().filter(|v| *v != left_out).map(|&v| (v, 3)).collect();
            assert!(least_max_degree(&limited(&rest), Progress::NONE).is_ok(), "{left_out}");
        }
        assert!(mesh(&limited(&all), 9, Progress::NONE).is_err());
        assert_eq!(
            trade_off(&limited(&all), Progress::NONE),
            Err(ExactError::DegreeLimits { vertices })
        );
    }

    #[test]
    fn a_long_list_of_vertices_is_cut() {
        assert_eq!(vertex_list(&[7]), "vertex 7");
        assert_eq!(vertex_list(&[1, 4, 7]), "vertices 1, 4 and 7 together");
        let many: Vec<u32> = (0..100).collect();
        assert_eq!(vertex_list(&many), "vertices 0, 1, 2, 3, 4, 5, 6, 7, … (100 in all) together");
    }
}
