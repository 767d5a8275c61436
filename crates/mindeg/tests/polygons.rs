//! Meshes of domains that are not convex: against all triangulations, and known answers.

use crate::outlines::{Measured, Outline, Random};
use mindeg::exact::{self, DegreeBound, LowerBound, Reached, degree_of_boundary};
use mindeg::glam::DVec2;
use mindeg::verify::{self, Proof};
use mindeg::{BoundaryMesh, Domain, FoundBy, Goal, Outline as Shape, Progress, Ring, Side, mesh};
use mindeg_exact::Refutation;
use mindeg_exact::check::CheckedOutline;
use mindeg_exact::check::refutation::{CheckedFace, refutes};
use mindeg_mesh::check;
use std::collections::BTreeSet;

/// The corners and counts of an outline's sides.
fn sides(outline: &Outline) -> (Vec<DVec2>, Vec<Side>) {
    let mut corners = Vec::new();
    let mut counts = Vec::<u64>::new();
    for (vertex, &side) in outline.side_of.iter().enumerate() {
        if counts.len() as u32 <= side {
            corners.push(outline.points[vertex]);
            counts.push(0);
        }
        counts[side as usize] += 1;
    }
    (corners, counts.into_iter().map(Side::count).collect())
}

fn domain(outline: &Outline) -> Domain {
    let (corners, sides) = sides(outline);
    Domain::polygon(corners, sides).unwrap()
}

/// The outline with the domain's own points and straight runs.
fn as_placed(domain: &Domain) -> Outline {
    Outline { points: domain.placement().points().collect(), side_of: domain.straight_runs() }
}

/// Turns corners that are straight or nearly so away: the two definitions of a straight run differ
/// there.
fn random(random: &mut Random, most: usize) -> Outline {
    loop {
        let corners = 4 + random.below(most as u64 - 4) as usize;
        if let Some(outline) = Outline::random(random, corners, most)
            && outline.len() >= 4
            && outline.len() <= most
        {
            return outline;
        }
    }
}

fn largest(degrees: &[u32]) -> u32 {
    degrees.iter().copied().max().unwrap()
}

/// Degree and angle of every goal are the best of all triangulations.
#[test]
fn every_goal_agrees_with_all_triangulations() {
    let mut numbers = Random(11);
    let (mut straight, mut reflex) = (0, 0);
    for round in 0..150 {
        let outline = random(&mut numbers, if round % 5 == 0 { 13 } else { 10 });
        let domain = domain(&outline);
        let placed = as_placed(&domain);
        let runs = placed.side_of.iter().collect::<BTreeSet<_>>().len();
        straight += usize::from(runs < domain.rings().side_count());
        reflex += usize::from(domain.convex().is_none());
        let all: Vec<Measured> = placed
            .triangulations()
            .iter()
            .map(|triangles| Measured::new(&placed.points, triangles))
            .collect();
        let best = |limit: u32| {
            let kept = all.iter().filter(|it| largest(&it.degrees) <= limit);
            kept.map(|it| it.tangent).max_by(f64::total_cmp)
        };
        let most = best(u32::MAX).unwrap();
        let least = all.iter().map(|it| largest(&it.degrees)).min().unwrap();
        let angle = |mesh: &BoundaryMesh| {
            let triangles: Vec<_> = mesh.triangles().collect();
            Measured::new(&placed.points, &triangles).tangent
        };
        let answer = exact::degree(&domain, Progress::NONE).unwrap();
        assert_eq!(answer.least_max_degree(), Some(least), "{outline:?}");
        let meshed = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
        assert_eq!(meshed.mesh.max_degree(), least);
        assert_eq!(angle(&meshed.mesh), best(least).unwrap(), "{outline:?}");
        for limit in least - 1..least + 3 {
            match mesh(&domain, Goal::MaxDegree(limit), Progress::NONE) {
                Ok(meshed) => {
                    assert!(meshed.mesh.max_degree() <= limit);
                    assert_eq!(angle(&meshed.mesh), best(limit).unwrap(), "{limit}: {outline:?}");
                }
                Err(_) => assert_eq!(limit, least - 1, "{outline:?}"),
            }
        }
        let share = [0.5, 0.9, 1.0][round % 3];
        let kept = mesh(&domain, Goal::KeepAngle(share), Progress::NONE).unwrap().mesh;
        let wanted = libm::tan(share * (1.0 - 2e-10) * libm::atan(most));
        let smallest = all.iter().filter(|it| it.tangent >= wanted);
        let smallest = smallest.map(|it| largest(&it.degrees)).min().unwrap();
        assert_eq!(kept.max_degree(), smallest, "{share}: {outline:?}");
        assert!(angle(&kept) >= wanted);
        let curve = exact::trade_off(&domain, Progress::NONE).unwrap();
        for step in curve.meshes() {
            assert_eq!(angle(&step.mesh), best(step.max_degree).unwrap(), "{outline:?}");
        }
        assert!(curve.is_exact());
    }
    assert!(straight > 5 && reflex > 100, "{straight}, {reflex}");
}

