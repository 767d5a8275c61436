//! Every optimal triangulation that the constructions allow, by index.
//!
//! All candidates have the same maximum degree; a caller that knows positions can choose among
//! them by their angles.
//!
//! Limits: not every optimal triangulation is a candidate, only the ones that a construction
//! builds from one strip, or from a main strip and a corner strip.

use crate::construction::{Construction, Heavy};
use crate::word::Letter;
use crate::{Boundary, Cut, Triangulation, best_cuts, bound, least_max_degree};
use alloc::vec::Vec;
use core::ops::Range;

/// The optimal triangulations that the constructions allow, no two of them equal.
///
/// The cut with the least imbalance selects one of three constructions, which
/// [`least_degree_triangulation`](crate::least_degree_triangulation) shows in figures. Each leaves
/// choices open:
///
/// - **Zig-zag**: each balanced cut, and both alternations if its runs are equal.
/// - **Dominant side**: every rotation of the balanced word.
/// - **Corner removal**: each best cut, each corner inside its larger run, either end of the
///   strips' shared edge as the one with two edges of the corner strip, and either alternation
///   of the main strip.
///
/// This may be O(k²) candidates, or O(n) for a dominant side. Each is built on demand.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Candidates};
///
/// let boundary = Boundary::new(&[4, 4, 4, 4])?;
/// let candidates = Candidates::new(&boundary);
/// assert_eq!(candidates.count(), 4); // two cuts, two alternations
/// assert!(candidates.iter().all(|triangulation| triangulation.max_degree() == 4));
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Debug)]
pub struct Candidates<'a> {
    boundary: &'a Boundary,
    max_degree: u32,
    /// Each family, with the number of candidates in the families before it.
    families: Vec<(u64, Family)>,
    count: u64,
}

/// Candidates that differ in one parameter only.
#[derive(Clone, Debug)]
enum Family {
    SingleTriangle,
    MedialTriangle,
    ZigZag { cut: Cut, first: Letter },
    DominantSide { cut: Cut, rotations: u32 },
    CornerRemoval { cut: Cut, heavy: Heavy, first: Letter, corners: Range<usize> },
}

impl Family {
    fn len(&self) -> u64 {
        match self {
            Self::SingleTriangle | Self::MedialTriangle | Self::ZigZag { .. } => 1,
            Self::DominantSide { rotations, .. } => u64::from(*rotations),
            Self::CornerRemoval { corners, .. } => corners.len() as u64,
        }
    }
}

impl<'a> Candidates<'a> {
    /// The candidates for a boundary. O(k) time and memory; builds none of them.
    pub fn new(boundary: &'a Boundary) -> Self {
        let mut count = 0;
        let mut indexed = Vec::new();
        for family in families(boundary) {
            let before = count;
            count += family.len();
            indexed.push((before, family));
        }
        Self { boundary, max_degree: least_max_degree(boundary), families: indexed, count }
    }

    /// The number of candidates, at least 1. O(1).
    pub fn count(&self) -> u64 {
        self.count
    }

