//! A mesh of a whole model.

use crate::interior::DegreeViolation;
use crate::names::shown;
use crate::numbers::{counted, percent, steady_angle, triangles as triangle_words};
use mindeg::model::{FilledModel, JointBound, ModelMesh};
use mindeg::quality::TriangleQuality;
use mindeg::{Model, ModelPlace};
use mindeg_mesh::{TriMesh, Triangles};
use serde::Serialize;
use std::collections::BTreeSet;

/// How many vertices a text names.
const NAMED: usize = 5;

/// A mesh of a whole model; angles in degrees. Degrees are over all faces.
#[derive(Clone, Debug, Serialize)]
pub struct ModelAnswer {
    name: Option<String>,
    faces: usize,
    edges: usize,
    vertices: usize,
    triangles: u32,
    max_degree: u32,
    min_angle: f64,
    max_angle: f64,
    closed: bool,
    notes: Vec<String>,
    #[serde(flatten)]
    known: Known,
    /// The answer in sentences, without the name of the model.
    #[serde(skip)]
    pub words: String,
}

/// Further facts about a mesh, by its goal.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum Known {
    /// Of boundary points alone.
    Degree {
        /// The maximum degree where that is proven to be the least, else null.
        least_max_degree: Option<u32>,
        /// No mesh from these points has a smaller maximum degree.
        at_least: u32,
        /// "sum", "edges", "side", "refuted" or "weights".
        bounded_by: &'static str,
        /// The vertices of maximum degree.
        worst_vertices: Vec<u32>,
        /// The smallest share that a face has of its Delaunay triangulation's minimum angle; null
        /// without `--keep-angle`.
        share_of_limit: Option<f64>,
        /// By corners.
        boundary_edges: Vec<[u32; 2]>,
        /// By corners: edges with three faces or more.
        non_manifold_edges: Vec<[u32; 2]>,
        groups: Vec<ModelGroup>,
    },
    /// With interior points.
    Filled {
        interior_points: usize,
        /// The vertices off the boundary with other degrees than 5 to 7, and those on it with more than 5.
        violations: Vec<DegreeViolation>,
    },
}

#[derive(Clone, Debug, Serialize)]
struct ModelGroup {
    name: Option<String>,
    material: Option<String>,
    /// The base color of the material: red, green, blue and opacity, in linear light.
    color: Option<[f32; 4]>,
    faces: usize,
    triangles: u32,
}

impl ModelAnswer {
    /// The answer for a mesh of a model's boundary points.
    #[must_use]
    pub fn of(model: &Model, meshed: &ModelMesh) -> Self {
        let corners = |edge: usize| model.edge_corners(edge);
        let known = Known::Degree {
            least_max_degree: meshed.is_proven().then_some(meshed.max_degree),
            at_least: meshed.lower_bound,
            bounded_by: match meshed.bounded_by {
                JointBound::Sum { .. } => "sum",
                JointBound::Edges { .. } => "edges",
                JointBound::Side { .. } => "side",
                JointBound::Refuted { .. } => "refuted",
                _ => "weights",
            },
            worst_vertices: meshed.worst_vertices.clone(),
            share_of_limit: meshed.angle_share,
            boundary_edges: model.boundary_edges().map(corners).collect(),
            non_manifold_edges: model.non_manifold_edges().map(corners).collect(),
            groups: groups(model, &meshed.mesh),
        };
        let degree = format!(
            "maximum degree {} (at least {} is needed)",
            meshed.max_degree, meshed.lower_bound
        );
        let mut lines = vec![standing(meshed)];
        lines.extend(highest(model, meshed));
        lines.extend(meshed.angle_share.map(|share| {
            let share = percent(share);
            format!("Every face keeps {share} of its Delaunay minimum angle, or more.")
        }));
        Self::new(model, &meshed.mesh, (meshed.max_degree, &degree), known, lines)
    }