/// A convex ring of points has the formula's degree, wherever its first corner is.
#[test]
fn a_first_corner_in_a_straight_side_changes_no_degree() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
    let whole = Domain::polygon(corners, [7, 3, 4, 3].map(Side::count).into()).unwrap();
    let least = BoundaryMesh::least_degree(&whole).unwrap();
    for split in 1..7_u64 {
        let middle = [4.0 * split as f64 / 7.0, 0.0];
        let corners = [middle, corners[1], corners[2], corners[3], corners[0]];
        let counts = [7 - split, 3, 4, 3, split].map(Side::count);
        let domain = Domain::polygon(corners, counts.into()).unwrap();
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        assert_eq!(mesh.max_degree(), least.max_degree());
        let listed = BoundaryMesh::with_triangles(&domain, mesh.triangles().collect()).unwrap();
        let n = mesh.vertex_count();
        assert!((0..n).all(|v| listed.degree(v) == mesh.degree(v)));
        assert!((0..n).all(|v| listed.neighbors(v) == mesh.neighbors(v)), "{split}");
        let mut filled = vec![[0; 3]; n as usize - 2];
        mesh.fill_triangles(0, &mut filled);
        assert!(mesh.triangles().eq(filled));
        let best = exact::mesh(&domain, 5, Progress::NONE).unwrap();
        let of_whole = exact::mesh(&whole, 5, Progress::NONE).unwrap();
        assert!((best.min_angle - of_whole.min_angle).abs() < 1e-9);
    }
}

/// The expected degree of each, from elsewhere.
#[test]
fn known_least_degrees() {
    let l = |counts| domain(&Outline::l_shape(counts));
    let u = |counts| domain(&Outline::u_shape(counts));
    let rectangle =
        |counts: [u64; 4]| Domain::rectangle(4.0, 3.0, counts.map(Side::count).to_vec()).unwrap();
    for (domain, least) in [
        (l([13, 6, 6, 6, 6, 13]), 5),
        (l([25, 13, 13, 13, 13, 25]), 5),
        (l([50, 25, 25, 25, 25, 50]), 4),
        (l([100, 50, 50, 50, 50, 100]), 4),
        (l([250, 125, 125, 125, 125, 250]), 4),
        (l([500, 250, 250, 250, 250, 500]), 4),
        (l([60, 2, 2, 2, 2, 2]), 11),
        (u([2, 2, 2, 2, 60, 2, 2, 2]), 23),
        (u([90, 2, 2, 2, 2, 2, 2, 2]), 14),
        (domain(&Outline::comb(8, 200, 1)), 11),
        (domain(&Outline::comb(8, 50, 11)), 5),
        (domain(&Outline::gear(12, 8)), 5),
        (domain(&Outline::spiral(5)), 4),
        (rectangle([30, 2, 4, 2]), 7),
        (rectangle([12, 9, 4, 4]), 5),
        (rectangle([100, 3, 3, 3]), 16),
        (rectangle([20, 1, 1, 1]), 12),
    ] {
        let answer = exact::degree(&domain, Progress::NONE).unwrap();
        assert_eq!(answer.least_max_degree(), Some(least), "{domain:?}");
    }
    let zigzag = exact::degree(&l([50, 25, 25, 25, 25, 50]), Progress::NONE).unwrap();
    assert!(matches!(zigzag.reached_by, Reached::ZigZag(_)));
    let five = exact::degree(&l([13, 6, 6, 6, 6, 13]), Progress::NONE).unwrap();
    let DegreeBound::Polygon(LowerBound::BlockedZigZags(blocked)) = five.bounded_by else {
        panic!("not 4")
    };
    let placed = as_placed(&l([13, 6, 6, 6, 6, 13]));
    let rings = exact_rings(&placed);
    assert!(rings(&blocked));
    assert!(!rings(&blocked[..blocked.len() / 2]));
}

