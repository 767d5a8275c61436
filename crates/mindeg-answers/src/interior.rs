//! The properties of a mesh with interior points.

use crate::numbers::{four_digits, percent, steady_angle};
use mindeg::Interior;
use mindeg::interior::{InteriorReport, Violation};
use serde::Serialize;
use std::ops::RangeInclusive;

/// How many violations a text names.
const NAMED: usize = 5;

/// The results of a mesh with interior points; angles are in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct InteriorAnswer {
    /// Triangles.
    pub triangles: usize,
    /// Vertices that are not on the boundary.
    pub interior_points: usize,
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// The minimum angle of all triangles.
    pub min_angle: f64,
    /// The maximum angle of all triangles.
    pub max_angle: f64,
    /// The largest minimum angle that the boundary allows, at its degree limits and at the degrees of
    /// vertices that break theirs.
    pub angle_limit: f64,
    /// The largest at any degree.
    pub angle_limit_at_any_degree: f64,
    /// The minimum angle over its limit.
    pub share_of_limit: f64,
    /// The least and the greatest; null without interior vertices.
    pub interior_degree: Option<[u32; 2]>,
    /// The least and the greatest.
    pub boundary_degree: [u32; 2],
    /// Vertices whose degree is out of its range.
    pub violations: Vec<DegreeViolation>,
    /// The greatest ratio of the areas of two triangles with a common edge.
    pub area_ratio: f64,
    /// The 99th percentile of the square root of that ratio.
    pub grading_p99: f64,
}

/// A vertex whose degree is out of its range.
#[derive(Clone, Debug, Serialize)]
pub struct DegreeViolation {
    vertex: u32,
    position: [f64; 2],
    degree: u32,
    on_boundary: bool,
}

impl From<&InteriorReport> for InteriorAnswer {
    fn from(report: &InteriorReport) -> Self {
        let ends = |range: &RangeInclusive<u32>| [*range.start(), *range.end()];
        let violation = |violation: &Violation| DegreeViolation {
            vertex: violation.vertex,
            position: violation.at.to_array(),
            degree: violation.degree,
            on_boundary: violation.is_boundary,
        };
        let interior_degree = report.interior_degree.as_ref().map(ends);
        let boundary_degree = ends(&report.boundary_degree);
        Self {
            triangles: report.triangles,
            interior_points: report.interior_points,
            max_degree: interior_degree.map_or(0, |[_, most]| most).max(boundary_degree[1]),
            min_angle: report.min_angle,
            max_angle: report.max_angle,
            angle_limit: report.angle_limit,
            angle_limit_at_any_degree: report.limits.angle_at_any_degree(),
            share_of_limit: report.share_of_limit,
            interior_degree,
            boundary_degree,
            violations: report.violations.iter().map(violation).collect(),
            area_ratio: report.area_ratio,
            grading_p99: report.grading_p99,
        }
    }
}

/// Angles and degrees in a line.
#[must_use]
pub fn angles_and_degrees(report: &InteriorReport) -> String {
    let degrees = |range: &RangeInclusive<u32>| match (range.start(), range.end()) {
        (least, greatest) if least == greatest => least.to_string(),
        (least, greatest) => format!("{least} to {greatest}"),
    };
    let inside = match &report.interior_degree {
        Some(range) => format!("{} inside, ", degrees(range)),
        None => String::new(),
    };
    let at_degrees = match report.angle_limit > report.limits.angle() {
        true => format!(", {} at the degrees of this mesh", steady_angle(report.angle_limit)),
        false => String::new(),
    };
    format!(
        "angles {} ({} of the limit{at_degrees}) to {}; degrees {inside}{} at the boundary",
        steady_angle(report.min_angle),
        percent(report.share_of_limit),
        steady_angle(report.max_angle),
        degrees(&report.boundary_degree),
    )
}

/// How much neighbouring triangles differ, in a sentence.
#[must_use]
pub fn grading(report: &InteriorReport) -> String {
    format!(
        "Neighbouring triangles differ in area by a factor of {} at most; in size, by {} at the 99th \
         percentile.",
        four_digits(report.area_ratio),
        four_digits(report.grading_p99)
    )
}

/// The violations with their places, if there are any.
#[must_use]
pub fn violations(report: &InteriorReport) -> Option<String> {
    named(report.violations.iter())
}

/// The degrees that are demanded and not reached, in words: those wanted, and at the boundary those that the
/// domain limits. A default value demands nothing.
#[must_use]
pub fn unmet_degrees(
    report: &InteriorReport,
    wanted: &Interior,
    has_degree_limits: bool,
) -> Option<String> {
    named(report.violations.iter().filter(|violation| match violation.is_boundary {
        true => wanted.boundary_degree.is_some() || has_degree_limits,
        false => wanted.interior_degree.is_some(),
    }))
}

fn named<'a>(violations: impl Iterator<Item = &'a Violation>) -> Option<String> {
    let place = |violation: &Violation| {
        let [x, y] = violation.at.to_array().map(four_digits);
        let kind = if violation.is_boundary { "boundary" } else { "interior" };
        format!("vertex {} at ({x}, {y}) has {} ({kind})", violation.vertex, violation.degree)
    };
    let mut places: Vec<String> = violations.map(place).collect();
    let are = match places.len() {
        0 => return None,
        1 => "1 vertex has a degree".to_owned(),
        count => format!("{count} vertices have degrees"),
    };
    if places.len() > NAMED {
        places.truncate(NAMED);
        places.push("…".to_owned());
    }
    Some(format!("{are} outside the range: {}", places.join(", ")))
}
