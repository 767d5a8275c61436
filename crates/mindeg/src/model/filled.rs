//! Faces with interior points: still watertight, since the points of edges stay bit for bit.

use mindeg_domain::{Interior, Model};
use mindeg_interior::{Generated, Options, generate};
use mindeg_mesh::{Progress, TriMesh};

use super::assembled;
use super::face::PlaneFace;
use crate::error::MeshError;
use crate::fill::min_angle;
use mindeg_mesh::parallel::map_all;

/// Faces from one report of progress to the next.
const REPORT: usize = 64;

/// A mesh of a model with points inside its faces.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledModel {
    /// The mesh: the vertices of the model, then the interior points face by face.
    pub mesh: TriMesh,
    /// The number of interior points.
    pub interior_points: usize,
    /// The largest degree, over all faces.
    pub max_degree: u32,
    /// The largest degree within one face, where the limits hold: edges of other faces do not count.
    pub max_face_degree: u32,
    /// The minimum angle of all triangles, in degrees.
    pub min_angle: f64,
}

/// Fills every face of a model with interior points, each face for itself: limits of degrees hold in
/// each face, and the edges of its neighbours come on top.
///
/// Same bytes on any number of threads.
///
/// # Errors
///
/// A face that cannot be filled, or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use mindeg::model::fill_model;
/// use mindeg::{Interior, Model, Progress};
///
/// let tetrahedron = Model::from_json(
///     r#"{"corners": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
///         "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], "size": 0.2}"#,
/// )?;
/// let filled = fill_model(&tetrahedron, &Interior::default(), Progress::NONE)?;
/// assert!(filled.interior_points > 0);
/// assert!(filled.mesh.boundary_loops().is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fill_model(
    model: &Model,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<FilledModel, MeshError> {
    let mut positions = model.positions();
    let options = Options::from(wanted.clone());
    let faces: Vec<usize> = (0..model.face_count()).collect();
    let fill = |face: usize| {
        let face_of_model = PlaneFace::new(model, &positions, face)?;
        let failed = |error| MeshError::of_face(face, error);
        let boundary = &face_of_model.boundary;
        let found = generate(boundary, &options, Progress::NONE);
        found.map_err(failed)
    };
    let mut filled = Vec::with_capacity(faces.len());
    let counter = progress.counter("filling faces", faces.len() as u64);
    for chunk in faces.chunks(REPORT) {
        for found in map_all(chunk.to_vec(), fill) {
            filled.push(found?);
        }
        counter.add(chunk.len())?;
    }
    let face_degree = |(face, found): (usize, &Generated)| {
        let mut degrees = vec![0_u32; found.points.len()];
        found.triangles.as_flattened().iter().for_each(|&place| degrees[place as usize] += 1);
        // A boundary vertex has an edge more than triangles.
        degrees[..model.face_size(face) as usize].iter_mut().for_each(|degree| *degree += 1);
        degrees.into_iter().max().unwrap_or(0)
    };
    let max_face_degree = filled.iter().enumerate().map(face_degree).max().unwrap_or(0);
    let boundary = positions.len();
    let mut firsts = Vec::with_capacity(faces.len());
    for (face, found) in filled.iter().enumerate() {
        firsts.push(positions.len() as u32);
        let inside = &found.points[model.face_size(face) as usize..];
        positions.extend(inside.iter().map(|&point| model.plane(face).lift(point)));
    }
    let interior_points = positions.len() - boundary;
    let (mesh, _) = assembled(model, positions, |face, vertices| {
        let of_model = |place: u32| match vertices.get(place as usize) {
            Some(&vertex) => vertex,
            None => firsts[face] + place - vertices.len() as u32,
        };
        filled[face].triangles.iter().map(|triangle| triangle.map(of_model)).collect()
    })?;
    let max_degree = mesh.degrees().iter().copied().max().unwrap_or(0);
    let min_angle = min_angle(mesh.positions(), mesh.triangles());
    Ok(FilledModel { mesh, interior_points, max_degree, max_face_degree, min_angle })
}
