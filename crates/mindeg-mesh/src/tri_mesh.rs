//! A triangle mesh as lists, the result of every reader.

mod append;
mod as_mesh;

use std::sync::OnceLock;

use glam::DVec3;
use thiserror::Error;

use crate::connectivity::boundary::{BoundaryEdges, BoundaryLoop};
use crate::connectivity::faces::Faces;
use crate::connectivity::stars::Stars;
use crate::mesh::{Group, Line, LineKind, NamedVertex, PeriodicLine};
use crate::planar::orientation;
use crate::polygons::{NonTriangles, Polygons};

/// A triangle mesh in space: any number of groups, with or without boundary, valid or not.
///
/// Every triangle names existing vertices, every position is finite, and the mesh has at least one
/// triangle. It guarantees nothing else: triangles may repeat, be flat, disagree in orientation or
/// meet three at an edge. A vertex that no triangle names is kept.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::TriMesh;
///
/// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
/// let mesh = TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?.named("square");
/// assert_eq!(mesh.boundary_loops()[0].vertices, [0, 1, 2, 3]);
/// assert_eq!(mesh.degrees(), [3, 2, 3, 2]);
/// # Ok::<(), mindeg_mesh::TriMeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TriMesh {
    name: Option<String>,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    groups: Vec<Group>,
    segments: Vec<[u32; 2]>,
    lines: Vec<Line>,
    /// Empty where no line has a kind.
    line_kinds: Vec<Option<LineKind>>,
    named_vertices: Vec<NamedVertex>,
    periodic_lines: Vec<PeriodicLine>,
    /// Empty where all are 0.
    depths: Vec<f64>,
    polygons: Option<Polygons>,
    non_triangles: NonTriangles,
    notes: Vec<String>,
    dropped: Vec<&'static str>,
    rounding: Option<f64>,
    degrees: Degrees,
}

/// The degrees of a mesh, once they were asked for. They follow from its triangles, so they make no difference.
#[derive(Clone, Debug, Default)]
struct Degrees(OnceLock<Vec<u32>>);

impl PartialEq for Degrees {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// Why points and triangles do not form a [`TriMesh`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct TriMeshError(String);

impl TriMeshError {
    /// A mesh with so many `things` that their indices are not u32.
    pub fn too_many(things: &str, count: usize) -> Self {
        Self(format!("the mesh has {count} {things}; the maximum is {}", u32::MAX))
    }
}

impl TriMesh {
    /// A mesh of positions and triangles, as one group without a name. O(n).
    ///
    /// # Errors
    ///
    /// A position that is not finite, a triangle with a vertex that the mesh does not have, more
    /// than `u32::MAX` vertices or triangles, or no triangle at all.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, TriMeshError> {
        let vertices = positions.len();
        if u32::try_from(vertices).is_err() {
            return Err(TriMeshError::too_many("vertices", vertices));
        }
        let Ok(triangle_count) = u32::try_from(triangles.len()) else {
            return Err(TriMeshError::too_many("triangles", triangles.len()));
        };
        if triangle_count == 0 {
            return Err(TriMeshError(format!("the mesh has no triangle ({vertices} vertices)")));
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(TriMeshError(format!(
                "vertex {vertex} (counted from 0) has a coordinate that is not a finite number"
            )));
        }
        check_vertices("triangle", &triangles, vertices)?;
        Ok(Self {
            name: None,
            positions,
            triangles,
            groups: vec![Group::new("", 0..triangle_count)],
            segments: Vec::new(),
            lines: Vec::new(),
            line_kinds: Vec::new(),
            named_vertices: Vec::new(),
            periodic_lines: Vec::new(),
            depths: Vec::new(),
            polygons: None,
            non_triangles: NonTriangles::default(),
            notes: Vec::new(),
            dropped: Vec::new(),
            rounding: None,
            degrees: Degrees::default(),
        })
    }

    /// The same mesh with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// The same mesh with this name, if it is one.
    #[must_use]
    pub fn called(self, name: Option<impl Into<String>>) -> Self {
        let name = name.map(Into::into).or(self.name);
        Self { name, ..self }
    }

