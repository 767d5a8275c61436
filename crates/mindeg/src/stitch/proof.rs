//! The boundary of triangles, and the proof that they fill it.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_mesh::check;
use mindeg_mesh::planar::{BoundaryFault, BoundaryPlace, PlanarBoundary};

use super::gap::shown;
use crate::error::MeshError;

/// The boundary vertex after each boundary vertex of triangles.
pub(super) fn boundary_of(
    triangles: &[[u32; 3]],
    points: &[DVec2],
) -> Result<BTreeMap<u32, u32>, MeshError> {
    let edges = || triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut directed: Vec<[u32; 2]> = edges().collect();
    directed.sort_unstable();
    let mut next = BTreeMap::new();
    for [from, to] in edges() {
        if directed.binary_search(&[to, from]).is_err() && next.insert(from, to).is_some() {
            return Err(MeshError::Refused(format!(
                "a mesh touches itself at vertex {from}, at {}: give the boundary one place there",
                shown(points[from as usize])
            )));
        }
    }
    Ok(next)
}

/// The vertices of each ring of a boundary.
fn rings_of(next: &BTreeMap<u32, u32>) -> Vec<Vec<u32>> {
    let mut left: BTreeSet<u32> = next.keys().copied().collect();
    let mut rings: Vec<Vec<u32>> = Vec::new();
    while let Some(start) = left.pop_first() {
        let mut ring = vec![start];
        let mut at = next[&start];
        while left.remove(&at) {
            ring.push(at);
            at = next[&at];
        }
        rings.push(ring);
    }
    rings
}

/// Refuses meshes with boundaries that meet; `starts` has the first vertex of each mesh.
pub(super) fn apart(
    points: &[DVec2],
    next: &BTreeMap<u32, u32>,
    starts: &[u32],
) -> Result<(), MeshError> {
    let rings = rings_of(next);
    let at = |vertex: &u32| points[*vertex as usize];
    let points: Vec<Vec<DVec2>> = rings.iter().map(|ring| ring.iter().map(at).collect()).collect();
    // The rings of several meshes are no boundary; only where they meet counts here.
    let Err(faults) = PlanarBoundary::new(&points) else { return Ok(()) };
    let number = |vertex: u32| starts.partition_point(|start| *start <= vertex);
    for fault in faults.list() {
        if let [a, b] = places(fault, &rings)[..]
            && number(a) != number(b)
        {
            let [first, second] = [number(a).min(number(b)), number(a).max(number(b))];
            return Err(MeshError::Refused(format!(
                "meshes {first} and {second} overlap or touch near {}, and an area is for a gap between them: without it, the second one of two \
                 meshes makes place",
                shown(at(&a))
            )));
        }
    }
    Ok(())
}

/// Proves that triangles fill the rings of their boundary, which is one outer ring and holes.
pub(super) fn prove(
    points: &[DVec2],
    triangles: &[[u32; 3]],
    next: &BTreeMap<u32, u32>,
) -> Result<(), MeshError> {
    let mut rings = rings_of(next);
    let at = |vertex: u32| points[vertex as usize];
    let is_outer = |ring: &Vec<u32>| {
        let place = |index: usize| at(ring[index % ring.len()]);
        (0..ring.len()).map(|i| place(i).perp_dot(place(i + 1))).sum::<f64>() > 0.0
    };
    rings.sort_by_key(|ring| !is_outer(ring));
    if let Some(other) = rings.get(1).filter(|ring| is_outer(ring)) {
        return Err(MeshError::Refused(format!(
            "the area does not join all meshes: the one at {} stays apart, or lies on another",
            shown(at(other[0]))
        )));
    }
    let places: Vec<Vec<DVec2>> =
        rings.iter().map(|ring| ring.iter().map(|vertex| at(*vertex)).collect()).collect();
    let boundary = PlanarBoundary::new(&places).map_err(|faults| {
        let fault = faults.first();
        let vertices = self::places(&fault, &rings);
        let place = vertices.first().map_or_else(|| fault.to_string(), |vertex| shown(at(*vertex)));
        MeshError::Refused(format!(
            "the meshes overlap or touch at {place}: cut one of them back there"
        ))
    })?;
    let mut index = vec![u32::MAX; points.len()];
    (0..).zip(rings.iter().flatten()).for_each(|(new, old)| index[*old as usize] = new);
    let mut inner = Vec::new();
    for (vertex, index) in index.iter_mut().enumerate().filter(|(_, index)| **index == u32::MAX) {
        *index = boundary.vertex_count() + inner.len() as u32;
        inner.push(points[vertex]);
    }
    let triangles: Vec<[u32; 3]> =
        triangles.iter().map(|corners| corners.map(|vertex| index[vertex as usize])).collect();
    check::triangulation(&boundary, &inner, &triangles)?;
    Ok(())
}

/// The one or two places of a fault, as the rings have them.
pub(super) fn places<T: Copy>(fault: &BoundaryFault, rings: &[Vec<T>]) -> Vec<T> {
    let places = match *fault {
        BoundaryFault::SamePoint(both) | BoundaryFault::Crossing(both) => both.to_vec(),
        BoundaryFault::Touch { vertex, edge } => vec![vertex, edge],
        BoundaryFault::FoldsBack(at) => vec![BoundaryPlace::Ring(at)],
        BoundaryFault::HoleOutside { hole } => {
            return rings.get(hole).and_then(|ring| ring.first()).copied().into_iter().collect();
        }
        _ => Vec::new(),
    };
    let of_rings = places.into_iter().filter_map(|place| match place {
        BoundaryPlace::Ring(at) => rings.get(at.ring)?.get(at.index).copied(),
        _ => None,
    });
    of_rings.collect()
}
