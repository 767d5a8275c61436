//! Rings of points that bound a domain of the plane.

use std::ops::Range;

use glam::DVec2;

use super::in_ring::InRing;
use super::turning::{straight_runs, turn};
use crate::Bounds;

/// The boundary of a domain of the plane: points, in rings, with the domain on the left of every
/// edge; and lines and points inside it.
///
/// Ring 0 is the outer one and counter-clockwise, the others are holes and clockwise. Vertices
/// count from 0, ring after ring, then the inner points. A line joins vertices of both kinds, so it may
/// end on a ring or on another line. [`new`](Self::new) and [`map`](Self::map) prove once, by an exact
/// sweep, that rings are simple, apart and nested like that, and that lines and points lie inside and
/// meet only at their vertices; code with a boundary need not prove it again. The lines divide the domain
/// into [faces](Self::faces).
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
    /// The points of the rings, then the inner points.
    pub(super) points: Vec<DVec2>,
    /// The first vertex of each ring, then the number of vertices on rings.
    pub(super) starts: Vec<u32>,
    /// The edges of all lines, line after line.
    pub(super) segments: Vec<[u32; 2]>,
    /// The first segment of each line, then the number of segments.
    pub(super) line_starts: Vec<u32>,
    /// The first vertices of the sides, ascending.
    corners: Vec<u32>,
    /// For each vertex, the straight run of the edge that begins there.
    runs: Vec<u32>,
    /// Vertices of rings with another one at the same point, ascending; only where rings touch.
    pub(super) twins: Vec<[u32; 2]>,
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
        Self::unproven(points, starts)
    }

    /// Rings of points, each edge a run of its own.
    pub(super) fn unproven(points: Vec<DVec2>, starts: Vec<u32>) -> Self {
        let on_rings = starts.last().copied().unwrap_or_default();
        let (corners, runs) = (Vec::new(), (0..on_rings).collect());
        let (segments, line_starts, twins) = (Vec::new(), vec![0], Vec::new());
        Self { points, starts, segments, line_starts, corners, runs, twins }
    }

    /// Sets the sides, which begin at `corners`, in ascending order, and for each vertex the
    /// straight run of the edge that begins there. Without this, every edge is a run of its own.
    ///
    /// # Panics
    ///
    /// If the number of runs differs from the number of vertices.
    #[must_use]
    pub fn with_sides(mut self, corners: Vec<u32>, runs: Vec<u32>) -> Self {
        assert_eq!(runs.len(), self.points().len(), "each edge is of one run");
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

    /// The points of the rings, ring after ring.
    pub fn points(&self) -> &[DVec2] {
        &self.points[..self.vertex_count() as usize]
    }

    /// The points inside, which are vertices after those of the rings.
    pub fn inner_points(&self) -> &[DVec2] {
        &self.points[self.vertex_count() as usize..]
    }

    /// The number of lines.
    pub fn line_count(&self) -> usize {
        self.line_starts.len() - 1
    }

    /// The edges of a line, from its first vertex on.
    pub fn line(&self, line: usize) -> &[[u32; 2]] {
        &self.segments[self.line_starts[line] as usize..self.line_starts[line + 1] as usize]
    }

    /// The edges of all lines, line after line.
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The ends of an edge: of the rings, each by the vertex that names it, then of the lines.
    pub fn ends(&self, edge: u32) -> [u32; 2] {
        match edge.checked_sub(self.vertex_count()) {
            None => [edge, self.next(edge)],
            Some(segment) => self.segments[segment as usize],
        }
    }

    /// The number of edges of rings and lines.
    pub fn edge_count(&self) -> u32 {
        self.vertex_count() + self.segments.len() as u32
    }

    /// The point of a vertex.
    ///
    /// # Panics
    ///
    /// If the boundary has no such vertex; the same holds below.
    pub fn point(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    /// The number of vertices on rings, which is also the number of their edges.
    pub fn vertex_count(&self) -> u32 {
        self.starts[self.starts.len() - 1]
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

    /// The ring of a vertex on a ring and its index there. O(log h) for h rings, like the next two functions.
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

    /// The other vertices at the point of a vertex: where rings touch themselves or each other, which only a
    /// [border](Self::border) may. O(log n) for n of these.
    pub fn twins(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let from = self.twins.partition_point(|&[of, _]| of < vertex);
        let own = self.twins[from..].iter().take_while(move |&&[of, _]| of == vertex);
        own.map(|&[_, twin]| twin)
    }

    /// The edges of the rings, each from the vertex that names it. O(1) each.
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

    /// The area inside the rings, in square units: that of the outer ones without the holes. O(n).
    pub fn area(&self) -> f64 {
        let points = |ring: Range<u32>| &self.points[ring.start as usize..ring.end as usize];
        self.rings().map(|ring| doubled_area(points(ring)) / 2.0).sum()
    }

    /// The box around all points. O(n).
    pub fn bounds(&self) -> Bounds {
        let origin = Bounds { min: DVec2::ZERO, max: DVec2::ZERO };
        Bounds::of(self.points().iter().copied()).unwrap_or(origin)
    }
}

/// Twice the area of a ring of points, in square units; negative if it runs clockwise. O(n).
pub fn doubled_area(points: &[DVec2]) -> f64 {
    // Relative to a point, so that nothing cancels far from the origin.
    let doubled = |pair: &[DVec2]| (pair[0] - points[0]).perp_dot(pair[1] - points[0]);
    points.windows(2).map(doubled).sum()
}
