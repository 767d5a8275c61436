//! The shapes of the triangles, one by one.

use crate::parallel::blocks;
use crate::quality::{QualitySummary, TriangleQuality, WorstTriangles, is_flat};
use crate::summary::Columns;
use crate::tri_mesh::TriMesh;

/// The quality of all triangles, the `worst_count` worst, and those without area. Shared by all threads.
pub(super) fn shapes(
    mesh: &TriMesh,
    worst_count: usize,
) -> (QualitySummary, WorstTriangles, Vec<u32>) {
    // Triangles have indices of 32 bits.
    let in_blocks = blocks(mesh.triangles().len() as u32, |triangles| {
        let (mut worst, mut flat) = (WorstTriangles::new(worst_count), Vec::new());
        let qualities = triangles.map(|triangle| {
            let corners = mesh.triangles()[triangle as usize];
            let [a, b, c] = corners.map(|vertex| mesh.positions()[vertex as usize]);
            let mut quality = TriangleQuality::in_space(a, b, c);
            // Rounding may give a flat triangle some area.
            if is_flat([a, b, c], &quality) {
                quality = TriangleQuality::without_area(quality.edge_ratio);
                flat.push(triangle);
            }
            worst.add(triangle, quality);
            quality
        });
        (qualities.collect::<Columns>(), worst, flat)
    });
    let (mut worst, mut flat) = (WorstTriangles::new(worst_count), Vec::new());
    let columns = in_blocks.into_iter().map(|(columns, worst_here, flat_here)| {
        worst.append(&worst_here);
        flat.extend(flat_here);
        columns
    });
    let quality = QualitySummary::of_blocks(columns.collect()).expect("a mesh has a triangle");
    (quality, worst, flat)
}
