//! A domain whose boundary lets a mesh with points inside reach a given angle.

use crate::error::MeshError;
use mindeg_condition::{BoundaryDemands, Conditioned, Hold, Point, condition as conditioned};
use mindeg_domain::{Domain, Ring, Side};

/// Changes a domain's boundary by as little as it takes for the limit of its minimum angle to reach the demanded angle.
///
/// Corners where the name or the kind of sides changes are not dropped, only cut where they are too sharp. The sides of `kept`, by their indices, keep all their
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
    let told = |side: usize| {
        let side = &domain.sides()[side];
        (&side.name, side.kind)
    };
    let hold = |vertex: u32| {
        let side = rings.side_of(vertex);
        let before = rings.is_corner(vertex).then(|| rings.previous_side(side));
        match before {
            _ if kept.contains(&side) => Hold::Edge,
            Some(before) if kept.contains(&before) => Hold::Point,
            Some(before) if told(before) != told(side) => Hold::Corner,
            _ => Hold::Free,
        }
    };
    let found = conditioned(&boundary, demands, hold).map_err(|error| refused(&error))?;
    let of_ring = |ring: &Vec<Point>| ring_of(domain, ring);
    let new = Domain::of_rings(found.rings.iter().map(of_ring).collect());
    let new = new.map_err(|error| refused(&error))?;
    let new = match domain.name() {
        Some(name) => new.named(name).map_err(|error| refused(&error))?,
        None => new,
    };
    let new = new.with_projection(domain.projection().copied());
    let new = match domain.interior() {
        Some(interior) => new.with_interior(interior.clone()),
        None => new,
    };
    Ok((new, found))
}

/// A conditioned ring with the sides of the domain, from the first corner that is left.
fn ring_of(domain: &Domain, points: &[Point]) -> Ring {
    let rings = domain.rings();
    let told = |point: &Point| {
        let side = &domain.sides()[rings.side_of(point.edge)];
        (&side.name, side.kind)
    };
    // A corner that was cut off leaves its sides to the points beside it.
    let is_corner = |at: usize| {
        let (point, before) = (&points[at], &points[(at + points.len() - 1) % points.len()]);
        point.of.is_some_and(|vertex| rings.is_corner(vertex)) || told(point) != told(before)
    };
    let first = (0..points.len()).find(|at| is_corner(*at)).unwrap_or(0);
    let mut ring = Ring::default();
    let mut inner: Vec<Vec<glam::DVec2>> = Vec::new();
    for step in 0..points.len() {
        let at = (first + step) % points.len();
        let point = &points[at];
        if step > 0 && !is_corner(at) {
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
