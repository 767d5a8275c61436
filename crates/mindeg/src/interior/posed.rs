//! The input of the engine of interior points, from a domain.

use std::borrow::Cow;

use mindeg_domain::{Domain, Interior, Region, Size, SizeAt};
use mindeg_interior::{InteriorError, Options, check_coordinates, size_of_area};
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
    let sizes = sizes.map(Size::At);
    options.wanted.sizes.extend(sizes);
    let rings = domain.rings();
    let sides = (0..rings.side_count()).map(|side| {
        let start = rings.corner(side);
        (domain.side_name(side), start..start + rings.intervals(side))
    });
    let after = rings.vertex_count();
    let lines = domain
        .inner_lines()
        .into_iter()
        .map(|(line, _)| (line.name, after + line.segments.start..after + line.segments.end));
    options.names = sides.chain(lines).collect();
    if let Some(faces) = domain.faces() {
        options.beside.clone_from(&faces.beside);
        options.region_sizes = domain.inside().regions.iter().map(size_of_region).collect();
    }
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

/// The size of a region, infinite where none is wanted.
fn size_of_region(region: &Region) -> f64 {
    let of_area = region.max_area.map_or(f64::INFINITY, size_of_area);
    region.size.map_or(of_area, |size| size.min(of_area))
}
