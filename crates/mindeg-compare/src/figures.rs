//! The figures of a domain and of each method, as reports hold them.

use crate::Method;
use mindeg::quality::Distribution;
use mindeg_answers::inspected::ThinTriangle;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// The domain that all methods triangulate.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DomainFigures {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// The intervals of each side, those of the outer ring first, then those of each hole.
    pub intervals: Vec<u32>,
    /// The name of each side, where it has one.
    pub side_names: Vec<Option<String>>,
    /// The x and y of each corner; side i runs from corner i to the next of its ring.
    pub corners: Vec<[f64; 2]>,
    /// The sum of the lengths of each side's intervals.
    pub side_lengths: Vec<f64>,
    /// The number of boundary vertices n; of a map, those inside count, too.
    pub vertices: u32,
    /// The number of holes h.
    pub holes: u32,
    /// The number of regions of a map; null if the domain is none.
    pub regions: Option<u32>,
    /// The number of triangles of every triangulation, n + 2h - 2 without vertices inside.
    pub triangles: u32,
    /// The number of interior edges of every triangulation, n + 3h - 3 without vertices inside.
    pub interior_edges: u32,
    /// The least maximum degree of all triangulations; null where it is not known.
    pub least_max_degree: Option<u32>,
    /// No triangulation has a smaller maximum degree.
    pub at_least: u32,
}

/// The mesh of one method in figures.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct MethodFigures {
    /// The name of the method.
    #[serde(rename = "name")]
    pub method: Method,
    /// The method in a sentence.
    pub description: String,
    /// The first method with exactly the same triangles, if one before this has them.
    pub same_mesh_as: Option<Method>,
    /// The largest number of edges at a vertex, boundary edges included.
    pub max_degree: Option<u32>,
    /// The number of vertices of each degree that occurs.
    pub degree_histogram: BTreeMap<u32, u64>,
    /// The part of the histogram above the domain's `at_least`.
    pub vertices_above_least: BTreeMap<u32, u64>,
    /// The minimum angle of all triangles, in degrees.
    pub min_angle: Option<f64>,
    /// The maximum angle of all triangles, in degrees.
    pub max_angle: Option<f64>,
    /// How each measure of quality is spread over the triangles, with the keys of `mindeg inspect --json`.
    pub metrics: Option<BTreeMap<&'static str, Distribution>>,
    /// The share of triangles, 0 to 1, with an angle below 1, 5, 10, 15 and 20 degrees.
    pub share_below_degrees: BTreeMap<u32, f64>,
    /// The five triangles with the minimum angles, worst first.
    pub worst_triangles: Vec<ThinTriangle>,
    /// Whether the triangles have passed the check: all of them counter-clockwise, none flat, every
    /// boundary edge in one and every interior edge in two.
    pub valid: bool,
    /// The fault where `valid` is false; empty otherwise.
    pub defects: Vec<MethodDefect>,
    /// The time from the boundary points to the list of triangles; `null` where there is none.
    pub seconds: Option<f64>,
}

impl MethodFigures {
    /// Maximum degree and minimum angle, where the mesh is valid.
    pub(crate) fn outcome(&self) -> Option<(u32, f64)> {
        self.max_degree.zip(self.min_angle).filter(|_| self.valid)
    }

    /// How a measure is spread.
    pub(crate) fn spread(&self, measure: &str) -> Option<&Distribution> {
        self.metrics.as_ref()?.get(measure)
    }
}

/// Why a method has no valid triangulation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MethodDefect {
    /// The kind of defect.
    pub kind: DefectKind,
    /// How often, where that can be counted.
    pub count: Option<u64>,
    /// The same in words.
    pub message: String,
}

/// The kinds of defect.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum DefectKind {
    /// Triangles with all vertices on one side of the domain.
    FlatTriangles,
    /// Fewer than n - 2 triangles.
    MissingTriangles,
    /// More than n - 2 triangles.
    SurplusTriangles,
    /// The triangles do not fit together.
    NotATriangulation,
    /// The method gave no triangles.
    NoTriangles,
    /// The method was given up after its time limit.
    TimeLimit,
}
