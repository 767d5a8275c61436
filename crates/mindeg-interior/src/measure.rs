//! Quality measures of a mesh, from its points and triangles alone.

use crate::goal::{Goal, MOST};
use crate::limits::Limits;
use crate::report::{
    CertifiedVertex, CornerTradeOff, ENOUGH, InteriorReport, LocalShares, TogetherBound, Violation,
    first_percentile, grading,
};
use crate::star::Stars;
use crate::together::Together;
use crate::triangle::{doubled_area, max_angle, min_angle};
use glam::DVec2;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

/// The wishes that a mesh is compared with, and the limits of its boundary.
pub(crate) struct Wanted<'a> {
    pub(crate) interior: RangeInclusive<u32>,
    /// The goals of vertices that stay.
    pub(crate) goals: &'a [Goal],
    pub(crate) stars: &'a Stars,
    pub(crate) limits: Limits,
    /// No limit of a place counts for more than this, in degrees.
    pub(crate) most: f64,
    /// Whether each triangle is to have a corner inside.
    pub(crate) corners_inside: bool,
}

/// Measures a mesh. `index` gives the index of a vertex among those that stay; `limits_at` the limits if vertices have
/// the degrees of these violations.
pub(crate) fn measure(
    points: &[DVec2],
    triangles: &[[u32; 3]],
    Wanted { interior, goals, stars, limits, most, corners_inside }: &Wanted<'_>,
    index_of: impl Fn(u32) -> u32,
    limits_at: impl Fn(&[Violation]) -> Limits,
) -> InteriorReport {
    let goal = |v: u32| goals.get(index_of(v) as usize);
    let corners = |t: &[u32; 3]| t.map(|v| points[v as usize]);
    let mut counts = vec![0_u32; points.len()];
    // The least angle of the triangles at each vertex that stays.
    let mut least_at = vec![60.0_f64; goals.len()];
    let (mut least, mut greatest) = ((f64::INFINITY, 0), 0.0_f64);
    let mut angles = Vec::with_capacity(triangles.len());
    let mut halves = Vec::with_capacity(3 * triangles.len());
    for (index, t) in triangles.iter().enumerate() {
        let angle = min_angle(corners(t));
        angles.push(angle);
        if angle < least.0 {
            least = (angle, index);
        }
        greatest = greatest.max(max_angle(corners(t)));
        for i in 0..3 {
            counts[t[i] as usize] += 1;
            if let Some(least) = least_at.get_mut(index_of(t[i]) as usize) {
                *least = angle.min(*least);
            }
            let (a, b) = (t[i], t[(i + 1) % 3]);
            halves.push((a.min(b), a.max(b), index as u32));
        }
    }
    halves.sort_unstable();
    let area = |t: u32| doubled_area(corners(&triangles[t as usize]));
    let mut ratios: Vec<f64> = halves
        .windows(2)
        .filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1))
        .map(|pair| area(pair[0].2) / area(pair[1].2))
        .map(|ratio| ratio.max(1.0 / ratio))
        .collect();
    let area_ratio = ratios.iter().copied().fold(1.0, f64::max);
    let grading_p99 = grading(&mut ratios);

    let (mut violations, mut certified) = (Vec::new(), Vec::new());
    let (mut boundary_vertices, mut at_least) = (0, 0);
    let mut inside: Option<(u32, u32)> = None;
    let mut boundary = (u32::MAX, 0);
    let mut interior_points = 0;
    let mut corner_list = Vec::new();
    let mut local = vec![*most; points.len()];
    let mut least_of_edges = f64::INFINITY;
    let together = together_bounds(points, &counts, goals, stars, &least_at, &index_of);
    for (vertex, count) in (0..).zip(counts).filter(|(_, count)| *count > 0) {
        let (at, own) = (points[vertex as usize], index_of(vertex));
        let (mut is_boundary, mut wanted) = (false, interior.clone());
        if let Some(goal) = goal(vertex) {
            is_boundary = goal.is_boundary;
            wanted = goal.least..=goal.wanted;
            let reached = match count > goal.wanted {
                true => stars.limit(own, Some(count)),
                false => goal.limit,
            };
            local[vertex as usize] = most.min(reached).min(goal.tents);
            if goal.tents < MOST {
                least_of_edges = least_of_edges.min(goal.tents);
            }
            let more = u32::from(is_boundary);
            let angle = |triangles| stars.limit(own, triangles).min(goal.tents);
            corner_list.extend(trade_off(count, goal.triangles, angle).map(|angles| {
                let angles = angles.into_iter().map(|(k, angle)| (k + more, angle)).collect();
                let (degree, degree_limit) = (count + more, goal.wanted + more);
                CornerTradeOff { vertex, at, degree, degree_limit, angles }
            }));
            let least = stars.least(own);
            at_least = at_least.max(least + more);
            boundary_vertices += u64::from(more);
            if least > goal.wanted {
                let named = |end: &u32| (0..points.len() as u32).find(|v| index_of(*v) == *end);
                let (degree_limit, least_degree) = (goal.wanted + more, least + more);
                let edges = stars.ends(own).iter().filter_map(named).collect();
                certified.push(CertifiedVertex { vertex, at, edges, degree_limit, least_degree });
            }
        }
        let degree = count + u32::from(is_boundary);
        if is_boundary {
            boundary = (boundary.0.min(degree), boundary.1.max(degree));
        } else {
            interior_points += 1;
            let (low, high) = inside.unwrap_or((count, count));
            inside = Some((low.min(count), high.max(count)));
        }
        if !wanted.contains(&count) {
            violations.push(Violation { vertex, at, degree, is_boundary });
        }
    }
    let used = (boundary_vertices + interior_points as u64) as i64;
    at_least = at_least.max(counted(boundary_vertices, used, &halves, triangles.len()));
    let breaks_limit = violations.iter().any(|violation| violation.is_boundary);
    let angle_limit = if breaks_limit { limits_at(&violations).angle() } else { limits.angle() };
    let angle_limit = angle_limit.min(least_of_edges);
    let (mut local, shares) = local_shares(triangles, &angles, &local, *most);
    local.at = points.get(local.vertex as usize).copied().unwrap_or_default();
    local.is_tent = goal(local.vertex).is_some_and(|goal| goal.tents <= local.limit);
    let is_at_boundary = |v: &u32| goal(*v).is_some_and(|goal| goal.is_boundary);
    let is_outside = |t: &&[u32; 3]| *corners_inside && t.iter().all(is_at_boundary);
    let outside = triangles.iter().filter(is_outside).count();
    InteriorReport {
        limits: *limits,
        min_angle: least.0,
        min_angle_vertex: triangles.get(least.1).map_or(0, |t| sharpest(t, corners(t))),
        angle_limit,
        least_of_edges,
        share_of_limit: (least.0 / angle_limit).min(1.0),
        local,
        corners: corner_list,
        max_angle: greatest,
        interior_degree: inside.map(|(low, high)| low..=high),
        boundary_degree: boundary.0..=boundary.1,
        violations,
        outside,
        certified,
        together,
        at_least,
        area_ratio,
        grading_p99,
        sizes: None,
        triangles: triangles.len(),
        interior_points,
        samples: [shares, ratios],
    }
}

