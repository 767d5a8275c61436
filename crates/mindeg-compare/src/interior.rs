//! Meshes with interior points on one boundary: mindeg's beside a Delaunay refinement.
//!
//! Both are measured here, on their points and triangles alone.

use crate::{Method, NoTriangulation};
use glam::DVec2;
use mindeg::interior::{self, InteriorError, InteriorMesh, degree_limit};
use mindeg::quality::TriangleQuality;
use mindeg::{Domain, Interior, Progress};
use mindeg_delaunay::refined;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// A mesh with interior points in figures; what it does not have is null.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct InteriorFigures {
    /// The program that made the mesh.
    pub method: String,
    /// How.
    pub description: String,
    /// Why there is no mesh.
    pub failure: Option<String>,
    /// The number of triangles.
    pub triangles: Option<usize>,
    /// The number of vertices that are not on the boundary.
    pub interior_points: Option<usize>,
    /// The minimum angle in degrees.
    pub min_angle: Option<f64>,
    /// The maximum angle in degrees.
    pub max_angle: Option<f64>,
    /// The minimum angle over the greatest that the boundary allows at its degree limits.
    pub share_of_limit: Option<f64>,
    /// The greatest degree of an interior vertex; null without any.
    pub max_interior_degree: Option<u32>,
    /// The greatest degree of a boundary vertex.
    pub max_boundary_degree: Option<u32>,
    /// How many interior vertices have other degrees than 5 to 7, and boundary vertices more than 5
    /// edges, or at a reflex corner 2 + round(angle / 60 degrees), if that is more.
    pub violations: Option<usize>,
    /// The 99th percentile of the square root of the area ratio of neighbouring triangles.
    pub grading_p99: Option<f64>,
    /// The time it took.
    pub seconds: Option<f64>,
}

/// The angle that refinement aims at, in degrees.
const REFINED_TO: f64 = 30.0;
/// Refinement that has added this many points for each boundary point does not end.
const MOST_ADDED: usize = 1000;

/// mindeg's mesh with points inside, and the seconds that it took; or why there is none.
pub(crate) type Inside = Result<(InteriorMesh, f64), InteriorError>;

/// Puts points inside a domain.
pub(crate) fn inside(domain: &Domain, wanted: &Interior, time_limit: Duration) -> Inside {
    let start = Instant::now();
    let in_time = Progress::while_it(|| start.elapsed() < time_limit);
    let found = interior::mesh(domain, wanted, Progress::new(&in_time))?;
    Ok((found, start.elapsed().as_secs_f64()))
}

/// The positions of a mesh with points inside.
pub(crate) fn points(found: &InteriorMesh) -> Vec<DVec2> {
    found.mesh.positions().iter().map(|point| point.truncate()).collect()
}

/// mindeg's mesh with interior points and spade's refinement of the same boundary.
pub(crate) fn beside(
    domain: &Domain,
    inside: &Inside,
    time_limit: Duration,
) -> Vec<InteriorFigures> {
    let wanted = domain.interior().cloned().unwrap_or_default();
    let limit = interior::angle_limit(domain, &wanted).ok().map(|limit| limit.min_angle);
    vec![own(domain, limit, inside, time_limit), spade(domain, limit)]
}

fn own(
    domain: &Domain,
    limit: Option<f64>,
    inside: &Inside,
    time_limit: Duration,
) -> InteriorFigures {
    let named = InteriorFigures {
        method: Method::Inside.to_string(),
        description: Method::Inside.description().into_owned(),
        ..InteriorFigures::default()
    };
    match inside {
        Ok((found, seconds)) => {
            let figures = measured(domain, &points(found), found.mesh.triangles(), limit);
            InteriorFigures { seconds: Some(*seconds), ..with_names(named, figures) }
        }
        Err(error) => {
            let failure = match error {
                InteriorError::Cancelled(_) => {
                    NoTriangulation::TimeLimit { limit: time_limit }.to_string()
                }
                error => error.to_string(),
            };
            InteriorFigures { failure: Some(failure), ..named }
        }
    }
}

fn spade(domain: &Domain, limit: Option<f64>) -> InteriorFigures {
    let named = InteriorFigures {
        method: "Delaunay refinement (spade)".to_owned(),
        description: format!(
            "Points are added until no angle is below {REFINED_TO}°, but for those at the boundary, \
             whose edges are kept"
        ),
        ..InteriorFigures::default()
    };
    if domain.is_map() {
        let failure = "it takes no lines or points inside".to_owned();
        return InteriorFigures { failure: Some(failure), ..named };
    }
    let boundary = match domain.boundary() {
        Ok(boundary) => boundary,
        Err(faults) => return InteriorFigures { failure: Some(faults.to_string()), ..named },
    };
    let start = Instant::now();
    match refined(&boundary, REFINED_TO, MOST_ADDED * boundary.points().len()) {
        Ok(found) if found.is_complete => {
            let seconds = Some(start.elapsed().as_secs_f64());
            let figures = measured(domain, &found.points, &found.triangles, limit);
            InteriorFigures { seconds, ..with_names(named, figures) }
        }
        Ok(_) => {
            let failure =
                format!("it did not end with {MOST_ADDED} points for each boundary point");
            InteriorFigures { failure: Some(failure), ..named }
        }
        Err(error) => InteriorFigures { failure: Some(error.to_string()), ..named },
    }
}

