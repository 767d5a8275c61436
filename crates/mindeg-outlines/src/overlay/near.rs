//! Vertices that edges pass nearly.

use std::collections::BTreeMap;

use glam::DVec2;

use super::edge::Edge;
use crate::curve::norm;

/// For each edge the vertices that it passes within the tolerance.
pub(in super::super) fn near_vertices(
    edges: &[Edge],
    points: &[DVec2],
    tolerance: f64,
) -> BTreeMap<usize, Vec<u32>> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(|&a, &b| points[a as usize].x.total_cmp(&points[b as usize].x));
    let mut near: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
    for (index, edge) in edges.iter().enumerate() {
        let [a, b] = edge.ends.map(|end| points[end as usize]);
        let (low, high) = (a.min(b) - tolerance, a.max(b) + tolerance);
        let from = order.partition_point(|&vertex| points[vertex as usize].x < low.x);
        let span = b - a;
        let length = norm(span);
        for &vertex in &order[from..] {
            let at = points[vertex as usize];
            if at.x > high.x {
                break;
            }
            let is_beside = at.y >= low.y && at.y <= high.y && !edge.ends.contains(&vertex);
            if is_beside {
                let along = (at - a).dot(span) / length;
                let across = span.perp_dot(at - a) / length;
                if across.abs() <= tolerance && along > 0.0 && along < length {
                    near.entry(index).or_default().push(vertex);
                }
            }
        }
    }
    near
}
