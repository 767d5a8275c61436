//! Triangles that are flat: all their vertices are on one straight run of the boundary.

use mindeg_mesh::parallel::first_of_blocks;
use mindeg_mesh::planar::PlanarBoundary;

/// The first triangle whose vertices are all on one straight run of the boundary.
pub(crate) fn first_flat(boundary: &PlanarBoundary, triangles: &[[u32; 3]]) -> Option<u32> {
    let after = boundary.runs();
    // The runs that end and begin at each vertex.
    let mut runs = vec![[0; 2]; after.len()];
    for [from, to] in boundary.edges() {
        runs[from as usize][1] = after[from as usize];
        runs[to as usize][0] = after[from as usize];
    }
    let count = u32::try_from(triangles.len()).unwrap_or(u32::MAX);
    first_of_blocks(count, |range| {
        range.into_iter().find(|&index| {
            let corners = triangles[index as usize];
            // Other vertices are interior points, or the checker's.
            let of = |corner: usize| runs.get(corners[corner] as usize).copied();
            let (Some(a), Some(b), Some(c)) = (of(0), of(1), of(2)) else { return false };
            a.iter().any(|run| b.contains(run) && c.contains(run))
        })
    })
}
