//! The algorithm: from a boundary to its triangulations of least maximum degree.
//!
//! The evenest cut decides which of three constructions applies (Liu 2005, Section 3, carried
//! over to every convex polygon):
//!
//! - **Zig-zag**, where the runs of a cut differ by at most one: one strip between the runs,
//!   an ear at either end, and an alternating word. Degree 4.
//! - **Dominant side**, where the larger run is a single side: one strip between that side and
//!   everything else, with a balanced word. The degree is Theorem 4's.
//! - **Corner removal**, otherwise: a cap round a corner inside the larger run takes away as
//!   many intervals as the runs differ by, and a zig-zag joins what is left. Degree 5.
//!
//! Each leaves choices open, all equally good as degrees go. [`Plans`] lists them, so that
//! geometry can choose.
//!
//! Limits: a plan is optimal for the whole boundary; caps on single vertices are not part of
//! these constructions.

use crate::strip::{Chain, Direction, End, Jump, Strip};
use crate::word::{Letter, Word};
use crate::{Boundary, Cut, Triangulation, best_cuts, bound, optimal_max_degree};
use alloc::vec::Vec;

/// A triangulation with the least possible maximum degree, the first of [`Plans`]. O(k).
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
    Plans::new(boundary).iter().next().expect("the first plan is always possible")
}

/// The optimal triangulations that the constructions allow, each once.
///
/// Zig-zag has both alternations of every balanced cut; the dominant side every rotation of
/// its balanced word; corner removal every corner inside the larger run of every best cut, with
/// either end of the shared edge taking the second edge of the cap, and both alternations of
/// the main strip.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Plans};
///
/// let boundary = Boundary::new(&[4, 4, 4, 4])?;
/// let plans = Plans::new(&boundary);
/// assert_eq!(plans.iter().count(), 4); // two cuts, two alternations
/// assert!(plans.iter().all(|triangulation| triangulation.max_degree() == 4));
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plans<'a> {
    boundary: &'a Boundary,
    max_degree: u32,
    construction: Construction,
}

#[derive(Clone, Debug)]
enum Construction {
    SingleTriangle,
    MedialTriangle,
    ZigZag { cuts: Vec<Cut> },
    DominantSide { cut: Cut, rotations: u32 },
    CornerRemoval { cuts: Vec<Cut>, corners_before: Vec<u64> },
}

/// In corner removal: which end of the shared edge has two edges of the cap, and how the main
/// word begins.
const VARIANTS: [(Heavy, Letter); 4] =
    [(Heavy::F, Letter::X), (Heavy::G, Letter::Y), (Heavy::G, Letter::X), (Heavy::F, Letter::Y)];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Heavy {
    F,
    G,
}

impl<'a> Plans<'a> {
    /// The plans for a boundary. O(k) time and memory.
    #[must_use]
    pub fn new(boundary: &'a Boundary) -> Self {
        let cuts: Vec<Cut> = best_cuts(boundary).collect();
        let cut = cuts[0];
        let construction = if boundary.vertex_count() == 3 {
            Construction::SingleTriangle
        } else if cut.is_balanced() {
            Construction::ZigZag { cuts }
        } else if bound::is_medial_exception(boundary) {
            Construction::MedialTriangle
        } else if cut.side_count == 1 {
            let runs = cut.smaller - 1;
            let rotations = runs / greatest_common_divisor(cut.larger - 2, runs);
            Construction::DominantSide { cut, rotations }
        } else {
            let corners_before = cuts
                .iter()
                .scan(0, |corners, cut| {
                    let before = *corners;
                    *corners += cut.side_count as u64 - 1;
                    Some(before)
                })
                .collect();
            Construction::CornerRemoval { cuts, corners_before }
        };
        Self { boundary, max_degree: optimal_max_degree(boundary), construction }
    }

