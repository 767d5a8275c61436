//! The input of the engine of interior points, from a domain; and its output, as that of the domain.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;

use mindeg_domain::{Domain, Interior, Periodic, Region, Size, SizeAt};
use mindeg_interior::{
    Generated, InteriorError, InteriorReport, JoinedVertices, Options, check_coordinates,
    size_of_area,
};
use mindeg_mesh::TriMesh;
use mindeg_mesh::planar::{Border, PlanarBoundary};

/// The boundary of a domain for the engine: around regions that are holes.
pub(super) struct Posed<'a> {
    /// With all lines.
    pub(super) whole: Cow<'a, PlanarBoundary>,
    /// The border, if a region is a hole.
    border: Option<Border>,
    is_periodic: bool,
}

impl<'a> Posed<'a> {
    /// The boundary, if limits and meshes can be computed.
    pub(super) fn new(domain: &'a Domain) -> Result<Self, InteriorError> {
        let whole = domain.boundary()?;
        check_coordinates(&whole)?;
        Ok(Self { whole, border: domain.border(), is_periodic: domain.periodic().is_some() })
    }

    pub(super) fn boundary(&self) -> &PlanarBoundary {
        self.border.as_ref().map_or(&self.whole, |border| &border.boundary)
    }

    /// The vertex of the domain, or after all of these, that a vertex of the engine is.
    pub(super) fn vertex(&self, vertex: u32) -> u32 {
        let Some(Border { vertices, .. }) = &self.border else { return vertex };
        match vertices.get(vertex as usize) {
            Some(own) => *own,
            None => vertex - vertices.len() as u32 + self.given() as u32,
        }
    }

    /// The edge of the domain's boundary that an edge of the engine's boundary is.
    pub(super) fn edge(&self, edge: u32) -> u32 {
        self.border.as_ref().map_or(edge, |border| border.edges[edge as usize])
    }

    /// The number of the domain's points.
    fn given(&self) -> usize {
        self.whole.points().len() + self.whole.inner_points().len()
    }

    /// The options for the inside of a domain, with its degree limits.
    pub(super) fn options(
        &self,
        domain: &Domain,
        wanted: &Interior,
    ) -> Result<Options, InteriorError> {
        let mut options = Options::from(wanted.clone());
        let divisible = domain.divisible_segments();
        let (boundary, on_rings) = (self.boundary(), self.whole.vertex_count());
        let segments = boundary.vertex_count()..boundary.edge_count();
        let whole = segments.map(|edge| (self.edge(edge) - on_rings) as usize);
        options.divisible = whole.map(|segment| divisible[segment]).collect();
        let sized = domain.inside().points.iter();
        let sizes = sized.filter_map(|point| Some(SizeAt { at: point.at, size: point.size? }));
        options.wanted.sizes.extend(sizes.map(Size::At));
        options.names = self.names(domain);
        if let Some(faces) = domain.faces() {
            options.beside = (0..boundary.edge_count())
                .map(|edge| {
                    let own = self.edge(edge);
                    let [left, right] = faces.beside[own as usize];
                    let is_same = self.whole.ends(own)[0] == self.vertex(boundary.ends(edge)[0]);
                    if is_same { [left, right] } else { [right, left] }
                })
                .collect();
            options.region_sizes = domain.inside().regions.iter().map(size_of_region).collect();
        }
        if let Some(periodic) = domain.periodic() {
            options.join(boundary, self.joined(domain, periodic));
        } else if domain.is_constrained() {
            for vertex in 0..boundary.vertex_count() {
                let own = self.vertex(vertex);
                if own < on_rings
                    && let Some(limit) = domain.degree_limit(own)
                {
                    let limit = limit.saturating_sub(domain.external_degree(own));
                    let edges = 2 * (1 + boundary.twins(vertex).count()) as u32;
                    if edges > limit.max(2) {
                        return Err(InteriorError::DegreeLimit { vertex: own, limit, edges });
                    }
                    options.degree_limits.insert(vertex, self.share(vertex, limit));
                }
            }
        }
        Ok(options)
    }

    /// The engine's vertices that periodic sides make one.
    fn joined(&self, domain: &Domain, periodic: &Periodic) -> Vec<JoinedVertices> {
        let mut of_domain: Vec<(u32, u32)> = (0..self.boundary().vertex_count())
            .map(|vertex| (self.vertex(vertex), vertex))
            .collect();
        of_domain.sort_unstable();
        let limit = |own: &[u32]| {
            let least = own.iter().filter_map(|&vertex| domain.degree_limit(vertex)).min()?;
            let external = own.iter().map(|&vertex| domain.external_degree(vertex)).sum();
            Some(u32::saturating_sub(least, external))
        };
        let joined = periodic.joined().into_iter().map(|own| {
            let from = |vertex: u32| of_domain.partition_point(|(other, _)| *other < vertex);
            let of = |&vertex: &u32| &of_domain[from(vertex)..from(vertex + 1)];
            JoinedVertices {
                vertices: own.iter().flat_map(of).map(|(_, vertex)| *vertex).collect(),
                is_inside: periodic.is_inside(own[0]),
                limit: if domain.is_constrained() { limit(&own) } else { None },
            }
        });
        joined.filter(|one| !one.vertices.is_empty()).collect()
    }

