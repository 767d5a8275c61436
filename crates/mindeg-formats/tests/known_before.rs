//! What is known of a file before it is written.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::{BoundaryMesh, Domain, Rectangle, Side, Spacing};
use mindeg_formats::gltf::Stored;
use mindeg_formats::{Plane, SurfaceOptions, WriteError, glb, gltf, obj};

const COLORS_AND_LINES: SurfaceOptions = SurfaceOptions {
    normals: true,
    texture_coordinates: true,
    degree_colors: true,
    boundary_lines: true,
    plane: Plane::Xy,
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
        ([6400; 4], Spacing::Uniform),
        ([30_000, 90, 150, 60], Spacing::Uniform),
        ([99_999, 10_000, 100_000, 1], Spacing::Uniform),
        ([20_000; 4], graded.clone()),
        ([40_000, 10, 30_000, 10], graded),
        ([20_000; 4], Spacing::Bump { ratio: 0.05 }),
        ([20_000; 4], Spacing::Beta { beta: -1.01 }),
    ] {
        let domain = rectangle(intervals, &spacing);
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        for options in [SurfaceOptions::default(), COLORS_AND_LINES] {
            let mut file = Vec::new();
            obj::write(&mesh, &options, &mut file).unwrap();
            let estimate = obj::estimated_len(&mesh, &options) as f64;
            let share = estimate / file.len() as f64;
            assert!((share - 1.0).abs() < 0.005, "{intervals:?} {spacing:?}: {share}");
        }
    }
}

#[test]
fn the_length_of_a_gltf_is_known() {
    let mesh =
        BoundaryMesh::least_degree(&rectangle([300, 30, 20, 20], &Spacing::Uniform)).unwrap();
    for options in [SurfaceOptions::default(), COLORS_AND_LINES] {
        let stored = Stored::new(&mesh, options.plane).unwrap();
        let [mut json, mut binary, mut file] = [Vec::new(), Vec::new(), Vec::new()];
        glb::write_stored(&mesh, &stored, &options, &mut file).unwrap();
        assert_eq!(file.len() as u64, glb::file_len(&mesh, &stored, &options).unwrap());
        gltf::write_stored(&mesh, &stored, &options, "x.bin", &mut json, &mut binary).unwrap();
        let [expected_json, expected_binary] = gltf::file_lens(&mesh, &stored, &options);
        assert_eq!(binary.len() as u64, expected_binary);
        assert!(expected_json.abs_diff(json.len() as u64) < 30);
    }
}

/// There are hundreds of millions of points, and it takes no time.
#[test]
fn the_first_of_many_coincidences_is_named() {
    let crowded = Side::count(1 << 28);
    let sides = vec![Side::count(1), crowded.clone(), crowded, Side::count(1)];
    let outline = Rectangle { rotation: 30.0, ..Rectangle::new(4.0, 3.0) };
    let domain = Domain::new(mindeg::Outline::Rectangle(outline), sides).unwrap();
    for _ in 0..3 {
        let error = Stored::new(domain.placement(), Plane::Xy).unwrap_err();
        assert!(matches!(error, WriteError::Coincident { vertices: [1, 2], .. }), "{error}");
        assert!(error.to_string().contains("or write OBJ"));
    }
}
