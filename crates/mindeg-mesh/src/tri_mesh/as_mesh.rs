//! The list as writers and measures see it: positions and triangles by range.

use std::borrow::Cow;

use glam::DVec3;

use super::TriMesh;
use crate::bounds::Bounds;
use crate::mesh::{Group, Line, LineKind, Positions, Triangles};

impl Positions for TriMesh {
    fn vertex_count(&self) -> u32 {
        // Checked when the mesh was made.
        self.positions.len() as u32
    }

    fn fill_positions(&self, first: u32, out: &mut [DVec3]) {
        out.copy_from_slice(&self.positions[first as usize..][..out.len()]);
    }

    fn bounds(&self) -> Bounds<DVec3> {
        let none = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        Bounds::of_space(self.positions.iter().copied()).unwrap_or(none)
    }

    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        match &self.depths[..] {
            [] => out.fill(0.0),
            depths => out.copy_from_slice(&depths[first as usize..][..out.len()]),
        }
    }
}

impl Triangles for TriMesh {
    fn triangle_count(&self) -> u32 {
        // Checked when the mesh was made.
        self.triangles.len() as u32
    }

    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        out.copy_from_slice(&self.triangles[first as usize..][..out.len()]);
    }

    fn fill_degrees(&self, first: u32, out: &mut [u32]) {
        out.copy_from_slice(&self.degrees()[first as usize..][..out.len()]);
    }

    fn max_degree(&self) -> u32 {
        self.degrees().iter().copied().max().unwrap_or(0)
    }

    /// +Z, if all vertices have the same z and no triangle is clockwise seen from there.
    fn normal(&self) -> Option<DVec3> {
        let z = self.positions.first()?.z;
        let is_upward = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| self.positions[vertex as usize].truncate());
            (b - a).perp_dot(c - a) >= 0.0
        };
        let is_flat = self.positions.iter().all(|position| position.z == z);
        (is_flat && self.triangles.iter().all(is_upward)).then_some(DVec3::Z)
    }

    fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    fn groups(&self) -> &[Group] {
        &self.groups
    }

    fn lines(&self) -> Cow<'_, [Line]> {
        Cow::Borrowed(&self.lines)
    }

    fn line_kind(&self, line: usize) -> Option<LineKind> {
        self.line_kinds.get(line).copied().flatten()
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        out.copy_from_slice(&self.segments[first as usize..][..out.len()]);
    }
}
