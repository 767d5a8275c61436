//! GeoJSON (RFC 7946) and TopoJSON: `Polygon`, `MultiPolygon`, and what holds them.
//!
//! Lines and points are those inside. Names are `properties.name`, else `id`, or a property that is chosen. Longitude
//! and latitude are taken as planar coordinates; heights are left out.
//!
//! The crate `geojson` tells what is wrong, but not in which feature or ring.

mod reader;
mod topology;

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::Value;
use serde_json::error::Category;

use self::reader::{Path, Reader};
use super::outline::Outlines;
use super::selection::Selection;
use super::text::{at_line, text_of};
use crate::error::OutlineError;

/// Reads a GeoJSON or TopoJSON text.
///
/// # Errors
///
/// Text that is not JSON (with its line), and objects that are not valid GeoJSON or TopoJSON (with their
/// path); a layer or a property that the file does not have.
pub(super) fn read(bytes: &[u8], selection: &Selection) -> Result<Outlines, OutlineError> {
    let document: Value = serde_json::from_str(text_of(bytes)?).map_err(|error| {
        let problem = match error.classify() {
            Category::Eof => "the JSON text ends too early; the file is not whole",
            _ if error.to_string().starts_with("number out of range") => "the number is too large",
            _ if error.to_string().starts_with("recursion limit") => {
                "more than 127 objects and lists inside each other"
            }
            _ => "this is not JSON",
        };
        at_line(error.line() as u64, format!("column {}: {problem}", error.column()))
    })?;
    let mut reader = Reader::default();
    reader.name_by = selection.name_by.as_deref();
    if document.get("type").and_then(Value::as_str) == Some("Topology") {
        topology::read(&document, selection.layer.as_deref(), &mut reader)?;
    } else if selection.layer.is_some() {
        let problem =
            "GeoJSON has no layers; a layer is an object of TopoJSON, or a layer of a DXF";
        return Err(Path::Start.error(problem));
    } else {
        reader.object(&document, &Path::Start, None)?;
    }
    reader.end(&document)
}

/// Whether a text is JSON with the type of a GeoJSON or TopoJSON object.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Head<'a> {
        #[serde(rename = "type", borrow)]
        kind: Option<Cow<'a, str>>,
    }
    let head = text_of(bytes).ok().and_then(|text| serde_json::from_str::<Head<'_>>(text).ok());
    let kind = head.and_then(|head| head.kind);
    kind.is_some_and(|kind| TYPES.contains(&&*kind))
}

/// The types of objects, and that of TopoJSON.
const TYPES: [&str; 10] = [
    "Feature",
    "FeatureCollection",
    "GeometryCollection",
    "LineString",
    "MultiLineString",
    "MultiPoint",
    "MultiPolygon",
    "Point",
    "Polygon",
    "Topology",
];

#[cfg(test)]
mod tests {
    use super::super::outline::DrawnRing;
    use super::*;
    use glam::DVec2;

    const RING: &str = "[[0, 0], [4, 0], [0.1, 3], [0, 0]]";

    fn read(text: &str) -> Result<Outlines, String> {
        super::read(text.replace('@', RING).as_bytes(), &Selection::default())
            .map_err(|error| error.to_string())
    }

    #[test]
    fn polygons_are_found_in_everything_that_holds_them() {
        let points = [[0.0, 0.0], [4.0, 0.0], [0.1, 3.0]].map(DVec2::from);
        for (text, names) in [
            (r#"{"type": "Polygon", "coordinates": [@]}"#, &[None][..]),
            (r#"{"type": "MultiPolygon", "coordinates": [[@], [@]]}"#, &[None, None]),
            (
                r#"{"type": "Feature", "id": 7, "geometry": {"type": "Polygon", "coordinates": [@]}}"#,
                &[Some("7")],
            ),
            (
                r#"{"type": "FeatureCollection", "features": [
                    {"type": "Feature", "id": "x", "properties": {"name": "Aland"},
                     "geometry": {"type": "MultiPolygon", "coordinates": [[@], [@]]}},
                    {"type": "Feature", "properties": null, "geometry":
                     {"type": "GeometryCollection", "geometries": [{"type": "Polygon", "coordinates": [@]}]}}
                ]}"#,
                &[Some("Aland"), Some("Aland"), None],
            ),
            ("\u{feff}{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[4,0],[0.1,3]]]}", &[None]),
        ] {
            let outlines = read(text).unwrap();
            let found: Vec<_> = outlines.features.iter().map(|it| it.name.as_deref()).collect();
            assert_eq!(found, names);
            for feature in outlines.features {
                assert_eq!(feature.rings, [DrawnRing::of_points(points)]);
            }
            assert!(outlines.notes.is_empty());
        }
    }

