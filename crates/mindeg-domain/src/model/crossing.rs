//! Whether the loops of a face bound an area: simple, apart from each other, holes inside. Exact
//! for the coordinates in the plane of the face.

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::BoundaryPlace::Ring;
use mindeg_mesh::planar::{BoundaryFault, InRing, PlanarBoundary};

use super::faults::{coincident, face_error};
use super::{ModelFace, Plane};
use crate::error::{DomainError, Place};

/// The loops of a face, holes opposite to the outer loop; or why they bound no area.
pub(super) fn oriented(
    corners: &[DVec3],
    face: usize,
    given: &ModelFace,
    plane: &Plane,
) -> Result<Vec<Vec<u32>>, DomainError> {
    check_repeated(face, &given.loops)?;
    let project = |&corner: &u32| plane.project(corners[corner as usize]);
    let rings: Vec<Vec<DVec2>> =
        given.loops.iter().map(|corners| corners.iter().map(project).collect()).collect();
    let corner = |at: InRing| given.loops[at.ring][at.index];
    let next = |InRing { ring, index }| {
        corner(InRing { ring, index: (index + 1) % given.loops[ring].len() })
    };
    let edge = |at: InRing| [corner(at), next(at)];
    let (_, turned) = PlanarBoundary::oriented(&rings).map_err(|faults| match faults.first() {
        BoundaryFault::SamePoint([Ring(a), Ring(b)]) => coincident([a, b].map(corner)),
        BoundaryFault::Touch { vertex: Ring(vertex), edge: Ring(on) } => {
            let (corner, [a, b]) = (corner(vertex), edge(on));
            face_error(
                face,
                format!("touches itself: corner {corner} lies on its edge {a}-{b} (by corners)"),
            )
        }
        BoundaryFault::Crossing([Ring(first), Ring(second)]) => {
            let [[a, b], [c, d]] = [first, second].map(edge);
            face_error(
                face,
                format!("crosses itself: its edges {a}-{b} and {c}-{d} (by corners) meet"),
            )
        }
        BoundaryFault::FoldsBack(tip) => {
            let before =
                (tip.index + given.loops[tip.ring].len() - 1) % given.loops[tip.ring].len();
            spike(face, corner(InRing { index: before, ..tip }), corner(tip))
        }
        BoundaryFault::HoleOutside { hole }
        | BoundaryFault::HoleInHole { hole, .. }
        | BoundaryFault::HoleAround { hole } => Place::key("faces")
            .then(face)
            .error(format!("hole {} of face {face} is not inside the face's outer loop", hole - 1)),
        // Corners are finite, and each loop has three.
        fault => face_error(face, fault),
    })?;
    let mut loops = given.loops.clone();
    // Newell's normal makes the outer loop counter-clockwise.
    turned.into_iter().filter(|&ring| ring > 0).for_each(|ring| loops[ring].reverse());
    Ok(loops)
}

fn spike(face: usize, from: u32, to: u32) -> DomainError {
    let is = format!("goes from corner {from} to corner {to} and straight back; remove the spike");
    face_error(face, is)
}

fn check_repeated(face: usize, loops: &[Vec<u32>]) -> Result<(), DomainError> {
    for corners in loops {
        let n = corners.len();
        // A spike has a better message than a corner that is passed twice.
        if let Some(i) = (0..n).find(|&i| corners[i] == corners[(i + 2) % n] && n > 3) {
            return Err(spike(face, corners[i], corners[(i + 1) % n]));
        }
    }
    let mut corners: Vec<u32> = loops.concat();
    corners.sort_unstable();
    match corners.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(face_error(
            face,
            format!(
                "passes corner {} twice; a face may not touch itself; cut it in two there",
                pair[0]
            ),
        )),
        None => Ok(()),
    }
}