    /// The same mesh in groups, which must contain every triangle once, in order; empty groups are
    /// dropped.
    ///
    /// # Panics
    ///
    /// If the groups do not contain every triangle once, in order.
    #[must_use]
    pub fn with_groups(self, mut groups: Vec<Group>) -> Self {
        groups.retain(|group| !group.triangles.is_empty());
        let mut end = 0;
        for group in &groups {
            assert_eq!(group.triangles.start, end, "groups follow one another");
            end = group.triangles.end;
        }
        assert_eq!(end as usize, self.triangles.len(), "groups hold every triangle");
        Self { groups, ..self }
    }

    /// The same mesh with lines, which must contain every segment once, in order.
    ///
    /// # Errors
    ///
    /// A segment with a vertex that the mesh does not have.
    ///
    /// # Panics
    ///
    /// If the lines do not contain every segment once, in order.
    pub fn with_lines(
        self,
        lines: Vec<Line>,
        segments: Vec<[u32; 2]>,
    ) -> Result<Self, TriMeshError> {
        check_vertices("segment", &segments, self.positions.len())?;
        let mut end = 0;
        for line in &lines {
            assert_eq!(line.segments.start, end, "lines follow one another");
            end = line.segments.end;
        }
        assert_eq!(end as usize, segments.len(), "lines hold every segment");
        Ok(Self { lines, segments, ..self })
    }

    /// The same mesh, with the kind of each of its lines in a coastal model.
    ///
    /// # Panics
    ///
    /// If the number of kinds differs from the number of lines.
    #[must_use]
    pub fn with_line_kinds(self, line_kinds: Vec<Option<LineKind>>) -> Self {
        assert_eq!(line_kinds.len(), self.lines.len(), "a kind for each line");
        Self { line_kinds, ..self }
    }

    /// The same mesh with names of vertices.
    ///
    /// # Errors
    ///
    /// A vertex that the mesh does not have.
    pub fn with_named_vertices(self, named: Vec<NamedVertex>) -> Result<Self, TriMeshError> {
        let vertices: Vec<[u32; 1]> = named.iter().map(|named| [named.vertex]).collect();
        check_vertices("name", &vertices, self.positions.len())?;
        Ok(Self { named_vertices: named, ..self })
    }

    /// The same mesh with lines that are others, moved.
    ///
    /// # Errors
    ///
    /// A line or a vertex that the mesh does not have.
    pub fn with_periodic_lines(self, periodic: Vec<PeriodicLine>) -> Result<Self, TriMeshError> {
        for PeriodicLine { line, of, vertices, .. } in &periodic {
            check_vertices("periodic pair", vertices, self.positions.len())?;
            if let Some(line) =
                [line, of].into_iter().find(|line| **line as usize >= self.lines.len())
            {
                return Err(TriMeshError(format!(
                    "a periodic line is {line}; the mesh has {} lines",
                    self.lines.len()
                )));
            }
        }
        Ok(Self { periodic_lines: periodic, ..self })
    }

    /// The same mesh with the depth of the water at each vertex.
    ///
    /// # Panics
    ///
    /// If the number of depths differs from the number of vertices, or a depth is not finite.
    #[must_use]
    pub fn with_depths(self, depths: Vec<f64>) -> Self {
        assert_eq!(depths.len(), self.positions.len(), "a depth for each vertex");
        assert!(depths.iter().all(|depth| depth.is_finite()), "depths are finite");
        Self { depths, ..self }
    }

