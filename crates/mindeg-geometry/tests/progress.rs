//! Progress of choosing and measuring a mesh.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg_core::Plans;
use mindeg_geometry::{Domain, Mesh, Progress, Side, Spacing};
use std::sync::Mutex;

#[test]
fn progress_goes_on_to_the_end_of_all_plans() {
    for intervals in [[50_000, 300, 500, 202], [50_000, 30_000, 25_000, 10_000], [3, 3, 2, 2]] {
        let spacing = Spacing::Geometric { ratio: 1.0001 };
        let side = |count| Side::count(count).spaced(spacing.clone());
        let domain = Domain::rectangle(4.0, 3.0, intervals.map(side).into()).unwrap();
        let told = Mutex::new(Vec::new());
        let watch = |progress| told.lock().unwrap().push(progress);
        // A single thread tells in the right order.
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let mesh = alone.install(|| Mesh::least_degree_watched(&domain, &watch)).unwrap();
        assert_eq!(Ok(&mesh), Mesh::least_degree(&domain).as_ref());
        let triangles = u64::from(mesh.triangle_count());
        let plans = Plans::new(domain.boundary()).count().min(64);
        let all = Progress { done: plans * triangles, total: plans * triangles };
        let told_of_plans = std::mem::take(&mut *told.lock().unwrap());
        assert!(told_of_plans.is_sorted_by_key(|told| told.done), "{told_of_plans:?}");
        assert_eq!(told_of_plans.last(), Some(&all), "{intervals:?}");

        assert_eq!(mesh.angle_range_watched(&watch), mesh.angle_range());
        let told = told.into_inner().unwrap();
        let all = Progress { done: triangles, total: triangles };
        assert!(told.contains(&all) && told.len() as u64 == triangles.div_ceil(1 << 14));
    }
}
