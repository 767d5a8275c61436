//! The lines of an answer, in JSON.

use mindeg_answers::advice::AdviceAnswer;
use mindeg_answers::degree::DegreeReport;
use mindeg_answers::limit::LimitAnswer;
use mindeg_answers::trade_off::TradeOffAnswer;
use serde::Serialize;
use serde_json::value::RawValue;

use crate::part::{Part, View};

/// A line of an answer.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum AnswerLine {
    /// The domain as it was understood.
    Domain(DomainShown),
    /// A mesh.
    Mesh(Box<Shown>),
    /// The degree in words.
    Degree(DegreeShown),
    /// The limit of the minimum angle of every mesh with this boundary, with any interior points.
    Limit(LimitShown),
    /// The trade-off: the minimum angle of every degree.
    Curve(CurveShown),
    /// The meshes to take by what they are for.
    Advice(AdviceAnswer),
    /// Changes that bring a smaller degree or a larger angle.
    Suggestions {
        /// The least change first.
        suggestions: Vec<ChangeShown>,
    },
    /// How to make the mesh without the page.
    Command {
        /// Ready for a POSIX shell.
        text: String,
    },
    /// One part has no answer, or no part has an answer.
    Refused {
        /// The part; `None` if the request or its domain is refused.
        part: Option<Part>,
        /// The error and the way to fix it, in a sentence.
        message: String,
        /// Where in the domain's JSON it is, such as `sides[2].spacing`, if that is known.
        path: Option<String>,
        /// Of points inside that are too many for the page: a size inside with which they are fewer.
        coarser: Option<f64>,
    },
    /// All parts are answered.
    Done {
        /// Milliseconds since the request was read.
        milliseconds: f64,
    },
}

/// A domain as it was understood.
#[derive(Clone, Debug, Serialize)]
pub struct DomainShown {
    /// Its name.
    pub name: Option<String>,
    /// The number of vertices of every mesh of its boundary and of what is inside.
    pub vertices: usize,
    /// The number of holes.
    pub holes: usize,
    /// The number of triangles of every mesh of its boundary points alone.
    pub triangles: u32,
    /// Whether it is convex and without holes.
    pub is_convex: bool,
    /// The origin of the points: the middle of their bounding box.
    pub center: [f64; 2],
    /// The width and height of the bounding box.
    pub size: [f64; 2],
    /// All boundary points: `f64`, base64.
    pub points: String,
    /// The first vertex of each ring, and then the number of vertices.
    pub rings: Vec<u32>,
    /// The sides of all rings.
    pub sides: Vec<SideShown>,
    /// The lines inside.
    pub lines: Vec<LineShown>,
    /// The points inside that have a name of their own.
    pub named_points: Vec<PlaceShown>,
    /// The regions of a map that are no holes, where a place in them is given.
    pub regions: Vec<PlaceShown>,
    /// How many regions a map has; 0 if the domain is none.
    pub region_count: usize,
    /// The changes to the description, in sentences.
    pub notes: Vec<String>,
}

/// A side of a domain.
#[derive(Clone, Debug, Serialize)]
pub struct SideShown {
    /// Its own name, or one like "hole 1 side 2".
    pub name: String,
    /// Its ring; 0 is the outer one.
    pub ring: usize,
    /// Its first vertex, which is a corner.
    pub start: u32,
    /// How many intervals it has.
    pub intervals: u32,
    /// Whether all its points are on a straight line.
    pub is_straight: bool,
}

/// A line inside a domain.
#[derive(Clone, Debug, Serialize)]
pub struct LineShown {
    /// Its name; empty if it has none.
    pub name: String,
    /// The two ends of each of its edges: `f64`, base64.
    pub segments: String,
}

/// A name and where it is.
#[derive(Clone, Debug, Serialize)]
pub struct PlaceShown {
    /// The name.
    pub name: String,
    /// Its x and y; not from the center.
    pub at: [f64; 2],
}

