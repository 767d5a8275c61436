//! Meshes of maps from their points alone, beside all triangulations of small ones, and their checks.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};
use mindeg::exact::{DegreeBound, degree, degree_with, trade_off};
use mindeg::verify::{self, Optimality};
use mindeg::{
    Domain, Goal, InnerPoint, Inside, Outline, Progress, Ring, Side, TriMesh, Triangles, mesh,
};
use proptest::prelude::*;

/// Twice the area of a triangle of whole coordinates, positive if it is counter-clockwise.
fn area(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i32 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// A map of whole coordinates: a ring, points inside, and edges of lines.
#[derive(Clone, Debug)]
struct Small {
    points: Vec<[i32; 2]>,
    on_ring: usize,
    lines: Vec<[usize; 2]>,
}

impl Small {
    fn ring_edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        (0..self.on_ring).map(|v| [v, (v + 1) % self.on_ring])
    }

    /// Whether two edges have an inner point of one of them in common.
    fn meet(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> bool {
        let [p, q, r, s] = [a, b, c, d].map(|v| self.points[v]);
        let crosses = area(p, q, r).signum() * area(p, q, s).signum() < 0
            && area(r, s, p).signum() * area(r, s, q).signum() < 0;
        crosses || self.passes([a, b]) || self.passes([c, d])
    }

    /// Whether an edge passes a point.
    fn passes(&self, [a, b]: [usize; 2]) -> bool {
        let [p, q] = [a, b].map(|v| self.points[v]);
        let between = |v: usize| {
            let r = self.points[v];
            v != a
                && v != b
                && area(p, q, r) == 0
                && (0..2).all(|i| p[i].min(q[i]) <= r[i] && r[i] <= p[i].max(q[i]))
        };
        (0..self.points.len()).any(between)
    }

    /// Whether the middle of a pair of points is inside the ring.
    fn is_inside(&self, [a, b]: [usize; 2]) -> bool {
        let [p, q] = [a, b].map(|v| self.points[v]);
        // In twice the coordinates; the middle of a free chord is on no edge.
        let middle = [p[0] + q[0], p[1] + q[1]];
        let crossings = self.ring_edges().filter(|&edge| {
            let [from, to] = edge.map(|v| self.points[v].map(|x| 2 * x));
            let is_up = from[1] <= middle[1] && middle[1] < to[1];
            let is_down = to[1] <= middle[1] && middle[1] < from[1];
            let left = area(from, to, middle);
            is_up && left > 0 || is_down && left < 0
        });
        crossings.count() % 2 == 1
    }

    /// The chords that a triangulation may have.
    fn chords(&self) -> Vec<[usize; 2]> {
        let is_fixed = |pair: [usize; 2]| {
            let same = |edge: [usize; 2]| edge == pair || [edge[1], edge[0]] == pair;
            self.ring_edges().chain(self.lines.iter().copied()).any(same)
        };
        let is_free = |pair: &[usize; 2]| {
            !is_fixed(*pair)
                && !self.passes(*pair)
                && self.is_inside(*pair)
                && !self.ring_edges().chain(self.lines.iter().copied()).any(|e| self.meet(*pair, e))
        };
        let n = self.points.len();
        (0..n).flat_map(|a| (a + 1..n).map(move |b| [a, b])).filter(is_free).collect()
    }

    /// The least maximum degree of all triangulations.
    fn least_degree(&self) -> u32 {
        let chords = self.chords();
        let mut degrees = vec![0; self.points.len()];
        self.ring_edges().chain(self.lines.iter().copied()).flatten().for_each(|v| degrees[v] += 1);
        // By Euler's formula: n + 2 i - 2 triangles, and 3 edges for each, two triangles for each inner edge.
        let inner = self.points.len() - self.on_ring;
        let triangles = self.on_ring + 2 * inner - 2;
        let needed = (3 * triangles - self.on_ring) / 2 - self.lines.len();
        (2..)
            .find(|&most| self.reaches(&chords, needed, most, &mut degrees, &mut Vec::new()))
            .unwrap()
    }

    fn reaches(
        &self,
        left: &[[usize; 2]],
        needed: usize,
        most: u32,
        degrees: &mut [u32],
        taken: &mut Vec<[usize; 2]>,
    ) -> bool {
        if degrees.iter().any(|&degree| degree > most) || left.len() < needed {
            return false;
        }
        let [first, rest @ ..] = left else { return needed == 0 };
        if needed == 0 {
            return true;
        }
        if !taken.iter().any(|&other| self.meet(*first, other)) {
            taken.push(*first);
            first.iter().for_each(|&v| degrees[v] += 1);
            let found = self.reaches(rest, needed - 1, most, degrees, taken);
            first.iter().for_each(|&v| degrees[v] -= 1);
            taken.pop();
            if found {
                return true;
            }
        }
        self.reaches(rest, needed, most, degrees, taken)
    }

    fn domain(&self) -> Option<Domain> {
        let at = |v: usize| DVec2::from(self.points[v].map(f64::from));
        let lines = self.lines.iter().map(|ends| Ring::new(ends.map(at), vec![Side::count(1)]));
        let points = (self.on_ring..self.points.len())
            .map(|v| InnerPoint { at: at(v), ..InnerPoint::default() });
        let inside =
            Inside { lines: lines.collect(), points: points.collect(), ..Inside::default() };
        let ring: Vec<DVec2> = (0..self.on_ring).map(at).collect();
        let sides = vec![Side::count(1); self.on_ring];
        let domain = Domain::builder(Outline::Polygon(ring), sides).inside(inside).build().ok()?;
        (!domain.was_reversed()).then_some(domain)
    }
}

fn small() -> impl Strategy<Value = Small> {
    let point = [0..9_i32, 0..9_i32];
    let points = prop::collection::vec(point, 6..10);
    (points, prop::collection::vec([0..10_usize, 0..10_usize], 1..5), 0..3_usize).prop_filter_map(
        "no map",
        |(points, wanted, inner)| {
            let distinct: BTreeSet<[i32; 2]> = points.iter().copied().collect();
            let mut points: Vec<[i32; 2]> = distinct.into_iter().collect();
            let on_ring = points.len().checked_sub(inner).filter(|&count| count >= 4)?;
            // Round the first point inside, or the middle of the box.
            let middle = points.get(on_ring).copied().unwrap_or([4, 4]);
            let angle =
                |p: &[i32; 2]| f64::from(p[1] - middle[1]).atan2(f64::from(p[0] - middle[0]));
            points[..on_ring].sort_by(|a, b| angle(a).total_cmp(&angle(b)));
            let mut small = Small { points, on_ring, lines: Vec::new() };
            for pair in wanted {
                let [a, b] = pair.map(|v| v % small.points.len());
                let pair = [a.min(b), a.max(b)];
                if small.chords().contains(&pair) {
                    small.lines.push(pair);
                }
            }
            small.domain().filter(|domain| domain.is_map()).map(|_| small)
        },
    )
}

/// The mesh as a file would give it.
fn listed(mesh: &mindeg::BoundaryMesh) -> TriMesh {
    let points: Vec<DVec3> = mesh.points().map(|point| point.extend(0.0)).collect();
    TriMesh::new(points, mesh.triangles().collect()).unwrap().with_groups(mesh.groups().to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_triangulation_of_a_small_map_is_below_the_bound(map in small()) {
        let domain = map.domain().unwrap();
        let least = map.least_degree();
        let answer = degree_with(&domain, 0.02, Progress::NONE).unwrap();
        prop_assert!(answer.at_least <= least, "{answer:?}, and {least} is possible: {map:?}");
        prop_assert!(answer.reached >= least, "{answer:?}, and {least} is the least: {map:?}");
        // Where each face is a polygon, the search decides.
        let is_closed = matches!(&answer.bounded_by, DegreeBound::Map { rings, .. } if rings.len() > map.lines.len());
        if is_closed && map.on_ring == map.points.len() {
            prop_assert_eq!(answer.least_max_degree(), Some(least), "{:?}", map);
        }
        if answer.least_max_degree().is_none() {
            return Ok(());
        }
        let found = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
        prop_assert_eq!(found.mesh.max_degree(), answer.reached);
        let verified = verify::triangulation(&listed(&found.mesh), &domain, None).unwrap();
        prop_assert_eq!((verified.max_degree, verified.interior_points), (answer.reached, 0));
        let optimality = verify::optimality(&verified, &domain, Progress::NONE).unwrap();
        prop_assert!(matches!(optimality, Optimality::Optimal { .. }), "{optimality:?} {answer:?} {map:?}");
    }
}

/// Two materials beside each other, a fibre, a line that ends inside, and a gauge.
const PLATE: &str = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.25,
    "holes": [{"corners": [[3.3, 1]], "sides": [{"arc": {"center": [3, 1]}, "intervals": 12, "name": "bore"}]}],
    "lines": [
        {"corners": [[2, 0], [2, 2]], "intervals": 8, "name": "interface"},
        {"corners": [[1, 1]], "sides": [{"arc": {"center": [0.7, 1]}, "intervals": 12, "name": "interface"}]},
        {"points": [[2.2, 0.4], [2.4, 0.5], [2.6, 0.4]], "name": "breakline"}],
    "points": [{"at": [3.7, 1.6], "name": "gauge"}],
    "regions": [{"at": [0.1, 0.1], "name": "matrix"}, {"at": [0.7, 1], "name": "fibre"},
        {"at": [3.5, 1.8], "name": "steel", "material": "S235"}]}"#;

#[test]
fn a_mesh_has_the_names_of_a_map() {
    let domain = Domain::from_json(PLATE).unwrap();
    let found = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
    let mesh = &found.mesh;
    let groups: Vec<(&str, Option<&str>)> = mesh
        .groups()
        .iter()
        .map(|group| (&*group.name, group.material.as_ref().map(|material| &*material.name)))
        .collect();
    assert_eq!(groups, [("matrix", None), ("fibre", None), ("steel", Some("S235"))]);
    let at = |v: u32| mesh.point(v);
    let area = |range: std::ops::Range<u32>| -> f64 {
        let of = |t: u32| {
            let [a, b, c] = mesh.triangle(t).map(at);
            (b - a).perp_dot(c - a) / 2.0
        };
        range.map(of).sum()
    };
    // A polygon of 12 corners on a circle of 0.3.
    let disc = 12.0 * 0.09 / 2.0 * (std::f64::consts::TAU / 12.0).sin();
    let areas: Vec<f64> = mesh.groups().iter().map(|group| area(group.triangles.clone())).collect();
    for (area, expected) in areas.into_iter().zip([4.0 - disc, disc, 4.0 - disc]) {
        assert!((area - expected).abs() < 1e-12, "{area} {expected}");
    }
    let lines = mesh.lines();
    let names: Vec<&str> = lines.iter().map(|line| &*line.name).collect();
    assert_eq!(names[4..], ["bore", "interface", "interface", "breakline"]);
    let edges: BTreeSet<[u32; 2]> = mesh
        .triangles()
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
        .flat_map(|[a, b]| [[a, b], [b, a]])
        .collect();
    for line in lines.iter() {
        let mut segments = vec![[0; 2]; line.segments.len()];
        mesh.fill_segments(line.segments.start, &mut segments);
        assert!(segments.iter().all(|segment| edges.contains(segment)), "{line:?}");
    }
    let gauge = &mesh.named_vertices()[0];
    assert_eq!((&*gauge.name, mesh.point(gauge.vertex)), ("gauge", DVec2::new(3.7, 1.6)));
    // Positions are the same however they are asked for.
    let mut points = vec![DVec2::ZERO; mesh.vertex_count() as usize - 3];
    mesh.fill_points(3, &mut points);
    assert!(mesh.points().skip(3).eq(points));
    for vertex in 0..mesh.vertex_count() {
        assert_eq!(mesh.neighbors(vertex).len() as u32, mesh.degree(vertex), "{vertex}");
    }
    assert!(found.least_max_degree <= mesh.max_degree() && mesh.max_degree() <= 8, "{found:?}");
    let verified = verify::triangulation(&listed(mesh), &domain, None).unwrap();
    assert_eq!((verified.interior_points, verified.max_degree), (0, mesh.max_degree()));
}

#[test]
fn a_mesh_without_a_line_of_the_map_is_refused() {
    let domain = Domain::from_json(PLATE).unwrap();
    let plain = Domain::from_json(
        r#"{"rectangle": {"width": 4, "height": 2}, "size": 9, "lines": [{"corners": [[0, 0], [4, 2]], "intervals": 1}]}"#,
    )
    .unwrap();
    let error =
        mindeg::BoundaryMesh::with_triangles(&plain, vec![[0, 1, 3], [1, 2, 3]]).unwrap_err();
    assert!(error.to_string().contains("the edge from 0 to 2 has no triangle"), "{error}");
    assert!(mindeg::BoundaryMesh::with_triangles(&plain, vec![[0, 1, 2], [0, 2, 3]]).is_ok());
    // A longer search for the angle has the same degree.
    let [least, best] = [Goal::LeastDegree, Goal::Optimize(mindeg::Optimized::Angle)]
        .map(|goal| mesh(&domain, goal, Progress::NONE).unwrap().mesh);
    assert_eq!(least.max_total_degree(), best.max_total_degree());
    assert!(best.angle_range().min >= least.angle_range().min);
}

#[test]
fn holes_between_lines_stay_empty() {
    // The hole touches the outline at a vertex, and a region lies between two lakes that touch each other.
    let domain = Domain::from_json(
        r#"{"rectangle": {"width": 8, "height": 8}, "size": 1, "lines": [
            {"corners": [[0, 0], [3, 1], [4, 4], [1, 3]], "closed": true, "intervals": 2, "name": "lake"},
            {"corners": [[4, 4], [8, 4]], "intervals": 4}, {"corners": [[4, 4], [4, 8]], "intervals": 4}],
            "regions": [{"at": [2, 2], "hole": true}, {"at": [7, 7], "name": "field"}]}"#,
    )
    .unwrap();
    let found = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
    let areas: f64 = found.mesh.qualities().map(|quality| quality.area).sum();
    assert!((areas - 56.0).abs() < 1e-9, "{areas}");
    assert!(found.mesh.max_degree() <= found.least_max_degree + 1, "{found:?}");
    let verified = verify::triangulation(&listed(&found.mesh), &domain, None).unwrap();
    assert_eq!(verified.max_degree, found.mesh.max_degree());
    let corner = found.mesh.neighbors(0);
    assert_eq!((corner.len() as u32, corner[0]), (found.mesh.degree(0), 1));
}

