//! The shapes of the triangles, one by one.

use crate::parallel::blocks;
use crate::quality::{QualitySummary, TriangleQuality, WorstTriangles, is_flat};
use crate::summary::Columns;
use crate::tri_mesh::TriMesh;
use std::ops::Range;

/// The findings.
pub(super) struct Shapes {
    pub(super) quality: QualitySummary,
    pub(super) worst_triangles: WorstTriangles,
    pub(super) zero_area_triangles: Vec<u32>,
}

impl Shapes {
    /// Measures every triangle, with all threads, and keeps the `worst_count` worst.
    pub(super) fn of(mesh: &TriMesh, worst_count: usize) -> Self {
        // Triangles have indices of 32 bits.
        let count = mesh.triangles().len() as u32;
        let mut columns = Vec::new();
        let mut worst_triangles = WorstTriangles::new(worst_count);
        let mut zero_area_triangles = Vec::new();
        for of_block in blocks(count, |range| Block::new(mesh, range, worst_count)) {
            columns.push(of_block.columns);
            worst_triangles.append(&of_block.worst_triangles);
            zero_area_triangles.extend(of_block.zero_area_triangles);
        }
        let quality = QualitySummary::of_blocks(columns).expect("a mesh has a triangle");
        Self { quality, worst_triangles, zero_area_triangles }
    }
}

/// The findings on some triangles.
struct Block {
    columns: Columns,
    worst_triangles: WorstTriangles,
    zero_area_triangles: Vec<u32>,
}

impl Block {
    fn new(mesh: &TriMesh, triangles: Range<u32>, worst_count: usize) -> Self {
        let mut worst_triangles = WorstTriangles::new(worst_count);
        let mut zero_area_triangles = Vec::new();
        let qualities = triangles.map(|triangle| {
            let corners = mesh.triangles()[triangle as usize];
            let [a, b, c] = corners.map(|vertex| mesh.positions()[vertex as usize]);
            let mut quality = TriangleQuality::in_space(a, b, c);
            // Rounding may give a flat triangle some area.
            if is_flat([a, b, c], &quality) {
                quality = TriangleQuality::without_area(quality.edge_ratio);
                zero_area_triangles.push(triangle);
            }
            worst_triangles.add(triangle, quality);
            quality
        });
        let columns = qualities.collect();
        Self { columns, worst_triangles, zero_area_triangles }
    }
}