/// The groups of vertices that no mesh with such angles brings nearer to their limits. `least_at`: the angles of vertices that stay.
fn together_bounds(
    points: &[DVec2],
    counts: &[u32],
    goals: &[Goal],
    stars: &Stars,
    least_at: &[f64],
    index_of: impl Fn(u32) -> u32,
) -> Vec<TogetherBound> {
    let mut names = vec![u32::MAX; goals.len()];
    let all = (0..points.len() as u32).map(|v| (v, index_of(v) as usize));
    all.for_each(|(v, index)| names.iter_mut().skip(index).take(1).for_each(|name| *name = v));
    let of_vertex = |name: &u32| counts.get(*name as usize).copied().unwrap_or(0);
    let own: Vec<u32> = names.iter().map(of_vertex).collect();
    let limits: Vec<u32> = goals.iter().map(|goal| goal.triangles).collect();
    if own.iter().zip(&limits).all(|(count, limit)| count <= limit) {
        return Vec::new();
    }
    let groups = Together::new(stars, least_at, &own, &limits).groups();
    let bound = |(group, share): (BTreeSet<u32>, f64)| {
        let excess = |v: &u32| own[*v as usize].saturating_sub(limits[*v as usize]);
        let ends = group.iter().flat_map(|v| stars.ends(*v));
        let ends = ends.filter(|v| (*v as usize) < names.len());
        let around: BTreeSet<u32> = group.iter().copied().chain(ends).collect();
        let name = |v: &u32| names[*v as usize];
        let mut angles: Vec<(u32, f64)> =
            around.iter().map(|v| (name(v), share * least_at[*v as usize])).collect();
        let mut vertices: Vec<u32> = group.iter().map(name).collect();
        vertices.sort_unstable();
        angles.sort_unstable_by_key(|own| own.0);
        let at = points[vertices[0] as usize];
        TogetherBound { more: group.iter().map(excess).sum(), vertices, at, share, angles }
    };
    groups.into_iter().map(bound).collect()
}

