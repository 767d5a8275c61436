//! `mindeg::verify` against meshes that are right, however they were written, and meshes that are not.

use std::path::Path;

use glam::{DVec2, DVec3};
use mindeg::verify::{self, MatchedPlane, MeshDefect, Optimality, VerifiedMesh};
use mindeg::{Domain, Goal, Interior, Progress, Side, TriMesh, interior};
use mindeg_mesh::{NonTriangles, Random};
use proptest::prelude::*;

fn shuffle<T>(items: &mut [T], random: &mut Random) {
    for last in (1..items.len()).rev() {
        items.swap(last, random.below(last + 1));
    }
}

/// Some, since each tries every kind of damage.
const CASES: u32 = 48;

fn asset(name: &str) -> Domain {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/domains");
    let text = std::fs::read_to_string(path.join(format!("{name}.json"))).unwrap();
    Domain::from_json(&text).unwrap()
}

/// Points and triangles of a mesh, to be rewritten and damaged.
#[derive(Clone, Debug)]
struct List {
    points: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
}

impl List {
    fn least(domain: &Domain) -> Self {
        let mesh = mindeg::mesh(domain, Goal::LeastDegree, Progress::NONE).unwrap().mesh;
        Self { points: mesh.points().collect(), triangles: mesh.triangles().collect() }
    }

    fn interior(domain: &Domain) -> Self {
        let mesh = interior::mesh(domain, &Interior::default(), Progress::NONE).unwrap().mesh;
        let points = mesh.positions().iter().map(|position| position.truncate()).collect();
        Self { points, triangles: mesh.triangles().to_vec() }
    }

    /// In another order of vertices, triangles and corners.
    fn shuffled(&self, random: &mut Random) -> Self {
        let mut order: Vec<u32> = (0..self.points.len() as u32).collect();
        shuffle(&mut order, random);
        let mut points = vec![DVec2::ZERO; self.points.len()];
        (0..).zip(&self.points).for_each(|(v, &point)| points[order[v as usize] as usize] = point);
        let mut triangles: Vec<[u32; 3]> =
            self.triangles.iter().map(|corners| corners.map(|v| order[v as usize])).collect();
        triangles.iter_mut().for_each(|corners| corners.rotate_left(random.below(3)));
        shuffle(&mut triangles, random);
        Self { points, triangles }
    }

