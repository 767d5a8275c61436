//! What a mesh is chosen for: the one place that decides between formula, search and windows.

use mindeg_core::Boundary;
use mindeg_domain::Domain;
use mindeg_exact::MAX_VERTICES;
use mindeg_mesh::Progress;

use crate::boundary_mesh::{BoundaryMesh, convex};
use crate::exact::{self, ExactError};
use crate::keep_angle::{Delaunay, keep_angle};
use crate::meshed::{FoundBy, HigherDegree, Meshed};

/// Up to this many chords between different sides, times the least maximum degree, the search for the
/// best mesh of least degree, and of one and two degrees more, takes less than about half a second on
/// one core.
const LITTLE_WORK: u64 = 150_000;

/// How many times the minimum angle a higher degree must bring to be worth a hint.
const MUCH: f64 = 1.5;

/// What a mesh is chosen for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Goal {
    /// The least maximum degree, at any size.
    ///
    /// Where few chords join different sides, or the domain [is constrained](Domain::is_constrained),
    /// the mesh with the largest minimum angle of all with that degree, by the solver. Else the best of
    /// at most 64 candidates that the construction gives.
    #[default]
    LeastDegree,
    /// No total degree above a limit, and the largest minimum angle within it: exactly up to
    /// [`MAX_VERTICES`] boundary vertices, beyond that as large as windows reach.
    MaxDegree(u32),
    /// The least maximum degree of all meshes that have this share, 0 to 1, of the minimum angle of a
    /// Delaunay triangulation: exactly up to [`MAX_VERTICES`] boundary vertices, beyond that as low
    /// as windows reach.
    KeepAngle(f64),
}

/// The mesh of a domain that a goal asks for.
///
/// # Errors
///
/// Points so close together that triangles have no area; limits of degrees that no mesh keeps; a
/// domain with limits of single vertices that is too large for the solver; and a `progress` callback
/// that cancels.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Goal, Progress, Side, mesh};
///
/// let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
/// let least = mesh(&domain, Goal::LeastDegree, Progress::NONE)?;
/// let kept = mesh(&domain, Goal::KeepAngle(0.95), Progress::NONE)?;
/// assert_eq!((least.mesh.max_degree(), kept.mesh.max_degree()), (5, 6));
/// assert!(kept.mesh.angle_range().min >= 0.95 * kept.delaunay_min_angle.unwrap());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh(domain: &Domain, goal: Goal, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    match goal {
        Goal::LeastDegree => least_degree(domain, progress),
        Goal::MaxDegree(limit) => max_degree(domain, limit, progress),
        Goal::KeepAngle(share) => keep_angle(domain, share, progress),
    }
}

fn least_degree(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    let boundary = convex(domain)?;
    let is_cheap = boundary.vertex_count() <= MAX_VERTICES && work(boundary) <= LITTLE_WORK;
    if !domain.is_constrained() && !is_cheap {
        return formula(domain, progress);
    }
    let mut tried = 0;
    let is_third = |_, _| {
        tried += 1;
        tried == 3
    };
    let trade_off = exact::trade_off_until(domain, is_third, progress)?;
    let [least, higher @ ..] = trade_off.meshes() else {
        return formula(domain, progress);
    };
    let is_much = |exact: &&exact::ExactMesh| exact.min_angle >= MUCH * least.min_angle;
    let higher_degree = higher
        .iter()
        .find(is_much)
        .map(|exact| HigherDegree { max_degree: exact.max_degree, min_angle: exact.min_angle });
    Ok(Meshed { higher_degree, ..Meshed::of(&trade_off, 0) })
}

fn formula(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    Ok(Meshed {
        mesh: BoundaryMesh::of_formula(domain, progress)?,
        least_max_degree: mindeg_core::least_max_degree(convex(domain)?),
        found_by: FoundBy::Formula,
        delaunay_min_angle: None,
        higher_degree: None,
    })
}

fn max_degree(domain: &Domain, limit: u32, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    /// The shares of Delaunay's angle that windows try to keep, in this order.
    const SHARES: [f64; 4] = [0.95, 0.75, 0.4, 0.0];
    let least_max_degree = exact::least_max_degree(domain, progress)?;
    if domain.rings().vertex_count() <= MAX_VERTICES {
        return Ok(Meshed {
            mesh: exact::mesh(domain, limit, progress)?.mesh,
            least_max_degree,
            found_by: FoundBy::Search,
            delaunay_min_angle: None,
            higher_degree: None,
        });
    }
    if limit < least_max_degree {
        return Err(mindeg_exact::Unsolved::Infeasible {
            max_degree: limit,
            least: least_max_degree,
        }
        .into());
    }
    let delaunay = Delaunay::new(domain, progress)?;
    for share in SHARES {
        let windowed = delaunay.windows(share, limit, progress)?;
        if windowed.mesh.max_total_degree() <= limit {
            return Ok(windowed);
        }
    }
    // What no window reaches, as round a dominant side, the formula does.
    formula(domain, progress)
}

/// How many chords join vertices that are not on one side, times the least maximum degree. O(k).
fn work(boundary: &Boundary) -> u64 {
    let pairs = |vertices: u64| vertices * (vertices - 1) / 2;
    let on_sides: u64 = boundary.sides().map(|intervals| pairs(u64::from(intervals) + 1)).sum();
    let chords = pairs(boundary.vertex_count().into()) - on_sides;
    chords.saturating_mul(mindeg_core::least_max_degree(boundary).into())
}
