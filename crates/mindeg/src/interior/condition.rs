//! A domain whose boundary lets a mesh with points inside reach a given angle.

mod pieces;

use std::collections::BTreeSet;

use glam::DVec2;
use mindeg_condition::{BoundaryDemands, Conditioned, Hold, condition_map};
use mindeg_domain::{Domain, Inside, Interior, Size, SizeAt};
use mindeg_interior::{InteriorError, sizes_across, sizes_asked};

use self::pieces::{Pieces, Sides};
use super::posed::Posed;
use crate::error::MeshError;

/// Changes a domain's boundary, and the lines inside it, by as little as it takes for the limit of its minimum angle to reach the
/// demanded angle. A border between two regions is changed once, for both.
///
/// Corners where the name or the kind of sides changes are not dropped, only cut where they are too sharp. The sides and lines
/// with a name of `kept` keep all their points. Other corners may go; the sides that met there are one side then, with the
/// settings of the first. Points inside, and places where lines meet or end, stay. No edge is longer than 4/3 of the size that
/// is `wanted` at its middle; without a least size there, sizes down to an eighth of the demanded one count.
///
/// O(n log n) for n points of the result.
///
/// # Errors
///
/// [`MeshError::Refused`]: demands out of their range, a name that nothing has, a domain with periodic sides or with limits of
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
/// let (domain, conditioned) = condition(&strait, &Interior::default(), &BoundaryDemands::default(), &[])?;
/// assert!(conditioned.before < 6.0 && conditioned.after >= 25.0);
/// assert!(interior::angle_limit(&domain, &Interior::default())?.min_angle >= 25.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn condition(
    domain: &Domain,
    wanted: &Interior,
    demands: &BoundaryDemands,
    kept: &[String],
) -> Result<(Domain, Conditioned), MeshError> {
    let on_box = Domain::edges_on_box(std::slice::from_ref(domain)).concat();
    condition_beside(domain, wanted, demands, kept, &on_box, &[])
}

/// [`condition`] of several domains that lie beside each other, such as islands: none gets into another.
///
/// # Errors
///
/// [`MeshError::Refused`], with the index of the domain.
pub fn condition_all(
    domains: &[Domain],
    wanted: &Interior,
    demands: &BoundaryDemands,
    kept: &[String],
) -> Result<(Vec<Domain>, Vec<Conditioned>), (usize, MeshError)> {
    let all_points = |domain: &Domain| -> Vec<DVec2> {
        domain.placement().points().chain(domain.inner_points().iter().copied()).collect()
    };
    let mut points: Vec<Vec<DVec2>> = domains.iter().map(all_points).collect();
    let mut boxes: Vec<_> = domains.iter().map(|domain| domain.placement().bounds()).collect();
    let on_box = Domain::edges_on_box(domains);
    let mut found: (Vec<Domain>, Vec<Conditioned>) = Default::default();
    for (index, domain) in domains.iter().enumerate() {
        let bounds = boxes[index];
        let is_beside = |other: usize| {
            let other_box = boxes[other];
            other != index
                && other_box.min.cmple(bounds.max).all()
                && other_box.max.cmpge(bounds.min).all()
        };
        let is_near =
            |point: &DVec2| point.cmpge(bounds.min).all() && point.cmple(bounds.max).all();
        let others = points.iter().enumerate().filter(|(other, _)| is_beside(*other));
        let near: Vec<DVec2> =
            others.flat_map(|(_, points)| points).copied().filter(is_near).collect();
        let (new, conditioned) =
            condition_beside(domain, wanted, demands, kept, &on_box[index], &near)
                .map_err(|error| (index, error))?;
        points[index] = all_points(&new);
        boxes[index] = new.placement().bounds();
        found.0.push(new);
        found.1.push(conditioned);
    }
    Ok(found)
}