    /// With separate vertices for each triangle, as in STL.
    fn unwelded(&self) -> Self {
        let points = self.triangles.as_flattened().iter().map(|&v| self.points[v as usize]);
        let triangles = (0..self.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
        Self { points: points.collect(), triangles: triangles.collect() }
    }

    fn reversed(mut self) -> Self {
        self.triangles.iter_mut().for_each(|corners| corners.swap(0, 1));
        self
    }

    fn mesh(&self, plane: MatchedPlane) -> TriMesh {
        let place = |point: &DVec2| match plane {
            MatchedPlane::Xy => DVec3::new(point.x, point.y, 2.5),
            MatchedPlane::Floor => DVec3::new(point.x, 0.0, -point.y),
            MatchedPlane::Xz => DVec3::new(point.x, -1.0, point.y),
        };
        TriMesh::new(self.points.iter().map(place).collect(), self.triangles.clone()).unwrap()
    }

    fn verify(&self, domain: &Domain) -> Result<VerifiedMesh, MeshDefect> {
        verify::triangulation(&self.mesh(MatchedPlane::Xy), domain, None)
    }
}

/// Rounds to the nearest 32-bit floats.
fn rounded(list: &List) -> List {
    let points = list.points.iter().map(|point| point.as_vec2().as_dvec2()).collect();
    List { points, triangles: list.triangles.clone() }
}

/// Rounds to six decimal digits.
fn six_digits(list: &List) -> List {
    let number = |value: f64| format!("{value:.6}").parse().unwrap();
    let points = list.points.iter().map(|point| DVec2::new(number(point.x), number(point.y)));
    List { points: points.collect(), triangles: list.triangles.clone() }
}

fn domains() -> impl Strategy<Value = Domain> {
    let counts = proptest::array::uniform4(1..9_u64);
    let l = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.5], [1.5, 1.5], [1.5, 4.0], [0.0, 4.0]];
    prop_oneof![
        counts.prop_map(|counts| {
            Domain::rectangle(4.0, 3.0, counts.map(Side::count).to_vec()).unwrap()
        }),
        proptest::array::uniform6(1..6_u64).prop_map(move |counts| Domain::polygon(
            l,
            counts.map(Side::count).to_vec()
        )
        .unwrap()),
        Just(asset("plate-with-holes")),
        Just(asset("half-round-cap")),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: CASES, ..ProptestConfig::default() })]

    #[test]
    fn right_meshes_pass_in_any_order_rounding_and_plane(domain in domains(), seed: u64) {
        let mut random = Random::new(seed);
        let list = List::least(&domain).shuffled(&mut random);
        let least = list.verify(&domain).unwrap();
        prop_assert_eq!(least.farthest, 0.0);
        prop_assert!(!least.is_reversed);
        for other in [rounded(&list), six_digits(&list), list.unwelded(), list.clone().reversed(),
            rounded(&list).unwelded().shuffled(&mut random)]
        {
            let verified = other.verify(&domain).unwrap();
            prop_assert_eq!(verified.max_degree, least.max_degree);
            prop_assert_eq!(verified.interior_points, 0);
            prop_assert!(verified.farthest < 1e-6);
        }
        for plane in [MatchedPlane::Floor, MatchedPlane::Xz] {
            let verified = verify::triangulation(&list.mesh(plane), &domain, None).unwrap();
            prop_assert_eq!(&verified.degrees, &least.degrees);
        }
    }

    #[test]
    fn damaged_meshes_are_found(domain in domains(), seed: u64) {
        let mut random = Random::new(seed);
        let list = List::least(&domain).shuffled(&mut random);
        for (name, damage, kinds) in DAMAGES {
            let mut damaged = list.clone();
            if !damage(&mut damaged, &mut random) {
                continue;
            }
            // A file says nothing else if its vertices are in another order.
            let damaged = damaged.shuffled(&mut random);
            match damaged.verify(&domain) {
                Ok(_) => prop_assert!(false, "{name} is not found: {damaged:?}"),
                Err(defect) => {
                    let message = defect.to_string();
                    prop_assert!(kinds.contains(&defect.kind), "{name}: {message}");
                    prop_assert!(!message.contains("expected"), "{name}: {message}");
                }
            }
        }
    }
}

type Damage = fn(&mut List, &mut Random) -> bool;