/// Whether chords prove that an outline has no triangulation of degree 4.
fn exact_rings(placed: &Outline) -> impl Fn(&[[u32; 2]]) -> bool + '_ {
    let ring = 0..placed.points.len() as u32;
    move |blocked| {
        mindeg_exact::check::CheckedOutline {
            points: &placed.points,
            rings: std::slice::from_ref(&ring),
            side_of: &placed.side_of,
            keeps_clear: true,
        }
        .blocks_all_zigzags(blocked)
    }
}

/// A square of side 4 with a square hole of side 2, and intervals to each of their sides.
fn frame(outer: u64, inner: u64) -> Domain {
    let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let outline = Shape::Polygon(square(0.0, 4.0).map(DVec2::from).to_vec());
    let hole = Ring::new(square(1.0, 3.0), vec![Side::count(inner); 4]);
    Domain::builder(outline, vec![Side::count(outer); 4]).hole(hole).build().unwrap()
}

/// A square plate with rows of round holes.
fn plate(rows: u32, corners: u32) -> Domain {
    let width = f64::from(rows);
    let side = vec![Side::count(5 * u64::from(rows)); 4];
    let outline = [[0.0, 0.0], [width, 0.0], [width, width], [0.0, width]];
    let outline = Shape::Polygon(outline.map(DVec2::from).to_vec());
    let mut builder = Domain::builder(outline, side);
    for (x, y) in (0..rows).flat_map(|x| (0..rows).map(move |y| (x, y))) {
        let at = |corner: u32| {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
            let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            center + 0.25 * DVec2::new(libm::cos(angle), libm::sin(angle))
        };
        builder =
            builder.hole(Ring::new((0..corners).map(at), vec![Side::count(1); corners as usize]));
    }
    builder.build().unwrap()
}

/// Windows alone do not meet the mesh.
#[test]
fn searches_meet_meshes_that_windows_miss() {
    let boundary = crate::stars::star(150, 5, 5);
    let answer = degree_of_boundary(&boundary, mindeg_exact::MAX_TRIPLES, Progress::NONE).unwrap();
    assert_eq!(answer.least_max_degree(), Some(5));
    assert!(matches!(answer.reached_by, Reached::Descent | Reached::Search), "{answer:?}");
}

#[test]
fn domains_with_holes_have_a_proven_degree() {
    for (domain, least) in [
        (frame(4, 2), 5),
        (frame(4, 4), 4),
        (frame(10, 5), 5),
        (frame(25, 12), 5),
        (plate(2, 8), 5),
        (plate(3, 12), 5),
        (plate(5, 24), 5),
        (frame(100, 50), 5),
    ] {
        let meshed = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
        let rings = domain.rings();
        let holes = rings.ring_count() as u32 - 1;
        assert_eq!(meshed.mesh.triangle_count(), rings.vertex_count() + 2 * holes - 2);
        assert_eq!((meshed.mesh.max_degree(), meshed.least_max_degree), (least, least));
        assert!(meshed.is_least_proven);
        let boundary = domain.boundary().unwrap();
        let triangles: Vec<_> = meshed.mesh.triangles().collect();
        let checked = check::triangulation(&boundary, &[], &triangles).unwrap();
        assert_eq!(checked.max_degree, least);
        for vertex in 0..rings.vertex_count() {
            let neighbors = meshed.mesh.neighbors(vertex);
            assert_eq!(neighbors.len() as u32, checked.degrees[vertex as usize]);
            let ends = (neighbors.first().copied(), neighbors.last().copied());
            assert_eq!(ends, (Some(rings.next(vertex)), Some(rings.previous(vertex))));
        }
        if rings.vertex_count() > 400 {
            // Searches of angles take long without optimisation.
            continue;
        }
        let kept = mesh(&domain, Goal::KeepAngle(0.9), Progress::NONE).unwrap();
        assert!(
            kept.mesh.angle_range().min >= 0.9 * kept.delaunay_min_angle.unwrap() * (1.0 - 1e-9)
        );
        // The best of that degree, which may keep more.
        let is_proven = kept.found_by == FoundBy::Search;
        assert!(is_proven || matches!(kept.found_by, FoundBy::Windows { share } if share >= 0.9));
        let curve = exact::trade_off(&domain, Progress::NONE).unwrap();
        assert!(curve.is_exact() == is_proven && curve.meshes()[0].max_degree == least);
        assert!(curve.share(curve.meshes().last().unwrap()) > 1.0 - 1e-9);
        let refused = mesh(&domain, Goal::MaxDegree(3), Progress::NONE).unwrap_err().to_string();
        assert!(refused.starts_with("no mesh here has maximum degree 3: "), "{refused}");
        assert!(refused.ends_with(&format!("; the least is {least}")), "{refused}");
    }
}

