//! Where triangles fail to be a triangulation: what the checker found, in words that help.
//!
//! The checker decides; this only looks for the first place to name.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_exact::check::is_passed;
use mindeg_mesh::Progress;
use mindeg_mesh::check::CheckError;
use mindeg_mesh::planar::PlanarBoundary;
use robust::{Coord, orient2d};

use super::defect::{FaultyEdge, FaultyTriangle, MeshDefect};
use crate::boundary_mesh::first_flat;
use crate::posed::Posed;

/// The number of open edges among which the most telling one is chosen.
const MOST_OPEN: usize = 100;

/// The sign of twice the area of a triangle, exactly.
fn orientation(points: &[DVec2], triangle: [u32; 3]) -> f64 {
    let [a, b, c] = triangle.map(|v| points[v as usize]).map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, c)
}

/// Whether some triangle is clockwise and no triangle is counter-clockwise.
pub(super) fn all_clockwise(points: &[DVec2], triangles: &[[u32; 3]]) -> bool {
    let mut areas = triangles.iter().map(|&triangle| orientation(points, triangle));
    areas.clone().any(|area| area < 0.0) && areas.all(|area| area <= 0.0)
}

/// The first triangle with all vertices on one straight run of the boundary.
pub(super) fn flat_triangle(boundary: &PlanarBoundary, triangles: &[[u32; 3]]) -> Option<usize> {
    first_flat(boundary, triangles).map(|index| index as usize)
}

/// The first triangle of boundary points with a chord that passes the third one: the chord and that point.
///
/// In a convex domain no chord passes a vertex but those of a side. A domain may be too thin for the
/// tolerance.
pub(super) fn passing_triangle(
    domain: &Domain,
    points: &[DVec2],
    triangles: &[[u32; 3]],
) -> Option<(usize, [u32; 2], u32)> {
    let rings = domain.rings();
    if domain.convex().is_some() {
        return None;
    }
    let passing = |(index, &[a, b, c]): (usize, &[u32; 3])| {
        let is_passing = |&([from, to], vertex): &([u32; 2], u32)| {
            from.max(to).max(vertex) < rings.vertex_count()
                && rings.next(from) != to
                && is_passed(points[vertex as usize], [from, to].map(|v| points[v as usize]))
        };
        let found = [([a, b], c), ([b, c], a), ([c, a], b)].into_iter().find(is_passing);
        found.map(|(chord, vertex)| (index, chord, vertex))
    };
    let found = triangles.iter().enumerate().find_map(passing)?;
    // Without a problem nobody knows; then the tolerance holds.
    let posed = Posed::new(domain, Progress::NONE);
    posed.map_or(true, |posed| posed.problem.keeps_clear()).then_some(found)
}

/// A mesh that failed.
pub(super) struct Search<'a> {
    pub(super) domain: &'a Domain,
    pub(super) boundary: &'a PlanarBoundary,
    pub(super) points: &'a [DVec2],
    pub(super) vertex_of: &'a [u32],
}

