//! The result of an inspection, in the words of its JSON, which `docs/inspect.md` explains.

mod polygon;

pub use polygon::OutlinePolygon;

use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::quality::{DegreeHistogram, Distribution, WorstTriangle, WorstTriangles};
use mindeg_core::{Boundary, least_max_degree};
use mindeg_mesh::TriMesh;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// The result of `mindeg inspect --json`, and of `mindeg.inspect` in Python. Angles are in degrees; vertices,
/// faces and triangles have indices from 0.
#[derive(Debug, Serialize)]
pub struct InspectionReport {
    /// The file, or null for a mesh from memory.
    pub file: Option<String>,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Vertices at the place of one before them, taken as that one.
    pub welded_vertices: usize,
    /// Triangles, those that polygons were cut into among them.
    pub triangles: usize,
    /// Faces with four corners.
    pub quads: u64,
    /// Faces with more corners.
    pub polygons: u64,
    /// Line segments.
    pub line_segments: u64,
    /// Points that stand alone.
    pub points: u64,
    /// The parts of the file that the reader left out.
    pub not_read: Vec<String>,
    /// Faces: a polygon is one.
    pub faces: usize,
    /// Edges of faces.
    pub edges: usize,
    /// Edges with a face on one side alone.
    pub boundary_edges: usize,
    /// Closed loops of boundary edges.
    pub boundary_loops: usize,
    /// Runs of boundary edges that do not close.
    pub open_boundaries: usize,
    /// Pieces that share no vertex.
    pub components: usize,
    /// Vertices - edges + faces.
    pub euler_characteristic: i64,
    /// Whether every edge has a face on either side.
    pub closed: bool,
    /// Whether no edge has three faces, and the faces at every vertex are one fan.
    pub manifold: bool,
    /// The number of handles of a mesh that is closed, manifold and consistently wound; null of any other.
    pub genus: Option<u64>,
    /// The volume inside; null where `genus` is.
    pub volume: Option<f64>,
    /// Edges with more than two faces.
    pub non_manifold_edges: Vec<[u32; 2]>,
    /// Vertices whose faces are several fans.
    pub non_manifold_vertices: Vec<u32>,
    /// Edges that both of their faces run along in the same direction.
    pub inconsistent_edges: Vec<[u32; 2]>,
    /// Faces with the vertices of one before them.
    pub duplicate_faces: Vec<u32>,
    /// The first triangle of each of these.
    pub duplicate_triangles: Vec<u32>,
    /// Triangles without an area.
    pub zero_area_triangles: Vec<u32>,
    /// Vertices that no face has.
    pub unreferenced_vertices: Vec<u32>,
    /// The greatest number of edges at a vertex.
    pub max_degree: u32,
    /// How many vertices have each degree.
    pub degree_histogram: DegreeCounts,
    /// Vertices of a degree above a limit.
    pub poles: Vec<Pole>,
    /// The sum of the areas.
    pub area: f64,
    /// The minimum angle.
    pub min_angle: f64,
    /// The greatest angle.
    pub max_angle: f64,
    /// How each measure of quality is distributed.
    pub metrics: BTreeMap<&'static str, Distribution>,
    /// The share of triangles with an angle below so many degrees.
    pub share_below_degrees: BTreeMap<u32, f64>,
    /// The triangles with the smallest minimum angles.
    pub worst_triangles: Vec<ThinTriangle>,
    /// The convex outline of a mesh of its vertices.
    pub outline: Option<ConvexOutline>,
    /// Why there is none.
    pub no_outline: Option<String>,
    /// Of a planar mesh of boundary vertices alone that has no convex outline.
    pub polygon: Option<OutlinePolygon>,
}

/// The number of vertices of each degree.
#[derive(Debug, Serialize)]
pub struct DegreeCounts {
    /// Of vertices on the boundary.
    pub boundary: BTreeMap<u32, u64>,
    /// Of the others.
    pub interior: BTreeMap<u32, u64>,
}

/// A vertex of high degree.
#[derive(Debug, Serialize)]
pub struct Pole {
    /// Its index.
    pub vertex: u32,
    /// The number of its edges.
    pub degree: u32,
    /// Whether it is on the boundary.
    pub on_boundary: bool,
    /// Where it is.
    pub position: [f64; 3],
}

/// A triangle with a small angle; angles are in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThinTriangle {
    /// Its index.
    pub triangle: u32,
    /// Its vertices.
    pub vertices: [u32; 3],
    /// Its minimum angle.
    pub min_angle: f64,
    /// Its greatest angle.
    pub max_angle: f64,
}

/// A convex outline.
#[derive(Debug, Serialize)]
pub struct ConvexOutline {
    /// Its corners, counter-clockwise.
    pub corners: Vec<u32>,
    /// The intervals of the side from each corner on.
    pub intervals: Vec<u32>,
    /// The least maximum degree of a mesh of its points.
    pub least_max_degree: u32,
}

