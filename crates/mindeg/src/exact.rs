//! A domain's exact meshes: the best one under a cap, and the whole trade-off between degree and
//! angle, as the solver of [`mindeg_exact`] finds them on the domain's points, with what the
//! domain says of its vertices' degrees.
//!
//! Degrees here are total: edges outside the domain count.
//!
//! Limits: those of the solver, [`MAX_VERTICES`](mindeg_exact::MAX_VERTICES) boundary vertices
//! above all.

use std::cmp::Reverse;

use glam::DVec2;
use mindeg_delaunay::DelaunayError;
use mindeg_domain::Domain;
use mindeg_exact::{Optimum, Problem, ProblemError, Unsolved, best_angle};
use mindeg_mesh::Progress;

use crate::boundary_mesh::{BoundaryMesh, MeshError};

/// A mesh with the largest minimum angle under a cap.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactMesh {
    /// The cap on the total degree of every vertex.
    pub max_degree: u32,
    /// The smallest angle of all triangles, in degrees, as the solver compares it: to 36 bits.
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
    /// mesh has it unless caps of single vertices stand against that.
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
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExactError {
    /// It is too large.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The caps cannot be kept, or the work was cancelled.
    #[error(transparent)]
    Unsolved(#[from] Unsolved),
    /// Its points have no Delaunay triangulation to start from.
    #[error(transparent)]
    Delaunay(#[from] DelaunayError),
    /// Its points are too close together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The least maximum degree there is on a domain; O(k) for k sides unless the domain is
/// constrained.
///
/// # Errors
///
/// A domain that is constrained and too large, or cannot keep to its own caps.
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
/// assert_eq!(exact::optimal_max_degree(&domain, Progress::NONE)?, 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn optimal_max_degree(domain: &Domain, progress: Progress<'_>) -> Result<u32, ExactError> {
    if !domain.is_constrained() {
        return Ok(mindeg_core::least_max_degree(domain.boundary()));
    }
    let problem = problem(domain)?;
    Ok(mindeg_exact::least_max_degree(&problem, progress)?)
}

/// The mesh with the largest minimum angle in which no total degree is above `max_degree`, nor
/// above what the domain says of single vertices.
///
/// See [`best_angle`] for the choice among several and for what it takes.
///
/// # Errors
///
/// A domain that is too large, caps that cannot be kept, a cancelled `progress`, or points so
/// close together that triangles have no area.
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
    placed(domain, best_angle(&problem, max_degree, progress)?)
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
    let answer = mindeg_exact::trade_off_until(&problem, &mut is_enough, progress)?;
    let meshes = answer.optima.into_iter().map(|optimum| placed(domain, optimum));
    Ok(TradeOff {
        domain: domain.clone(),
        meshes: meshes.collect::<Result<_, _>>()?,
        delaunay_min_angle: answer.unlimited_min_angle,
    })
}

/// The domain as the solver takes it.
fn problem(domain: &Domain) -> Result<Problem, ProblemError> {
    let boundary = domain.boundary();
    // The solver refuses a number of vertices too large for the memory of one point each.
    if boundary.vertex_count() > mindeg_exact::MAX_VERTICES {
        return Err(ProblemError::TooManyVertices { vertices: boundary.vertex_count() });
    }
    let points: Vec<DVec2> = domain.placement().points().collect();
    let mut problem = Problem::new(boundary, &points)?;
    constrain(&mut problem, domain);
    Ok(problem)
}

/// Tells the solver what the domain says of its vertices' degrees.
pub(crate) fn constrain(problem: &mut Problem, domain: &Domain) {
    if domain.is_constrained() {
        for vertex in 0..domain.boundary().vertex_count() {
            problem.set_external_degree(vertex, domain.outside_degree(vertex));
            if let Some(max_degree) = domain.max_degree(vertex) {
                problem.set_degree_limit(vertex, max_degree);
            }
        }
    }
}

fn placed(domain: &Domain, optimum: Optimum) -> Result<ExactMesh, ExactError> {
    let Optimum { max_degree, min_angle, mut triangles, .. } = optimum;
    // Every triangle cuts off the vertices from its smallest to its largest. Sorted like that,
    // what one cuts off follows on it, and neighbours mostly share an edge.
    triangles.sort_unstable_by_key(|&[first, _, last]| (first, Reverse(last)));
    Ok(ExactMesh { max_degree, min_angle, mesh: BoundaryMesh::with_triangles(domain, triangles)? })
}
