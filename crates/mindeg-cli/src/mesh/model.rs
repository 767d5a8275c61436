//! `mindeg mesh` of a whole model: from its faces to one watertight mesh.

mod source;

pub(super) use source::{divided, of_mesh};

use crate::args::MeshArguments;
use crate::demands::met_or_written_anyway;
use crate::failure::Failure;
use crate::making::Making;
use crate::terminal::shown;
use mindeg::model::{JointBound, ModelMesh, fill_model, mesh_model};
use mindeg::quality::TriangleQuality;
use mindeg::{Model, ModelPlace};
use mindeg_answers::numbers::{percent, steady_angle};
use mindeg_mesh::{TriMesh, Triangles};
use serde::Serialize;

/// How many vertices and edges a message names.
const NAMED: usize = 5;

/// The output of `--json`; angles in degrees. Degrees are over all faces.
#[derive(Serialize)]
struct Summary<'a> {
    name: Option<&'a str>,
    faces: usize,
    edges: usize,
    vertices: u32,
    triangles: u32,
    max_degree: u32,
    /// The same where that is proven, else null.
    least_max_degree: Option<u32>,
    /// No mesh from these points has a smaller maximum degree.
    at_least: u32,
    /// "sum", "edges", "side" or "weights".
    bounded_by: &'static str,
    /// The vertices of maximum degree.
    worst_vertices: &'a [u32],
    min_angle: f64,
    max_angle: f64,
    /// The smallest share that a face has of its Delaunay triangulation's minimum angle; null
    /// without `--keep-angle`.
    share_of_delaunay: Option<f64>,
    closed: bool,
    /// By corners.
    boundary_edges: Vec<[u32; 2]>,
    /// By corners: edges with three faces or more.
    non_manifold_edges: Vec<[u32; 2]>,
    groups: Vec<GroupSummary<'a>>,
    notes: &'a [String],
}

/// The output of `--json` with `--interior`.
#[derive(Serialize)]
struct FilledSummary<'a> {
    name: Option<&'a str>,
    faces: usize,
    edges: usize,
    vertices: usize,
    interior_points: usize,
    triangles: u32,
    /// Over all faces.
    max_degree: u32,
    /// Within one face.
    max_face_degree: u32,
    min_angle: f64,
    max_angle: f64,
    closed: bool,
    notes: &'a [String],
}

#[derive(Serialize)]
struct GroupSummary<'a> {
    name: Option<&'a str>,
    material: Option<&'a str>,
    /// The base color of the material: red, green, blue and opacity, in linear light.
    color: Option<[f32; 4]>,
    faces: usize,
    triangles: u32,
}

pub(super) fn run(model: &Model, arguments: &MeshArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut making = Making::new(surface, &surface.output, arguments.quiet, arguments.json)?;
    making.expect_materials(model.groups().iter().any(|group| group.material.is_some()))?;
    if arguments.interior.interior {
        return fill(model, arguments, making);
    }
    let (goal, effort) = (arguments.goal.goal(), arguments.model.effort);
    making.open()?;
    let meshed = making.work(|progress| mesh_model(model, goal, effort, progress));
    let meshed = meshed.map_err(|error| source::bad(arguments, &error))?;
    let mesh = &meshed.mesh;
    let end = judged(arguments, mesh, meshed.min_angle)?;
    let made = making.write(mesh)?;

    let corners = |edge: usize| model.edge_corners(edge);
    let summary = Summary {
        name: model.name(),
        faces: model.face_count(),
        edges: model.edge_count(),
        vertices: model.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: meshed.max_degree,
        least_max_degree: meshed.is_proven().then_some(meshed.max_degree),
        at_least: meshed.lower_bound,
        bounded_by: match meshed.bounded_by {
            JointBound::Sum { .. } => "sum",
            JointBound::Edges { .. } => "edges",
            JointBound::Side { .. } => "side",
            JointBound::Refuted { .. } => "refuted",
            _ => "weights",
        },
        worst_vertices: &meshed.worst_vertices,
        min_angle: meshed.min_angle,
        max_angle: max_angle(mesh),
        share_of_delaunay: meshed.angle_share,
        closed: model.is_closed(),
        boundary_edges: model.boundary_edges().map(corners).collect(),
        non_manifold_edges: model.non_manifold_edges().map(corners).collect(),
        groups: groups(model, mesh),
        notes: model.notes(),
    };
    made.say(|| text(model, &meshed, &summary), || &summary)?;
    end
}

