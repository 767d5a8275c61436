//! Writing a mesh to files that other programs open.
//!
//! [`obj`] and [`gltf`] write the surface, [`svg`] a picture of it. Every writer takes an
//! [`std::io::Write`] and streams: points, degrees and triangles are asked of the
//! [`Mesh`](crate::Mesh) one block at a time, so memory does not grow with the mesh, and
//! writers need no buffering around them. The bytes depend on the mesh and the options
//! alone.
//!
//! Connectivity is never touched here. Files, paths and their replacement are the
//! caller's; so is the question which of the formats a file name asks for.
//!
//! What a format cannot hold, and how long a file will be, follows from the domain and is known
//! before there is a mesh: [`gltf::Glb`], [`gltf::Gltf`], [`obj::estimated_len`],
//! [`svg::check_size`].

pub mod degree_color;
pub mod gltf;
pub mod obj;
mod sections;
pub mod svg;

use crate::{Bounds, Domain};
use glam::{DVec2, DVec3};
use mindeg_core::Boundary;
use std::io;
use thiserror::Error;

/// Why a mesh could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The writer failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A `.glb` gives its own length as a 32-bit number.
    #[error(
        "a .glb holds 4 GiB at most, and this mesh would take at least {bytes} bytes; write a \
         .gltf with its .bin or an OBJ, which may be larger, or use fewer intervals"
    )]
    TooLargeForGlb {
        /// The length of the file, or a lower bound of it.
        bytes: u64,
    },
    /// A coordinate beyond the range of 32-bit floats.
    #[error(
        "vertex {vertex} (counted from 0) at ({}, {}) is beyond the range of glTF's 32-bit \
         floats; scale the domain down, or write OBJ", .point.x, .point.y
    )]
    OutOfRange {
        /// The vertex.
        vertex: u32,
        /// Where it is.
        point: DVec2,
    },
    /// Two vertices that are one point in 32-bit floats.
    #[error(
        "vertices {} and {} (counted from 0) at ({}, {}) are too close together for glTF's \
         32-bit floats to tell them apart; use fewer intervals there, or write OBJ, which keeps \
         every digit", .vertices[0], .vertices[1], .point.x, .point.y
    )]
    Coincident {
        /// The vertices, in the order of the boundary.
        vertices: [u32; 2],
        /// Where the second is.
        point: DVec2,
    },
    /// A mesh with more vertices than a picture can show.
    #[error(
        "an SVG shows {limit} vertices at most, and this mesh has {vertices}; write OBJ or glTF, \
         or use fewer intervals"
    )]
    TooLargeForSvg {
        /// How many the mesh has.
        vertices: u32,
        /// The most an SVG shows.
        limit: u32,
    },
}

/// What a surface file ([`obj`], [`gltf`]) holds besides points and triangles, and how it lies.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{Plane, SurfaceOptions};
///
/// let options = SurfaceOptions { boundary_lines: true, ..SurfaceOptions::default() };
/// assert!(options.normals && options.texture_coordinates && !options.degree_colors);
/// assert_eq!(options.plane, Plane::Xy);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceOptions {
    /// A unit normal for every vertex. On by default: some viewers show nothing useful without.
    pub normals: bool,
    /// Texture coordinates for every vertex: its position in the bounding box, so that an
    /// image laid over the box is neither turned nor mirrored. On by default.
    pub texture_coordinates: bool,
    /// A color for every vertex, by its degree ([`degree_color`]). Off by default: some OBJ
    /// readers reject vertex colors.
    pub degree_colors: bool,
    /// The boundary as line segments, one object for each side, named after it. Off by
    /// default: some readers take the lines of a glTF for degenerate triangles, and MeshLab
    /// 2025.7 can crash on them.
    pub boundary_lines: bool,
    /// The plane the mesh lies in.
    pub plane: Plane,
}

impl Default for SurfaceOptions {
    fn default() -> Self {
        Self {
            normals: true,
            texture_coordinates: true,
            degree_colors: false,
            boundary_lines: false,
            plane: Plane::Xy,
        }
    }
}

/// The plane of space a mesh is put into. Triangles stay counter-clockwise seen from where
/// the normal points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// `(x, y)` becomes `(x, y, 0)`, the normal is `+Z`: facing the viewer in programs where
    /// `+Y` is up, as it is in glTF.
    #[default]
    Xy,
    /// `(x, y)` becomes `(x, 0, -y)`, the normal is `+Y`: lying on the floor in programs
    /// where `+Y` is up. Programs with `+Z` up turn it into their XY plane as they read it.
    Floor,
}

impl Plane {
    /// Where a point of the mesh lies in space. No coordinate is a negative zero.
    fn place(self, point: DVec2) -> DVec3 {
        // Adding zero turns -0 into 0.
        let placed = match self {
            Self::Xy => DVec3::new(point.x, point.y, 0.0),
            Self::Floor => DVec3::new(point.x, 0.0, -point.y),
        };
        placed + DVec3::ZERO
    }

    fn normal(self) -> DVec3 {
        match self {
            Self::Xy => DVec3::Z,
            Self::Floor => DVec3::Y,
        }
    }
}

/// The program and its version, as files name their maker.
const GENERATOR: &str = concat!("mindeg ", env!("CARGO_PKG_VERSION"));

/// The position of `point` in the box, each coordinate in 0 to 1 from the lower left.
fn in_box(bounds: Bounds, point: DVec2) -> DVec2 {
    // Rounding can put a point a little beyond the corners.
    ((point - bounds.min) / bounds.size()).clamp(DVec2::ZERO, DVec2::ONE)
}

/// The name of a mesh, as its domain has it.
fn mesh_name(domain: &Domain) -> &str {
    domain.name().unwrap_or("mesh")
}

/// The name of a side, counted from 0; one without a name is called by its number from 1.
fn side_name(domain: &Domain, side: usize) -> String {
    match &domain.sides()[side].name {
        Some(name) => name.clone(),
        None => format!("side {}", side + 1),
    }
}

/// The boundary edge from a vertex to the next.
fn boundary_edge(boundary: &Boundary, start: u32) -> [u32; 2] {
    let end = start + 1;
    [start, if end == boundary.vertex_count() { 0 } else { end }]
}
