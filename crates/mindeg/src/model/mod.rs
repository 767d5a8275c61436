//! A watertight mesh of a whole model, with one limit on the degrees of all its vertices.
//!
//! Every face is triangulated from its boundary points alone. The degree of a vertex counts its
//! edges over all faces, so the faces are one problem: it is solved by block descent, which gives
//! one face after another the triangulation that is best beside its neighbours' (`descent.rs`).
//! `bound.rs` proves how small the maximum degree can be.
//!
//! Same bytes on any number of threads: faces that share a corner are never solved together
//! (`colors.rs`), and random numbers depend on the round and the face alone.

mod annealed;
pub(crate) mod bound;
mod colors;
mod descent;
pub(crate) mod face;
#[cfg(feature = "interior")]
mod filled;
mod flips;
pub(crate) mod joint;
mod polish;
mod search;
pub(crate) mod solve;

pub use bound::JointBound;
#[cfg(feature = "interior")]
pub use filled::{FilledModel, fill_model};

use glam::DVec3;
use mindeg_domain::Model;
use mindeg_mesh::quality::min_angle;
use mindeg_mesh::{Group, Line, Progress, TriMesh, TriMeshError};

use crate::error::MeshError;
use crate::goal::Goal;
use face::PlaneFace;
use joint::Joint;
use solve::solve;

/// A mesh of a model, and what is known of its degrees. Degrees count all edges at a vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelMesh {
    /// The mesh: vertices as the model has them, triangles face by face, a group for each group of
    /// faces, and a line for each named edge.
    pub mesh: TriMesh,
    /// Where the triangles of each face of the model begin, by face.
    pub face_starts: Vec<u32>,
    /// The maximum degree.
    pub max_degree: u32,
    /// No mesh of the model from these points has a smaller maximum degree; with
    /// [`Goal::KeepAngle`], no mesh whose faces keep that share.
    pub lower_bound: u32,
    /// The proof of that.
    pub bounded_by: JointBound,
    /// The vertices of maximum degree, ascending.
    pub worst_vertices: Vec<u32>,
    /// The minimum angle of all triangles, in degrees.
    pub min_angle: f64,
    /// The smallest share that a face has of its Delaunay triangulation's minimum angle; none
    /// unless the goal asks for one.
    pub angle_share: Option<f64>,
}

impl ModelMesh {
    /// Whether the maximum degree is proven to be the least.
    pub fn is_proven(&self) -> bool {
        self.max_degree == self.lower_bound
    }
}

/// Meshes a model. `effort` is how long to look for each degree, as a multiple of the default work of a few seconds.
///
/// Of a [`Goal::KeepAngle`], every face keeps the share of the minimum angle of its own Delaunay triangulation; at a
/// [`Goal::MaxDegree`] the work on the degree ends once no vertex has more edges.
///
/// The maximum degree is what block descent reaches, with a lower bound beside it. A face without
/// holes changes as a whole while it is small, else window by window. With a lower bound of B, the
/// descent first aims at B+1, which is nearly always possible, and then at B. Near-linear time for
/// many faces of like size; memory in proportion to the vertices.
///
/// # Errors
///
/// A goal that [`GOALS`](crate::GOALS) does not give to models; a face that cannot be triangulated once its points are rounded to
/// f64, or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use mindeg::model::mesh_model;
/// use mindeg::{Goal, Model, Progress};
///
/// let cube = Model::from_json(
///     r#"{"corners": [[0,0,0], [1,0,0], [1,1,0], [0,1,0], [0,0,1], [1,0,1], [1,1,1], [0,1,1]],
///         "faces": [[0,3,2,1], [4,5,6,7], [0,1,5,4], [1,2,6,5], [2,3,7,6], [3,0,4,7]],
///         "size": 0.25}"#,
/// )?;
/// let meshed = mesh_model(&cube, Goal::LeastDegree, 1.0, Progress::NONE)?;
/// // The degrees of V vertices of a closed surface add up to 6V - 12.
/// assert_eq!((meshed.max_degree, meshed.lower_bound), (6, 6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_model(
    model: &Model,
    goal: Goal,
    effort: f64,
    progress: Progress<'_>,
) -> Result<ModelMesh, MeshError> {
    let (share, limit) = match goal {
        Goal::LeastDegree => (None, 0),
        Goal::KeepAngle(share) => (Some(share), 0),
        Goal::MaxDegree(limit) => (None, limit),
        _ => return Err(goal.refused("domains", "a model")),
    };
    let positions = model.positions();
    let mut joint = of_model(model, &positions, share, progress)?;
    let bound = solve(&mut joint, limit, effort, progress)?;
    finished(model, positions, &joint, bound)
}

