//! What is wanted of each vertex and of the mesh as a whole.

use crate::limits::fan_limit_at;
use crate::options::Options;
use mindeg_domain::Prefer;
use mindeg_mesh::planar::PlanarBoundary;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// What is wanted of a boundary vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Goal {
    /// The greatest number of triangles.
    pub(crate) triangles: u32,
    /// The interior angle over 60 degrees: the best number of triangles.
    pub(crate) ideal: f64,
    /// The greatest number of triangles that a good fan may have; any if angles are preferred.
    pub(crate) fan: Option<u32>,
    /// The fan limit with so many, in degrees.
    pub(crate) limit: f64,
}

/// The goals of an outline's vertices.
pub(crate) fn goals(outline: &PlanarBoundary, options: &Options) -> Vec<Goal> {
    let goal = |vertex| {
        let angle = outline.angle(vertex);
        let triangles = options.degree_limit(outline, vertex) - 1;
        let fan = (options.wanted.prefer() == Prefer::Degree).then_some(triangles);
        let limit = fan_limit_at(outline, vertex, fan);
        Goal { triangles, ideal: angle / (PI / 3.0), fan, limit }
    };
    (0..outline.vertex_count()).map(goal).collect()
}

/// How much each aim counts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Weights {
    /// The minimum angle aimed at, in degrees, where the boundary allows it.
    pub(crate) floor: f64,
    /// The cost of an angle 5 degrees below the floor.
    pub(crate) angle: f64,
    /// The cost of a degree 1 beyond its limit.
    pub(crate) degree: f64,
    /// The degrees wanted inside.
    pub(crate) interior: RangeInclusive<u32>,
    /// True if a better shape may cost a violation more.
    pub(crate) may_violate: bool,
}

impl Weights {
    /// The weights of single operations.
    pub(crate) fn single(options: &Options, floor: f64) -> Self {
        let (degree, may_violate) = match options.wanted.prefer() {
            Prefer::Degree => (1e3, false),
            Prefer::Angle => (2.0, true),
        };
        Self { floor, angle: 2.0, degree, interior: options.wanted.interior_degree(), may_violate }
    }

    /// The weights of the search for pairs of operations: angles count more, so that no good fan is
    /// given up.
    pub(crate) fn pairs(options: &Options, floor: f64) -> Self {
        let single = Self::single(options, floor);
        Self { angle: 100.0, degree: 100.0 * single.degree, ..single }
    }
}
