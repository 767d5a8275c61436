//! Options of writers: contents besides points and triangles, the plane, and how numbers are written.

use glam::{DVec2, DVec3};
use mindeg_mesh::Bounds;

/// How a mesh is written, whatever the format; each format takes what it can hold.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Encoding, WriteOptions};
///
/// let options = WriteOptions { encoding: Encoding::Ascii, ..WriteOptions::default() };
/// assert!(options.fields && !options.double);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WriteOptions {
    /// The contents of OBJ and glTF besides points and triangles. PLY takes the degree colors.
    pub surface: SurfaceOptions,
    /// Binary or text, where a format has both.
    pub encoding: Encoding,
    /// The version of MSH.
    pub msh_version: MshVersion,
    /// 64-bit coordinates in a PLY; Gmsh cannot read such a file. Off by default. Other formats
    /// have one precision.
    pub double: bool,
    /// The degree of every vertex, the minimum angle of every triangle and the side of every
    /// boundary edge, where a format has data fields. On by default.
    pub fields: bool,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self {
            surface: SurfaceOptions::default(),
            encoding: Encoding::Binary,
            msh_version: MshVersion::V4,
            double: false,
            fields: true,
        }
    }
}

/// How numbers are written, in formats that have both ways.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Bytes: small, fast and exact.
    #[default]
    Binary,
    /// Text. Decimals are the shortest that read back as the same numbers.
    Ascii,
}

/// A version of Gmsh's MSH.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MshVersion {
    /// 4.1, what Gmsh writes today.
    #[default]
    V4,
    /// 2.2, which more programs read.
    V2,
}

/// The contents of a surface file (OBJ, glTF) besides points and triangles, and its plane.
///
/// # Example
///
/// ```
/// use mindeg_formats::{MeshPlane, SurfaceOptions};
///
/// let options = SurfaceOptions { boundary_lines: true, ..SurfaceOptions::default() };
/// assert!(options.normals && options.texture_coordinates && !options.degree_colors);
/// assert_eq!(options.plane, MeshPlane::Xy);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceOptions {
    /// A unit normal for every vertex. On by default: some viewers show nothing useful without.
    pub normals: bool,
    /// Texture coordinates for every vertex: its position in the bounding box, so that an
    /// image laid over the box is neither turned nor mirrored. On by default.
    pub texture_coordinates: bool,
    /// A color for every vertex, by its degree ([`degree_color`](crate::degree_color)). Off by default: some OBJ
    /// readers reject vertex colors.
    pub degree_colors: bool,
    /// The boundary as line segments, one object for each side, named after it. Off by
    /// default: some readers take the lines of a glTF for degenerate triangles, and MeshLab
    /// 2025.7 can crash on them.
    pub boundary_lines: bool,
    /// The plane the mesh lies in.
    pub plane: MeshPlane,
}

impl Default for SurfaceOptions {
    fn default() -> Self {
        Self {
            normals: true,
            texture_coordinates: true,
            degree_colors: false,
            boundary_lines: false,
            plane: MeshPlane::Xy,
        }
    }
}

/// The plane of space a mesh is put into. Triangles stay counter-clockwise seen from where
/// the normal points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshPlane {
    /// Points stay where they are. A mesh in the plane has the normal `+Z`: it faces the viewer in
    /// programs where `+Y` is up, as it is in glTF.
    #[default]
    Xy,
    /// `(x, y, z)` becomes `(x, z, -y)`. A mesh in the plane has the normal `+Y`: it lies on the
    /// floor in programs where `+Y` is up. Programs with `+Z` up turn it into their XY plane as
    /// they read it.
    Floor,
}

impl MeshPlane {
    /// Where a point of the mesh lies in space. No coordinate is a negative zero.
    pub(crate) fn place(self, point: DVec3) -> DVec3 {
        // Adding zero turns -0 into 0.
        let placed = match self {
            Self::Xy => point,
            Self::Floor => DVec3::new(point.x, point.z, -point.y),
        };
        placed + DVec3::ZERO
    }
}

/// The position of `point` in the box, x and y each in 0 to 1 from the lower left.
pub(crate) fn in_box(bounds: Bounds<DVec3>, point: DVec3) -> DVec2 {
    let Bounds { min, max } = bounds.in_plane();
    // Rounding can put a point a little beyond the corners.
    ((point.truncate() - min) / (max - min)).clamp(DVec2::ZERO, DVec2::ONE)
}
