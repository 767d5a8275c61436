//! A mesh that says how it was made.

use std::borrow::Cow;

use glam::DVec3;

use crate::bounds::Bounds;
use crate::mesh::{Group, Line, LineKind, Mesh, NamedVertex, Positions, Triangles};

/// A mesh that says how it was [made](Triangles::made_by).
pub struct MadeBy<'a> {
    /// The mesh.
    pub mesh: &'a dyn Mesh,
    /// How it was made.
    pub made_by: &'a str,
}

impl Positions for MadeBy<'_> {
    fn vertex_count(&self) -> u32 {
        self.mesh.vertex_count()
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        self.mesh.fill_positions(first, out);
    }

    fn bounds(&self) -> Bounds<DVec3> {
        self.mesh.bounds()
    }

    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        self.mesh.fill_depths(first, out);
    }

    fn is_ring(&self) -> bool {
        self.mesh.is_ring()
    }
}

impl Triangles for MadeBy<'_> {
    fn triangle_count(&self) -> u32 {
        self.mesh.triangle_count()
    }

    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        self.mesh.fill_triangles(first, out);
    }

    fn fill_degrees(&self, first: u32, out: &mut [u32]) {
        self.mesh.fill_degrees(first, out);
    }

    fn max_degree(&self) -> u32 {
        self.mesh.max_degree()
    }

    fn normal(&self) -> Option<DVec3> {
        self.mesh.normal()
    }

    fn name(&self) -> Option<&str> {
        self.mesh.name()
    }

    fn made_by(&self) -> Option<&str> {
        Some(self.made_by)
    }

    fn groups(&self) -> &[Group] {
        self.mesh.groups()
    }

    fn lines(&self) -> Cow<'_, [Line]> {
        self.mesh.lines()
    }

    fn line_kind(&self, line: usize) -> Option<LineKind> {
        self.mesh.line_kind(line)
    }

    fn named_vertices(&self) -> Cow<'_, [NamedVertex]> {
        self.mesh.named_vertices()
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        self.mesh.fill_segments(first, out);
    }
}