    /// The same mesh in the plane z = 0, with depths of -z, if seen from above all triangles are counter-clockwise: z is the
    /// height of a bed then. Else the mesh as it is. O(n).
    #[must_use]
    pub fn with_bed_as_depths(mut self) -> Self {
        let is_bed = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| self.positions[vertex as usize].truncate());
            orientation(a, b, c) > 0.0
        };
        if self.positions.iter().any(|point| point.z != 0.0) && self.triangles.iter().all(is_bed) {
            let depth = |point: &mut DVec3| 0.0 - std::mem::take(&mut point.z);
            self.depths = self.positions.iter_mut().map(depth).collect();
        }
        self
    }

    /// The same mesh with the polygons that its triangles were cut from.
    ///
    /// # Panics
    ///
    /// If the polygons do not cover the triangles of the mesh, or a sum of corners does not fit k - 2 each.
    #[must_use]
    pub fn with_polygons(self, polygons: Polygons) -> Self {
        let triangles = polygons.triangle_starts.last().map_or(0, |&count| count as usize);
        assert_eq!(triangles, self.triangles.len(), "every triangle is of a polygon");
        assert_eq!(polygons.corners.len(), triangles + 2 * polygons.count(), "k - 2 triangles");
        Self { polygons: Some(polygons), ..self }
    }

    /// The same mesh with the counts of its file's elements that are not triangles.
    #[must_use]
    pub fn with_non_triangles(self, non_triangles: NonTriangles) -> Self {
        Self { non_triangles, ..self }
    }

    /// The same mesh with notes on contents of its file that the mesh lacks, such as morph targets
    /// or skins: one short phrase each, for people to read.
    #[must_use]
    pub fn with_notes(self, notes: Vec<String>) -> Self {
        Self { notes, ..self }
    }

    /// The same mesh with the kinds of values at vertices or corners that its file has and the mesh
    /// lacks, such as `"texture coordinates"`.
    #[must_use]
    pub fn with_dropped(self, dropped: Vec<&'static str>) -> Self {
        Self { dropped, ..self }
    }

    /// The same mesh, whose coordinates may be off by `rounding`, in units of length.
    ///
    /// A reader of 32-bit floats gives 2^-24 times the largest coordinate in the file, times the
    /// scale of the transform into the scene.
    ///
    /// # Panics
    ///
    /// If `rounding` is negative, infinite or NaN.
    #[must_use]
    pub fn with_rounding(self, rounding: f64) -> Self {
        assert!(rounding >= 0.0 && rounding.is_finite(), "{rounding} is no length");
        Self { rounding: Some(rounding), ..self }
    }

    /// The positions of the vertices, in units of the file.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The triangles by their vertices, in the order and orientation of the file. At least one.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The groups, which contain every triangle once, in order.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// Whether a group has a material.
    pub fn has_materials(&self) -> bool {
        self.groups.iter().any(|group| group.material.is_some())
    }

    /// The segments of all [lines](crate::Triangles::lines), one line after the other.
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The polygons that the triangles were cut from, if the file had any besides triangles.
    pub fn polygons(&self) -> Option<&Polygons> {
        self.polygons.as_ref()
    }

    /// The counts of the file's elements that are not triangles.
    pub fn non_triangles(&self) -> NonTriangles {
        self.non_triangles
    }

    /// The contents of the file that the mesh lacks, one short phrase each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The kinds of values at vertices or corners that the file has and the mesh lacks.
    pub fn dropped(&self) -> &[&'static str] {
        &self.dropped
    }

    /// The largest error of each coordinate, in units of length: the value of
    /// [`with_rounding`](Self::with_rounding), and never less than 2^-52 times the largest
    /// coordinate, two roundings of a 64-bit float. O(n).
    pub fn rounding(&self) -> f64 {
        let largest = self.positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        self.rounding.unwrap_or(0.0).max(f64::EPSILON * largest)
    }

    /// The number of edges of triangles at each vertex. O(n log d) for degrees of d, computed once.
    pub fn degrees(&self) -> &[u32] {
        self.degrees.0.get_or_init(|| {
            let mut degrees = vec![0; self.positions.len()];
            let faces = Faces::new(&self.triangles, None, None);
            let stars = Stars::new(self.positions.len(), &faces);
            stars.for_each(0..stars.count(), |vertex, star| {
                degrees[vertex as usize] = star.degree() as u32;
            });
            degrees
        })
    }

    /// The loops of edges with only one face, in the order of their first vertices. Faces are the
    /// [polygons](Self::polygons), or the triangles if the mesh has no other polygons.
    ///
    /// At a vertex, a loop continues with the boundary edge found by turning from face to face, so
    /// that loops that touch in a vertex stay apart. A closed loop starts at its least vertex; a
    /// loop that runs into an edge with three faces or more is open. Triangles that name a vertex
    /// twice do not count. O(n) time and memory, except for sorting at vertices of very high
    /// degree.
    pub fn boundary_loops(&self) -> Vec<BoundaryLoop> {
        let faces = Faces::new(&self.triangles, self.polygons(), None);
        BoundaryEdges::new(&Stars::new(self.positions.len(), &faces)).loops()
    }
}

