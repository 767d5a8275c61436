//! The triangles and edges at each vertex.

use super::disjoint_sets::DisjointSets;
use std::ops::Range;

/// Whether a triangle has three different vertices. Only such triangles are in stars.
pub(crate) fn is_proper([a, b, c]: [u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// Which triangles are at which vertex, in two flat arrays.
pub(crate) struct Stars<'a> {
    triangles: &'a [[u32; 3]],
    /// Where the triangles of each vertex start in `at`; the length of `at` at the end.
    starts: Vec<usize>,
    /// The triangles at vertex 0 in ascending order, then those at vertex 1, and so on.
    at: Vec<u32>,
}

impl<'a> Stars<'a> {
    /// The stars of all vertices. O(n) time and memory for n vertices and triangles.
    ///
    /// Triangles are numbered in u32 and name vertices below `vertex_count`.
    pub(crate) fn new(vertex_count: usize, triangles: &'a [[u32; 3]]) -> Self {
        let proper = || (0_u32..).zip(triangles).filter(|&(_, &corners)| is_proper(corners));
        let mut starts = vec![0; vertex_count + 1];
        for vertex in proper().flat_map(|(_, corners)| corners) {
            starts[*vertex as usize + 1] += 1;
        }
        for vertex in 0..vertex_count {
            starts[vertex + 1] += starts[vertex];
        }
        let mut at = vec![0; starts[vertex_count]];
        let mut next = starts.clone();
        for (triangle, corners) in proper() {
            for &vertex in corners {
                let place = &mut next[vertex as usize];
                at[*place] = triangle;
                *place += 1;
            }
        }
        Self { triangles, starts, at }
    }

    /// The number of stars: of vertices.
    pub(crate) fn count(&self) -> u32 {
        // Vertices are numbered in u32.
        (self.starts.len() - 1) as u32
    }

    /// Calls `visit` with some vertices, in ascending order, and their stars. O(d log d) for each
    /// star of d edges, beside what `visit` takes.
    pub(crate) fn for_each(&self, vertices: Range<u32>, mut visit: impl FnMut(u32, &Star)) {
        let mut star = Star::default();
        for vertex in vertices {
            let [start, end] = [vertex as usize, vertex as usize + 1].map(|i| self.starts[i]);
            star.set(vertex, self.triangles, &self.at[start..end]);
            visit(vertex, &star);
        }
    }
}

/// The triangles and edges at one vertex.
#[derive(Default)]
pub(crate) struct Star {
    /// Two for each triangle, in the order of ends, then triangles.
    rays: Vec<Ray>,
    /// For each edge the end of its rays; they start where those of the edge before end.
    ends: Vec<usize>,
}

/// An edge from the vertex of a star to another, as one triangle has it.
#[derive(Clone, Copy)]
pub(crate) struct Ray {
    /// The other end.
    pub(crate) end: u32,
    /// The triangle.
    pub(crate) triangle: u32,
    /// The third vertex of the triangle.
    pub(crate) apex: u32,
    /// Whether the triangle runs from the vertex of the star to `end`.
    pub(crate) is_outgoing: bool,
}

impl Star {
    fn set(&mut self, vertex: u32, triangles: &[[u32; 3]], at: &[u32]) {
        self.rays.clear();
        for &triangle in at {
            let [a, b, c] = triangles[triangle as usize];
            let [next, last] = if a == vertex {
                [b, c]
            } else if b == vertex {
                [c, a]
            } else {
                [a, b]
            };
            self.rays.extend([
                Ray { end: next, triangle, apex: last, is_outgoing: true },
                Ray { end: last, triangle, apex: next, is_outgoing: false },
            ]);
        }
        self.rays.sort_unstable_by_key(|ray| (ray.end, ray.triangle));
        self.ends.clear();
        let mut end = 0;
        for edge in self.rays.chunk_by(|a, b| a.end == b.end) {
            end += edge.len();
            self.ends.push(end);
        }
    }

    /// The number of edges at the vertex.
    pub(crate) fn degree(&self) -> usize {
        self.ends.len()
    }

    /// The edges at the vertex, each as the rays along it, in ascending order of their ends.
    pub(crate) fn edges(&self) -> impl Iterator<Item = &[Ray]> {
        (0..self.degree()).map(|edge| self.edge(edge))
    }

    fn edge(&self, edge: usize) -> &[Ray] {
        let start = if edge == 0 { 0 } else { self.ends[edge - 1] };
        &self.rays[start..self.ends[edge]]
    }

    /// The number of the edge to `end`, which is there.
    fn edge_to(&self, end: u32) -> usize {
        self.ends.partition_point(|&last| self.rays[last - 1].end < end)
    }

    /// The number of fans: sets of triangles that hang together by edges at the vertex.
    pub(crate) fn fan_count(&self) -> usize {
        let mut fans = DisjointSets::new(self.degree());
        for ray in self.rays.iter().filter(|ray| ray.is_outgoing) {
            fans.join(self.edge_to(ray.end) as u32, self.edge_to(ray.apex) as u32);
        }
        fans.count()
    }

    /// The end of the boundary edge that is found from a boundary edge by turning about the
    /// vertex, from triangle to triangle across edges with two; `None` where an edge with more
    /// is in the way.
    pub(crate) fn across(&self, boundary_edge: Ray) -> Option<u32> {
        let mut ray = boundary_edge;
        loop {
            match *self.edge(self.edge_to(ray.apex)) {
                [_] => return Some(ray.apex),
                // Never back to an edge behind: each of those has its two triangles behind too.
                [a, b] => ray = if a.triangle == ray.triangle { b } else { a },
                _ => return None,
            }
        }
    }
}