/// Each kind of damage, and the kinds of defects that name it.
const DAMAGES: [(&str, Damage, &[&str]); 14] = [
    (
        "missing triangle",
        |list, random| {
            list.triangles.swap_remove(random.below(list.triangles.len()));
            !list.triangles.is_empty()
        },
        &["open_boundary", "open_edge", "no_vertex"],
    ),
    (
        "turned triangle",
        |list, random| {
            let index = random.below(list.triangles.len());
            list.triangles[index].swap(0, 1);
            list.triangles.len() > 2
        },
        &["turned_over"],
    ),
    (
        "triangle twice",
        |list, random| {
            let index = random.below(list.triangles.len());
            list.triangles.push(list.triangles[index]);
            true
        },
        &["repeated_triangle"],
    ),
    (
        "moved vertex",
        |list, random| {
            let index = random.below(list.points.len());
            list.points[index].x += 0.01;
            true
        },
        &["no_vertex"],
    ),
    (
        "swapped vertices",
        |list, random| {
            // Swaps two points, so that triangles cross.
            let [a, b] = [random.below(list.points.len()), random.below(list.points.len())];
            list.points.swap(a, b);
            let are_alike =
                |corners: &[u32; 3]| corners.contains(&(a as u32)) == corners.contains(&(b as u32));
            !list.triangles.iter().all(are_alike) && list.triangles.len() > 3
        },
        &["turned_over", "no_area", "outside", "open_boundary", "overlap", "open_edge"],
    ),
    (
        "diagonal that crosses",
        |list, random| {
            // A triangle gets a vertex of no neighbour of its own.
            let index = random.below(list.triangles.len());
            let mut corners = list.triangles[index];
            let other = random.below(list.points.len()) as u32;
            if corners.contains(&other) {
                return false;
            }
            corners[random.below(3)] = other;
            list.triangles[index] = corners;
            list.triangles.len() > 2
        },
        &[
            "turned_over",
            "no_area",
            "outside",
            "open_boundary",
            "overlap",
            "open_edge",
            "no_vertex",
            "repeated_triangle",
        ],
    ),
    (
        "hole",
        |list, random| {
            let vertex = random.below(list.points.len()) as u32;
            let count = list.triangles.len();
            list.triangles.retain(|corners| !corners.contains(&vertex));
            list.triangles.len() < count && !list.triangles.is_empty()
        },
        &["no_vertex", "open_boundary", "open_edge"],
    ),
    ("vertex on a boundary edge", |list, random| split(list, random, true), &["open_boundary"]),
    ("T-junction", |list, random| split(list, random, false), &["open_edge"]),
    (
        "overlapping triangle",
        |list, random| {
            let [a, b, c] = list.triangles[random.below(list.triangles.len())];
            let center = [a, b, c].map(|v| list.points[v as usize]).iter().sum::<DVec2>() / 3.0;
            list.points.push(center);
            list.triangles.push([a, b, list.points.len() as u32 - 1]);
            true
        },
        &["overlap"],
    ),
    (
        "no area",
        |list, random| {
            let index = random.below(list.triangles.len());
            let [a, b, _] = list.triangles[index];
            list.triangles[index] = [a, b, b];
            true
        },
        &["repeated_vertex", "no_vertex"],
    ),
    (
        "off the plane",
        |list, random| {
            // In the plane of the test a damaged vertex is as good as gone.
            let index = random.below(list.points.len());
            list.points[index] *= 3.0;
            list.points[index] += 1.0;
            true
        },
        &["no_vertex"],
    ),
    (
        "other size",
        |list, _| {
            list.points.iter_mut().for_each(|point| *point *= 1000.0);
            true
        },
        &["no_vertex"],
    ),
    (
        "interior vertex outside its star",
        |list, random| {
            let index = random.below(list.triangles.len());
            let [a, b, c] = list.triangles[index];
            let [p, q, r] = [a, b, c].map(|v| list.points[v as usize]);
            let new = list.points.len() as u32;
            // Beyond the edge from b to c, as seen from a.
            list.points.push((q + r) / 2.0 + 0.5 * ((q + r) / 2.0 - p));
            list.triangles[index] = [a, b, new];
            list.triangles.push([b, c, new]);
            list.triangles.push([c, a, new]);
            true
        },
        // Where a vertex is there already, that is told.
        &["turned_over", "repeated_triangle", "repeated_vertex", "no_area", "overlap"],
    ),
];

/// Puts a vertex on an edge of one triangle: at the boundary, or so that the neighbour does not know it.
fn split(list: &mut List, random: &mut Random, at_boundary: bool) -> bool {
    let start = random.below(list.triangles.len());
    for step in 0..list.triangles.len() {
        let index = (start + step) % list.triangles.len();
        for corner in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| list.triangles[index][(corner + i) % 3]);
            let is_edge = |t: &[u32; 3]| (0..3).any(|i| t[i] == b && t[(i + 1) % 3] == a);
            if list.triangles.iter().any(is_edge) == at_boundary {
                continue;
            }
            let middle = (list.points[a as usize] + list.points[b as usize]) / 2.0;
            let new = list.points.len() as u32;
            // Halves of these coordinates are exact, or the middle is off the line by a rounding.
            list.points.push(middle);
            list.triangles[index] = [a, new, c];
            list.triangles.push([new, b, c]);
            return true;
        }
    }
    false
}

