//! Faces with interior points: still watertight, since the points of edges stay bit for bit.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use glam::DVec3;
use mindeg_domain::{Interior, Model};
use mindeg_interior::{Options, RemeshError, generate, improve_surface};
use mindeg_mesh::quality::min_angle;
use mindeg_mesh::{Cancelled, Progress, TriMesh};
use mindeg_surfaces::{FeatureRules, Given, Surface};

use super::assembled;
use super::face::PlaneFace;
use crate::error::MeshError;
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
    /// The vertices off the boundary with fewer than 5 or more than 7 edges, and those on it with more than 5, ascending.
    pub violations: Vec<u32>,
    /// The minimum angle of all triangles, in degrees.
    pub min_angle: f64,
}

/// Fills every face of a model with interior points: first each face for itself, then by a search over all faces
/// together, in which all edges at a vertex count. Where faces do not form a surface, such as three at an edge, or the
/// search is in vain, the first stays.
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
    let boundary = positions.len();
    let mut firsts = Vec::with_capacity(faces.len());
    for (face, found) in filled.iter().enumerate() {
        firsts.push(positions.len() as u32);
        let inside = &found.points[model.face_size(face) as usize..];
        positions.extend(inside.iter().map(|&point| model.plane(face).lift(point)));
    }
    let (mesh, starts) = assembled(model, positions, |face, vertices| {
        let of_model = |place: u32| match vertices.get(place as usize) {
            Some(&vertex) => vertex,
            None => firsts[face] + place - vertices.len() as u32,
        };
        filled[face].triangles.iter().map(|triangle| triangle.map(of_model)).collect()
    })?;
    let apart = Judged::new(mesh);
    let joined = joined(model, &apart.mesh, &starts, &options, progress)?.map(Judged::new);
    let Judged { mesh, violations, min_angle } = match joined {
        Some(joined) if joined.is_better_than(&apart) => joined,
        _ => apart,
    };
    let max_degree = mesh.degrees().iter().copied().max().unwrap_or(0);
    let interior_points = mesh.positions().len() - boundary;
    Ok(FilledModel { mesh, interior_points, max_degree, violations, min_angle })
}

/// A mesh with what counts of it.
struct Judged {
    mesh: TriMesh,
    violations: Vec<u32>,
    min_angle: f64,
}

impl Judged {
    fn new(mesh: TriMesh) -> Self {
        let mut is_open = vec![false; mesh.positions().len()];
        let loops = mesh.boundary_loops();
        loops.iter().flat_map(|found| &found.vertices).for_each(|v| is_open[*v as usize] = true);
        let is_violated = |(v, degree): (u32, &u32)| match is_open[v as usize] {
            true => *degree > 5,
            false => *degree > 0 && !(5..=7).contains(degree),
        };
        let all = (0_u32..).zip(mesh.degrees());
        let violations = all.filter(|vertex| is_violated(*vertex)).map(|(v, _)| v).collect();
        let min_angle = min_angle(mesh.positions(), mesh.triangles());
        Self { mesh, violations, min_angle }
    }

    fn is_better_than(&self, other: &Self) -> bool {
        match self.violations.len().cmp(&other.violations.len()) {
            Ordering::Equal => self.min_angle > other.min_angle,
            order => order == Ordering::Less,
        }
    }
}

/// The mesh after a search over all faces together, for degrees over edges and corners; `None` where faces form no surface.
fn joined(
    model: &Model,
    mesh: &TriMesh,
    starts: &[u32],
    options: &Options,
    progress: Progress<'_>,
) -> Result<Option<TriMesh>, MeshError> {
    let mut faces: Vec<u32> = (0..model.face_count() as u32).collect();
    faces.sort_by_key(|face| starts[*face as usize]);
    let first = |face: u32| starts[face as usize];
    let ends = faces.iter().skip(1).map(|face| first(*face)).chain([mesh.triangles().len() as u32]);
    let face_of: Vec<u32> =
        faces.iter().zip(ends).flat_map(|(face, end)| (first(*face)..end).map(|_| *face)).collect();
    let given = Given { groups: &face_of, ..Given::default() };
    // Edges between faces are borders of groups; nothing else is sharp.
    let rules = FeatureRules { angle_deg: 180.0, ..FeatureRules::default() };
    let surface = Surface::keeping(mesh.positions(), mesh.triangles(), &given, &rules);
    let Ok(surface) = surface else { return Ok(None) };
    let found = match improve_surface(&surface, options, progress) {
        Ok(found) => found,
        Err(RemeshError::Cancelled) => return Err(Cancelled.into()),
        Err(error) => return Err(MeshError::refused(error)),
    };
    // The points of edges are there bit for bit, and have their indices again; others follow, face by face.
    let mut positions = model.positions();
    let bits = |point: DVec3| (point + DVec3::ZERO).to_array().map(f64::to_bits);
    let of_model: BTreeMap<_, u32> = positions.iter().map(|p| bits(*p)).zip(0..).collect();
    let mut own: Vec<Vec<usize>> = vec![Vec::new(); model.face_count()];
    for (t, patch) in found.patches.iter().enumerate() {
        own[surface.group(*patch) as usize].push(t);
    }
    let mut vertex_of: Vec<Option<u32>> =
        found.points.iter().map(|point| of_model.get(&bits(*point)).copied()).collect();
    for v in own.iter().flatten().flat_map(|t| found.triangles[*t]) {
        if vertex_of[v as usize].is_none() {
            vertex_of[v as usize] = Some(positions.len() as u32);
            positions.push(found.points[v as usize]);
        }
    }
    let (mesh, _) = assembled(model, positions, |face, _| {
        let corners = |t: &usize| found.triangles[*t].map(|v| vertex_of[v as usize].unwrap_or(0));
        own[face].iter().map(corners).collect()
    })?;
    Ok(Some(mesh))
}