#[test]
fn a_trade_off_by_windows_ends_with_the_first_mesh_that_is_enough() {
    // Beyond the work of the search with holes.
    let domain = frame(150, 70);
    let all = exact::trade_off(&domain, Progress::NONE).unwrap();
    assert!(!all.is_exact() && all.meshes().len() > 1, "{:?}", all.meshes().len());
    for share in [0.0, 0.9, 2.0] {
        let is_enough = |angle: f64, most: f64| angle >= share * most;
        let found = exact::trade_off_until(&domain, is_enough, Progress::NONE).unwrap();
        let wanted = all.meshes().iter().position(|mesh| all.share(mesh) >= share);
        assert_eq!(found.meshes().len(), wanted.map_or(all.meshes().len(), |i| i + 1), "{share}");
    }
}

/// All triangulations of a small domain with a hole.
fn all_of_rings(domain: &Domain) -> Vec<Vec<[u32; 3]>> {
    let points: Vec<DVec2> = domain.placement().points().collect();
    let rings: Vec<_> = domain.rings().rings().collect();
    let runs = domain.straight_runs();
    let outline = mindeg_exact::check::CheckedOutline {
        points: &points,
        rings: &rings,
        side_of: &runs,
        keeps_clear: true,
    };
    let n = points.len() as u32;
    let is_edge = |a: u32, b: u32| domain.rings().next(a) == b || domain.rings().next(b) == a;
    let joins: Vec<Vec<bool>> = (0..n)
        .map(|a| {
            (0..n).map(|b| a != b && (is_edge(a, b) || outline.is_admissible([a, b]))).collect()
        })
        .collect();
    let mut all = Vec::new();
    let open: BTreeSet<[u32; 2]> = (0..n).map(|v| [v, domain.rings().next(v)]).collect();
    advance(&points, &joins, &open, &mut Vec::new(), &mut all);
    all
}

/// Puts a triangle on the first half-edge that has none, in every way.
fn advance(
    points: &[DVec2],
    joins: &[Vec<bool>],
    open: &BTreeSet<[u32; 2]>,
    triangles: &mut Vec<[u32; 3]>,
    all: &mut Vec<Vec<[u32; 3]>>,
) {
    let Some(&[a, b]) = open.first() else {
        all.push(triangles.clone());
        return;
    };
    let at = |vertex: u32| points[vertex as usize];
    let n = points.len() as u32;
    for c in (0..n).filter(|&c| joins[a as usize][c as usize] && joins[b as usize][c as usize]) {
        let is_inside = |vertex: u32| {
            let p = at(vertex);
            ![a, b, c].contains(&vertex)
                && crate::outlines::turn(at(a), at(b), p) >= 0.0
                && crate::outlines::turn(at(b), at(c), p) >= 0.0
                && crate::outlines::turn(at(c), at(a), p) >= 0.0
        };
        let crosses = |triangle: &[u32; 3]| {
            let edges = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
            edges(*triangle).into_iter().any(|[p, q]| {
                edges([a, b, c]).into_iter().any(|[r, s]| {
                    let turn = |x, y, z| crate::outlines::turn(at(x), at(y), at(z));
                    ![r, s].contains(&p)
                        && ![r, s].contains(&q)
                        && turn(p, q, r) * turn(p, q, s) < 0.0
                        && turn(r, s, p) * turn(r, s, q) < 0.0
                })
            })
        };
        if crate::outlines::turn(at(a), at(b), at(c)) <= 0.0
            || (0..n).any(is_inside)
            || triangles.iter().any(crosses)
        {
            continue;
        }
        let mut next = open.clone();
        let mut fits = true;
        for [from, to] in [[a, b], [b, c], [c, a]] {
            // An edge that is open is closed; any other one opens on its other side.
            if !next.remove(&[from, to]) {
                fits &= next.insert([to, from]);
            }
        }
        if fits {
            triangles.push([a, b, c]);
            advance(points, joins, &next, triangles, all);
            triangles.pop();
        }
    }
}

