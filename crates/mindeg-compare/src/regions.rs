//! The regions of a map that methods triangulate one by one.

use std::borrow::Cow;

use glam::DVec2;
use mindeg::Domain;
use mindeg_mesh::planar::{Border, PlanarBoundary};

/// The number of regions of a map that are no holes; none if the domain is no map.
pub(crate) fn regions(domain: &Domain) -> Option<u32> {
    domain.is_map().then(|| domain.region_count() as u32)
}

/// The border of each region of a map that is no hole, on the boundary of its domain.
pub(crate) fn borders(domain: &Domain, boundary: &PlanarBoundary) -> Vec<Border> {
    let Some(faces) = domain.faces() else {
        // A boundary of proven lines has faces.
        let faces = boundary.faces(&[]);
        return faces.map_or_else(|_| Vec::new(), |faces| boundary.face_borders(&faces));
    };
    let borders = (0..).zip(boundary.face_borders(faces));
    borders.filter(|(face, _)| !domain.is_hole(*face)).map(|(_, border)| border).collect()
}

/// The points of a domain and those inside, by vertex.
pub(crate) fn points(boundary: &PlanarBoundary) -> Cow<'_, [DVec2]> {
    match boundary.inner_points() {
        [] => Cow::Borrowed(boundary.points()),
        inner => Cow::Owned([boundary.points(), inner].concat()),
    }
}
