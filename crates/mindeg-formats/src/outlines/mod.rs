//! Outlines in files: what to mesh, drawn by other programs.
//!
//! [`read`] gives the polygons of a file, with holes, names and curves.
mod csv;
mod curve;
mod dxf;
mod geojson;
mod loops;
mod msh;
mod nesting;
mod obj_lines;
mod outline;
mod plane;
mod poly;
mod svg;
mod text;
mod wkt;
pub use curve::{Arc, Curve, Segment};
pub use outline::{Feature, Outlines, Piece, Ring};
/// t
pub fn t(b: &[u8]) {
    let _ = (
        csv::read(b),
        geojson::read(b),
        msh::read(b),
        obj_lines::read(b),
        poly::read(b),
        dxf::read(b),
        svg::read(b),
        wkt::read(b),
        wkt::begins(""),
    );
}
