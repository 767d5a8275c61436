//! The lines and points inside a domain as a mesh has them.

use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;

/// The inner points of a boundary with those that divide segments, and the edges that segments are divided into.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Breaklines {
    /// After the outline's points.
    pub(crate) points: Vec<DVec2>,
    pub(crate) edges: Vec<[u32; 2]>,
}

impl Breaklines {
    pub(crate) fn pieces(&self, outline: &PlanarBoundary) -> Vec<Piece> {
        let at = |v: u32| self.at(outline, v);
        self.edges.iter().map(|[a, b]| Piece { from: at(*a), to: at(*b) }).collect()
    }

    pub(crate) fn at(&self, outline: &PlanarBoundary, vertex: u32) -> DVec2 {
        let boundary = outline.points();
        match boundary.get(vertex as usize) {
            Some(point) => *point,
            None => self.points[vertex as usize - boundary.len()],
        }
    }
}

/// A segment that the packing starts from and keeps clear of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
}
