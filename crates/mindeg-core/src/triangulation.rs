//! A triangulation as a formula: any triangle, degree or neighbour in constant time.
//!
//! Limits: only the constructions of this crate make one. It cannot be edited, and it stores no
//! positions.

use crate::ring::Ring;
use crate::strip::{Opposite, Strip};
use crate::word::Letter;

/// A triangulation of a boundary with the least possible maximum degree.
///
/// It is one strip, or a main strip and a corner strip, so it takes O(1) memory whatever the
/// number of intervals. It has `n-2` triangles and `n-3` interior edges (Lemma 1 of Liu 2005),
/// and integer arithmetic gives each of them from the strips.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, least_degree_triangulation};
///
/// let boundary = Boundary::new(&[3, 3, 2, 2])?;
/// let triangulation = least_degree_triangulation(&boundary);
/// assert_eq!(triangulation.max_degree(), 4);
/// assert_eq!(triangulation.triangles().len(), 8);
/// assert_eq!(triangulation.interior_edges().len(), 7);
/// for vertex in 0..boundary.vertex_count() {
///     assert_eq!(triangulation.neighbors(vertex).len() as u32, triangulation.degree(vertex));
/// }
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangulation {
    ring: Ring,
    max_degree: u32,
    main: Strip,
    corner: Option<Strip>,
}

impl Triangulation {
    pub(crate) fn new(ring: Ring, max_degree: u32, main: Strip, corner: Option<Strip>) -> Self {
        Self { ring, max_degree, main, corner }
    }

    /// The number of vertices n, at least 3.
    pub fn vertex_count(&self) -> u32 {
        self.ring.len()
    }

    /// The number of triangles, n - 2.
    pub fn triangle_count(&self) -> u32 {
        self.ring.len() - 2
    }

    /// The largest number of edges at a vertex, boundary edges included. O(1).
    pub fn max_degree(&self) -> u32 {
        self.max_degree
    }

    /// The main strip, then the corner strip if it exists. [`triangles`](Self::triangles) are
    /// the triangles of the strips in this order.
    pub fn strips(&self) -> impl Iterator<Item = &Strip> {
        core::iter::once(&self.main).chain(&self.corner)
    }

    /// The triangle at `index`, in `0..n-2`, counter-clockwise. O(1).
    ///
    /// # Panics
    ///
    /// If `index` is not below [`triangle_count`](Self::triangle_count).
    pub fn triangle(&self, index: u32) -> [u32; 3] {
        let count = self.triangle_count();
        assert!(index < count, "triangle {index} does not exist; the triangulation has {count}");
        let in_main = self.main.triangle_count();
        match &self.corner {
            Some(corner) if index >= in_main => corner.triangle(index - in_main),
            _ => self.main.triangle(index),
        }
    }

    /// Fills `out` with the triangles from index `first` on. O(`out.len()`), with no division for
    /// each triangle.
    ///
    /// Threads can fill chunks of one buffer in parallel: every split gives the same result.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` triangles remain from `first` on.
    ///
    /// ```
    /// # use mindeg_core::{Boundary, least_degree_triangulation};
    /// let triangulation = least_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
    /// let mut indices = [[0; 3]; 8];
    /// for (chunk, out) in (0..).zip(indices.chunks_mut(3)) {
    ///     triangulation.fill_triangles(3 * chunk, out);
    /// }
    /// assert!(triangulation.triangles().eq(indices));
    /// # Ok::<(), mindeg_core::Defect>(())
    /// ```
    pub fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        let len = out.len();
        let left = self.triangle_count().saturating_sub(first) as usize;
        assert!(len <= left, "cannot fill {len} triangles from index {first}: {left} remain");
        let in_main = self.main.triangle_count();
        let main_left = in_main.saturating_sub(first) as usize;
        let (main, corner) = out.split_at_mut(main_left.min(len));
        self.main.fill(first, main);
        if let Some(strip) = &self.corner {
            strip.fill(first.saturating_sub(in_main), corner);
        }
    }

    /// All `n-3` interior edges, each once, strip by strip. O(1) for each.
    pub fn interior_edges(&self) -> impl ExactSizeIterator<Item = [u32; 2]> + '_ {
        let in_main = self.main.interior_edge_count();
        (0..self.ring.len() - 3).map(move |index| match &self.corner {
            Some(corner) if index >= in_main => corner.edge(index - in_main),
            _ => self.main.edge(index),
        })
    }

    /// The number of edges at `vertex`, its two boundary edges included; graphics programs call
    /// it "valence". O(1).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn degree(&self, vertex: u32) -> u32 {
        2 + self.interior_neighbors(vertex).iter().flatten().map(Opposite::len).sum::<u32>()
    }

    /// The neighbours of `vertex`, counter-clockwise: from the next boundary vertex to the
    /// previous one. O(1) for each.
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn neighbors(&self, vertex: u32) -> Neighbors {
        Neighbors {
            interior: self.interior_neighbors(vertex),
            next: Some(self.ring.forward(vertex, 1)),
            previous: Some(self.ring.backward(vertex, 1)),
        }
    }

    /// The neighbours of `vertex` along the cross edges of each strip, counter-clockwise.
    fn interior_neighbors(&self, vertex: u32) -> [Option<Opposite>; 2] {
        let n = self.ring.len();
        assert!(vertex < n, "vertex {vertex} does not exist; the triangulation has {n} vertices");
        let main = self.main.opposite(vertex);
        let corner = self.corner.and_then(|strip| strip.opposite(vertex));
        // Both strips have the ends of their shared edge. On the ring, the corner strip lies after
        // the end on its y chain and before the end on its x chain.
        match &corner {
            Some(opposite) if opposite.from == Letter::Y => [corner, main],
            _ => [main, corner],
        }
    }
}

/// The neighbours of one vertex, counter-clockwise; see [`Triangulation::neighbors`].
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Neighbors, least_degree_triangulation};
///
/// let triangulation = least_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let neighbors: Neighbors = triangulation.neighbors(0);
/// assert_eq!(neighbors.len(), 4);
/// assert!(neighbors.eq([1, 6, 7, 9]));
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Debug)]
pub struct Neighbors {
    next: Option<u32>,
    interior: [Option<Opposite>; 2],
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
        let interior: u32 = self.interior.iter().flatten().map(Opposite::len).sum();
        let len = interior as usize
            + usize::from(self.next.is_some())
            + usize::from(self.previous.is_some());
        (len, Some(len))
    }
}

impl ExactSizeIterator for Neighbors {}