#[test]
fn interior_points_are_accepted_and_damage_among_them_is_found() {
    let domain = asset("plate-with-holes");
    let list = List::interior(&domain);
    let boundary_points = domain.rings().vertex_count() as usize;
    let mut random = Random::new(7);
    for other in [rounded(&list), six_digits(&list.shuffled(&mut random)), list.unwelded()] {
        let verified = other.verify(&domain).unwrap();
        assert_eq!(verified.interior_points, list.points.len() - boundary_points);
        let optimality = verify::optimality(&verified, &domain, Progress::NONE).unwrap();
        assert!(matches!(optimality, Optimality::Unknown { .. }));
    }
    for (name, damage, _) in DAMAGES {
        for seed in 0..8 {
            let (mut damaged, mut random) = (list.clone(), Random::new(seed));
            let inside = boundary_points + random.below(list.points.len() - boundary_points);
            if name == "moved vertex" {
                // Moves an interior point as far as across the domain.
                damaged.points[inside] = damaged.points[0] + DVec2::new(0.1, 0.07);
            } else if matches!(name, "off the plane" | "swapped vertices")
                || !damage(&mut damaged, &mut random)
            {
                continue;
            }
            assert!(damaged.verify(&domain).is_err(), "{name}, {seed}");
        }
    }
}

