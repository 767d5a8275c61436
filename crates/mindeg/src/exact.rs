//! A domain's exact meshes: the best one under a degree limit, and the whole trade-off between degree
//! and angle, as the solver of [`mindeg_exact`] finds them on the domain's points under the domain's
//! own constraints.
//!
//! Degrees here are total: external degrees count.
//!
//! Limits: those of the solver, [`MAX_VERTICES`] boundary vertices of a
//! convex domain above all. With holes, searches decide within a number of steps; where they do not, and where
//! too many vertices see each other, windows reach what they can, and the answers say so.

use mindeg_domain::Domain;
use mindeg_exact::{Optimum, best_angle};
use mindeg_mesh::Progress;

use crate::boundary_mesh::BoundaryMesh;
pub use crate::degree::{DegreeAnswer, DegreeBound, degree, degree_of_boundary, degree_with};
use crate::degree_first::degree_first;
pub use crate::error::MeshError;
use crate::map;
use crate::meshed::Meshed;
use crate::posed::Posed;
use crate::searched::Searched;
pub use crate::trade_off::{ExactMesh, TradeOff, keeps, share_of};
use crate::windowed::{SHARES, within};
pub use mindeg_exact::{
    ApexBound, Element, Literal, LowerBound, MAX_VERTICES, Reached, Refutation, ZigZag,
};

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
    if domain.is_map() {
        return map::delaunay_min_angle(domain, progress);
    }
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
    if domain.is_map() {
        let Meshed { mesh, .. } = map::max_degree(domain, max_degree, progress)?;
        let min_angle = mesh.measure_angles(progress)?.min;
        return Ok(ExactMesh { max_degree, min_angle, is_proven: false, mesh });
    }
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
    if domain.is_map() {
        return map::trade_off(domain, is_enough, progress);
    }
    // Windows keep limits of single vertices by chance only.
    let posed = match domain.is_constrained() {
        true => Posed::new(domain, progress)?,
        false => Posed::of_any_size(domain, progress)?,
    };
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

/// The angles that windows reach at each degree, with holes and beyond the budget of exact work; the formula gives the least
/// degree where it can.
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
    let is_by_formula = posed.domain().convex().is_some() && !posed.domain().is_constrained();
    let least = match is_by_formula {
        true => BoundaryMesh::of_formula(posed.domain(), progress)?,
        false => degree_first(posed, progress)?.mesh,
    };
    let max_degree = least.max_total_degree();
    if meshes.last().is_none_or(|last| max_degree < last.max_degree) {
        let min_angle = least.measure_angles(progress)?.min;
        meshes.push(ExactMesh { max_degree, min_angle, is_proven: false, mesh: least });
    }
    meshes.reverse();
    let enough = meshes.iter().position(|exact| is_enough(exact.min_angle, most));
    meshes.truncate(enough.map_or(meshes.len(), |index| index + 1));
    Ok(TradeOff::new(posed.domain(), meshes, most, is_by_formula))
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
