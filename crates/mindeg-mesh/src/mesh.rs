//! What a triangle mesh is to a writer, a measure or a picture.
//!
//! A mesh has two halves. [`Positions`] tells where the vertices are; a domain knows that before it
//! has a mesh. [`Triangles`] tells which vertices are joined, in which groups, under which names.
//! Both give ranges at a time, so a mesh that is a formula streams through a writer, and a mesh that
//! is a list is copied.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::bounds::Bounds;

/// Where vertices are.
pub trait Positions: Sync {
    /// The number of vertices.
    fn vertex_count(&self) -> u32;

    /// Writes the positions of the vertices from `first` on into `out`, as many as it holds.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    fn fill_positions(&self, first: u32, out: &mut [DVec3]);

    /// The smallest box around all vertices.
    fn bounds(&self) -> Bounds<DVec3>;

    /// Writes the depths of the water at the vertices from `first` on into `out`, as many as it
    /// holds: 0 but for a mesh of a coastal model that has them.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    fn fill_depths(&self, first: u32, out: &mut [f64]) {
        let _ = first;
        out.fill(0.0);
    }

    /// Whether each vertex follows the one before round a boundary, and the first the last: then
    /// no two of them may become one point in a file.
    fn is_ring(&self) -> bool {
        false
    }
}

/// Which vertices are joined to triangles, and what the parts are called.
pub trait Triangles: Sync {
    /// The number of triangles.
    fn triangle_count(&self) -> u32;

    /// Writes the triangles from `first` on into `out`, as many as it holds. Each is
    /// counter-clockwise seen from its front.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` triangles remain from `first` on.
    fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]);

    /// Writes the degrees of the vertices from `first` on into `out`, as many as it holds.
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

    /// What the mesh is called.
    fn name(&self) -> Option<&str> {
        None
    }

    /// The named groups, which hold every triangle once, in order; empty for a mesh in one piece.
    fn groups(&self) -> &[Group] {
        &[]
    }

    /// The named lines of the mesh, such as the sides of its domain, which hold every segment
    /// once, in order.
    fn lines(&self) -> Cow<'_, [Line]> {
        Cow::Borrowed(&[])
    }

    /// What the line with this index is in a coastal model, where that is known.
    fn line_kind(&self, line: usize) -> Option<LineKind> {
        let _ = line;
        None
    }

    /// Writes the segments from `first` on into `out`, as many as it holds. The segments of a line
    /// follow one another.
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
/// what of it has one material; a node of a glTF, or one of its primitives.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name; empty if there is none.
    pub name: String,
    /// The triangles; never empty.
    pub triangles: Range<u32>,
    /// The material, if there is one. Groups may share it.
    pub material: Option<Arc<Material>>,
}

impl Group {
    /// A group without a material.
    #[must_use]
    pub fn new(name: impl Into<String>, triangles: Range<u32>) -> Self {
        Self { name: name.into(), triangles, material: None }
    }

    /// The same group with a material.
    #[must_use]
    pub fn of_material(self, material: Option<Arc<Material>>) -> Self {
        Self { material, ..self }
    }

    /// What to call the group where a file has no materials: its name, or else its material's.
    #[must_use]
    pub fn label(&self) -> &str {
        match &self.material {
            Some(material) if self.name.is_empty() => &material.name,
            _ => &self.name,
        }
    }
}

/// What a surface is made of.
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
    /// Whether each segment is known to start where the one before ends, all on the straight line
    /// between the ends of the line but for rounding.
    pub is_straight: bool,
}

/// What a part of the boundary of a coastal model is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LineKind {
    /// Open water.
    Open,
    /// The shore of the mainland.
    Land,
    /// The shore of an island.
    Island,
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
