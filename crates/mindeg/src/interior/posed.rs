//! The input of the engine of interior points, from a domain.

use std::borrow::Cow;

use mindeg_domain::{Domain, Interior, SizeAt};
use mindeg_interior::{InteriorError, Options, check_coordinates};
use mindeg_mesh::planar::PlanarBoundary;

/// The boundary of a domain, if limits and meshes can be computed.
pub(super) fn boundary(domain: &Domain) -> Result<Cow<'_, PlanarBoundary>, InteriorError> {
    let boundary = domain.boundary()?;
    check_coordinates(&boundary)?;
    Ok(boundary)
}

/// The options for the inside of a domain, with its degree limits.
pub(super) fn options(domain: &Domain, wanted: &Interior) -> Options {
    let mut options = Options::from(wanted.clone());
    options.divisible = domain.divisible_segments();
    let sized = domain.inside().points.iter();
    let sizes = sized.filter_map(|point| Some(SizeAt { at: point.at, size: point.size? }));
    options.wanted.sizes.extend(sizes);
    if domain.is_constrained() {
        for vertex in 0..domain.rings().vertex_count() {
            if let Some(limit) = domain.degree_limit(vertex) {
                let limit = limit.saturating_sub(domain.external_degree(vertex));
                options.degree_limits.insert(vertex, limit.max(2));
            }
        }
    }
    options
}