/// A square of one interval a side, and the messages of what is wrong with a mesh of it.
#[test]
fn defects_say_what_and_where() {
    let domain = Domain::rectangle(2.0, 2.0, vec![Side::count(1); 4]).unwrap();
    let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0), (1.0, 0.0)];
    let points = points.map(|(x, y)| DVec3::new(x, y, 0.0));
    let message = |points: &[DVec3], triangles: &[[u32; 3]]| {
        let mesh = TriMesh::new(points.to_vec(), triangles.to_vec()).unwrap();
        verify::triangulation(&mesh, &domain, None).unwrap_err().to_string()
    };
    let star = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let mut lifted = points;
    lifted[4].z = 0.5;
    let mut moved = points;
    moved[2].x = 2.00001;
    let mut far = points;
    far[2].x = 2.5;
    // Its coordinates round by more than the square's size.
    let mut beside_unused = far.to_vec();
    beside_unused.push(DVec3::new(1e17, 0.0, 0.0));
    for (found, expected) in [
        (
            message(&beside_unused, &star),
            "no vertex is at boundary point 2 on side 3, (2, 2): the nearest, vertex 2, is 0.5 away, \
             and 2e-6 is the tolerance",
        ),
        (
            message(&lifted, &star),
            "vertex 4 is 0.5 off the plane of the others; a domain is planar, in x and y or in x and z",
        ),
        (
            message(&moved, &star),
            "no vertex is at boundary point 2 on side 3, (2, 2): the nearest, vertex 2, is 0.00001 away, \
             and 2e-6 is the tolerance; if the mesh was rounded, give a larger --tolerance",
        ),
        (
            message(&far, &star),
            "no vertex is at boundary point 2 on side 3, (2, 2): the nearest, vertex 2, is 0.5 away, \
             and 2e-6 is the tolerance",
        ),
        (
            message(&points.map(|point| point * 1000.0), &star),
            "no vertex is at boundary point 1 on side 2, (2, 0): the nearest, vertex 0, is 2 away, and \
             2e-6 is the tolerance; the mesh is 1000 times as large as the domain: is its unit \
             another one?",
        ),
        (
            message(&points.map(|point| point + DVec3::new(0.0, 5.0, 0.0)), &star),
            "no vertex is at boundary point 0 on side 1, (0, 0): the nearest, vertex 0, is 5 away, and \
             2e-6 is the tolerance; the mesh seems to be moved by (0, 5)",
        ),
        (
            message(&points, &[star[0], star[1], star[2], [3, 0, 0]]),
            "triangle 3 (vertices 3, 0, 0) near (0, 0.666667) has two corners in one place",
        ),
        (
            message(&points, &[star[0], star[1], star[2], star[3], [2, 4, 1]]),
            "triangle 4 (vertices 2, 4, 1) near (1.66667, 1) has the same vertices as triangle 1",
        ),
        (
            message(&points, &[[0, 1, 5], [0, 5, 4], [5, 1, 4], star[1], star[2], star[3]]),
            "triangle 0 (vertices 0, 1, 5) near (1, 0) has no area",
        ),
        (
            message(&points, &[star[0], star[1], star[2], [0, 3, 4]]),
            "triangle 3 (vertices 0, 3, 4) near (0.333333, 1) is turned over: it runs the other way round \
             than the others",
        ),
        (
            message(&points, &[[0, 1, 2], [0, 2, 3], [0, 1, 4]]),
            "triangles 0 and 2 overlap: both are on the same side of the edge from vertex 0 to vertex 1 \
             near (1, 0)",
        ),
        (
            message(&points, &star[1..]),
            "no triangle has the edge from vertex 0 to vertex 1 near (1, 0), on side 1 of the boundary",
        ),
        (
            message(&points, &[[0, 5, 4], [5, 1, 4], star[1], star[2], star[3]]),
            "no triangle has the edge from vertex 0 to vertex 1 near (1, 0), on side 1 of the boundary; \
             vertex 5 lies on it",
        ),
        (
            // Vertex 2 is on the line of the edge from vertex 3 to vertex 6, and beyond its end.
            message(
                &[&points[..], &[DVec3::new(1.0, 2.0, 0.0)]].concat(),
                &[star[0], star[1], [2, 6, 4], star[3]],
            ),
            "no triangle has the edge from vertex 2 to vertex 3 near (1, 2), on side 3 of the boundary; \
             vertex 6 lies on it",
        ),
        (
            message(&points, &[[0, 1, 2], [0, 4, 3], [4, 2, 3]]),
            "triangle 0 has no neighbour at the edge from vertex 2 to vertex 0 near (1, 1), inside the \
             domain; vertex 4 lies on it",
        ),
    ] {
        assert_eq!(found, expected);
    }
    // From (2, 0) to (4, 2), moved back to the origin.
    let beside = Domain::from_json(
        r#"{"rectangle": {"width": 2, "height": 2, "origin": [2, 0]}, "size": 2}"#,
    );
    let mesh = TriMesh::new(points.to_vec(), star.to_vec()).unwrap();
    let error = verify::triangulation(&mesh, &beside.unwrap(), None).unwrap_err().to_string();
    assert!(error.ends_with("the mesh seems to be moved by (-2, 0)"), "{error}");
    let larger = NonTriangles { quads: 1, polygons: 2, ..NonTriangles::default() };
    let mesh = TriMesh::new(points.to_vec(), star.to_vec()).unwrap().with_non_triangles(larger);
    let error = verify::triangulation(&mesh, &domain, None).unwrap_err();
    assert_eq!(error.kind, "larger_faces");
    assert!(error.message.starts_with("3 faces have"), "{error}");
    let mesh = TriMesh::new(points.to_vec(), star.to_vec()).unwrap();
    let error = verify::triangulation(&mesh, &domain, Some(1.0)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a tolerance of 1 is too large: the shortest interval is 2 long; give less than half of that"
    );
}