    /// All plans in a fixed order. There may be as many as O(k²), or O(n) for a dominant side;
    /// each is built in O(log k) when it is asked for.
    pub fn iter(&self) -> impl Iterator<Item = Triangulation> + '_ {
        (0..self.slots()).filter_map(|slot| self.plan(slot))
    }

    /// At least one plan and at most `limit.max(1)`, spread evenly over all of them.
    pub fn sample(&self, limit: u32) -> impl Iterator<Item = Triangulation> + '_ {
        // An odd stride meets all variants in turn.
        let stride = self.slots().div_ceil(u64::from(limit.max(1))) | 1;
        (0..self.slots())
            .step_by(usize::try_from(stride).unwrap_or(usize::MAX))
            .filter_map(|slot| self.plan(slot))
    }

    /// Plans are numbered with gaps: some slots hold none, slot 0 always does.
    fn slots(&self) -> u64 {
        match &self.construction {
            Construction::SingleTriangle | Construction::MedialTriangle => 1,
            Construction::ZigZag { cuts } => 2 * cuts.len() as u64,
            Construction::DominantSide { rotations, .. } => u64::from(*rotations),
            Construction::CornerRemoval { cuts, corners_before } => {
                let corners = corners_before.iter().zip(cuts).next_back();
                let corners = corners.map_or(0, |(before, cut)| before + cut.side_count as u64 - 1);
                VARIANTS.len() as u64 * corners
            }
        }
    }

    fn plan(&self, slot: u64) -> Option<Triangulation> {
        let plan = self.build(slot)?;
        // On (1,2,3,2) and (2,3,3), and on no other boundary that an exhaustive search could
        // reach, two caps of one triangulation are both what corner removal would cut off.
        let is_repeated = self.boundary.vertex_count() == 8 && {
            let edges = |plan: &Triangulation| {
                let mut edges: Vec<[u32; 2]> = plan.interior_edges().collect();
                edges.iter_mut().for_each(|edge| edge.sort_unstable());
                edges.sort_unstable();
                edges
            };
            let earlier = (0..slot).filter_map(|slot| self.build(slot));
            earlier.into_iter().any(|earlier| edges(&earlier) == edges(&plan))
        };
        (!is_repeated).then_some(plan)
    }

    fn build(&self, slot: u64) -> Option<Triangulation> {
        let (main, cap) = match &self.construction {
            Construction::SingleTriangle => (single_triangle(), None),
            Construction::MedialTriangle => {
                let (main, cap) = medial_triangle();
                (main, Some(cap))
            }
            Construction::ZigZag { cuts } => {
                let first = if slot.is_multiple_of(2) { Letter::X } else { Letter::Y };
                (self.zig_zag(&cuts[(slot / 2) as usize], first)?, None)
            }
            Construction::DominantSide { cut, rotations } => {
                (self.dominant_side(cut, *rotations, slot as u32), None)
            }
            Construction::CornerRemoval { cuts, corners_before } => {
                let (corner, variant) = (slot / 4, VARIANTS[(slot % 4) as usize]);
                let place = corners_before.partition_point(|&before| before <= corner) - 1;
                let corner = 1 + (corner - corners_before[place]) as usize;
                let (main, cap) = self.corner_removal(&cuts[place], corner, variant)?;
                (main, Some(cap))
            }
        };
        Some(Triangulation::new(self.boundary.vertex_count(), self.max_degree, main, cap))
    }

    /// The corner at which the larger run of a cut starts, and the one where it ends.
    fn cut_corners(&self, cut: &Cut) -> (u32, u32) {
        let sides = self.boundary.side_count();
        let end = (cut.first_side + cut.side_count) % sides;
        (self.boundary.corner(cut.first_side), self.boundary.corner(end))
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

    fn zig_zag(&self, cut: &Cut, first: Letter) -> Option<Strip> {
        let (xs, ys) = (cut.larger - 2, cut.smaller - 2);
        // The longer chain goes first and last; and the empty word has one alternation.
        if first == Letter::Y && (xs != ys || xs == 0) {
            return None;
        }
        let (start, end) = self.cut_corners(cut);
        let x = self.ahead(start, 1, xs + 1);
        let y = self.behind(start, ys + 1);
        let word = Word::alternating(first, xs, ys);
        Some(Strip::new(x, y, word, End::Ear(start), End::Ear(end)))
    }

    fn dominant_side(&self, cut: &Cut, rotations: u32, rotation: u32) -> Strip {
        let (start, end) = self.cut_corners(cut);
        let (xs, ys) = (cut.larger - 2, cut.smaller - 2);
        // Shifts within one multiple of the common divisor spell the same word. The middle one
        // comes first: it is the most symmetric.
        let shift = (rotation + rotations / 2) % rotations * ((ys + 1) / rotations);
        let x = self.ahead(start, 1, xs + 1);
        let y = self.behind(start, ys + 1);
        Strip::new(x, y, Word::balanced(xs, ys, shift), End::Ear(start), End::Ear(end))
    }

    /// The main strip and the cap at the given corner of the larger run, counted from its start.
    ///
    /// The cap holds the `p` vertices before the corner t and the `q` after it, `p + q = e + 1`.
    /// Its far edge joins f and g, which are x_i and x_{i+1} of the main strip's larger chain.
    /// f and g have two boundary edges each, the heavy one two edges of the cap, the other one:
    /// so for degree 5 the heavy one can have one edge of the main strip, the other two.
    fn corner_removal(
        &self,
        cut: &Cut,
        corner: usize,
        (heavy, first): (Heavy, Letter),
    ) -> Option<(Strip, Strip)> {
        let vertices = self.boundary.vertex_count();
        let (start, end) = self.cut_corners(cut);
        let tip = self.boundary.corner((cut.first_side + corner) % self.boundary.side_count());
        let before_tip = if tip >= start { tip - start } else { vertices - (start - tip) };

        let removed = cut.imbalance() + 1;
        let (more, fewer) = (removed.div_ceil(2), removed / 2);
        let (p, q) = if heavy == Heavy::F { (fewer, more) } else { (more, fewer) };
        // The last letter decides which end has two edges, the word alternates back from there.
        let cap_first = match (heavy, p == q) {
            (Heavy::F, false) | (Heavy::G, true) => Letter::X,
            (Heavy::F, true) | (Heavy::G, false) => Letter::Y,
        };
        let cap = Strip::new(
            self.ahead(tip, 1, q),
            self.behind(tip, p),
            Word::alternating(cap_first, q - 1, p - 1),
            End::Ear(tip),
            End::Shared,
        );

        // The cut's end sides have at least e >= p, q intervals, or a better cut existed.
        let i = before_tip - p;
        let chain_len = cut.smaller - 1;
        let x = if i == 0 {
            self.ahead(start, p + q, chain_len)
        } else {
            let jump = Jump { after: i - 1, skipped: p + q - 1 };
            self.ahead(start, 1, chain_len).with_jump(jump)
        };
        let y = self.behind(start, chain_len);
        let word = main_word(heavy, first, i, cut.smaller)?;
        Some((Strip::new(x, y, word, End::Ear(start), End::Ear(end)), cap))
    }
}

