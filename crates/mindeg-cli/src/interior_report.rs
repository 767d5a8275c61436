//! What a mesh with interior points is like, in words and in JSON.

use mindeg::Interior;
use mindeg::interior::{AngleLimit, Lift, Report, Violation};
use mindeg_answers::numbers::four_digits;
use serde::Serialize;
use std::ops::RangeInclusive;

/// What was reached; angles in degrees.
#[derive(Serialize)]
pub(crate) struct Reached {
    pub(crate) triangles: usize,
    pub(crate) interior_points: usize,
    pub(crate) min_angle: f64,
    pub(crate) max_angle: f64,
    /// The greatest minimum angle that the boundary allows, at its degree limits and at the degrees of
    /// vertices that break theirs.
    pub(crate) min_angle_limit: f64,
    /// The same at any degree.
    pub(crate) min_angle_limit_at_any_degree: f64,
    pub(crate) share_of_limit: f64,
    /// The least and the greatest; null without interior vertices.
    pub(crate) interior_degree: Option<[u32; 2]>,
    pub(crate) boundary_degree: [u32; 2],
    /// Vertices whose degree is out of its range.
    pub(crate) violations: Vec<Place>,
    /// The greatest ratio of the areas of two triangles with a common edge.
    pub(crate) area_ratio: f64,
    /// The 99th percentile of the square root of that ratio.
    pub(crate) grading_p99: f64,
}

/// A vertex whose degree is out of its range.
#[derive(Serialize)]
pub(crate) struct Place {
    vertex: u32,
    position: [f64; 2],
    degree: u32,
    on_boundary: bool,
}

impl From<&Report> for Reached {
    fn from(report: &Report) -> Self {
        let ends = |range: &RangeInclusive<u32>| [*range.start(), *range.end()];
        let place = |violation: &Violation| Place {
            vertex: violation.vertex,
            position: violation.at.to_array(),
            degree: violation.degree,
            on_boundary: violation.is_boundary,
        };
        Self {
            triangles: report.triangles,
            interior_points: report.interior_points,
            min_angle: report.min_angle,
            max_angle: report.max_angle,
            min_angle_limit: report.angle_limit,
            min_angle_limit_at_any_degree: report.limits.angle_at_any_degree(),
            share_of_limit: report.share_of_limit,
            interior_degree: report.interior_degree.as_ref().map(ends),
            boundary_degree: ends(&report.boundary_degree),
            violations: report.violations.iter().map(place).collect(),
            area_ratio: report.area_ratio,
            grading_p99: report.grading_p99,
        }
    }
}

/// The limit of the minimum angle, and what lifts it.
#[derive(Serialize)]
pub(crate) struct Limit {
    pub(crate) min_angle: f64,
    /// What decides it, in words.
    pub(crate) cause: String,
    pub(crate) min_angle_at_any_degree: f64,
    pub(crate) cause_at_any_degree: String,
    /// A change of counts that lifts it; null if none of one place does.
    pub(crate) lift: Option<LiftRow>,
}

/// A change of counts, and the limit after it.
#[derive(Serialize)]
pub(crate) struct LiftRow {
    pub(crate) changes: Vec<SideCount>,
    pub(crate) min_angle: f64,
    pub(crate) cause: String,
}

/// The intervals of a side after a change; sides count from 1, through all rings.
#[derive(Serialize)]
pub(crate) struct SideCount {
    side: usize,
    by: i64,
    intervals: u64,
}

impl Limit {
    pub(crate) fn new(limit: &AngleLimit, lift: Option<&Lift>) -> Self {
        Self {
            min_angle: limit.min_angle,
            cause: limit.cause.to_string(),
            min_angle_at_any_degree: limit.min_angle_at_any_degree,
            cause_at_any_degree: limit.cause_at_any_degree.to_string(),
            lift: lift.map(LiftRow::from),
        }
    }
}

impl From<&Lift> for LiftRow {
    fn from(lift: &Lift) -> Self {
        let changes = lift.changes.iter().zip(&lift.intervals).map(|(change, &intervals)| {
            SideCount { side: change.side + 1, by: change.by, intervals }
        });
        let changes = changes.collect();
        Self { changes, min_angle: lift.min_angle, cause: lift.cause.to_string() }
    }
}

/// How much neighbouring triangles differ.
pub(crate) fn grading(report: &Report) -> String {
    format!(
        "Neighbouring triangles differ in area by a factor of {} at most; in size, by {} at the 99th \
         percentile.",
        four_digits(report.area_ratio),
        four_digits(report.grading_p99)
    )
}

/// The degrees that are demanded and not reached, in words: those wanted, and at the boundary those that the
/// domain limits. A default is no demand.
pub(crate) fn unmet_degrees(
    report: &Report,
    wanted: &Interior,
    has_degree_limits: bool,
) -> Option<String> {
    let mut demanded = report.clone();
    demanded.violations.retain(|violation| match violation.is_boundary {
        true => wanted.boundary_degree.is_some() || has_degree_limits,
        false => wanted.interior_degree.is_some(),
    });
    violations(&demanded)
}

/// The violations with their places, if there are any.
pub(crate) fn violations(report: &Report) -> Option<String> {
    const NAMED: usize = 5;
    let count = report.violations.len();
    let place = |violation: &Violation| {
        let [x, y] = violation.at.to_array();
        let where_ = if violation.is_boundary { "boundary" } else { "interior" };
        format!("vertex {} at ({x}, {y}) has {} ({where_})", violation.vertex, violation.degree)
    };
    let mut places: Vec<String> = report.violations.iter().take(NAMED).map(place).collect();
    if count > NAMED {
        places.push("…".to_owned());
    }
    let are = if count == 1 { "1 vertex has a degree" } else { "vertices have degrees" };
    let are = if count == 1 { are.to_owned() } else { format!("{count} {are}") };
    (count > 0).then(|| format!("{are} outside the range: {}", places.join(", ")))
}
