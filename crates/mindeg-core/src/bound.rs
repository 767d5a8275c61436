//! How low the maximum degree can be: the statements of Liu 2005, by their numbers there.
//!
//! C.-L. Liu, "Minimum degree triangulation for rectangular domains", 2005. All of them hold
//! for every convex polygon, not only for rectangles; Theorem 10 needs one correction, given at
//! [`is_medial_exception`].

use crate::{Boundary, Cut, best_cuts};

/// Lemma 1: every triangulation on `vertices >= 3` boundary vertices has `n-2` triangles.
#[must_use]
pub fn triangle_count(vertices: u32) -> u32 {
    vertices - 2
}

/// Lemma 1: every triangulation on `vertices >= 3` boundary vertices has `n-3` interior edges.
#[must_use]
pub fn interior_edge_count(vertices: u32) -> u32 {
    vertices - 3
}

/// Lemma 2: every triangulation has at least this many isolated corners.
pub const LEAST_ISOLATED_CORNERS: u32 = 2;

/// Theorems 3 and 8: the bound from counting edges.
///
/// The degrees add up to `4n-6`. Two isolated corners take 4 of that, so one of the other
/// vertices has at least `(4n-10)/(n-2)`, rounded up: 2 for n = 3, 3 for n = 4, else 4.
#[must_use]
pub fn counting_bound(vertices: u32) -> u32 {
    let vertices = u64::from(vertices);
    (4 * vertices - 10).div_ceil(vertices - 2) as u32
}

/// Theorem 4: the bound from one side with `side` of all `vertices` intervals.
///
/// Every interior edge has an end off that side, so of the `n-a-1` vertices there one has at
/// least `(a-2)/(n-a-1)`, rounded up, plus 1 interior edges. It holds for `side <= vertices - 2`.
#[must_use]
pub fn side_bound(side: u32, vertices: u32) -> u32 {
    side.saturating_sub(2).div_ceil(vertices - side - 1) + 3
}

/// The zig-zag condition of Theorems 5 and 10: a cut whose runs differ by at most one. O(k).
///
/// With at least 7 intervals, degree 4 can be had if and only if there is one.
///
/// ```
/// # use mindeg_core::{Boundary, bound::zig_zag_condition};
/// assert!(zig_zag_condition(&Boundary::new(&[3, 3, 2, 2])?).is_some());
/// assert!(zig_zag_condition(&Boundary::new(&[30, 2, 4, 2])?).is_none());
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[must_use]
pub fn zig_zag_condition(boundary: &Boundary) -> Option<Cut> {
    best_cuts(boundary).next().filter(Cut::is_balanced)
}

/// Whether this is the triangle with every side halved, the only boundary that has degree 4
/// without a balanced cut.
///
/// As printed, Theorem 10 asks for `k+3` intervals on a k-sided polygon and so covers (2,2,2),
/// where it fails: the medial triangle and three ears have degree 4. The hypothesis that works
/// is at least 7 intervals, whatever k is. If three ears and degree 4 go together, every other
/// vertex has two interior edges, the three edges of the triangle between the ears close up,
/// and so n = 6.
#[must_use]
pub fn is_medial_exception(boundary: &Boundary) -> bool {
    boundary.sides().eq([2, 2, 2])
}
