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

use super::defect::{MeshDefect, STRAIGHT, at};
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
    pub(super) triangles: &'a [[u32; 3]],
}

impl Search<'_> {
    /// The first defect, from those of single triangles to those of edges; without one, the checker's message.
    pub(super) fn first_defect(&self, checker: Option<CheckError>) -> MeshDefect {
        let checked = |error| format!("{error} (vertices by boundary points)");
        self.repeated_vertex()
            .or_else(|| self.repeated_triangle())
            .or_else(|| self.without_area())
            .or_else(|| self.turned_over())
            .or_else(|| self.edges())
            .or_else(|| checker.map(|error| MeshDefect::new("check", checked(error))))
            .expect("the checker failed, or a triangle is flat")
    }

    fn triangle(&self, index: usize) -> String {
        let corners = self.triangles[index];
        let sum: DVec2 = corners.iter().map(|&v| self.points[v as usize]).sum();
        let [a, b, c] = corners.map(|v| self.vertex_of[v as usize]);
        format!("triangle {index} (vertices {a}, {b}, {c}) near {}", at(sum / 3.0))
    }

    fn edge(&self, ends: [u32; 2]) -> String {
        let [a, b] = ends.map(|v| self.points[v as usize]);
        let [from, to] = ends.map(|v| self.vertex_of[v as usize]);
        format!("the edge from vertex {from} to vertex {to} near {}", at((a + b) / 2.0))
    }

    /// A vertex that lies on an edge between its ends.
    fn vertex_on(&self, ends: [u32; 2]) -> Option<u32> {
        let [a, b] = ends.map(|v| self.points[v as usize]);
        // As far from the line as a vertex may be from its position.
        let slack = 1e-6 * a.distance(b);
        let is_on_it = |&v: &u32| {
            let p = self.points[v as usize];
            let is_between = (p - a).dot(b - a) > 0.0 && (p - b).dot(a - b) > 0.0;
            is_between && (b - a).perp_dot(p - a).abs() <= slack * a.distance(b)
        };
        let on_it = (0..self.points.len() as u32).find(is_on_it);
        on_it.map(|v| self.vertex_of[v as usize])
    }

    /// The same in words, after the edge.
    fn and_vertex_on(&self, ends: [u32; 2]) -> String {
        let lies = |vertex| format!("; vertex {vertex} lies on it");
        self.vertex_on(ends).map_or_else(String::new, lies)
    }

    fn side(&self, vertex: u32) -> String {
        self.domain.side_name(self.domain.rings().side_of(vertex))
    }

    fn repeated_vertex(&self) -> Option<MeshDefect> {
        let is_repeated = |[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        let index = self.triangles.iter().position(is_repeated)?;
        let message = format!("{} has two corners in one place", self.triangle(index));
        Some(MeshDefect::new("repeated_vertex", message))
    }

    fn repeated_triangle(&self) -> Option<MeshDefect> {
        let sorted = |(index, mut corners): (usize, [u32; 3])| {
            corners.sort_unstable();
            (corners, index)
        };
        let mut sorted: Vec<_> = self.triangles.iter().copied().enumerate().map(sorted).collect();
        sorted.sort_unstable();
        let pairs = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let (first, second) =
            pairs.map(|pair| (pair[0].1, pair[1].1)).min_by_key(|&(_, second)| second)?;
        let triangle = self.triangle(second);
        let message = format!("{triangle} has the same vertices as triangle {first}");
        Some(MeshDefect::new("repeated_triangle", message))
    }

    fn without_area(&self) -> Option<MeshDefect> {
        let (index, why) = if let Some(index) = flat_triangle(self.boundary, self.triangles) {
            let mut corners = self.triangles[index];
            corners.sort_unstable();
            let side = self.side(corners[1]);
            (index, format!(": all its vertices are on {side}, where {STRAIGHT}"))
        } else if let Some((index, [from, to], vertex)) =
            passing_triangle(self.domain, self.points, self.triangles)
        {
            let [from, to, vertex] = [from, to, vertex].map(|v| self.vertex_of[v as usize]);
            let edge = format!("its edge from {from} to {to}");
            (index, format!(": vertex {vertex} is on {edge}, where {STRAIGHT}"))
        } else {
            let is_flat = |&triangle: &[u32; 3]| orientation(self.points, triangle) == 0.0;
            (self.triangles.iter().position(is_flat)?, String::new())
        };
        let message = format!("{} has no area{why}", self.triangle(index));
        Some(MeshDefect::new("no_area", message))
    }

    /// A clockwise triangle among the others, or a counter-clockwise one if they are fewer.
    fn turned_over(&self) -> Option<MeshDefect> {
        let is_clockwise = |&triangle: &[u32; 3]| orientation(self.points, triangle) < 0.0;
        let clockwise = self.triangles.iter().filter(|triangle| is_clockwise(triangle)).count();
        if clockwise == 0 {
            return None;
        }
        let are_fewer = 2 * clockwise <= self.triangles.len();
        let index = self.triangles.iter().position(|t| is_clockwise(t) == are_fewer)?;
        let triangle = self.triangle(index);
        let message =
            format!("{triangle} is turned over: it runs the other way round than the others");
        Some(MeshDefect::new("turned_over", message))
    }

    /// The first fault of the edges: two triangles on one side, a triangle outside, or a gap.
    fn edges(&self) -> Option<MeshDefect> {
        let rings = self.domain.rings();
        let boundary_count = rings.vertex_count();
        let is_boundary =
            |[from, to]: [u32; 2]| from.max(to) < boundary_count && rings.next(from) == to;
        let mut triangle_of = BTreeMap::new();
        for (index, &[a, b, c]) in self.triangles.iter().enumerate() {
            for edge in [[a, b], [b, c], [c, a]] {
                if let Some(first) = triangle_of.insert(edge, index) {
                    let both = format!("triangles {first} and {index} overlap");
                    let message =
                        format!("{both}: both are on the same side of {}", self.edge(edge));
                    return Some(MeshDefect::new("overlap", message));
                }
            }
        }
        let outside = triangle_of.iter().find(|&(&[from, to], _)| is_boundary([to, from]));
        if let Some((&[_, to], &index)) = outside {
            let (triangle, side) = (self.triangle(index), self.side(to));
            let message = format!("{triangle} is outside the domain, beyond {side}");
            return Some(MeshDefect::new("outside", message));
        }
        let mut boundary = (0..boundary_count).map(|from| [from, rings.next(from)]);
        if let Some(ends) = boundary.find(|edge| !triangle_of.contains_key(edge)) {
            let (edge, side, on_it) =
                (self.edge(ends), self.side(ends[0]), self.and_vertex_on(ends));
            let message = format!("no triangle has {edge}, on {side} of the boundary{on_it}");
            return Some(MeshDefect::new("open_boundary", message));
        }
        let open =
            |edge: [u32; 2]| !is_boundary(edge) && !triangle_of.contains_key(&[edge[1], edge[0]]);
        let mut open = triangle_of.iter().filter(|&(&edge, _)| open(edge)).take(MOST_OPEN);
        let first = open.next()?;
        // A vertex on an open edge tells more.
        let has_vertex = |&(&ends, _): &(&[u32; 2], &usize)| self.vertex_on(ends).is_some();
        let telling = if has_vertex(&first) { None } else { open.find(has_vertex) };
        let (&ends, triangle) = telling.unwrap_or(first);
        let (edge, on_it) = (self.edge(ends), self.and_vertex_on(ends));
        let message =
            format!("triangle {triangle} has no neighbour at {edge}, inside the domain{on_it}");
        Some(MeshDefect::new("open_edge", message))
    }
}