/// A mesh, what it is like and how it is colored.
#[derive(Clone, Debug, Serialize)]
pub struct Shown {
    /// The view that the mesh belongs to.
    pub view: View,
    /// Whether a better one follows: while the exact search runs, the best mesh at hand is shown.
    pub is_last: bool,
    /// In a sentence: degree, angles, and what is proven of them.
    pub words: String,
    /// Points beyond those of the domain: `f64`, base64; empty but in [`View::Interior`].
    pub interior_points: String,
    /// Three vertices each: `u32`, base64.
    pub triangles: String,
    /// The degree of each vertex: `u32`, base64.
    pub degrees: String,
    /// The measure of [`Request::color`](crate::Request::color) of each triangle: `f32`, base64; empty without one.
    pub values: String,
    /// The greatest degree, external degrees included.
    pub max_degree: u32,
    /// No mesh of the boundary points has less.
    pub at_least: Option<u32>,
    /// The minimum angle in degrees.
    pub min_angle: f64,
    /// The maximum angle in degrees.
    pub max_angle: f64,
    /// The minimum angle as a share of that of a Delaunay triangulation, where that is known.
    pub share_of_delaunay: Option<f64>,
    /// How many vertices have each degree, ascending: `[degree, vertices]`.
    pub degree_bars: Vec<[u64; 2]>,
    /// How the measure of [`Request::color`](crate::Request::color) is spread.
    pub bars: Option<Bars>,
    /// The triangle with the minimum angle.
    pub worst_triangle: u32,
    /// The first vertex with the greatest degree.
    pub max_degree_vertex: u32,
    /// The places that decide the angle or break a degree limit, with what is so there.
    pub marks: Vec<PlaceShown>,
}

/// A histogram of a measure.
#[derive(Clone, Debug, Serialize)]
pub struct Bars {
    /// The name of the measure.
    pub measure: String,
    /// The ends of the axis; what is beyond is counted in the first and last bar. The axis of a measure is
    /// the same for all meshes but that of lengths and areas, which goes by the domain's size.
    pub range: [f64; 2],
    /// Whether the bars divide the axis by equal ratios instead of equal steps.
    pub is_logarithmic: bool,
    /// The number of triangles in each of 30 bars.
    pub counts: Vec<u32>,
    /// The smallest value, the median, the mean and the largest.
    pub min: f64,
    /// The median.
    pub median: f64,
    /// The mean.
    pub mean: f64,
    /// The largest value.
    pub max: f64,
}

/// The least maximum degree, with its words.
#[derive(Clone, Debug, Serialize)]
pub struct DegreeShown {
    /// The same keys as in `mindeg degree --json`.
    #[serde(flatten)]
    pub report: DegreeReport,
    /// Why it cannot be less, and how it is reached: sentences, as `mindeg degree` has them.
    pub words: String,
}

/// The limit of the minimum angle, with its words.
#[derive(Clone, Debug, Serialize)]
pub struct LimitShown {
    /// The same keys as in `mindeg degree --json`.
    #[serde(flatten)]
    pub limit: LimitAnswer,
    /// The sentence of `mindeg degree`.
    pub words: String,
    /// The vertices that decide: one, or one of each of two intervals that face each other.
    pub vertices: Vec<u32>,
    /// Their sides.
    pub sides: Vec<usize>,
}

/// The largest minimum angle for every maximum degree, with its words.
#[derive(Clone, Debug, Serialize)]
pub struct CurveShown {
    /// The same keys as in `mindeg tradeoff --json`.
    #[serde(flatten)]
    pub answer: TradeOffAnswer,
    /// The maximum degree of a Delaunay triangulation.
    pub delaunay_max_degree: Option<u32>,
    /// The unproven points, in a sentence.
    pub open_question: Option<&'static str>,
}

/// A change of interval counts.
#[derive(Clone, Debug, Serialize)]
pub struct ChangeShown {
    /// The change and what it brings: "add 2 to side 2: degree 4".
    pub words: String,
    /// The least maximum degree after it, if that is what it is for.
    pub max_degree: Option<u32>,
    /// The limit of the minimum angle after it, in degrees, if that is what it is for.
    pub min_angle: Option<f64>,
    /// The domain after it, for [`Request::domain`](crate::Request::domain).
    pub domain: Box<RawValue>,
}
