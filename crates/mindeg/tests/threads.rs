//! How many threads there are shows in nothing but the time.

use glam::{DVec2, DVec3};
use mindeg::TriMesh;
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::quality::{QualitySummary, TriangleQuality};
use mindeg::{BoundaryMesh, Domain, Side, Spacing};
use mindeg_core::Candidates;
use rayon::ThreadPoolBuilder;

/// The result of `work`, which must be equal with 1, 2 and 5 threads.
fn with_any_threads<R: PartialEq + std::fmt::Debug + Send>(work: impl Fn() -> R + Sync) -> R {
    let [one, two, five] = [1, 2, 5].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(&work)
    });
    assert!(one == two && one == five);
    one
}

/// A zig-zag, a dominant side and a corner removal, of some dozen blocks each.
fn domains() -> impl Iterator<Item = Domain> {
    let spacings = [Spacing::Uniform, Spacing::Bump { ratio: 0.3 }, Spacing::Beta { beta: -1.2 }];
    let percent = [[25_u64, 25, 25, 25], [97, 1, 1, 1], [40, 30, 20, 10]];
    spacings.into_iter().zip(percent).map(|(spacing, percent)| {
        let side = |percent| Side::count(percent * 2011).spaced(spacing.clone());
        Domain::rectangle(4.0, 3.0, percent.map(side).into()).unwrap()
    })
}

#[test]
fn the_same_candidate_is_chosen_and_it_is_the_best() {
    for domain in domains() {
        let mesh = with_any_threads(|| BoundaryMesh::least_degree(&domain).unwrap());
        let points: Vec<DVec2> = domain.placement().points().collect();
        let minimum_angle = |triangle: [u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
            TriangleQuality::of(a, b, c).min_angle
        };
        let chosen = mesh.triangles().map(minimum_angle).fold(180.0, f64::min);
        for candidate in Candidates::new(domain.convex().unwrap().boundary()).sample(8) {
            let other = candidate.triangles().map(minimum_angle).fold(180.0, f64::min);
            assert!(chosen >= other * (1.0 - 2e-9), "{chosen} and {other}");
        }
    }
}

#[test]
fn an_index_buffer_is_filled_the_same_in_whole_and_in_parts() {
    for domain in domains() {
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let whole = with_any_threads(|| {
            let mut indices = vec![[0; 3]; mesh.triangle_count() as usize];
            mesh.fill_triangles(0, &mut indices);
            indices
        });
        assert!(mesh.triangles().eq(whole.iter().copied()));
        let in_parts = with_any_threads(|| {
            let mut indices = vec![[0; 3]; mesh.triangle_count() as usize];
            let (first, second) = indices.split_at_mut(70_001);
            mesh.fill_triangles(70_001, second);
            mesh.fill_triangles(0, first);
            indices
        });
        assert!(whole == in_parts);
    }
}

#[test]
fn measures_have_the_same_bits() {
    for domain in domains() {
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let angles = with_any_threads(|| mesh.angle_range());
        let quality = QualitySummary::of(mesh.qualities()).unwrap();
        assert_eq!(quality.triangle_count, mesh.triangle_count() as usize);
        let [least, greatest] = [quality.metrics[1].min, quality.metrics[2].max];
        assert!((least / angles.min - 1.0).abs() < 1e-9, "{least} {}", angles.min);
        assert!((greatest / angles.max - 1.0).abs() < 1e-9, "{greatest} {}", angles.max);
    }
}

/// Some copies of a piece in which everything is wrong, side by side.
fn broken(copies: u32) -> TriMesh {
    #[rustfmt::skip]
    let corners = [
        [0, 0], [2, 0], [2, 2], [0, 2], [1, 1], [1, 1], [1, 3], [1, 0],
        [4, 4], [3, 0], [4, 0], [3, 1], [4, 2], [3, 2],
    ];
    let triangles = [
        [0, 1, 4],
        [1, 2, 5],
        [5, 3, 2],
        [3, 0, 4],
        [0, 4, 3],
        [2, 6, 3],
        [6, 2, 4],
        [3, 2, 4],
        [0, 7, 1],
        [6, 6, 2],
        [9, 10, 11],
        [11, 12, 13],
    ];
    let positions = (0..copies).flat_map(|copy| {
        corners.map(|[x, y]| DVec3::new(f64::from(5 * copy + x), f64::from(y), 0.0))
    });
    let triangles = (0..copies).flat_map(|copy| {
        let first = corners.len() as u32 * copy;
        triangles.map(|triangle| triangle.map(|vertex| first + vertex))
    });
    TriMesh::new(positions.collect(), triangles.collect()).unwrap()
}

#[test]
fn many_broken_pieces_are_as_broken_as_one_each() {
    const COPIES: usize = 10_000;
    let options = InspectionOptions { pole_degree: 4, ..InspectionOptions::default() };
    let one = Inspection::of(&broken(1), &options);
    let mesh = broken(COPIES as u32);
    let all = with_any_threads(|| Inspection::of(&mesh, &options));
    let counts = |of: &Inspection| {
        [
            of.welded_count,
            of.face_count,
            of.edge_count,
            of.boundary_edge_count,
            of.boundary_loop_count,
            of.open_boundary_count,
            of.component_count,
            of.non_manifold_edges.len(),
            of.non_manifold_vertices.len(),
            of.inconsistent_edges.len(),
            of.duplicate_faces.len(),
            of.zero_area_triangles.len(),
            of.unreferenced_vertices.len(),
            of.poles.len(),
        ]
    };
    let copied = |counts: [usize; 14]| counts.map(|count| COPIES * count);
    assert_eq!(counts(&all), copied(counts(&one)));
    assert!(!counts(&one).contains(&0), "{one:#?}");
    assert_eq!(all.highest_degree, one.highest_degree);
    let last = all.duplicate_faces.last().map(|face| face % 12);
    assert_eq!(last, one.duplicate_faces.last().copied());
    for (all, one) in [
        (&all.boundary_degrees, &one.boundary_degrees),
        (&all.interior_degrees, &one.interior_degrees),
    ] {
        let copied = one.iter().map(|(degree, count)| (degree, count * COPIES as u64));
        assert!(all.iter().eq(copied));
    }
    let triangles =
        |of: &Inspection| of.worst_triangles.iter().map(|worst| worst.triangle).collect::<Vec<_>>();
    // The flat ones, and of equal ones the first.
    assert_eq!(triangles(&all), [8, 9, 20, 21, 32]);
    assert_eq!(triangles(&one)[..2], [8, 9]);
}