#[test]
fn goals_trade_degree_for_angle_on_a_map() {
    let domain = Domain::from_json(PLATE).unwrap();
    let trade_off = trade_off(&domain, Progress::NONE).unwrap();
    let last = trade_off.meshes().last().unwrap();
    assert!((trade_off.share(last) - 1.0).abs() < 1e-9 && !trade_off.is_exact());
    let kept = mesh(&domain, Goal::KeepAngle(0.9), Progress::NONE).unwrap();
    assert!(kept.mesh.angle_range().min >= 0.9 * trade_off.delaunay_min_angle() * (1.0 - 1e-9));
    let within = mesh(&domain, Goal::MaxDegree(last.max_degree), Progress::NONE).unwrap();
    assert!(within.mesh.max_degree() <= last.max_degree);
    assert!(within.mesh.angle_range().min >= last.min_angle * (1.0 - 1e-9));
    // Each row is the mesh of its command.
    for row in trade_off.meshes() {
        let made = mesh(&domain, Goal::MaxDegree(row.max_degree), Progress::NONE).unwrap();
        assert_eq!(made.mesh.angle_range().min, row.mesh.angle_range().min, "{}", row.max_degree);
    }
    let goal = Goal::Optimize(mindeg::Optimized::Angle);
    let fewest = mesh(&domain, goal, Progress::NONE).unwrap().mesh;
    let first = &trade_off.meshes()[0];
    assert_eq!(fewest.max_total_degree(), first.max_degree);
    assert_eq!(fewest.angle_range().min, first.mesh.angle_range().min);
    let refused = mesh(&domain, Goal::MaxDegree(4), Progress::NONE).unwrap_err().to_string();
    assert!(
        refused.starts_with("no mesh here has maximum degree 4: each has at least "),
        "{refused}"
    );
}

