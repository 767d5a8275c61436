//! Triangle meshes in and out of files.
//!
//! Each format of surfaces, solvers, arrays, maps or pictures is a module with reader and writer side by side.
//! [`Format`] lists them; [`read()`] and [`Writer`] choose among them. Every reader gives a
//! [`TriMesh`](mindeg_mesh::TriMesh), every writer takes any [`Mesh`](mindeg_mesh::Mesh), so each mesh that
//! is read can be written in any format.
//!
//! ```
//! use mindeg_formats::{SurfaceOptions, glb, obj};
//!
//! let file = "o roof\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4\n";
//! let mesh = obj::read(file.as_bytes())?;
//! let mut binary = Vec::new();
//! glb::write(&mesh, &SurfaceOptions::default(), &mut binary)?;
//! assert!(binary.starts_with(b"glTF"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Writers take an [`std::io::Write`] and stream: they ask the mesh for one block at a time, so
//! memory does not grow with a mesh that is a formula, and they need no buffering around
//! them. The bytes depend on the mesh and the options alone. Writers never compute connectivity.
//! Readers take an [`std::io::Read`] or [`std::io::BufRead`]. A malformed file is an error that says
//! what is wrong and where, never a panic. Files, paths and their replacement are the caller's.

mod boundary;
mod bytes;
mod corners;
mod decimals;
pub mod degree_color;
mod detect;
mod dropped;
mod error;
mod face_list;
mod facts;
mod field;
mod format;
pub mod fort14;
mod geojson;
pub mod gltf;
mod grid;
pub mod inp;
mod lines;
mod lists;
mod materials;
pub mod msh;
mod names;
mod netcdf;
pub mod npz;
mod numbered;
mod numbers;
pub mod obj;
pub mod off;
mod options;
pub mod ply;
pub mod png;
mod raster;
mod read;
mod records;
mod runs;
mod scanner;
mod sections;
pub mod slf;
pub mod sms2dm;
pub mod stl;
pub mod su2;
pub mod svg;
mod tables;
pub mod triangle;
mod ugrid;
mod unfold;
pub mod vtk;
pub mod vtu;
mod words;
mod write;

pub use self::gltf::glb;
pub use boundary::with_boundary_lines;
pub use error::{ReadError, WriteError};
pub use field::Field;
pub use format::{Format, extensions};
pub use names::one_line;
pub use options::{Encoding, MeshPlane, MshVersion, SurfaceOptions, WriteOptions};
pub use raster::Raster;
pub use read::{read, read_as};
pub use runs::{PlaneSurface, Polylines};
pub use write::{Writer, write};

/// The program and its version, as files name their maker.
const GENERATOR: &str = concat!("mindeg ", env!("CARGO_PKG_VERSION"));

/// How a mesh was made, as files say it.
fn made_by(mesh: &dyn mindeg_mesh::Mesh) -> &str {
    mesh.made_by().unwrap_or(GENERATOR)
}

/// The name of a mesh in a file: its own, or that of its groups if they are one object.
fn mesh_name(mesh: &dyn mindeg_mesh::Mesh) -> &str {
    let groups = mesh.groups();
    let is_one = groups.windows(2).all(|pair| materials::is_same_object(&pair[0], &pair[1]));
    let group = groups.first().filter(|group| is_one && !group.name.is_empty());
    let own = mesh.name().filter(|name| !name.is_empty());
    own.or(group.map(|group| &*group.name)).unwrap_or("mesh")
}
