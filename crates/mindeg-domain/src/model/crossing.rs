//! Whether the loops of a face bound an area: simple, apart from each other, holes inside. Exact
//! for the coordinates in the plane of the face.

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::{BoundaryFault, InRing, PlanarBoundary};

use super::{ModelError, ModelFace, Plane};

/// The loops of a face, holes opposite to the outer loop; or why they bound no area.
pub(super) fn oriented(
    corners: &[DVec3],
    face: usize,
    given: &ModelFace,
    plane: &Plane,
) -> Result<Vec<Vec<u32>>, ModelError> {
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
        BoundaryFault::SamePoint(places) => {
            ModelError::CoincidentCorners { corners: places.map(corner) }
        }
        BoundaryFault::Touch { vertex, edge: on } => {
            ModelError::Touch { face, corner: corner(vertex), edge: edge(on) }
        }
        BoundaryFault::Crossing(places) => ModelError::Crossing { face, edges: places.map(edge) },
        BoundaryFault::FoldsBack(tip) => {
            let before =
                (tip.index + given.loops[tip.ring].len() - 1) % given.loops[tip.ring].len();
            let from = corner(InRing { index: before, ..tip });
            ModelError::Spike { face, from, to: corner(tip) }
        }
        BoundaryFault::HoleOutside { hole }
        | BoundaryFault::HoleInHole { hole, .. }
        | BoundaryFault::HoleAround { hole } => ModelError::HoleOutside { face, hole: hole - 1 },
        // Corners are finite, and each loop has three.
        _ => ModelError::NoArea { face },
    })?;
    let mut loops = given.loops.clone();
    // Newell's normal makes the outer loop counter-clockwise.
    turned.into_iter().filter(|&ring| ring > 0).for_each(|ring| loops[ring].reverse());
    Ok(loops)
}

fn check_repeated(face: usize, loops: &[Vec<u32>]) -> Result<(), ModelError> {
    for corners in loops {
        let n = corners.len();
        // A spike has a better message than a corner that is passed twice.
        if let Some(i) = (0..n).find(|&i| corners[i] == corners[(i + 2) % n] && n > 3) {
            return Err(ModelError::Spike { face, from: corners[i], to: corners[(i + 1) % n] });
        }
    }
    let mut corners: Vec<u32> = loops.concat();
    corners.sort_unstable();
    match corners.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(ModelError::RepeatedCorner { face, corner: pair[0] }),
        None => Ok(()),
    }
}
