//! Surfaces in space: degrees, angles, features, distances and bytes of their meshes.

#[path = "../examples/surfaces/models.rs"]
mod models;

use glam::DVec3;
use mindeg_interior::{RemeshOptions, Remeshed, remesh};
use mindeg_mesh::Progress;
use mindeg_surfaces::{FeatureRules, Surface};

fn surface(name: &str) -> (Surface, f64) {
    let found = models::all().into_iter().find(|model| model.0 == name).unwrap();
    let (points, triangles, size) = found.1;
    let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default()).unwrap();
    (surface, size.unwrap())
}

fn mesh(surface: &Surface, size: f64) -> Remeshed {
    let options = RemeshOptions { size: Some(size), ..RemeshOptions::default() };
    remesh(surface, &options, Progress::NONE).unwrap()
}

/// The edges at each point, and the number of edges with one triangle.
fn degrees(mesh: &Remeshed) -> (Vec<i64>, usize) {
    let mut halves: Vec<[u32; 2]> = Vec::new();
    for &[a, b, c] in &mesh.triangles {
        halves.extend([[a, b], [b, c], [c, a]]);
    }
    let directed = halves.len();
    halves.sort_unstable();
    halves.dedup();
    assert_eq!(halves.len(), directed, "no two triangles use an edge in one direction");
    let mut edges: Vec<[u32; 2]> = halves.iter().map(|[a, b]| [*a.min(b), *a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; mesh.points.len()];
    edges.iter().flatten().for_each(|v| degrees[*v as usize] += 1);
    (degrees, 2 * edges.len() - directed)
}

fn euler(mesh: &Remeshed, edges: usize) -> i64 {
    mesh.points.len() as i64 - edges as i64 + mesh.triangles.len() as i64
}

#[test]
fn closed_surfaces_have_degrees_five_to_seven() {
    // The least minimum angle that is wanted, and the Euler characteristic.
    for (name, coarser, angle, chi) in [
        ("cube", 2.0, 35.0, 2),
        ("sphere", 2.0, 35.0, 2),
        ("cylinder", 2.0, 34.0, 2),
        ("torus", 1.5, 35.0, 0),
        ("plate", 2.0, 34.0, 2),
        ("lshape", 1.5, 34.0, 2),
    ] {
        let (surface, size) = surface(name);
        let mesh = mesh(&surface, coarser * size);
        let (degrees, boundary) = degrees(&mesh);
        assert_eq!(boundary, 0, "{name}");
        assert!(degrees.iter().all(|d| (5..=7).contains(d)), "{name} {:?}", mesh.report);
        assert!(mesh.report.off_degree.is_empty());
        assert_eq!(euler(&mesh, 3 * mesh.triangles.len() / 2), chi);
        assert_eq!(degrees.iter().map(|d| 6 - d).sum::<i64>(), 6 * chi);
        assert!(mesh.report.min_angle > angle, "{name}: {}", mesh.report.min_angle);
    }
}

#[test]
fn the_boundary_of_an_open_surface_keeps_its_corners_and_low_degrees() {
    let (surface, size) = surface("saddle");
    let mesh = mesh(&surface, 1.5 * size);
    let (degrees, boundary) = degrees(&mesh);
    assert!(boundary > 20 && mesh.report.off_degree.is_empty());
    let mut on_boundary = vec![false; degrees.len()];
    for edge in mesh.curves.iter().flat_map(|curve| &curve.edges) {
        edge.iter().for_each(|v| on_boundary[*v as usize] = true);
    }
    for (v, degree) in degrees.iter().enumerate() {
        let range = if on_boundary[v] { 2..=5 } else { 5..=7 };
        assert!(range.contains(degree), "{v}: {degree}");
    }
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        assert!(mesh.points.contains(&DVec3::new(x, y, 0.0)));
    }
    assert!(mesh.report.min_angle > 35.0);
}

