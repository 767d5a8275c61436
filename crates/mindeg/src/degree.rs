//! The least maximum degree of any domain, with what proves it, or what is reached and what is known
//! below.
//!
//! Limits: beyond the solver's budget there may be a gap.

use mindeg_domain::Domain;
use mindeg_exact::{COVER_STEPS, DegreeRange, LowerBound, Problem, Reached, degree_range};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

use crate::error::MeshError;
use crate::map;
use crate::model::bound::JointBound;
use crate::posed::Posed;

/// A maximum degree that a mesh reaches, and one that no mesh is below.
///
/// [`mindeg_exact::check`] tells whether blocked zig-zags and apexes hold.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeAnswer {
    /// The maximum degree of some mesh, external degrees included.
    pub reached: u32,
    /// No mesh has a smaller maximum degree.
    pub at_least: u32,
    /// How `reached` was found.
    pub reached_by: Reached,
    /// The proof of `at_least`.
    pub bounded_by: DegreeBound,
}

/// The proof that no mesh has a smaller maximum degree.
#[derive(Clone, Debug, PartialEq)]
pub enum DegreeBound {
    /// Of a polygon, with or without holes.
    Polygon(LowerBound),
    /// Of a map, whose faces are one problem.
    Map {
        /// The proof.
        bound: JointBound,
        /// The number of triangles of every mesh.
        triangles: u32,
        /// The rings of each of its faces, the outer one first, by vertices.
        rings: Vec<Vec<Vec<u32>>>,
    },
}

impl DegreeAnswer {
    /// The least maximum degree, if it is proven.
    pub fn least_max_degree(&self) -> Option<u32> {
        (self.reached == self.at_least).then_some(self.reached)
    }
}

impl From<DegreeRange> for DegreeAnswer {
    fn from(range: DegreeRange) -> Self {
        let DegreeRange { max_degree, lower_bound, reached_by, bounded_by, .. } = range;
        let bounded_by = DegreeBound::Polygon(bounded_by);
        Self { reached: max_degree, at_least: lower_bound, reached_by, bounded_by }
    }
}

/// The least maximum degree of all meshes of a domain, or the gap that is left.
///
/// A map, which has lines or points inside, is meshed by the joint search of [models](crate::model).
///
/// O(k) for k sides of a convex domain without constraints. Else as [`degree_range`] finds it: for a
/// polygon without holes in which at most [`MAX_TRIPLES`](mindeg_exact::MAX_TRIPLES) triples of vertices
/// see each other it is proven; with holes, wherever the search for it ends within its steps.
///
/// # Errors
///
/// A domain that is constrained, convex and too large; whose own degree limits no mesh keeps; points
/// without a Delaunay triangulation; a `progress` that cancels.
///
/// # Example
///
/// ```
/// use mindeg::exact::{DegreeBound, LowerBound, degree};
/// use mindeg::{Domain, Progress, Side};
///
/// // An L with 13, 6, 6, 6, 6 and 13 intervals.
/// let corners = [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]].map(|[x, y]| [x as f64, y as f64]);
/// let sides = [13, 6, 6, 6, 6, 13].map(Side::count).to_vec();
/// let answer = degree(&Domain::polygon(corners, sides)?, Progress::NONE)?;
/// assert_eq!(answer.least_max_degree(), Some(5));
/// assert!(matches!(answer.bounded_by, DegreeBound::Polygon(LowerBound::BlockedZigZags(_))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn degree(domain: &Domain, progress: Progress<'_>) -> Result<DegreeAnswer, MeshError> {
    degree_with(domain, 1.0, progress)
}

/// [`degree`] with more steps for searches with holes, or fewer: `effort` times their default, which takes some
/// seconds.
///
/// # Errors
///
/// As [`degree`].
pub fn degree_with(
    domain: &Domain,
    effort: f64,
    progress: Progress<'_>,
) -> Result<DegreeAnswer, MeshError> {
    degree_decided(domain, None, effort, progress)
}

/// [`degree_with`], which may end as soon as it knows whether some mesh has at most the wanted degree.
pub(crate) fn degree_decided(
    domain: &Domain,
    wanted: Option<u32>,
    effort: f64,
    progress: Progress<'_>,
) -> Result<DegreeAnswer, MeshError> {
    if let Some(form) = domain.convex()
        && !domain.is_constrained()
    {
        let least = mindeg_core::least_max_degree(form.boundary());
        let bounded_by = DegreeBound::Polygon(LowerBound::ClosedForm);
        let reached_by = Reached::ClosedForm;
        return Ok(DegreeAnswer { reached: least, at_least: least, reached_by, bounded_by });
    }
    if domain.is_map() {
        let found = map::least(domain, wanted.unwrap_or(0), effort, progress)?;
        return Ok(DegreeAnswer {
            reached: found.max_degree(),
            at_least: found.bound.max_degree(),
            reached_by: Reached::Windows,
            bounded_by: DegreeBound::Map {
                bound: found.bound,
                triangles: found.mesh.triangle_count(),
                rings: found.rings,
            },
        });
    }
    let mut posed = Posed::new(domain, progress)?;
    posed.problem.set_max_steps((COVER_STEPS as f64 * effort.max(0.0)) as u64);
    if let Some(wanted) = wanted {
        posed.problem.set_wanted_degree(wanted);
    }
    let range = degree_range(&posed.problem, progress);
    Ok(range.map_err(|error| posed.unsolved(error, progress))?.into())
}

/// The least maximum degree of all meshes of rings of points, or the gap that is left; as [`degree`]
/// without a domain.
///
/// Beyond `max_triples` triples of vertices that see each other there is a gap.
///
/// # Errors
///
/// Coordinates out of range, and a `progress` that cancels.
pub fn degree_of_boundary(
    boundary: &PlanarBoundary,
    max_triples: u64,
    progress: Progress<'_>,
) -> Result<DegreeAnswer, MeshError> {
    let triangles = mindeg_delaunay::triangles(boundary, &[], &[], progress)?;
    let mut problem = Problem::triangulated(boundary, &triangles)?;
    problem.set_max_triples(max_triples);
    Ok(degree_range(&problem, progress)?.into())
}
