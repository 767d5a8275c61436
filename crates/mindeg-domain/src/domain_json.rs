//! Domains as JSON text: what engineers write by hand and keep beside their meshes.
//!
//! Keys that are not the format's are refused, so that a misspelt one is not passed over. Every
//! error says where in the text it is, also those that show only when all of it is read.
//!
//! Limits: JSON has no comments and no infinities. The whole text is held in memory.

use std::fmt;

use glam::DVec2;
use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use crate::constraint::{OutsideDegree, VertexConstraint};
use crate::domain::{Domain, Intervals, Outline, Side};
use crate::domain_error::DomainError;
use crate::domain_json_error::{DomainJsonError, at, path_of};
use crate::json_path::{Step, display, locate};
use crate::rectangle::Rectangle;
use crate::spacing::Spacing;

impl Domain {
    /// Reads a domain from JSON text.
    ///
    /// ```json
    /// {
    ///   "name": "plate",
    ///   "rectangle": {"width": 4, "height": 3, "origin": [0, 0], "rotation": 0},
    ///   "size": 0.5,
    ///   "sides": [
    ///     {"intervals": 12, "name": "bottom"},
    ///     {"size": 0.25, "spacing": {"geometric": {"ratio": 1.2}}},
    ///     {"spacing": {"parameters": [0.25, 0.5, 0.75]}},
    ///     {}
    ///   ]
    /// }
    /// ```
    ///
    /// | key | value |
    /// |---|---|
    /// | `name` | optional: the domain's name |
    /// | `rectangle` | `width`, `height`, and optionally `origin`, the corner where the bottom starts, and `rotation` in degrees about it. Sides run bottom, right, top, left |
    /// | `polygon` | `corners`, a list of `[x, y]` pairs around the polygon; instead of `rectangle` |
    /// | `sides` | one entry for each side, from the first corner on; may be left out where `size` says it all |
    /// | `size` | optional: the target interval length of every side that gives neither `intervals` nor `size` nor `parameters` |
    /// | `vertices` | optional: constraints on single vertices, each `{"vertex": v, "outside_degree": d, "max_degree": D}` with one of the last two or both. Vertices are numbered as in the mesh: from 0 at the first corner, counter-clockwise, also where the corners are given clockwise |
    ///
    /// and in each side, all optional:
    ///
    /// | key | value |
    /// |---|---|
    /// | `intervals` | a whole number, at least 1 |
    /// | `size` | instead: a target length, above 0, that the side's length is divided by |
    /// | `spacing` | `"uniform"`, `{"geometric": {"ratio": r}}`, `{"bump": {"ratio": c}}`, `{"beta": {"beta": b}}`, `{"first_length": h}`, `{"last_length": h}` or `{"parameters": [t1, …]}`; see [`Spacing`] |
    /// | `name` | the side's name; no two sides may have the same |
    /// | `outside_degree` | how many edges its vertices have on the other side of the boundary, the boundary's own not among them: one number for all vertices that are not corners, or a list of one for each from the side's first corner to its last |
    /// | `max_degree` | the most edges any of its vertices may have, corners and edges outside included |
    ///
    /// What is said of one vertex in several places counts together: edges outside add up, and of
    /// caps the smallest holds.
    ///
    /// # Errors
    ///
    /// Text that is no JSON, keys or values that are not the format's, and whatever
    /// [`Domain::new`] refuses; each with its path, line and column.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Domain;
    ///
    /// let domain = Domain::from_json(
    ///     r#"{
    ///         "rectangle": {"width": 4, "height": 3},
    ///         "sides": [
    ///             {"intervals": 3, "spacing": {"geometric": {"ratio": 1.2}}, "name": "bottom"},
    ///             {"size": 0.5}, {"intervals": 3}, {"intervals": 2}
    ///         ]
    ///     }"#,
    /// )?;
    /// assert_eq!(domain.boundary().sides().collect::<Vec<_>>(), [3, 6, 3, 2]);
    ///
    /// let error = Domain::from_json(r#"{"rectangle": {"width": 4, "hight": 3}}"#).unwrap_err();
    /// assert_eq!(error.path, "rectangle.hight");
    /// assert_eq!((error.line, error.column), (1, 34));
    /// # Ok::<(), mindeg_domain::DomainJsonError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, DomainJsonError> {
        // A mark that some Windows programs put before UTF-8 text.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let keys = parse(text)?;
        keys.into_domain().map_err(|Misfit { mut path, message }| {
            let (line, column) = locate(text, &mut path);
            DomainJsonError { path: display(&path), line, column, message }
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with the keys of a domain")]
struct DomainKeys {
    name: Option<String>,
    rectangle: Option<RectangleKeys>,
    polygon: Option<PolygonKeys>,
    size: Option<f64>,
    sides: Option<Vec<SideKeys>>,
    #[serde(default)]
    vertices: Vec<VertexKeys>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RectangleKeys {
    width: f64,
    height: f64,
    #[serde(default)]
    origin: [f64; 2],
    #[serde(default)]
    rotation: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PolygonKeys {
    corners: Vec<[f64; 2]>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SideKeys {
    intervals: Option<u64>,
    size: Option<f64>,
    #[serde(default)]
    spacing: Spacing,
    name: Option<String>,
    #[serde(default, deserialize_with = "number_or_list")]
    outside_degree: OutsideDegree,
    max_degree: Option<u32>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VertexKeys {
    vertex: u32,
    outside_degree: Option<u32>,
    max_degree: Option<u32>,
}

fn number_or_list<'de, D: Deserializer<'de>>(reader: D) -> Result<OutsideDegree, D::Error> {
    struct NumberOrList;

    impl<'de> Visitor<'de> for NumberOrList {
        type Value = OutsideDegree;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a number or a list of numbers")
        }

        fn visit_u64<E: Error>(self, number: u64) -> Result<OutsideDegree, E> {
            u32::try_from(number)
                .map(OutsideDegree::Inside)
                .map_err(|_| E::invalid_value(serde::de::Unexpected::Unsigned(number), &self))
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<OutsideDegree, A::Error> {
            let mut numbers = Vec::new();
            while let Some(number) = list.next_element()? {
                numbers.push(number);
            }
            Ok(OutsideDegree::Each(numbers))
        }
    }

    reader.deserialize_any(NumberOrList)
}

/// Something wrong with what was read, not with how it is written.
struct Misfit {
    path: Vec<Step>,
    message: String,
}

impl Misfit {
    fn new<const N: usize>(path: [Step; N], message: &str) -> Self {
        Self { path: path.into(), message: message.to_owned() }
    }
}

impl From<DomainError> for Misfit {
    fn from(error: DomainError) -> Self {
        Self { path: path_of(&error), message: error.to_string() }
    }
}

impl DomainKeys {
    fn into_domain(self) -> Result<Domain, Misfit> {
        let (outline, side_count) = match (self.rectangle, self.polygon) {
            (Some(RectangleKeys { width, height, origin, rotation }), None) => {
                let origin = origin.into();
                (Outline::Rectangle(Rectangle { width, height, origin, rotation }), 4)
            }
            (None, Some(PolygonKeys { corners })) => {
                let corners: Vec<DVec2> = corners.into_iter().map(DVec2::from).collect();
                let count = corners.len();
                (Outline::Polygon(corners), count)
            }
            (None, None) => {
                let message = "the outline is missing; give \"rectangle\": {\"width\": w, \
                               \"height\": h} or \"polygon\": {\"corners\": [[x, y], …]}";
                return Err(Misfit::new([], message));
            }
            (Some(_), Some(_)) => {
                let message = "a domain is either a \"rectangle\" or a \"polygon\"; drop one";
                return Err(Misfit::new([Step::Key("polygon")], message));
            }
        };
        let sides = match (self.sides, self.size) {
            (Some(sides), _) => sides,
            (None, Some(_)) => (0..side_count).map(|_| SideKeys::default()).collect(),
            (None, None) => {
                let message = "the sides are missing; give \"sides\": [{\"intervals\": n}, …], \
                               or a target interval length \"size\" for all";
                return Err(Misfit::new([], message));
            }
        };
        let sides = sides
            .into_iter()
            .enumerate()
            .map(|(number, side)| side.into_side(number, self.size))
            .collect::<Result<Vec<_>, _>>()?;
        let vertices = self.vertices.into_iter().enumerate();
        let vertices = vertices
            .map(|(entry, vertex)| vertex.into_constraint(entry))
            .collect::<Result<_, _>>()?;
        let domain = Domain::new(outline, sides)?.with_vertex_constraints(vertices)?;
        Ok(match self.name {
            Some(name) => domain.named(name)?,
            None => domain,
        })
    }
}

impl SideKeys {
    fn into_side(self, number: usize, default_size: Option<f64>) -> Result<Side, Misfit> {
        let Self { intervals, size, spacing, name, outside_degree, max_degree } = self;
        let wrong = |message| Misfit::new([Step::Key("sides"), Step::Index(number)], message);
        let intervals = match (intervals, size, &spacing) {
            (Some(_), Some(_), _) => {
                return Err(wrong("give either \"intervals\" or \"size\", not both"));
            }
            (None, Some(_), Spacing::Parameters(_)) => {
                return Err(wrong(
                    "\"parameters\" say how many intervals there are; drop \"size\"",
                ));
            }
            (Some(count), None, _) => Intervals::Count(count),
            (None, Some(size), _) => Intervals::Size(size),
            (None, None, Spacing::Parameters(given)) => Intervals::Count(given.len() as u64 + 1),
            (None, None, _) => Intervals::Size(default_size.ok_or_else(|| {
                wrong("give \"intervals\" (a whole number) or \"size\" (a target interval length)")
            })?),
        };
        Ok(Side { intervals, spacing, name, outside_degree, max_degree })
    }
}

impl VertexKeys {
    fn into_constraint(self, entry: usize) -> Result<VertexConstraint, Misfit> {
        let Self { vertex, outside_degree, max_degree } = self;
        if outside_degree.is_none() && max_degree.is_none() {
            let message = "give \"outside_degree\" (edges on the other side of the boundary) or \
                           \"max_degree\" (a cap), or drop the vertex";
            return Err(Misfit::new([Step::Key("vertices"), Step::Index(entry)], message));
        }
        let outside_degree = outside_degree.unwrap_or(0);
        Ok(VertexConstraint { vertex, outside_degree, max_degree })
    }
}

fn parse(text: &str) -> Result<DomainKeys, DomainJsonError> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let keys = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        // The path of the whole text, and of what cannot be told.
        let path = path.trim_matches(['.', '?']).to_owned();
        at(path, error.inner())
    })?;
    reader.end().map_err(|error| at(String::new(), &error))?;
    Ok(keys)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_every_key() {
        let domain = Domain::from_json(
            r#"{
                "name": "plate",
                "polygon": {"corners": [[0, 0], [8, 0], [8, 4], [0, 4]]},
                "size": 2,
                "sides": [
                    {"spacing": "uniform", "name": "bottom"},
                    {"intervals": 3, "spacing": {"first_length": 0.5}},
                    {"size": 1, "spacing": {"beta": {"beta": 1.2}}},
                    {"spacing": {"parameters": [0.25, 0.5]}}
                ]
            }"#,
        )
        .unwrap();
        assert_eq!(domain.name(), Some("plate"));
        assert!(domain.boundary().sides().eq([4, 3, 8, 3]));
        assert_eq!(domain.sides()[0], Side::size(2.0).named("bottom"));
        assert_eq!(domain.sides()[1], Side::count(3).spaced(Spacing::FirstLength(0.5)));
        assert_eq!(domain.sides()[3], Side::parameters(vec![0.25, 0.5]));

        let text = r#"{"rectangle": {"width": 2, "height": 1, "origin": [5, 6], "rotation": 90}, "size": 0.5}"#;
        for text in [text.to_owned(), format!("\u{feff}{text}\n")] {
            let domain = Domain::from_json(&text).unwrap();
            assert!(domain.boundary().sides().eq([4, 2, 4, 2]));
            assert_eq!(domain.placement().corners()[1], DVec2::new(5.0, 8.0));
        }
    }

    #[test]
    fn reads_constraints() {
        let domain = Domain::from_json(
            r#"{
                "rectangle": {"width": 4, "height": 3}, "size": 2,
                "sides": [
                    {"outside_degree": 2}, {"outside_degree": [1, 0, 2], "max_degree": 9}, {}, {}
                ],
                "vertices": [
                    {"vertex": 6, "max_degree": 4}, {"vertex": 1, "outside_degree": 1}
                ]
            }"#,
        )
        .unwrap();
        assert_eq!(domain.sides()[0].outside_degree, OutsideDegree::Inside(2));
        assert_eq!(domain.sides()[1].outside_degree, OutsideDegree::Each(vec![1, 0, 2]));
        assert_eq!(domain.sides().iter().filter_map(|s| s.max_degree).collect::<Vec<_>>(), [9]);
        let vertex = |vertex, outside_degree, max_degree| VertexConstraint {
            vertex,
            outside_degree,
            max_degree,
        };
        assert_eq!(domain.vertex_constraints(), [vertex(1, 1, None), vertex(6, 0, Some(4))]);
    }

    /// The reader's own float parser is allowed to be off by a unit in the last place.
    #[test]
    fn coordinates_are_the_nearest_f64() {
        for i in 0..2000_u32 {
            let x = 1e5 + f64::from(i) / 7.0;
            let text = format!(
                r#"{{"size": 1e5, "polygon": {{"corners": [[0, 0], [{x}, 0], [{x}, 1e6]]}}}}"#
            );
            let domain = Domain::from_json(&text).unwrap();
            assert_eq!(domain.placement().corners()[1].x, x);
        }
    }

    #[track_caller]
    fn check_error(text: &str, position: (usize, usize), path: &str, message: &str) {
        let error = Domain::from_json(text).unwrap_err();
        assert_eq!((error.line, error.column), position, "{error}");
        assert_eq!(error.path, path, "{error}");
        assert!(error.message.starts_with(message), "{error}");
    }

    /// A unit square in whose JSON the last side is as given, on line 3 from column 2 on.
    fn with_side(side: &str) -> String {
        format!(
            "{{\"rectangle\": {{\"width\": 1, \"height\": 1}}, \"sides\": [\n\
             {{\"intervals\": 1}}, {{\"intervals\": 1}}, {{\"intervals\": 1, \"name\": \"top\"}},\n {side}]}}"
        )
    }

    #[test]
    fn says_where_the_text_is_wrong() {
        #[rustfmt::skip]
        let table = [
            (r#"{"intervals": 2.5}"#, 18, "sides[3].intervals", "invalid type: floating point `2.5`; allowed: a whole number, at least 1"),
            (r#"{"intervals": -1}"#, 17, "sides[3].intervals", "invalid value: integer `-1`; allowed: a whole number, at least 1"),
            (r#"{"interval": 1}"#, 12, "sides[3].interval", "unknown field `interval`, expected one of `intervals`, `size`, `spacing`, `name`"),
            (r#"{"size": "a"}"#, 13, "sides[3].size", "invalid type: string \"a\"; allowed: a number above 0"),
            (r#"{"size": 1e999}"#, 15, "sides[3].size", "number out of range"),
            (r#"{"intervals": 1, "spacing": "even"}"#, 35, "sides[3].spacing", "unknown variant `even`; allowed: \"uniform\", {"),
            (r#"{"intervals": 1, "spacing": "bump"}"#, 36, "sides[3].spacing.bump", "invalid type: unit variant; allowed: \"uniform\", {"),
            (r#"{"intervals": 1, "spacing": {"bump": {"c": 2}}}"#, 42, "sides[3].spacing.bump.c", "unknown field `c`; allowed: \"uniform\","),
            (r#"{"intervals": 1, "spacing": {"bump": {"ratio": true}}}"#, 52, "sides[3].spacing.bump.ratio", "invalid type: boolean `true`; allowed:"),
            (r#"{"intervals": 1, "intervals": 1}"#, 29, "sides[3]", "duplicate field `intervals`"),
            (r#"{"outside_degree": -1}"#, 22, "sides[3].outside_degree", "invalid type: integer `-1`; allowed: a whole number; for a side also a list"),
            (r#"{"outside_degree": 5000000000}"#, 30, "sides[3].outside_degree", "invalid value: integer `5000000000`; allowed: a whole number"),
            (r#"{"outside_degree": [1, "a"]}"#, 27, "sides[3].outside_degree[1]", "invalid type: string \"a\"; allowed: a whole number"),
            (r#"{"max_degree": 2.5}"#, 19, "sides[3].max_degree", "invalid type: floating point `2.5`; allowed: a whole number, at least 2"),
        ];
        for (side, column, path, message) in table {
            check_error(&with_side(side), (3, column), path, message);
        }
        #[rustfmt::skip]
        let table = [
            ("", 1, "", "EOF while parsing a value"),
            ("{}{}", 3, "", "trailing characters"),
            ("3", 1, "", "invalid type: integer `3`, expected an object with the keys of a domain"),
            (r#"{"polygon": [[0, 0], [1, 0]]}"#, 15, "polygon[0][0]", "invalid type: integer `0`; allowed: {\"corners\": [[x, y], …]}"),
            (r#"{"rectangle": {"width": 1}}"#, 26, "rectangle", "missing field `height`"),
            (r#"{"vertices": [{"id": 1}]}"#, 19, "vertices[0].id", "unknown field `id`; allowed: a list of {\"vertex\": v, "),
            (r#"{"vertices": [{"vertex": -1}]}"#, 27, "vertices[0].vertex", "invalid value: integer `-1`; allowed: a whole number, the vertex's"),
            (r#"{"vertices": [{"max_degree": 4}]}"#, 31, "vertices[0]", "missing field `vertex`"),
            (r#"{"polygon": {"corners": [[0, 0], [1, 0, 0]]}}"#, 41, "polygon.corners[1]", "trailing characters; allowed: a list of [x, y] pairs"),
        ];
        for (text, column, path, message) in table {
            check_error(text, (1, column), path, message);
        }
    }

    #[test]
    fn says_where_the_domain_is_wrong() {
        #[rustfmt::skip]
        let table = [
            (r#"{"intervals": 0}"#, 16, "sides[3].intervals", "side 4 has 0 intervals"),
            (r#"{"size": 0}"#, 11, "sides[3].size", "side 4: the size is 0.0"),
            (r#"{}"#, 2, "sides[3]", "give \"intervals\" (a whole number) or \"size\" (a target"),
            (r#"{"intervals": 1, "size": 1}"#, 2, "sides[3]", "give either \"intervals\" or \"size\""),
            (r#"{"size": 1, "spacing": {"parameters": [0.5]}}"#, 2, "sides[3]", "\"parameters\" say how many"),
            (r#"{"intervals": 1, "name": "top"}"#, 27, "sides[3].name", "sides 3 and 4 are both named \"top\""),
            (r#"{"intervals": 2, "spacing": {"bump": {"ratio": 0}}}"#, 30, "sides[3].spacing", "side 4: the ratio is 0.0"),
            (r#"{"intervals": 1, "outside_degree": [1]}"#, 37, "sides[3].outside_degree", "side 4: outside_degree lists 1 numbers, and the side has 2"),
            (r#"{"intervals": 1, "outside_degree": 1000000001}"#, 37, "sides[3].outside_degree", "side 4: an outside_degree of 1000000001 is more"),
            (r#"{"intervals": 1, "max_degree": 1}"#, 33, "sides[3].max_degree", "vertex 3 has a max_degree of 1"),
            (r#"{"spacing": {"parameters": [0.5, 0.5]}}"#, 35, "sides[3].spacing.parameters[1]", "side 4: parameter 2 (0.5) is not above"),
        ];
        for (side, column, path, message) in table {
            check_error(&with_side(side), (3, column), path, message);
        }
        #[rustfmt::skip]
        let table = [
            ("{}", (1, 1), "", "the outline is missing"),
            (r#"{"sides": [], "rectangle": {"width": 1, "height": 1}}"#, (1, 11), "sides", "0 sides are described"),
            (r#"{"size": 1, "rectangle": {"width": 1, "height": -1}}"#, (1, 49), "rectangle.height", "the rectangle's height is -1.0"),
            (r#"{"rectangle": {"width": 1, "height": 1}}"#, (1, 1), "", "the sides are missing"),
            (r#"{"size": 1, "vertices": [{"vertex": 1}], "rectangle": {"width": 1, "height": 1}}"#, (1, 26), "vertices[0]", "give \"outside_degree\""),
            (r#"{"size": 1, "vertices": [{"vertex": 4, "max_degree": 3}], "rectangle": {"width": 1, "height": 1}}"#, (1, 37), "vertices[0].vertex", "vertex 4 does not exist"),
            (r#"{"size": 1, "vertices": [{"vertex": 1, "max_degree": 3}, {"max_degree": 4, "vertex": 1}], "rectangle": {"width": 1, "height": 1}}"#, (1, 86), "vertices[1].vertex", "vertex 1 is listed twice"),
            (r#"{"size": 1, "vertices": [{"vertex": 1, "max_degree": 3, "outside_degree": 2}], "rectangle": {"width": 1, "height": 1}}"#, (1, 54), "vertices[0].max_degree", "vertex 1 has a max_degree of 3"),
            (r#"{"size": 1, "vertices": [{"vertex": 1, "outside_degree": 4000000000}], "rectangle": {"width": 1, "height": 1}}"#, (1, 58), "vertices[0].outside_degree", "entry 1: an outside_degree of 4"),
            (r#"{"rectangle": {"width": 1, "height": 1}, "size": -1}"#, (1, 1), "", "side 1: the size is -1.0"),
            (r#"{"rectangle": {"width": 1, "height": 1}, "polygon": {"corners": []}}"#, (1, 53), "polygon", "a domain is either"),
            ("{\"size\": 1, \"polygon\": {\"corners\":\n[[0,0],[1,0],\n[2,0],[0,1]]}}", (2, 8), "polygon.corners[1]", "corner 2 at (1.0, 0.0) is straight"),
        ];
        for (text, position, path, message) in table {
            check_error(text, position, path, message);
        }
    }

    #[test]
    fn the_message_leads_to_the_place() {
        let error = Domain::from_json(&with_side(r#"{"intervals": 0}"#)).unwrap_err();
        assert_eq!(
            error.to_string(),
            "line 3, column 16, sides[3].intervals: side 4 has 0 intervals; every side needs at \
             least 1"
        );
        let error = Domain::from_json("{").unwrap_err().to_string();
        assert_eq!(error, "line 1, column 1: EOF while parsing an object");
    }
}
