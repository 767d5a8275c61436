//! The fan: all triangles round one vertex.
//!
//! The triangle on a boundary edge is flat when the tip of the fan is on that edge's side and
//! not an end of the edge. So the sides on which the tip lies must consist of edges at the
//! tip: it is the middle of a side of two intervals, or a corner between two sides of one.

use mindeg::ConvexForm;
use mindeg_core::Boundary;

/// The triangles round the first vertex that gives no flat triangle, counter-clockwise.
pub(super) fn triangulate(form: &ConvexForm) -> Option<Vec<[u32; 3]>> {
    let vertices = form.boundary().vertex_count();
    let tip = (tip(form.boundary())? + form.first()) % vertices;
    let after = |steps: u32| ((u64::from(tip) + u64::from(steps)) % u64::from(vertices)) as u32;
    Some((1..vertices - 1).map(|steps| [tip, after(steps), after(steps + 1)]).collect())
}

fn tip(boundary: &Boundary) -> Option<u32> {
    let sides = boundary.side_count();
    (0..sides).find_map(|side| {
        let before = boundary.intervals(if side == 0 { sides - 1 } else { side - 1 });
        match (before, boundary.intervals(side)) {
            (1, 1) => Some(boundary.corner(side)),
            (_, 2) => Some(boundary.corner(side) + 1),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use mindeg::{BoundaryMesh, Domain, Side};
    use proptest::prelude::*;

    #[test]
    fn starts_at_the_first_vertex_that_will_do() {
        for (intervals, expected) in [
            (&[1, 1, 1][..], Some(0)),
            (&[2, 1, 1], Some(1)),
            (&[3, 1, 1], Some(4)),
            (&[1, 3, 4, 1], Some(0)),
            (&[3, 3, 2, 2], Some(7)),
            (&[3, 1, 3, 1], None),
            (&[3, 3, 3], None),
        ] {
            let boundary = Boundary::new(intervals).unwrap();
            assert_eq!(tip(&boundary), expected, "{intervals:?}");
        }
    }

    /// The first corner is in the middle of a side of two intervals: there the fan has its tip.
    #[test]
    fn the_fan_is_that_of_the_domain_where_sides_are_on_one_line() {
        let corners = [[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let domain = Domain::polygon(corners, [1, 1, 3, 1, 1].map(Side::count).into()).unwrap();
        let fan = triangulate(domain.convex().unwrap()).unwrap();
        let mesh = BoundaryMesh::with_triangles(&domain, fan).unwrap();
        assert_eq!(mesh.degree(0), mesh.vertex_count() - 1);
    }

    proptest! {
        #[test]
        fn every_other_fan_is_flat(intervals in prop::collection::vec(1_u64..5, 3..8)) {
            let boundary = Boundary::new(&intervals).unwrap();
            let vertices = boundary.vertex_count();
            let around = |tip: u32| {
                let ring = (1..vertices - 1).map(move |i| [i, i + 1].map(|i| (tip + i) % vertices));
                ring.map(move |[a, b]| [tip, a, b])
            };
            let first = (0..vertices).find(|&tip| around(tip).all(|t| !boundary.is_flat(t)));
            prop_assert_eq!(tip(&boundary), first);
            if first.is_some() {
                let turn = std::f64::consts::TAU / intervals.len() as f64;
                let corners = (0..intervals.len()).map(|side| DVec2::from_angle(turn * side as f64));
                let sides = intervals.iter().copied().map(Side::count).collect();
                let domain = Domain::polygon(corners, sides).unwrap();
                let form = domain.convex().unwrap();
                let fan = triangulate(form).unwrap();
                let mesh = BoundaryMesh::with_triangles(&domain, fan).unwrap();
                prop_assert_eq!(mesh.max_degree(), vertices - 1);
            }
        }
    }
}
