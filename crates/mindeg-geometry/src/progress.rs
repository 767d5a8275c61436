//! Watching work on very many triangles.
//!
//! Limits: what hears of progress cannot stop the work.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// How far the work is.
///
/// # Example
///
/// ```
/// use mindeg_geometry::{Domain, Mesh, Progress, Side};
/// use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(20_000); 4])?;
/// let left = AtomicU64::new(u64::MAX);
/// let mesh = Mesh::least_degree_watched(&domain, &|Progress { done, total }| {
///     left.fetch_min(total - done, Relaxed);
/// })?;
/// assert_eq!(left.into_inner(), 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// How many triangles have been dealt with, 0 to `total`. What turned out not to be worth
    /// looking at counts as well.
    pub done: u64,
    /// How many there are to deal with; a triangle counts anew in each plan that is tried.
    pub total: u64,
}

/// Hears of progress every ten thousand triangles or so, on any of the threads that work. Two of
/// them may tell in the wrong order. [`unwatched`] is one.
pub type Watch<'a> = &'a (dyn Fn(Progress) + Sync);

/// A [`Watch`] that looks away.
pub fn unwatched(_: Progress) {}

/// Counts what is done, for a watch.
pub(crate) struct Counter<'a> {
    done: AtomicU64,
    total: u64,
    watch: Watch<'a>,
}

impl<'a> Counter<'a> {
    pub(crate) fn new(total: u64, watch: Watch<'a>) -> Self {
        Self { done: AtomicU64::new(0), total, watch }
    }

    /// So many more are done.
    pub(crate) fn add(&self, count: usize) {
        let count = count as u64;
        let done = self.done.fetch_add(count, Relaxed) + count;
        (self.watch)(Progress { done, total: self.total });
    }

    /// So many are done in all, no less than before; nobody works meanwhile.
    pub(crate) fn reach(&self, done: u64) {
        self.done.store(done, Relaxed);
        (self.watch)(Progress { done, total: self.total });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, Mesh, Side, Spacing};
    use mindeg_core::Candidates;
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
            let plans = Candidates::new(domain.boundary()).count().min(64);
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
}
