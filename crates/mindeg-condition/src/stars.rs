//! The limit of the minimum angle at a vertex: of one fan on a ring, of one on each side of a line, and of all sectors where lines meet.

use crate::chains::Chains;
use glam::DVec2;
use mindeg_interior::limits::{degree_limit, fan_limit_from, star_limit};
use std::f64::consts::TAU;

/// The edges that a boundary vertex may have, but for reflex corners.
const MOST_EDGES: u32 = 5;
/// The edges, and so the triangles, that a vertex inside may have.
const MOST_INSIDE: u32 = 7;

/// The room between two edges at a vertex: its angle in radians, and their lengths.
type Sector = (f64, [f64; 2]);

/// The angle from one direction counter-clockwise to another, above 0, in radians.
pub(crate) fn angle_to(from: DVec2, to: DVec2) -> f64 {
    let angle = libm::atan2(from.perp_dot(to), from.dot(to));
    if angle <= 0.0 { angle + TAU } else { angle }
}

impl Chains<'_> {
    /// The limit at a vertex, in degrees.
    pub(crate) fn limit(&self, vertex: u32) -> f64 {
        self.limit_with(vertex, vertex, DVec2::ZERO)
    }

    /// The limit at a vertex if the edge to a neighbour went to another point instead.
    pub(crate) fn limit_with(&self, vertex: u32, neighbor: u32, instead: DVec2) -> f64 {
        let limit = |arc: &Vec<Sector>, is_inside: bool| {
            let whole = arc.iter().map(|sector| sector.0).sum();
            match (&arc[..], is_inside) {
                (_, true) => star_limit(arc, MOST_INSIDE),
                (&[(angle, [short, long])], false) => {
                    let triangles = degree_limit(angle, MOST_EDGES) - 1;
                    let least = self.least_triangles;
                    fan_limit_from(least, angle, [short, long], Some(triangles))
                }
                _ => star_limit(arc, degree_limit(whole, MOST_EDGES) - 1),
            }
        };
        let (arcs, is_inside) = self.arcs(vertex, neighbor, instead);
        arcs.iter().map(|arc| limit(arc, is_inside)).fold(60.0, f64::min)
    }

    /// The least angle between edges at a vertex with the domain between them, in radians.
    pub(crate) fn angle(&self, vertex: u32) -> f64 {
        let (arcs, _) = self.arcs(vertex, vertex, DVec2::ZERO);
        arcs.into_iter().flatten().map(|sector| sector.0).fold(TAU, f64::min)
    }

    /// The limit at a vertex if its edges had the best lengths, in degrees: what its sectors' angles leave to their triangles.
    pub(crate) fn limit_of_angles(&self, vertex: u32) -> f64 {
        self.limit_of_angles_with(vertex, vertex, DVec2::ZERO)
    }

    /// The same if the edge to a neighbour went to another point instead.
    pub(crate) fn limit_of_angles_with(&self, vertex: u32, neighbor: u32, instead: DVec2) -> f64 {
        let (arcs, is_inside) = self.arcs(vertex, neighbor, instead);
        let limit = |arc: &Vec<Sector>| match &arc[..] {
            [sector] if !is_inside => sector.0 / f64::from(self.least_triangles),
            sectors => sectors.iter().map(|sector| sector.0).fold(TAU, f64::min),
        };
        arcs.iter().map(limit).fold(TAU, f64::min).to_degrees()
    }

    /// The sectors of the domain at a vertex: one run for each room that something else bounds; and whether the domain is all around.
    fn arcs(&self, vertex: u32, neighbor: u32, instead: DVec2) -> (Vec<Vec<Sector>>, bool) {
        let center = self.at(vertex);
        let spoke = |(to, has_left): (u32, bool)| {
            let at = if to == neighbor { instead } else { self.at(to) };
            (at - center, has_left)
        };
        let mut spokes: Vec<(DVec2, bool)> =
            self.neighbors(vertex).into_iter().map(spoke).collect();
        let direction = |spoke: &(DVec2, bool)| libm::atan2(spoke.0.y, spoke.0.x);
        if spokes.len() > 2 {
            spokes.sort_by(|a, b| direction(a).total_cmp(&direction(b)));
        }
        // From behind something else on.
        let last = spokes.iter().position(|spoke| !spoke.1);
        spokes.rotate_left(last.map_or(0, |last| last + 1));
        let mut arcs: Vec<Vec<Sector>> = vec![Vec::new()];
        for (index, (from, has_left)) in spokes.iter().enumerate() {
            let to = spokes[(index + 1) % spokes.len()].0;
            if !has_left {
                arcs.push(Vec::new());
            } else if let Some(arc) = arcs.last_mut() {
                arc.push((angle_to(*from, to), [from.length(), to.length()]));
            }
        }
        arcs.retain(|arc| !arc.is_empty());
        (arcs, last.is_none())
    }
}
