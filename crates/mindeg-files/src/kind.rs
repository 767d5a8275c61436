//! The kind of a file: JSON, outlines or a mesh.
//!
//! The formats themselves tell what their files look like; this is the one place that decides between
//! them, by the name, the content and what is wanted.

use crate::error::extension;
use crate::foreign;
use mindeg_formats::Format;
use mindeg_outlines::OutlineFormat;
use std::path::Path;

/// The content that a caller wants. A file of lines is an outline to whom a domain is wanted; one of
/// faces is a model or a mesh to others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// A domain, or polygons that become domains.
    Domain,
    /// That, or a model: JSON with faces, a glTF, or an OBJ with faces.
    Model,
    /// A domain, polygons, a model in JSON, or a mesh to look at.
    Mesh,
}

/// The kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Json,
    Outlines(OutlineFormat),
    Mesh(Format),
    /// Outlines, unless there is a mesh in the file or beside it.
    MeshOrOutlines(Format, OutlineFormat),
}

/// Whether a name is that of a mesh that is read.
#[must_use]
pub fn is_mesh_name(path: &Path) -> bool {
    Format::of_path(path).is_some_and(|format| Format::READ.contains(&format))
}

/// Whether a name is that of a domain: JSON, or an outline in a format that has no meshes.
#[must_use]
pub fn is_domain_name(path: &Path) -> bool {
    extension(path) == "json" || OutlineFormat::of_path(path).is_some() && !is_mesh_name(path)
}

/// The format of meshes that a name tells, where it does not stand for outlines, too.
pub(crate) fn mesh_format(path: &Path) -> Option<Format> {
    if OutlineFormat::of_path(path).is_some() { None } else { Format::of_path(path) }
}

/// The message for a mesh where a domain is wanted.
pub(crate) fn no_mesh(file: &str) -> String {
    format!(
        "it is a mesh, and a domain is expected; of a mesh in the plane, `mindeg convert {file} -o \
         outline.poly` writes the boundary, which is a domain"
    )
}

/// The message for a domain where a mesh is wanted.
pub(crate) fn no_domain(file: &str) -> String {
    format!("it is a domain, and a mesh is expected; `mindeg mesh {file} -o mesh.vtu` makes one")
}

/// The kind of a file. The extension tells, if the content does not look like another format; without a
/// known extension the content does. Where neither tells, it counts as JSON, whose reader says best
/// what is wrong.
pub(crate) fn kind(
    path: Option<&Path>,
    bytes: &[u8],
    wanted: Wanted,
    name: &str,
) -> Result<Kind, String> {
    let told = path.and_then(OutlineFormat::of_path);
    let looks_like = OutlineFormat::of_content(bytes);
    let has_brace = bytes.trim_ascii_start().starts_with(b"{");
    let extension = path.map(extension).unwrap_or_default();
    // A script may have any name, that of a table of points, too.
    let may_be_script = matches!(told, None | Some(OutlineFormat::Csv));
    if may_be_script
        && foreign::is_gmsh_script(bytes)
        && let Some(advice) = foreign::advice("geo", name)
    {
        return Err(advice);
    }
    if told.is_none() && looks_like.is_none() && !has_brace {
        // An NPZ is one, too, and is never called so.
        if extension == "zip"
            && let Some(advice) = foreign::advice(&extension, name)
        {
            return Err(advice);
        }
        if let Some(format) = Format::of_content(bytes) {
            return match wanted {
                Wanted::Domain => Err(no_mesh(name)),
                Wanted::Model | Wanted::Mesh => Ok(Kind::Mesh(format)),
            };
        }
        let foreign = foreign::extension_of(bytes).unwrap_or(&extension);
        if let Some(advice) = foreign::advice(foreign, name) {
            return Err(advice);
        }
    }
    let lie = |ends: &str, looks: &str, right: &str| {
        Err(format!(
            "the name ends {ends}, and the content {looks}; rename the file to end in .{right}"
        ))
    };
    let format = match (told, looks_like) {
        (None, Some(format)) if extension == "json" && format != OutlineFormat::GeoJson => {
            let looks = format!("looks like {}", format.name());
            return lie("in .json", &looks, format.extensions()[0]);
        }
        (Some(told), None) if has_brace && told != OutlineFormat::GeoJson => {
            return lie(&format!("as {} does", told.name()), "is JSON", "json");
        }
        // Tables of points have many names.
        (None | Some(OutlineFormat::Csv), Some(format)) | (Some(format), None) => format,
        (Some(told), Some(looks)) if told != looks => {
            let looks_like = format!("looks like {}", looks.name());
            return lie(&format!("as {} does", told.name()), &looks_like, looks.extensions()[0]);
        }
        (Some(format), Some(_)) => format,
        (None, None) => return Ok(Kind::Json),
    };
    let mesh = match format {
        OutlineFormat::Obj => Format::Obj,
        OutlineFormat::Msh => Format::Msh,
        OutlineFormat::Poly => Format::Node,
        _ => return Ok(Kind::Outlines(format)),
    };
    Ok(match wanted {
        Wanted::Model | Wanted::Mesh if mesh == Format::Obj && has_faces(bytes) => Kind::Mesh(mesh),
        Wanted::Mesh if mesh != Format::Obj => Kind::MeshOrOutlines(mesh, format),
        _ => Kind::Outlines(format),
    })
}