    #[test]
    fn lines_and_points_lie_inside() {
        let square = r#"{"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 8], [0, 8]]]}"#;
        let geojson = format!(
            r#"{{"type": "FeatureCollection", "features": [
                {{"type": "Feature", "geometry": {square}}},
                {{"type": "Feature", "properties": {{"name": "weir"}},
                  "geometry": {{"type": "LineString", "coordinates": [[1, 1], [2, 1], [2, 1], [2, 2]]}}}},
                {{"type": "Feature", "properties": {{"name": "gauges"}},
                  "geometry": {{"type": "MultiPoint", "coordinates": [[5, 5], [6, 5], [5, 5]]}}}},
                {{"type": "Point", "coordinates": []}}]}}"#
        );
        // The same by halves.
        let topojson = r#"{"type": "Topology", "transform": {"scale": [0.5, 0.5], "translate": [1, 1]},
            "arcs": [[[-2, -2], [16, 0], [0, 16], [-16, 0], [0, -16]], [[0, 0], [2, 0], [0, 2]]],
            "objects": {"all": {"type": "GeometryCollection", "geometries": [
                {"type": "Polygon", "arcs": [[0]]},
                {"type": "LineString", "arcs": [1], "properties": {"name": "weir"}},
                {"type": "MultiPoint", "coordinates": [[8, 8], [10, 8]], "properties": {"name": "gauges"}}]}}}"#;
        for text in [&*geojson, topojson] {
            let Outlines { features, inside, .. } = read(text).unwrap();
            assert_eq!(features.len(), 1);
            let ends = inside.lines.iter().map(|line| [line.segment.start, line.segment.end]);
            let at = |x, y| DVec2::new(x, y);
            assert!(
                ends.eq([[at(1.0, 1.0), at(2.0, 1.0)], [at(2.0, 1.0), at(2.0, 2.0)]]),
                "{inside:?}"
            );
            assert!(inside.lines.iter().all(|line| line.side.as_deref() == Some("weir")));
            let points = inside.points.iter().map(|it| (it.at, it.name.as_deref()));
            assert!(
                points.eq([at(5.0, 5.0), at(6.0, 5.0)].map(|at| (at, Some("gauges")))),
                "{inside:?}"
            );
        }
    }

    #[test]
    fn what_is_left_out_is_said() {
        let outlines = read(
            r#"{"type": "GeometryCollection", "geometries": [
                {"type": "Point", "coordinates": [0, 0]}, {"type": "Polygon", "coordinates": []},
                {"type": "Polygon", "coordinates": [[[0, 0, 1], [1, 0, 1], [0, 1, 1]], @]},
                {"type": "Point", "coordinates": [0, 0]}]}"#,
        );
        let outlines = outlines.unwrap();
        assert_eq!(
            outlines.notes,
            ["left out 1 empty polygon", "left out the heights of positions"]
        );
        assert_eq!(outlines.features[0].rings.len(), 2);
    }

    #[test]
    fn errors_say_where_and_what() {
        for (text, message) in [
            ("", "line 1: column 0: the JSON text ends too early; the file is not whole"),
            ("[1e999]", "line 1: column 6: the number is too large"),
            (
                &"[".repeat(200),
                "line 1: column 128: more than 127 objects and lists inside each other",
            ),
            ("{\n\"type\":}", "line 2: column 8: this is not JSON"),
            ("3", "found the number 3, expected a GeoJSON object"),
            (r#"{"type": "Polygon"}"#, "\"coordinates\" is missing"),
            (
                r#"{"type": "Polygon", "coordinates": [[[0, 0], [1, "a"]]]}"#,
                "coordinates[0][1]: found the text \"a\" in a position, expected a number",
            ),
            (
                r#"{"type": "Polygon", "coordinates": [[[0, 0], [1]]]}"#,
                "coordinates[0][1]: a position needs two numbers, such as [4.5, 52.1]",
            ),
            (
                r#"{"type": "Polygon", "coordinates": [[]]}"#,
                "coordinates[0]: the ring has no positions; drop it",
            ),
            (
                r#"{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {"type": "Ring"}}]}"#,
                "features[0].geometry: the type \"Ring\" is none of GeoJSON; expected \"FeatureCollection\", \"Feature\", \"Polygon\" or \"MultiPolygon\"",
            ),
            (r#"{"type": "Topology", "arcs": []}"#, "\"objects\" is missing"),
            (
                r#"{"type": "LineString", "coordinates": []}"#,
                "no Polygon or MultiPolygon; the collection is empty",
            ),
            (
                r#"{"type": "FeatureCollection", "features": []}"#,
                "no Polygon or MultiPolygon; the collection is empty",
            ),
        ] {
            assert_eq!(read(text).unwrap_err(), message, "{text}");
        }
    }
}
