//! A domain's exact meshes: the best one under a degree limit, and the whole trade-off between degree
//! and angle, as the solver of [`mindeg_exact`] finds them on the domain's points under the domain's
//! own constraints.
//!
//! Degrees here are total: external degrees count.
//!
//! Limits: those of the solver, [`MAX_VERTICES`](mindeg_exact::MAX_VERTICES) boundary vertices of a
//! convex domain above all. With holes, searches decide within a number of steps; where they do not, and where
//! too many vertices see each other, windows reach what they can, and the answers say so.

use mindeg_domain::Domain;
use mindeg_exact::{Optimum, best_angle};
use mindeg_mesh::Progress;

use crate::boundary_mesh::BoundaryMesh;
pub use crate::degree::{DegreeAnswer, degree, degree_of_boundary};
pub use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;
use crate::searched::Searched;
use crate::windowed::{SHARES, within};
pub use mindeg_exact::{ApexBound, LowerBound, Reached, ZigZag};

/// A mesh with the largest minimum angle under a degree limit.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactMesh {
    /// The limit on the total degree of every vertex.
    pub max_degree: u32,
    /// The minimum angle of the mesh, in degrees, as the solver compares it: to 36 bits.
    pub min_angle: f64,
    /// Whether no mesh within the limit has a larger one.
    pub is_proven: bool,
    /// The mesh.
    pub mesh: BoundaryMesh,
}

/// The best minimum angle for every degree on a domain; [`trade_off`] finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    domain: Domain,
    meshes: Vec<ExactMesh>,
    delaunay_min_angle: f64,
    is_exact: bool,
}

impl TradeOff {
    /// A trade-off from the least degree on, which is proven or not.
    pub(crate) fn new(
        domain: &Domain,
        meshes: Vec<ExactMesh>,
        delaunay_min_angle: f64,
        is_least_proven: bool,
    ) -> Self {
        let is_exact = is_least_proven && meshes.iter().all(|exact| exact.is_proven);
        Self { domain: domain.clone(), meshes, delaunay_min_angle, is_exact }
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// A mesh for every maximum degree, from the least possible one to the first with which the
    /// minimum angle is as large as with any. At least one. Where windows reached them, degrees without
    /// a better mesh than the one before are left out.
    pub fn meshes(&self) -> &[ExactMesh] {
        &self.meshes
    }

    /// The minimum angle of a Delaunay triangulation, in degrees: the largest there is. The last
    /// mesh has it unless degree limits of single vertices rule that out.
    pub fn delaunay_min_angle(&self) -> f64 {
        self.delaunay_min_angle
    }

    /// Whether the least degree and the angles are proven to be the best. If not, some are what windows and
    /// searches reach: too many vertices see each other.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// How much of that a mesh has, 0 to 1; 1 where only rounding keeps them apart.
    pub fn share(&self, exact: &ExactMesh) -> f64 {
        share_of(exact.min_angle, self.delaunay_min_angle)
    }

    /// The mesh of the smallest degree that keeps this share of Delaunay's minimum angle, 0 to 1.
    pub fn keeping(&self, share: f64) -> Option<&ExactMesh> {
        self.meshes.iter().find(|exact| keeps(exact.min_angle, share, self.delaunay_min_angle))
    }

    /// The last mesh, of an exact trade-off that starts at the least maximum degree.
    pub(crate) fn last(&self) -> Meshed {
        self.meshed(self.meshes.len() - 1)
    }

    /// The mesh with this index, of an exact trade-off that starts at the least maximum degree.
    pub(crate) fn meshed(&self, index: usize) -> Meshed {
        Meshed {
            mesh: self.meshes[index].mesh.clone(),
            least_max_degree: self.meshes[0].max_degree,
            is_least_proven: true,
            found_by: FoundBy::Search,
            delaunay_min_angle: Some(self.delaunay_min_angle),
            higher_degree: None,
        }
    }
}

/// An angle as a share of the largest, `most`; 1 where only rounding keeps them apart.
pub fn share_of(angle: f64, most: f64) -> f64 {
    /// The most that rounding takes from a share.
    const ROUNDING: f64 = 1e-9;
    let share = angle / most;
    if (share - 1.0).abs() < ROUNDING { 1.0 } else { share }
}

/// Whether an angle has this share of the largest, `most`. Angles are compared to 36 bits; the last of them
/// decides nothing.
pub fn keeps(angle: f64, share: f64, most: f64) -> bool {
    angle >= share * most * (1.0 - 1e-10)
}

/// The least maximum degree of all meshes of a domain; O(k) for k sides of a convex domain without
/// constraints. [`degree`] has more to say.
///
/// # Errors
///
/// As [`degree`], and a least maximum degree that is not proven: with holes, and where too many vertices
/// see each other.
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
pub fn least_max_degree(domain: &Domain, progress: Progress<'_>) -> Result<u32, MeshError> {
    let DegreeAnswer { reached, at_least, .. } = degree(domain, progress)?;
    if reached == at_least {
        return Ok(reached);
    }
    Err(MeshError::Refused(format!(
        "the least maximum degree is not known; {reached} is reached, and no mesh has less than \
         {at_least}"
    )))
}

/// The largest minimum angle of all meshes of a domain's boundary points, in degrees: that of a Delaunay
/// triangulation. O(n log n).
///
/// # Errors
///
/// Points without a Delaunay triangulation, and a cancelled `progress`.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Progress, Side, exact};
///
/// let square = Domain::rectangle(1.0, 1.0, vec![Side::count(1); 4])?;
/// assert!((exact::delaunay_min_angle(&square, Progress::NONE)? - 45.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn delaunay_min_angle(domain: &Domain, progress: Progress<'_>) -> Result<f64, MeshError> {
    let posed = Posed::triangulated(domain, progress)?;
    Ok(posed.delaunay_min_angle.unwrap_or(0.0))
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
) -> Result<ExactMesh, MeshError> {
    let posed = Posed::new(domain, progress)?;
    match Searched::new(&posed, progress)? {
        Some(searched) => searched.within(max_degree),
        None => best_mesh(&posed, max_degree, progress),
    }
}

