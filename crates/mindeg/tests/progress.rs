//! Progress of choosing and measuring a mesh, and cancelling.

use mindeg::{
    BoundaryMesh, Cancelled, Domain, Goal, MeshError, Progress, Side, Spacing, Step, mesh,
};
use mindeg_core::Candidates;
use std::ops::ControlFlow;
use std::sync::Mutex;

#[test]
fn progress_goes_on_to_the_end_of_all_candidates() {
    for intervals in
        [[50_000, 300, 500, 202], [50_000, 30_000, 25_000, 10_000], [2_000, 1_000, 900, 700]]
    {
        let spacing = Spacing::Geometric { ratio: 1.0001 };
        let side = |count| Side::count(count).spaced(spacing.clone());
        let domain = Domain::rectangle(4.0, 3.0, intervals.map(side).into()).unwrap();
        let told = Mutex::new(Vec::new());
        let callback = |step: Step<'_>| {
            told.lock().unwrap().push((step.done, step.total));
            ControlFlow::Continue(())
        };
        let progress = Progress::new(&callback);
        // A single thread tells in the right order.
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let mesh = alone.install(|| mesh(&domain, Goal::LeastDegree, progress)).unwrap().mesh;
        assert_eq!(Ok(&mesh), BoundaryMesh::least_degree(&domain).as_ref());
        let triangles = u64::from(mesh.triangle_count());
        let candidates = Candidates::new(domain.convex().unwrap().boundary()).count().min(64);
        let of_choice = std::mem::take(&mut *told.lock().unwrap());
        assert!(of_choice.is_sorted_by_key(|told| told.0), "{of_choice:?}");
        let all = candidates * triangles;
        assert_eq!(of_choice.last(), Some(&(all, all)), "{intervals:?}");

        assert_eq!(mesh.measure_angles(progress), Ok(mesh.angle_range()));
        let told = told.lock().unwrap();
        assert!(told.contains(&(triangles, triangles)));
        assert_eq!(told.len() as u64, triangles.div_ceil(1 << 14));
    }
}

#[test]
fn a_callback_can_cancel() {
    let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(50_000); 4]).unwrap();
    let callback = |_: Step<'_>| ControlFlow::Break(());
    let progress = Progress::new(&callback);
    let cancelled = mesh(&domain, Goal::LeastDegree, progress);
    assert_eq!(cancelled, Err(MeshError::Cancelled(Cancelled)));
    let small = Domain::rectangle(4.0, 3.0, vec![Side::count(5); 4]).unwrap();
    let goal = Goal::MaxDegree(4);
    assert_eq!(mesh(&small, goal, progress).unwrap_err().to_string(), "cancelled");
    let made = BoundaryMesh::least_degree(&domain).unwrap();
    assert_eq!(made.measure_angles(progress), Err(Cancelled));
}