/// How the run ends once the mesh is written, if it is to be.
fn judged(
    arguments: &MeshArguments,
    mesh: &TriMesh,
    min_angle: f64,
) -> Result<Result<(), Failure>, Failure> {
    let aims = &arguments.interior.wanted;
    let unmet = arguments.demands(aims.target_angle()).unmet_by(mesh, min_angle);
    met_or_written_anyway(&unmet, aims.write_anyway)
}

/// Fills the faces with interior points.
fn fill(model: &Model, arguments: &MeshArguments, mut making: Making) -> Result<(), Failure> {
    arguments.refuse_goals_with_interior("--interior")?;
    making.open()?;
    let interior = arguments.interior.wanted.over(None);
    let filled = making.work(|progress| fill_model(model, &interior, progress));
    let filled = filled.map_err(|error| source::bad(arguments, &error))?;
    let mesh = &filled.mesh;
    let end = judged(arguments, mesh, filled.min_angle)?;
    let made = making.write(mesh)?;
    let summary = FilledSummary {
        name: model.name(),
        faces: model.face_count(),
        edges: model.edge_count(),
        vertices: mesh.positions().len(),
        interior_points: filled.interior_points,
        triangles: mesh.triangle_count(),
        max_degree: filled.max_degree,
        max_face_degree: filled.max_face_degree,
        min_angle: filled.min_angle,
        max_angle: max_angle(mesh),
        closed: model.is_closed(),
        notes: model.notes(),
    };
    let text = || {
        let mut lines = vec![format!(
            "{}: {} faces, {} vertices, {} of them inside faces, {} triangles, maximum degree {} over \
             all faces and {} within one, angles {} to {}",
            shown(summary.name.unwrap_or("model")),
            summary.faces,
            summary.vertices,
            summary.interior_points,
            summary.triangles,
            summary.max_degree,
            summary.max_face_degree,
            steady_angle(summary.min_angle),
            steady_angle(summary.max_angle),
        )];
        lines.extend(model.notes().iter().cloned());
        lines.join("\n")
    };
    made.say(text, || &summary)?;
    end
}

fn quality(mesh: &TriMesh, triangle: [u32; 3]) -> TriangleQuality {
    let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]);
    TriangleQuality::in_space(a, b, c)
}

fn max_angle(mesh: &TriMesh) -> f64 {
    let angles = mesh.triangles().iter().map(|&triangle| quality(mesh, triangle).max_angle);
    angles.fold(0.0, f64::max)
}

fn groups<'a>(model: &'a Model, mesh: &TriMesh) -> Vec<GroupSummary<'a>> {
    let mut groups: Vec<GroupSummary<'a>> = model
        .groups()
        .iter()
        .map(|group| GroupSummary {
            name: group.name.as_deref(),
            material: group.material.as_ref().map(|material| &*material.name),
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

fn text(model: &Model, meshed: &ModelMesh, summary: &Summary<'_>) -> String {
    let mut lines = vec![format!(
        "{}: {} faces, {} vertices, {} triangles, maximum degree {} (at least {} is needed), angles \
         {} to {}",
        shown(summary.name.unwrap_or("model")),
        summary.faces,
        summary.vertices,
        summary.triangles,
        summary.max_degree,
        summary.at_least,
        steady_angle(summary.min_angle),
        steady_angle(summary.max_angle),
    )];
    lines.push(standing(meshed));
    let count = meshed.worst_vertices.len();
    let mut named: Vec<String> =
        meshed.worst_vertices.iter().take(NAMED).map(|&v| place_text(model, meshed, v)).collect();
    if count > NAMED {
        named.push(format!("and {} more", count - NAMED));
    }
    // If most vertices have the maximum, their names tell nothing.
    if count * 4 <= summary.vertices as usize || count <= NAMED {
        let noun = if count == 1 { "vertex has" } else { "vertices have" };
        lines.push(format!("{count} {noun} degree {}: {}.", meshed.max_degree, named.join(", ")));
    }
    if let Some(share) = summary.share_of_delaunay {
        let share = percent(share);
        lines.push(format!("Every face keeps {share} of its Delaunay minimum angle, or more."));
    }
    lines.extend(model.notes().iter().cloned());
    lines.join("\n")
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
            "a search over all triangulations refutes degree {} in {} steps, checked",
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
        ModelPlace::Edge { edge, .. } => {
            let [low, high] = model.edge_corners(edge as usize);
            match model.edge_name(edge as usize) {
                Some(name) => format!("on edge {}", shown(name)),
                None => format!("on edge {low}-{high}"),
            }
        }
    };
    format!("{vertex} ({place}, at {x} {y} {z})")
}
