//! Domains that lie beside each other, such as islands: shared among all threads, and meshed as one mesh.
//!
//! Limits: nothing checks that they do not overlap.

use std::cmp::Reverse;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use mindeg_domain::Domain;
use mindeg_mesh::parallel::map_all;
use mindeg_mesh::{Cancelled, Progress, Step, TriMesh};

use crate::error::MeshError;
use crate::goal::{Goal, mesh};
use crate::meshed::Meshed;

/// Does work on each of several domains, shared among all threads; `progress` hears one count of `what`. The results are in the
/// order of the domains.
///
/// # Errors
///
/// The first error in the order of the domains, with the index of its domain.
pub fn each<R: Send, E: Send>(
    domains: &[Domain],
    what: &str,
    progress: Progress<'_>,
    work: impl Fn(&Domain, Progress<'_>) -> Result<R, E> + Sync,
) -> Result<Vec<R>, (usize, E)> {
    let weight = |domain: &Domain| u64::from(domain.placement().vertex_count());
    let (total, done) = (domains.iter().map(weight).sum::<u64>(), AtomicU64::new(0));
    // The largest take longest, so they begin first.
    let mut order: Vec<usize> = (0..domains.len()).collect();
    order.sort_by_key(|&index| Reverse(weight(&domains[index])));
    let found = map_all(order.clone(), |index| {
        let (told, weight) = (AtomicU64::new(0), weight(&domains[index]));
        let tell = |step: Step<'_>| {
            let own = weight * step.done.min(step.total) / step.total.max(1);
            let more = own.saturating_sub(told.fetch_max(own, Relaxed));
            let done = done.fetch_add(more, Relaxed) + more;
            match progress.report(what, done, total) {
                Ok(()) => ControlFlow::Continue(()),
                Err(Cancelled) => ControlFlow::Break(()),
            }
        };
        work(&domains[index], Progress::new(&tell))
    });
    let mut found: Vec<_> = order.into_iter().zip(found).collect();
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(index, found)| found.map_err(|error| (index, error))).collect()
}

/// A mesh of several domains from their boundary points alone.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshBeside {
    /// The mesh: the vertices of the first domain come first; groups of one name are one group.
    pub mesh: TriMesh,
    /// The mesh of each domain, with what is known of its degree.
    pub parts: Vec<Meshed>,
}

impl MeshBeside {
    /// A degree that no mesh of all domains is below, and whether some mesh is known to have it.
    #[must_use]
    pub fn least_max_degree(&self) -> (u32, bool) {
        let least = self.parts.iter().map(|part| part.least_max_degree).fold(0, u32::max);
        let has = |part: &Meshed| part.is_least_proven || part.mesh.max_total_degree() <= least;
        (least, self.parts.iter().all(has))
    }
}

/// Meshes domains that lie beside each other, each as the goal asks for: a share of the minimum angle is that of its own
/// Delaunay triangulation. The domains are shared among all threads.
///
/// # Errors
///
/// No domain, or the errors of [`mesh`], with the index of the first domain that has one.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Goal, Progress, Side, Triangles, beside};
///
/// let square = |at: f64| {
///     let corners = [[at, 0.0], [at + 1.0, 0.0], [at + 1.0, 1.0], [at, 1.0]];
///     Domain::polygon(corners, vec![Side::count(2); 4])
/// };
/// let squares = [square(0.0)?, square(3.0)?];
/// let found = beside::mesh_all(&squares, Goal::LeastDegree, Progress::NONE).map_err(|(_, error)| error)?;
/// assert_eq!((found.mesh.triangle_count(), found.least_max_degree()), (12, (4, true)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_all(
    domains: &[Domain],
    goal: Goal,
    progress: Progress<'_>,
) -> Result<MeshBeside, (usize, MeshError)> {
    let work = |domain: &Domain, progress: Progress<'_>| mesh(domain, goal, progress);
    let parts = each(domains, "triangulating", progress, work)?;
    let mut all: Option<TriMesh> = None;
    for (index, part) in parts.iter().enumerate() {
        let own = TriMesh::of(&part.mesh).map_err(|error| (index, error.into()))?;
        all = Some(match all {
            None => own,
            Some(all) => all.with_mesh_added(&own).map_err(|error| (index, error.into()))?,
        });
    }
    let all = all.ok_or_else(|| (0, MeshError::refused("there is no domain")))?;
    Ok(MeshBeside { mesh: all.with_groups_merged(), parts })
}
