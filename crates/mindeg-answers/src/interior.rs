//! The properties of a mesh with interior points.

use crate::condition::placed;
use crate::names::{NAMED, listed};
use crate::numbers::{number, percent, steady_angle};
use crate::proven::{TogetherAnswer, certified, together};
use mindeg::interior::{
    CertifiedVertex, CoarseSide, CornerTradeOff, InteriorMesh, InteriorReport, LocalShares,
    SizeReport, Violation,
};
use mindeg::{Interior, Projection};
use serde::Serialize;
use std::cmp::Ordering;
use std::ops::RangeInclusive;

/// Angles beyond are found on no ordinary boundary, in degrees.
const MOST_SOUGHT: f64 = 45.0;
/// So many degrees of a vertex have their angles in the text; JSON has all.
const MOST_DEGREES: usize = 8;
/// The share of the limit that another search can be asked for.
const ALL_BUT: f64 = 0.95;

/// The results of a mesh with interior points; angles are in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct InteriorAnswer {
    /// Triangles.
    pub triangles: usize,
    /// Vertices that are not on the boundary.
    pub interior_points: usize,
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// Null where it is not known; no mesh has less than `at_least`.
    pub least_max_degree: Option<u32>,
    /// No mesh of the boundary and the lines has a smaller maximum degree, whatever points are inside.
    pub at_least: u32,
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
    /// The angles of all triangles beside the limits of their places.
    pub local: LocalAnswer,
    /// Vertices on the boundary and on lines whose degree limit costs angle.
    pub corners: Vec<CornerAnswer>,
    /// The least and the greatest; null without interior vertices.
    pub interior_degree: Option<[u32; 2]>,
    /// The least and the greatest.
    pub boundary_degree: [u32; 2],
    /// Vertices whose degree is out of its range.
    pub violations: Vec<Violation>,
    /// Of these vertices, the ones that are in every mesh, with the edges that prove it.
    pub certified: Vec<CertifiedVertex>,
    /// Groups with others of these vertices, which no mesh brings nearer to their degree limits unless an angle there is smaller.
    pub together: Vec<TogetherAnswer>,
    /// The greatest ratio of the areas of two triangles with a common edge.
    pub area_ratio: f64,
    /// The 99th percentile of the square root of that ratio.
    pub grading_p99: f64,
    /// The edges inside beside the sizes wanted; null for a mesh that was improved.
    pub sizes: Option<SizeReport>,
    /// The sides and lines whose edges are longer than the sizes asked for there, the worst first.
    pub coarse_sides: Vec<CoarseSide>,
}

/// The angles of all triangles beside the limits of their places, of which at most [`LocalShares::most`] degrees count.
#[derive(Clone, Debug, Serialize)]
pub struct LocalAnswer {
    /// The least share that a triangle has of its limit, at most 1.
    worst: f64,
    /// The vertex that decides that limit.
    vertex: u32,
    position: [f64; 2],
    limit: f64,
    /// `corner`: the edges at the vertex; `gap`: edges that face each other; `none`: [`LocalShares::most`].
    decided_by: &'static str,
    /// The 1st percentile of the shares.
    percentile_1: f64,
    /// The number of triangles with a share below 0.9.
    below_90: usize,
}

/// A vertex on the boundary or a line whose degree limit costs angle.
#[derive(Clone, Debug, Serialize)]
pub struct CornerAnswer {
    vertex: u32,
    position: [f64; 2],
    degree: u32,
    degree_limit: u32,
    /// The greatest minimum angle at the vertex with each degree from the limit on.
    angles: Vec<AngleOfDegree>,
}

#[derive(Clone, Debug, Serialize)]
struct AngleOfDegree {
    degree: u32,
    min_angle: f64,
}

impl From<&LocalShares> for LocalAnswer {
    fn from(local: &LocalShares) -> Self {
        Self {
            worst: local.worst,
            vertex: local.vertex,
            position: local.at.to_array(),
            limit: local.limit,
            decided_by: decided_by(local),
            percentile_1: local.percentile,
            below_90: local.below,
        }
    }
}

impl From<&CornerTradeOff> for CornerAnswer {
    fn from(corner: &CornerTradeOff) -> Self {
        let angle = |&(degree, min_angle): &(u32, f64)| AngleOfDegree { degree, min_angle };
        Self {
            vertex: corner.vertex,
            position: corner.at.to_array(),
            degree: corner.degree,
            degree_limit: corner.degree_limit,
            angles: corner.angles.iter().map(angle).collect(),
        }
    }
}