/// A maximum degree that no mesh with these boundary vertices is below: with fewer, its edges would have too many ends.
///
/// Every mesh of V vertices has 3V - 3c - b edges, where c is its Euler characteristic and b the number of its boundary edges, which
/// are the same in all. With D at every vertex, twice as many are at most DV: (6 - D)V <= 6c + 2b, which more vertices only
/// make harder. `halves` are the edges of the triangles of a mesh, sorted; `used` its vertices in triangles.
fn counted(boundary_vertices: u64, used: i64, halves: &[(u32, u32, u32)], triangles: usize) -> u32 {
    let ends = |half: &(u32, u32, u32)| (half.0, half.1);
    let edges = halves.chunk_by(|a, b| ends(a) == ends(b));
    let (mut all, mut border) = (0, 0);
    for halves in edges {
        all += 1;
        border += i64::from(halves.len() == 1);
    }
    let most = 6 * (used - all + triangles as i64) + 2 * border;
    let holds = |degree: &u32| i64::from(6 - degree) * boundary_vertices as i64 <= most;
    (2..6).find(holds).unwrap_or(6)
}

/// A greater angle counts if it is so many times as large.
const NOTABLE: f64 = 1.02;

/// The numbers of triangles of a vertex from its limit on with the greatest angle of each, if the limit costs angle that
/// counts. `angle`: the greatest with at most so many triangles.
fn trade_off(
    count: u32,
    limit: u32,
    angle: impl Fn(Option<u32>) -> f64,
) -> Option<Vec<(u32, f64)>> {
    let most = angle(None);
    let is_broken = count > limit;
    if !is_broken && most.min(ENOUGH) <= NOTABLE * angle(Some(limit)) {
        return None;
    }
    let mut angles = Vec::new();
    for triangles in limit..=u32::MAX {
        let reached = angle(Some(triangles));
        angles.push((triangles, reached));
        if reached >= most {
            break;
        }
    }
    Some(angles)
}

/// The shares of triangles with these angles, if vertices have these limits, of which at most `most` degrees count:
/// the measures, and all of them.
fn local_shares(
    triangles: &[[u32; 3]],
    angles: &[f64],
    limits: &[f64],
    most: f64,
) -> (LocalShares, Vec<f64>) {
    let limit = |v: &u32| limits[*v as usize];
    let mut worst = (f64::INFINITY, 0);
    let mut shares = Vec::with_capacity(angles.len());
    for (triangle, angle) in triangles.iter().zip(angles) {
        let [a, b, c] = triangle;
        let of =
            [b, c].into_iter().fold(a, |best, v| if limit(v) < limit(best) { v } else { best });
        let share = (angle / limit(of)).min(1.0);
        shares.push(share);
        if share < worst.0 {
            worst = (share, *of);
        }
    }
    let below = shares.iter().filter(|share| **share < 0.9).count();
    let percentile = first_percentile(&mut shares);
    let limit = limits.get(worst.1 as usize).copied().unwrap_or(most);
    let (at, is_tent) = (DVec2::ZERO, false);
    let worst_share = worst.0.min(1.0);
    let local = LocalShares {
        worst: worst_share,
        vertex: worst.1,
        at,
        limit,
        is_tent,
        most,
        percentile,
        below,
    };
    (local, shares)
}

/// The degree of each vertex of the boundary that breaks its limit, by its index there; 0 of others.
pub(crate) fn degrees_at_boundary(
    broken: &[Violation],
    index: impl Fn(u32) -> u32,
) -> impl Fn(u32) -> u32 {
    let own = broken.iter().filter(|violation| violation.is_boundary);
    let degrees: BTreeMap<u32, u32> = own.map(|own| (index(own.vertex), own.degree)).collect();
    move |vertex| degrees.get(&vertex).copied().unwrap_or(0)
}

