//! The counts and defects of a mesh, from the stars of all vertices.

use crate::connectivity::boundary::BoundaryEdges;
use crate::connectivity::disjoint_sets::DisjointSets;
use crate::connectivity::faces::Faces;
use crate::connectivity::stars::{HalfEdge, Star, Stars};
use crate::parallel::blocks;
use crate::summary::DegreeHistogram;
use std::ops::Range;

/// A vertex and its degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexDegree {
    /// The vertex.
    pub vertex: u32,
    /// The number of edges at the vertex.
    pub degree: u32,
    /// Whether one of its edges is a boundary edge.
    pub on_boundary: bool,
}

/// The findings, with vertices and faces in ascending order.
#[derive(Default)]
pub(super) struct Topology {
    /// Vertices without an edge.
    pub(super) isolated: Vec<u32>,
    pub(super) face_count: usize,
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
    /// The vertices of a higher degree than the pole degree.
    pub(super) poles: Vec<VertexDegree>,
    /// Faces that share an edge.
    neighbors: Vec<[u32; 2]>,
}

impl Topology {
    /// Visits every star, with all threads.
    pub(super) fn new(vertex_count: usize, faces: &Faces<'_>, pole_degree: u32) -> Self {
        let stars = Stars::new(vertex_count, faces);
        let in_blocks = blocks(stars.count(), |range| Self::of_some(&stars, range, pole_degree));
        let mut topology = Self::default();
        let mut components = DisjointSets::new(faces.count());
        for of_block in in_blocks {
            for &[a, b] in &of_block.neighbors {
                components.join(a, b);
            }
            topology.append(of_block);
        }
        topology.face_count = faces.iter().filter(|(_, corners)| !corners.is_empty()).count();
        // A face that encloses nothing is a set of its own.
        topology.component_count = components.count() - (faces.count() - topology.face_count);
        topology.duplicates.sort_unstable();
        topology.duplicates.dedup();
        topology
    }

    /// The results from the stars of some vertices, without the counts of faces and components.
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
            topology.add_edges(vertex, star, stars.faces());
        });
        topology.boundary_degrees = boundary_degrees.into_iter().collect();
        topology.interior_degrees = interior_degrees.into_iter().collect();
        topology
    }

    /// Adds the results of the vertices that follow.
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
        // If several vertices have the same degree, the first stays.
        let degree = |highest: Option<VertexDegree>| highest.map(|vertex| vertex.degree);
        if degree(next.highest) > degree(self.highest) {
            self.highest = next.highest;
        }
        self.poles.extend(next.poles);
    }

    /// Adds the edges to greater vertices, so that each is added once.
    fn add_edges(&mut self, vertex: u32, star: &Star, faces: &Faces<'_>) {
        for edge in star.edges().filter(|edge| edge[0].end > vertex) {
            self.edge_count += 1;
            let pairs = edge.windows(2).map(|pair| [pair[0].corner.face, pair[1].corner.face]);
            self.neighbors.extend(pairs);
            match edge {
                [a, b] if a.is_outgoing == b.is_outgoing => {
                    self.inconsistent_edges.push([vertex, a.end]);
                }
                [_, _, _, ..] => self.non_manifold_edges.push([vertex, edge[0].end]),
                _ => {}
            }
            self.add_duplicates(vertex, edge, faces);
        }
    }

    /// Adds the faces at an edge that repeat an earlier one. They share all their edges, so at
    /// their least vertex, the edge to the lesser neighbor finds them.
    fn add_duplicates(&mut self, vertex: u32, edge: &[HalfEdge], faces: &Faces<'_>) {
        match edge {
            [_] => return,
            [a, b] if a.other_end != b.other_end => return,
            _ => {}
        }
        let mut found: Vec<(Vec<u32>, u32)> = edge
            .iter()
            .filter(|half| half.other_end > half.end)
            .map(|half| (corners_along(half, faces), half.corner.face))
            .filter(|(corners, _)| corners.iter().all(|&corner| corner >= vertex))
            .collect();
        found.sort_unstable();
        let again = found.chunk_by(|a, b| a.0 == b.0).flat_map(|same| &same[1..]);
        self.duplicates.extend(again.map(|(_, face)| face));
    }
}

/// The corners of the face of a half-edge, from its start on and along it.
fn corners_along(half: &HalfEdge, faces: &Faces<'_>) -> Vec<u32> {
    let (before, after) = faces.corners(half.corner.face).split_at(half.corner.index as usize);
    let mut corners = [after, before].concat();
    if !half.is_outgoing {
        corners[1..].reverse();
    }
    corners
}