#[test]
fn the_degree_of_a_hole_is_the_least_of_all_triangulations() {
    let mut numbers = Random(3);
    for _ in 0..40 {
        let corners = 4 + numbers.below(2) as usize;
        let outer = (0..corners).map(|corner| {
            let radius = 6.0 + numbers.below(40) as f64 / 10.0;
            let angle = std::f64::consts::TAU * corner as f64 / corners as f64;
            DVec2::new(libm::cos(angle), libm::sin(angle)) * radius
        });
        let outer: Vec<DVec2> = outer.collect();
        let shift = numbers.below(100) as f64 / 100.0;
        let hole = (0..3).map(|corner| {
            let angle = shift + std::f64::consts::TAU * f64::from(corner) / 3.0;
            DVec2::new(libm::cos(angle), libm::sin(angle)) * 2.0
        });
        let counts = (0..corners).map(|_| Side::count(1 + numbers.below(2))).collect();
        let domain = Domain::builder(Shape::Polygon(outer), counts)
            .hole(Ring::new(hole, vec![Side::count(1); 3]))
            .build()
            .unwrap();
        let points: Vec<DVec2> = domain.placement().points().collect();
        let all = all_of_rings(&domain);
        let least = all.iter().map(|t| largest(&Measured::new(&points, t).degrees)).min().unwrap();
        let answer = exact::degree(&domain, Progress::NONE).unwrap();
        assert_eq!(answer.least_max_degree(), Some(least), "{answer:?}");
    }
}

/// A regular polygon with a smaller one, turned by half a step, as its hole.
fn ring_of(outer: u32, inner: u32) -> Domain {
    let regular = |corners: u32, radius: f64, turn: f64| {
        (0..corners).map(move |corner| {
            let angle = std::f64::consts::TAU * (f64::from(corner) + turn) / f64::from(corners);
            radius * DVec2::new(libm::cos(angle), libm::sin(angle))
        })
    };
    let counts = |corners: u32| vec![Side::count(1); corners as usize];
    Domain::builder(Shape::Polygon(regular(outer, 6.0, 0.0).collect()), counts(outer))
        .hole(Ring::new(regular(inner, 2.0, 0.5), counts(inner)))
        .build()
        .unwrap()
}

/// With one hole, degree 4 needs four edges at every vertex.
#[test]
fn one_hole_allows_degree_4_or_excludes_it() {
    for (domain, least) in [
        (ring_of(3, 3), 4),
        (ring_of(4, 4), 4),
        (ring_of(5, 5), 4),
        (ring_of(4, 3), 5),
        (ring_of(3, 4), 5),
        (ring_of(6, 3), 5),
        (ring_of(7, 3), 5),
        (frame(1, 1), 4),
    ] {
        let points: Vec<DVec2> = domain.placement().points().collect();
        let all = all_of_rings(&domain);
        let of_all = all.iter().map(|t| largest(&Measured::new(&points, t).degrees)).min();
        assert_eq!(of_all, Some(least), "{domain:?}");
        let answer = exact::degree(&domain, Progress::NONE).unwrap();
        assert_eq!(answer.reached, least, "{domain:?}");
        assert!((4..=least).contains(&answer.at_least), "{domain:?}");
    }
}

