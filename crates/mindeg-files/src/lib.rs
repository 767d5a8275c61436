//! The one door for files.
//!
//! A [`Session`] opens files and writes them for one run of a program. [`Session::open`] tells what a
//! file holds: a domain or a model in JSON, polygons of another program, or a mesh. [`Targets`] writes a
//! mesh to files that appear whole or not at all.
//!
//! ```
//! use mindeg_files::{Content, Input, ReadOptions, Session, Wanted};
//! use mindeg_mesh::Progress;
//!
//! let session = Session::new("");
//! let lid = Input::Bytes("lid.svg", b"<svg><circle id='lid' cx='5' cy='5' r='2'/></svg>");
//! let options = ReadOptions::default();
//! let Content::Polygons(polygons) = session.open(&lid, Wanted::Domain, &options, Progress::NONE)?
//! else { unreachable!("an SVG holds polygons") };
//! assert_eq!(polygons.only()?.name(), Some("lid"));
//! # Ok::<(), mindeg_files::FileError>(())
//! ```
//!
//! Files may come from anywhere. A file that another names is read only if it is a regular file in the
//! same folder, also where links lead to it. No output replaces a link, a file that was read, or one
//! that has a second name.

mod beside;
mod error;
mod foreign;
mod input;
mod kind;
mod mesh;
mod open;
mod outputs;
mod polygons;
mod recipe;
mod session;
mod sizes;
mod targets;

// The words of formats that callers need: this crate alone reads and writes files.
pub use mindeg_formats::{
    Encoding, Format, MeshPlane, MshVersion, SurfaceOptions, WriteError, WriteOptions, Writer,
    extensions, obj, svg, with_boundary_lines,
};
pub use mindeg_outlines::{
    Division, FillRule, OutlineFormat, Polygon, ProjectionChoice, Selection, is_eastward,
};

pub use error::{FileError, plainly};
pub use input::Input;
pub use kind::{Wanted, is_domain_name, is_mesh_name};
pub use mesh::READING;
pub use open::Content;
pub use outputs::{Outputs, cannot_write, is_standard_output, write_to};
pub use polygons::{PolygonFile, ReadOptions, look_like_degrees};
pub use recipe::{Ingredient, Recipe};
pub use session::Session;
pub use targets::{Targets, in_degrees};