/// The faces of a model, triangulated.
fn of_model(
    model: &Model,
    positions: &[DVec3],
    keep_angle: Option<f64>,
    progress: Progress<'_>,
) -> Result<Joint, MeshError> {
    let face = |face| PlaneFace::new(model, positions, face);
    Joint::new(model.face_count(), face, model.edge_degrees(), keep_angle, progress)
}

fn finished(
    model: &Model,
    positions: Vec<DVec3>,
    joint: &Joint,
    bound: JointBound,
) -> Result<ModelMesh, MeshError> {
    let max_degree = joint.max_degree();
    let is_worst = |&(_, &degree): &(usize, &u32)| degree == max_degree;
    let worst_vertices =
        joint.totals.iter().enumerate().filter(is_worst).map(|(v, _)| v as u32).collect();
    let angle_share = joint.angle_share();

    let triangles = |face: usize, vertices: &[u32]| -> Vec<[u32; 3]> {
        let of_model = |triangle: &[u32; 3]| triangle.map(|place| vertices[place as usize]);
        joint.triangles[face].iter().map(of_model).collect()
    };
    let (mesh, face_starts) = assembled(model, positions, triangles)?;
    let min_angle = min_angle(mesh.positions(), mesh.triangles());
    Ok(ModelMesh {
        mesh,
        face_starts,
        max_degree,
        lower_bound: bound.max_degree().min(max_degree),
        bounded_by: bound,
        worst_vertices,
        min_angle,
        angle_share,
    })
}

/// The mesh of a model and where the triangles of each face begin, from each face's triangles, for
/// which `triangles` gets the face and its vertices.
fn assembled(
    model: &Model,
    positions: Vec<DVec3>,
    mut triangles: impl FnMut(usize, &[u32]) -> Vec<[u32; 3]>,
) -> Result<(TriMesh, Vec<u32>), TriMeshError> {
    // Faces of one group follow each other.
    let mut order: Vec<usize> = (0..model.face_count()).collect();
    order.sort_by_key(|&face| model.group_of(face));
    let mut face_starts = vec![0; model.face_count()];
    let mut all = Vec::new();
    let mut groups: Vec<Group> = Vec::new();
    for same in order.chunk_by(|&a, &b| model.group_of(a) == model.group_of(b)) {
        let start = all.len() as u32;
        for &face in same {
            face_starts[face] = all.len() as u32;
            all.extend(triangles(face, &model.face_vertices(face)));
        }
        let group = &model.groups()[model.group_of(same[0])];
        let triangles = start..all.len() as u32;
        let name = group.name.clone().unwrap_or_default();
        groups.push(Group::new(name, triangles).of_material(group.material.clone()));
    }
    let mesh = TriMesh::new(positions, all)?.with_groups(groups);
    let (lines, segments) = lines(model);
    let mesh = mesh.with_lines(lines, segments)?;
    let mesh = mesh.called(model.name());
    Ok((mesh, face_starts))
}

/// The named edges as lines.
fn lines(model: &Model) -> (Vec<Line>, Vec<[u32; 2]>) {
    let mut lines = Vec::new();
    let mut segments = Vec::new();
    for edge in 0..model.edge_count() {
        let Some(name) = model.edge_name(edge) else { continue };
        let start = segments.len() as u32;
        let vertices: Vec<u32> = model.edge_vertices(edge).collect();
        segments.extend(vertices.windows(2).map(|pair| [pair[0], pair[1]]));
        let segments = start..segments.len() as u32;
        lines.push(Line { name: name.to_owned(), segments, is_straight: true });
    }
    (lines, segments)
}
