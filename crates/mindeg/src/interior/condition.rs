//! A domain whose boundary lets a mesh with points inside reach a given angle.

use crate::error::MeshError;
use mindeg_condition::{BoundaryDemands, Conditioned, Point, condition as conditioned};
use mindeg_domain::{Domain, Ring, Side};

/// Changes a domain's boundary by as little as it takes for the limit of its minimum angle to reach the demanded angle.
///
/// Corners between sides of which one has a name or a kind stay. The sides of `kept`, by their indices, keep all their
/// points. Other corners may go; the sides that met there are one side then, with the settings of the first.
///
/// O(n log n) for n points of the result.
///
/// # Errors
///
/// [`MeshError::Refused`]: demands out of their range, a domain with lines, points or regions inside or with limits of
/// degrees, or a boundary that rounding makes cross itself.
///
/// # Example
///
/// ```
/// use mindeg::interior::{BoundaryDemands, condition};
/// use mindeg::{Domain, Interior, interior};
///
/// // Two edges half a unit from each other, ten units long.
/// let strait = Domain::from_rings([[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]]])?;
/// let (domain, conditioned) = condition(&strait, &BoundaryDemands::default(), &[])?;
/// assert!(conditioned.before < 6.0 && conditioned.after >= 25.0);
/// assert!(interior::angle_limit(&domain, &Interior::default())?.min_angle >= 25.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn condition(
    domain: &Domain,
    demands: &BoundaryDemands,
    kept: &[usize],
) -> Result<(Domain, Conditioned), MeshError> {
    let refused = |error: &dyn std::fmt::Display| MeshError::Refused(error.to_string());
    if domain.is_map() {
        let sentence = "a domain with lines, points or regions inside cannot be conditioned: condition its outline alone";
        return Err(refused(&sentence));
    }
    if domain.is_constrained() {
        let sentence = "a domain with limits of degrees cannot be conditioned, since its vertices change: leave the limits out";
        return Err(refused(&sentence));
    }
    let rings = domain.rings();
    let boundary = domain.boundary().map_err(|error| refused(&error))?;
    let is_told = |side: usize| {
        let side = &domain.sides()[side];
        side.name.is_some() || side.kind.is_some()
    };
    let is_kept = |vertex: u32| {
        let side = rings.side_of(vertex);
        let sides = [Some(side), rings.is_corner(vertex).then(|| rings.previous_side(side))];
        let mut sides = sides.into_iter().flatten();
        sides.any(|side| kept.contains(&side) || rings.is_corner(vertex) && is_told(side))
    };
    let found = conditioned(&boundary, demands, is_kept).map_err(|error| refused(&error))?;
    let of_ring = |ring: &Vec<Point>| ring_of(domain, ring);
    let new = Domain::of_rings(found.rings.iter().map(of_ring).collect());
    let new = new.map_err(|error| refused(&error))?;
    let new = match domain.name() {
        Some(name) => new.named(name).map_err(|error| refused(&error))?,
        None => new,
    };
    let new = match domain.interior() {
        Some(interior) => new.with_interior(interior.clone()),
        None => new,
    };
    Ok((new, found))
}

/// A conditioned ring with the sides of the domain, from the first corner that is left.
fn ring_of(domain: &Domain, points: &[Point]) -> Ring {
    let rings = domain.rings();
    let is_corner = |point: &Point| point.of.is_some_and(|vertex| rings.is_corner(vertex));
    let first = points.iter().position(is_corner).unwrap_or(0);
    let mut ring = Ring::default();
    let mut inner: Vec<Vec<glam::DVec2>> = Vec::new();
    for (at, point) in points[first..].iter().chain(&points[..first]).enumerate() {
        if at > 0 && !is_corner(point) {
            // The first point is a corner, so there is a side.
            inner.last_mut().into_iter().for_each(|side| side.push(point.at));
            continue;
        }
        let Side { name, kind, .. } = domain.sides()[rings.side_of(point.edge)].clone();
        ring.corners.push(point.at);
        ring.sides.push(Side { name, kind, ..Side::count(1) });
        inner.push(Vec::new());
    }
    for (side, points) in ring.sides.iter_mut().zip(inner) {
        *side = Side { name: side.name.take(), kind: side.kind, ..Side::points(points) };
    }
    ring
}
