//! A domain whose boundary lets a mesh with points inside reach a given angle.

use std::collections::BTreeSet;
use std::ops::Range;

use glam::DVec2;
use mindeg_condition::{BoundaryDemands, Conditioned, Hold, Point, condition_map};
use mindeg_domain::{Domain, Inside, Outline, Ring, Side, first_names};
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::PlanarBoundary;

use crate::error::MeshError;

/// Changes a domain's boundary, and the lines inside it, by as little as it takes for the limit of its minimum angle to reach the
/// demanded angle. A border between two regions is changed once, for both.
///
/// Corners where the name or the kind of sides changes are not dropped, only cut where they are too sharp. The sides and lines
/// with a name of `kept` keep all their points. Other corners may go; the sides that met there are one side then, with the
/// settings of the first. Points inside, and places where lines meet or end, stay.
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
/// let (domain, conditioned) = condition(&strait, &BoundaryDemands::default(), &[])?;
/// assert!(conditioned.before < 6.0 && conditioned.after >= 25.0);
/// assert!(interior::angle_limit(&domain, &Interior::default())?.min_angle >= 25.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn condition(
    domain: &Domain,
    demands: &BoundaryDemands,
    kept: &[String],
) -> Result<(Domain, Conditioned), MeshError> {
    let on_box = Domain::edges_on_box(std::slice::from_ref(domain)).concat();
    condition_beside(domain, demands, kept, &on_box, &[])
}

