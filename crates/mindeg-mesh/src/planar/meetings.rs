//! All points where the rings and lines of a boundary meet that should not.

use glam::{DVec2, DVec3};

use super::boundary::PlanarBoundary;
use super::orientation;
use super::sweep::Meeting;
use crate::Bounds;
use crate::box_tree::BoxTree;

/// An edge, or an inner point as an edge without length.
#[derive(Clone, Copy)]
struct Item {
    edge: u32,
    ends: [u32; 2],
    /// The vertex that this item stands for: where an edge of a ring begins, or an inner point.
    vertex: Option<u32>,
}

/// All points where rings and lines meet themselves or each other, by the first edge of each.
pub(super) fn meetings(boundary: &PlanarBoundary) -> impl Iterator<Item = Meeting> + '_ {
    let (on_rings, edges) = (boundary.vertex_count(), boundary.edge_count());
    let item = move |index: u32| match index.checked_sub(edges) {
        Some(inner) => {
            let vertex = on_rings + inner;
            Item { edge: index, ends: [vertex; 2], vertex: Some(vertex) }
        }
        None => {
            let vertex = (index < on_rings).then_some(index);
            Item { edge: index, ends: boundary.ends(index), vertex }
        }
    };
    let at = move |vertex: u32| boundary.point(vertex);
    let items = edges + boundary.inner_points().len() as u32;
    let around = |index: u32| {
        let [a, b] = item(index).ends.map(|vertex| at(vertex).extend(0.0));
        Bounds::<DVec3> { min: a.min(b), max: a.max(b) }
    };
    let tree = BoxTree::new((0..items).map(around).collect());
    (0..items).flat_map(move |index| {
        let own = item(index);
        let mut found = Vec::new();
        if own.vertex.is_some() && own.edge < on_rings {
            let [before, here, after] = [boundary.previous(index), index, own.ends[1]].map(at);
            if here != after && here != before && orientation(before, here, after) == 0.0 {
                let folds = (before - here).dot(after - here) > 0.0;
                found.extend(folds.then_some(Meeting::FoldsBack(index)));
            }
        }
        let mut near = Vec::new();
        tree.meet_item(index, &mut near);
        near.sort_unstable();
        near.into_iter().for_each(|other| meet(boundary, [own, item(other)], &mut found));
        found
    })
}

/// How an edge or point meets another.
fn meet(boundary: &PlanarBoundary, [own, other]: [Item; 2], found: &mut Vec<Meeting>) {
    let at = |vertex: u32| boundary.point(vertex);
    let ([p, q], [c, d]) = (own.ends.map(at), other.ends);
    if let (Some(a), Some(c)) = (own.vertex, other.vertex)
        && c > a
        && at(c) == p
    {
        found.push(Meeting::SamePoint([a, c]));
    }
    if let Some(vertex) = other.vertex
        && !own.ends.contains(&vertex)
        && orientation(p, q, at(vertex)) == 0.0
        && is_between(at(vertex), [p, q])
    {
        found.push(Meeting::Touch { vertex, edge: own.edge });
    }
    if other.edge <= own.edge {
        return;
    }
    let is_of_line = other.edge >= boundary.vertex_count() && c != d;
    if let Some(&shared) = own.ends.iter().find(|end| other.ends.contains(end)) {
        let far = |[from, to]: [u32; 2]| at(if from == shared { to } else { from });
        let [first, second] = [far(own.ends), far(other.ends)];
        let lie = orientation(at(shared), first, second) == 0.0
            && (first - at(shared)).dot(second - at(shared)) > 0.0;
        found.extend((is_of_line && lie).then_some(Meeting::Overlap([own.edge, other.edge])));
        return;
    }
    let sides = |[from, to]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        [orientation(from, to, c), orientation(from, to, d)]
    };
    let others = [at(c), at(d)];
    if are_opposite(sides([p, q], others)) && are_opposite(sides(others, [p, q])) {
        found.push(Meeting::Crossing([own.edge, other.edge]));
    }
}

fn is_between(point: DVec2, [p, q]: [DVec2; 2]) -> bool {
    (point - p).dot(q - p) > 0.0 && (point - q).dot(p - q) > 0.0
}

fn are_opposite([x, y]: [f64; 2]) -> bool {
    x > 0.0 && y < 0.0 || x < 0.0 && y > 0.0
}