    /// The answer in sentences, under the name of the model.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{}: {}", shown(self.name.as_deref().unwrap_or("model")), self.words)
    }

    /// The answer for a model whose faces have points inside.
    #[must_use]
    pub fn filled(model: &Model, filled: &FilledModel) -> Self {
        let FilledModel { mesh, interior_points, max_degree, violations, .. } = filled;
        let loops = mesh.boundary_loops();
        let boundary: BTreeSet<u32> =
            loops.iter().flat_map(|found| &found.vertices).copied().collect();
        let degrees = mesh.degrees();
        let violation = |vertex: &u32| DegreeViolation {
            vertex: *vertex,
            position: mesh.positions()[*vertex as usize].to_array(),
            degree: degrees[*vertex as usize],
            on_boundary: boundary.contains(vertex),
        };
        let known = Known::Filled {
            interior_points: *interior_points,
            violations: violations.iter().map(violation).collect(),
        };
        let degree = match violations.len() {
            0 => "degrees 5 to 7, at the boundary 5 at most".to_owned(),
            1 => format!("maximum degree {max_degree}, 1 vertex out of 5 to 7"),
            count => format!("maximum degree {max_degree}, {count} vertices out of 5 to 7"),
        };
        Self::new(model, mesh, (*max_degree, &degree), known, Vec::new())
    }

    fn new(
        model: &Model,
        mesh: &TriMesh,
        (max_degree, degree): (u32, &str),
        known: Known,
        mut lines: Vec<String>,
    ) -> Self {
        let quality = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]);
            TriangleQuality::in_space(a, b, c)
        };
        let qualities = mesh.triangles().iter().map(quality);
        let [min_angle, max_angle] = qualities.fold([f64::INFINITY, 0.0], |[min, max], one| {
            [f64::min(min, one.min_angle), f64::max(max, one.max_angle)]
        });
        let inside = match known {
            Known::Degree { .. } => String::new(),
            Known::Filled { interior_points, .. } => {
                format!(", {interior_points} of them inside faces")
            }
        };
        let (faces, vertices) = (model.face_count(), mesh.positions().len());
        let triangles = mesh.triangle_count();
        let [min, max] = [min_angle, max_angle].map(steady_angle);
        lines.insert(
            0,
            format!(
                "{}, {vertices} vertices{inside}, {}, {degree}, angles {min} to {max}",
                counted(faces as u64, "face"),
                triangle_words(triangles)
            ),
        );
        lines.extend(model.notes().iter().cloned());
        Self {
            name: model.name().map(str::to_owned),
            faces,
            edges: model.edge_count(),
            vertices,
            triangles,
            max_degree,
            min_angle,
            max_angle,
            closed: model.is_closed(),
            notes: model.notes().to_vec(),
            known,
            words: lines.join("\n"),
        }
    }
}

/// The vertices of maximum degree; if most have it, their names tell nothing.
fn highest(model: &Model, meshed: &ModelMesh) -> Option<String> {
    let count = meshed.worst_vertices.len();
    if count * 4 > meshed.mesh.positions().len() && count > NAMED {
        return None;
    }
    let first = meshed.worst_vertices.iter().take(NAMED);
    let mut named: Vec<String> = first.map(|&v| place_text(model, meshed, v)).collect();
    if count > NAMED {
        named.push(format!("and {} more", count - NAMED));
    }
    let noun = if count == 1 { "vertex has" } else { "vertices have" };
    Some(format!("{count} {noun} degree {}: {}.", meshed.max_degree, named.join(", ")))
}

fn groups(model: &Model, mesh: &TriMesh) -> Vec<ModelGroup> {
    let mut groups: Vec<ModelGroup> = model
        .groups()
        .iter()
        .map(|group| ModelGroup {
            name: group.name.clone(),
            material: group.material.as_ref().map(|material| material.name.clone()),
            color: group.material.as_ref().and_then(|material| material.color),
            faces: 0,
            triangles: 0,
        })
        .collect();
    for face in 0..model.face_count() {
        groups[model.group_of(face)].faces += 1;
    }
    for (group, of_mesh) in groups.iter_mut().zip(Triangles::groups(mesh)) {
        group.triangles = of_mesh.triangles.len() as u32;
    }
    groups
}

/// The proven facts about the degree.
fn standing(meshed: &ModelMesh) -> String {
    let why = match &meshed.bounded_by {
        JointBound::Sum { sum, vertices } => {
            format!(
                "the degrees of all {vertices} vertices add up to {sum}, whatever the triangles"
            )
        }
        JointBound::Edges { vertex, edges } => {
            format!("vertex {vertex} has {edges} edges of the model")
        }
        JointBound::Side { face, intervals, .. } => format!(
            "face {face} has a side of {intervals} intervals, whose triangles need apexes elsewhere"
        ),
        JointBound::Refuted { refutation, max_degree } => format!(
            "degree {} is refuted by {} clauses, checked",
            max_degree - 1,
            refutation.clauses.len()
        ),
        _ => "a weighted sum of the degrees, least over all triangulations of each face".to_owned(),
    };
    let (degree, bound) = (meshed.max_degree, meshed.lower_bound);
    let mesh = match meshed.angle_share {
        Some(_) => "mesh of these points with such angles",
        None => "mesh of these points",
    };
    if meshed.is_proven() {
        format!("No {mesh} has a smaller maximum degree: {why}.")
    } else {
        format!(
            "Degree {degree} was reached. No {mesh} has less than {bound}: {why}. The gap is {}; \
             --effort 10 looks ten times as long.",
            degree - bound
        )
    }
}

fn place_text(model: &Model, meshed: &ModelMesh, vertex: u32) -> String {
    let position = meshed.mesh.positions()[vertex as usize];
    let [x, y, z] = position.to_array().map(|x| format!("{}", x as f32));
    let place = match model.place(vertex) {
        ModelPlace::Corner(corner) => format!("corner {corner}"),
        ModelPlace::Edge { edge, .. } => format!("on {}", edge_in_text(model, edge as usize)),
    };
    format!("{vertex} ({place}, at {x} {y} {z})")
}

/// An edge by its name or its corners, such as "edge 0-4".
pub(crate) fn edge_in_text(model: &Model, edge: usize) -> String {
    match (model.edge_name(edge), model.edge_corners(edge)) {
        (Some(name), _) => format!("edge {}", shown(name)),
        (None, [low, high]) => format!("edge {low}-{high}"),
    }
}
