//! What the triangles are like one by one.

use super::{WORST, WorstTriangle};
use crate::parallel::blocks;
use crate::quality::{QualitySummary, TriangleQuality};
use crate::summary::Columns;
use crate::tri_mesh::TriMesh;
use glam::DVec3;
use std::ops::Range;

/// The findings.
pub(super) struct Shapes {
    pub(super) quality: QualitySummary,
    /// The triangles with the least angles, worst first; the first of equal ones first.
    pub(super) worst_triangles: Vec<WorstTriangle>,
    pub(super) zero_area_triangles: Vec<u32>,
}

impl Shapes {
    /// Looks at every triangle, with all threads.
    pub(super) fn of(mesh: &TriMesh) -> Self {
        // Triangles are numbered in u32.
        let count = mesh.triangles().len() as u32;
        let mut columns = Vec::new();
        let mut worst_triangles = Vec::new();
        let mut zero_area_triangles = Vec::new();
        for of_block in blocks(count, |range| Block::new(mesh, range)) {
            columns.push(of_block.columns);
            of_block
                .worst_triangles
                .into_iter()
                .for_each(|worst| rank(worst, &mut worst_triangles));
            zero_area_triangles.extend(of_block.zero_area_triangles);
        }
        let quality = QualitySummary::of_blocks(columns).expect("a mesh has a triangle");
        Self { quality, worst_triangles, zero_area_triangles }
    }
}

/// The findings on some triangles.
struct Block {
    columns: Columns,
    worst_triangles: Vec<WorstTriangle>,
    zero_area_triangles: Vec<u32>,
}

impl Block {
    fn new(mesh: &TriMesh, triangles: Range<u32>) -> Self {
        let mut worst_triangles = Vec::with_capacity(WORST);
        let mut zero_area_triangles = Vec::new();
        let qualities = triangles.map(|triangle| {
            let corners = mesh.triangles()[triangle as usize];
            let points = corners.map(|vertex| mesh.positions()[vertex as usize]);
            let [a, b, c] = points;
            let quality = TriangleQuality::in_space(a, b, c);
            if is_flat(points, &quality) {
                zero_area_triangles.push(triangle);
            }
            rank(WorstTriangle { triangle, quality }, &mut worst_triangles);
            quality
        });
        let columns = qualities.collect();
        Self { columns, worst_triangles, zero_area_triangles }
    }
}

/// Puts a triangle in its place among the worst of those before it, if it has one.
fn rank(triangle: WorstTriangle, worst: &mut Vec<WorstTriangle>) {
    let is_no_better =
        |other: &WorstTriangle| other.quality.min_angle <= triangle.quality.min_angle;
    let place = worst.iter().rposition(is_no_better).map_or(0, |before| before + 1);
    if place < WORST {
        worst.truncate(WORST - 1);
        worst.insert(place, triangle);
    }
}

/// Whether it takes no more than rounding to make a triangle flat.
///
/// To move a vertex by some length changes twice the area by that length times the edge
/// opposite at most, and so the height on the longest edge by no more than the length times the
/// share of that edge.
fn is_flat(points: [DVec3; 3], quality: &TriangleQuality) -> bool {
    const ROUNDING: f64 = 2.0 * f64::EPSILON;
    let [a, b, c] = points;
    let lengths = [c - b, a - c, b - a].map(|edge| edge.abs().max_element());
    let longest = lengths.into_iter().fold(0.0, f64::max);
    let moved = points
        .iter()
        .zip(lengths)
        .map(|(point, length)| ROUNDING * point.abs().max_element() * (length / longest));
    quality.minimum_height == 0.0 || quality.minimum_height <= moved.sum()
}
