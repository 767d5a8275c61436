//! The interface of a triangle mesh for a writer, a measure or a picture.
//!
//! A mesh has two traits. [`Positions`] gives the positions of the vertices; a domain knows them
//! before it has a mesh. [`Triangles`] gives the triangles, their groups and their names. Both work
//! on ranges, so a mesh that is a formula streams through a writer, and a mesh that is a list is
//! copied.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::bounds::Bounds;

/// The positions of the vertices.
pub trait Positions: Sync {
    /// The number of vertices.
    fn vertex_count(&self) -> u32;

    /// Fills `out` with the positions of the vertices from `first` on.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    fn fill_positions(&self, first: u32, out: &mut [DVec3]);

    /// The smallest box around all vertices.
    fn bounds(&self) -> Bounds<DVec3>;

    /// Whether x and y are known to be degrees of longitude and latitude.
    fn is_in_degrees(&self) -> bool {
        false
    }

    /// Fills `out` with the water depths at the vertices from `first` on: 0 unless the mesh is a
    /// coastal model with depths.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        let _ = first;
        out.fill(0.0);
    }

    /// Whether a vertex has a depth other than 0. O(n).
    fn has_depths(&self) -> bool {
        const BLOCK: u32 = 1 << 12;
        let count = self.vertex_count();
        (0..count).step_by(BLOCK as usize).any(|first| {
            let block = first..first.saturating_add(BLOCK).min(count);
            let depths = filled(block, 0.0, |first, out| self.fill_depths(first, out));
            depths.iter().any(|depth| *depth != 0.0)
        })
    }

    /// Whether consecutive vertices, and the last and the first, are neighbours on one boundary:
    /// then no two of them may become one point in a file.
    fn is_ring(&self) -> bool {
        false
    }
}

/// The triangles of a mesh and the names of its groups and lines.
pub trait Triangles: Sync {
    /// The number of triangles.
    fn triangle_count(&self) -> u32;

    /// Fills `out` with the triangles from `first` on. Each is counter-clockwise seen from its
    /// front.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` triangles remain from `first` on.
    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]);

    /// Fills `out` with the degrees of the vertices from `first` on.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    fn fill_degrees(&self, first: u32, out: &mut [u32]);

    /// The largest degree.
    fn max_degree(&self) -> u32;

    /// The unit normal of all triangles, if they lie in one plane and face the same way.
    fn normal(&self) -> Option<DVec3> {
        None
    }

    /// The name of the mesh.
    fn name(&self) -> Option<&str> {
        None
    }

    /// How the mesh was made, for files that have a place for remarks: one line of ASCII without `"`, `&`, `<`, `>`
    /// and `\\`. `None` for the name of the program alone.
    fn made_by(&self) -> Option<&str> {
        None
    }

    /// The named groups, which contain every triangle once, in order; empty if the mesh has none.
    fn groups(&self) -> &[Group] {
        &[]
    }

    /// The named lines of the mesh, such as the sides of its domain, which contain every segment
    /// once, in order. Lines of one name are one group.
    fn lines(&self) -> Cow<'_, [Line]> {
        Cow::Borrowed(&[])
    }

    /// The kind of the line with this index in a coastal model, if known.
    fn line_kind(&self, line: usize) -> Option<LineKind> {
        let _ = line;
        None
    }

    /// The vertices with names, in any order; vertices that share a name are one group.
    fn named_vertices(&self) -> Cow<'_, [NamedVertex]> {
        Cow::Borrowed(&[])
    }

    /// The lines that are others, moved.
    fn periodic_lines(&self) -> Cow<'_, [PeriodicLine]> {
        Cow::Borrowed(&[])
    }

    /// Fills `out` with the segments from `first` on. The segments of a line follow one another.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` segments remain from `first` on.
    fn fill_segments(&self, first: u32, out: &mut [[u32; 2]]) {
        assert!(out.is_empty(), "the mesh has no segment {first}");
    }
}

/// Any triangle mesh: positions and triangles.
pub trait Mesh: Positions + Triangles {}

impl<T: Positions + Triangles + ?Sized> Mesh for T {}

/// A range of a mesh's triangles with one name and one material: an object or group of an OBJ, or
/// its triangles of one material; a node of a glTF, or one of its primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name; empty if the group has none.
    pub name: String,
    /// The triangles; never empty.
    pub triangles: Range<u32>,
    /// The material, if the group has one. Groups may share it.
    pub material: Option<Arc<Material>>,
}

impl Group {
    /// A group without a material.
    pub fn new(name: impl Into<String>, triangles: Range<u32>) -> Self {
        Self { name: name.into(), triangles, material: None }
    }

    /// The same group with a material.
    #[must_use]
    pub fn of_material(self, material: Option<Arc<Material>>) -> Self {
        Self { material, ..self }
    }

    /// The label of the group in a file without materials: its name, or else its material's name.
    pub fn label(&self) -> &str {
        match &self.material {
            Some(material) if self.name.is_empty() => &material.name,
            _ => &self.name,
        }
    }
}

/// The material of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name; never empty.
    pub name: String,
    /// The base color, if it is known: red, green, blue and opacity, each 0 to 1, in linear light.
    pub color: Option<[f32; 4]>,
}

/// A named range of a mesh's segments: a side of a domain, or the lines of an object of an OBJ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The name; never empty.
    pub name: String,
    /// The segments; never empty.
    pub segments: Range<u32>,
    /// Whether each segment is known to start at the end of the previous one, all on the straight
    /// line between the ends of the line, except for rounding.
    pub is_straight: bool,
}

/// A vertex with a name, such as a gauge or a support.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedVertex {
    /// The name; never empty.
    pub name: String,
    /// Its index.
    pub vertex: u32,
}

/// A line that is another one, moved: a mesh that is joined there is periodic.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicLine {
    /// Its index.
    pub line: u32,
    /// The index of the other line.
    pub of: u32,
    /// The rows of the matrix that moves a point (x, y, z, 1) of the other line here.
    pub matrix: [[f64; 4]; 4],
    /// Each vertex of the line with the one that is moved there.
    pub vertices: Vec<[u32; 2]>,
}

/// The kind of a line on the boundary of a coastal model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LineKind {
    /// Open water.
    Open,
    /// The shore of the mainland.
    Land,
    /// The shore of an island.
    Island,
}

impl LineKind {
    /// The word for it in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Land => "land",
            Self::Island => "island",
        }
    }

    /// The kind that a word of a file means.
    #[must_use]
    pub fn named(word: &str) -> Option<Self> {
        [Self::Open, Self::Land, Self::Island].into_iter().find(|kind| kind.name() == word)
    }
}

/// The values of a range, from a function that fills a slice.
///
/// # Example
///
/// ```
/// use mindeg_mesh::filled;
///
/// let squares = filled(2..5, 0, |first, out: &mut [u32]| {
///     (first..).zip(out).for_each(|(i, value)| *value = i * i);
/// });
/// assert_eq!(squares, [4, 9, 16]);
/// ```
pub fn filled<T: Clone>(range: Range<u32>, empty: T, fill: impl FnOnce(u32, &mut [T])) -> Vec<T> {
    let mut values = vec![empty; range.len()];
    fill(range.start, &mut values);
    values
}