fn check_vertices<const N: usize>(
    what: &str,
    items: &[[u32; N]],
    vertices: usize,
) -> Result<(), TriMeshError> {
    for (index, corners) in items.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(TriMeshError(format!(
                "{what} {index} (counted from 0) names vertex {vertex} (counted from 0); the mesh has \
                 {vertices} vertices"
            )));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Triangles;

    #[test]
    fn refuses_what_is_no_mesh_and_says_what() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let mut broken = square;
        broken[2].y = f64::NAN;
        for (positions, triangles, message) in [
            (square, vec![], "the mesh has no triangle (4 vertices)"),
            (
                square,
                vec![[0, 1, 2], [0, 2, 4]],
                "triangle 1 (counted from 0) names vertex 4 (counted from 0); the mesh has 4 vertices",
            ),
            (
                broken,
                vec![[0, 1, 2]],
                "vertex 2 (counted from 0) has a coordinate that is not a finite number",
            ),
        ] {
            let error = TriMesh::new(positions.to_vec(), triangles).unwrap_err();
            assert_eq!(error.to_string(), message);
        }
    }

    #[test]
    fn meshes_that_differ_in_one_part_are_not_equal() {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let both = vec![[0, 1, 2], [0, 2, 3]];
        let mesh = || TriMesh::new(points.clone(), both.clone()).unwrap();
        let with_line = |is_straight| {
            let line = Line { name: "side".into(), segments: 0..1, is_straight };
            mesh().with_lines(vec![line], vec![[0, 1]]).unwrap()
        };
        let mut moved = points.clone();
        moved[2].x = 2.0;
        assert_eq!(mesh(), mesh());
        for other in [
            mesh().named("x"),
            TriMesh::new(moved, both.clone()).unwrap(),
            TriMesh::new(points.clone(), vec![[0, 1, 3], [1, 2, 3]]).unwrap(),
            with_line(true),
            mesh().with_depths(vec![0.0; 4]),
            mesh()
                .with_polygons(Polygons { triangle_starts: vec![0, 2], corners: vec![0, 1, 2, 3] }),
            mesh().with_non_triangles(NonTriangles { points: 1, ..NonTriangles::default() }),
            mesh().with_notes(vec!["a note".to_owned()]),
            mesh().with_dropped(vec!["colors"]),
            mesh().with_rounding(0.5),
        ] {
            assert_ne!(mesh(), other);
        }
        assert_ne!(with_line(true), with_line(false));
    }

    #[test]
    fn a_plane_that_faces_up_has_a_normal() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let mesh = |points: [DVec3; 4], second| {
            TriMesh::new(points.to_vec(), vec![[0, 1, 2], second]).unwrap()
        };
        // Far from the origin, where the coordinates alone do not show a turn.
        let far = points.map(|point| point - DVec3::new(9.0, 7.0, 0.0));
        assert_eq!(mesh(far, [0, 2, 3]).normal(), Some(DVec3::Z));
        assert_eq!(mesh(far, [0, 3, 2]).normal(), None);
        assert_eq!(mesh(points, [0, 2, 3]).normal(), Some(DVec3::Z));
        assert_eq!(mesh(points.map(|p| p + DVec3::Z), [0, 2, 3]).normal(), Some(DVec3::Z));
        assert_eq!(mesh(points, [0, 3, 2]).normal(), None);
        assert_eq!(mesh(points.map(|p| DVec3::new(p.x, 0.0, p.y)), [0, 2, 3]).normal(), None);
    }
}