/// The vertex opposite the shortest edge.
fn sharpest(triangle: &[u32; 3], corners: [DVec2; 3]) -> u32 {
    let opposite = |i: usize| corners[(i + 1) % 3].distance_squared(corners[(i + 2) % 3]);
    let i = (1..3).fold(0, |best, i| if opposite(i) < opposite(best) { i } else { best });
    triangle[i]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breaklines::Breaklines;
    use crate::limits::{FanLimit, fan_limit_at};
    use mindeg_mesh::planar::PlanarBoundary;

    #[test]
    fn figures_are_those_of_the_triangles() {
        // A triangle of area 2 beside one of area 8, whose least angle is at vertex 1.
        let points = [[2.0, 0.0], [6.0, 4.0], [2.0, 2.0], [0.0, 0.0]].map(DVec2::from);
        let fan = FanLimit { angle: 45.0, vertex: 0 };
        let limits = Limits { any_degree: fan, with_degree_limit: fan, tent: None };
        for turn in 0..3 {
            let mut triangles = [[3, 0, 2], [0, 1, 2]];
            triangles.iter_mut().for_each(|triangle| triangle.rotate_left(turn));
            let stars = Stars::default();
            let (most, corners_inside) = (ENOUGH, false);
            let wanted =
                Wanted { interior: 5..=7, goals: &[], stars: &stars, limits, most, corners_inside };
            let report = measure(&points, &triangles, &wanted, |v| v, |_| limits);
            let [small, large] = [libm::atan2(2.0, 4.0), libm::atan2(4.0, 4.0)];
            let least = (large - small).to_degrees();
            assert!((report.min_angle - least).abs() < 1e-9, "{report:?}");
            assert_eq!(report.min_angle_vertex, 1);
            assert!((report.share_of_limit - least / 45.0).abs() < 1e-12);
            assert!((report.max_angle - (90.0 + small.to_degrees())).abs() < 1e-9, "{report:?}");
            assert_eq!((report.area_ratio, report.grading_p99), (2.0, 2.0_f64.sqrt()));
            assert_eq!((report.triangles, report.interior_points), (2, 4));
            assert_eq!(report.violations.len(), 4);
        }
    }

    /// A mesh with 1.954° was said to have 129% of a limit of 1.509°.
    #[test]
    fn a_broken_degree_limit_is_compared_with_the_limit_of_its_degree() {
        let points = [[2.0, 0.0], [6.0, 4.0], [2.0, 2.0], [0.0, 0.0]].map(DVec2::from);
        let of = |angle| {
            let fan = FanLimit { angle, vertex: 0 };
            Limits { any_degree: fan, with_degree_limit: fan, tent: None }
        };
        // A corner of 60 degrees between edges of 1 and 10.
        let ring = [[0.0, 0.0], [10.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from);
        let outline = PlanarBoundary::new(&[ring]).unwrap();
        let stars = Stars::new(&outline, &Breaklines::default());
        let goal = Goal {
            is_boundary: true,
            least: 1,
            triangles: 1,
            wanted: 1,
            ideal: 1.0,
            fan: None,
            limit: 10.0,
            tents: 40.0,
            sine: 0.0,
        };
        let limits_at = |broken: &[Violation]| {
            assert_eq!([0, 1].map(degrees_at_boundary(broken, |vertex| vertex)), [3, 0]);
            of(30.0)
        };
        let triangles = [[3, 0, 2], [0, 1, 2]];
        let wanted = Wanted {
            interior: 1..=7,
            goals: &[goal],
            stars: &stars,
            limits: of(10.0),
            most: ENOUGH,
            corners_inside: false,
        };
        let report = measure(&points, &triangles, &wanted, |v| v, limits_at);
        assert_eq!((report.limits.angle(), report.angle_limit), (10.0, 30.0));
        assert_eq!(report.share_of_limit, report.min_angle / 30.0);
        assert!(report.share_of_limit < 1.0);
        // With 2 triangles where 1 is allowed: the angle of each degree up to the best, and the one at hand.
        let [corner] = &report.corners[..] else { panic!("{:?}", report.corners) };
        assert_eq!((corner.vertex, corner.degree, corner.degree_limit), (0, 3, 2));
        let angle = |triangles| fan_limit_at(&outline, 0, 1, Some(triangles));
        assert_eq!(corner.angles[..2], [(2, angle(1)), (3, angle(2))]);
        let best = fan_limit_at(&outline, 0, 1, None);
        assert_eq!(corner.angles.last().map(|(_, angle)| *angle), Some(best));
        assert_eq!((report.local.at, report.local.is_tent), (points[0], false));
    }

    #[test]
    fn a_degree_limit_that_costs_no_angle_has_no_table() {
        let angle = |triangles: Option<u32>| f64::from(triangles.unwrap_or(9).min(3) * 8);
        assert_eq!(trade_off(3, 3, angle), None);
        assert_eq!(trade_off(2, 2, angle), Some(vec![(2, 16.0), (3, 24.0)]));
        // Angles from 35 degrees on cost nothing.
        let wide = |triangles: Option<u32>| 17.6 * f64::from(triangles.unwrap_or(9).min(9));
        assert_eq!(trade_off(2, 2, wide), None);
    }
}
