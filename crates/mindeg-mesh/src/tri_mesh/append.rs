//! A mesh with more triangles, with another mesh beside it, or in another place.

use std::collections::HashMap;

use glam::DVec3;

use super::{Degrees, TriMesh, TriMeshError, check_vertices};
use crate::mesh::{Group, Line, NamedVertex, PeriodicLine};
use crate::polygons::{NonTriangles, Polygons};

impl TriMesh {
    /// The same mesh with its vertices elsewhere.
    ///
    /// # Errors
    ///
    /// Another number of positions, or one that is not finite.
    pub fn with_positions(self, positions: Vec<DVec3>) -> Result<Self, TriMeshError> {
        let count = self.positions.len();
        if positions.len() != count {
            return Err(TriMeshError(format!(
                "{} positions for {count} vertices",
                positions.len()
            )));
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(TriMeshError(format!("vertex {vertex} would have no finite place")));
        }
        Ok(Self { positions, ..self })
    }

    /// The same mesh with more triangles between its vertices, appended as a group of their own.
    /// Everything else stays unchanged. O(n) if the mesh has polygons, else O(k) for k triangles.
    ///
    /// # Errors
    ///
    /// A triangle with a vertex that the mesh does not have, or more than `u32::MAX` triangles.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec3;
    /// use mindeg_mesh::TriMesh;
    ///
    /// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    /// let half = TriMesh::new(square, vec![[0, 1, 2]])?;
    /// let whole = half.with_triangles_added("other half", &[[0, 2, 3]])?;
    /// assert_eq!(whole.groups()[1].name, "other half");
    /// assert_eq!(whole.groups()[1].triangles, 1..2);
    /// # Ok::<(), mindeg_mesh::TriMeshError>(())
    /// ```
    pub fn with_triangles_added(
        mut self,
        group: &str,
        triangles: &[[u32; 3]],
    ) -> Result<Self, TriMeshError> {
        check_vertices("triangle", triangles, self.positions.len())?;
        let start = self.triangles.len() as u32;
        let all = self.triangles.len() + triangles.len();
        let end = u32::try_from(all).map_err(|_| TriMeshError::too_many("triangles", all))?;
        if end > start {
            self.groups.push(Group::new(group, start..end));
        }
        self.triangles.extend_from_slice(triangles);
        if let Some(polygons) = &mut self.polygons {
            polygons.triangle_starts.extend(start + 1..=end);
            polygons.corners.extend(triangles.iter().flatten());
        }
        self.degrees = Degrees::default();
        Ok(self)
    }

    /// The same mesh with more vertices, which no triangle has yet; where others have depths, theirs are 0. O(k) for k vertices.
    ///
    /// # Errors
    ///
    /// A coordinate that is not finite, or more than `u32::MAX` vertices.
    pub fn with_vertices_added(mut self, positions: &[DVec3]) -> Result<Self, TriMeshError> {
        let all = self.positions.len() + positions.len();
        u32::try_from(all).map_err(|_| TriMeshError::too_many("vertices", all))?;
        if let Some(bad) = positions.iter().position(|position| !position.is_finite()) {
            let message = format!("new vertex {bad} has a coordinate that is not a finite number");
            return Err(TriMeshError(message));
        }
        self.positions.extend_from_slice(positions);
        if !self.depths.is_empty() {
            self.depths.resize(all, 0.0);
        }
        self.degrees = Degrees::default();
        Ok(self)
    }

    /// The same mesh with one group for each name and material, in the order of their first triangles. The triangles of
    /// a group keep their order; a mesh whose groups change has no polygons any more. O(n).
    #[must_use]
    pub fn with_groups_merged(mut self) -> Self {
        let mut known = HashMap::new();
        let mut merged: Vec<(&Group, Vec<[u32; 3]>)> = Vec::new();
        for group in &self.groups {
            let material = group.material.as_ref().map(|material| &*material.name);
            let at = *known.entry((&*group.name, material)).or_insert(merged.len());
            if at == merged.len() {
                merged.push((group, Vec::new()));
            }
            let own = group.triangles.start as usize..group.triangles.end as usize;
            merged[at].1.extend_from_slice(&self.triangles[own]);
        }
        if merged.len() == self.groups.len() {
            return self;
        }
        let mut end = 0;
        let (mut groups, mut triangles) = (Vec::new(), Vec::with_capacity(self.triangles.len()));
        for (group, own) in merged {
            let start = end;
            end += own.len() as u32;
            groups.push(Group { triangles: start..end, ..group.clone() });
            triangles.extend(own);
        }
        (self.groups, self.triangles, self.polygons) = (groups, triangles, None);
        self
    }

