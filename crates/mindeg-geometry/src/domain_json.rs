//! Domains as JSON text: what engineers write by hand and keep beside their meshes.
//!
//! Keys that are not the format's are refused, so that a misspelt one is not passed over. Every
//! error says where in the text it is, also those that show only when all of it is read.
//!
//! Limits: JSON has no comments and no infinities. The whole text is held in memory.

use glam::DVec2;
use mindeg_core::BoundaryError;
use serde::Deserialize;

use crate::domain::{Domain, Intervals, Outline, Rectangle, Side};
use crate::domain_error::DomainError;
use crate::json_path::{Step, display, locate};
use crate::spacing::{Spacing, SpacingError};

/// What is wrong with a domain's JSON text, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}, column {column}{}: {message}", if path.is_empty() { String::new() } else { format!(", {path}") })]
pub struct DomainJsonError {
    /// The keys that lead to the place, such as `sides[2].spacing`; empty for the whole text.
    pub path: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in bytes: where the wrong value starts, or how far it was read.
    pub column: usize,
    /// What is wrong and what is allowed.
    pub message: String,
}

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
    ///
    /// and in each side, all optional:
    ///
    /// | key | value |
    /// |---|---|
    /// | `intervals` | a whole number, at least 1 |
    /// | `size` | instead: a target length, above 0, that the side's length is divided by |
    /// | `spacing` | `"uniform"`, `{"geometric": {"ratio": r}}`, `{"bump": {"ratio": c}}`, `{"beta": {"beta": b}}`, `{"first_length": h}`, `{"last_length": h}` or `{"parameters": [t1, …]}`; see [`Spacing`] |
    /// | `name` | the side's name; no two sides may have the same |
    ///
    /// # Errors
    ///
    /// Text that is no JSON, keys or values that are not the format's, and whatever
    /// [`Domain::new`] refuses; each with its path, line and column.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_geometry::Domain;
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
    /// # Ok::<(), mindeg_geometry::DomainJsonError>(())
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
        let domain = Domain::new(outline, sides)?;
        Ok(match self.name {
            Some(name) => domain.named(name)?,
            None => domain,
        })
    }
}

impl SideKeys {
    fn into_side(self, number: usize, default_size: Option<f64>) -> Result<Side, Misfit> {
        let Self { intervals, size, spacing, name } = self;
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
        Ok(Side { intervals, spacing, name })
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

fn at(path: String, error: &serde_json::Error) -> DomainJsonError {
    let (line, column) = (error.line().max(1), error.column().max(1));
    let message = error.to_string();
    let position = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&position).unwrap_or(&message);
    let message = match allowed(&path) {
        // What the parser expects it calls by the names of Rust's types.
        Some(allowed) => {
            format!("{}; allowed: {allowed}", message.split(", expected").next().unwrap_or(message))
        }
        None => message.to_owned(),
    };
    DomainJsonError { path, line, column, message }
}

/// What may stand at a path, where the parser's own words do not say it.
fn allowed(path: &str) -> Option<&'static str> {
    let keys = path.rsplit('.').map(|key| key.split('[').next().unwrap_or(key));
    keys.filter_map(|key| match key {
        "intervals" => Some("a whole number, at least 1"),
        "size" | "width" | "height" => Some("a number above 0"),
        "rotation" => Some("a number, in degrees"),
        "rectangle" => {
            Some("{\"width\": w, \"height\": h, \"origin\": [x, y], \"rotation\": degrees}")
        }
        "polygon" => Some("{\"corners\": [[x, y], …]}"),
        "corners" => Some("a list of [x, y] pairs of numbers"),
        "origin" => Some("a pair [x, y] of numbers"),
        "spacing" => Some(
            "\"uniform\", {\"geometric\": {\"ratio\": r}}, {\"bump\": {\"ratio\": c}}, \
             {\"beta\": {\"beta\": b}}, {\"first_length\": h}, {\"last_length\": h} or \
             {\"parameters\": [t1, t2, …]}",
        ),
        _ => None,
    })
    .next()
}

/// The place in the JSON text that an error of the domain is about.
fn path_of(error: &DomainError) -> Vec<Step> {
    use Step::{Index, Key};
    let corner = |corner| vec![Key("polygon"), Key("corners"), Index(corner)];
    let side = |side, key| vec![Key("sides"), Index(side), Key(key)];
    match *error {
        DomainError::Rectangle { key, .. } => vec![Key("rectangle"), Key(key)],
        DomainError::TooFewCorners { .. } | DomainError::NotSimple { .. } => {
            vec![Key("polygon"), Key("corners")]
        }
        DomainError::Coordinate { corner: c, .. }
        | DomainError::RepeatedCorner { second: c, .. }
        | DomainError::NotConvex { corner: c, .. }
        | DomainError::UnresolvedCorner { corner: c, .. } => corner(c),
        DomainError::SideCount { .. } => vec![Key("sides")],
        DomainError::Name { side: None, .. } => vec![Key("name")],
        DomainError::Name { side: Some(s), .. } | DomainError::RepeatedName { second: s, .. } => {
            side(s, "name")
        }
        DomainError::Size { side: s, .. } => side(s, "size"),
        DomainError::Boundary(
            BoundaryError::NoIntervals { side: s } | BoundaryError::TooManyVertices { side: s, .. },
        ) => side(s, "intervals"),
        DomainError::Boundary(_) => vec![Key("sides")],
        DomainError::Spacing {
            side: s,
            source:
                SpacingError::ParameterRange { index, .. } | SpacingError::ParameterOrder { index, .. },
        } => [side(s, "spacing"), vec![Key("parameters"), Index(index)]].concat(),
        DomainError::Spacing { side: s, .. } | DomainError::UnresolvedInterval { side: s, .. } => {
            side(s, "spacing")
        }
    }
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