#[test]
fn other_triangles_than_a_mesh_are_refused() {
    let domain = frame(1, 1);
    let good: Vec<_> =
        mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap().mesh.triangles().collect();
    let refused = |triangles: Vec<[u32; 3]>| {
        BoundaryMesh::with_triangles(&domain, triangles).unwrap_err().to_string()
    };
    assert!(BoundaryMesh::with_triangles(&domain, good.clone()).is_ok());
    assert!(refused(good[1..].to_vec()).contains("found 7 triangles, expected 8"));
    let mut other = good.clone();
    other[0] = [0, 1, 2];
    assert!(refused(other).contains("on the same side"));
    let mut other = good;
    other[0] = [0, 1, 99];
    assert!(refused(other).contains("vertex 99, which does not exist"));

    // Three points of a straight bottom, in an L.
    let bottom = domain_of_l([2, 1, 1, 1, 1, 1]);
    let flat = vec![[0, 1, 2], [0, 2, 4], [2, 3, 4], [0, 4, 6], [4, 5, 6]];
    let refusal = BoundaryMesh::with_triangles(&bottom, flat).unwrap_err().to_string();
    assert!(refusal.ends_with("triangle [0, 1, 2] is flat"), "{refusal}");
}

fn domain_of_l(counts: [u32; 6]) -> Domain {
    domain(&Outline::l_shape(counts))
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let domains = [domain_of_l([60, 30, 30, 30, 30, 60]), frame(30, 15), plate(3, 12)];
    for domain in domains {
        let solve = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let goals = [Goal::LeastDegree, Goal::KeepAngle(0.9), Goal::MaxDegree(7)];
                (
                    goals.map(|goal| mesh(&domain, goal, Progress::NONE).unwrap()),
                    exact::degree(&domain, Progress::NONE).unwrap(),
                    exact::trade_off(&domain, Progress::NONE).unwrap(),
                )
            })
        };
        let one = solve(1);
        assert_eq!(solve(2), one);
        assert_eq!(solve(7), one);
    }
}

/// Windows keep the limits of neither domain, but a mesh that keeps them exists.
#[test]
fn limits_round_holes_that_windows_miss_are_kept() {
    for json in [
        r#"{"ring": [[0, 0], [6, 0], [8, 0], [8, 8], [0, 8], [0, 6]], "holes": [{"ring": [[1, 7], [2, 5], [6, 7],
            [1, 3]]}], "vertices": [{"vertex": 7, "outside_degree": 2}, {"vertex": 3, "max_degree": 4},
            {"vertex": 4, "max_degree": 4}, {"vertex": 2, "max_degree": 7}, {"vertex": 9, "max_degree": 4},
            {"vertex": 8, "outside_degree": 1, "max_degree": 7}, {"vertex": 1, "max_degree": 5},
            {"vertex": 6, "outside_degree": 1, "max_degree": 7}]}"#,
        r#"{"ring": [[4, 6], [2, 6], [2, 4], [0, 0], [6, 2], [6, 6]], "holes": [{"ring": [[4, 2], [5, 5], [5, 3]]}],
            "vertices": [{"vertex": 3, "outside_degree": 2}, {"vertex": 2, "outside_degree": 2},
            {"vertex": 8, "outside_degree": 3}, {"vertex": 7, "outside_degree": 3, "max_degree": 8},
            {"vertex": 1, "outside_degree": 1}, {"vertex": 0, "max_degree": 4},
            {"vertex": 5, "outside_degree": 3, "max_degree": 6}]}"#,
    ] {
        let domain = Domain::from_json(json).unwrap();
        let least = exact::degree(&domain, Progress::NONE).unwrap().least_max_degree();
        let meshed = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
        assert!(meshed.is_least_proven);
        assert_eq!(Some(meshed.mesh.max_total_degree()), least);
        let is_kept = |vertex| {
            let total = meshed.mesh.neighbors(vertex).len() as u32 + domain.external_degree(vertex);
            domain.degree_limit(vertex).is_none_or(|limit| total <= limit)
        };
        assert!((0..domain.rings().vertex_count()).all(is_kept));
        let curve = exact::trade_off(&domain, Progress::NONE).unwrap();
        assert!(curve.is_exact() && Some(curve.meshes()[0].max_degree) == least);
    }
}