/// [`condition`] of several domains that lie beside each other, such as islands: none gets into another.
///
/// # Errors
///
/// [`MeshError::Refused`], with the index of the domain.
pub fn condition_all(
    domains: &[Domain],
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
        let (new, conditioned) = condition_beside(domain, demands, kept, &on_box[index], &near)
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
    let found = condition_map(&boundary, demands, hold, has_domain, is_on_box, &marks);
    let found = found.map_err(|error| refused(&error))?;
    let rebuilt = |how| pieces.rebuilt(&found, how).map_err(|error| refused(&error));
    let kept = rebuilt(Sides::KeptWhereTheyStay).ok();
    let new = match kept.filter(|(new, points)| has_points(new, points)) {
        Some((new, _)) => new,
        None => rebuilt(Sides::OfPoints)?.0,
    };
    Ok((new, found))
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

/// How the sides of a conditioned boundary are described.
#[derive(Clone, Copy)]
enum Sides {
    /// As they were, where all their points are.
    KeptWhereTheyStay,
    /// By their points.
    OfPoints,
}

/// The edges of a boundary with the sides and lines that they are of.
struct Pieces<'a> {
    domain: &'a Domain,
    boundary: &'a PlanarBoundary,
    /// The line, the side and the first edge of that side, of each edge of lines.
    of_lines: Vec<(usize, &'a Side, u32)>,
    /// The first edge of each line, then the number of edges.
    starts: Vec<u32>,
}

impl<'a> Pieces<'a> {
    fn new(domain: &'a Domain, boundary: &'a PlanarBoundary) -> Self {
        let on_rings = boundary.vertex_count();
        let (mut of_lines, mut starts) = (Vec::new(), vec![on_rings]);
        for (line, side, segments) in domain.line_sides() {
            starts.resize(line + 2, on_rings + segments.end);
            starts[line + 1] = on_rings + segments.end;
            let first = on_rings + segments.start;
            of_lines.extend(segments.map(|_| (line, side, first)));
        }
        Self { domain, boundary, of_lines, starts }
    }

    fn of_line(&self, edge: u32) -> Option<(usize, &'a Side, u32)> {
        let segment = edge.checked_sub(self.boundary.vertex_count())?;
        Some(self.of_lines[segment as usize])
    }

    fn side(&self, edge: u32) -> &'a Side {
        match self.of_line(edge) {
            Some((_, side, _)) => side,
            None => &self.domain.sides()[self.domain.rings().side_of(edge)],
        }
    }

    fn name(&self, edge: u32) -> String {
        match self.of_line(edge) {
            Some((line, side, _)) => self.domain.line_name(line, side),
            None => self.domain.side_name(self.domain.rings().side_of(edge)),
        }
    }

    fn told(&self, edge: u32) -> (&'a Option<String>, Option<LineKind>) {
        let side = self.side(edge);
        (&side.name, side.kind)
    }

    /// The kind that an edge is told to have on a ring: an island that joined the outer one is land.
    fn told_on(&self, is_outer: bool, edge: u32) -> (Option<&'a str>, Option<LineKind>) {
        match self.told(edge) {
            (name, Some(LineKind::Island)) if is_outer => {
                let is_plain = name.as_deref() == Some("island");
                let name = if is_plain { Some("land") } else { name.as_deref() };
                (name, Some(LineKind::Land))
            }
            (name, kind) => (name.as_deref(), kind),
        }
    }

    /// The edge before one on its ring or line.
    fn before(&self, edge: u32) -> Option<u32> {
        let Some((line, ..)) = self.of_line(edge) else {
            return Some(self.boundary.previous(edge));
        };
        let is_closed = !self.domain.inside().lines[line].is_open();
        let around = self.starts[line + 1] - 1;
        match edge == self.starts[line] {
            true => is_closed.then_some(around),
            false => Some(edge - 1),
        }
    }

    /// Whether a side begins with an edge.
    fn begins(&self, edge: u32) -> bool {
        match self.of_line(edge) {
            Some((_, _, first)) => edge == first,
            None => self.domain.rings().is_corner(edge),
        }
    }

    /// The reason why a name is refused: nothing is called so.
    fn check_names(&self, names: &[String]) -> Result<(), String> {
        let known = Domain::names_of(std::slice::from_ref(self.domain));
        let Some(wrong) = names.iter().find(|name| !known.contains(name)) else { return Ok(()) };
        let known = first_names(&known);
        Err(format!("there is no side {wrong:?} to keep; the domain has {known}"))
    }

    /// The domain with the new rings and lines.
    fn rebuilt(
        &self,
        found: &Conditioned,
        how: Sides,
    ) -> Result<(Domain, Vec<DVec2>), mindeg_domain::DomainError> {
        let mut places = Vec::new();
        let mut all = Vec::new();
        for (index, ring) in found.rings.iter().enumerate() {
            let (ring, own) = self.ring_of(ring, true, index == 0, how);
            places.extend(own);
            all.push(ring);
        }
        let mut rings = all.into_iter();
        let Ring { corners, sides } = rings.next().unwrap_or_default();
        let lines = found.lines.iter().zip(&self.domain.inside().lines);
        let inside = Inside {
            lines: lines
                .map(|(points, line)| self.ring_of(points, !line.is_open(), false, how).0)
                .collect(),
            ..self.domain.inside().clone()
        };
        let new = Domain::builder(Outline::Polygon(corners), sides).inside(inside);
        let new = rings.fold(new, mindeg_domain::DomainBuilder::hole).build()?;
        let new = match self.domain.name() {
            Some(name) => new.named(name)?,
            None => new,
        };
        let new = new.with_projection(self.domain.projection().copied());
        let new = match self.domain.interior() {
            Some(interior) => new.with_interior(interior.clone()),
            None => new,
        };
        Ok((new, places))
    }

    /// A conditioned ring or line with its sides, from the first corner that is left, and its points in order.
    fn ring_of(
        &self,
        points: &[Point],
        is_closed: bool,
        is_outer: bool,
        how: Sides,
    ) -> (Ring, Vec<DVec2>) {
        // A corner that was cut off leaves its sides to the points beside it.
        let is_corner = |at: usize| {
            let (point, before) = (&points[at], &points[(at + points.len() - 1) % points.len()]);
            point.of.is_some() && self.begins(point.edge)
                || self.told_on(is_outer, point.edge) != self.told_on(is_outer, before.edge)
        };
        let first = match is_closed {
            true => (0..points.len()).find(|at| is_corner(*at)).unwrap_or(0),
            false => 0,
        };
        let order = (0..points.len()).map(|step| points[(first + step) % points.len()].at);
        let (mut ring, order) = (Ring::default(), order.collect());
        let mut inner: Vec<Vec<DVec2>> = Vec::new();
        let mut edges: Vec<u32> = Vec::new();
        for step in 0..points.len() {
            let at = (first + step) % points.len();
            let point = &points[at];
            if !is_closed && step + 1 == points.len() {
                ring.corners.push(point.at);
            } else if step > 0 && !is_corner(at) {
                // The first point is a corner, so there is a side.
                inner.last_mut().into_iter().for_each(|side| side.push(point.at));
            } else {
                ring.corners.push(point.at);
                inner.push(Vec::new());
                edges.push(point.edge);
                let (name, kind) = self.told_on(is_outer, point.edge);
                let name = name.map(str::to_owned);
                ring.sides.push(Side { name, kind, ..Side::count(1) });
            }
        }
        for (at, points) in inner.into_iter().enumerate() {
            let end = ring.corners.get(at + 1).copied().or_else(|| ring.corners.first().copied());
            let ends = [Some(ring.corners[at]), end];
            let side = &mut ring.sides[at];
            let as_it_was = match how {
                Sides::KeptWhereTheyStay => self.unchanged(edges[at], side, ends, &points),
                Sides::OfPoints => None,
            };
            *side = as_it_was.unwrap_or_else(|| Side {
                name: side.name.take(),
                kind: side.kind,
                ..Side::points(points)
            });
        }
        (ring, order)
    }

    /// The side that begins with an edge, with its law and its curve, if it has these points, its ends first.
    fn unchanged(
        &self,
        edge: u32,
        told: &Side,
        ends: [Option<DVec2>; 2],
        inner: &[DVec2],
    ) -> Option<Side> {
        let old = self.side(edge);
        if (&old.name, old.kind) != (&told.name, told.kind) || old.matches.is_some() {
            return None;
        }
        let edges = self.edges_of(edge);
        let last = edges.clone().next_back()?;
        let starts = edges.clone().map(|edge| self.boundary.ends(edge)[0]);
        let vertices = starts.chain([self.boundary.ends(last)[1]]);
        let was = vertices.map(|vertex| self.boundary.point(vertex));
        let is = ends[0].into_iter().chain(inner.iter().copied()).chain(ends[1]);
        let is_same = edge == edges.start && edges.len() == inner.len() + 1 && was.eq(is);
        is_same.then(|| old.clone())
    }

    /// The edges of the side that an edge is of.
    fn edges_of(&self, edge: u32) -> Range<u32> {
        let Some((line, _, first)) = self.of_line(edge) else {
            let (rings, side) = (self.domain.rings(), self.domain.rings().side_of(edge));
            return rings.corner(side)..rings.corner(side) + rings.intervals(side);
        };
        let of_side = &self.of_lines[(first - self.boundary.vertex_count()) as usize..];
        let own = of_side.iter().take_while(|other| (other.0, other.2) == (line, first));
        first..first + own.count() as u32
    }
}
