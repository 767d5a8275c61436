//! Domains beside each other: a mesh of them all.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use mindeg_domain::{Domain, Interior};
use mindeg_interior::{InteriorError, InteriorReport};
use mindeg_mesh::parallel::map_all;
use mindeg_mesh::{Cancelled, Progress, Step, TriMesh};

use super::{AngleLimit, InteriorMesh, coarse, mesh};

/// Meshes domains that lie beside each other, such as islands, as one mesh: the vertices of the first domain come first.
/// Groups of one name are one group. The domains are shared among all threads; the limit is that of the domain with the
/// least.
///
/// # Errors
///
/// No domain; the errors of [`mesh`], with the index of the first domain that has one.
pub fn mesh_all(
    domains: &[Domain],
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<InteriorMesh, (usize, InteriorError)> {
    let weight = |domain: &Domain| u64::from(domain.placement().vertex_count());
    let (total, done) = (domains.iter().map(weight).sum::<u64>(), AtomicU64::new(0));
    // The largest take longest, so they begin first.
    let mut order: Vec<usize> = (0..domains.len()).collect();
    order.sort_by_key(|&index| std::cmp::Reverse(weight(&domains[index])));
    let meshed = map_all(order.clone(), |index| {
        let (told, weight) = (AtomicU64::new(0), weight(&domains[index]));
        let tell = |step: Step<'_>| {
            let own = weight * step.done.min(step.total) / step.total.max(1);
            let more = own.saturating_sub(told.fetch_max(own, Relaxed));
            let done = done.fetch_add(more, Relaxed) + more;
            match progress.report("adding interior points", done, total) {
                Ok(()) => ControlFlow::Continue(()),
                Err(Cancelled) => ControlFlow::Break(()),
            }
        };
        mesh(&domains[index], wanted, Progress::new(&tell))
    });
    let mut meshed: Vec<_> = order.into_iter().zip(meshed).collect();
    meshed.sort_by_key(|(index, _)| *index);
    let mut all: Option<TriMesh> = None;
    let mut reports = Vec::with_capacity(meshed.len());
    let mut limit: Option<AngleLimit> = None;
    let mut coarse_sides = Vec::new();
    for (index, found) in meshed {
        let found = found.map_err(|error| (index, error))?;
        let first = all.as_ref().map_or(0, |all| all.positions().len()) as u32;
        let own = found.limit.of_vertices_from(first);
        limit = Some(match limit {
            Some(least) if least.min_angle <= own.min_angle => least,
            _ => own,
        });
        reports.push((first, found.report));
        coarse_sides.extend(found.coarse_sides);
        all = Some(match all {
            None => found.mesh,
            Some(all) => all
                .with_mesh_added(&found.mesh)
                .map_err(|error| (index, InteriorError::NotFilled(error.to_string())))?,
        });
    }
    let report = InteriorReport::of_all(reports);
    let (Some(mesh), Some(report), Some(limit)) = (all, report, limit) else {
        return Err((0, InteriorError::NotFilled("there is no domain".to_owned())));
    };
    coarse::sort(&mut coarse_sides);
    Ok(InteriorMesh { mesh: mesh.with_groups_merged(), report, limit, coarse_sides })
}