fn decided_by(local: &LocalShares) -> &'static str {
    match local {
        LocalShares { is_tent: true, .. } => "gap",
        LocalShares { limit, most, .. } if limit < most => "corner",
        _ => "none",
    }
}

/// A vertex in space whose degree is out of its range.
#[derive(Clone, Debug, Serialize)]
pub struct DegreeViolation {
    pub(crate) vertex: u32,
    pub(crate) position: [f64; 3],
    pub(crate) degree: u32,
    pub(crate) on_boundary: bool,
}

impl From<&InteriorReport> for InteriorAnswer {
    fn from(report: &InteriorReport) -> Self {
        let ends = |range: &RangeInclusive<u32>| [*range.start(), *range.end()];
        let interior_degree = report.interior_degree.as_ref().map(ends);
        let boundary_degree = ends(&report.boundary_degree);
        let max_degree = interior_degree.map_or(0, |[_, most]| most).max(boundary_degree[1]);
        Self {
            triangles: report.triangles,
            interior_points: report.interior_points,
            max_degree,
            least_max_degree: (max_degree <= report.at_least).then_some(report.at_least),
            at_least: report.at_least,
            min_angle: report.min_angle,
            max_angle: report.max_angle,
            angle_limit: report.angle_limit,
            angle_limit_at_any_degree: report.limits.angle_at_any_degree(),
            share_of_limit: report.share_of_limit,
            local: LocalAnswer::from(&report.local),
            corners: report.corners.iter().map(CornerAnswer::from).collect(),
            interior_degree,
            boundary_degree,
            violations: report.violations.clone(),
            certified: report.certified.clone(),
            together: report.together.iter().map(TogetherAnswer::from).collect(),
            area_ratio: report.area_ratio,
            grading_p99: report.grading_p99,
            sizes: report.sizes.clone(),
            coarse_sides: Vec::new(),
        }
    }
}

impl From<&InteriorMesh> for InteriorAnswer {
    fn from(found: &InteriorMesh) -> Self {
        Self { coarse_sides: found.coarse_sides.clone(), ..Self::from(&found.report) }
    }
}

/// Angles and degrees in a line.
#[must_use]
pub fn angles_and_degrees(report: &InteriorReport) -> String {
    let degrees = |range: &RangeInclusive<u32>| match (range.start(), range.end()) {
        (least, greatest) if least == greatest => least.to_string(),
        (least, greatest) => format!("{least} to {greatest}"),
    };
    let inside = report.interior_degree.as_ref().map(|range| format!("{} inside", degrees(range)));
    // A mesh that is joined at all its sides has no boundary.
    let has_boundary = *report.boundary_degree.end() > 0;
    let boundary = format!("{} at the boundary", degrees(&report.boundary_degree));
    let degrees = [inside, has_boundary.then_some(boundary)];
    let degrees = degrees.into_iter().flatten().collect::<Vec<_>>().join(", ");
    let (limit, of_boundary) = (report.angle_limit, report.limits.angle());
    let at_degrees = match limit.total_cmp(&of_boundary) {
        Ordering::Greater => format!(", {} at the degrees of this mesh", steady_angle(limit)),
        Ordering::Less => format!(", {} by edges near each other", steady_angle(limit)),
        Ordering::Equal => String::new(),
    };
    format!(
        "angles {} ({} of the limit{at_degrees}) to {}; degrees {degrees}",
        steady_angle(report.min_angle),
        percent(report.share_of_limit),
        steady_angle(report.max_angle),
    )
}

/// That a search for a larger minimum angle was not asked for, where the boundary allows one: a hint, and how to ask.
#[must_use]
pub fn more_on_request(report: &InteriorReport, target: Option<f64>) -> Option<String> {
    let sought = libm::floor(ALL_BUT * report.angle_limit.min(MOST_SOUGHT));
    // Below, the search did not find what it aims at.
    let is_open = target.is_none() && report.min_angle >= LocalShares::MOST;
    (is_open && sought > report.min_angle + 1.0).then(|| {
        format!(
            "hint: no more than {}° is asked for; --target-angle {sought} looks for more",
            LocalShares::MOST
        )
    })
}

/// How much neighbouring triangles differ, in a sentence.
#[must_use]
pub fn grading(report: &InteriorReport) -> String {
    format!(
        "Neighbouring triangles differ in area by a factor of {} at most; in size, by {} at the 99th \
         percentile.",
        number(report.area_ratio),
        number(report.grading_p99)
    )
}

