//! The convex outlines that inspections find, and those that are none.

use glam::{DQuat, DVec2, DVec3};
use mindeg::inspection::{FoundOutline, Inspection, InspectionOptions, NoConvexOutline};
use mindeg::{BoundaryMesh, Domain, Side, Spacing};
use mindeg_formats::{MeshPlane, SurfaceOptions, glb, obj};
use mindeg_mesh::TriMesh;
use proptest::prelude::*;
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

fn inspect(mesh: &TriMesh) -> Inspection {
    Inspection::of(mesh, &InspectionOptions::default())
}

/// The outline of a fan from the first point.
fn outline_of(points: &[DVec3], corner_angle: f64) -> Result<FoundOutline, NoConvexOutline> {
    let last = points.len() as u32 - 1;
    let fan = (1..last).map(|i| [0, i, i + 1]).collect();
    let mesh = TriMesh::new(points.to_vec(), fan).unwrap();
    let options = InspectionOptions { corner_angle, ..InspectionOptions::default() };
    Inspection::of(&mesh, &options).outline
}

fn in_xy(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

fn obj(mesh: &BoundaryMesh, options: &SurfaceOptions) -> TriMesh {
    let mut file = Vec::new();
    obj::write(mesh, options, &mut file).unwrap();
    obj::read(&file[..]).unwrap()
}

fn glb(mesh: &BoundaryMesh, options: &SurfaceOptions) -> TriMesh {
    let mut file = Vec::new();
    glb::write(mesh, options, &mut file).unwrap();
    glb::read(&file[..], |_| Err(io::ErrorKind::Unsupported.into())).unwrap()
}

/// An inspection of a least-degree mesh that has been written and read.
fn check(mesh: &BoundaryMesh, read: &TriMesh) -> Result<(), TestCaseError> {
    let found = inspect(read);
    let boundary = mesh.rings();
    let outline = found.outline.as_ref().unwrap();
    prop_assert!(boundary.sides().eq(outline.intervals.iter().copied()), "{:?}", outline);
    let corners = (0..boundary.side_count()).map(|side| boundary.corner(side));
    prop_assert!(corners.eq(outline.corners.iter().copied()));
    prop_assert_eq!(found.max_degree(), mesh.max_degree());
    let [n, k] = [mesh.vertex_count() as usize, mesh.triangle_count() as usize];
    let counts =
        (found.vertex_count, found.face_count, found.edge_count, found.boundary_edge_count);
    prop_assert_eq!(counts, (n, k, 2 * n - 3, n));
    prop_assert_eq!((found.euler_characteristic, found.component_count), (1, 1));
    prop_assert!(found.inconsistent_edges.is_empty());
    for vertex in &found.poles {
        prop_assert_eq!(vertex.degree, mesh.degree(vertex.vertex));
    }
    Ok(())
}

#[test]
fn the_example_domains_are_recognized() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/domains");
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let domain = Domain::from_json(&std::fs::read_to_string(&path).unwrap()).unwrap();
        // Convex outlines with straight sides are recognized.
        if domain.convex().is_none_or(|form| form.boundary().side_count() != domain.sides().len()) {
            continue;
        }
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let floor = SurfaceOptions { plane: MeshPlane::Floor, ..SurfaceOptions::default() };
        for read in [obj(&mesh, &SurfaceOptions::default()), glb(&mesh, &floor)] {
            check(&mesh, &read).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let found = inspect(&read);
            let [least, expected] =
                [found.quality.metric("min_angle").unwrap().min, mesh.angle_range().min];
            // A .glb has 32-bit floats.
            assert!((least / expected - 1.0).abs() < 1e-4, "{}: {least}", path.display());
        }
    }
}

