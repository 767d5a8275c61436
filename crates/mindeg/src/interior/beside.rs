//! Domains beside each other: a mesh of them all.

use mindeg_domain::{Domain, Interior};
use mindeg_interior::{InteriorError, InteriorReport};
use mindeg_mesh::{Progress, TriMesh};

use crate::beside::each;

use super::{AngleLimit, InteriorMesh, coarse, mesh};

/// Meshes one domain, or several that lie beside each other, such as islands, as one mesh: the vertices of the first domain come first.
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
    if let [domain] = domains {
        return mesh(domain, wanted, progress).map_err(|error| (0, error));
    }
    let work = |domain: &Domain, progress: Progress<'_>| mesh(domain, wanted, progress);
    let meshed = each(domains, "adding interior points", progress, work)?;
    let mut all: Option<TriMesh> = None;
    let mut reports = Vec::with_capacity(meshed.len());
    let mut limit: Option<AngleLimit> = None;
    let mut coarse_sides = Vec::new();
    for (index, found) in meshed.into_iter().enumerate() {
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
