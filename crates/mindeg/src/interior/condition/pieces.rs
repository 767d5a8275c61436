//! The sides and lines of a boundary before and after it is conditioned.

use std::ops::Range;

use glam::DVec2;
use mindeg_condition::{Conditioned, Point};
use mindeg_domain::{Domain, Inside, Outline, Ring, Side, first_names};
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::PlanarBoundary;

/// How the sides of a conditioned boundary are described.
#[derive(Clone, Copy)]
pub(super) enum Sides {
    /// As they were, where all their points are.
    KeptWhereTheyStay,
    /// By their points.
    OfPoints,
}

/// The edges of a boundary with the sides and lines that they are of.
pub(super) struct Pieces<'a> {
    domain: &'a Domain,
    boundary: &'a PlanarBoundary,
    /// The line, the side and the first edge of that side, of each edge of lines.
    of_lines: Vec<(usize, &'a Side, u32)>,
    /// The first edge of each line, then the number of edges.
    starts: Vec<u32>,
}

impl<'a> Pieces<'a> {
    pub(super) fn new(domain: &'a Domain, boundary: &'a PlanarBoundary) -> Self {
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

    pub(super) fn name(&self, edge: u32) -> String {
        match self.of_line(edge) {
            Some((line, side, _)) => self.domain.line_name(line, side),
            None => self.domain.side_name(self.domain.rings().side_of(edge)),
        }
    }

    pub(super) fn told(&self, edge: u32) -> (&'a Option<String>, Option<LineKind>) {
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
    pub(super) fn before(&self, edge: u32) -> Option<u32> {
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
    pub(super) fn check_names(&self, names: &[String]) -> Result<(), String> {
        let known = Domain::names_of(std::slice::from_ref(self.domain));
        let Some(wrong) = names.iter().find(|name| !known.contains(name)) else { return Ok(()) };
        let known = first_names(&known);
        Err(format!("there is no side {wrong:?} to keep; the domain has {known}"))
    }

    /// The domain with the new rings and lines.
    pub(super) fn rebuilt(
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
