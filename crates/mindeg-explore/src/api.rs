//! The messages between the page and the server.
//!
//! Everything under `/api/` needs the header `X-Mindeg-Token` with the token after `#` in the printed
//! address, `http://127.0.0.1:PORT/#TOKEN` or `http://127.0.0.1:PORT/#TOKEN/STATE`. A request that is
//! refused has a status of 400 or more and the body `{"message": "…"}`, one sentence to show.
//!
//! | request | body | answer |
//! |---|---|---|
//! | `GET /`, `GET /page/NAME` | | the page and its files; no token |
//! | `GET /api/start` | | [`Source`]: the domain or surface of the command line, or else a preset |
//! | `GET /api/start/choices` | | a list of [`Source`]: all domains of its file, where there are several |
//! | `GET /api/start/divided?size=1` | | the same, their curves and sides divided into edges of a length |
//! | `GET /api/start/file` | | the bytes of the file of that surface |
//! | `GET /api/presets` | | a list of [`Source`]: the domains of `assets/domains` |
//! | `GET /api/facts` | | [`Facts`]: measures and formats by name, limits |
//! | `POST /api/answer?tab=ID` | [`Request`] | [`AnswerLine`]s, one JSON object a line, each as soon as it is known |
//! | `POST /api/read?name=FILE` | a file's bytes | a list of [`Source`]: its polygons, or its one domain; also `size` |
//! | `POST /api/condition?angle=25` | [`Request`] | the domain with a boundary that allows the angle, `words` and `command`; also `size`, `within` |
//! | `POST /api/divide?size=1` | [`Request`] | the domain with all sides divided into edges of a length |
//! | `POST /api/solid?name=FILE&change=CHANGE` | a file's bytes | the surface in it, after `nothing`, `remesh`, `fill` or `bridge`; also `size`, `loops`, `interior` |
//! | `POST /api/solid/file?name=FILE&change=CHANGE&format=NAME` | a file's bytes | the bytes of a file of it |
//! | `POST /api/whole?purpose=solver` | [`WholeMap`] | the mesh of all parts of a map; also `advice` without `purpose` |
//! | `POST /api/whole/file?purpose=solver&format=NAME` | [`WholeMap`] | the bytes of a file of it |
//! | `POST /api/download?format=NAME&view=VIEW&file=0` | [`Request`] | the bytes of a file of the mesh |
//! | `PUT /api/state/ID`, `GET /api/state/ID` | any JSON | kept while the process runs |
//!
//! `tab` is any name of up to 64 letters, digits, `-` and `_`, as is a state's ID. A newer request of a tab to
//! `/api/answer` ends the one before: its answer then stops without [`AnswerLine::Done`]. So does closing the
//! connection.
//!
//! # Arrays
//!
//! Arrays are base64 of little-endian numbers, as in the reports' pages: `f64` points as x, y, x, y, …
//! from the center of the boundary, which [`AnswerLine::Domain`] gives; `u32` triangles, three vertices each,
//! counter-clockwise; `f32` values. Vertices, sides and triangles count from 0; vertices run
//! counter-clockwise round the outer ring and clockwise round each hole; y points up.
//!
//! # Order
//!
//! First [`AnswerLine::Domain`] or [`AnswerLine::Refused`]; then what is fast; last [`AnswerLine::Done`]. Only what
//! [`Request::show`] lists is worked out: the curve, say, stays the same for another goal. A later mesh of
//! the same view replaces an earlier one.

use mindeg::quality::METRICS;
use mindeg::{Goal, GoalKind};
use mindeg_answers::advice::Purpose;
use mindeg_answers::interior_keys::InteriorKey;
use mindeg_answers::measures::MeasureFacts;
use mindeg_files::Format;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::format::format_named;
pub use crate::line::*;
pub use crate::part::{Part, View};
pub use crate::whole::WholeMap;