/// [`mesh()`] of a domain that has been posed.
pub(crate) fn best_mesh(
    posed: &Posed<'_>,
    max_degree: u32,
    progress: Progress<'_>,
) -> Result<ExactMesh, MeshError> {
    let best = best_angle(&posed.problem, max_degree, progress);
    placed(posed, best.map_err(|error| posed.unsolved(error, progress))?)
}

/// The best mesh for every maximum degree; where exact work is out of reach, the best that windows
/// reach, see [`TradeOff::is_exact`].
///
/// # Errors
///
/// The errors of [`mesh()`].
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
pub fn trade_off(domain: &Domain, progress: Progress<'_>) -> Result<TradeOff, MeshError> {
    trade_off_until(domain, |_, _| false, progress)
}

/// The [`trade_off`] up to the first mesh for which `is_enough` is true of its minimum angle and of
/// Delaunay's, in degrees.
///
/// # Errors
///
/// The errors of [`mesh()`].
pub fn trade_off_until(
    domain: &Domain,
    is_enough: impl FnMut(f64, f64) -> bool,
    progress: Progress<'_>,
) -> Result<TradeOff, MeshError> {
    let posed = Posed::new(domain, progress)?;
    if posed.has_best_angles(progress)? {
        exact_trade_off(&posed, is_enough, progress)
    } else if let Some(searched) = Searched::new(&posed, progress)? {
        searched.trade_off(is_enough)
    } else {
        trade_off_by_windows(&posed, is_enough, progress)
    }
}

/// The trade-off up to the first mesh that is enough, by the search.
pub(crate) fn exact_trade_off(
    posed: &Posed<'_>,
    mut is_enough: impl FnMut(f64, f64) -> bool,
    progress: Progress<'_>,
) -> Result<TradeOff, MeshError> {
    let mut is_enough = |optimum: &Optimum, most: f64| is_enough(optimum.min_angle, most);
    let answer = mindeg_exact::trade_off_until(&posed.problem, &mut is_enough, progress)
        .map_err(|error| posed.unsolved(error, progress))?;
    let meshes = answer.optima.into_iter().map(|optimum| placed(posed, optimum));
    let meshes = meshes.collect::<Result<_, _>>()?;
    Ok(TradeOff::new(posed.domain(), meshes, answer.unlimited_min_angle, true))
}

/// The angles that windows reach at each degree, with holes and beyond the budget of exact work.
fn trade_off_by_windows(
    posed: &Posed<'_>,
    mut is_enough: impl FnMut(f64, f64) -> bool,
    progress: Progress<'_>,
) -> Result<TradeOff, MeshError> {
    let most = posed.delaunay_min_angle.unwrap_or(0.0);
    let mut meshes = Vec::<ExactMesh>::new();
    for share in SHARES {
        let limit = meshes.last().map_or(u32::MAX, |last| last.max_degree - 1);
        let Some(Meshed { mesh, .. }) = within(posed, [share], limit, progress)? else { continue };
        let max_degree = mesh.max_total_degree();
        let min_angle = mesh.measure_angles(progress)?.min;
        meshes.push(ExactMesh { max_degree, min_angle, is_proven: false, mesh });
    }
    meshes.reverse();
    if meshes.is_empty() {
        return Err(MeshError::LimitsNotReached);
    }
    let enough = meshes.iter().position(|exact| is_enough(exact.min_angle, most));
    meshes.truncate(enough.map_or(meshes.len(), |index| index + 1));
    Ok(TradeOff::new(posed.domain(), meshes, most, false))
}

fn placed(posed: &Posed<'_>, optimum: Optimum) -> Result<ExactMesh, MeshError> {
    let Optimum { max_degree, min_angle, triangles, .. } = optimum;
    Ok(ExactMesh { max_degree, min_angle, is_proven: true, mesh: posed.mesh(triangles)? })
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
        Domain::builder(outline, vec![Side::count(2); 4]).constraints(constraints).build().unwrap()
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

        let vertices = [1, 3, 5, 7];
        for left_out in &vertices {
            let rest: Vec<_> =
                vertices.iter().filter(|v| *v != left_out).map(|&v| (v, 3)).collect();
            assert!(least_max_degree(&limited(&rest), Progress::NONE).is_ok(), "{left_out}");
        }
        assert!(mesh(&limited(&all), 9, Progress::NONE).is_err());
        assert_eq!(
            trade_off(&limited(&all), Progress::NONE).unwrap_err().to_string(),
            message(&all)
        );
    }
}
