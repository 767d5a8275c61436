//! The findings in the words of the JSON output, which `docs/inspect.md` explains.

use super::polygon::Polygon;
use mindeg::inspection::Inspection;
use mindeg::quality::{ANGLES, DegreeHistogram, Distribution, METRICS};
use mindeg_core::{Boundary, least_max_degree};
use mindeg_mesh::TriMesh;
use serde::Serialize;
use std::collections::BTreeMap;

/// What `--json` prints, and what the text is made of.
#[derive(Serialize)]
pub(super) struct Report {
    pub(super) file: String,
    pub(super) vertices: usize,
    pub(super) welded_vertices: usize,
    pub(super) triangles: usize,
    pub(super) quads: u64,
    pub(super) polygons: u64,
    pub(super) line_segments: u64,
    pub(super) points: u64,
    pub(super) not_read: Vec<String>,
    pub(super) faces: usize,
    pub(super) edges: usize,
    pub(super) boundary_edges: usize,
    pub(super) boundary_loops: usize,
    pub(super) open_boundaries: usize,
    pub(super) components: usize,
    pub(super) euler_characteristic: i64,
    pub(super) closed: bool,
    pub(super) manifold: bool,
    /// Null unless the mesh is closed, manifold and consistently wound; so is `volume`.
    pub(super) genus: Option<u64>,
    pub(super) volume: Option<f64>,
    pub(super) non_manifold_edges: Vec<[u32; 2]>,
    pub(super) non_manifold_vertices: Vec<u32>,
    pub(super) inconsistent_edges: Vec<[u32; 2]>,
    pub(super) duplicate_faces: Vec<u32>,
    pub(super) duplicate_triangles: Vec<u32>,
    pub(super) zero_area_triangles: Vec<u32>,
    pub(super) unreferenced_vertices: Vec<u32>,
    pub(super) max_degree: u32,
    pub(super) degree_histogram: Histograms,
    pub(super) poles: Vec<Pole>,
    pub(super) area: f64,
    pub(super) min_angle: f64,
    pub(super) max_angle: f64,
    pub(super) metrics: BTreeMap<&'static str, Spread>,
    pub(super) share_below_degrees: BTreeMap<u32, f64>,
    pub(super) worst_triangles: Vec<Triangle>,
    pub(super) outline: Option<Outline>,
    pub(super) no_outline: Option<String>,
    /// Of a planar mesh of boundary vertices alone that has no convex outline.
    pub(super) polygon: Option<Polygon>,
}

/// The number of vertices of each degree.
#[derive(Serialize)]
pub(super) struct Histograms {
    pub(super) boundary: BTreeMap<u32, u64>,
    pub(super) interior: BTreeMap<u32, u64>,
}

#[derive(Serialize)]
pub(super) struct Pole {
    pub(super) vertex: u32,
    pub(super) degree: u32,
    pub(super) on_boundary: bool,
    pub(super) position: [f64; 3],
}

/// A distribution; what is infinite is null.
#[derive(Serialize)]
pub(super) struct Spread {
    pub(super) min: f64,
    pub(super) p01: f64,
    pub(super) median: f64,
    pub(super) mean: f64,
    pub(super) p99: f64,
    pub(super) max: f64,
}

#[derive(Serialize)]
pub(super) struct Triangle {
    pub(super) triangle: u32,
    pub(super) vertices: [u32; 3],
    pub(super) min_angle: f64,
    pub(super) max_angle: f64,
}

#[derive(Serialize)]
pub(super) struct Outline {
    pub(super) corners: Vec<u32>,
    pub(super) intervals: Vec<u32>,
    pub(super) least_max_degree: u32,
}

impl Report {
    pub(super) fn new(
        file: String,
        mesh: &TriMesh,
        inspection: &Inspection,
        polygon: Option<Polygon>,
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
            degree_histogram: Histograms {
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
            metrics: METRICS
                .iter()
                .zip(&quality.metrics)
                .map(|(metric, spread)| (metric.name, Spread::from(spread)))
                .collect(),
            share_below_degrees: ANGLES
                .iter()
                .zip(quality.shares_below)
                .map(|(&angle, share)| (angle as u32, share))
                .collect(),
            worst_triangles: inspection
                .worst_triangles
                .iter()
                .map(|worst| Triangle {
                    triangle: worst.triangle,
                    vertices: mesh.triangles()[worst.triangle as usize],
                    min_angle: worst.quality.min_angle,
                    max_angle: worst.quality.max_angle,
                })
                .collect(),
            outline: outline.ok().and_then(|outline| {
                let counts: Vec<u64> = outline.intervals.iter().copied().map(u64::from).collect();
                Some(Outline {
                    corners: outline.corners.clone(),
                    intervals: outline.intervals.clone(),
                    least_max_degree: least_max_degree(&Boundary::new(&counts).ok()?),
                })
            }),
            no_outline: outline.err().map(ToString::to_string),
            polygon,
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

impl From<&Distribution> for Spread {
    fn from(spread: &Distribution) -> Self {
        let Distribution { min, p01, median, mean, p99, max } = *spread;
        Self { min, p01, median, mean, p99, max }
    }
}