    /// This mesh and another as one: first the vertices, triangles, groups and lines of this mesh,
    /// then those of the other. The name is that of this mesh, or else of the other. O(n).
    ///
    /// # Errors
    ///
    /// More than `u32::MAX` vertices or triangles in all.
    pub fn with_mesh_added(mut self, other: &Self) -> Result<Self, TriMeshError> {
        let (first, first_triangle) = (self.positions.len(), self.triangles.len());
        let vertices = first + other.positions.len();
        u32::try_from(vertices).map_err(|_| TriMeshError::too_many("vertices", vertices))?;
        let triangles = first_triangle + other.triangles.len();
        u32::try_from(triangles).map_err(|_| TriMeshError::too_many("triangles", triangles))?;
        // Both sums fit in 32 bits, so their summands do.
        let (first, first_triangle) = (first as u32, first_triangle as u32);
        let (first_segment, first_line) = (self.segments.len() as u32, self.lines.len() as u32);

        let polygons = match (self.polygons.take(), &other.polygons) {
            (None, None) => None,
            (own, others) => {
                let mut all = own.unwrap_or_else(|| as_polygons(&self.triangles));
                let others = others.clone().unwrap_or_else(|| as_polygons(&other.triangles));
                let starts = others.triangle_starts.iter().skip(1);
                all.triangle_starts.extend(starts.map(|start| first_triangle + start));
                all.corners.extend(others.corners.iter().map(|corner| first + corner));
                Some(all)
            }
        };
        self.polygons = polygons;
        if !(self.depths.is_empty() && other.depths.is_empty()) {
            self.depths.resize(first as usize, 0.0);
            self.depths.extend_from_slice(&other.depths);
            self.depths.resize(vertices, 0.0);
        }
        if !(self.line_kinds.is_empty() && other.line_kinds.is_empty()) {
            self.line_kinds.resize(first_line as usize, None);
            self.line_kinds.extend_from_slice(&other.line_kinds);
            self.line_kinds.resize(self.lines.len() + other.lines.len(), None);
        }
        self.positions.extend_from_slice(&other.positions);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|vertex| first + vertex)));
        self.groups.extend(other.groups.iter().map(|group| Group {
            triangles: first_triangle + group.triangles.start..first_triangle + group.triangles.end,
            ..group.clone()
        }));
        self.segments.extend(other.segments.iter().map(|s| s.map(|vertex| first + vertex)));
        self.lines.extend(other.lines.iter().map(|line| Line {
            segments: first_segment + line.segments.start..first_segment + line.segments.end,
            ..line.clone()
        }));
        self.named_vertices.extend(
            other
                .named_vertices
                .iter()
                .map(|named| NamedVertex { vertex: first + named.vertex, ..named.clone() }),
        );
        self.periodic_lines.extend(other.periodic_lines.iter().map(|own| PeriodicLine {
            line: first_line + own.line,
            of: first_line + own.of,
            vertices: own.vertices.iter().map(|pair| pair.map(|vertex| first + vertex)).collect(),
            ..own.clone()
        }));
        self.name = self.name.or_else(|| other.name.clone());
        let [a, b] = [self.non_triangles, other.non_triangles];
        self.non_triangles = NonTriangles {
            quads: a.quads + b.quads,
            polygons: a.polygons + b.polygons,
            line_segments: a.line_segments + b.line_segments,
            points: a.points + b.points,
        };
        self.notes.extend(other.notes.iter().cloned());
        let missing = |kind: &&&str| !self.dropped.contains(kind);
        let more: Vec<_> = other.dropped.iter().filter(missing).copied().collect();
        self.dropped.extend(more);
        self.rounding = match (self.rounding, other.rounding) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        self.degrees = Degrees::default();
        Ok(self)
    }
}

