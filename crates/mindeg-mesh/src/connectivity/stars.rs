//! The faces and edges at each vertex.

use super::disjoint_sets::DisjointSets;
use super::faces::Faces;
use std::ops::Range;

/// The faces at each vertex, in two flat arrays.
pub(crate) struct Stars<'a> {
    faces: &'a Faces<'a>,
    /// The first index in `at` of each vertex's corners; then the length of `at`.
    starts: Vec<usize>,
    /// The corners at vertex 0 in the order of their faces, then those at vertex 1, and so on.
    at: Vec<Corner>,
}

/// A corner of a face.
#[derive(Clone, Copy, Default, PartialEq)]
pub(crate) struct Corner {
    pub(crate) face: u32,
    /// Its index among the corners of the face.
    pub(crate) index: u32,
}

impl<'a> Stars<'a> {
    /// The stars of all vertices. O(n) time and memory for n vertices and corners. All vertices are
    /// below `vertex_count`.
    pub(crate) fn new(vertex_count: usize, faces: &'a Faces<'a>) -> Self {
        let mut starts = vec![0; vertex_count + 1];
        for (_, corners) in faces.iter() {
            corners.iter().for_each(|&vertex| starts[vertex as usize + 1] += 1);
        }
        for vertex in 0..vertex_count {
            starts[vertex + 1] += starts[vertex];
        }
        let mut at = vec![Corner::default(); starts[vertex_count]];
        let mut next = starts.clone();
        for (face, corners) in faces.iter() {
            for (index, &vertex) in (0..).zip(corners) {
                let free = &mut next[vertex as usize];
                at[*free] = Corner { face, index };
                *free += 1;
            }
        }
        Self { faces, starts, at }
    }

    /// The number of stars, which is the number of vertices.
    pub(crate) fn count(&self) -> u32 {
        // Vertices have indices of 32 bits.
        (self.starts.len() - 1) as u32
    }

    /// The faces that form the stars.
    pub(crate) fn faces(&self) -> &Faces<'a> {
        self.faces
    }

    /// Calls `visit` with the vertices of a range, in ascending order, and their stars. O(d log d)
    /// for each star of d edges, plus the time of `visit`.
    pub(crate) fn for_each(&self, vertices: Range<u32>, mut visit: impl FnMut(u32, &Star)) {
        let mut star = Star::default();
        for vertex in vertices {
            let [start, end] = [vertex as usize, vertex as usize + 1].map(|i| self.starts[i]);
            star.set(self.faces, &self.at[start..end]);
            visit(vertex, &star);
        }
    }
}

/// The faces and edges at one vertex.
#[derive(Default)]
pub(crate) struct Star {
    /// Two for each corner, in the order of ends, then corners.
    half_edges: Vec<HalfEdge>,
    /// For each edge, the end of its half-edges; they start at the end of the previous edge's.
    ends: Vec<usize>,
}

/// An edge from the vertex of a star to another, in one face.
#[derive(Clone, Copy)]
pub(crate) struct HalfEdge {
    /// The other vertex of the edge.
    pub(crate) end: u32,
    /// The corner of the face at the vertex of the star.
    pub(crate) corner: Corner,
    /// The end of the other edge of that corner.
    pub(crate) other_end: u32,
    /// Whether the face runs from the vertex of the star to `end`.
    pub(crate) is_outgoing: bool,
}

impl Star {
    fn set(&mut self, faces: &Faces<'_>, at: &[Corner]) {
        self.half_edges.clear();
        for &corner in at {
            let corners = faces.corners(corner.face);
            let index = corner.index as usize;
            let next = corners.get(index + 1).copied().unwrap_or(corners[0]);
            let last = corners[if index == 0 { corners.len() } else { index } - 1];
            self.half_edges.extend([
                HalfEdge { end: next, corner, other_end: last, is_outgoing: true },
                HalfEdge { end: last, corner, other_end: next, is_outgoing: false },
            ]);
        }
        self.half_edges
            .sort_unstable_by_key(|half| (half.end, half.corner.face, half.corner.index));
        self.ends.clear();
        let mut end = 0;
        for edge in self.half_edges.chunk_by(|a, b| a.end == b.end) {
            end += edge.len();
            self.ends.push(end);
        }
    }

    /// The number of edges at the vertex.
    pub(crate) fn degree(&self) -> usize {
        self.ends.len()
    }

    /// The edges at the vertex, each as its half-edges, in ascending order of their ends.
    pub(crate) fn edges(&self) -> impl Iterator<Item = &[HalfEdge]> {
        (0..self.degree()).map(|edge| self.edge(edge))
    }

    fn edge(&self, edge: usize) -> &[HalfEdge] {
        let start = if edge == 0 { 0 } else { self.ends[edge - 1] };
        &self.half_edges[start..self.ends[edge]]
    }

    /// The index of the edge to `end`; the edge must exist.
    fn edge_to(&self, end: u32) -> usize {
        self.ends.partition_point(|&last| self.half_edges[last - 1].end < end)
    }

    /// The number of fans: sets of corners that edges at the vertex connect.
    pub(crate) fn fan_count(&self) -> usize {
        let mut fans = DisjointSets::new(self.degree());
        for half in self.half_edges.iter().filter(|half| half.is_outgoing) {
            fans.join(self.edge_to(half.end) as u32, self.edge_to(half.other_end) as u32);
        }
        fans.count()
    }

    /// The end of the boundary edge reached from a boundary edge by turning about the vertex, from
    /// face to face over edges with two faces; `None` if an edge with more faces stops the turn.
    pub(crate) fn next_boundary_edge(&self, boundary_edge: HalfEdge) -> Option<u32> {
        let mut half = boundary_edge;
        loop {
            match *self.edge(self.edge_to(half.other_end)) {
                [_] => return Some(half.other_end),
                // Never back to an earlier edge: both its corners were passed already.
                [a, b] => half = if a.corner == half.corner { b } else { a },
                _ => return None,
            }
        }
    }
}
