//! The edges of outer boundaries on the sides of the box around all.

use glam::DVec2;
use mindeg_mesh::Bounds;

use crate::domain::Domain;

/// The names of the sides of projected outlines that lie on the box around all degrees.
pub(crate) const BOX_SIDES: [&str; 4] = ["south", "east", "north", "west"];
/// An edge is on the box if it is no farther than this share of the box's size from it.
const NEAR: f64 = 1e-9;
/// The same in degrees: an edge along a parallel bends, and points on its chord are beside it.
const NEAR_DEGREES: f64 = 1e-5;

impl Domain {
    /// The first vertices of the edges of each domain's outer boundary that are on the box around all. Of projected domains these
    /// are the sides that have their name from the box around degrees, or else also those on that box.
    #[must_use]
    pub fn edges_on_box(domains: &[Self]) -> Vec<Vec<u32>> {
        let named = |domain: &Self| {
            let is_of_box = |side: usize| {
                let name = domain.sides()[side].name.as_deref();
                domain.projection.is_some()
                    && domain.rings().in_ring(side).ring == 0
                    && name.is_some_and(|name| BOX_SIDES.contains(&name))
            };
            domain.edges_of_sides(is_of_box)
        };
        let named: Vec<_> = domains.iter().map(named).collect();
        if named.iter().any(|edges| !edges.is_empty()) {
            return named;
        }
        let outer = |domain: &Self| -> Vec<DVec2> {
            domain.rings().ring(0).map(|vertex| domain.placement().point(vertex)).collect()
        };
        let places: Vec<_> = domains.iter().map(outer).collect();
        let mut found = on_box(&places, NEAR);
        // Longitudes count from that of one point, to go on across the antimeridian.
        let mut origin = None;
        let degrees = |(domain, points): (&Self, &Vec<DVec2>)| {
            let projection = domain.projection?;
            let places = points.iter().map(|point| {
                let at = projection.to_degrees(*point);
                let x = at.x - *origin.get_or_insert(at.x);
                DVec2::new(x - 360.0 * libm::round(x / 360.0), at.y)
            });
            Some(places.collect())
        };
        let degrees: Option<Vec<Vec<DVec2>>> = domains.iter().zip(&places).map(degrees).collect();
        if let Some(degrees) = degrees {
            for (found, more) in found.iter_mut().zip(on_box(&degrees, NEAR_DEGREES)) {
                found.extend(more);
                found.sort_unstable();
                found.dedup();
            }
        }
        found
    }
}

/// The edges of each ring that are on a side of the box around all, to a share of its size.
fn on_box(rings: &[Vec<DVec2>], near: f64) -> Vec<Vec<u32>> {
    let Some(all) = Bounds::of(rings.iter().flatten().copied()) else { return Vec::new() };
    let near = all.size().max_element() * near;
    let is_on = |[a, b]: [DVec2; 2]| {
        [all.min, all.max].into_iter().any(|corner| {
            let is_near = |point: DVec2| (point - corner).abs().cmple(DVec2::splat(near));
            (is_near(a) & is_near(b)).any()
        })
    };
    let of_ring = |ring: &Vec<DVec2>| {
        let edge = |at: &u32| [ring[*at as usize], ring[(*at as usize + 1) % ring.len()]];
        (0..ring.len() as u32).filter(|at| is_on(edge(at))).collect()
    };
    rings.iter().map(of_ring).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::projection::Projection;

    #[test]
    fn the_box_of_a_projected_domain_is_that_of_its_degrees_too() {
        let projection: Projection = "EPSG:32635".parse().unwrap();
        let ring = [[24.0, 38.0], [25.0, 38.0], [25.0, 39.0], [24.5, 38.9], [24.0, 39.0]];
        let plane = ring.map(|at| projection.to_plane(at.into()).to_array());
        let sea = Domain::from_rings([plane]).unwrap();
        assert_eq!(Domain::edges_on_box(std::slice::from_ref(&sea)).concat(), [0u32; 0]);
        let sea = sea.with_projection(Some(projection));
        assert_eq!(Domain::edges_on_box(std::slice::from_ref(&sea)), [vec![0, 1, 4]]);
        // Across the antimeridian.
        let projection: Projection =
            "+proj=stere +lat_0=-17 +lon_0=180 +datum=WGS84".parse().unwrap();
        let ring = [[179.0, -18.0], [-179.0, -18.0], [-179.0, -16.0], [180.0, -16.5]];
        let plane = ring.map(|at| projection.to_plane(at.into()).to_array());
        let sea = Domain::from_rings([plane]).unwrap().with_projection(Some(projection));
        assert_eq!(Domain::edges_on_box(std::slice::from_ref(&sea)), [vec![0, 1]]);
        // A box that was cut in metres.
        let square = [[4e5, 4.2e6], [4.5e5, 4.2e6], [4.5e5, 4.25e6], [4.1e5, 4.24e6]];
        let projection = "EPSG:32635".parse().unwrap();
        let sea = Domain::from_rings([square]).unwrap().with_projection(Some(projection));
        assert_eq!(Domain::edges_on_box(std::slice::from_ref(&sea)), [vec![0, 1]]);
    }
}
