//! The algorithm: from a cut of the boundary to a triangulation of least maximum degree.
//!
//! The evenest cut decides which of three constructions applies (Liu 2005, Section 3, carried
//! over to every convex polygon): zig-zag, dominant side or corner removal. Each leaves choices
//! open, all equally good as degrees go; [`Plans`] lists them.
//!
//! Limits: a plan is optimal for the whole boundary; caps on single vertices are not part of
//! these constructions.

use crate::strip::{Chain, Direction, End, Jump, Strip};
use crate::word::{Letter, Word};
use crate::{Boundary, Cut, Plans, Triangulation};

/// A triangulation with the least possible maximum degree, the first of [`Plans`]. O(k).
///
/// How it is built depends on the cut of the ring of sides into two runs with the most even
/// sums (Liu 2005, Section 3, carried over to every convex polygon):
///
/// - **Zig-zag**, where the runs differ by at most one interval: one strip between the runs, an
///   ear at either end, and an alternating word. Degree 4.
/// - **Dominant side**, where the larger run is a single side: one strip between that side and
///   everything else, with a balanced word. The degree is Theorem 4's.
/// - **Corner removal**, otherwise: a cap round a corner inside the larger run takes away as
///   many intervals as the runs differ by, and a zig-zag joins what is left. Degree 5.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, min_degree_triangulation, verify};
///
/// let sides = [12, 9, 4, 4];
/// let triangulation = min_degree_triangulation(&Boundary::new(&sides)?);
/// assert_eq!(triangulation.max_degree(), 5);
/// assert_eq!(verify(&sides, triangulation.triangles())?.max_degree, 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn min_degree_triangulation(boundary: &Boundary) -> Triangulation {
    Plans::new(boundary).iter().next().expect("every boundary has a plan")
}

/// In corner removal: which end of the edge under the cap has two edges of the cap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Heavy {
    /// The end before the cap's corner.
    F,
    /// The end after it.
    G,
}

/// A cut of a boundary, and the strips that can be built on it.
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

    /// `len` vertices counter-clockwise from the one `steps` after `vertex`.
    fn ahead(&self, vertex: u32, steps: u32, len: u32) -> Chain {
        let vertices = self.boundary.vertex_count();
        let first = ((u64::from(vertex) + u64::from(steps)) % u64::from(vertices)) as u32;
        Chain::new(first, len, Direction::CounterClockwise, vertices)
    }

    /// `len` vertices clockwise from the one before `vertex`.
    fn behind(&self, vertex: u32, len: u32) -> Chain {
        let vertices = self.boundary.vertex_count();
        let first = if vertex == 0 { vertices - 1 } else { vertex - 1 };
        Chain::new(first, len, Direction::Clockwise, vertices)
    }

    /// The strip between the inner vertices of the two runs, with an ear at either end.
    fn between_runs(&self, word: Word) -> Strip {
        let x = self.ahead(self.start, 1, self.cut.larger - 1);
        let y = self.behind(self.start, self.cut.smaller - 1);
        Strip::new(self.start, x, y, word, End::Ear(self.end))
    }

    /// For a balanced cut; Y may be first where the runs are equal.
    pub(crate) fn zig_zag(&self, first: Letter) -> Strip {
        let (xs, ys) = (self.cut.larger - 2, self.cut.smaller - 2);
        self.between_runs(Word::alternating(first, xs, ys))
    }

    /// For a larger run of one side; see [`Word::balanced`] for the shift.
    pub(crate) fn dominant_side(&self, shift: u32) -> Strip {
        let (xs, ys) = (self.cut.larger - 2, self.cut.smaller - 2);
        self.between_runs(Word::balanced(xs, ys, shift))
    }

    /// The main strip, and the cap at the given corner of the larger run, counted from its start.
    ///
    /// The cap holds the `p` vertices before the corner t and the `q` after it, `p + q = e + 1`.
    /// Its far edge joins f and g, which are x_i and x_{i+1} of the main strip's larger chain.
    /// f and g have two boundary edges each, the heavy one two edges of the cap, the other one:
    /// so for degree 5 the heavy one can have one edge of the main strip, the other two.
    pub(crate) fn corner_removal(
        &self,
        corner: usize,
        heavy: Heavy,
        first: Letter,
    ) -> (Strip, Option<Strip>) {
        let vertices = self.boundary.vertex_count();
        let tip_side = (self.cut.first_side + corner) % self.boundary.side_count();
        let tip = self.boundary.corner(tip_side);
        let before_tip =
            if tip >= self.start { tip - self.start } else { vertices - (self.start - tip) };

        let removed = self.cut.imbalance() + 1;
        let (more, fewer) = (removed.div_ceil(2), removed / 2);
        let (p, q) = if heavy == Heavy::F { (fewer, more) } else { (more, fewer) };
        // The last letter decides which end has two edges, the word alternates back from there.
        let cap_first = match (heavy, p == q) {
            (Heavy::F, false) | (Heavy::G, true) => Letter::X,
            (Heavy::F, true) | (Heavy::G, false) => Letter::Y,
        };
        let cap = Strip::new(
            tip,
            self.ahead(tip, 1, q),
            self.behind(tip, p),
            Word::alternating(cap_first, q - 1, p - 1),
            End::Shared,
        );

        // The end sides of the larger run have e intervals or more, or a better cut existed. That
        // is p at least, and more than p where f is heavy; likewise for q and g. So the heavy end
        // is never a corner of the cut.
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
        (Strip::new(self.start, x, y, word, End::Ear(self.end)), Some(cap))
    }

    pub(crate) fn single_triangle() -> Strip {
        let x = Chain::new(1, 1, Direction::CounterClockwise, 3);
        let y = Chain::new(2, 1, Direction::Clockwise, 3);
        Strip::new(0, x, y, Word::alternating(Letter::X, 0, 0), End::Boundary)
    }

    /// (2,2,2): the zig-zag of the sides without corner 2, and the ear there as a cap.
    pub(crate) fn medial_triangle() -> (Strip, Option<Strip>) {
        let jump = Jump { after: 0, skipped: 1 };
        let main = Strip::new(
            0,
            Chain::new(1, 2, Direction::CounterClockwise, 6).with_jump(jump),
            Chain::new(5, 1, Direction::Clockwise, 6),
            Word::alternating(Letter::X, 1, 0),
            End::Ear(4),
        );
        let cap = Strip::new(
            2,
            Chain::new(3, 1, Direction::CounterClockwise, 6),
            Chain::new(1, 1, Direction::Clockwise, 6),
            Word::alternating(Letter::X, 0, 0),
            End::Shared,
        );
        (main, Some(cap))
    }
}

/// The main strip's word in corner removal: it gives the heavy end one edge.
///
/// Both chains have corners x_0, x_Q and Q-1 vertices between them. In the alternating word
/// every x has two edges but the first (when X comes first) or the last (when Y does). If the
/// heavy end has two, its Y moves to the neighbour away from the other end of the edge under the
/// cap (the adjustment of the paper's Figure 9).
fn main_word(heavy: Heavy, index: u32, first: Letter, q: u32) -> Word {
    let word = Word::alternating(first, q - 2, q - 2);
    let single = if first == Letter::X { 1 } else { q - 1 };
    if index == single {
        return word;
    }
    // Where the Y of x_index stands; the X before it leads to x_index, the X after it away.
    let place = if first == Letter::X { 2 * index - 3 } else { 2 * index - 2 };
    word.with_swap(if heavy == Heavy::F { place - 1 } else { place })
}

pub(crate) fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