impl ThinTriangle {
    /// The worst of some triangles, worst first.
    #[must_use]
    pub fn listed(worst: &WorstTriangles, triangles: &[[u32; 3]]) -> Vec<Self> {
        let described = worst.iter().map(|&WorstTriangle { triangle, quality }| Self {
            triangle,
            vertices: triangles[triangle as usize],
            min_angle: quality.min_angle,
            max_angle: quality.max_angle,
        });
        described.collect()
    }
}

impl InspectionReport {
    /// The result of `inspection` of `mesh` under `options`, and the least degree of its outline.
    ///
    /// O(n) for the report. The least degree of an outline that is not convex takes about a second
    /// at most; where it would take more, it is left out.
    #[must_use]
    pub fn new(
        file: Option<String>,
        mesh: &TriMesh,
        inspection: &Inspection,
        options: &InspectionOptions,
    ) -> Self {
        let others = mesh.non_triangles();
        let quality = &inspection.quality;
        let [min_angle, max_angle] = ["min_angle", "max_angle"].map(|name| quality.metric(name));
        let outline = inspection.outline.as_ref();
        Self {
            file,
            vertices: inspection.vertex_count,
            welded_vertices: inspection.welded_count,
            triangles: inspection.triangle_count,
            quads: others.quads,
            polygons: others.polygons,
            line_segments: others.line_segments,
            points: others.points,
            not_read: mesh.notes().to_vec(),
            faces: inspection.face_count,
            edges: inspection.edge_count,
            boundary_edges: inspection.boundary_edge_count,
            boundary_loops: inspection.boundary_loop_count,
            open_boundaries: inspection.open_boundary_count,
            components: inspection.component_count,
            euler_characteristic: inspection.euler_characteristic,
            closed: inspection.is_closed(),
            manifold: inspection.is_manifold(),
            genus: inspection.genus(),
            volume: inspection.volume,
            non_manifold_edges: inspection.non_manifold_edges.clone(),
            non_manifold_vertices: inspection.non_manifold_vertices.clone(),
            inconsistent_edges: inspection.inconsistent_edges.clone(),
            duplicate_faces: inspection.duplicate_faces.clone(),
            duplicate_triangles: inspection
                .duplicate_faces
                .iter()
                .map(|&face| first_triangle(mesh, face))
                .collect(),
            zero_area_triangles: inspection.zero_area_triangles.clone(),
            unreferenced_vertices: inspection.unreferenced_vertices.clone(),
            max_degree: inspection.max_degree(),
            degree_histogram: DegreeCounts {
                boundary: histogram(&inspection.boundary_degrees),
                interior: histogram(&inspection.interior_degrees),
            },
            poles: inspection
                .poles
                .iter()
                .map(|pole| Pole {
                    vertex: pole.vertex,
                    degree: pole.degree,
                    on_boundary: pole.on_boundary,
                    position: mesh.positions()[pole.vertex as usize].to_array(),
                })
                .collect(),
            area: quality.area,
            min_angle: min_angle.map_or(0.0, |spread| spread.min),
            max_angle: max_angle.map_or(180.0, |spread| spread.max),
            metrics: quality.by_name(),
            share_below_degrees: quality.shares_by_angle(),
            worst_triangles: ThinTriangle::listed(&inspection.worst_triangles, mesh.triangles()),
            outline: outline.ok().and_then(|outline| {
                let counts: Vec<u64> = outline.intervals.iter().copied().map(u64::from).collect();
                Some(ConvexOutline {
                    corners: outline.corners.clone(),
                    intervals: outline.intervals.clone(),
                    least_max_degree: least_max_degree(&Boundary::new(&counts).ok()?),
                })
            }),
            no_outline: outline.err().map(ToString::to_string),
            polygon: polygon::polygon(mesh, inspection, options),
        }
    }
}

/// The first of the triangles that a face was cut into.
fn first_triangle(mesh: &TriMesh, face: u32) -> u32 {
    mesh.polygons().map_or(face, |polygons| polygons.triangle_starts[face as usize])
}

fn histogram(degrees: &DegreeHistogram) -> BTreeMap<u32, u64> {
    degrees.iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::glam::DVec3;
    use mindeg_mesh::Polygons;

    #[test]
    fn a_duplicate_face_is_named_by_its_first_triangle() {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let square = [[0, 1, 2], [0, 2, 3]];
        let report = |mesh: &TriMesh| {
            let options = InspectionOptions::default();
            InspectionReport::new(None, mesh, &Inspection::of(mesh, &options), &options)
        };
        let twice = TriMesh::new(points.clone(), [square, square].concat()).unwrap();
        let found = report(&twice);
        assert_eq!((found.duplicate_faces, found.duplicate_triangles), (vec![2, 3], vec![2, 3]));
        // The same as two faces of four corners.
        let corners = vec![0, 1, 2, 3, 0, 1, 2, 3];
        let found =
            report(&twice.with_polygons(Polygons { triangle_starts: vec![0, 2, 4], corners }));
        assert_eq!((found.duplicate_faces, found.duplicate_triangles), (vec![1], vec![2]));
    }
}