/// Triangles as polygons of three corners.
fn as_polygons(triangles: &[[u32; 3]]) -> Polygons {
    Polygons {
        triangle_starts: (0..=triangles.len() as u32).collect(),
        corners: triangles.iter().flatten().copied().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn quad() -> TriMesh {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let polygons = Polygons { triangle_starts: vec![0, 2], corners: vec![0, 1, 2, 3] };
        let mesh = TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let line = Line { name: "edge".into(), segments: 0..1, is_straight: true };
        mesh.with_polygons(polygons).with_lines(vec![line], vec![[0, 1]]).unwrap()
    }

    fn triangle() -> TriMesh {
        let mesh = TriMesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]);
        mesh.unwrap().named("triangle").with_rounding(0.5)
    }

    #[test]
    fn depths_and_kinds_stay_with_their_vertices_and_lines() {
        use crate::{LineKind, Mesh, Positions, Triangles};
        let told = quad()
            .with_depths(vec![1.0, 2.0, 3.0, 4.0])
            .with_line_kinds(vec![Some(LineKind::Open)]);
        for (one, other, depths, kinds) in [
            (&told, &triangle(), [1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0], [Some(LineKind::Open), None]),
            (&triangle(), &told, [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0], [Some(LineKind::Open), None]),
        ] {
            let both = one.clone().with_mesh_added(other).unwrap();
            let mut found = [0.0; 7];
            both.fill_depths(0, &mut found);
            assert_eq!(found, depths);
            assert_eq!([0, 1].map(|line| (&both as &dyn Mesh).line_kind(line)), kinds);
        }
        let both = quad().with_mesh_added(&told).unwrap();
        assert_eq!([0, 1].map(|line| both.line_kind(line)), [None, Some(LineKind::Open)]);
    }

    #[test]
    fn added_triangles_are_polygons_and_a_group_of_their_own() {
        let mesh = quad().with_triangles_added("fill", &[[3, 2, 1], [3, 1, 0]]).unwrap();
        assert_eq!(mesh.triangles()[2..], [[3, 2, 1], [3, 1, 0]]);
        assert_eq!(mesh.degrees(), [3; 4]);
        let polygons = mesh.polygons().unwrap();
        assert!(polygons.iter().eq([&[0, 1, 2, 3][..], &[3, 2, 1], &[3, 1, 0]]));
        let names: Vec<_> = mesh.groups().iter().map(|group| &*group.name).collect();
        assert_eq!(names, ["", "fill"]);
        let error = quad().with_triangles_added("fill", &[[0, 1, 4]]).unwrap_err();
        assert!(error.to_string().contains("names vertex 4 "), "{error}");
        assert_eq!(quad().with_triangles_added("fill", &[]).unwrap(), quad());
    }

    #[test]
    fn vertices_are_appended() {
        let mesh = quad().with_depths(vec![1.0; 4]).with_vertices_added(&[DVec3::Z]).unwrap();
        assert_eq!((mesh.positions().len(), mesh.positions()[4]), (5, DVec3::Z));
        assert_eq!(mesh.degrees().len(), 5);
        let mut depths = [9.0; 5];
        crate::Positions::fill_depths(&mesh, 0, &mut depths);
        assert_eq!(depths, [1.0, 1.0, 1.0, 1.0, 0.0]);
        let error = quad().with_vertices_added(&[DVec3::NAN]).unwrap_err();
        assert!(error.to_string().contains("new vertex 0 "), "{error}");
    }

    #[test]
    fn two_meshes_become_one() {
        for (a, b) in [(quad(), triangle()), (triangle(), quad()), (quad(), quad())] {
            let both = a.clone().with_mesh_added(&b).unwrap();
            let (vertices, triangles) = (a.positions().len() as u32, a.triangles().len());
            assert_eq!(both.positions()[..a.positions().len()], *a.positions());
            assert_eq!(both.positions()[a.positions().len()..], *b.positions());
            assert_eq!(both.triangles()[..triangles], *a.triangles());
            let others = b.triangles().iter().map(|t| t.map(|vertex| vertices + vertex));
            assert!(both.triangles()[triangles..].iter().copied().eq(others));
            let count =
                |mesh: &TriMesh| mesh.polygons().map_or(mesh.triangles().len(), Polygons::count);
            assert_eq!(both.polygons().unwrap().count(), count(&a) + count(&b));
            assert_eq!(both.polygons().unwrap().iter().last().unwrap()[0], vertices);
            assert_eq!(both.segments().len(), a.segments().len() + b.segments().len());
            assert_eq!(both.degrees(), [a.degrees(), b.degrees()].concat());
        }
        let grouped = |mesh: TriMesh, name: &str| {
            let count = mesh.triangles().len() as u32;
            mesh.with_groups(vec![Group::new(name.to_owned(), 0..count)])
        };
        let three = grouped(quad(), "a").with_mesh_added(&grouped(quad(), "b")).unwrap();
        let three = three.with_mesh_added(&grouped(quad(), "c")).unwrap();
        let ranges: Vec<_> = three.groups().iter().map(|group| group.triangles.clone()).collect();
        assert_eq!(ranges, [0..2, 2..4, 4..6]);
        let lines: Vec<_> = three.lines.iter().map(|line| line.segments.clone()).collect();
        assert_eq!(lines, [0..1, 1..2, 2..3]);
        let both = quad().with_mesh_added(&triangle()).unwrap();
        assert_eq!((both.rounding(), crate::Triangles::name(&both)), (0.5, Some("triangle")));
    }
}
