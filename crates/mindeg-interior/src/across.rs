//! How wide a domain is between sides that face each other.

use crate::edge_tree::EdgeTree;
use glam::DVec2;
use mindeg_domain::SizeAt;
use mindeg_mesh::planar::PlanarBoundary;

/// Sides face each other if the largest circle between them touches them this far apart: the cosine of the angle from its
/// middle. So corners of 45° and more are no channels.
const FACING: f64 = -0.7;
/// An edge is looked across at so many places at most.
const MOST_PLACES: usize = 64;
/// Rounding, as a share of a radius.
const NEAR: f64 = 1e-9;
/// The circles shrink by a share each, so these are many.
const MOST_ROUNDS: usize = 100;

/// Sizes on the ways across a domain, where sides face each other: so many on each way, none below `least`. Their number is that of the
/// boundary's edges times `across`, and 64 times that where edges are much longer than the domain is wide.
///
/// The way from a place on the boundary is the diameter of the largest circle that touches it there and lies inside.
/// O(n log n).
pub fn sizes_across(outline: &PlanarBoundary, across: f64, least: f64) -> Vec<SizeAt> {
    let tree = EdgeTree::of_boundary(outline);
    let most = outline.bounds().size().length();
    let mut sizes = Vec::new();
    for [a, b] in outline.edges() {
        let [from, to] = [a, b].map(|vertex| outline.point(vertex));
        let inwards = (to - from).perp().normalize_or_zero();
        let circle = |share: f64| {
            let at = from.lerp(to, share);
            let (middle, opposite) = circle_at(outline, &tree, at, inwards, most)?;
            Some((at, middle, opposite))
        };
        let size = |(at, middle, _): (DVec2, DVec2, DVec2)| {
            (2.0 * at.distance(middle) / across).max(least)
        };
        let looks = [1.0, 3.0, 5.0].map(|sixths| circle(sixths / 6.0));
        let narrowest = looks.into_iter().flatten().map(size).fold(f64::INFINITY, f64::min);
        let places = ((from.distance(to) / narrowest).ceil() as usize).clamp(1, MOST_PLACES);
        let own = (0..places).filter_map(|i| circle((i as f64 + 0.5) / places as f64));
        for found @ (at, middle, opposite) in own {
            let size = size(found);
            // The opposite side has ways of its own: half of this one.
            let count = (at.distance(middle) / size).ceil();
            let step = |i: u32| SizeAt { at: at.lerp(middle, f64::from(i) / count), size };
            sizes.extend((0..=count as u32).map(step));
            sizes.push(SizeAt { at: opposite, size });
        }
    }
    sizes
}

/// The middle of the largest circle inside that touches the boundary at a place, and where it touches the side that faces the place; none
/// if no side does.
fn circle_at(
    outline: &PlanarBoundary,
    tree: &EdgeTree,
    at: DVec2,
    inwards: DVec2,
    most: f64,
) -> Option<(DVec2, DVec2)> {
    let (mut radius, mut touched) = (most, None);
    for _ in 0..MOST_ROUNDS {
        let middle = at + inwards * radius;
        let (edge, distance) = tree.nearest(middle, f64::INFINITY)?;
        if distance >= radius * (1.0 - NEAR) {
            break;
        }
        let [from, to] = outline.ends(edge).map(|vertex| outline.point(vertex));
        let along = to - from;
        let share = ((middle - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let opposite = from + along * share;
        let way = opposite - at;
        let smaller = way.length_squared() / (2.0 * way.dot(inwards));
        if !(smaller > 0.0 && smaller < radius) {
            break;
        }
        (radius, touched) = (smaller, Some(opposite));
    }
    let (middle, opposite) = (at + inwards * radius, touched?);
    let [one, other] = [at - middle, opposite - middle];
    (one.dot(other) <= FACING * one.length() * other.length()).then_some((middle, opposite))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn a_channel_has_its_width_and_a_square_that_of_its_sides() {
        let channel = samples::rectangle(20.0, 2.0, [1, 1, 1, 1]);
        let sizes = sizes_across(&channel, 4.0, 0.0);
        // Every place of the channel, but near its ends, has a size of half a unit near it.
        for i in 0..36 {
            let at = DVec2::new(1.0 + f64::from(i) / 2.0, 0.4 + f64::from(i % 5) * 0.3);
            let near = sizes.iter().filter(|size| size.at.distance(at) < 0.4);
            assert!(near.clone().count() > 0, "{at}");
            near.for_each(|size| assert!((size.size - 0.5).abs() < 1e-9, "{size:?}"));
        }
        // No corner is a channel: nothing is smaller.
        assert!(sizes.iter().all(|size| size.size > 0.5 - 1e-9));
        assert!(sizes_across(&channel, 4.0, 0.7).iter().all(|size| size.size >= 0.7));
        let square = sizes_across(&samples::rectangle(8.0, 8.0, [8; 4]), 4.0, 0.0);
        assert!(square.iter().all(|size| size.size > 2.0 - 1e-9), "{square:?}");
    }

    #[test]
    fn the_way_around_an_island_is_narrower() {
        let plate = samples::plate_with_hole();
        let sizes = sizes_across(&plate, 3.0, 0.0);
        let whole = plate.bounds().size().min_element();
        let least = sizes.iter().map(|size| size.size).fold(f64::INFINITY, f64::min);
        assert!(least < 0.5 * whole / 3.0, "{least}");
    }
}
