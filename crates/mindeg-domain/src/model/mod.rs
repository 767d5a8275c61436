//! Whole models: planar faces in space that share edges.
//!
//! A model has corners, straight edges between them, and faces: loops of edges in one plane, the
//! outer one first and then holes. Every edge is divided once, from its lower corner to its higher
//! one, so that all its faces share its points bit for bit.
//!
//! Vertices of a model's mesh are the corners that faces use, in ascending order, and then the
//! points inside the edges, edge by edge; edges are in ascending order of their corners.
//!
//! Limits: straight edges and planar faces. A face may not touch itself: no loop passes a corner
//! twice, and loops of one face have no corner in common.

mod build;
mod coplanar;
mod crossing;
mod face;
mod faults;
mod from_mesh;

pub use face::Plane;
pub use from_mesh::FromMesh;

use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;
use mindeg_mesh::Material;

use crate::side::Side;
use crate::spacing::Spacing;
use crate::spacing_law::SpacingLaw;

/// A face as given: its loops of corners, and its names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelFace {
    /// The outer loop and then the holes, by corners. The outer loop runs counter-clockwise as seen
    /// from the front; holes may run either way.
    pub loops: Vec<Vec<u32>>,
    /// The face's own name.
    pub name: Option<String>,
    /// The group that it belongs to.
    pub group: Option<String>,
    /// Its material.
    pub material: Option<Arc<Material>>,
}

/// The division of one edge, seen from the first of its corners.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelEdge {
    /// Its corners, in either order.
    pub corners: [u32; 2],
    /// Its division and name.
    pub side: Side,
}

/// The input of a [`Model`].
#[derive(Clone, Debug)]
pub struct ModelParts {
    /// Positions of corners, in units of length.
    pub corners: Vec<DVec3>,
    /// The faces.
    pub faces: Vec<ModelFace>,
    /// The division of some edges.
    pub edges: Vec<ModelEdge>,
    /// The division of all other edges; `None` if all are given.
    pub other_edges: Option<Side>,
    /// How far a corner may be from the plane of its face, in units of length; `None` means
    /// [`PLANAR_SHARE`] of the largest extent of the model.
    pub planar_tolerance: Option<f64>,
}

/// The default tolerance of planarity, as a share of the largest extent of the model.
pub const PLANAR_SHARE: f64 = 1e-5;

/// Planar faces that share divided edges.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_domain::{Model, ModelFace, ModelParts, Side};
///
/// // A cube with three intervals to an edge.
/// let corner = |i: u32| DVec3::new((i & 1).into(), (i >> 1 & 1).into(), (i >> 2).into());
/// let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
/// let face = |quad: [u32; 4]| ModelFace { loops: vec![quad.to_vec()], ..ModelFace::default() };
/// let model = Model::new(ModelParts {
///     corners: (0..8).map(corner).collect(),
///     faces: quads.map(face).to_vec(),
///     edges: vec![],
///     other_edges: Some(Side::count(3)),
///     planar_tolerance: None,
/// })?;
/// assert_eq!((model.edge_count(), model.vertex_count()), (12, 8 + 12 * 2));
/// assert!(model.is_closed());
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    name: Option<String>,
    corners: Vec<DVec3>,
    /// The corners that are vertices, ascending.
    used: Vec<u32>,
    edges: Vec<Edge>,
    faces: Vec<Face>,
    groups: Vec<FaceGroup>,
    planar_tolerance: f64,
    notes: Vec<String>,
}

/// The faces of one group with one material: one piece of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceGroup {
    /// The group's name, if it has one.
    pub name: Option<String>,
    /// The material, if the faces have one.
    pub material: Option<Arc<Material>>,
}

#[derive(Clone, Debug, PartialEq)]
struct Edge {
    /// The lower and the higher corner.
    corners: [u32; 2],
    /// The vertex of the first interior point.
    first: u32,
    /// From the lower corner on.
    spacing: Spacing,
    law: SpacingLaw,
    name: Option<String>,
    /// The number of faces that pass the edge upwards (lower to higher corner), and downwards.
    passes: [u32; 2],
}

#[derive(Clone, Debug, PartialEq)]
struct Face {
    /// For each loop its edges in order; holes run opposite to the outer loop.
    loops: Vec<Vec<Pass>>,
    plane: Plane,
    name: Option<String>,
    group: u32,
}

/// One edge in the direction of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Pass {
    edge: u32,
    /// Whether it goes from the lower to the higher corner.
    is_upward: bool,
}

/// The position of a vertex on a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelPlace {
    /// At this corner.
    Corner(u32),
    /// Inside an edge.
    Edge {
        /// The edge.
        edge: u32,
        /// The index of the point on the edge, from its lower corner (0): 1 or more.
        point: u32,
    },
}

