//! The least maximum degree of a planar mesh whose outline is not convex, or has holes.
//!
//! Limits: points are taken as the file has them. Three that rounding may have moved off one line count as
//! on it; where edges are not much longer than rounding, nothing is said.

use mindeg::Progress;
use mindeg::exact::{DegreeAnswer, degree_of_rings};
use mindeg::glam::{DVec2, DVec3};
use mindeg::inspection::{Inspection, InspectionOptions, weld};
use mindeg_mesh::TriMesh;
use serde::Serialize;
use std::ops::Range;

/// Up to this many boundary vertices the outline is looked at.
const MOST_VERTICES: usize = 200_000;

/// Up to this many triples of vertices that see each other, exact work takes about a second.
const MOST_TRIPLES: u64 = 100_000_000;

/// How many times longer than rounding the shortest edge must be.
const CLEAR: f64 = 1000.0;

/// What is known of a planar mesh's outline that is not convex.
#[derive(Debug, Serialize)]
pub struct OutlinePolygon {
    /// Vertices, all of them on its boundary.
    pub vertices: usize,
    /// Holes.
    pub holes: usize,
    /// Null where it is not known: then it is between the next two.
    pub least_max_degree: Option<u32>,
    /// No triangulation has less.
    pub at_least: u32,
    /// One has this.
    pub reached: u32,
}

impl OutlinePolygon {
    /// A sentence on what is known, beside the degree of the mesh.
    #[must_use]
    pub fn text(&self, found: u32) -> String {
        let Self { vertices, holes, at_least, reached, .. } = self;
        let holes = match holes {
            0 => String::new(),
            1 => " with a hole".to_owned(),
            holes => format!(" with {holes} holes"),
        };
        let known = match self.least_max_degree {
            Some(least) => format!("is {least}"),
            None => format!("is between {at_least} and {reached}"),
        };
        format!(
            "All {vertices} vertices are on the boundary of a polygon{holes}. The least maximum degree of \
             triangles for it {known}, where this mesh has {found}."
        )
    }
}

/// The outline of a planar mesh in one piece whose vertices are all on its boundary, unless it is
/// convex.
pub(super) fn polygon(
    mesh: &TriMesh,
    inspection: &Inspection,
    options: &InspectionOptions,
) -> Option<OutlinePolygon> {
    let is_surface = inspection.component_count == 1
        && inspection.open_boundary_count == 0
        && inspection.non_manifold_edges.is_empty()
        && inspection.non_manifold_vertices.is_empty()
        && inspection.inconsistent_edges.is_empty()
        && inspection.interior_degrees.max_degree().is_none()
        && mesh.positions().len() <= MOST_VERTICES;
    if inspection.outline.is_ok() || !is_surface {
        return None;
    }
    let (points, rings) = rings(mesh, options)?;
    let side_of = straight_runs(&points, &rings, mesh.rounding())?;
    let answer = degree_of_rings(&points, &rings, &side_of, MOST_TRIPLES, Progress::NONE).ok()?;
    let DegreeAnswer { reached, at_least, .. } = answer;
    Some(OutlinePolygon {
        vertices: points.len(),
        holes: rings.len() - 1,
        least_max_degree: answer.least_max_degree(),
        at_least,
        reached,
    })
}

/// The boundary loops of a mesh in a plane of constant z, the outer one first and counter-clockwise.
fn rings(mesh: &TriMesh, options: &InspectionOptions) -> Option<(Vec<DVec2>, Vec<Range<u32>>)> {
    let positions = mesh.positions();
    let first = match options.weld {
        Some(tolerance) => weld(positions, tolerance),
        None => (0..positions.len() as u32).collect(),
    };
    let triangles = mesh.triangles().iter().map(|corners| corners.map(|v| first[v as usize]));
    let welded = TriMesh::new(positions.to_vec(), triangles.collect()).ok()?;
    let height = positions.first()?.z;
    let is_flat = |point: &DVec3| (point.z - height).abs() <= mesh.rounding();
    let loops = welded.boundary_loops();
    if !positions.iter().all(is_flat) || !loops.iter().all(|one| one.closed) {
        return None;
    }
    let lines: Vec<Vec<DVec2>> = loops
        .iter()
        .map(|one| {
            one.vertices.iter().map(|&vertex| positions[vertex as usize].truncate()).collect()
        })
        .collect();
    let area = |line: &Vec<DVec2>| {
        let origin = line[0];
        let pairs = line.windows(2).map(|pair| (pair[0] - origin).perp_dot(pair[1] - origin));
        pairs.sum::<f64>()
    };
    let outer = (0..lines.len())
        .max_by(|&a, &b| area(&lines[a]).abs().total_cmp(&area(&lines[b]).abs()))?;
    // Seen from below, a mesh is its mirror image.
    let mirror = DVec2::new(area(&lines[outer]).signum(), 1.0);
    let mut points = Vec::new();
    let mut rings = Vec::new();
    let others = (0..lines.len()).filter(|&line| line != outer);
    for line in [outer].into_iter().chain(others) {
        let start = points.len() as u32;
        points.extend(lines[line].iter().map(|&point| point * mirror));
        rings.push(start..points.len() as u32);
    }
    Some((points, rings))
}

/// For each edge of the rings the straight run that it is on; none if edges are too short to tell.
fn straight_runs(points: &[DVec2], rings: &[Range<u32>], rounding: f64) -> Option<Vec<u32>> {
    let mut runs = vec![0; points.len()];
    let mut run = 0;
    for ring in rings {
        let at = |vertex: u32| points[vertex as usize];
        let next = |vertex: u32| if vertex + 1 == ring.end { ring.start } else { vertex + 1 };
        if ring.clone().any(|v| at(v).distance(at(next(v))) < CLEAR * rounding) {
            return None;
        }
        let is_straight = |b: u32| {
            let a = if b == ring.start { ring.end - 1 } else { b - 1 };
            let (a, b, c) = (at(a), at(b), at(next(b)));
            let height = (b - a).perp_dot(c - a).abs() / c.distance(a);
            (b - a).dot(c - b) > 0.0 && height <= 2.0 * rounding
        };
        let first = ring.clone().find(|&vertex| !is_straight(vertex))?;
        for step in 0..ring.len() as u32 {
            let vertex = ring.start + (first - ring.start + step) % ring.len() as u32;
            run += u32::from(!is_straight(vertex));
            runs[vertex as usize] = run;
        }
    }
    Some(runs)
}
