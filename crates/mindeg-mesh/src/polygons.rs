//! The faces of a file before they were cut into triangles.

/// The polygons that a mesh's triangles were cut from.
///
/// The triangles of a polygon follow one another, in the order of polygons; a polygon of k corners
/// has k - 2 triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polygons {
    /// The index of each polygon's first triangle, then the number of triangles.
    pub triangle_starts: Vec<u32>,
    /// The corners of the first polygon in order, then those of the next.
    pub corners: Vec<u32>,
}

impl Polygons {
    /// The number of polygons.
    pub fn count(&self) -> usize {
        self.triangle_starts.len().saturating_sub(1)
    }

    /// The corners of a polygon in order.
    ///
    /// # Panics
    ///
    /// If `polygon` is not below [`count`](Self::count).
    pub fn corners(&self, polygon: usize) -> &[u32] {
        let start = |i: usize| self.triangle_starts[i] as usize + 2 * i;
        &self.corners[start(polygon)..start(polygon + 1)]
    }

    /// The corners of all polygons.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.count()).map(|polygon| self.corners(polygon))
    }
}

/// Counts of a file's elements that are not triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NonTriangles {
    /// Faces with four corners. Each was cut into two triangles.
    pub quads: u64,
    /// Faces with more corners. Each was cut into triangles.
    pub polygons: u64,
    /// Line segments.
    pub line_segments: u64,
    /// Single points. They were left out.
    pub points: u64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_know_their_corners() {
        let polygons =
            Polygons { triangle_starts: vec![0, 2, 3], corners: vec![0, 1, 2, 3, 0, 3, 4] };
        assert!(polygons.iter().eq([&[0, 1, 2, 3][..], &[0, 3, 4]]));
    }
}
