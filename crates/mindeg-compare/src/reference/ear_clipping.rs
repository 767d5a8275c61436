//! Ear clipping by the `earcut` crate.
//!
//! Limits: quadratic on boundary points of few sides, and not to be interrupted. Where points
//! of a slanted side are rounded it may leave flat triangles or leave some out.

use glam::DVec2;

/// The triangles as the crate gives them: counter-clockwise for a counter-clockwise outer ring. `holes`
/// are the first vertices of the rings after it.
pub(super) fn triangulate(points: &[DVec2], holes: &[u32]) -> Vec<[u32; 3]> {
    let mut indices: Vec<u32> = Vec::new();
    let points = points.iter().map(|point| point.to_array());
    earcut::Earcut::new().earcut(points, holes, &mut indices);
    indices.chunks_exact(3).map(|triangle| [triangle[0], triangle[1], triangle[2]]).collect()
}
