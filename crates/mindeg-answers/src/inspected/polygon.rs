//! The least maximum degree of a planar mesh whose outline is not convex, or has holes.
//!
//! Limits: the points are those of the file. Three that rounding may have moved off one line count as
//! on it; where edges are not much longer than rounding, nothing is said.

use mindeg::Progress;
use mindeg::exact::{DegreeAnswer, degree_of_boundary};
use mindeg::glam::{DVec2, DVec3};
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg_mesh::TriMesh;
use mindeg_mesh::planar::{PlanarBoundary, doubled_area};
use serde::Serialize;
use std::ops::Range;

/// The most boundary vertices of an outline that is examined.
const MOST_VERTICES: usize = 200_000;

/// Up to this many triples of vertices that see each other, exact work takes about a second.
const MOST_TRIPLES: u64 = 100_000_000;

/// How many times longer than rounding the shortest edge must be.
const CLEAR: f64 = 1000.0;

/// The known facts about a planar mesh's outline that is not convex.
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
    /// A triangulation with this maximum degree exists.
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
    let of_ring = |ring: &Range<u32>| &points[ring.start as usize..ring.end as usize];
    let slices: Vec<&[DVec2]> = rings.iter().map(of_ring).collect();
    let boundary = PlanarBoundary::new(&slices).ok()?.with_sides(Vec::new(), side_of);
    let answer = degree_of_boundary(&boundary, MOST_TRIPLES, Progress::NONE).ok()?;
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
    let welded = options.weld.map(|tolerance| mesh.welded(tolerance));
    let height = positions.first()?.z;
    let is_flat = |point: &DVec3| (point.z - height).abs() <= mesh.rounding();
    let loops = welded.as_ref().unwrap_or(mesh).boundary_loops();
    if !positions.iter().all(is_flat) || !loops.iter().all(|one| one.closed) {
        return None;
    }
    let lines: Vec<Vec<DVec2>> = loops
        .iter()
        .map(|one| {
            one.vertices.iter().map(|&vertex| positions[vertex as usize].truncate()).collect()
        })
        .collect();
    let area = |line: usize| doubled_area(&lines[line]);
    let outer = (0..lines.len()).max_by(|&a, &b| area(a).abs().total_cmp(&area(b).abs()))?;
    // Seen from below, a mesh is its mirror image.
    let mirror = DVec2::new(area(outer).signum(), 1.0);
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

