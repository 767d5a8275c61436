//! Whether the loops of a face bound an area: simple, apart from each other, holes inside. Exact
//! for the coordinates in the plane of the face.

use std::ops::Range;

use glam::{DVec2, DVec3};
use mindeg_mesh::planar::{self, Fault};

use super::{ModelError, ModelFace, Plane};

/// The loops of a face, holes opposite to the outer loop; or why they bound no area.
pub(super) fn oriented(
    corners: &[DVec3],
    face: usize,
    given: &ModelFace,
    plane: &Plane,
) -> Result<Vec<Vec<u32>>, ModelError> {
    check_repeated(face, &given.loops)?;
    let all = given.loops.concat();
    let points: Vec<DVec2> =
        all.iter().map(|&corner| plane.project(corners[corner as usize])).collect();
    let mut rings: Vec<Range<u32>> = Vec::with_capacity(given.loops.len());
    for corners in &given.loops {
        let start = rings.last().map_or(0, |ring| ring.end);
        rings.push(start..start + corners.len() as u32);
    }
    let edge = |place: u32| {
        let ring = rings.iter().find(|ring| ring.contains(&place)).cloned().unwrap_or(0..1);
        let next = if place + 1 == ring.end { ring.start } else { place + 1 };
        [all[place as usize], all[next as usize]]
    };
    let nesting = planar::nesting(&points, &rings).map_err(|fault| match fault {
        Fault::SamePoint(places) => {
            ModelError::CoincidentCorners { corners: places.map(|place| all[place as usize]) }
        }
        Fault::Touch { vertex, edge: on } => {
            ModelError::Touch { face, corner: all[vertex as usize], edge: edge(on) }
        }
        Fault::Crossing(places) => ModelError::Crossing { face, edges: places.map(edge) },
        Fault::FoldsBack(tip) => {
            let ring = rings.iter().find(|ring| ring.contains(&tip)).cloned().unwrap_or(0..1);
            let before = if tip == ring.start { ring.end - 1 } else { tip - 1 };
            ModelError::Spike { face, from: all[before as usize], to: all[tip as usize] }
        }
    })?;
    let mut loops = given.loops.clone();
    for (index, (corners, nesting)) in loops.iter_mut().zip(nesting).enumerate().skip(1) {
        if nesting.parent != Some(0) {
            return Err(ModelError::HoleOutside { face, hole: index - 1 });
        }
        if nesting.is_counter_clockwise {
            corners.reverse();
        }
    }
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
