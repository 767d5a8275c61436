//! The questions of the optimiser to the space that a mesh lies in; the same in the plane and on a surface.

use crate::array_mesh::ArrayMesh;
use crate::goal::Weights;
use crate::space::Space;
use glam::DVec2;
use std::fmt::Debug;

/// How the distortion of a triangle changes when one of its vertices moves in its tangent plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slope {
    /// The sum of the squared edges.
    pub(crate) squares: f64,
    /// Twice the area.
    pub(crate) doubled: f64,
    /// The gradients of both.
    pub(crate) of_squares: DVec2,
    pub(crate) of_doubled: DVec2,
}

/// The plane, or a surface, as the optimiser asks it.
pub(crate) trait Manifold: Space {
    /// The plane in which a vertex moves.
    type Frame: Copy + Debug;
    /// The state that an operation must not make worse.
    type Survey;

    /// The middle of an edge whose label is given.
    fn middle(
        mesh: &ArrayMesh<Self>,
        ends: [u32; 2],
        label: Self::Label,
        patch: Self::Patch,
    ) -> Option<Self::Site>;

    /// A place inside a patch, beside a vertex.
    fn beside(
        mesh: &ArrayMesh<Self>,
        vertex: u32,
        patch: Self::Patch,
        offset: Self::Vector,
    ) -> Option<Self::Site>;

    /// True if a triangle of a patch has these corners and is neither flat nor turned over.
    fn is_proper(&self, corners: [&Self::Site; 3]) -> bool;

    /// An error if a triangle of the mesh is turned over or has no area.
    fn check(mesh: &ArrayMesh<Self>, triangle: u32) -> Result<(), String>;

    /// The cost of a triangle beyond its shape and size.
    fn bend(mesh: &ArrayMesh<Self>, triangle: u32) -> f64;

    /// By how much a vertex's degree is out of its range, and how far it is from the best one.
    fn degree(mesh: &ArrayMesh<Self>, weights: &Weights, vertex: u32) -> (u32, f64);

    /// True if that depends on the number of triangles alone.
    fn counts_triangles(mesh: &ArrayMesh<Self>, vertex: u32) -> bool;

    fn frame(mesh: &ArrayMesh<Self>, vertex: u32) -> Self::Frame;

    /// True if a vertex moves along a line: by the first coordinate of its frame.
    fn is_on_line(mesh: &ArrayMesh<Self>, vertex: u32) -> bool;

    /// How a triangle changes with its corner `x`; `b` and `c` follow counter-clockwise. `None` if it has no area.
    fn slope(
        frame: &Self::Frame,
        x: Self::Vector,
        b: Self::Vector,
        c: Self::Vector,
    ) -> Option<Slope>;

    /// Where a vertex is after a step in its frame from a site.
    fn moved(
        mesh: &ArrayMesh<Self>,
        vertex: u32,
        from: &Self::Site,
        frame: &Self::Frame,
        step: DVec2,
    ) -> Option<Self::Site>;

    /// True if a vertex with these triangles may move to a site, whatever that does to shapes.
    fn may_move(mesh: &ArrayMesh<Self>, vertex: u32, triangles: &[u32], to: &Self::Site) -> bool;

    /// The state that the triangles at these vertices keep; `None` if that need not be looked at. `moves`: only a vertex moves.
    fn survey(mesh: &ArrayMesh<Self>, vertices: &[u32], moves: bool) -> Option<Self::Survey>;

    /// True if the mesh keeps it at these vertices.
    fn keeps(mesh: &ArrayMesh<Self>, survey: &Self::Survey, vertices: &[u32]) -> bool;
}