/// [`condition`] of a domain with edges on a box, in ascending order, beside points that are not to get into the domain, nor out of it.
fn condition_beside(
    domain: &Domain,
    wanted: &Interior,
    demands: &BoundaryDemands,
    kept: &[String],
    on_box: &[u32],
    beside: &[DVec2],
) -> Result<(Domain, Conditioned), MeshError> {
    let refused = |error: &dyn std::fmt::Display| MeshError::Refused(error.to_string());
    if domain.periodic().is_some() {
        let sentence = "a domain with periodic sides cannot be conditioned: leave them out, and match the sides afterwards";
        return Err(refused(&sentence));
    }
    if domain.is_constrained() {
        let sentence = "a domain with limits of degrees cannot be conditioned, since its vertices change: leave the limits out";
        return Err(refused(&sentence));
    }
    let boundary = domain.boundary().map_err(|error| refused(&error))?;
    let pieces = Pieces::new(domain, &boundary);
    pieces.check_names(kept).map_err(|sentence| refused(&sentence))?;
    let place = |point: DVec2| point.to_array().map(f64::to_bits);
    let named: BTreeSet<[u64; 2]> =
        domain.inside().points.iter().map(|point| place(point.at)).collect();
    let is_on_box = |edge: u32| on_box.binary_search(&edge).is_ok();
    let is_projected = domain.projection().is_some();
    let is_named_by_box =
        |edge: u32| is_projected && is_on_box(edge) && pieces.told(edge).1.is_none();
    let hold = |edge: u32| {
        let is_kept = |edge: u32| kept.iter().any(|name| *name == pieces.name(edge));
        let before = pieces.before(edge);
        match before {
            _ if is_kept(edge) => Hold::Edge,
            Some(before) if is_kept(before) => Hold::Point,
            _ if named.contains(&place(boundary.point(boundary.ends(edge)[0]))) => Hold::Point,
            Some(before) if pieces.told(before) == pieces.told(edge) => Hold::Free,
            // A name that the box of degrees gave is no reason to keep a point.
            Some(before) if is_named_by_box(before) && pieces.told(edge) == (&None, None) => {
                Hold::End
            }
            Some(before) if is_named_by_box(edge) && pieces.told(before) == (&None, None) => {
                Hold::End
            }
            Some(_) => Hold::Corner,
            _ => Hold::Free,
        }
    };
    let on_rings = boundary.vertex_count();
    let has_domain = |edge: u32| match domain.faces() {
        Some(faces) => {
            faces.beside[edge as usize].map(|face| face.is_some_and(|face| !domain.is_hole(face)))
        }
        None => [true, edge >= on_rings],
    };
    let regions = domain.inside().regions.iter().map(|region| region.at);
    let marks: Vec<DVec2> = regions.chain(beside.iter().copied()).collect();
    let asked = asked(domain, wanted, demands).map_err(|error| refused(&error))?;
    let size_at = |place: DVec2| asked.as_ref().map_or(f64::INFINITY, |asked| asked(place));
    let found = condition_map(&boundary, demands, hold, has_domain, is_on_box, &size_at, &marks);
    let found = found.map_err(|error| refused(&error))?;
    let rebuilt = |how| pieces.rebuilt(&found, how).map_err(|error| refused(&error));
    let kept = rebuilt(Sides::KeptWhereTheyStay).ok();
    let new = match kept.filter(|(new, points)| has_points(new, points)) {
        Some((new, _)) => new,
        None => rebuilt(Sides::OfPoints)?.0,
    };
    Ok((new, found))
}

/// Sizes that are wanted inside divide edges down to this share of the size of edges, unless there is a least one. Depths near a
/// shore go to 0, and sizes by their slope with them.
const LEAST_ASKED: f64 = 0.125;

/// The sizes that are wanted inside, if there may be any: longer edges of the boundary would keep the mesh from having them.
fn asked(
    domain: &Domain,
    wanted: &Interior,
    demands: &BoundaryDemands,
) -> Result<Option<impl Fn(DVec2) -> f64 + Sync + use<>>, InteriorError> {
    let Inside { points, regions, .. } = domain.inside();
    if *wanted == Interior::default() && points.is_empty() && regions.is_empty() {
        return Ok(None);
    }
    let posed = Posed::new(domain)?;
    let mut options = posed.options(domain, wanted)?;
    let wanted = &mut options.wanted;
    wanted.min_size = wanted.min_size.or(demands.size.map(|size| LEAST_ASKED * size));
    if let Some(across) = wanted.across.take() {
        // Narrower ways are closed.
        let is_wide = |way: &SizeAt| way.size * across >= demands.narrowest;
        let ways = sizes_across(posed.boundary(), across, 0.0).into_iter().filter(is_wide);
        let least = wanted.min_size.unwrap_or(0.0);
        let raised = |way: SizeAt| Size::At(SizeAt { size: way.size.max(least), ..way });
        wanted.sizes.extend(ways.map(raised));
    }
    Ok(Some(sizes_asked(posed.boundary(), &options)))
}

