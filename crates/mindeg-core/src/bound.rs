//! Lower bounds on the maximum degree: the statements of Liu 2005, by their numbers there.
//!
//! Pangfeng Liu, "Minimum degree triangulation for rectangular domains", 2005. All statements hold
//! for every convex polygon, not only for rectangles. Theorem 10 needs one correction; see
//! [`is_medial_exception`].
//!
//! Limits: each function is one statement. [`certificate`](crate::certificate()) selects the sharp
//! one for a boundary.

use crate::Boundary;

/// Lemma 1: the number of triangles in every triangulation of a boundary, `n-2`. O(1).
///
/// ```
/// # use mindeg_core::{Boundary, bound};
/// assert_eq!(bound::triangle_count(&Boundary::new(&[3, 3, 2, 2])?), 8);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn triangle_count(boundary: &Boundary) -> u32 {
    boundary.vertex_count() - 2
}

/// Lemma 1: the number of interior edges in every triangulation of a boundary, `n-3`. O(1).
///
/// ```
/// # use mindeg_core::{Boundary, bound};
/// assert_eq!(bound::interior_edge_count(&Boundary::new(&[3, 3, 2, 2])?), 7);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn interior_edge_count(boundary: &Boundary) -> u32 {
    boundary.vertex_count() - 3
}

/// Theorems 3 and 8: the bound on the maximum degree from counting edges. O(1).
///
/// The sum of the degrees is `4n-6`. Two isolated corners have 4 of it, so another vertex has at
/// least `(4n-10)/(n-2)`, rounded up: 2 for n = 3, 3 for n = 4, otherwise 4.
///
/// ```
/// # use mindeg_core::{Boundary, bound};
/// assert_eq!(bound::counting_bound(&Boundary::new(&[1, 1, 1])?), 2);
/// assert_eq!(bound::counting_bound(&Boundary::new(&[1, 1, 1, 1])?), 3);
/// assert_eq!(bound::counting_bound(&Boundary::new(&[3, 3, 2, 2])?), 4);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn counting_bound(boundary: &Boundary) -> u32 {
    let vertices = u64::from(boundary.vertex_count());
    (4 * vertices - 10).div_ceil(vertices - 2) as u32
}

/// Theorem 4: the bound on the maximum degree from the a intervals of one side. O(1).
///
/// Each of the `n-3` interior edges has an end among the `n-a-1` vertices that are not on that
/// side. So one of these vertices has at least `(n-3)/(n-a-1)` of them, rounded up, and two
/// boundary edges. The paper writes the same value as `(a-2)/(n-a-1)`, rounded up, plus 3.
///
/// # Panics
///
/// If `side` is not below [`Boundary::side_count`].
///
/// ```
/// # use mindeg_core::{Boundary, bound};
/// let boundary = Boundary::new(&[30, 2, 4, 2])?;
/// assert_eq!(bound::side_bound(&boundary, 0), 7);
/// assert_eq!(bound::side_bound(&boundary, 1), 3);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn side_bound(boundary: &Boundary, side: usize) -> u32 {
    let off_side = boundary.vertex_count() - boundary.intervals(side) - 1;
    interior_edge_count(boundary).div_ceil(off_side) + 2
}

/// Whether this is (2,2,2), the triangle with every side halved: the only boundary with degree 4
/// and no balanced cut. O(k).
///
/// The printed Theorem 10 requires at least `k+3` intervals on a k-sided polygon. It thus covers
/// (2,2,2), where it fails: the medial triangle and three ears have degree 4. The correct
/// hypothesis is at least 7 intervals, whatever k is. The reason: if a triangulation has three
/// ears and degree 4, every other vertex has two interior edges, the three edges of the triangle
/// between the ears form a closed ring, and so n = 6.
///
/// ```
/// # use mindeg_core::{Boundary, bound};
/// assert!(bound::is_medial_exception(&Boundary::new(&[2, 2, 2])?));
/// assert!(!bound::is_medial_exception(&Boundary::new(&[2, 2, 1, 1])?));
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn is_medial_exception(boundary: &Boundary) -> bool {
    boundary.sides().eq([2, 2, 2])
}