#[test]
fn sides_and_corners_by_the_angle() {
    let square = in_xy(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    // The vertex in the first side is 0.02 below: a turn of 2.3 degrees.
    let mut bent = square.clone();
    bent[1].y = -0.02;
    for (points, corner_angle, intervals) in [
        (&square, 1.0, &[2, 1, 1, 1][..]),
        (&square, 0.0, &[2, 1, 1, 1]),
        (&square, 89.0, &[2, 1, 1, 1]),
        (&bent, 1.0, &[1, 1, 1, 1, 1]),
        (&bent, 3.0, &[2, 1, 1, 1]),
    ] {
        let outline = outline_of(points, corner_angle).unwrap();
        assert_eq!(outline.intervals, intervals, "{corner_angle}");
    }
    // With no angle to spare, rounding is still no corner and no fold.
    let turn = DQuat::from_xyzw(0.1, 0.7, -0.3, 0.6).normalize();
    let turned: Vec<_> = square.iter().map(|&point| turn * (point + DVec3::X) / 3.0).collect();
    assert_eq!(outline_of(&turned, 0.0).unwrap().intervals, [2, 1, 1, 1]);
    // Without a corner at the first vertex, sides start at the first that is one.
    let turned = [&square[1..], &square[..1]].concat();
    let outline = outline_of(&turned, 1.0).unwrap();
    assert_eq!((outline.corners, outline.intervals), (vec![1, 2, 3, 4], vec![1, 1, 1, 2]));
}

#[test]
fn what_is_no_convex_outline_is_told_why() {
    let around = |count: u32, point: fn(f64) -> [f64; 2]| {
        let points = (0..count).map(|i| point(TAU * f64::from(i) / f64::from(count)));
        in_xy(&points.collect::<Vec<_>>())
    };
    let circle = |angle: f64| [angle.cos(), angle.sin()];
    let mut folded = in_xy(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    folded[2].z = 0.1;
    for (points, reason) in [
        (in_xy(&[[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]]), NoConvexOutline::NotConvex),
        (in_xy(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), NoConvexOutline::TooThin),
        (
            around(10, |a| [(2.0 * a).cos() * (1.0 + a), (2.0 * a).sin()]),
            NoConvexOutline::NotConvex,
        ),
        (around(5, |a| [(2.0 * a).cos(), (2.0 * a).sin()]), NoConvexOutline::NotConvex),
        (around(1000, circle), NoConvexOutline::NotConvex),
        (around(1000, |a| [a.cos(), a.sin().min(0.0)]), NoConvexOutline::NotConvex),
        (folded, NoConvexOutline::NotPlanar),
        // Three straight sides and an arc that starts and ends with corners.
        (
            [
                in_xy(&[[-1.0, -2.0], [1.0, -2.0]]),
                (0..=400)
                    .map(|i| TAU / 2.0 * f64::from(i) / 400.0)
                    .map(|a| DVec3::new(a.cos(), 0.1 * a.sin(), 0.0))
                    .collect(),
            ]
            .concat(),
            NoConvexOutline::Curved,
        ),
    ] {
        assert_eq!(outline_of(&points, 1.0), Err(reason), "{points:?}");
    }
    // A circle of few vertices is a polygon.
    assert_eq!(outline_of(&around(100, circle), 1.0).unwrap().intervals, [1; 100]);

    let of = |positions: &[[f64; 2]], triangles: &[[u32; 3]]| {
        inspect(&TriMesh::new(in_xy(positions), triangles.to_vec()).unwrap()).outline
    };
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
    let wheel = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    assert_eq!(of(&square, &wheel), Err(NoConvexOutline::InteriorVertices));
    assert_eq!(of(&square, &wheel[..3]), Err(NoConvexOutline::NotConvex));
    assert_eq!(of(&square, &[[0, 1, 4], [2, 3, 4]]), Err(NoConvexOutline::NotADisk));
    // A Möbius strip has one boundary loop through all vertices.
    let band = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    assert_eq!(of(&square, &band), Err(NoConvexOutline::NotADisk));
    // A vertex that is not used is not in the way, nor a triangle that is turned over.
    assert_eq!(of(&square, &[[0, 1, 2], [0, 2, 3]]).unwrap().intervals, [1; 4]);
    assert_eq!(of(&square, &[[0, 1, 2], [0, 3, 2]]).unwrap().intervals, [1; 4]);
}

#[test]
fn what_32_bit_floats_blur_is_too_fine_to_tell() {
    let corners =
        |corners: &[[f64; 2]]| corners.iter().copied().map(DVec2::from).collect::<Vec<_>>();
    // Intervals near the corners are so short that 32-bit floats turn them by several degrees,
    let layer = Side::count(40).spaced(Spacing::Bump { ratio: 1e-5 });
    let layers = corners(&[[0.1, 0.2], [1.3, 0.7], [0.9, 1.7], [0.3, 1.1]]);
    // and a whole side that is so short is far from straight.
    let cut = corners(&[[0.0, 0.0], [1.0, 0.1], [1.000_006, 0.100_007], [0.3, 0.9]]);
    for (corners, side) in [(layers, layer), (cut, Side::count(7))] {
        let mesh =
            BoundaryMesh::least_degree(&Domain::polygon(corners, vec![side; 4]).unwrap()).unwrap();
        check(&mesh, &obj(&mesh, &SurfaceOptions::default())).unwrap();
        let read = glb(&mesh, &SurfaceOptions::default());
        assert_eq!(inspect(&read).outline, Err(NoConvexOutline::TooFine));
        // With corners of 20 degrees and more, such turns are none.
        let options = InspectionOptions { corner_angle: 20.0, ..InspectionOptions::default() };
        let outline = Inspection::of(&read, &options).outline.unwrap();
        assert!(mesh.rings().sides().eq(outline.intervals), "{:?}", outline.corners);
    }
}

/// Polygons on an ellipse with corners of several degrees, far from the origin or not.
fn meshes() -> impl Strategy<Value = BoundaryMesh> {
    let side = (0.1..0.7, 1_u64..30, 0.8..1.25);
    let place = prop_oneof![Just(0.0), Just(-3.7), Just(480_000.0)];
    (prop::collection::vec(side, 3..9), 0.5..2.0, place).prop_map(|(sides, width, x)| {
        let k = sides.len() as f64;
        let corner = |(i, &(shift, ..)): (usize, &(f64, u64, f64))| {
            let angle = TAU * (i as f64 + shift) / k;
            DVec2::new(x + width * angle.cos(), angle.sin())
        };
        let corners: Vec<DVec2> = sides.iter().enumerate().map(corner).collect();
        let sides = sides
            .iter()
            .map(|&(_, count, ratio)| Side::count(count).spaced(Spacing::Geometric { ratio }));
        BoundaryMesh::least_degree(&Domain::polygon(corners, sides.collect()).unwrap()).unwrap()
    })
}

proptest! {
    #[test]
    fn outlines_are_recognized_in_every_format(mesh in meshes()) {
        check(&mesh, &obj(&mesh, &SurfaceOptions::default()))?;
        check(&mesh, &glb(&mesh, &SurfaceOptions::default()))?;
    }

    #[test]
    fn in_any_plane_and_at_any_size(
        mesh in meshes(),
        turn in prop::array::uniform4(-1.0..1.0_f64),
        exponent in -250..250_i32,
    ) {
        prop_assume!(DQuat::from_array(turn).length() > 0.1);
        let turn = DQuat::from_array(turn).normalize();
        // Far from the origin, rounding is as large as intervals.
        let origin = mesh.point(0);
        let scale = 10.0_f64.powi(exponent);
        let place = |point: DVec2| turn * (point - origin).extend(0.0) * scale;
        let moved = TriMesh::new(mesh.points().map(place).collect(), mesh.triangles().collect());
        check(&mesh, &moved.unwrap())?;
    }
}
