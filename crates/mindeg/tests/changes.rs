//! Changes of counts of domains with holes and of polygons that are not convex, compared with all smaller changes.

use glam::DVec3;
use mindeg::changes::{CountChange, CountChanges, count_changes, model_count_changes};
use mindeg::exact::degree;
use mindeg::model::mesh_model;
use mindeg::{
    Constraints, Domain, Goal, Intervals, Model, ModelFace, ModelParts, Outline, Progress,
    Rectangle, Ring, Side, VertexConstraint,
};

fn counts(intervals: &[u64]) -> Vec<Side> {
    intervals.iter().map(|&count| Side::count(count)).collect()
}

fn rectangle([left, bottom, right, top]: [f64; 4], intervals: [u64; 4]) -> Ring {
    Ring::new([(left, bottom), (right, bottom), (right, top), (left, top)], counts(&intervals))
}

fn found(domain: &Domain, wanted: Option<u32>) -> CountChanges<Domain> {
    count_changes(domain, wanted, 1.0, Progress::NONE).expect("changes are looked for")
}

/// Calls `visit` with the domain after every change of this many intervals.
fn for_each_change(domain: &Domain, size: u64, visit: &mut dyn FnMut(&Domain)) {
    fn go(domain: &Domain, from: usize, left: u64, visit: &mut dyn FnMut(&Domain)) {
        if left == 0 {
            visit(domain);
        }
        for side in from..domain.sides().len() {
            for by in (1..=left as i64).flat_map(|by| [by, -by]) {
                let mut sides = domain.sides().to_vec();
                let count = i64::from(domain.rings().intervals(side)) + by;
                sides[side].intervals = Intervals::Count(count.max(0) as u64);
                if let Ok(changed) = domain.with_sides(sides) {
                    go(&changed, side + 1, left - by.unsigned_abs(), visit);
                }
            }
        }
    }
    go(domain, 0, size, visit);
}

#[test]
fn no_smaller_change_than_proven_leads_to_the_degree() {
    let hole = [1.0, 1.0, 3.0, 3.0];
    let annulus = |outer, inner| {
        let rings = vec![rectangle([0.0, 0.0, 4.0, 4.0], outer), rectangle(hole, inner)];
        Domain::of_rings(rings).unwrap()
    };
    let ell = [(0.0, 0.0), (6.0, 0.0), (6.0, 1.0), (1.0, 1.0), (1.0, 6.0), (0.0, 6.0)];
    let plate = [[1.0, 1.0, 2.0, 2.0], [4.0, 1.0, 5.0, 2.0]].map(|at| rectangle(at, [1; 4]));
    let plate = [vec![rectangle([0.0, 0.0, 6.0, 3.0], [16, 1, 16, 1])], plate.to_vec()].concat();
    for domain in [
        annulus([2, 2, 2, 2], [2, 1, 1, 2]),
        annulus([3, 1, 3, 1], [1, 1, 2, 2]),
        Domain::polygon(ell, counts(&[9, 1, 1, 1, 1, 1])).unwrap(),
        Domain::of_rings(plate).unwrap(),
    ] {
        let changes = found(&domain, None);
        let today = degree(&domain, Progress::NONE).unwrap();
        assert_eq!((changes.at_least, changes.reached), (today.at_least, today.reached));
        assert_eq!(changes.found.is_empty(), changes.reached == changes.floor);
        let mut reached = changes.reached;
        for change in &changes.found {
            let after = degree(&change.after, Progress::NONE).unwrap();
            assert_eq!(after.reached, change.suggestion.max_degree);
            assert!(after.reached < reached);
            reached = after.reached;
            for size in 1..change.at_least.min(3) {
                for_each_change(&domain, size, &mut |smaller| {
                    let at_least = degree(smaller, Progress::NONE).unwrap().at_least;
                    assert!(at_least > reached, "{change:?}: {:?}", smaller.sides());
                });
            }
        }
        let is_proven = |change: &CountChange<Domain>| change.at_least == change.suggestion.cost();
        assert!(changes.found.first().is_none_or(is_proven), "{:?}", changes.found);
    }
}

