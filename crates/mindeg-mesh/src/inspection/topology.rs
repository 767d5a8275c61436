//! What the stars of all vertices tell about a mesh.

use super::VertexDegree;
use crate::connectivity::boundary::BoundaryEdges;
use crate::connectivity::disjoint_sets::DisjointSets;
use crate::connectivity::stars::{Ray, Star, Stars};
use crate::parallel::blocks;
use crate::summary::DegreeHistogram;
use std::ops::Range;

/// The findings, with vertices and triangles in ascending order.
#[derive(Default)]
pub(super) struct Topology {
    /// Vertices without an edge.
    pub(super) isolated: Vec<u32>,
    pub(super) edge_count: usize,
    pub(super) component_count: usize,
    pub(super) boundary: BoundaryEdges,
    pub(super) non_manifold_edges: Vec<[u32; 2]>,
    pub(super) non_manifold_vertices: Vec<u32>,
    pub(super) inconsistent_edges: Vec<[u32; 2]>,
    pub(super) duplicates: Vec<u32>,
    pub(super) boundary_degrees: DegreeHistogram,
    pub(super) interior_degrees: DegreeHistogram,
    /// The first vertex of the highest degree.
    pub(super) highest: Option<VertexDegree>,
    /// The vertices of a higher degree than asked for.
    pub(super) poles: Vec<VertexDegree>,
    /// Triangles that share an edge.
    neighbors: Vec<[u32; 2]>,
}

impl Topology {
    /// Looks at every star, with all threads. Of `triangle_count` triangles, `improper` are in
    /// none.
    pub(super) fn new(
        stars: &Stars<'_>,
        triangle_count: usize,
        improper: usize,
        pole_degree: u32,
    ) -> Self {
        let in_blocks = blocks(stars.count(), |range| Self::of_some(stars, range, pole_degree));
        let mut topology = Self::default();
        let mut components = DisjointSets::new(triangle_count);
        for of_block in in_blocks {
            for &[a, b] in &of_block.neighbors {
                components.join(a, b);
            }
            topology.append(of_block);
        }
        // A triangle in no star is a set of its own.
        topology.component_count = components.count() - improper;
        topology.duplicates.sort_unstable();
        topology
    }

    /// What the stars of some vertices tell, but for components.
    fn of_some(stars: &Stars<'_>, vertices: Range<u32>, pole_degree: u32) -> Self {
        let mut topology = Self::default();
        let [mut boundary_degrees, mut interior_degrees] = [Vec::new(), Vec::new()];
        stars.for_each(vertices, |vertex, star| {
            topology.boundary.add(vertex, star);
            let degree = star.degree() as u32;
            if degree == 0 {
                topology.isolated.push(vertex);
                return;
            }
            let on_boundary = star.edges().any(|edge| edge.len() == 1);
            let degrees = if on_boundary { &mut boundary_degrees } else { &mut interior_degrees };
            degrees.push(degree);
            let vertex_degree = VertexDegree { vertex, degree, on_boundary };
            if topology.highest.is_none_or(|highest| degree > highest.degree) {
                topology.highest = Some(vertex_degree);
            }
            if degree > pole_degree {
                topology.poles.push(vertex_degree);
            }
            if star.fan_count() > 1 {
                topology.non_manifold_vertices.push(vertex);
            }
            topology.add_edges(vertex, star);
        });
        topology.boundary_degrees = boundary_degrees.into_iter().collect();
        topology.interior_degrees = interior_degrees.into_iter().collect();
        topology
    }

    /// Adds what the stars of the vertices that follow tell.
    fn append(&mut self, next: Self) {
        self.isolated.extend(next.isolated);
        self.edge_count += next.edge_count;
        self.boundary.append(next.boundary);
        self.non_manifold_edges.extend(next.non_manifold_edges);
        self.non_manifold_vertices.extend(next.non_manifold_vertices);
        self.inconsistent_edges.extend(next.inconsistent_edges);
        self.duplicates.extend(next.duplicates);
        self.boundary_degrees = [&self.boundary_degrees, &next.boundary_degrees].into_iter().sum();
        self.interior_degrees = [&self.interior_degrees, &next.interior_degrees].into_iter().sum();
        // Of vertices of the same degree the first stays.
        let degree = |highest: Option<VertexDegree>| highest.map(|vertex| vertex.degree);
        if degree(next.highest) > degree(self.highest) {
            self.highest = next.highest;
        }
        self.poles.extend(next.poles);
    }

    /// Adds the edges to greater vertices, so that each is added once.
    fn add_edges(&mut self, vertex: u32, star: &Star) {
        for edge in star.edges().filter(|edge| edge[0].end > vertex) {
            self.edge_count += 1;
            let pairs = edge.windows(2).map(|pair| [pair[0].triangle, pair[1].triangle]);
            self.neighbors.extend(pairs);
            match edge {
                [a, b] if a.is_outgoing == b.is_outgoing => {
                    self.inconsistent_edges.push([vertex, a.end]);
                }
                [_, _, _, ..] => self.non_manifold_edges.push([vertex, edge[0].end]),
                _ => {}
            }
            self.add_duplicates(edge);
        }
    }

    /// Adds the triangles at an edge that are there before. They share all their edges; the one
    /// between their two least vertices finds them.
    fn add_duplicates(&mut self, edge: &[Ray]) {
        match edge {
            [_] => {}
            [a, b] if a.apex != b.apex => {}
            _ => {
                let mut apexes: Vec<(u32, u32)> =
                    edge.iter().filter(|r| r.apex > r.end).map(|r| (r.apex, r.triangle)).collect();
                apexes.sort_unstable();
                let again = apexes.windows(2).filter(|pair| pair[0].0 == pair[1].0);
                self.duplicates.extend(again.map(|pair| pair[1].1));
            }
        }
    }
}
