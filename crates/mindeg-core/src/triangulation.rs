//! A triangulation as a formula: any triangle, degree or neighbour in constant time.
//!
//! Limits: only what the constructions of this crate can give; no edits, and no positions.

use crate::Triangles;
use crate::strip::{Across, End, Strip};
use crate::word::Letter;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;

/// A triangulation of a boundary with the least possible maximum degree.
///
/// It is one strip, or a main strip and a cap cut off at a corner, so it takes O(1) memory
/// whatever the number of intervals. It has `n-2` triangles and `n-3` interior edges
/// (Lemma 1 of Liu 2005), and all of them follow from the strips by integer arithmetic.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, min_degree_triangulation};
///
/// let boundary = Boundary::new(&[3, 3, 2, 2])?;
/// let triangulation = min_degree_triangulation(&boundary);
/// assert_eq!(triangulation.max_degree(), 4);
/// assert_eq!(triangulation.triangles().len(), 8);
/// assert_eq!(triangulation.interior_edges().len(), 7);
/// for vertex in 0..boundary.vertex_count() {
///     assert_eq!(triangulation.neighbors(vertex).len() as u32, triangulation.degree(vertex));
/// }
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangulation {
    vertex_count: u32,
    max_degree: u32,
    main: Strip,
    cap: Option<Strip>,
}

impl Triangulation {
    pub(crate) fn new(vertex_count: u32, max_degree: u32, main: Strip, cap: Option<Strip>) -> Self {
        Self { vertex_count, max_degree, main, cap }
    }

    /// The number of vertices n, at least 3.
    #[must_use]
    pub fn vertex_count(&self) -> u32 {
        self.vertex_count
    }

    /// The number of triangles, n - 2.
    #[must_use]
    pub fn triangle_count(&self) -> u32 {
        self.vertex_count - 2
    }

    /// The largest number of edges at a vertex, boundary edges included. O(1).
    #[must_use]
    pub fn max_degree(&self) -> u32 {
        self.max_degree
    }

    /// The one or two strips, the main strip first; their triangles in turn are
    /// [`triangles`](Self::triangles).
    pub fn strips(&self) -> impl Iterator<Item = &Strip> {
        core::iter::once(&self.main).chain(&self.cap)
    }

    /// The triangle with the given number, in `0..n-2`, counter-clockwise. O(1).
    ///
    /// # Panics
    ///
    /// When `number` is not below [`triangle_count`](Self::triangle_count).
    #[must_use]
    pub fn triangle(&self, number: u32) -> [u32; 3] {
        assert!(number < self.triangle_count(), "triangle {number} does not exist");
        let in_main = self.main.triangle_count();
        match &self.cap {
            Some(cap) if number >= in_main => cap.triangle(number - in_main),
            _ => self.main.triangle(number),
        }
    }