#[test]
fn counting_tells_what_no_change_reaches() {
    // Six triangles in a rectangle: degree 5 takes 30 vertices, and here are 22.
    let triangle = |x: f64, y: f64| {
        Ring::new([(x, y), (x + 0.8, y + 0.1), (x + 0.1, y + 0.8)], counts(&[1; 3]))
    };
    let holes = [1.0, 3.0, 5.0].into_iter().flat_map(|x| [1.0, 3.0].map(|y| triangle(x, y)));
    let outer = rectangle([0.0, 0.0, 7.0, 5.0], [1; 4]);
    let domain = Domain::of_rings(std::iter::once(outer).chain(holes).collect()).unwrap();
    let changes = found(&domain, None);
    assert_eq!((changes.reached, changes.floor), (6, 5));
    let [change] = changes.found.as_slice() else { panic!("{:?}", changes.found) };
    assert!(change.at_least >= 8 && change.suggestion.cost() >= change.at_least, "{change:?}");
    assert_eq!(change.suggestion.max_degree, 5);
    assert!(found(&domain, Some(6)).found.is_empty());
    assert_eq!(found(&change.after, None).open, None);
}

#[test]
fn points_and_limits_stay_where_they_are() {
    // Seven points inside eight: degree 4 takes one more.
    let square = |half: f64| {
        let turns = [(-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0)];
        turns.map(|(x, y)| (half * f64::from(x), half * f64::from(y)))
    };
    let rings = vec![Ring::of_points(square(2.0)), Ring::of_points(square(1.0)[..7].to_vec())];
    let domain = Domain::of_rings(rings).unwrap();
    let changes = found(&domain, None);
    let change = &changes.found[0];
    assert_eq!(
        (change.suggestion.max_degree, change.suggestion.cost(), change.at_least),
        (4, 1, 1)
    );
    let after: Vec<_> = change.after.placement().points().collect();
    assert!(domain.placement().points().all(|point| after.contains(&point)), "{after:?}");
    assert_eq!(after.len(), 16);

    let limit = VertexConstraint { vertex: 0, external_degree: 0, degree_limit: Some(5) };
    let constraints = Constraints { vertices: vec![limit], ..Constraints::default() };
    let outline = Outline::Rectangle(Rectangle::new(4.0, 3.0));
    let limited = Domain::builder(outline, counts(&[3, 2, 2, 2])).constraints(constraints);
    let error = count_changes(&limited.build().unwrap(), None, 1.0, Progress::NONE).unwrap_err();
    assert!(error.to_string().contains("of single vertices"), "{error}");
}

/// A tetrahedron; each edge gets as many intervals.
fn tetrahedron(counts: &[u64]) -> Model {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].to_vec();
    let face =
        |corners: [u32; 3]| ModelFace { loops: vec![corners.to_vec()], ..ModelFace::default() };
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(face).to_vec();
    let other_edges = Some(Side::count(1));
    let parts =
        ModelParts { corners, faces, edges: Vec::new(), other_edges, planar_tolerance: None };
    Model::new(parts).and_then(|model| model.with_intervals(counts)).expect("a tetrahedron")
}

#[test]
fn no_smaller_change_of_a_model_leads_to_the_degree() {
    let degrees = |model: &Model| {
        let mesh = mesh_model(model, Goal::LeastDegree, 1.0, Progress::NONE).unwrap();
        [mesh.lower_bound, mesh.max_degree]
    };
    for counts in [[2, 2, 2, 2, 2, 2], [5, 1, 1, 1, 1, 1], [1, 3, 1, 1, 2, 1]] {
        let model = tetrahedron(&counts);
        let changes = model_count_changes(&model, None, 1.0, Progress::NONE).unwrap();
        let [at_least, mut reached] = degrees(&model);
        assert_eq!([changes.at_least, changes.reached], [at_least, reached]);
        assert_eq!(changes.floor, 3);
        assert!(!changes.found.is_empty());
        for change in &changes.found {
            let [_, after] = degrees(&change.after);
            assert_eq!(after, change.suggestion.max_degree);
            assert!(after < reached);
            reached = after;
            // All changes of one interval.
            for edge in (0..6).filter(|_| change.at_least > 1) {
                for count in [counts[edge] - 1, counts[edge] + 1].into_iter().filter(|&n| n > 0) {
                    let mut smaller = counts;
                    smaller[edge] = count;
                    assert!(degrees(&tetrahedron(&smaller))[0] > after, "{change:?}");
                }
            }
        }
    }
}
