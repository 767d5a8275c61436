//! Outlines in files: what to mesh, drawn by other programs.
//!
//! [`read`] gives the polygons of a file, with their holes, names and curves.

mod csv;
mod curve;
mod domain;
mod dxf;
mod format;
mod geojson;
mod loops;
mod msh;
mod nesting;
mod obj_lines;
mod outline;
mod plane;
mod poly;
mod repair;
mod sides;
mod svg;
mod text;
mod wkt;

pub use curve::{Arc, Curve, Segment};
pub use domain::FeatureError;
pub use format::{OutlineFormat, format_of, read};
pub use outline::{Feature, Outlines, Piece, Ring};
pub use sides::{DividedSide, Division, SizeTooSmall};
