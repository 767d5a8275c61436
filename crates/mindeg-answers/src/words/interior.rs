//! What a mesh with interior points is like.

use std::ops::RangeInclusive;

use mindeg::interior::Report;

use crate::numbers::{percent, steady_angle};

/// Angles and degrees in a line.
#[must_use]
pub fn angles_and_degrees(report: &Report) -> String {
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
