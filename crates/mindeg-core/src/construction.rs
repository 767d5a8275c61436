//! The three constructions: from a cut of the boundary to the strips of a triangulation.
//!
//! [`least_degree_triangulation`](crate::least_degree_triangulation) shows a figure of each.
//! Each leaves choices open, which do not change the maximum degree;
//! [`Candidates`](crate::Candidates) lists them.
//!
//! Source: Liu 2005, Section 3, extended from rectangles to every convex polygon.
//!
//! Limits: the constructions minimise the maximum degree over all vertices. They do not accept
//! degree limits on single vertices.

use crate::ring::Ring;
use crate::strip::{Chain, Direction, End, Jump, Strip};
use crate::word::{Letter, Word};
use crate::{Boundary, Cut};

/// In corner removal: which end of the shared edge f–g has two edges of the corner strip, the
/// shared edge included. The other end has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Heavy {
    /// The end before the removed corner.
    F,
    /// The end after it.
    G,
}

/// A cut of a boundary, from which each construction builds its strips in O(log k).
pub(crate) struct Construction<'a> {
    boundary: &'a Boundary,
    cut: &'a Cut,
    /// The corner at which the larger run starts.
    start: u32,
    /// The corner at which it ends.
    end: u32,
}

impl<'a> Construction<'a> {
    pub(crate) fn new(boundary: &'a Boundary, cut: &'a Cut) -> Self {
        let end_side = (cut.first_side + cut.side_count) % boundary.side_count();
        let (start, end) = (boundary.corner(cut.first_side), boundary.corner(end_side));
        Self { boundary, cut, start, end }
    }

    /// `len` vertices counter-clockwise; the first is `steps` after `vertex`.
    fn ahead(&self, vertex: u32, steps: u32, len: u32) -> Chain {
        let ring = self.boundary.ring();
        Chain::new(ring.forward(vertex, steps), len, Direction::CounterClockwise, ring)
    }

    /// `len` vertices clockwise; the first is the one before `vertex`.
    fn behind(&self, vertex: u32, len: u32) -> Chain {
        let ring = self.boundary.ring();
        Chain::new(ring.backward(vertex, 1), len, Direction::Clockwise, ring)
    }

    /// The strip between the inner vertices of the two runs, with an ear at each end.
    fn between_runs(&self, word: Word) -> Strip {
        let x = self.ahead(self.start, 1, self.cut.larger - 1);
        let y = self.behind(self.start, self.cut.smaller - 1);
        Strip::new(self.start, x, y, word, End::Ear(self.end))
    }

    /// For a balanced cut. If the runs are equal, Y may be first.
    pub(crate) fn zig_zag(&self, first: Letter) -> Strip {
        let (xs, ys) = (self.cut.larger - 2, self.cut.smaller - 2);
        self.between_runs(Word::alternating(first, xs, ys))
    }

    /// For a larger run of one side; [`Word::balanced`] explains `shift`.
    pub(crate) fn dominant_side(&self, shift: u32) -> Strip {
        let (xs, ys) = (self.cut.larger - 2, self.cut.smaller - 2);
        self.between_runs(Word::balanced(xs, ys, shift))
    }