/// The main strip's word in corner removal: it gives the heavy end at most one edge.
///
/// Both chains have corners x_0, x_Q and Q-1 vertices between them. In the alternating word
/// every x has two edges but the first (when X comes first) or the last (when Y does). If the
/// heavy end has two, its Y moves to the neighbour away from the other end of the shared edge
/// (the adjustment of the paper's Figure 9); there is no such plan without that neighbour.
fn main_word(heavy: Heavy, first: Letter, i: u32, q: u32) -> Option<Word> {
    let word = Word::alternating(first, q - 2, q - 2);
    let index = if heavy == Heavy::F { i } else { i + 1 };
    let is_cut_corner = index == 0 || index == q;
    let has_one_edge = index == if first == Letter::X { 1 } else { q - 1 };
    if is_cut_corner || has_one_edge {
        return Some(word);
    }
    // Where the Y of x_index stands; the X before it leads to x_index, the X after it away.
    let place = if first == Letter::X { 2 * index - 3 } else { 2 * index - 2 };
    match heavy {
        Heavy::F if index >= 2 => Some(word.with_swap(place - 1)),
        Heavy::G if index + 2 <= q => Some(word.with_swap(place)),
        _ => None,
    }
}

fn single_triangle() -> Strip {
    let x = Chain::new(1, 1, Direction::CounterClockwise, 3);
    let y = Chain::new(2, 1, Direction::Clockwise, 3);
    Strip::new(x, y, Word::alternating(Letter::X, 0, 0), End::Ear(0), End::Boundary)
}

/// (2,2,2): the zig-zag of the sides without corner 2, and the ear there as a cap.
fn medial_triangle() -> (Strip, Strip) {
    let main = Strip::new(
        Chain::new(1, 2, Direction::CounterClockwise, 6).with_jump(Jump { after: 0, skipped: 1 }),
        Chain::new(5, 1, Direction::Clockwise, 6),
        Word::alternating(Letter::X, 1, 0),
        End::Ear(0),
        End::Ear(4),
    );
    let cap = Strip::new(
        Chain::new(3, 1, Direction::CounterClockwise, 6),
        Chain::new(1, 1, Direction::Clockwise, 6),
        Word::alternating(Letter::X, 0, 0),
        End::Ear(2),
        End::Shared,
    );
    (main, cap)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
