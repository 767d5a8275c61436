//! All triangles in turn, a block at a time.
//!
//! Limits: what is asked for one by one is still written in blocks, so the first triangle after a
//! leap costs as much as the next dozens together.

use crate::Triangulation;

/// How many triangles are written at a time: enough to forget the cost of starting, and few enough
/// for the iterator to be moved about.
const BLOCK: u32 = 64;

/// The triangles of a triangulation; see [`Triangulation::triangles`].
///
/// Leaps ([`nth`](Iterator::nth), [`skip`](Iterator::skip)) are O(1).
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Triangles, min_degree_triangulation};
///
/// let triangulation = min_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let mut triangles: Triangles<'_> = triangulation.triangles();
/// assert_eq!(triangles.next(), Some([3, 4, 2]));
/// assert_eq!(triangles.nth(6), Some([7, 8, 9]));
/// assert_eq!(triangles.len(), 0);
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Triangles<'a> {
    triangulation: &'a Triangulation,
    /// The number of the next triangle.
    next: u32,
    /// The triangles `block_start..block_end`, and what was there before.
    block: [[u32; 3]; BLOCK as usize],
    block_start: u32,
    block_end: u32,
}

impl<'a> Triangles<'a> {
    pub(crate) fn new(triangulation: &'a Triangulation) -> Self {
        let block = [[0; 3]; BLOCK as usize];
        Self { triangulation, next: 0, block, block_start: 0, block_end: 0 }
    }
}

impl Iterator for Triangles<'_> {
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

impl ExactSizeIterator for Triangles<'_> {}
impl core::iter::FusedIterator for Triangles<'_> {}

impl Triangles<'_> {
    /// Writes the next triangle and those after it into the block, or says that there is none.
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
