//! Rings that touch: one site for all vertices at a point, and the triangles of its sectors to each of them.

use std::collections::{BTreeMap, BTreeSet};

use mindeg_mesh::planar::PlanarBoundary;

/// The first vertex at the point of a vertex.
pub(crate) fn first(boundary: &PlanarBoundary, vertex: u32) -> u32 {
    boundary.twins(vertex).next().map_or(vertex, |twin| twin.min(vertex))
}

/// The edges that begin at a vertex after the first one at its point, by first vertices.
pub(crate) fn edges(boundary: &PlanarBoundary) -> BTreeSet<[u32; 2]> {
    let later = boundary.edges().filter(|[from, _]| first(boundary, *from) != *from);
    later.map(|edge| edge.map(|vertex| first(boundary, vertex))).collect()
}

/// Gives each of several vertices at one point the triangles of its sector; so far the first has them all.
pub(crate) fn share_out(boundary: &PlanarBoundary, triangles: &mut [[u32; 3]]) {
    let has_twins = |vertex: u32| boundary.twins(vertex).next().is_some();
    // At each point, from a neighbour: the triangle on the left of that edge, its corner, and the next neighbour.
    let mut after = BTreeMap::new();
    for (index, triangle) in triangles.iter().enumerate() {
        for corner in (0..3).filter(|&corner| has_twins(triangle[corner])) {
            let [at, from, to] = [0, 1, 2].map(|i| triangle[(corner + i) % 3]);
            after.insert([at, from], (index, corner, to));
        }
    }
    for vertex in (0..boundary.vertex_count()).filter(|&vertex| has_twins(vertex)) {
        let [at, last] = [vertex, boundary.previous(vertex)].map(|v| first(boundary, v));
        let mut from = first(boundary, boundary.next(vertex));
        while from != last
            && let Some((triangle, corner, to)) = after.remove(&[at, from])
        {
            triangles[triangle][corner] = vertex;
            from = to;
        }
    }
}
