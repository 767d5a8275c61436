//! The worst triangles of a mesh.

use crate::quality::TriangleQuality;

/// A triangle and its measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTriangle {
    /// The index of the triangle.
    pub triangle: u32,
    /// Its measures.
    pub quality: TriangleQuality,
}

/// The triangles with the least minimum angles, worst first. Of equal angles, the triangle that was
/// added first comes first.
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::{TriangleQuality, WorstTriangles};
///
/// let mut worst = WorstTriangles::new(2);
/// for (triangle, width) in [(0, 1.0), (1, 9.0), (2, 3.0)] {
///     let quality =
///         TriangleQuality::of([0.0, 0.0].into(), [width, 0.0].into(), [0.0, 1.0].into());
///     worst.add(triangle, quality);
/// }
/// assert!(worst.iter().map(|worst| worst.triangle).eq([1, 2]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WorstTriangles {
    count: usize,
    worst: Vec<WorstTriangle>,
}

impl WorstTriangles {
    /// Starts empty and keeps at most `count` triangles.
    pub fn new(count: usize) -> Self {
        Self { count, worst: Vec::with_capacity(count) }
    }

    /// Adds a triangle; if there are too many, drops the best. O(count).
    pub fn add(&mut self, triangle: u32, quality: TriangleQuality) {
        let place = self.worst.partition_point(|w| w.quality.min_angle <= quality.min_angle);
        if place < self.count {
            self.worst.truncate(self.count - 1);
            self.worst.insert(place, WorstTriangle { triangle, quality });
        }
    }

    /// Adds the triangles of the block that follows.
    pub fn append(&mut self, next: &Self) {
        next.iter().for_each(|worst| self.add(worst.triangle, worst.quality));
    }

    /// The triangles, worst first.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &WorstTriangle> {
        self.worst.iter()
    }

    /// The worst triangle; `None` if the list is empty.
    pub fn first(&self) -> Option<&WorstTriangle> {
        self.worst.first()
    }
}
