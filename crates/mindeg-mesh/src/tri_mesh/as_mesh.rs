//! The list as writers and measures read it, positions and triangles by range, and back.

use std::borrow::Cow;

use glam::DVec3;

use super::TriMesh;
use super::TriMeshError;
use crate::bounds::Bounds;
use crate::mesh::{
    Group, Line, LineKind, Mesh, NamedVertex, PeriodicLine, Positions, Triangles, filled,
};

impl TriMesh {
    /// The list of any mesh: its positions, triangles, groups, lines, named vertices, kinds and depths.
    ///
    /// # Errors
    ///
    /// A mesh that [`TriMesh::new`] refuses.
    pub fn of(mesh: &dyn Mesh) -> Result<Self, TriMeshError> {
        let vertices = 0..mesh.vertex_count();
        let positions = filled(vertices.clone(), DVec3::ZERO, |first, out| {
            mesh.fill_positions(first, out);
        });
        let triangles =
            filled(0..mesh.triangle_count(), [0; 3], |first, out| mesh.fill_triangles(first, out));
        let lines = mesh.lines().into_owned();
        let count = lines.last().map_or(0, |line| line.segments.end);
        let segments = filled(0..count, [0; 2], |first, out| mesh.fill_segments(first, out));
        let kinds: Vec<_> = (0..lines.len()).map(|line| mesh.line_kind(line)).collect();
        let depths = filled(vertices, 0.0, |first, out| mesh.fill_depths(first, out));
        let mut list = Self::new(positions, triangles)?.with_lines(lines, segments)?;
        if kinds.iter().any(Option::is_some) {
            list = list.with_line_kinds(kinds);
        }
        if depths.iter().any(|&depth| depth != 0.0) {
            list = list.with_depths(depths);
        }
        list = list.with_named_vertices(mesh.named_vertices().into_owned())?;
        list = list.with_periodic_lines(mesh.periodic_lines().into_owned())?;
        if !mesh.groups().is_empty() {
            list = list.with_groups(mesh.groups().to_vec());
        }
        list.name = mesh.name().map(str::to_owned);
        Ok(list)
    }
}

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

    fn named_vertices(&self) -> Cow<'_, [NamedVertex]> {
        Cow::Borrowed(&self.named_vertices)
    }

    fn periodic_lines(&self) -> Cow<'_, [PeriodicLine]> {
        Cow::Borrowed(&self.periodic_lines)
    }

    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        out.copy_from_slice(&self.segments[first as usize..][..out.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_of_a_list_is_the_same() {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let plain = TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let line = Line { name: "shore".into(), segments: 0..1, is_straight: true };
        let groups = vec![Group::new("left", 0..1), Group::new("right", 1..2)];
        let full = plain.clone().named("plate").with_lines(vec![line], vec![[0, 1]]).unwrap();
        let gauge = NamedVertex { name: "gauge".into(), vertex: 3 };
        let full = full.with_named_vertices(vec![gauge]).unwrap();
        let turned = PeriodicLine { line: 0, of: 0, matrix: [[1.0; 4]; 4], vertices: vec![[0, 2]] };
        let full = full.with_periodic_lines(vec![turned]).unwrap();
        let full = full.with_line_kinds(vec![Some(LineKind::Land)]).with_groups(groups);
        for mesh in [plain, full.with_depths(vec![1.0, 0.0, 2.0, 0.0])] {
            assert_eq!(TriMesh::of(&mesh).unwrap(), mesh);
        }
    }
}
