//! A point inside a face.

use glam::DVec2;
use mindeg_mesh::planar::orientation;

/// How many edges of a ring are tried.
const TRIED: usize = 12;

/// A point inside a face, far from its edges compared with others: beside one of `ring`, which has the face on its left.
/// `edges` are all edges of the face, and may be more. `None` if rounding leaves no point.
pub(super) fn inner_point(ring: &[DVec2], edges: &[[DVec2; 2]]) -> Option<DVec2> {
    let own = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]);
    let mut own: Vec<[DVec2; 2]> = own.collect();
    // The edges that are longest along an axis first.
    own.sort_by(|a, b| reach(*b).total_cmp(&reach(*a)));
    let found = |share: f64| {
        let found = own.iter().take(TRIED).filter_map(|&edge| beside(edge, share, edges));
        found.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, point)| point)
    };
    // Something may lie halfway across from every middle.
    [0.5, 0.28125, 0.671875].into_iter().find_map(found)
}

fn reach([a, b]: [DVec2; 2]) -> f64 {
    (b - a).abs().max_element()
}

/// The point halfway from a point at a share of an edge to what is on its left, along the axis across it, and a measure of
/// the room there.
fn beside(edge: [DVec2; 2], share: f64, edges: &[[DVec2; 2]]) -> Option<(f64, DVec2)> {
    let is_steep = (edge[1] - edge[0]).abs().y >= (edge[1] - edge[0]).abs().x;
    // Work along x: an edge that is not steep is turned by a right angle, which is exact.
    let turned = |point: DVec2| if is_steep { point } else { DVec2::new(point.y, -point.x) };
    let back = |point: DVec2| if is_steep { point } else { DVec2::new(-point.y, point.x) };
    let [a, b] = edge.map(turned);
    let y = a.y + (b.y - a.y) * share;
    let at_level = |[a, b]: [DVec2; 2]| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    let from = at_level([a, b]);
    // An edge that runs down has its left at greater x.
    let sign = if b.y < a.y { 1.0 } else { -1.0 };
    let mut nearest = f64::INFINITY;
    for other in edges.iter().map(|other| other.map(turned)) {
        let is_own = other == [a, b] || other == [b, a];
        if !is_own && (other[0].y > y) != (other[1].y > y) {
            let distance = sign * (at_level(other) - from);
            if distance > 0.0 {
                nearest = nearest.min(distance);
            }
        }
    }
    let at = DVec2::new(from + sign * nearest / 2.0, y);
    let is_on = |[a, b]: [DVec2; 2]| {
        orientation(a, b, at) == 0.0 && at.cmpge(a.min(b)).all() && at.cmple(a.max(b)).all()
    };
    let is_free = nearest.is_finite()
        && orientation(a, b, at) > 0.0
        && !edges.iter().any(|other| is_on(other.map(turned)));
    is_free.then(|| (nearest.min((b.y - a.y).abs()), back(at)))
}
