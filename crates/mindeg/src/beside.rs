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
    each_by_index(domains, what, progress, |index, progress| work(&domains[index], progress))
}

fn each_by_index<R: Send, E: Send>(
    domains: &[Domain],
    what: &str,
    progress: Progress<'_>,
    work: impl Fn(usize, Progress<'_>) -> Result<R, E> + Sync,
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
        work(index, Progress::new(&tell))
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
    /// The part that decides the degree: the first that needs it.
    pub deciding_part: usize,
}

impl MeshBeside {
    /// The minimum angle of a Delaunay triangulation of all domains, in degrees, if that of each is known.
    #[must_use]
    pub fn delaunay_min_angle(&self) -> Option<f64> {
        delaunay_min_angle(&self.parts)
    }

    /// A degree that no mesh of all domains is below, and whether some mesh is known to have it.
    #[must_use]
    pub fn least_max_degree(&self) -> (u32, bool) {
        let least = self.parts.iter().map(|part| part.least_max_degree).fold(0, u32::max);
        let has = |part: &Meshed| part.is_least_proven || part.mesh.max_total_degree() <= least;
        (least, self.parts.iter().all(has))
    }
}

/// Meshes one domain, or several that lie beside each other as one mesh: a share of the minimum angle, and the degree within
/// which the angle is the largest, are those of all together. The domains are shared among all threads.
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
    let (parts, deciding_part) = parts_of(domains, goal, progress)?;
    let mut all: Option<TriMesh> = None;
    for (index, part) in parts.iter().enumerate() {
        let own = TriMesh::of(&part.mesh).map_err(|error| (index, error.into()))?;
        all = Some(match all {
            None => own,
            Some(all) => all.with_mesh_added(&own).map_err(|error| (index, error.into()))?,
        });
    }
    let all = all.ok_or_else(|| (0, MeshError::refused("there is no domain")))?;
    let mesh = if parts.len() > 1 { all.with_groups_merged() } else { all };
    Ok(MeshBeside { mesh, parts, deciding_part })
}

/// The meshes of the domains that [`mesh_all`] makes one of.
///
/// # Errors
///
/// The errors of [`mesh`], with the index of the first domain that has one.
pub fn mesh_parts(
    domains: &[Domain],
    goal: Goal,
    progress: Progress<'_>,
) -> Result<Vec<Meshed>, (usize, MeshError)> {
    Ok(parts_of(domains, goal, progress)?.0)
}

/// The meshes, and the index of the one that decides the degree.
fn parts_of(
    domains: &[Domain],
    goal: Goal,
    progress: Progress<'_>,
) -> Result<(Vec<Meshed>, usize), (usize, MeshError)> {
    const WHAT: &str = "triangulating";
    let own = each(domains, WHAT, progress, |domain, progress| mesh(domain, goal, progress))?;
    let degree = |meshed: &Meshed| meshed.mesh.max_total_degree();
    let highest = |all: &[Meshed]| (0..all.len()).rev().max_by_key(|&it| degree(&all[it]));
    let own = match (goal, delaunay_min_angle(&own)) {
        (Goal::KeepAngle(share), Some(most)) if own.len() > 1 => {
            // A domain whose own angles are larger keeps less of them.
            each_by_index(domains, WHAT, progress, |index, progress| {
                let meshed = &own[index];
                match meshed.delaunay_min_angle {
                    Some(angle) if angle > most => {
                        mesh(&domains[index], Goal::KeepAngle(share * most / angle), progress)
                    }
                    _ => Ok(meshed.clone()),
                }
            })?
        }
        _ => own,
    };
    let deciding = highest(&own).unwrap_or(0);
    if own.len() < 2 || !matches!(goal, Goal::KeepAngle(_) | Goal::Optimize(_)) {
        return Ok((own, deciding));
    }
    let limit = degree(&own[deciding]);
    let all = each_by_index(domains, WHAT, progress, |index, progress| {
        let meshed = &own[index];
        if degree(meshed) == limit {
            return Ok(meshed.clone());
        }
        let angle = |meshed: &Meshed| meshed.mesh.angle_range().min;
        match mesh(&domains[index], Goal::MaxDegree(limit), progress) {
            Ok(more) if angle(&more) > angle(meshed) => Ok(more.with_bound_of(meshed)),
            Ok(_) => Ok(meshed.clone()),
            // The mesh that windows do not reach again is there already.
            Err(error) => progress.report(WHAT, 0, 1).map_or(Err(error), |()| Ok(meshed.clone())),
        }
    })?;
    Ok((all, deciding))
}

/// The minimum angle of a Delaunay triangulation of all domains, if that of each is known.
fn delaunay_min_angle(parts: &[Meshed]) -> Option<f64> {
    let angles = parts.iter().map(|part| part.delaunay_min_angle);
    angles.reduce(|a, b| Some(a?.min(b?))).flatten()
}