/// which answer the degree gets, for each kind of proof and where there is none.
#[test]
fn optimality_is_proven_refuted_or_open() {
    let of = |domain: &Domain, list: &List| {
        let verified = list.verify(domain).unwrap();
        match verify::optimality(&verified, domain, Progress::NONE).unwrap() {
            Optimality::Optimal { proof } => proof.kind().to_owned(),
            Optimality::Improvable { reached, .. } => format!("no: {reached}"),
            Optimality::Unknown { reason, .. } => format!("unknown: {reason}"),
        }
    };
    let json = |text: &str| Domain::from_json(text).unwrap();
    let constrained = json(
        r#"{"rectangle": {"width": 4, "height": 3}, "size": 1, "sides": [
            {}, {}, {"outside_degree": 3}, {"max_degree": 4}]}"#,
    );
    for (domain, kind) in [
        (asset("figure-1"), "balanced_cut"),
        (asset("gusset"), "no_balanced_cut"),
        (asset("dominated-side"), "long_side"),
        (asset("l-bracket"), "counting"),
        (asset("plate-with-holes"), "counting"),
        (constrained, "search"),
        (
            json(
                r#"{"polygon": {"corners": [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]]}, "sides": [
                    {"intervals": 13}, {"intervals": 6}, {"intervals": 6}, {"intervals": 6},
                    {"intervals": 6}, {"intervals": 13}]}"#,
            ),
            "blocked_zig_zags",
        ),
        (
            json(
                r#"{"polygon": {"corners": [[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]]}, "sides": [
                    {"intervals": 2}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2},
                    {"intervals": 60}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2}]}"#,
            ),
            "apexes",
        ),
    ] {
        assert_eq!(of(&domain, &List::least(&domain)), kind);
    }

    // A fan from vertex 3 reaches less than the degree that a zig-zag has.
    let domain = Domain::rectangle(4.0, 3.0, [3, 3, 3, 3].map(Side::count).to_vec()).unwrap();
    let mesh = mindeg::mesh(&domain, Goal::KeepAngle(1.0), Progress::NONE).unwrap().mesh;
    assert!(mesh.max_degree() > 4);
    let delaunay = List { points: mesh.points().collect(), triangles: mesh.triangles().collect() };
    assert_eq!(of(&domain, &delaunay), "no: 4");

    // Degree 4 takes as many vertices around a hole as around the outside.
    let domain = json(
        r#"{"polygon": {"corners": [[0, 0], [3, 0], [3, 3], [0, 3]]}, "size": 0.3,
            "holes": [{"corners": [[1, 1], [2, 1], [2, 2], [1, 2]], "size": 0.2}]}"#,
    );
    assert_eq!(of(&domain, &List::least(&domain)), "no_strip");
    // Windows reach 7, and the bounds are 4 to 5.
    let domain = json(
        r#"{"ring": [[0, -4112], [25, 625], [-22, 484]], "holes": [
            {"ring": [[5, -1856], [3, -2013], [4, -1392], [10, -1980]]},
            {"ring": [[17, -494], [12, 120], [15, 86], [15, 63], [14, -14]]}]}"#,
    );
    assert_eq!(of(&domain, &List::least(&domain)), "refuted");
}

/// A vertex inside was taken for a boundary point near it, which has a vertex of its own.
#[test]
fn a_mesh_in_metres_of_a_domain_in_micrometres_passes() {
    let domain = Domain::from_json(
        r#"{"ring": [[9e-06, 2e-06], [8e-06, 6e-06], [0.0, 1e-06]], "holes": [{"ring":
            [[4e-06, 2e-06], [4.9999999999999996e-06, 3e-06], [4.9999999999999996e-06, 2e-06]]}]}"#,
    )
    .unwrap();
    let list = List::interior(&domain);
    let verified = list.verify(&domain).unwrap();
    assert_eq!(verified.interior_points, list.points.len() - 6);
    // With a tolerance as wide, too.
    let mesh = list.mesh(MatchedPlane::Xy);
    assert!(verify::triangulation(&mesh, &domain, Some(2.4e-7)).is_ok());
    // The default is a share of the domain's extent.
    assert!((verified.tolerance / (1e-6 * 9e-6) - 1.0).abs() < 0.2, "{}", verified.tolerance);
}