impl Model {
    /// The same model with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// The name of the model.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The number of edges of faces.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The number of vertices of a mesh of this model: corners and points of edges.
    pub fn vertex_count(&self) -> u32 {
        let end = |edge: &Edge| edge.first + edge.law.intervals() - 1;
        self.edges.last().map_or(self.used.len() as u32, end)
    }

    /// The groups of faces, in the order of their first faces. Groups of equal name but different
    /// materials follow one another.
    pub fn groups(&self) -> &[FaceGroup] {
        &self.groups
    }

    /// The index of the group of a face.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn group_of(&self, face: usize) -> usize {
        self.faces[face].group as usize
    }

    /// The name of a face.
    ///
    /// # Panics
    ///
    /// If the model has no such face.
    pub fn face_name(&self, face: usize) -> Option<&str> {
        self.faces[face].name.as_deref()
    }

    /// The lower and the higher corner of an edge.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn edge_corners(&self, edge: usize) -> [u32; 2] {
        self.edges[edge].corners
    }

    /// The name of an edge.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn edge_name(&self, edge: usize) -> Option<&str> {
        self.edges[edge].name.as_deref()
    }

    /// The number of intervals of an edge.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn intervals(&self, edge: usize) -> u32 {
        self.edges[edge].law.intervals()
    }

    /// The length of an edge.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn edge_length(&self, edge: usize) -> f64 {
        let [low, high] = self.edges[edge].corners.map(|corner| self.corners[corner as usize]);
        low.distance(high)
    }

    /// Whether the points of an edge are given, so that it keeps them.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn has_own_points(&self, edge: usize) -> bool {
        matches!(self.edges[edge].spacing, Spacing::Parameters(_))
    }

    /// The number of faces at an edge; a face that passes it twice counts twice.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn faces_at(&self, edge: usize) -> u32 {
        self.edges[edge].passes.iter().sum()
    }

    /// The vertices of an edge, from its lower to its higher corner.
    ///
    /// # Panics
    ///
    /// If the model has no such edge.
    pub fn edge_vertices(&self, edge: usize) -> impl DoubleEndedIterator<Item = u32> + '_ {
        let edge = &self.edges[edge];
        let [low, high] = edge.corners.map(|corner| self.vertex_of(corner));
        std::iter::once(low).chain(edge.inner()).chain(std::iter::once(high))
    }

    /// Whether every edge has at least two faces.
    pub fn is_closed(&self) -> bool {
        (0..self.edges.len()).all(|edge| self.faces_at(edge) > 1)
    }

    /// The edges with one face.
    pub fn boundary_edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.edges.len()).filter(|&edge| self.faces_at(edge) == 1)
    }

    /// The edges with three faces or more.
    pub fn non_manifold_edges(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.edges.len()).filter(|&edge| self.faces_at(edge) > 2)
    }

    /// Notes on the model for the user, one sentence each: open, flipped, not manifold, not quite
    /// planar.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The positions of all vertices. O(n). The points of an edge are computed from its lower to
    /// its higher corner.
    pub fn positions(&self) -> Vec<DVec3> {
        let mut positions = Vec::with_capacity(self.vertex_count() as usize);
        positions.extend(self.used.iter().map(|&corner| self.corners[corner as usize]));
        for edge in &self.edges {
            let [from, to] = edge.corners.map(|corner| self.corners[corner as usize]);
            let points = 1..edge.law.intervals();
            positions.extend(points.map(|i| from.lerp(to, edge.law.parameter(i))));
        }
        positions
    }

    /// The corner or edge that a vertex is on. O(log n).
    ///
    /// # Panics
    ///
    /// If the model has no such vertex.
    pub fn place(&self, vertex: u32) -> ModelPlace {
        if let Some(&corner) = self.used.get(vertex as usize) {
            return ModelPlace::Corner(corner);
        }
        assert!(vertex < self.vertex_count(), "the model has no vertex {vertex}");
        // The last edge that begins at the vertex or before; edges without points begin there, too.
        let edge = self.edges.partition_point(|edge| edge.first <= vertex) - 1;
        ModelPlace::Edge { edge: edge as u32, point: vertex - self.edges[edge].first + 1 }
    }

    /// For each vertex, the number of divided-edge ends there: 2 inside an edge, the valence at a
    /// corner. O(n).
    pub fn edge_degrees(&self) -> Vec<u32> {
        let mut degrees = vec![2; self.vertex_count() as usize];
        degrees[..self.used.len()].fill(0);
        for corner in self.edges.iter().flat_map(|edge| edge.corners) {
            degrees[self.vertex_of(corner) as usize] += 1;
        }
        degrees
    }

    /// The vertex of a corner that a face uses.
    fn vertex_of(&self, corner: u32) -> u32 {
        self.used.partition_point(|&used| used < corner) as u32
    }
}

impl Edge {
    /// The vertices inside.
    fn inner(&self) -> Range<u32> {
        self.first..self.first + self.law.intervals() - 1
    }
}
