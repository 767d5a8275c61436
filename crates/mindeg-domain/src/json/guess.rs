//! Guesses what a file is if it is not a domain: the likely mistakes of people who have a mesh or
//! an outline in another format.
//!
//! Limits: guesses from the first lines and keys; use it for a message only.

use serde_json::Value;

use super::error::DomainJsonError;

/// Guesses the format of a text that is not JSON.
pub(super) fn of_text(text: &str) -> Option<&'static str> {
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
    if text.trim_start().starts_with("# vtk") {
        return Some("a VTK mesh");
    }
    let first = first?;
    let starts = [
        ("$MeshFormat", "a Gmsh mesh (.msh)"),
        ("Point(", "a Gmsh geometry (.geo)"),
        ("SetFactory", "a Gmsh geometry (.geo)"),
        ("glTF", "a glTF mesh (.glb)"),
        ("ply", "a PLY mesh"),
        ("OFF", "an OFF mesh"),
        ("solid ", "an STL mesh"),
        ("<svg", "an SVG drawing"),
        ("<", "XML, such as a VTU mesh or an SVG drawing"),
        ("POLYGON", "WKT"),
        ("MULTIPOLYGON", "WKT"),
        ("LINESTRING", "WKT"),
    ];
    if let Some((_, format)) = starts.iter().find(|(start, _)| first.starts_with(start)) {
        return Some(format);
    }
    // Comments and names may come first in an OBJ.
    let of_obj =
        |line: &str| ["v ", "f ", "mtllib ", "o ", "g "].iter().any(|s| line.starts_with(s));
    if of_obj(first) {
        return Some("an OBJ mesh (mindeg inspect reads meshes)");
    }
    let fields: Vec<&str> =
        first.split([',', ';', '\t', ' ']).filter(|field| !field.is_empty()).collect();
    let are_numbers = fields.iter().all(|field| field.parse::<f64>().is_ok());
    let is_head = ["x,y", "x;y", "x\ty", "X,Y"].iter().any(|head| first.starts_with(head));
    ((fields.len() > 1 && are_numbers) || is_head)
        .then_some("a list of points (CSV); they go into \"polygon\": {\"corners\": [[x, y], …]}")
}

/// The same error, or a guess at the format if the text is JSON for something else.
pub(super) fn explained(text: &str, error: DomainJsonError) -> DomainJsonError {
    const DOMAIN: &str = "a domain is an object with \"rectangle\", \"polygon\" or \"ring\", and \
                          \"sides\" or \"size\"";
    let json = serde_json::from_str(text.strip_prefix('\u{feff}').unwrap_or(text));
    let message = match json {
        Ok(Value::Array(_)) => Some(format!(
            "found a list; {DOMAIN}; the corners of a polygon go into \"polygon\": {{\"corners\": \
             [[x, y], …]}}"
        )),
        Ok(Value::Object(keys)) => {
            let kind = keys.get("type").and_then(Value::as_str);
            let format = of_keys(keys.keys().map(String::as_str), kind);
            format.map(|format| format!("this looks like {format}; {DOMAIN}"))
        }
        _ => None,
    };
    match message {
        Some(message) => {
            DomainJsonError { path: String::new(), line: 1, column: 1, message, more: Vec::new() }
        }
        None => error,
    }
}

/// Guesses the format of a JSON object with these keys and this text under `type`.
fn of_keys<'k>(
    mut keys: impl Iterator<Item = &'k str>,
    kind: Option<&str>,
) -> Option<&'static str> {
    let geometries = ["FeatureCollection", "Feature", "GeometryCollection"];
    let shapes = ["Point", "LineString", "Polygon"];
    let is_geo_json = |kind: &str| {
        geometries.contains(&kind) || shapes.contains(&kind.trim_start_matches("Multi"))
    };
    if kind.is_some_and(is_geo_json) {
        return Some("GeoJSON");
    }
    keys.any(|key| key == "asset").then_some("a glTF mesh (mindeg inspect reads meshes)")
}