/// Refused with the vertices whose limits conflict, and with the least degree.
#[test]
fn limits_round_a_hole_that_no_mesh_keeps_are_told() {
    let hole = r#""ring": [[0, 0], [9, 0], [9, 9], [0, 9]], "holes": [{"ring": [[3, 3], [3, 6], [6, 6], [6, 3]]}]"#;
    // The only chords of vertices 0 and 1 would end at a vertex of the hole that sees all of the outside.
    let limits = r#""vertices": [{"vertex": 0, "max_degree": 3}, {"vertex": 1, "max_degree": 3},
        {"vertex": 6, "max_degree": 9}]"#;
    let domain = Domain::from_json(&format!("{{{hole}, {limits}}}")).unwrap();
    let refusals = [
        exact::degree(&domain, Progress::NONE).err(),
        mesh(&domain, Goal::LeastDegree, Progress::NONE).err(),
        exact::trade_off(&domain, Progress::NONE).err(),
    ];
    for refusal in refusals {
        let sentence = refusal.unwrap().to_string();
        let conflict = "no mesh keeps the degree limits of vertices 0 and 1 together";
        assert!(sentence.starts_with(conflict), "{sentence}");
    }
    let domain = Domain::from_json(&format!("{{{hole}}}")).unwrap();
    let refused = mesh(&domain, Goal::MaxDegree(3), Progress::NONE).err().unwrap().to_string();
    assert_eq!(
        refused,
        "no mesh here has maximum degree 3: its edges have too many ends for its vertices; the least is 4"
    );
}

/// Each line of the file is a domain with the least degree that windows and bounds alone leave open.
#[test]
fn gaps_of_drawn_outlines_are_closed() {
    let lines = include_str!("gaps.txt").lines();
    let mut refuted = 0;
    for line in lines {
        let (least, json) = line.split_once(' ').unwrap();
        let domain = Domain::from_json(json).unwrap();
        let answer = exact::degree(&domain, Progress::NONE).unwrap();
        assert_eq!(answer.least_max_degree(), least.parse().ok(), "{json}");
        let proof = verify::checked_proof(&answer, &domain, Progress::NONE).unwrap();
        assert!(proof.is_some(), "{json}");
        refuted += u32::from(matches!(proof, Some(Proof::Refuted { .. })));
    }
    assert_eq!(refuted, 5);
}

#[test]
fn the_largest_angle_round_a_hole_is_found() {
    let json = r#"{"ring": [[4, 1], [6, 0], [2, 4], [0, 3]], "holes": [{"ring": [[1, 3], [2, 3], [3, 2]]}]}"#;
    let exact = exact::mesh(&Domain::from_json(json).unwrap(), 5, Progress::NONE).unwrap();
    assert!(exact.is_proven && (exact.min_angle - 7.125).abs() < 5e-4, "{}", exact.min_angle);
}

#[test]
fn limits_that_no_mesh_with_holes_keeps_are_refused_with_the_proof() {
    let square = |x: f64, y: f64, size: [f64; 2]| {
        let [right, top] = [x + size[0], y + size[1]];
        Ring::new([(x, y), (right, y), (right, top), (x, top)], vec![Side::count(1); 4])
    };
    let holes = [1.0, 5.0, 9.0].map(|x| square(x, 1.0, [2.0; 2]));
    let row = Domain::of_rings([vec![square(0.0, 0.0, [12.0, 4.0])], holes.to_vec()].concat());
    let uneven = Domain::of_rings(vec![square(0.0, 0.0, [4.0; 2]), {
        Ring::new([(1.0, 1.0), (3.0, 1.0), (2.0, 3.0)], vec![Side::count(1); 3])
    }]);
    for (domain, limit, words) in [
        (row.unwrap(), 5, ["clauses refute degree 5, which mindeg degree", "; the least is 6"]),
        (
            uneven.unwrap(),
            4,
            ["4 boundary edges have only 3 vertices as apexes", "; the least is 5"],
        ),
    ] {
        for limit in limit - 1..=limit {
            let refused = mesh(&domain, Goal::MaxDegree(limit), Progress::NONE).unwrap_err();
            let message = refused.to_string();
            assert!(message.starts_with(&format!("no mesh here has maximum degree {limit}: ")));
            assert!(words.iter().all(|words| message.contains(words)), "{message}");
        }
        assert!(mesh(&domain, Goal::MaxDegree(limit + 1), Progress::NONE).is_ok());
    }
}

