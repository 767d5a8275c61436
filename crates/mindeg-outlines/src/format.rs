//! The formats of outlines, and which of them a file has.

use std::io;
use std::path::Path;

use super::outline::Outlines;
use super::{csv, dxf, geojson, msh, obj_lines, poly, svg, wkt};
use crate::error::ReadError;

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

    /// What the format is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            GeoJson => "GeoJSON",
            Wkt => "WKT",
            Svg => "SVG",
            Csv => "a list of points",
            Obj => "OBJ",
            Msh => "Gmsh's MSH",
            Poly => "Triangle's .poly",
            Dxf => "DXF",
        }
    }

    /// The extensions of its files, in lower case.
    #[must_use]
    pub fn extensions(self) -> &'static [&'static str] {
        match self {
            GeoJson => &["geojson"],
            Wkt => &["wkt"],
            Svg => &["svg"],
            Csv => &["csv", "tsv", "xy", "txt", "dat"],
            Obj => &["obj"],
            Msh => &["msh"],
            Poly => &["poly"],
            Dxf => &["dxf"],
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
        if poly::begins(first) {
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
/// What is not as the format has it, with the line or place, and files without closed outlines.
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
/// # Ok::<(), mindeg_outlines::ReadError>(())
/// ```
pub fn read(
    bytes: &[u8],
    format: OutlineFormat,
    beside: impl Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<Outlines, ReadError> {
    match format {
        GeoJson => geojson::read(bytes),
        Wkt => wkt::read(bytes),
        Svg => svg::read(bytes),
        Csv => csv::read(bytes),
        Obj => obj_lines::read(bytes),
        Msh => msh::read(bytes),
        Poly => poly::read(bytes, beside),
        Dxf => dxf::read(bytes),
    }
}

/// The format of the outlines in a file; none if it is, or should be, a domain in JSON.
///
/// The extension tells, if the content does not look like another format; without a known extension
/// the content does. Where neither tells, it counts as JSON, whose reader says best what is wrong.
///
/// # Errors
///
/// An extension and a content that tell different formats; meshes.
pub fn format_of(path: Option<&Path>, bytes: &[u8]) -> Result<Option<OutlineFormat>, ReadError> {
    path.map_or(Ok(()), refuse_mesh)?;
    let is_named_json = path.is_some_and(|path| extension(path) == "json");
    let told = path.and_then(OutlineFormat::of_path);
    let looks_like = OutlineFormat::of_content(bytes);
    let is_json = bytes.trim_ascii_start().starts_with(b"{") && looks_like.is_none();
    match (told, looks_like) {
        (None, Some(format)) if is_named_json && format != GeoJson => Err(wrong_name(format!(
            "it ends in .json, and the content looks like {}; rename the file to end in .{}",
            format.name(),
            format.extensions()[0]
        ))),
        (Some(told), None) if is_json && told != GeoJson => Err(wrong_name(format!(
            "it ends as {} does, and the content is JSON; rename the file to end in .json",
            told.name()
        ))),
        // Tables of points have many names.
        (None | Some(Csv), Some(format)) | (Some(format), None) => Ok(Some(format)),
        (Some(told), Some(looks_like)) if told == looks_like => Ok(Some(told)),
        (Some(told), Some(looks_like)) => Err(wrong_name(format!(
            "it ends as {} does, and the content looks like {}; rename the file to end in .{}",
            told.name(),
            looks_like.name(),
            looks_like.extensions()[0],
        ))),
        (None, None) => Ok(None),
    }
}

/// Refuses a file that is a mesh by its name, which can be done before it is read.
///
/// # Errors
///
/// What to do with a mesh instead.
pub fn refuse_mesh(path: &Path) -> Result<(), ReadError> {
    if MESHES.contains(&&*extension(path)) {
        return Err(wrong_name(
            "it ends as a mesh does, and a domain is expected; of a mesh in the plane, mindeg convert \
             FILE -o outline.poly writes the boundary, which is a domain"
                .to_owned(),
        ));
    }
    Ok(())
}

/// The extension in lower case.
fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}

/// Extensions of meshes, which are no domains.
const MESHES: [&str; 16] = [
    "14", "2dm", "ele", "fbx", "glb", "gltf", "grd", "inp", "node", "npz", "off", "ply", "stl",
    "su2", "vtk", "vtu",
];

fn wrong_name(problem: String) -> ReadError {
    ReadError::place("the name of the file", problem)
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

    #[test]
    fn a_lie_is_named_on_both_sides() {
        let told = |path: Option<&str>, text: &str| {
            format_of(path.map(Path::new), text.as_bytes()).map_err(|error| error.to_string())
        };
        assert_eq!(told(Some("a.WKT"), "POLYGON((0 0"), Ok(Some(Wkt)));
        assert_eq!(told(Some("a.svg"), "half a file"), Ok(Some(Svg)));
        assert_eq!(told(Some("a.txt"), "POLYGON((0 0"), Ok(Some(Wkt)));
        assert_eq!(told(Some("a.json"), "{\"type\": \"Feature\"}"), Ok(Some(GeoJson)));
        assert_eq!(told(None, "0 0\n1 1"), Ok(Some(Csv)));
        assert_eq!(told(Some("a.json"), "{\"size\": 1}"), Ok(None));
        assert_eq!(told(Some("a.bin"), "hello"), Ok(None));
        for (path, text, message) in [
            (
                "a.svg",
                "POLYGON((0 0",
                "it ends as SVG does, and the content looks like WKT; rename the file to end in .wkt",
            ),
            (
                "a.json",
                "POLYGON((0 0",
                "it ends in .json, and the content looks like WKT; rename the file to end in .wkt",
            ),
            (
                "a.wkt",
                "{\"size\": 1}",
                "it ends as WKT does, and the content is JSON; rename the file to end in .json",
            ),
            ("a.14", "grid\n3 3", "it ends as a mesh does, and a domain is expected"),
        ] {
            let error = told(Some(path), text).unwrap_err();
            assert!(error.starts_with(&format!("the name of the file: {message}")), "{error}");
        }
    }
}
