//! The strip between two rings: the triangles that join two closed loops of vertices.
//!
//! Two rings of p and q vertices are the two boundaries of a tube or of an annulus. A strip joins
//! them by p + q triangles without any new vertex. Going round, it advances along one ring or the
//! other, so a cyclic word of p letters X and q letters Y describes it.
//!
//! # The least maximum degree
//!
//! A vertex has its two ring edges, one edge to the other ring, and one more for each letter of
//! the other kind while the strip stays at the vertex. So the p + q letters give the x ring q edges
//! beyond the first three of each vertex, and the y ring p of them.
//!
//! **Theorem.** The least maximum degree of a strip between rings of p >= q vertices is
//! 3 + ⌈p/q⌉.
//!
//! *Lower bound.* The q vertices of the y ring share p edges beyond 3 each, so one of them has
//! ⌈p/q⌉ or more.
//!
//! *Construction.* Let n = p + q, and let ⌊kp/n⌋ of the first k letters be X. Then ⌈kq/n⌉ of them
//! are Y, so the j-th Y (from 0) is the letter at ⌊jn/q⌋, the last k with ⌈kq/n⌉ = j. Two
//! neighbouring Y, the last and the first included, are ⌊n/q⌋ or ⌈n/q⌉ letters apart, with
//! n/q = p/q + 1, so ⌊p/q⌋ or ⌈p/q⌉ X are between them. In the same way the j-th X is the letter
//! before ⌈(j+1)n/p⌉, and ⌊q/p⌋ or ⌈q/p⌉ <= 1 Y are between two neighbouring X. So the largest
//! degree on the y ring is 3 + ⌈p/q⌉ and on the x ring at most 4 <= 3 + ⌈p/q⌉. ∎
//!
//! `tests/ring_strips.rs` compares this with all words of all rings up to nine vertices.

use crate::Defect;
use crate::boundary::MAX_VERTICES;
use crate::word::Letter;
use alloc::format;

/// The strip of least maximum degree between two rings. O(1) memory, O(1) for each question.
///
/// The x ring has the vertices `0..xs`, the y ring `xs..xs + ys`. Both run in the same direction
/// round the tube. Every triangle runs forward along the x ring, or backward along the y ring: seen
/// from a side on which the x ring is the outer one and counter-clockwise, all triangles are
/// counter-clockwise.
///
/// # Example
///
/// ```
/// use mindeg_core::RingStrip;
///
/// let strip = RingStrip::new(8, 3)?;
/// assert_eq!(strip.max_degree(), 6);
/// assert_eq!(strip.triangles().count(), 11);
/// assert_eq!(strip.triangle(0), [0, 9, 8]);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RingStrip {
    xs: u32,
    ys: u32,
}

impl RingStrip {
    /// The strip between rings of `xs` and `ys` vertices.
    ///
    /// # Errors
    ///
    /// A ring of fewer than three vertices, or more than [`MAX_VERTICES`] in all.
    pub fn new(xs: u32, ys: u32) -> Result<Self, Defect> {
        let vertices = xs.min(ys);
        if vertices < 3 {
            return Err(Defect::new(format!("a ring has {vertices} vertices; the minimum is 3")));
        }
        let vertices = u64::from(xs) + u64::from(ys);
        if vertices > u64::from(MAX_VERTICES) {
            return Err(Defect::new(format!(
                "the rings have {vertices} vertices; the maximum is {MAX_VERTICES}"
            )));
        }
        Ok(Self { xs, ys })
    }

    /// The number of vertices of the x ring.
    pub fn xs(&self) -> u32 {
        self.xs
    }

    /// The number of vertices of the y ring.
    pub fn ys(&self) -> u32 {
        self.ys
    }

    /// The number of triangles, of letters, and of edges between the rings.
    #[expect(clippy::len_without_is_empty, reason = "a strip is never empty")]
    pub fn len(&self) -> u32 {
        self.xs + self.ys
    }

    /// The largest degree of a vertex: its two ring edges and those of the strip. No strip between
    /// these rings has less.
    pub fn max_degree(&self) -> u32 {
        3 + self.xs.max(self.ys).div_ceil(self.xs.min(self.ys))
    }

    /// The letter at an index in `0..len`.
    ///
    /// # Panics
    ///
    /// If `index` is not below [`len`](Self::len).
    pub fn letter(&self, index: u32) -> Letter {
        self.assert_index(index);
        if self.xs_before(index + 1) > self.xs_before(index) { Letter::X } else { Letter::Y }
    }

    /// The triangle of the letter at an index in `0..len`.
    ///
    /// # Panics
    ///
    /// If `index` is not below [`len`](Self::len).
    pub fn triangle(&self, index: u32) -> [u32; 3] {
        let letter = self.letter(index);
        let i = self.xs_before(index);
        let j = index - i;
        // After its last step, a ring is at its first vertex again.
        let x = |i: u32| if i == self.xs { 0 } else { i };
        let y = |j: u32| self.xs + if j == self.ys { 0 } else { j };
        match letter {
            Letter::X => [x(i), x(i + 1), y(j)],
            Letter::Y => [x(i), y(j + 1), y(j)],
        }
    }

    /// All triangles, in the order of their letters.
    pub fn triangles(self) -> impl ExactSizeIterator<Item = [u32; 3]> {
        (0..self.len()).map(move |index| self.triangle(index))
    }

    /// The number of X before an index in `0..=len`.
    fn xs_before(&self, index: u32) -> u32 {
        (u64::from(index) * u64::from(self.xs) / u64::from(self.len())) as u32
    }

    fn assert_index(&self, index: u32) {
        let len = self.len();
        assert!(index < len, "index {index} is out of range; the strip has {len} triangles");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::{String, ToString};

    fn spelled(xs: u32, ys: u32) -> String {
        let strip = RingStrip::new(xs, ys).unwrap();
        let letters = (0..strip.len()).map(|index| strip.letter(index));
        letters.map(|letter| if letter == Letter::X { 'X' } else { 'Y' }).collect()
    }

    #[test]
    #[should_panic(expected = "index 7 is out of range; the strip has 7 triangles")]
    fn no_triangle_follows_the_last() {
        let _ = RingStrip::new(4, 3).unwrap().triangle(7);
    }

    #[test]
    fn words_are_balanced() {
        assert_eq!(spelled(3, 3), "YXYXYX");
        assert_eq!(spelled(8, 3), "YXXYXXXYXXX");
        assert_eq!(spelled(3, 7), "YYYXYYXYYX");
    }

    #[test]
    fn rings_that_are_too_small_or_too_large_are_refused() {
        for (xs, ys, message) in [
            (2, 9, "a ring has 2 vertices; the minimum is 3"),
            (3, 0, "a ring has 0 vertices; the minimum is 3"),
            (u32::MAX - 3, 3, "the rings have 4294967295 vertices; the maximum is 4294967294"),
        ] {
            assert_eq!(RingStrip::new(xs, ys).unwrap_err().to_string(), message);
        }
        let largest = RingStrip::new(MAX_VERTICES - 3, 3).unwrap();
        assert_eq!(largest.triangle(largest.len() - 1), [MAX_VERTICES - 4, 0, MAX_VERTICES - 3]);
        assert_eq!(largest.max_degree(), 3 + (MAX_VERTICES - 3).div_ceil(3));
    }
}