#[test]
fn features_keep_their_curves_and_planes_their_points() {
    let (surface, size) = surface("cube");
    let mesh = mesh(&surface, 2.0 * size);
    assert_eq!((mesh.curves.len(), surface.curves().len()), (12, 12));
    let on_face = |p: &DVec3| p.to_array().iter().any(|x| *x == 0.0 || *x == 1.0);
    assert!(mesh.points.iter().all(on_face));
    for curve in &mesh.curves {
        // Each of the cube's edges is there in its whole length.
        let length =
            |[a, b]: &[u32; 2]| mesh.points[*a as usize].distance(mesh.points[*b as usize]);
        let total: f64 = curve.edges.iter().map(length).sum();
        assert!((total - 1.0).abs() < 1e-12);
    }
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.points[v as usize]);
        0.5 * (b - a).cross(c - a).length()
    };
    assert!((mesh.triangles.iter().map(area).sum::<f64>() - 6.0).abs() < 1e-12);
}

#[test]
fn a_spike_is_not_eaten() {
    let (surface, size) = surface("spike");
    let mesh = mesh(&surface, size);
    let top = |points: &[DVec3]| points.iter().map(|p| p.z).fold(0.0, f64::max);
    let lost = top(surface.points()) - top(&mesh.points);
    assert!(lost < 0.2 * size, "{lost}");
    assert!(mesh.report.off_degree.is_empty() && mesh.report.min_angle > 35.0);
}

#[test]
fn equal_input_gives_equal_meshes() {
    let (surface, size) = surface("sphere");
    assert_eq!(mesh(&surface, 2.0 * size), mesh(&surface, 2.0 * size));
}

#[test]
fn options_without_meaning_and_breaks_are_refused() {
    let (surface, size) = surface("cube");
    for options in [
        RemeshOptions { size: Some(0.0), ..RemeshOptions::default() },
        RemeshOptions { size: Some(f64::NAN), ..RemeshOptions::default() },
        RemeshOptions { tolerance: Some(-1.0), ..RemeshOptions::default() },
        RemeshOptions { target_angle: Some(60.0), ..RemeshOptions::default() },
    ] {
        assert!(remesh(&surface, &options, Progress::NONE).is_err(), "{options:?}");
    }
    let broken = |_: mindeg_mesh::Step<'_>| std::ops::ControlFlow::Break(());
    let options = RemeshOptions { size: Some(size), ..RemeshOptions::default() };
    let found = remesh(&surface, &options, Progress::new(&broken));
    assert_eq!(found, Err(mindeg_interior::RemeshError::Cancelled));
}

#[test]
fn kept_samples_stay_bit_for_bit_and_none_come_between_them() {
    // Graded samples on the boundary of a bent sheet.
    let n = 12;
    let x = |i: u32| {
        let share = f64::from(i) / f64::from(n);
        2.0 * share * (0.6 + 0.4 * share) - 1.0
    };
    let point = |v: u32| {
        let (x, y) = (x(v % (n + 1)), x(v / (n + 1)));
        DVec3::new(x, y, 0.3 * (x * x - y * y))
    };
    let points: Vec<DVec3> = (0..(n + 1) * (n + 1)).map(point).collect();
    let cells = (0..n * n).map(|c| c / n * (n + 1) + c % n);
    let triangles: Vec<[u32; 3]> =
        cells.flat_map(|v| [[v, v + 1, v + n + 2], [v, v + n + 2, v + n + 1]]).collect();
    let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default()).unwrap();
    let options =
        RemeshOptions { size: Some(0.15), keep_boundary: true, ..RemeshOptions::default() };
    let mesh = remesh(&surface, &options, Progress::NONE).unwrap();
    let sorted = |edges: Vec<[DVec3; 2]>| {
        let bits = |p: DVec3| p.to_array().map(f64::to_bits);
        let mut edges: Vec<_> = edges
            .into_iter()
            .map(|[a, b]| if bits(a) < bits(b) { [bits(a), bits(b)] } else { [bits(b), bits(a)] })
            .collect();
        edges.sort_unstable();
        edges
    };
    let before = surface.spans().iter().map(|s| s.vertices.map(|v| surface.points()[v as usize]));
    let after = mesh.curves.iter().flat_map(|curve| &curve.edges);
    let after = after.map(|edge| edge.map(|v| mesh.points[v as usize]));
    assert_eq!(sorted(before.collect()), sorted(after.collect()));
    assert!(mesh.report.off_degree.is_empty(), "{:?}", mesh.report);
    assert!(mesh.report.min_angle > 33.0, "{:?}", mesh.report);
}