    /// The runs of edges with the names of sides and lines.
    fn names(&self, domain: &Domain) -> Vec<(String, Range<u32>)> {
        let rings = domain.rings();
        let sides = (0..rings.side_count()).map(|side| {
            let start = rings.corner(side);
            (domain.side_name(side), start..start + rings.intervals(side))
        });
        let after = rings.vertex_count();
        let lines = domain
            .inner_lines()
            .into_iter()
            .map(|(line, _)| (line.name, after + line.segments.start..after + line.segments.end));
        let whole = sides.chain(lines);
        let Some(Border { edges, .. }) = &self.border else { return whole.collect() };
        let mut names: Vec<(u32, u32)> = edges.iter().copied().zip(0..).collect();
        names.sort_unstable();
        whole
            .flat_map(|(name, run)| {
                let from = names.partition_point(|(own, _)| *own < run.start);
                let own = names[from..].iter().take_while(move |(own, _)| *own < run.end);
                own.map(move |(_, edge)| (name.clone(), *edge..edge + 1))
            })
            .collect()
    }

    /// The edges that a vertex may have, if all vertices at its point may have so many: two each, and the others one by
    /// one to the sector with the largest angle for each triangle.
    fn share(&self, vertex: u32, limit: u32) -> u32 {
        let boundary = self.boundary();
        let mut sectors: Vec<(u32, u32)> =
            [vertex].into_iter().chain(boundary.twins(vertex)).map(|v| (v, 2)).collect();
        sectors.sort_unstable();
        let wide = |&(v, edges): &(u32, u32)| boundary.angle(v) / f64::from(edges - 1);
        for _ in 2 * sectors.len() as u32..limit {
            let widest = (0..sectors.len())
                .reduce(|a, b| if wide(&sectors[b]) > wide(&sectors[a]) { b } else { a });
            sectors[widest.unwrap_or_default()].1 += 1;
        }
        sectors.iter().find(|sector| sector.0 == vertex).map_or(limit, |sector| sector.1)
    }

    /// A mesh of the engine, whatever its report, with the vertices and lines of the domain.
    pub(super) fn in_domain<R>(&self, found: Generated<R>) -> Generated<R> {
        let Some(Border { vertices, edges, boundary }) = &self.border else { return found };
        let name = |vertex: u32| self.vertex(vertex);
        let points = self.whole.points().iter().chain(self.whole.inner_points());
        let mut pieces = found.line_edges.iter();
        let mut kept = edges[boundary.points().len()..].iter().zip(boundary.segments()).peekable();
        let mut line_edges = Vec::new();
        for (edge, &ends) in (self.whole.vertex_count()..).zip(self.whole.segments()) {
            match kept.next_if(|(own, _)| **own == edge) {
                // At a hole: a boundary edge.
                None => line_edges.push(ends),
                Some((_, [_, end])) => {
                    for piece in pieces.by_ref() {
                        line_edges.push(piece.map(name));
                        if piece[1] == *end {
                            break;
                        }
                    }
                }
            }
        }
        Generated {
            points: points.chain(&found.points[vertices.len()..]).copied().collect(),
            triangles: found.triangles.iter().map(|triangle| triangle.map(name)).collect(),
            line_edges,
            report: found.report,
        }
    }

    /// A report of the engine with the vertices and edges of the domain, and the degrees of its `mesh`.
    pub(super) fn report(&self, report: InteriorReport, mesh: &TriMesh) -> InteriorReport {
        if self.border.is_none() {
            return report;
        }
        let mut report = report.renamed(|vertex| self.vertex(vertex), |edge| self.edge(edge));
        let boundary = self.boundary();
        let touches = |vertex: &u32| boundary.twins(*vertex).next().is_some();
        let on_rings = 0..boundary.vertex_count();
        let touching: BTreeSet<u32> =
            on_rings.clone().filter(touches).map(|vertex| self.vertex(vertex)).collect();
        // The engine counts sector by sector. Periodic sides are joined already.
        if !touching.is_empty() && !self.is_periodic {
            let degrees = mesh.degrees();
            let all = on_rings.map(|vertex| degrees[self.vertex(vertex) as usize]);
            let (least, most) =
                all.fold((u32::MAX, 0), |(low, high), own| (low.min(own), high.max(own)));
            report.boundary_degree = least..=most;
            for violation in
                report.violations.iter_mut().filter(|own| touching.contains(&own.vertex))
            {
                violation.degree = degrees[violation.vertex as usize];
            }
            report.violations.dedup_by_key(|violation| violation.vertex);
        }
        report
    }

    /// An error of the engine with the vertices of the domain.
    pub(super) fn error(&self, error: InteriorError) -> InteriorError {
        match error {
            InteriorError::TargetAboveLimit { target, limit, vertex } => {
                InteriorError::TargetAboveLimit { target, limit, vertex: self.vertex(vertex) }
            }
            error => error,
        }
    }
}

/// The size of a region, infinite where none is wanted.
fn size_of_region(region: &Region) -> f64 {
    let of_area = region.max_area.map_or(f64::INFINITY, size_of_area);
    region.size.map_or(of_area, |size| size.min(of_area))
}
