//! A domain or model that was turned is meshed as the one that was not: rounding moves points off the
//! lines on which they were, and that must decide nothing.

use std::path::Path;

use crate::outlines::{Outline, Random};
use crate::solids::Solid;
use mindeg::glam::{DQuat, DVec2, DVec3};
use mindeg::model::mesh_model;
use mindeg::{Domain, Goal, Progress, Side, TriMesh, exact, mesh, verify};

/// Polygons and turns of each: some of the 500 and 20 that `MINDEG_FULL` asks for, which take
/// minutes.
fn sample(some: [u32; 2], all: [u32; 2]) -> [u32; 2] {
    if std::env::var_os("MINDEG_FULL").is_some() { all } else { some }
}

fn file(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/turned").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// The least degree and the minimum angle of the mesh of that degree.
fn measures(domain: &Domain) -> (u32, f64) {
    let meshed = mesh(domain, Goal::LeastDegree, Progress::NONE).unwrap();
    let degree = exact::degree(domain, Progress::NONE).unwrap();
    assert_eq!(degree.least_max_degree(), Some(meshed.mesh.max_degree()));
    (meshed.mesh.max_degree(), meshed.mesh.angle_range().min)
}

fn of_points(points: Vec<DVec2>) -> Domain {
    Domain::from_rings([points]).unwrap()
}

/// Checks that a turned domain has the same degree and nearly the same angle.
fn compare(turned: &Domain, before: (u32, f64), name: &str) {
    let (degree, angle) = measures(turned);
    assert_eq!(degree, before.0, "{name}");
    assert!(angle > 1e-4 * before.1, "{name}: {angle}° and {}°", before.1);
}

/// A turn by any angle, from numbers that look random.
fn turn(random: &mut Random) -> DVec2 {
    let angle = random.below(1 << 40) as f64 / f64::from(1 << 20);
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

#[test]
fn turned_polygons_keep_their_degrees_and_angles() {
    let [polygons, turns] = sample([60, 3], [500, 20]);
    let mut random = Random(22);
    let mut done = 0;
    while done < polygons {
        let corners = 7 + random.below(25) as usize;
        let Some(outline) = Outline::random(&mut random, corners, 35) else { continue };
        let before = measures(&of_points(outline.points.clone()));
        for _ in 0..turns {
            let turn = turn(&mut random);
            let turned = outline.points.iter().map(|&point| turn.rotate(point)).collect();
            compare(&of_points(turned), before, &format!("{turn} of {outline:?}"));
        }
        done += 1;
    }
}

/// The chord of one triangle passes a vertex by 1e-17: no mesh was written, or one of 1e-15°.
#[test]
fn domains_that_were_refused_or_got_slivers_have_their_meshes() {
    for name in ["rotated-refused", "rotated-sliver"] {
        let [turned, before] = ["", "-before-rotation"]
            .map(|end| Domain::from_json(&file(&format!("{name}{end}.json"))));
        compare(&turned.unwrap(), measures(&before.unwrap()), name);
    }
}

/// Three of its points are on a line but for rounding, and a mesh of degree 4 has a triangle on them.
#[test]
fn a_mesh_with_a_triangle_within_the_tolerance_is_not_counted_and_told_why() {
    let domain = Domain::from_json(&file("sliver.json")).unwrap();
    assert_eq!(exact::degree(&domain, Progress::NONE).unwrap().least_max_degree(), Some(5));
    let read = mindeg_formats::obj::read(file("sliver-degree4.obj").as_bytes()).unwrap();
    let refusal = |mesh: &TriMesh, domain: &Domain| {
        verify::triangulation(mesh, domain, None).unwrap_err().to_string()
    };
    assert_eq!(
        refusal(&read, &domain),
        "triangle 0 (vertices 0, 1, 2) near (0.366667, 0.233333) has no area: all its vertices are on side \
         1, where a turn of less than 1e-9 radians counts as straight"
    );
    // A notch whose tip a chord passes by a hair.
    let points = [[0.0, 0.0], [2.0, -1.0], [4.0, 0.0], [4.0, 2.0], [2.0, 1e-11], [0.0, 2.0]];
    let notched = of_points(points.map(DVec2::from).to_vec());
    let positions = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
    let passing = vec![[0, 1, 2], [0, 2, 4], [2, 3, 4], [0, 4, 5]];
    assert_eq!(
        refusal(&TriMesh::new(positions.clone(), passing).unwrap(), &notched),
        "triangle 1 (vertices 0, 2, 4) near (2, 3.33333e-12) has no area: vertex 4 is on its edge from 0 to \
         2, where a turn of less than 1e-9 radians counts as straight"
    );
    let other = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 5]];
    assert!(
        verify::triangulation(&TriMesh::new(positions, other).unwrap(), &notched, None).is_ok()
    );
}

#[test]
fn turned_prisms_keep_their_degrees() {
    let [prisms, turns] = sample([6, 2], [60, 5]);
    let mut random = Random(3);
    let mut done = 0;
    while done < prisms {
        let Some(outline) = Outline::random(&mut random, 6, 6) else { continue };
        let ring: Vec<[f64; 2]> = outline.points.iter().map(|point| point.to_array()).collect();
        let solid = Solid::prism(&ring, 30.0);
        let degrees = |solid: &Solid| {
            let model = solid.model(Side::count(2));
            let meshed = mesh_model(&model, Goal::LeastDegree, 0.05, Progress::NONE).unwrap();
            let at = |vertex: u32| meshed.mesh.positions()[vertex as usize];
            let corners = meshed
                .mesh
                .triangles()
                .iter()
                .flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]]);
            let angles = corners.map(|[a, b, c]| (at(b) - at(a)).angle_between(at(c) - at(a)));
            let angle = angles.fold(f64::INFINITY, f64::min);
            (meshed.max_degree, meshed.lower_bound, angle)
        };
        let before = degrees(&solid);
        for _ in 0..turns {
            let axis = [0; 3].map(|_: u32| random.below(2001) as f64 - 1000.5);
            let turn = DQuat::from_axis_angle(
                DVec3::from(axis).normalize(),
                random.below(628) as f64 / 100.0,
            );
            let mut turned = solid.clone();
            turned.corners.iter_mut().for_each(|corner| *corner = turn * *corner);
            let after = degrees(&turned);
            assert_eq!([after.0, after.1], [before.0, before.1], "{turn} of {outline:?}");
            assert!(after.2 > 1e-4 * before.2, "{turn} of {outline:?}: {after:?}, {before:?}");
        }
        done += 1;
    }
}
