//! The formats of outlines, and which of them a file has.

use std::io;
use std::path::Path;

use mindeg_formats::Format;

use super::outline::Outlines;
use super::selection::Selection;
use super::{csv, dxf, geojson, mesh_lines, poly, svg, wkt};
use crate::error::OutlineError;

/// A format that holds outlines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutlineFormat {
    /// GeoJSON.
    GeoJson,
    /// Well-known text.
    Wkt,
    /// Scalable Vector Graphics.
    Svg,
    /// Points as text.
    Csv,
    /// Wavefront OBJ with lines.
    Obj,
    /// Gmsh's MSH with line elements.
    Msh,
    /// Triangle's .poly.
    Poly,
    /// AutoCAD's DXF.
    Dxf,
}

use OutlineFormat::{Csv, Dxf, GeoJson, Msh, Obj, Poly, Svg, Wkt};

impl OutlineFormat {
    /// All of them.
    pub const ALL: [Self; 8] = [GeoJson, Wkt, Svg, Csv, Obj, Msh, Poly, Dxf];

    /// The name in a sentence.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().0
    }

    /// The extensions of the format's files, without dots; the first is the usual one.
    #[must_use]
    pub fn extensions(self) -> &'static [&'static str] {
        self.facts().1
    }

    fn facts(self) -> (&'static str, &'static [&'static str]) {
        match self {
            GeoJson => ("GeoJSON", &["geojson", "topojson"]),
            Wkt => ("WKT", &["wkt"]),
            Svg => ("SVG", &["svg"]),
            Csv => ("a list of points", &["csv", "tsv", "xy", "txt", "dat"]),
            Obj => ("OBJ", &["obj"]),
            Msh => ("Gmsh's MSH", &["msh"]),
            Poly => ("Triangle's .poly", &["poly"]),
            Dxf => ("DXF", &["dxf"]),
        }
    }

    /// The format that the extension of a file tells, in upper or lower case.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_outlines::OutlineFormat;
    ///
    /// assert_eq!(OutlineFormat::of_path("Icon.SVG".as_ref()), Some(OutlineFormat::Svg));
    /// assert_eq!(OutlineFormat::of_path("domain.json".as_ref()), None);
    /// ```
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| format.extensions().contains(&&*extension))
    }

    /// The format that the first lines of a file look like. JSON counts as GeoJSON if its `type`
    /// says so.
    #[must_use]
    pub fn of_content(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"AutoCAD Binary DXF") {
            return Some(Dxf);
        }
        const LOOKED_AT: usize = 1 << 16;
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(LOOKED_AT)]);
        let start = start.trim_start_matches('\u{feff}').trim_start();
        let mut lines = start.lines().map(str::trim);
        let mut rows = lines.clone().filter(|line| !line.is_empty() && !line.starts_with('#'));
        let first = rows.next()?;
        if first.starts_with('{') {
            return geojson::is_one(bytes).then_some(GeoJson);
        }
        if first.starts_with('<') {
            return start.contains("<svg").then_some(Svg);
        }
        if first.starts_with('$') {
            return Some(Msh);
        }
        if wkt::begins(first) {
            return Some(Wkt);
        }
        let is_dxf = lines.next().is_some_and(|code| code == "0" || code == "999")
            && lines.clone().take(200).any(|line| line == "SECTION");
        if is_dxf {
            return Some(Dxf);
        }
        let is_obj = |line: &str| {
            let keyword = line.split_whitespace().next().unwrap_or_default();
            matches!(keyword, "v" | "vn" | "vt" | "mtllib" | "o" | "g" | "f" | "l" | "s")
        };
        if is_obj(first) {
            return Some(Obj);
        }
        if Format::of_all(first.as_bytes()) == Some(Format::Node) {
            return Some(Poly);
        }
        csv::begins([first].into_iter().chain(rows.take(1))).then_some(Csv)
    }
}