/// Whether an OBJ has a face.
pub(crate) fn has_faces(bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|&byte| byte == b'\n' || byte == b'\r');
    lines.any(|line| line.starts_with(b"f ") || line.starts_with(b"f\t"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use OutlineFormat::{Csv, GeoJson, Svg, Wkt};

    fn told(path: Option<&str>, text: &str) -> Result<Kind, String> {
        kind(path.map(Path::new), text.as_bytes(), Wanted::Domain, "FILE")
    }

    #[test]
    fn name_and_content_tell_what_a_file_is() {
        for (path, text, expected) in [
            (Some("a.WKT"), "POLYGON((0 0", Kind::Outlines(Wkt)),
            (Some("a.svg"), "half a file", Kind::Outlines(Svg)),
            (Some("a.txt"), "POLYGON((0 0", Kind::Outlines(Wkt)),
            (Some("a.json"), "{\"type\": \"Feature\"}", Kind::Outlines(GeoJson)),
            (None, "0 0\n1 1", Kind::Outlines(Csv)),
            (Some("a.json"), "{\"size\": 1}", Kind::Json),
            (Some("a.html"), "{\"size\": 1}", Kind::Json),
            (Some("a.bin"), "hello", Kind::Json),
            // A key of glTF as a name makes no mesh of a domain.
            (Some("a.json"), "{\"name\": \"asset\"}", Kind::Json),
        ] {
            assert_eq!(told(path, text), Ok(expected), "{path:?} {text:?}");
        }
    }

    #[test]
    fn a_lie_is_named_on_both_sides() {
        for (path, text, message) in [
            (
                "a.svg",
                "POLYGON((0 0",
                "the name ends as SVG does, and the content looks like WKT; rename the file to end in .wkt",
            ),
            (
                "a.json",
                "POLYGON((0 0",
                "the name ends in .json, and the content looks like WKT; rename the file to end in .wkt",
            ),
            (
                "a.wkt",
                "{\"size\": 1}",
                "the name ends as WKT does, and the content is JSON; rename the file to end in .json",
            ),
        ] {
            assert_eq!(told(Some(path), text).unwrap_err(), message);
        }
    }

    #[test]
    fn files_of_other_programs_are_named_with_a_way_in() {
        for (path, text, words) in [
            ("coast.shp", "\0\0\x27\x0a\0", "ogr2ogr outline.geojson FILE"),
            ("coast.parquet", "PAR1\x15\x04", "ogr2ogr outline.geojson FILE"),
            ("coast", "fgb\x03fgb\0", "ogr2ogr outline.geojson FILE"),
            ("x.geo", "lc = 1;\nPoint(1) = {0, 0, 0};", "gmsh -1 FILE -o outline.msh"),
            ("x.geo", "Point(1) = {0, 0, 0};", "gmsh -1 FILE -o outline.msh"),
            ("geo.txt2", "SetFactory(\"OpenCASCADE\");", "gmsh -1 FILE"),
            ("x.txt", "// a part\n\nlc = 0.1;\nPoint(1) = {0, 0, 0, lc};", "gmsh -1 FILE"),
            ("x.txt", "Point (1) = {0, 0, 0};", "gmsh -1 FILE"),
            ("part.step", "ISO-10303-21;\nHEADER;", "gmsh -2 FILE -o part.msh"),
            ("part.bin", "ply\nformat ascii 1.0\n", "it is a mesh, and a domain is expected"),
        ] {
            let error = told(Some(path), text).unwrap_err();
            assert!(error.contains(words), "{path}: {error}");
        }
    }

    #[test]
    fn wkt_with_points_is_no_script() {
        for text in [
            "SRID=4326;GeometryCollection(Polygon((0 0, 1 0, 0 1, 0 0)), Point(0.1 0.1))",
            "Point (0 0)",
        ] {
            assert_eq!(told(Some("x.txt"), text), Ok(Kind::Outlines(OutlineFormat::Wkt)));
        }
    }

    #[test]
    fn what_is_wanted_decides_between_outlines_and_meshes() {
        let of = |path: &str, text: &str, wanted| {
            kind(Some(Path::new(path)), text.as_bytes(), wanted, "FILE").unwrap()
        };
        let (lines, faces) = ("v 0 0 0\nl 1 2\n", "v 0 0 0\nf 1 2 3\n");
        let outline = Kind::Outlines(OutlineFormat::Obj);
        for (text, wanted, expected) in [
            (faces, Wanted::Domain, outline),
            (faces, Wanted::Model, Kind::Mesh(Format::Obj)),
            (faces, Wanted::Mesh, Kind::Mesh(Format::Obj)),
            (lines, Wanted::Model, outline),
            (lines, Wanted::Mesh, outline),
        ] {
            assert_eq!(of("a.obj", text, wanted), expected, "{text:?} {wanted:?}");
        }
        let msh = "$MeshFormat\n4.1 0 8\n";
        assert_eq!(of("a.msh", msh, Wanted::Model), Kind::Outlines(OutlineFormat::Msh));
        let both = Kind::MeshOrOutlines(Format::Msh, OutlineFormat::Msh);
        assert_eq!(of("a.msh", msh, Wanted::Mesh), both);
    }
}