impl Search<'_> {
    /// The first defect in the order of [`MeshDefect`]; without one, the checker's message.
    pub(super) fn first_defect(
        &self,
        triangles: &[[u32; 3]],
        checker: Option<CheckError>,
    ) -> MeshDefect {
        self.repeated_vertex(triangles)
            .or_else(|| self.repeated_triangle(triangles))
            .or_else(|| self.without_area(triangles))
            .or_else(|| self.turned_over(triangles))
            .or_else(|| self.edges(triangles))
            .or_else(|| checker.map(MeshDefect::Check))
            .expect("the checker failed, or a triangle is flat")
    }

    fn triangle(&self, triangles: &[[u32; 3]], index: usize) -> FaultyTriangle {
        let corners = triangles[index];
        let sum: DVec2 = corners.iter().map(|&v| self.points[v as usize]).sum();
        let vertices = corners.map(|v| self.vertex_of[v as usize]);
        FaultyTriangle { index, vertices, center: sum / 3.0 }
    }

    fn edge(&self, ends: [u32; 2]) -> FaultyEdge {
        let [a, b] = ends.map(|v| self.points[v as usize]);
        // As far from the line as a vertex may be from its position.
        let slack = 1e-6 * a.distance(b);
        let is_on_it = |&v: &u32| {
            let p = self.points[v as usize];
            let is_between = (p - a).dot(b - a) > 0.0 && (p - b).dot(a - b) > 0.0;
            is_between && (b - a).perp_dot(p - a).abs() <= slack * a.distance(b)
        };
        let on_it = (0..self.points.len() as u32).find(is_on_it);
        FaultyEdge {
            ends: ends.map(|v| self.vertex_of[v as usize]),
            middle: (a + b) / 2.0,
            vertex_on_it: on_it.map(|v| self.vertex_of[v as usize]),
        }
    }

    fn side(&self, vertex: u32) -> String {
        self.domain.side_name(self.domain.rings().side_of(vertex))
    }

    fn repeated_vertex(&self, triangles: &[[u32; 3]]) -> Option<MeshDefect> {
        let is_repeated = |[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        let index = triangles.iter().position(is_repeated)?;
        Some(MeshDefect::RepeatedVertex(self.triangle(triangles, index)))
    }

    fn repeated_triangle(&self, triangles: &[[u32; 3]]) -> Option<MeshDefect> {
        let mut sorted: Vec<([u32; 3], usize)> = triangles
            .iter()
            .enumerate()
            .map(|(index, &corners)| {
                let mut corners = corners;
                corners.sort_unstable();
                (corners, index)
            })
            .collect();
        sorted.sort_unstable();
        let pairs = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let (first, second) =
            pairs.map(|pair| (pair[0].1, pair[1].1)).min_by_key(|&(_, second)| second)?;
        let triangle = self.triangle(triangles, second);
        Some(MeshDefect::RepeatedTriangle { triangle, first })
    }

    fn without_area(&self, triangles: &[[u32; 3]]) -> Option<MeshDefect> {
        if let Some(index) = flat_triangle(self.boundary, triangles) {
            let mut corners = triangles[index];
            corners.sort_unstable();
            let side = Some(self.side(corners[1]));
            return Some(MeshDefect::NoArea { triangle: self.triangle(triangles, index), side });
        }
        if let Some((index, chord, vertex)) = passing_triangle(self.domain, self.points, triangles)
        {
            let [from, to, vertex] =
                [chord[0], chord[1], vertex].map(|v| self.vertex_of[v as usize]);
            let triangle = self.triangle(triangles, index);
            return Some(MeshDefect::Passes { triangle, chord: [from, to], vertex });
        }
        let index = triangles.iter().position(|&t| orientation(self.points, t) == 0.0)?;
        Some(MeshDefect::NoArea { triangle: self.triangle(triangles, index), side: None })
    }

    /// The first triangle of those that are fewer.
    fn turned_over(&self, triangles: &[[u32; 3]]) -> Option<MeshDefect> {
        let is_clockwise = |&triangle: &[u32; 3]| orientation(self.points, triangle) < 0.0;
        let clockwise = triangles.iter().filter(|triangle| is_clockwise(triangle)).count();
        if clockwise == 0 {
            return None;
        }
        let are_fewer = 2 * clockwise <= triangles.len();
        let index = triangles.iter().position(|triangle| is_clockwise(triangle) == are_fewer)?;
        Some(MeshDefect::TurnedOver(self.triangle(triangles, index)))
    }

    /// Two triangles on one side of an edge, one outside, or an edge without a triangle.
    fn edges(&self, triangles: &[[u32; 3]]) -> Option<MeshDefect> {
        let rings = self.domain.rings();
        let boundary_count = rings.vertex_count();
        let is_boundary =
            |[from, to]: [u32; 2]| from.max(to) < boundary_count && rings.next(from) == to;
        let mut triangle_of = BTreeMap::new();
        for (index, &[a, b, c]) in triangles.iter().enumerate() {
            for edge in [[a, b], [b, c], [c, a]] {
                if let Some(first) = triangle_of.insert(edge, index) {
                    let triangles = [first, index];
                    return Some(MeshDefect::Overlap { triangles, edge: self.edge(edge) });
                }
            }
        }
        let outside = triangle_of.iter().find(|&(&[from, to], _)| is_boundary([to, from]));
        if let Some((&[_, to], &index)) = outside {
            let triangle = self.triangle(triangles, index);
            return Some(MeshDefect::Outside { triangle, side: self.side(to) });
        }
        let boundary = (0..boundary_count).map(|from| [from, rings.next(from)]);
        if let Some(edge) = boundary.into_iter().find(|edge| !triangle_of.contains_key(edge)) {
            let side = self.side(edge[0]);
            return Some(MeshDefect::OpenBoundary { edge: self.edge(edge), side });
        }
        let open =
            |edge: [u32; 2]| !is_boundary(edge) && !triangle_of.contains_key(&[edge[1], edge[0]]);
        let open = triangle_of.iter().filter(|&(&edge, _)| open(edge)).take(MOST_OPEN);
        let mut open = open.map(|(&edge, &triangle)| (triangle, self.edge(edge)));
        let first = open.next()?;
        // Of the edges round a gap, the one that a vertex lies on says most.
        let has_vertex = |(_, edge): &(usize, FaultyEdge)| edge.vertex_on_it.is_some();
        let telling = if has_vertex(&first) { None } else { open.find(has_vertex) };
        let (triangle, edge) = telling.unwrap_or(first);
        Some(MeshDefect::Open { triangle, edge })
    }
}