/// For each edge of the rings the straight run that it is on; `None` if edges are too short to tell.
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::slice::from_ref;

    /// An L.
    const BENT: [[f64; 2]; 6] =
        [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

    /// A square hole in a square, its vertices first.
    const FRAME: [[f64; 2]; 8] = [
        [1.0, 1.0],
        [2.0, 1.0],
        [2.0, 2.0],
        [1.0, 2.0],
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [0.0, 3.0],
    ];

    const FRAME_TRIANGLES: [[u32; 3]; 8] =
        [[4, 5, 0], [5, 1, 0], [5, 6, 1], [6, 2, 1], [6, 7, 2], [7, 3, 2], [7, 4, 3], [4, 0, 3]];

    /// A mesh right below the origin, in the plane of height 5.
    fn mesh(points: &[[f64; 2]], triangles: &[[u32; 3]]) -> TriMesh {
        let points = points.iter().map(|[x, y]| DVec3::new(x + 10.0, y - 10.0, 5.0));
        TriMesh::new(points.collect(), triangles.to_vec()).unwrap()
    }

    fn polygon_of(mesh: &TriMesh) -> Option<OutlinePolygon> {
        let options = InspectionOptions::default();
        polygon(mesh, &Inspection::of(mesh, &options), &options)
    }

    /// The triangles as seen from below.
    fn turned(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
        triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect()
    }

    #[test]
    fn an_outline_that_is_not_convex_has_a_least_degree_from_either_side() {
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
        for triangles in [fan.to_vec(), turned(&fan)] {
            let found = polygon_of(&mesh(&BENT, &triangles)).unwrap();
            assert_eq!((found.vertices, found.holes), (6, 0));
            // All chords end at vertex 0 or 3, and a mesh has three of them.
            assert_eq!(found.least_max_degree, Some(4));
        }
        for triangles in [FRAME_TRIANGLES.to_vec(), turned(&FRAME_TRIANGLES)] {
            let found = polygon_of(&mesh(&FRAME, &triangles)).unwrap();
            assert_eq!((found.vertices, found.holes), (8, 1));
            assert_eq!((found.at_least, found.reached), (4, 4));
        }
    }

    #[test]
    fn what_is_no_outline_or_a_convex_one_is_left_out() {
        let square = mesh(&FRAME[..4], &[[0, 1, 2], [0, 2, 3]]);
        assert!(polygon_of(&square).is_none());
        let with_inner = [&BENT[..], &[[0.5, 0.5]]].concat();
        let fan: Vec<[u32; 3]> = (0..6).map(|vertex| [6, vertex, (vertex + 1) % 6]).collect();
        assert!(polygon_of(&mesh(&with_inner, &fan)).is_none());
        // Bent out of its plane.
        let mut points = mesh(&BENT, &[[0, 1, 2]]).positions().to_vec();
        points[5].z += 1.0;
        let bent = TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]);
        assert!(polygon_of(&bent.unwrap()).is_none());
    }

    #[test]
    fn the_outer_ring_comes_first_and_counter_clockwise() {
        let options = InspectionOptions::default();
        let seen = |triangles: &[[u32; 3]]| rings(&mesh(&FRAME, triangles), &options).unwrap();
        let (above, ranges) = seen(&FRAME_TRIANGLES);
        assert_eq!(ranges, [0..4, 4..8]);
        let outer = [[10.0, -10.0], [13.0, -10.0], [13.0, -7.0], [10.0, -7.0]];
        let hole = [[11.0, -9.0], [11.0, -8.0], [12.0, -8.0], [12.0, -9.0]];
        assert_eq!(above, [outer, hole].concat().into_iter().map(DVec2::from).collect::<Vec<_>>());

        // The mirror image, so that it is seen from above.
        let (below, ranges) = seen(&turned(&FRAME_TRIANGLES));
        assert_eq!(ranges, [0..4, 4..8]);
        let outer = [[-10.0, -10.0], [-10.0, -7.0], [-13.0, -7.0], [-13.0, -10.0]];
        let hole = [[-11.0, -9.0], [-12.0, -9.0], [-12.0, -8.0], [-11.0, -8.0]];
        assert_eq!(below, [outer, hole].concat().into_iter().map(DVec2::from).collect::<Vec<_>>());
    }

    /// A square that starts in the middle of a side, and a hole that starts with two points of a side.
    const SIDES: [[f64; 2]; 11] = [
        [2.0, 0.0],
        [4.0, 0.0],
        [4.0, 2.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.75, 1.0],
        [1.25, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [2.0, 1.0],
    ];

    #[test]
    fn edges_on_one_line_are_one_run() {
        let points = SIDES.map(DVec2::from);
        let runs = straight_runs(&points, &[0..6, 6..11], 1e-12).unwrap();
        assert_eq!(runs, [4, 1, 1, 2, 3, 4, 7, 7, 5, 6, 7]);
        // A run that goes back on itself is not straight.
        let spike = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]].map(DVec2::from);
        assert_eq!(straight_runs(&spike, from_ref(&(0..4)), 1e-12).unwrap(), [1, 2, 3, 4]);
    }

    #[test]
    fn rounding_bends_no_run_and_hides_short_edges() {
        let mut points = SIDES.map(DVec2::from);
        points[2].x += 1e-6;
        let runs = |rounding| straight_runs(&points, &[0..6, 6..11], rounding);
        assert_eq!(runs(1e-6).unwrap()[..6], [4, 1, 1, 2, 3, 4]);
        assert_eq!(runs(1e-7).unwrap()[..6], [5, 1, 2, 3, 4, 5]);
        // The shortest edge has a length of 0.25.
        assert!(runs(0.00024).is_some() && runs(0.00026).is_none());
    }
}
