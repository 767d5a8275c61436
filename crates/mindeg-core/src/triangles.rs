//! An iterator over all triangles, which computes them in blocks.
//!
//! Limits: the iterator always fills a whole block, so the first triangle after a jump costs as
//! much as the next 63 together.

use crate::Triangulation;

/// The number of triangles in a block: enough to amortise the start of a block, and few enough
/// to move the iterator cheaply.
const BLOCK: u32 = 64;

/// The triangles of a triangulation; see [`Triangulation::triangles`].
///
/// [`nth`](Iterator::nth) and [`skip`](Iterator::skip) are O(1).
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, TriangleIter, least_degree_triangulation};
///
/// let triangulation = least_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let mut triangles: TriangleIter<'_> = triangulation.triangles();
/// assert_eq!(triangles.next(), Some([3, 4, 2]));
/// assert_eq!(triangles.nth(6), Some([7, 8, 9]));
/// assert_eq!(triangles.len(), 0);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Debug)]
pub struct TriangleIter<'a> {
    triangulation: &'a Triangulation,
    /// The index of the next triangle.
    next: u32,
    /// The triangles `block_start..block_end`; the rest of the array is out of date.
    block: [[u32; 3]; BLOCK as usize],
    block_start: u32,
    block_end: u32,
}

// This method is here, not in `triangulation.rs`, so that the two files do not use each other.
impl Triangulation {
    /// All `n-2` triangles, each counter-clockwise, strip by strip. Amortised O(1) for each; to
    /// fill a buffer, [`fill_triangles`](Self::fill_triangles) is faster.
    pub fn triangles(&self) -> TriangleIter<'_> {
        let block = [[0; 3]; BLOCK as usize];
        TriangleIter { triangulation: self, next: 0, block, block_start: 0, block_end: 0 }
    }
}

impl Iterator for TriangleIter<'_> {
    type Item = [u32; 3];

    #[inline]
    fn next(&mut self) -> Option<[u32; 3]> {
        if self.next >= self.block_end {
            self.fill_block()?;
        }
        let triangle = self.block[(self.next - self.block_start) as usize];
        self.next += 1;
        Some(triangle)
    }

    fn nth(&mut self, skipped: usize) -> Option<[u32; 3]> {
        let skipped = u32::try_from(skipped).unwrap_or(u32::MAX);
        self.next = self.next.saturating_add(skipped).min(self.triangulation.triangle_count());
        self.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let len = (self.triangulation.triangle_count() - self.next) as usize;
        (len, Some(len))
    }
}

impl ExactSizeIterator for TriangleIter<'_> {}
impl core::iter::FusedIterator for TriangleIter<'_> {}

impl TriangleIter<'_> {
    /// Fills the block from the next triangle on; none if no triangle remains.
    fn fill_block(&mut self) -> Option<()> {
        let len = (self.triangulation.triangle_count() - self.next).min(BLOCK);
        if len == 0 {
            return None;
        }
        self.triangulation.fill_triangles(self.next, &mut self.block[..len as usize]);
        (self.block_start, self.block_end) = (self.next, self.next + len);
        Some(())
    }
}
