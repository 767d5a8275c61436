//! Every optimal triangulation that the constructions allow, by number.
//!
//! As degrees go all candidates are equal; geometry can choose among them.
//!
//! Limits: not every optimal triangulation is a candidate, only those of one strip, or one strip and
//! one cap, that [`min_degree`](crate::min_degree) builds.

use crate::construction::{Construction, Heavy};
use crate::word::Letter;
use crate::{Boundary, Cut, Triangulation, best_cuts, bound, least_max_degree};
use alloc::vec::Vec;
use core::ops::Range;

/// The optimal triangulations that the constructions allow, no two of them the same.
///
/// There are three constructions, and the evenest cut decides which one applies; see
/// [`least_degree_triangulation`](crate::least_degree_triangulation). The choices they leave open:
///
/// - **Zig-zag**: each balanced cut, and where its runs are equal, both alternations.
/// - **Dominant side**: every rotation of the balanced word.
/// - **Corner removal**: each best cut, each corner inside its larger run for the cap, either end
///   of the edge under the cap to take the second edge of the cap, and either alternation of the
///   main strip.
///
/// That may be O(k²) candidates, or O(n) for a dominant side; none is built before it is asked for.
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
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Candidates<'a> {
    boundary: &'a Boundary,
    max_degree: u32,
    /// Each with the number of candidates in the families before it.
    families: Vec<(u64, Family)>,
    count: u64,
}

/// Candidates that differ in one number alone.
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
    /// The candidates for a boundary. O(k) time and memory.
    #[must_use]
    pub fn new(boundary: &'a Boundary) -> Self {
        let mut count = 0;
        let mut numbered = Vec::new();
        for family in families(boundary) {
            let before = count;
            count += family.len();
            numbered.push((before, family));
        }
        Self { boundary, max_degree: least_max_degree(boundary), families: numbered, count }
    }

    /// The number of candidates, at least 1. O(1).
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// All candidates, each built in O(log k).
    ///
    /// The order is fixed: alternations and the choice of an end change slowest, then the cut in
    /// the order of [`best_cuts`], then the corner or the rotation. The first candidate is the one of
    /// [`least_degree_triangulation`](crate::least_degree_triangulation).
    pub fn iter(&self) -> impl Iterator<Item = Triangulation> + '_ {
        (0..self.count).map(|number| self.candidate(number))
    }

    /// As many candidates as there are, but at most `limit.max(1)`: spread evenly over the order of
    /// [`iter`](Self::iter), the first one always among them.
    ///
    /// ```
    /// # use mindeg_core::{Boundary, Candidates};
    /// let boundary = Boundary::new(&[1000, 3, 5, 2])?;
    /// let candidates = Candidates::new(&boundary);
    /// assert_eq!(candidates.count(), 9);
    /// assert_eq!(candidates.sample(4).count(), 4);
    /// assert_eq!(candidates.sample(100).count(), 9);
    /// # Ok::<(), mindeg_core::BoundaryError>(())
    /// ```
    pub fn sample(&self, limit: u32) -> impl Iterator<Item = Triangulation> + '_ {
        let samples = self.count.min(u64::from(limit.max(1)));
        let spread =
            move |i: u64| (u128::from(i) * u128::from(self.count) / u128::from(samples)) as u64;
        (0..samples).map(move |i| self.candidate(spread(i)))
    }

    /// The candidate with the given number, below the count.
    fn candidate(&self, number: u64) -> Triangulation {
        // Of families that start alike only the last has candidates.
        let family = self.families.partition_point(|&(before, _)| before <= number) - 1;
        let (before, family) = &self.families[family];
        let number = number - before;
        let construction = |cut| Construction::new(self.boundary, cut);
        let (main, corner_strip) = match family {
            Family::SingleTriangle => (Construction::single_triangle(), None),
            Family::MedialTriangle => Construction::medial_triangle(),
            Family::ZigZag { cut, first } => (construction(cut).zig_zag(*first), None),
            Family::DominantSide { cut, rotations } => {
                // The middle rotation comes first: it is the most symmetric.
                let rotation = (number as u32 + rotations / 2) % rotations;
                // Shifts within one multiple of the common divisor spell the same word.
                let shift = rotation * ((cut.smaller - 1) / rotations);
                (construction(cut).dominant_side(shift), None)
            }
            Family::CornerRemoval { cut, heavy, first, corners } => {
                let corner = corners.start + number as usize;
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
        // Where one run is longer it goes first and last, and with no letters (n = 4) there is
        // nothing to alternate. All best cuts have one imbalance.
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

/// The corners of a cut's larger run, counted from its start, that a variant can cap.
///
/// All of them when X comes first with f heavy, or Y with g heavy. Otherwise the adjustment of
/// the main word may lack the neighbour it needs; and where the smaller run has 3 intervals the
/// adjusted word is the other alternation, so that the candidate is there already. No other two candidates
/// are the same: the tests see to it on every small boundary.
fn removable_corners(boundary: &Boundary, cut: &Cut, heavy: Heavy, first: Letter) -> Range<usize> {
    let fewer = cut.imbalance().div_ceil(2);
    let last_side = (cut.first_side + cut.side_count - 1) % boundary.side_count();
    let mut corners = 1..cut.side_count;
    match (heavy, first) {
        (Heavy::F, Letter::X) | (Heavy::G, Letter::Y) => {}
        _ if cut.smaller == 3 => corners.end = corners.start,
        // f would be x_1, with no x before it to take its first Y.
        (Heavy::F, Letter::Y) if boundary.intervals(cut.first_side) == fewer + 1 => {
            corners.start += 1;
        }
        // g would be x_{Q-1}, with no x after it to take its last Y.
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
