//! Faults in how faces join: an error if a mesh would make no sense, else a note.

use super::Model;
use crate::error::{DomainError, Place};
use mindeg_mesh::{number, sorted};

/// The maximum number of items that a note names.
const NAMED: usize = 6;

/// The error of a face.
pub(super) fn face_error(face: usize, is: impl std::fmt::Display) -> DomainError {
    Place::key("faces").then(face).error(format!("face {face} {is}"))
}

/// The error of an edge whose two corners coincide.
pub(super) fn coincident([first, second]: [u32; 2]) -> DomainError {
    Place::key("corners").then(second as usize).touch(format!(
        "corners {first} and {second} of an edge are at the same place; merge them or move one"
    ))
}

/// Refuses two faces with the same corners.
pub(super) fn check_face_twice(faces: &[Vec<Vec<u32>>]) -> Result<(), DomainError> {
    let mut keys: Vec<(Vec<u32>, usize)> = faces
        .iter()
        .enumerate()
        .map(|(index, loops)| {
            let mut corners: Vec<u32> = loops.iter().flatten().copied().collect();
            corners.sort_unstable();
            (corners, index)
        })
        .collect();
    keys.sort_unstable();
    for same in keys.chunk_by(|a, b| a.0 == b.0) {
        for (place, (_, second)) in same.iter().enumerate() {
            let has_same = |first: usize| edges(&faces[first]) == edges(&faces[*second]);
            if let Some((_, first)) = same[..place].iter().find(|(_, first)| has_same(*first)) {
                return Err(Place::key("faces").then(*second).error(format!(
                    "faces {first} and {second} have the same corners; remove one of them"
                )));
            }
        }
    }
    Ok(())
}

/// The edges of some loops, from the smaller corner to the larger, in order.
pub(super) fn edges<'a>(loops: impl IntoIterator<Item = &'a Vec<u32>>) -> Vec<[u32; 2]> {
    let of_loop = |corners: &'a Vec<u32>| {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&a, &b)| sorted([a, b]))
    };
    let mut edges: Vec<_> = loops.into_iter().flat_map(of_loop).collect();
    edges.sort_unstable();
    edges
}

/// The notes for the user, one sentence each.
pub(super) fn notes(model: &Model) -> Vec<String> {
    let mut notes = Vec::new();
    let boundary: Vec<usize> = model.boundary_edges().collect();
    if !boundary.is_empty() {
        let edges = named_edges(model, &boundary);
        let (verb, noun) = if boundary.len() == 1 { ("has", "edge") } else { ("have", "edges") };
        let count = boundary.len();
        notes.push(format!("The model is open: {count} {noun} {verb} one face: {edges}."));
    }
    let non_manifold: Vec<usize> = model.non_manifold_edges().collect();
    if !non_manifold.is_empty() {
        let edges = named_edges(model, &non_manifold);
        let (verb, noun) =
            if non_manifold.len() == 1 { ("has", "edge") } else { ("have", "edges") };
        let count = non_manifold.len();
        notes.push(format!("{count} {noun} {verb} three faces or more: {edges}."));
    }
    let is_flipped = |edge: &usize| matches!(model.edges[*edge].passes, [2, 0] | [0, 2]);
    let flipped: Vec<usize> = (0..model.edge_count()).filter(is_flipped).collect();
    if let Some(&first) = flipped.first() {
        let has = |face: &usize| {
            model.faces[*face].loops.iter().flatten().any(|pass| pass.edge as usize == first)
        };
        let faces: Vec<String> =
            (0..model.face_count()).filter(has).map(|face| face_text(model, face)).collect();
        let edges = named_edges(model, &flipped);
        let (count, noun) = (flipped.len(), if flipped.len() == 1 { "edge" } else { "edges" });
        notes.push(format!(
            "Flipped: {} run along their common edge in the same direction; turn one of them \
             round. {count} such {noun}: {edges}.",
            faces.join(" and ")
        ));
    }
    notes.extend(off_plane(model));
    notes
}

/// A face in a sentence.
fn face_text(model: &Model, face: usize) -> String {
    match model.face_name(face) {
        Some(name) => format!("face {face} ({name})"),
        None => format!("face {face}"),
    }
}

fn named_edges(model: &Model, edges: &[usize]) -> String {
    let text = |&edge: &usize| {
        let [low, high] = model.edge_corners(edge);
        match model.edge_name(edge) {
            Some(name) => format!("{name} ({low}-{high})"),
            None => format!("{low}-{high}"),
        }
    };
    let mut texts: Vec<String> = edges.iter().take(NAMED).map(text).collect();
    if edges.len() > NAMED {
        texts.push(format!("and {} more", edges.len() - NAMED));
    }
    format!("{} (by corners)", texts.join(", "))
}

/// Faces whose corners are off their plane by more than rounding, within the tolerance.
fn off_plane(model: &Model) -> Option<String> {
    let largest = model.corners.iter().map(|corner| corner.abs().max_element());
    let rounding = 16.0 * f64::EPSILON * largest.fold(0.0, f64::max);
    let mut count = 0;
    let mut worst = (0.0, 0);
    for face in 0..model.face_count() {
        let corners = model.face_loops(face).flatten().map(|c| model.corners[c as usize]);
        let distance = corners.map(|at| model.plane(face).distance(at)).fold(0.0, f64::max);
        count += usize::from(distance > rounding);
        if distance > worst.0 {
            worst = (distance, face);
        }
    }
    let (distance, face) = worst;
    let tolerance = model.planar_tolerance;
    (count > 0).then(|| {
        let (noun, verb) = if count == 1 { ("face", "is") } else { ("faces", "are") };
        format!(
            "{count} {noun} {verb} not quite planar: corners are up to {} off ({}), within the \
             tolerance of {}.",
            number(distance),
            face_text(model, face),
            number(tolerance)
        )
    })
}
