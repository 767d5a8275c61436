//! Decides the degrees that descent and bounds leave open, by searches over the triangulations of all faces together.
//!
//! Limits: those of [`Cover`], and a number of steps.

use mindeg_exact::check::CheckedOutline;
use mindeg_exact::check::refutation::{CheckedFace, refutes};
use mindeg_exact::{COVER_STEPS, Cover, Decision, Problem, Refutation};
use mindeg_mesh::{Cancelled, Progress};

use super::bound::JointBound;
use super::joint::Joint;

/// Closes the gap between a bound and the degree reached, from the bound up, as far as the steps suffice:
/// `effort` times their default. Degrees above `enough` alone are brought down.
pub(super) fn close(
    joint: &mut Joint,
    mut bound: JointBound,
    enough: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<JointBound, Cancelled> {
    if joint.max_degree() <= bound.max_degree().max(enough) {
        return Ok(bound);
    }
    let Some(cover) = cover(joint, progress)? else { return Ok(bound) };
    let mut steps = (COVER_STEPS as f64 * effort.max(0.0)) as u64;
    while joint.max_degree() > bound.max_degree().max(enough) {
        let degree = bound.max_degree().max(enough);
        let most: Option<Vec<u32>> =
            joint.edge_degrees.iter().map(|&edges| degree.checked_sub(edges)).collect();
        let Some(most) = most else { return Ok(bound) };
        let (tangents, start) = (&joint.thresholds, &joint.triangles);
        match cover.decide(&most, tangents, start, steps, progress)? {
            Decision::Mesh(faces) => {
                for (face, triangles) in faces.into_iter().enumerate() {
                    joint.replace(face, triangles);
                }
            }
            Decision::Refuted(refutation) => {
                if !holds(joint, degree, &refutation) {
                    return Ok(bound);
                }
                bound = JointBound::Refuted { max_degree: degree + 1, refutation };
            }
            Decision::Unknown => break,
        }
        steps /= 2;
    }
    Ok(bound)
}

/// The candidates of all faces; none if they are too many.
fn cover(joint: &Joint, progress: Progress<'_>) -> Result<Option<Cover>, Cancelled> {
    let faces = 0..joint.face_count();
    let problem = |face: usize| joint.face(face).problem(&joint.triangles[face]);
    let Some(problems) = faces.map(problem).collect::<Option<Vec<Problem>>>() else {
        return Ok(None);
    };
    let with_vertices = |(face, problem)| (problem, &joint.face(face).vertices[..]);
    let faces: Vec<(&Problem, &[u32])> = problems.iter().enumerate().map(with_vertices).collect();
    Cover::of_faces(&faces, progress)
}

/// Whether a refutation holds for the checker, which makes the candidates with its own code.
fn holds(joint: &Joint, max_degree: u32, refutation: &Refutation) -> bool {
    let all = || 0..joint.face_count();
    let rings: Vec<Vec<_>> =
        all().map(|face| joint.face(face).boundary.rings().collect()).collect();
    let checked = |face: usize| {
        let plane_face = joint.face(face);
        let problem = plane_face.problem(&joint.triangles[face])?;
        let outline = CheckedOutline {
            points: plane_face.boundary.points(),
            rings: &rings[face],
            side_of: plane_face.boundary.runs(),
            keeps_clear: problem.keeps_clear(),
        };
        let (vertices, least_tangent) = (&plane_face.vertices[..], joint.thresholds[face]);
        Some(CheckedFace { outline, vertices, least_tangent })
    };
    let most = joint.edge_degrees.iter().map(|&edges| max_degree.checked_sub(edges));
    let most: Option<Vec<u32>> = most.collect();
    let faces: Option<Vec<CheckedFace<'_>>> = all().map(checked).collect();
    faces.zip(most).is_some_and(|(faces, most)| refutes(&faces, &most, refutation))
}
