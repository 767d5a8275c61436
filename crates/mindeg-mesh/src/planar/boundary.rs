//! Rings of points that bound a domain of the plane.

use std::ops::Range;

use glam::DVec2;

use super::in_ring::InRing;
use super::turning::{straight_runs, turn};
use crate::Bounds;

/// The boundary of a domain of the plane: points, in rings, with the domain on the left of every
/// edge.
///
/// Ring 0 is the outer one and counter-clockwise, the others are holes and clockwise. Vertices
/// count from 0, ring after ring. [`new`](Self::new) proves once, by an exact sweep, that the rings
/// are simple, apart and nested like that; code with a boundary need not prove it again.
///
/// # What belongs here later
///
/// A region is a part of the domain: rings of its own, over the same points, and a name. A line
/// between rings is a sequence of points with an edge from each to the next, which two regions or
/// one have beside it. Both join `points` after the rings, and the sweep, which passes edges and not
/// rings, then proves them too.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
/// let hole = [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0]];
/// let rings = [square.map(DVec2::from).to_vec(), hole.map(DVec2::from).to_vec()];
/// let boundary = PlanarBoundary::new(&rings)?;
/// assert_eq!((boundary.ring_count(), boundary.next(6), boundary.previous(0)), (2, 4, 3));
///
/// // All faults are listed: the hole crosses the square twice.
/// let aside = hole.map(|[x, y]| DVec2::new(x - 1.5, y)).to_vec();
/// let faults = PlanarBoundary::new(&[rings[0].clone(), aside]).unwrap_err();
/// assert_eq!(faults.list().len(), 2);
/// # Ok::<(), mindeg_mesh::planar::BoundaryFaults>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlanarBoundary {
    pub(super) points: Vec<DVec2>,
    /// The first vertex of each ring, then the number of vertices.
    pub(super) starts: Vec<u32>,
    /// The first vertices of the sides, ascending.
    corners: Vec<u32>,
    /// For each vertex, the straight run of the edge that begins there.
    runs: Vec<u32>,
}

impl PlanarBoundary {
    /// The boundary of triangles, which prove it: nothing is checked. The rings may be in any order, include several
    /// outer rings, and touch each other at points.
    pub fn of_mesh<R: AsRef<[DVec2]>>(rings: &[R]) -> Self {
        let mut points = Vec::with_capacity(rings.iter().map(|ring| ring.as_ref().len()).sum());
        let mut starts = vec![0];
        for ring in rings {
            points.extend_from_slice(ring.as_ref());
            starts.push(points.len() as u32);
        }
        let (corners, runs) = (Vec::new(), (0..points.len() as u32).collect());
        Self { points, starts, corners, runs }
    }

    /// Sets the sides, which begin at `corners`, in ascending order, and for each vertex the
    /// straight run of the edge that begins there. Without this, every edge is a run of its own.
    ///
    /// # Panics
    ///
    /// If the number of runs differs from the number of vertices.
    #[must_use]
    pub fn with_sides(mut self, corners: Vec<u32>, runs: Vec<u32>) -> Self {
        assert_eq!(runs.len(), self.points.len(), "each edge is of one run");
        (self.corners, self.runs) = (corners, runs);
        self
    }

    /// Sets sides that are all straight and begin at `corners`, in ascending order; the first
    /// vertex of each ring is one of them. Consecutive sides without a turn are one straight run.
    #[must_use]
    pub fn with_straight_sides(self, corners: Vec<u32>) -> Self {
        let turns = |ring: usize| {
            let Range { start, end } = self.ring(ring);
            let [from, to] = [start, end].map(|v| corners.partition_point(|&corner| corner < v));
            let own = &corners[from..to];
            let at = |index: usize| self.point(own[index % own.len()]);
            let turn_at = |index: usize| {
                let [before, here, after] = [at(index + own.len() - 1), at(index), at(index + 1)];
                (own[index], turn([before, here], [here, after]))
            };
            (0..own.len()).map(turn_at).collect()
        };
        let runs = straight_runs(self.rings(), turns);
        self.with_sides(corners, runs)
    }

    /// The points, ring after ring.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The point of a vertex.
    ///
    /// # Panics
    ///
    /// If the boundary has no such vertex; the same holds below.
    pub fn point(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    /// The number of vertices, which is also the number of edges.
    pub fn vertex_count(&self) -> u32 {
        self.points.len() as u32
    }

    /// The number of rings: 1 and the number of holes.
    pub fn ring_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The vertices of a ring.
    pub fn ring(&self, ring: usize) -> Range<u32> {
        self.starts[ring]..self.starts[ring + 1]
    }

    /// The vertices of each ring.
    pub fn rings(&self) -> impl ExactSizeIterator<Item = Range<u32>> + '_ {
        self.starts.windows(2).map(|ends| ends[0]..ends[1])
    }

    /// The ring of a vertex and its index there. O(log h) for h rings, like the next two functions.
    pub fn in_ring(&self, vertex: u32) -> InRing {
        let ring = self.starts.partition_point(|&start| start <= vertex) - 1;
        InRing { ring, index: (vertex - self.starts[ring]) as usize }
    }

    /// The vertex after `vertex` on its ring.
    pub fn next(&self, vertex: u32) -> u32 {
        let Range { start, end } = self.ring(self.in_ring(vertex).ring);
        if vertex + 1 == end { start } else { vertex + 1 }
    }

    /// The vertex before `vertex` on its ring.
    pub fn previous(&self, vertex: u32) -> u32 {
        let Range { start, end } = self.ring(self.in_ring(vertex).ring);
        if vertex == start { end - 1 } else { vertex - 1 }
    }

    /// The edges, each from the vertex that names it. O(1) each.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.rings().flat_map(|ring| {
            let next = (ring.start + 1..ring.end).chain([ring.start]);
            ring.zip(next).map(|(from, to)| [from, to])
        })
    }

    /// The length of the edge that begins at `vertex`.
    pub fn length(&self, vertex: u32) -> f64 {
        self.point(vertex).distance(self.point(self.next(vertex)))
    }

    /// The interior angle at `vertex` in radians, above 0 and below 2 pi.
    pub fn angle(&self, vertex: u32) -> f64 {
        let at = self.point(vertex);
        let (after, before) =
            (self.point(self.next(vertex)) - at, self.point(self.previous(vertex)) - at);
        let angle = libm::atan2(after.perp_dot(before), after.dot(before));
        if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
    }

    /// The first vertices of the sides, ascending; empty if unknown.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// For each vertex, the straight run that the edge beginning there belongs to.
    pub fn runs(&self) -> &[u32] {
        &self.runs
    }

    /// The box around all points. O(n).
    pub fn bounds(&self) -> Bounds {
        let origin = Bounds { min: DVec2::ZERO, max: DVec2::ZERO };
        Bounds::of(self.points.iter().copied()).unwrap_or(origin)
    }
}