/// A search whose attention wanders from place to place takes four times as many steps, and states a gap.
#[test]
fn a_refutation_with_holes_takes_few_steps() {
    let boundary = crate::stars::star(250, 2, 6);
    let triangles = mindeg_delaunay::triangles(&boundary, &[], &[], Progress::NONE).unwrap();
    let mut problem = mindeg_exact::Problem::triangulated(&boundary, &triangles).unwrap();
    problem.set_max_steps(14_000_000);
    let range = mindeg_exact::degree_range(&problem, Progress::NONE).unwrap();
    assert_eq!((range.lower_bound, range.max_degree), (6, 6));
}

/// Clauses leave it open after a thousand million steps: its rings are nearly smooth.
#[test]
fn one_hole_is_decided_and_the_decision_repeated() {
    let boundary = crate::stars::star(200, 1, 8);
    let answer = degree_of_boundary(&boundary, mindeg_exact::MAX_TRIPLES, Progress::NONE).unwrap();
    assert_eq!(answer.least_max_degree(), Some(6));
    assert_eq!(answer.bounded_by, DegreeBound::Polygon(LowerBound::Exhaustive));
    let rings: Vec<_> = boundary.rings().collect();
    let (points, side_of) = (boundary.points(), boundary.runs());
    let outline = CheckedOutline { points, rings: &rings, side_of, keeps_clear: true };
    assert_eq!(outline.has_triangulation(&[3; 200], 2_000_000_000), Some(false));
    assert_eq!(outline.has_triangulation(&[4; 200], 2_000_000_000), Some(true));
}

/// A thousand clauses hold as they are; against a limit that a mesh keeps, none of them with a change does.
#[test]
fn long_proofs_hold_and_with_changes_do_not() {
    let boundary = crate::stars::star(100, 1, 1);
    let answer = degree_of_boundary(&boundary, mindeg_exact::MAX_TRIPLES, Progress::NONE).unwrap();
    let least = answer.least_max_degree().unwrap();
    let DegreeBound::Polygon(LowerBound::Refuted(proof)) = answer.bounded_by else {
        panic!("{:?}", answer.bounded_by)
    };
    assert!(proof.clauses.len() > 500);
    let rings: Vec<_> = boundary.rings().collect();
    let (points, side_of) = (boundary.points(), boundary.runs());
    let outline = CheckedOutline { points, rings: &rings, side_of, keeps_clear: true };
    let vertices: Vec<u32> = (0..points.len() as u32).collect();
    let face = CheckedFace { outline, vertices: &vertices, least_tangent: 0.0 };
    let holds = |degree: u32, proof: &Refutation| {
        refutes(&[face], &vec![degree - 2; vertices.len()], proof)
    };
    assert!(holds(least - 1, &proof));
    assert!(!holds(least, &proof));
    // Half of it is no proof, and the empty clause alone is none.
    let half = proof.clauses.iter().step_by(2).cloned().chain([Vec::new()]);
    assert!(!holds(least - 1, &Refutation { clauses: half.collect() }));
    assert!(!holds(least - 1, &Refutation { clauses: vec![Vec::new()] }));
    let mut random = Random(7);
    for _ in 0..30 {
        let mut changed = proof.clone();
        let clause = random.below(changed.clauses.len() as u64 - 1) as usize;
        match random.below(4) {
            0 => changed.clauses[clause].clear(),
            1 => changed.clauses[clause].truncate(1),
            2 => changed.clauses.swap(clause, 0),
            _ => changed.clauses[clause].iter_mut().for_each(|literal| literal.is_used ^= true),
        }
        assert!(!holds(least, &changed));
    }
}