    /// All triangles, each counter-clockwise, strip by strip. A few nanoseconds for each; to
    /// fill a buffer, [`fill_triangles`](Self::fill_triangles) is faster.
    pub fn triangles(&self) -> Triangles<'_> {
        Triangles::new(self)
    }

    /// Writes the triangles from number `first` on into `out`, as many as it holds.
    ///
    /// This is as fast as memory can be written, with no division for each triangle. Parts of one
    /// buffer can be filled in parallel: they come out the same however it is split.
    ///
    /// # Panics
    ///
    /// When `out` is longer than the triangles from `first` on are many.
    ///
    /// ```
    /// # use mindeg_core::{Boundary, min_degree_triangulation};
    /// let triangulation = min_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
    /// let mut indices = [[0; 3]; 8];
    /// for (part, out) in (0..).zip(indices.chunks_mut(3)) {
    ///     triangulation.fill_triangles(3 * part, out);
    /// }
    /// assert!(triangulation.triangles().eq(indices));
    /// # Ok::<(), mindeg_core::BoundaryError>(())
    /// ```
    pub fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        let left = self.triangle_count().saturating_sub(first) as usize;
        assert!(out.len() <= left, "{} triangles from {first} on do not exist", out.len());
        let in_main = self.main.triangle_count();
        let main_left = in_main.saturating_sub(first) as usize;
        let (main, cap) = out.split_at_mut(main_left.min(out.len()));
        self.main.fill(first, main);
        if let Some(strip) = &self.cap {
            strip.fill(first.saturating_sub(in_main), cap);
        }
    }

    /// All `n-3` interior edges, each once, strip by strip.
    pub fn interior_edges(&self) -> impl ExactSizeIterator<Item = [u32; 2]> + '_ {
        let in_main = self.main.interior_edge_count();
        (0..self.vertex_count - 3).map(move |number| match &self.cap {
            Some(cap) if number >= in_main => cap.edge(number - in_main),
            _ => self.main.edge(number),
        })
    }

    /// The number of edges at `vertex`, its two boundary edges included ("valence" in
    /// graphics). O(1).
    ///
    /// # Panics
    ///
    /// When `vertex` is not below [`vertex_count`](Self::vertex_count).
    #[must_use]
    pub fn degree(&self, vertex: u32) -> u32 {
        2 + self.interior_neighbors(vertex).iter().flatten().map(Across::len).sum::<u32>()
    }

    /// The neighbours of `vertex`, counter-clockwise: from the next boundary vertex to the
    /// one before. O(1) to start, O(1) for each.
    ///
    /// # Panics
    ///
    /// When `vertex` is not below [`vertex_count`](Self::vertex_count).
    #[must_use]
    pub fn neighbors(&self, vertex: u32) -> Neighbors {
        let interior = self.interior_neighbors(vertex);
        let last = self.vertex_count - 1;
        Neighbors {
            next: Some(if vertex == last { 0 } else { vertex + 1 }),
            interior,
            previous: Some(if vertex == 0 { last } else { vertex - 1 }),
        }
    }

    /// What `vertex` is joined to across each strip, in counter-clockwise order.
    fn interior_neighbors(&self, vertex: u32) -> [Option<Across>; 2] {
        assert!(vertex < self.vertex_count, "vertex {vertex} does not exist");
        let main = self.main.across(vertex);
        let cap = self.cap.and_then(|cap| cap.across(vertex));
        // Of the two ends of the edge shared by both strips, the one on the cap's y chain has the
        // cap right after it on the ring, the one on its x chain right before it.
        match &cap {
            Some(across) if across.seen_from == Letter::Y => [cap, main],
            _ => [main, cap],
        }
    }

    /// The isolated corners, those with no interior edge, in ascending order: at least two
    /// (Lemma 2 of Liu 2005) and at most three.
    #[must_use]
    pub fn isolated_corners(&self) -> Vec<u32> {
        if self.vertex_count == 3 {
            return [0, 1, 2].into();
        }
        let mut corners: Vec<u32> = self
            .strips()
            .flat_map(|strip| {
                let last = if let End::Ear(tip) = strip.end() { Some(tip) } else { None };
                [Some(strip.tip()), last]
            })
            .flatten()
            .filter(|&tip| self.degree(tip) == 2)
            .collect();
        corners.sort_unstable();
        corners
    }

    /// How many vertices have each degree, for the degrees that occur. O(n) time.
    ///
    /// ```
    /// # use mindeg_core::{Boundary, min_degree_triangulation};
    /// let triangulation = min_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
    /// let histogram = triangulation.degree_histogram();
    /// assert!(histogram.into_iter().eq([(2, 2), (3, 2), (4, 6)]));
    /// # Ok::<(), mindeg_core::BoundaryError>(())
    /// ```
    #[must_use]
    pub fn degree_histogram(&self) -> BTreeMap<u32, u32> {
        let mut histogram = BTreeMap::new();
        for vertex in 0..self.vertex_count {
            *histogram.entry(self.degree(vertex)).or_default() += 1;
        }
        histogram
    }
}

/// The neighbours of one vertex, counter-clockwise; see [`Triangulation::neighbors`].
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Neighbors, min_degree_triangulation};
///
/// let triangulation = min_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let neighbors: Neighbors = triangulation.neighbors(0);
/// assert_eq!(neighbors.len(), 4);
/// assert!(neighbors.eq([1, 6, 7, 9]));
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Neighbors {
    next: Option<u32>,
    interior: [Option<Across>; 2],
    previous: Option<u32>,
}

impl Iterator for Neighbors {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.next
            .take()
            .or_else(|| self.interior.iter_mut().flatten().find_map(Iterator::next))
            .or_else(|| self.previous.take())
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let interior: u32 = self.interior.iter().flatten().map(Across::len).sum();
        let len = interior as usize
            + usize::from(self.next.is_some())
            + usize::from(self.previous.is_some());
        (len, Some(len))
    }
}

impl ExactSizeIterator for Neighbors {}
