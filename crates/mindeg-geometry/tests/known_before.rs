//! What is known of a file before it is written.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg_geometry::export::{ExportError, SurfaceOptions, gltf, obj};
use mindeg_geometry::{Domain, Mesh, Rectangle, Side, Spacing};
use std::io;

const COLORS_AND_LINES: SurfaceOptions = SurfaceOptions {
    normals: true,
    texture_coordinates: true,
    degree_colors: true,
    boundary_lines: true,
    plane: mindeg_geometry::export::Plane::Xy,
};

fn rectangle(intervals: [u64; 4], spacing: &Spacing) -> Domain {
    let side = |count| Side::count(count).spaced(spacing.clone());
    Domain::rectangle(4.0, 3.0, intervals.map(side).into()).unwrap()
}

#[test]
fn the_length_of_an_obj_is_estimated() {
    let graded = Spacing::Geometric { ratio: 1.0005 };
    for (intervals, spacing) in [
        ([3, 3, 2, 2], Spacing::Uniform),
        ([500, 400, 300, 200], Spacing::Uniform),
        ([1000; 4], Spacing::Uniform),
        ([30_000, 90, 150, 60], Spacing::Uniform),
        ([99_999, 10_000, 100_000, 1], Spacing::Uniform),
        ([20_000; 4], graded.clone()),
        ([40_000, 10, 30_000, 10], graded),
        ([20_000; 4], Spacing::Bump { ratio: 0.05 }),
        ([20_000; 4], Spacing::Beta { beta: -1.01 }),
    ] {
        let domain = rectangle(intervals, &spacing);
        let mesh = Mesh::least_degree(&domain).unwrap();
        for options in [SurfaceOptions::default(), COLORS_AND_LINES] {
            let mut file = Vec::new();
            obj::write(&mesh, &options, &mut file).unwrap();
            let estimate = obj::estimated_len(&domain, &options) as f64;
            let share = estimate / file.len() as f64;
            assert!((share - 1.0).abs() < 0.005, "{intervals:?} {spacing:?}: {share}");
        }
    }
}

#[test]
fn a_file_prepared_for_one_domain_takes_no_mesh_of_another() {
    let options = SurfaceOptions::default();
    let prepared = rectangle([3, 3, 2, 2], &Spacing::Uniform);
    let graded = Spacing::Geometric { ratio: 1.1 };
    for other in [rectangle([3, 3, 2, 3], &Spacing::Uniform), rectangle([3, 3, 2, 2], &graded)] {
        let mesh = Mesh::least_degree(&other).unwrap();
        let [mut json, mut binary] = [Vec::new(), Vec::new()];
        let glb = gltf::Glb::new(&prepared, &options).unwrap();
        let error = glb.write(&mesh, &mut binary).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidInput);
        let gltf = gltf::Gltf::new(&prepared, &options, "plate.bin").unwrap();
        let error = gltf.write(&mesh, &mut json, &mut binary).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidInput);
        assert!(json.is_empty() && binary.is_empty());
    }
}

/// There are hundreds of millions of points, and it takes no time.
#[test]
fn the_first_of_many_coincidences_is_named() {
    let crowded = Side::count(1 << 28);
    let sides = vec![Side::count(1), crowded.clone(), crowded, Side::count(1)];
    let outline = Rectangle { rotation: 30.0, ..Rectangle::new(4.0, 3.0) };
    let domain = Domain::new(mindeg_geometry::Outline::Rectangle(outline), sides).unwrap();
    for _ in 0..3 {
        let error = gltf::Gltf::new(&domain, &SurfaceOptions::default(), "x.bin").unwrap_err();
        assert!(matches!(error, ExportError::Coincident { vertices: [1, 2], .. }), "{error}");
        assert!(error.to_string().contains("or write OBJ"));
    }
}