fn with_names(named: InteriorFigures, figures: InteriorFigures) -> InteriorFigures {
    InteriorFigures { method: named.method, description: named.description, ..figures }
}

/// Measures a mesh whose first vertices are the boundary's.
fn measured(
    domain: &Domain,
    points: &[DVec2],
    triangles: &[[u32; 3]],
    limit: Option<f64>,
) -> InteriorFigures {
    let rings = domain.rings();
    let boundary = rings.vertex_count() as usize;
    let at = |v: u32| points[v as usize];
    let quality = |t: &[u32; 3]| TriangleQuality::of(at(t[0]), at(t[1]), at(t[2]));
    let least = triangles.iter().map(|t| quality(t).min_angle).fold(180.0, f64::min);
    let greatest = triangles.iter().map(|t| quality(t).max_angle).fold(0.0, f64::max);

    let mut sides: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (index, [a, b, c]) in triangles.iter().enumerate() {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            sides.entry([from.min(to), from.max(to)]).or_default().push(index);
        }
    }
    let mut degrees = vec![0_u32; points.len()];
    let mut ratios = Vec::new();
    for (edge, owners) in &sides {
        edge.iter().for_each(|v| degrees[*v as usize] += 1);
        if let [first, second] = owners[..] {
            let ratio = quality(&triangles[first]).area / quality(&triangles[second]).area;
            ratios.push(ratio.max(1.0 / ratio).sqrt());
        }
    }
    ratios.sort_unstable_by(f64::total_cmp);
    let allowed = |vertex: u32| {
        let [before, after] = [rings.previous(vertex), rings.next(vertex)].map(at);
        let (u, v) = (after - at(vertex), before - at(vertex));
        let angle = libm::atan2(u.perp_dot(v), u.dot(v));
        degree_limit(if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }, 5)
    };
    let (outside, inside) = degrees.split_at(boundary);
    let too_many = (0..).zip(outside).filter(|&(v, degree)| *degree > allowed(v)).count();
    let used = || inside.iter().copied().filter(|degree| *degree > 0);
    InteriorFigures {
        triangles: Some(triangles.len()),
        interior_points: Some(used().count()),
        min_angle: Some(least),
        max_angle: Some(greatest),
        share_of_limit: limit.map(|limit| least / limit),
        max_interior_degree: used().max(),
        max_boundary_degree: outside.iter().copied().max(),
        violations: Some(too_many + used().filter(|degree| !(5..=7).contains(degree)).count()),
        grading_p99: ratios.get(ratios.len().saturating_sub(1) * 99 / 100).copied(),
        ..InteriorFigures::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Side;

    #[test]
    fn both_meshes_are_measured() {
        let domain = Domain::rectangle(4.0, 3.0, [16, 12, 16, 3].map(Side::count).into()).unwrap();
        let minute = Duration::from_secs(60);
        let found = inside(&domain, &Interior::default(), minute);
        let [own, spade] = &beside(&domain, &found, minute)[..] else { panic!("two") };
        assert_eq!((own.violations, own.max_boundary_degree), (Some(0), Some(5)), "{own:?}");
        assert!(own.share_of_limit > Some(0.95) && own.share_of_limit <= Some(1.0 + 1e-9));
        assert!(spade.min_angle < own.min_angle, "{spade:?}");
        assert!(spade.triangles > Some(40) && spade.failure.is_none());
    }

    #[test]
    fn what_is_late_says_so() {
        let domain = Domain::rectangle(4.0, 3.0, [16, 12, 16, 3].map(Side::count).into()).unwrap();
        let late = inside(&domain, &Interior::default(), Duration::ZERO);
        let own = &beside(&domain, &late, Duration::ZERO)[0];
        assert!(own.failure.as_ref().is_some_and(|text| text.contains("time limit")), "{own:?}");
        assert_eq!(own.triangles, None);
    }

    #[test]
    fn figures_are_those_of_the_triangles() {
        let measured = |corners: &str, inner: [f64; 2], triangles: &[[u32; 3]]| {
            let text = format!(r#"{{"polygon": {{"corners": {corners}}}, "size": 99}}"#);
            let domain = Domain::from_json(&text).unwrap();
            let points: Vec<DVec2> = domain.placement().points().chain([inner.into()]).collect();
            measured(&domain, &points, triangles, Some(90.0))
        };
        // Areas of 4, 6, 4 and 2 round the inner point: ratios of 1.5, 1.5, 2 and 2.
        let found = measured(
            "[[1,1],[5,1],[5,5],[1,5]]",
            [2.0, 3.0],
            &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
        );
        assert_eq!((found.triangles, found.interior_points), (Some(4), Some(1)));
        assert_eq!((found.max_interior_degree, found.max_boundary_degree), (Some(4), Some(3)));
        assert_eq!(found.violations, Some(1), "an inner degree of 4");
        assert_eq!(found.grading_p99, Some(2.0_f64.sqrt()));
        assert_eq!(found.share_of_limit, found.min_angle.map(|angle| angle / 90.0));

        // A corner of nearly a whole turn may have 8 edges; it has 6 here.
        let corners = "[[5,5],[7,4],[7,7],[3,7],[3,3],[7,3],[7,3.5]]";
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6]];
        let found = measured(corners, [9.0, 9.0], &fan);
        assert_eq!((found.max_boundary_degree, found.violations), (Some(6), Some(0)));
        assert_eq!((found.interior_points, found.max_interior_degree), (Some(0), None));
    }
}