    /// The main strip, and the corner strip at a corner of the larger run. `corner` counts the
    /// sides from the start of that run to the corner.
    ///
    /// ```text
    ///     f = y_1 ------------ g = x_1        f = x_i and g = x_{i+1} in the main strip
    ///          \ `-.     X    /
    ///           \  Y  `-.    /
    ///           y_0 ----- x_0              p = q = 2, f heavy, word Y X
    ///              \      /
    ///               \ ear/
    ///                 t
    /// ```
    ///
    /// The corner strip covers the `p` intervals before the corner t and the `q` after it, with
    /// `p + q = e + 1`. f and g have two boundary edges each. The heavy one has two edges of the
    /// corner strip, so for degree 5 it may have one more edge of the main strip. The other one
    /// may have two.
    pub(crate) fn corner_removal(
        &self,
        corner: usize,
        heavy: Heavy,
        first: Letter,
    ) -> (Strip, Option<Strip>) {
        let tip_side = (self.cut.first_side + corner) % self.boundary.side_count();
        let tip = self.boundary.corner(tip_side);
        let before_tip = self.boundary.ring().steps(self.start, tip);

        let removed = self.cut.imbalance() + 1;
        let (more, fewer) = (removed.div_ceil(2), removed / 2);
        let (p, q) = if heavy == Heavy::F { (fewer, more) } else { (more, fewer) };
        // The last letter decides which end is heavy; the word alternates back from there.
        let corner_first = match (heavy, p == q) {
            (Heavy::F, false) | (Heavy::G, true) => Letter::X,
            (Heavy::F, true) | (Heavy::G, false) => Letter::Y,
        };
        let corner_strip = Strip::new(
            tip,
            self.ahead(tip, 1, q),
            self.behind(tip, p),
            Word::alternating(corner_first, q - 1, p - 1),
            End::Shared,
        );

        // Each end side of the larger run has at least e intervals, or a better cut would exist.
        // That is at least p, and more than p if f is heavy; likewise for q and g. So the heavy
        // end is never a corner of the cut.
        let i = before_tip - p;
        let chain_len = self.cut.smaller - 1;
        let x = if i == 0 {
            self.ahead(self.start, p + q, chain_len)
        } else {
            let jump = Jump { after: i - 1, skipped: p + q - 1 };
            self.ahead(self.start, 1, chain_len).with_jump(jump)
        };
        let y = self.behind(self.start, chain_len);
        let heavy_index = if heavy == Heavy::F { i } else { i + 1 };
        let word = main_word(heavy, heavy_index, first, self.cut.smaller);
        (Strip::new(self.start, x, y, word, End::Ear(self.end)), Some(corner_strip))
    }

    /// (1,1,1), which has no interior edge.
    pub(crate) fn single_triangle() -> Strip {
        let ring = Ring::new(3);
        let x = Chain::new(1, 1, Direction::CounterClockwise, ring);
        let y = Chain::new(2, 1, Direction::Clockwise, ring);
        Strip::new(0, x, y, Word::alternating(Letter::X, 0, 0), End::Boundary)
    }

    /// (2,2,2): the zig-zag of the sides without corner 2, and the ear there as corner strip.
    pub(crate) fn medial_triangle() -> (Strip, Option<Strip>) {
        let ring = Ring::new(6);
        let jump = Jump { after: 0, skipped: 1 };
        let main = Strip::new(
            0,
            Chain::new(1, 2, Direction::CounterClockwise, ring).with_jump(jump),
            Chain::new(5, 1, Direction::Clockwise, ring),
            Word::alternating(Letter::X, 1, 0),
            End::Ear(4),
        );
        let corner_strip = Strip::new(
            2,
            Chain::new(3, 1, Direction::CounterClockwise, ring),
            Chain::new(1, 1, Direction::Clockwise, ring),
            Word::alternating(Letter::X, 0, 0),
            End::Shared,
        );
        (main, Some(corner_strip))
    }
}

/// The main strip's word in corner removal. It gives the heavy end, x_index, one edge.
///
/// Each chain has corners x_0 and x_Q (Q is `q` here) and Q-1 vertices between them. In the
/// alternating word every x has two edges, except the first (if X comes first) or the last (if Y
/// does). If the heavy end has two, swap its Y with the X beside it, so that the Y moves to the
/// neighbour that is not the other end of f–g (the adjustment of the paper's Figure 9):
///
/// ```text
/// f heavy:  … [X Y] X Y …  becomes  … [Y X] X Y …
/// g heavy:  … X [Y X] Y …  becomes  … X [X Y] Y …
/// ```
fn main_word(heavy: Heavy, index: u32, first: Letter, q: u32) -> Word {
    let word = Word::alternating(first, q - 2, q - 2);
    let single = if first == Letter::X { 1 } else { q - 1 };
    if index == single {
        return word;
    }
    // The Y of x_index. The X before it leads to x_index, the X after it away from x_index.
    let own_y = if first == Letter::X { 2 * index - 3 } else { 2 * index - 2 };
    word.with_swap(if heavy == Heavy::F { own_y - 1 } else { own_y })
}