/// The triangles beside the limits of their places, in a sentence.
#[must_use]
pub fn local_limits(report: &InteriorReport, projection: Option<&Projection>) -> String {
    let local = &report.local;
    if local.worst > 0.9995 {
        return format!("Each triangle reaches the limit of its place (at most {}°).", local.most);
    }
    let place = placed(projection, local.at);
    let decides = match decided_by(local) {
        "gap" => ", decided by a gap",
        "corner" => ", decided by the edges there",
        _ => "",
    };
    let below = match local.below {
        0 => "none is".to_owned(),
        1 => "1 is".to_owned(),
        count => format!("{count} are"),
    };
    format!(
        "Of the limit of its place (at most {}°) each triangle reaches {} or more, the least at vertex {} at {place} \
         (limit {}{decides}); 99 of 100 reach {}; {below} below 90%.",
        local.most,
        percent(local.worst),
        local.vertex,
        steady_angle(local.limit),
        percent(local.percentile),
    )
}

/// The corners whose degree limits cost angle with their tables, if there are any.
#[must_use]
pub fn corners(report: &InteriorReport, projection: Option<&Projection>) -> Option<String> {
    let row = |(degree, angle): &(u32, f64)| format!("{} with {degree}", steady_angle(*angle));
    let table = |corner: &CornerTradeOff| {
        let mut rows: Vec<String> = corner.angles.iter().map(row).collect();
        if rows.len() > MOST_DEGREES {
            rows.splice(MOST_DEGREES - 1..rows.len() - 1, ["…".to_owned()]);
        }
        format!(
            "  vertex {} at {} has {} edges: {}",
            corner.vertex,
            placed(projection, corner.at),
            corner.degree,
            rows.join(", ")
        )
    };
    let mut lines = match report.corners.len() {
        0 => return None,
        1 => {
            vec!["A degree limit costs angle. The largest angle by the number of edges:".to_owned()]
        }
        count => vec![format!(
            "{count} degree limits cost angle. The largest angles by the number of edges:"
        )],
    };
    // The least angle within the limit first.
    let mut order: Vec<&CornerTradeOff> = report.corners.iter().collect();
    let least = |corner: &CornerTradeOff| corner.angles.first().map_or(0.0, |first| first.1);
    order.sort_by(|a, b| least(a).total_cmp(&least(b)));
    lines.extend(order.iter().take(NAMED).map(|corner| table(corner)));
    if order.len() > NAMED {
        lines.push("  …".to_owned());
    }
    Some(lines.join("\n"))
}

/// The violations with their places, and which of them are in every mesh, if there are any.
#[must_use]
pub fn violations(report: &InteriorReport, projection: Option<&Projection>) -> Option<String> {
    let text = named(report.violations.iter(), projection).into_iter().chain(outside(report));
    let text = text.reduce(|all, one| format!("{all}. {one}"))?;
    let proofs = certified(report, projection).into_iter().chain(together(report, projection));
    Some(proofs.fold(text, |text, proof| format!("{text}. {proof}")))
}

/// The degrees that are demanded and not reached, in words: those wanted, and at the boundary those that the
/// domain limits; and the triangles without a corner inside, where each is to have one. A default value demands nothing.
#[must_use]
pub fn unmet_degrees(
    report: &InteriorReport,
    wanted: &Interior,
    has_degree_limits: bool,
    projection: Option<&Projection>,
) -> Option<String> {
    let is_demanded = |violation: &&Violation| match violation.is_boundary {
        true => wanted.boundary_degree.is_some() || has_degree_limits,
        false => wanted.interior_degree.is_some(),
    };
    let unmet = named(report.violations.iter().filter(is_demanded), projection);
    let all: Vec<String> = unmet.into_iter().chain(outside(report)).collect();
    (!all.is_empty()).then(|| all.join("; "))
}

/// The triangles that have no corner inside, in words.
fn outside(report: &InteriorReport) -> Option<String> {
    let are = match report.outside {
        0 => return None,
        1 => "1 triangle has".to_owned(),
        count => format!("{count} triangles have"),
    };
    Some(format!(
        "{are} all corners at the boundary; where it is narrow, shorter edges there make room for points inside"
    ))
}

