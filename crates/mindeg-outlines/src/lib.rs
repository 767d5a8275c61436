//! Outlines in files: what to mesh, drawn by other programs.
//!
//! [`read`] gives the polygons of a file, with their holes, names and curves;
//! [`Outlines::repaired`] parts rings that touch themselves; [`Feature::domain`] divides the rings
//! into sides and points, as a domain.
//!
//! ```
//! use mindeg_outlines::{Division, OutlineFormat, read};
//!
//! let svg = b"<svg><circle cx='5' cy='5' r='2'/></svg>";
//! let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
//! let outlines = read(svg, OutlineFormat::Svg, alone)?;
//! let domain = outlines.features[0].domain(&Division { size: Some(0.5), ..Division::default() })?;
//! assert_eq!(domain.rings().vertex_count(), 25);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! In a file with several polygons, [`labelled`] gives each a name of its own, and [`chosen`] takes the ones
//! that somebody names.
//!
//! Readers take the bytes of a whole file and use memory in proportion to them. A malformed file is
//! an error that says what is wrong and where, never a panic. Paths are the caller's. The same file
//! gives the same points on every machine.
//!
//! To read a further format, add a module with a function `read`, a variant of [`OutlineFormat`],
//! and the first lines that tell it.

mod antimeridian;
mod choice;
mod crs;
mod csv;
mod curve;
mod domain;
mod dxf;
mod error;
mod faces;
mod format;
mod geojson;
mod globe;
mod kinds;
mod loops;
mod map;
mod mesh_lines;
mod nesting;
mod noding;
mod outline;
mod overlay;
mod periodic;
mod poly;
mod repair;
mod sea;
mod selection;
mod sides;
mod svg;
mod text;
mod vertices;
mod wkt;

pub use choice::{Listed, Polygon, chosen, labelled};
pub use curve::{EllipseArc, PieceCurve, Segment};
pub use error::OutlineError;
pub use format::{OutlineFormat, read, read_selected};
pub use globe::ProjectionChoice;
pub use kinds::with_kinds;
pub use map::maps;
pub use outline::{DrawnInside, DrawnRing, Feature, FillRule, Outlines, Piece, SideKinds};
pub use periodic::{PeriodicCurve, with_periodic_sides};
pub use sea::is_eastward;
pub use selection::Selection;
pub use sides::{DividedSide, Division};
