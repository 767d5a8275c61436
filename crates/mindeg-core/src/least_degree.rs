//! The entry point: one triangulation of least maximum degree.
//!
//! Limits: interval counts alone choose the triangulation; [`Candidates`] lists the others for
//! a caller that knows positions.

use crate::{Boundary, Candidates, Triangulation};

/// A triangulation with the least possible maximum degree: the first of [`Candidates`].
/// O(k) time and memory for k sides.
///
/// A cut splits the ring of sides into two runs of consecutive sides. The cut with the least
/// imbalance selects one of three constructions (Liu 2005, Section 3, extended from rectangles
/// to every convex polygon). In the figures the x chain runs counter-clockwise along the
/// bottom and the y chain clockwise along the top. Each triangle after the first ear is one
/// letter of the [`Word`](crate::Word): X for an edge on the x chain, Y for an edge on the y
/// chain.
///
/// # Zig-zag
///
/// If the runs differ by at most one interval, one strip with an alternating word joins them,
/// and each end is an ear. The degree is 4, or less for three and four intervals. Here (3,3,2,2),
/// cut at corners 3 and 8:
///
/// ```text
///         2-----1-----0-----9
///       / | \ Y | \ Y | \ Y | \
///     3   |  \  |  \  |  \  |   8
///       \ | X \ | X \ | X \ | /
///         4-----5-----6-----7
/// ```
///
/// # Dominant side
///
/// If the larger run is a single side, one strip with a balanced word joins it to the other
/// sides: the vertices opposite share its edges as equally as integers allow. The degree is
/// Theorem 4's ([`bound::side_bound`](crate::bound::side_bound)). Here (6,1,1,1), of degree 5:
///
/// ```text
///            8-----------------7
///         / / \ \      Y    / / \ \
///      /   /   \   \     /   /   \   \
///   0-----1-----2-----3-----4-----5-----6
///            X     X     X     X
/// ```
///
/// # Corner removal
///
/// Otherwise, a **corner strip** at a corner t inside the larger run removes as many intervals
/// as the runs differ by. Equal chains remain, and a zig-zag, the **main strip**, joins them.
/// The strips share the edge f–g. The degree is 5. Here (4,3,3), cut at corners 4 and 0, with
/// t = 7, f = 6 and g = 9:
///
/// ```text
///         3-------2-------1
///       / |  Y  / | \  Y  | \
///     4   |   /   |   \   |   0     main strip: Y X X Y
///       \ | /  X  |  X  \ | /
///         5-------6-------9
///                 | \   X |
///                 |   \   |         corner strip: X
///                 |     \ |
///                 7-------8
/// ```
///
/// The word XYXY of a plain zig-zag would give f, which has two edges of the corner strip, a
/// sixth edge. So one pair of letters is swapped (the adjustment of the paper's Figure 9).
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, least_degree_triangulation, verify};
///
/// let sides = [4, 3, 3];
/// let triangulation = least_degree_triangulation(&Boundary::new(&sides)?);
/// assert_eq!(triangulation.max_degree(), 5);
/// assert_eq!(verify(&sides, triangulation.triangles())?.max_degree, 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_degree_triangulation(boundary: &Boundary) -> Triangulation {
    Candidates::new(boundary).iter().next().expect("every boundary has a candidate")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Letter;
    use alloc::string::String;
    use alloc::vec::Vec;

    /// The letters and the chains in the figures above.
    #[test]
    fn the_figures_show_what_is_built() {
        for (sides, strips) in [
            (&[3, 3, 2, 2][..], &[("XYXYXY", &[4, 5, 6, 7][..], &[2, 1, 0, 9][..])][..]),
            (&[6, 1, 1, 1], &[("XXYXX", &[1, 2, 3, 4, 5], &[8, 7])]),
            (&[4, 3, 3], &[("YXXY", &[5, 6, 9], &[3, 2, 1]), ("X", &[8, 9], &[6])]),
        ] {
            let triangulation = least_degree_triangulation(&Boundary::new(sides).unwrap());
            assert_eq!(triangulation.strips().count(), strips.len());
            for (strip, &(spelling, x, y)) in triangulation.strips().zip(strips) {
                let word = strip.word();
                let letters = (0..word.len()).map(|index| word.letter(index));
                let letters = letters.map(|letter| if letter == Letter::X { 'X' } else { 'Y' });
                assert_eq!(letters.collect::<String>(), spelling);
                for (chain, vertices) in [(strip.x(), x), (strip.y(), y)] {
                    let found = (0..chain.len()).map(|index| chain.vertex(index));
                    assert_eq!(found.collect::<Vec<_>>(), vertices);
                }
            }
        }
    }
}