fn named<'a>(
    violations: impl Iterator<Item = &'a Violation>,
    projection: Option<&Projection>,
) -> Option<String> {
    let place = |violation: &Violation| {
        let kind = if violation.is_boundary { "boundary" } else { "interior" };
        let at = placed(projection, violation.at);
        format!("vertex {} at {at} has {} ({kind})", violation.vertex, violation.degree)
    };
    let violations: Vec<&Violation> = violations.collect();
    let are = match violations.len() {
        0 => return None,
        1 => "1 vertex has a degree".to_owned(),
        count => format!("{count} vertices have degrees"),
    };
    Some(format!("{are} outside the range: {}", listed(violations.into_iter().map(place), ", ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::interior::TogetherBound;
    use mindeg::{Domain, Progress, interior};

    fn report(json: &str) -> InteriorReport {
        let domain = Domain::from_json(json).unwrap();
        interior::mesh(&domain, &Interior::default(), Progress::NONE).unwrap().report
    }

    #[test]
    fn a_corner_that_must_choose_has_its_table() {
        // One interval of 10 beside one of 0.1: six edges at their corner would allow more than five.
        let report = report(
            r#"{"rectangle": {"width": 10, "height": 10},
                "sides": [{"intervals": 1}, {"intervals": 3}, {"intervals": 3}, {"intervals": 100}]}"#,
        );
        let text = corners(&report, None).unwrap();
        assert!(text.starts_with("2 degree limits cost angle."), "{text}");
        assert!(text.contains("has 5 edges: 9.702° with 5, 11.199° with 6"), "{text}");
        let json = serde_json::to_value(InteriorAnswer::from(&report)).unwrap();
        assert_eq!(json["corners"][0]["angles"][0]["degree"], 5);
        assert!(json["local"]["worst"].as_f64().unwrap() <= 1.0);
        assert!(json["share_of_limit"].as_f64().unwrap() <= 1.0);
    }

    #[test]
    fn a_degree_that_no_mesh_keeps_is_told_with_its_proof() {
        let line = |turn: u32| {
            let (y, x) = f64::from(turn * 40).to_radians().sin_cos();
            format!(r#"{{"points": [[0, 0], [{x}, {y}]]}}"#)
        };
        let lines: Vec<String> = (0..9).map(line).collect();
        let lines = lines.join(", ");
        let domain = r#"{"polygon": {"corners": [[-9, -9], [9, -9], [9, 9], [-9, 9]]}, "size": 3"#;
        let report = report(&format!(r#"{domain}, "lines": [{lines}]}}"#));
        let text = violations(&report, None).unwrap();
        let center = report.certified[0].vertex;
        let proof = format!(
            ". No mesh keeps the degree limit of 1 vertex: vertex {center} at (0, 0), where 9 edges meet that \
             stay, has 9 or more (limit 7)"
        );
        assert!(text.ends_with(&proof), "{text}");
        let json = serde_json::to_value(InteriorAnswer::from(&report)).unwrap();
        assert_eq!(json["certified"][0]["least_degree"], 9);
        assert_eq!(json["certified"][0]["edges"].as_array().unwrap().len(), 9);
    }

    #[test]
    fn degrees_that_exclude_each_other_are_told_with_the_angles() {
        let mut report = report(r#"{"rectangle": {"width": 4, "height": 4}, "size": 1}"#);
        let at = [1.0, 2.0].into();
        report.violations = vec![Violation { vertex: 3, at, degree: 8, is_boundary: false }];
        let angles = vec![(3, 10.0), (4, 12.0)];
        report.together =
            vec![TogetherBound { vertices: vec![3, 4], at, more: 1, share: 0.5, angles }];
        let text = violations(&report, None).unwrap();
        let proof = ". No mesh with so much of the angles there has fewer edges above the limits: \
                     1 at vertices 3 and 4 at (1, 2) (with 50%)";
        assert!(text.ends_with(proof), "{text}");
        let json = serde_json::to_value(InteriorAnswer::from(&report)).unwrap();
        assert_eq!(json["together"][0]["angles"][1]["min_angle"], 12.0);
        assert_eq!(
            (&json["together"][0]["more"], &json["together"][0]["share"]),
            (&1.into(), &0.5.into())
        );
    }

    #[test]
    fn limits_of_places_are_told_in_a_sentence() {
        let square = r#"{"rectangle": {"width": 4, "height": 4}, "size": 1}"#;
        let mut report = report(square);
        assert_eq!(corners(&report, None), None);
        assert_eq!(
            local_limits(&report, None),
            "Each triangle reaches the limit of its place (at most 35°)."
        );
        report.local.most = 40.0;
        assert!(local_limits(&report, None).ends_with("(at most 40°)."));
        report.local.worst = 0.5;
        report.local.limit = 20.0;
        report.local.below = 2;
        let text = local_limits(&report, None);
        assert!(text.contains("reaches 50% or more") && text.contains("2 are below 90%"), "{text}");
        assert!(text.contains("(limit 20.000°, decided by the edges there)"), "{text}");
        report.local.is_tent = true;
        assert!(local_limits(&report, None).contains("decided by a gap"));
    }
}