    /// All candidates, each built in O(log k).
    ///
    /// The order is fixed. The alternation and the choice of an end change slowest, then the cut
    /// in the order of [`best_cuts`], then the corner or the rotation.
    /// [`least_degree_triangulation`](crate::least_degree_triangulation) is the first candidate.
    pub fn iter(&self) -> impl Iterator<Item = Triangulation> + '_ {
        (0..self.count).map(|index| self.candidate(index))
    }

    /// At most `limit.max(1)` candidates, at equal distances in the order of
    /// [`iter`](Self::iter). The first candidate is always one of them.
    ///
    /// ```
    /// # use mindeg_core::{Boundary, Candidates};
    /// let boundary = Boundary::new(&[1000, 3, 5, 2])?;
    /// let candidates = Candidates::new(&boundary);
    /// assert_eq!(candidates.count(), 9);
    /// assert_eq!(candidates.sample(4).count(), 4);
    /// assert_eq!(candidates.sample(100).count(), 9);
    /// # Ok::<(), mindeg_core::Defect>(())
    /// ```
    pub fn sample(&self, limit: u32) -> impl Iterator<Item = Triangulation> + '_ {
        let samples = self.count.min(u64::from(limit.max(1)));
        let spread =
            move |i: u64| (u128::from(i) * u128::from(self.count) / u128::from(samples)) as u64;
        (0..samples).map(move |i| self.candidate(spread(i)))
    }

    /// The candidate at `index`, in `0..count`.
    fn candidate(&self, index: u64) -> Triangulation {
        // Among families with the same `before`, only the last is not empty.
        let family = self.families.partition_point(|&(before, _)| before <= index) - 1;
        let (before, family) = &self.families[family];
        let index = index - before;
        let construction = |cut| Construction::new(self.boundary, cut);
        let (main, corner_strip) = match family {
            Family::SingleTriangle => (Construction::single_triangle(), None),
            Family::MedialTriangle => Construction::medial_triangle(),
            Family::ZigZag { cut, first } => (construction(cut).zig_zag(*first), None),
            Family::DominantSide { cut, rotations } => {
                // The middle rotation is first because it is the most symmetric.
                let rotation = (index as u32 + rotations / 2) % rotations;
                // Shifts below one multiple of the common divisor give the same word.
                let shift = rotation * ((cut.smaller - 1) / rotations);
                (construction(cut).dominant_side(shift), None)
            }
            Family::CornerRemoval { cut, heavy, first, corners } => {
                let index =
                    usize::try_from(index).expect("a family has fewer candidates than corners");
                let corner = corners.start + index;
                construction(cut).corner_removal(corner, *heavy, *first)
            }
        };
        Triangulation::new(self.boundary.ring(), self.max_degree, main, corner_strip)
    }
}

fn families(boundary: &Boundary) -> Vec<Family> {
    let cuts: Vec<Cut> = best_cuts(boundary).collect();
    let cut = cuts[0];
    if boundary.vertex_count() == 3 {
        [Family::SingleTriangle].into()
    } else if cut.is_balanced() {
        // A longer run has the first and the last letter, so it leaves no choice. A word without
        // letters (n = 4) has no alternation. All best cuts have the same imbalance.
        let both = cut.imbalance() == 0 && cut.smaller > 2;
        let firsts = if both { &[Letter::X, Letter::Y][..] } else { &[Letter::X] };
        firsts
            .iter()
            .flat_map(|&first| cuts.iter().map(move |&cut| Family::ZigZag { cut, first }))
            .collect()
    } else if bound::is_medial_exception(boundary) {
        [Family::MedialTriangle].into()
    } else if cut.side_count == 1 {
        let runs = cut.smaller - 1;
        let rotations = runs / greatest_common_divisor(cut.larger - 2, runs);
        [Family::DominantSide { cut, rotations }].into()
    } else {
        let variants = [
            (Heavy::F, Letter::X),
            (Heavy::G, Letter::Y),
            (Heavy::G, Letter::X),
            (Heavy::F, Letter::Y),
        ];
        let family = |(heavy, first), cut| {
            let corners = removable_corners(boundary, &cut, heavy, first);
            Family::CornerRemoval { cut, heavy, first, corners }
        };
        variants
            .into_iter()
            .flat_map(|variant| cuts.iter().map(move |&cut| family(variant, cut)))
            .collect()
    }
}

/// The corners of a cut's larger run, counted from its start, that a variant can remove.
///
/// These are all corners if X is first and f is heavy, or Y is first and g is heavy. Otherwise
/// the swap in the main word may lack the neighbour it needs. And if the smaller run has 3
/// intervals, the swapped word is the other alternation, which is already a candidate. No other
/// two candidates are equal: the tests check this on every small boundary.
fn removable_corners(boundary: &Boundary, cut: &Cut, heavy: Heavy, first: Letter) -> Range<usize> {
    let fewer = cut.imbalance().div_ceil(2);
    let last_side = (cut.first_side + cut.side_count - 1) % boundary.side_count();
    let mut corners = 1..cut.side_count;
    match (heavy, first) {
        (Heavy::F, Letter::X) | (Heavy::G, Letter::Y) => {}
        _ if cut.smaller == 3 => corners.end = corners.start,
        // f would be x_1, with no x before it to receive its Y.
        (Heavy::F, Letter::Y) if boundary.intervals(cut.first_side) == fewer + 1 => {
            corners.start += 1;
        }
        // g would be x_{Q-1}, with no x after it to receive its Y.
        (Heavy::G, Letter::X) if boundary.intervals(last_side) == fewer + 1 => {
            corners.end -= 1;
        }
        _ => {}
    }
    corners
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