/// Of the extent of a domain, points may be so far from where they were when a side that was read the other way round is written:
/// its law then runs from the other end.
const ROUNDING: f64 = 1e-14;

/// Whether the rings of a domain have these points, in order; bit for bit where lines inside may share them.
fn has_points(domain: &Domain, points: &[DVec2]) -> bool {
    let bounds = domain.placement().bounds();
    let extent = bounds.max.abs().max(bounds.min.abs()).max_element();
    let reach = if domain.is_map() { 0.0 } else { ROUNDING * extent };
    let is_near = |(made, wanted): (DVec2, &DVec2)| made.distance(*wanted) <= reach;
    domain.placement().points().count() == points.len()
        && domain.placement().points().zip(points).all(is_near)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::SizeFrom;

    /// A channel of 20 by 1 between two basins, one with a named end.
    fn basins() -> Domain {
        let text = r#"{"polygon": {"corners": [[0, 0], [8, 0], [8, 4], [28, 4], [28, 0], [36, 0], [36, 9], [28, 9], [28, 5], [8, 5],
            [8, 9], [0, 9]]}, "sides": [S, S, S, S, S, {"intervals": 1, "name": "quay"}, S, S, S, S, S, S]}"#;
        let text = text.replace('S', r#"{"intervals": 1}"#);
        Domain::from_json(&text).unwrap()
    }

    /// The longest edge with its middle in a range of x.
    fn longest(domain: &Domain, range: std::ops::RangeInclusive<f64>) -> f64 {
        let points: Vec<DVec2> = domain.placement().points().collect();
        let edges = points.iter().zip(points.iter().cycle().skip(1));
        let near = edges.filter(|(a, b)| range.contains(&a.midpoint(**b).x));
        near.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    }

    #[test]
    fn edges_are_no_longer_than_the_sizes_wanted_inside() {
        let demands = BoundaryDemands { growth: 0.0, ..BoundaryDemands::of_size(4.0) };
        let made = |wanted: &Interior, demands: &BoundaryDemands| {
            condition(&basins(), wanted, demands, &[]).unwrap().0
        };
        let plain = made(&Interior::default(), &demands);
        assert!(longest(&plain, 12.0..=24.0) > 1.0);
        let across = Interior { across: Some(2.0), ..Interior::default() };
        let narrow = longest(&made(&across, &demands), 12.0..=24.0);
        assert!(narrow <= 4.0 / 3.0 * 0.5 + 1e-9, "{narrow}");
        // An eighth of the size is the least without another one, and edges are halved until they are short enough.
        let many = Interior { across: Some(20.0), ..Interior::default() };
        let least = longest(&made(&many, &demands), 12.0..=24.0);
        assert!((0.25..=4.0 / 3.0 * 0.5 + 1e-9).contains(&least), "{least}");
        let fine = Interior { min_size: Some(0.1), ..many };
        assert!(longest(&made(&fine, &demands), 12.0..=24.0) < 0.2);
        // A channel that is too narrow to stay asks for nothing.
        let all = BoundaryDemands { narrowest: 1.5, ..demands };
        let closed = made(&across, &all);
        assert!(longest(&closed, 0.0..=36.0) > 1.5, "{closed:?}");
        let quay = Size::From(SizeFrom {
            from: vec!["quay".to_owned()],
            size: 0.6,
            growth: None,
            until: None,
        });
        let wanted = Interior { sizes: vec![quay], ..Interior::default() };
        let from_quay = made(&wanted, &demands);
        assert!(longest(&from_quay, 36.0..=36.0) <= 0.8);
        assert!(longest(&from_quay, 0.0..=0.0) > 1.0);
    }
}