/// Reads the outlines of a file whose content is of a format.
///
/// Memory is proportional to the length of the file. The whole text is given at once. `beside` gives the
/// bytes of the file of the same name with another extension: a .poly may have its vertices in a .node.
///
/// # Errors
///
/// Malformed input, with its line or position, and files without closed outlines.
///
/// # Example
///
/// ```
/// use mindeg_outlines::OutlineFormat;
///
/// let text = b"POLYGON((0 0, 4 0, 4 3, 0 3), (1 1, 1 2, 2 2, 2 1))";
/// assert_eq!(OutlineFormat::of_content(text), Some(OutlineFormat::Wkt));
/// let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
/// let outlines = mindeg_outlines::read(text, OutlineFormat::Wkt, alone)?;
/// assert_eq!(outlines.features[0].rings.len(), 2);
///
/// let error = mindeg_outlines::read(b"POLYGON((0 0, 4 x))", OutlineFormat::Wkt, alone).unwrap_err();
/// assert!(error.to_string().starts_with("line 1, column 17: found \"x))\""));
/// # Ok::<(), mindeg_outlines::OutlineError>(())
/// ```
pub fn read(
    bytes: &[u8],
    format: OutlineFormat,
    beside: impl Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<Outlines, OutlineError> {
    read_selected(bytes, format, &Selection::default(), beside)
}

/// [`read`] of a part of a file.
///
/// # Errors
///
/// The errors of [`read`]; a layer or a property that the file does not have, or that its format has not.
pub fn read_selected(
    bytes: &[u8],
    format: OutlineFormat,
    selection: &Selection,
    beside: impl Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<Outlines, OutlineError> {
    let refused = |what: &str, of: &str| {
        let problem = format!("{} has no {what}; {of}", format.name());
        Err(OutlineError::place("", problem))
    };
    let has_layers = matches!(format, GeoJson | Dxf);
    if selection.name_by.is_some() && !has_layers {
        return refused("properties", "polygons are named by those of GeoJSON and TopoJSON");
    }
    if selection.layer.is_some() && !has_layers {
        return refused("layers", "a layer is an object of TopoJSON, or a layer of a DXF");
    }
    match format {
        GeoJson => geojson::read(bytes, selection),
        Wkt => wkt::read(bytes),
        Svg => svg::read(bytes),
        Csv => csv::read(bytes),
        Obj => mesh_lines::read_obj(bytes),
        Msh => mesh_lines::read_msh(bytes),
        Poly => poly::read(bytes, beside),
        Dxf => dxf::read(bytes, selection),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_told_by_their_first_lines() {
        for (text, format) in [
            ("\u{feff} {\"type\": \"Feature\", \"geometry\": null}", Some(GeoJson)),
            ("{\"features\": [], \"type\": \"FeatureCollection\"}", Some(GeoJson)),
            ("{\"type\": \"Topology\"}", Some(GeoJson)),
            ("{\"rectangle\": {\"width\": 4, \"height\": 3}, \"size\": 1}", None),
            ("{\"type\": \"Pol", None),
            ("\n<?xml version='1.0'?>\n<!-- x --><svg/>", Some(Svg)),
            ("<VTKFile/>", None),
            ("$MeshFormat\n4.1 0 8\n", Some(Msh)),
            ("SRID=4326;POLYGON((0 0,1 0,0 1))", Some(Wkt)),
            ("multipolygon (((", Some(Wkt)),
            ("  0\r\nSECTION\r\n  2\r\nHEADER\r\n", Some(Dxf)),
            ("999\nmade by x\n0\nSECTION\n", Some(Dxf)),
            ("AutoCAD Binary DXF\r\n\u{1a}\0", Some(Dxf)),
            ("# Blender\no plate\nv 0 0 0\n", Some(Obj)),
            ("v 0 0 0\nl 1 2\n", Some(Obj)),
            ("# a box\n4 2 0 1\n1 0 0\n", Some(Poly)),
            ("0,0\n1,0\n", Some(Csv)),
            ("x;y\n0;0\n", Some(Csv)),
            ("0 0 0\n1 0 0\n", Some(Csv)),
            ("0\n1\n0\n", None),
            ("5\nSECTION\n", None),
            ("hello\nworld", None),
            ("", None),
        ] {
            assert_eq!(OutlineFormat::of_content(text.as_bytes()), format, "{text:?}");
        }
    }
}
