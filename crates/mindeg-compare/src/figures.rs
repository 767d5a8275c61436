//! The figures of a domain and of each method, as reports hold them.

use crate::Method;
use mindeg::quality;
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
    /// The number of boundary vertices n.
    pub vertices: u32,
    /// The number of holes h.
    pub holes: u32,
    /// The number of triangles of every triangulation, n + 2h - 2.
    pub triangles: u32,
    /// The number of interior edges of every triangulation, n + 3h - 3.
    pub interior_edges: u32,
    /// The least maximum degree that any triangulation can have; if that is not proven, none has a
    /// smaller one.
    pub optimal_max_degree: u32,
    /// Whether some triangulation is known to have the least maximum degree.
    pub optimum_is_proven: bool,
}

/// What one method gives.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct MethodFigures {
    /// The name of the method.
    #[serde(rename = "name")]
    pub method: Method,
    /// What the method does, in a sentence.
    pub description: String,
    /// The first method with exactly the same triangles, if one before this has them.
    pub same_mesh_as: Option<Method>,
    /// The largest number of edges at a vertex, boundary edges included.
    pub max_degree: Option<u32>,
    /// The number of vertices of each degree that occurs.
    pub degree_histogram: BTreeMap<u32, u64>,
    /// The part of the histogram above the domain's least maximum degree.
    pub vertices_above_optimum: BTreeMap<u32, u64>,
    /// The minimum angle of all triangles, in degrees.
    pub min_angle: Option<f64>,
    /// The maximum angle of all triangles, in degrees.
    pub max_angle: Option<f64>,
    /// How each measure of quality is spread over the triangles.
    pub metrics: Option<MetricFigures>,
    /// The share of triangles, 0 to 1, with an angle below 1, 5, 10, 15 and 20 degrees.
    pub share_below_degrees: BTreeMap<u32, f64>,
    /// The five triangles with the minimum angles, worst first.
    pub worst_triangles: Vec<WorstTriangle>,
    /// For a Delaunay triangulation, the number of interior edges whose two triangles lie on
    /// one circle: there the other diagonal would be as good, and degrees are arbitrary.
    pub ties: Option<u32>,
    /// Whether the triangles have passed the check: all of them counter-clockwise, none flat, every
    /// boundary edge in one and every interior edge in two.
    pub valid: bool,
    /// What is wrong where `valid` is false; empty otherwise.
    pub defects: Vec<MethodDefect>,
    /// The time from the boundary points to the list of triangles; `null` where there is none.
    pub seconds: Option<f64>,
}

impl MethodFigures {
    /// Maximum degree and minimum angle, where the mesh is valid.
    pub(crate) fn outcome(&self) -> Option<(u32, f64)> {
        self.max_degree.zip(self.min_angle).filter(|_| self.valid)
    }
}

/// The measures of quality of all triangles. Edge lengths are x <= y <= z, A is the area.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MetricFigures {
    /// The angle opposite x, in degrees: 60 (best) to 0.
    pub min_angle: Distribution,
    /// The angle opposite z, in degrees: 60 (best) to 180.
    pub max_angle: Distribution,
    /// 2A/z, in the domain's unit of length.
    pub minimum_height: Distribution,
    /// z (x+y+z)/(4√3 A): 1 (best) to infinity.
    pub aspect_ratio: Distribution,
    /// xyz (x+y+z)/(16 A²), the circumradius over twice the inradius: 1 (best) to infinity.
    pub radius_ratio: Distribution,
    /// 4√3 A/(x²+y²+z²): 1 (best) to 0.
    pub shape: Distribution,
}

/// How the values of one measure are spread. What is infinite, as ratios of a flat triangle
/// are, is `null` in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Distribution {
    /// The least value.
    #[schemars(with = "Option<f64>")]
    pub min: f64,
    /// The least value that at least 1% of all values do not exceed.
    #[schemars(with = "Option<f64>")]
    pub p01: f64,
    /// The least value that at least half of all values do not exceed.
    #[schemars(with = "Option<f64>")]
    pub median: f64,
    /// The arithmetic mean.
    #[schemars(with = "Option<f64>")]
    pub mean: f64,
    /// The least value that at least 99% of all values do not exceed.
    #[schemars(with = "Option<f64>")]
    pub p99: f64,
    /// The greatest value.
    #[schemars(with = "Option<f64>")]
    pub max: f64,
}

/// One of the worst triangles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstTriangle {
    /// Its number, from 0, in the order of the method: mindeg's as in the files it writes, the
    /// others' sorted by vertices.
    pub triangle: u32,
    /// Its vertices, counter-clockwise, numbered from 0 at the first corner.
    pub vertices: [u32; 3],
    /// Its minimum angle, in degrees.
    pub min_angle: f64,
    /// Its maximum angle, in degrees.
    pub max_angle: f64,
}

/// Why a method has no valid triangulation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MethodDefect {
    /// What it is.
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

impl From<&quality::Distribution> for Distribution {
    fn from(spread: &quality::Distribution) -> Self {
        let quality::Distribution { min, p01, median, mean, p99, max } = *spread;
        Self { min, p01, median, mean, p99, max }
    }
}