/// The request of the page.
///
/// ```
/// let body = r#"{
///     "domain": {"rectangle": {"width": 4, "height": 3}, "size": 0.5},
///     "goal": {"keep_angle": 0.95},
///     "show": ["wanted", "degree"],
///     "color": "min_angle"
/// }"#;
/// let request: mindeg_explore::Request = serde_json::from_str(body)?;
/// assert_eq!(request.goal, mindeg::Goal::KeepAngle(0.95));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The domain, as every command of mindeg takes it. Its `interior` is what is wanted of the view
    /// [`View::Interior`].
    pub domain: Box<RawValue>,
    /// The goal of [`View::Wanted`]: `"least_degree"`, or one with a value such as `{"keep_angle": 0.95}`.
    #[serde(default)]
    pub goal: Goal,
    /// The parts to answer; all but [`Part::Interior`] and [`Part::Advice`] by default.
    #[serde(default = "Part::usual")]
    pub show: Vec<Part>,
    /// Meshes that come at once, as drafts, and no other part: while a corner is dragged.
    #[serde(default)]
    pub drafts_only: bool,
    /// The measure of [`Shown::values`]: one of [`Facts::measures`]. Without it there are no values.
    #[serde(default)]
    pub color: Option<String>,
    /// The mesh of [`AnswerLine::Command`].
    #[serde(default)]
    pub view: View,
    /// The format of [`AnswerLine::Command`]: one of [`Facts::formats`], OBJ by default.
    #[serde(default)]
    pub format: Option<String>,
}

/// A domain to start from.
#[derive(Clone, Debug, Serialize)]
pub struct Source {
    /// Its name, or its file's name.
    pub name: String,
    /// Its JSON; `None` if it is not a domain, and then `message` says why.
    pub domain: Option<Box<RawValue>>,
    /// The reader's omissions and changes, in sentences.
    pub notes: Vec<String>,
    /// The reason why it is not a domain.
    pub message: Option<String>,
    /// Whether the file holds a surface instead, for `/api/solid`.
    pub is_solid: bool,
    /// All parts of the file together, for `/api/whole`; that has no one domain.
    pub map: Option<WholeMap>,
}

/// The facts that the page shows but does not work out.
#[derive(Clone, Debug, Serialize)]
pub struct Facts {
    /// The measures of a triangle.
    pub measures: Vec<MeasureFacts>,
    /// The formats to download.
    pub formats: Vec<FormatFact>,
    /// The goals of a mesh.
    pub goals: &'static [GoalKind],
    /// The keys of `interior` that have one value.
    pub interior: Vec<InteriorKey>,
    /// The most boundary vertices of a domain.
    pub max_vertices: u32,
    /// The most bytes of a body.
    pub max_bytes: usize,
    /// The purpose of the mesh, if the command line tells it.
    pub purpose: Option<Purpose>,
}

/// A format to download.
#[derive(Clone, Debug, Serialize)]
pub struct FormatFact {
    /// For `format=`.
    pub name: &'static str,
    /// In a few words.
    pub description: &'static str,
    /// The extension of each of its files, for `file=0`, `file=1`, …
    pub files: Vec<String>,
    /// Whether it holds meshes in the plane alone.
    pub is_planar: bool,
}

impl Request {
    /// The request, if its goal, measure and format exist.
    pub(crate) fn checked(self) -> Result<Self, String> {
        let (kind, value) = self.goal.kind_and_value();
        kind.read(&value).map_err(|problem| format!("{}: {problem}", kind.key))?;
        let is_measure = |name: &String| METRICS.iter().any(|metric| metric.name == name);
        if let Some(name) = self.color.as_ref().filter(|name| !is_measure(name)) {
            return Err(format!("no measure is called {name:?}"));
        }
        self.format.as_deref().map(format_named).transpose()?;
        Ok(self)
    }

    /// The format that is named.
    pub(crate) fn format(&self) -> Option<Format> {
        format_named(self.format.as_deref()?).ok()
    }
}