/// Degrees outside count, and limits of single vertices are refused.
#[test]
fn degrees_outside_a_map_count() {
    let with = |keys: &str| {
        format!(
            r#"{{"rectangle": {{"width": 2, "height": 1}}, "size": 0.5, "lines": [{{"corners": [[1, 0], [1, 1]], "intervals": 2}}],
                "vertices": [{{"vertex": 2, {keys}}}]}}"#
        )
    };
    let domain = Domain::from_json(&with(r#""outside_degree": 20"#)).unwrap();
    let answer = degree(&domain, Progress::NONE).unwrap();
    assert_eq!((answer.reached, answer.at_least), (23, 23));
    let found = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
    assert_eq!(found.mesh.max_total_degree(), 23);
    let verified = verify::triangulation(&listed(&found.mesh), &domain, None).unwrap();
    let optimality = verify::optimality(&verified, &domain, Progress::NONE).unwrap();
    assert!(matches!(optimality, Optimality::Optimal { .. }), "{optimality:?}");
    // Vertex 2 is an end of the line, and has the edge of it and two of the boundary.
    for limit in [9, 4] {
        let limited = Domain::from_json(&with(&format!(r#""max_degree": {limit}"#))).unwrap();
        let found = mesh(&limited, Goal::LeastDegree, Progress::NONE).unwrap();
        assert!(found.mesh.degree(2) <= limit, "{limit}");
    }
}
