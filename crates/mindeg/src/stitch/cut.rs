//! A mesh without some of its triangles.

use std::collections::BTreeSet;

use mindeg_mesh::{
    Group, Line, LineKind, NamedVertex, Positions, TriMesh, Triangles, edges_of, sorted,
};

use crate::error::MeshError;

/// The rest of a mesh.
pub(super) struct Cut {
    /// The vertices that are left, by their old indices.
    pub(super) vertices: Vec<u32>,
    /// The triangles that are left, with old indices.
    pub(super) triangles: Vec<[u32; 3]>,
    is_dropped: Vec<bool>,
}

impl Cut {
    pub(super) fn new(mesh: &TriMesh, is_dropped: &[bool]) -> Self {
        let left = mesh.triangles().iter().zip(is_dropped).filter(|(_, is_dropped)| !**is_dropped);
        let triangles: Vec<[u32; 3]> = left.map(|(corners, _)| *corners).collect();
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        Self { vertices, triangles, is_dropped: is_dropped.to_vec() }
    }

    /// The new index of a vertex that is left.
    pub(super) fn number(&self, vertex: u32) -> Option<u32> {
        self.vertices.binary_search(&vertex).ok().map(|index| index as u32)
    }

    /// The mesh that is left, with its names, kinds and depths. A line that was cut is several.
    pub(super) fn mesh(&self, of: &TriMesh) -> Result<TriMesh, MeshError> {
        let positions = self.vertices.iter().map(|v| of.positions()[*v as usize]).collect();
        // Vertices of triangles that are left are left.
        let number = |vertex: u32| self.number(vertex).unwrap_or_default();
        let triangles = self.triangles.iter().map(|corners| corners.map(number)).collect();
        let mut end = 0;
        let group = |group: &Group| {
            let own = group.triangles.start as usize..group.triangles.end as usize;
            let count = self.is_dropped[own].iter().filter(|is_dropped| !**is_dropped).count();
            let start = end;
            end += count as u32;
            Group { triangles: start..end, ..group.clone() }
        };
        let groups = of.groups().iter().map(group).collect();
        let edges: BTreeSet<[u32; 2]> =
            self.triangles.iter().copied().flat_map(edges_of).map(sorted).collect();
        let (mut lines, mut kinds, mut segments) =
            (Vec::new(), Vec::<Option<LineKind>>::new(), Vec::new());
        for (index, line) in of.lines().iter().enumerate() {
            let own = line.segments.start as usize..line.segments.end as usize;
            let is_left = |ends: &&[u32; 2]| edges.contains(&sorted(**ends));
            let left: Vec<[u32; 2]> = of.segments()[own].iter().filter(is_left).copied().collect();
            for piece in left.chunk_by(|a, b| a[1] == b[0]) {
                let start = segments.len() as u32;
                segments.extend(piece.iter().map(|ends| ends.map(number)));
                let segments = start..segments.len() as u32;
                lines.push(Line { segments, ..line.clone() });
                kinds.push(of.line_kind(index));
            }
        }
        let named = |named: &NamedVertex| {
            Some(NamedVertex { vertex: self.number(named.vertex)?, ..named.clone() })
        };
        let mesh = TriMesh::new(positions, triangles)?
            .with_groups(groups)
            .with_lines(lines, segments)?
            .with_line_kinds(kinds)
            .with_named_vertices(of.named_vertices().iter().filter_map(named).collect())?;
        let mesh = mesh.called(of.name());
        if !of.has_depths() {
            return Ok(mesh);
        }
        let mut depths = vec![0.0; of.positions().len()];
        of.fill_depths(0, &mut depths);
        Ok(mesh.with_depths(self.vertices.iter().map(|v| depths[*v as usize]).collect()))
    }
}
