//! The depths of new vertices between old ones.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_mesh::edges_of;

/// The depths with those of new vertices: each is the mean of its neighbours, the nearer ones weighing more.
pub(super) fn depths_between(
    mut depths: Vec<f64>,
    points: &[DVec2],
    triangles: &[[u32; 3]],
) -> Vec<f64> {
    const MOST_SWEEPS: usize = 20_000;
    const STILL: f64 = 1e-9;
    let first = depths.len() as u32;
    let known = triangles.iter().flatten().filter(|vertex| **vertex < first);
    let (mut sum, mut count) = (0.0, 0.0);
    known.for_each(|vertex| {
        sum += depths[*vertex as usize];
        count += 1.0;
    });
    depths.resize(points.len(), if count > 0.0 { sum / count } else { 0.0 });
    let mut neighbors: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for [a, b] in triangles.iter().copied().flat_map(edges_of) {
        for [a, b] in [[a, b], [b, a]] {
            if a >= first {
                neighbors.entry(a).or_default().insert(b);
            }
        }
    }
    for _ in 0..MOST_SWEEPS {
        let mut change: f64 = 0.0;
        for (vertex, near) in &neighbors {
            let (mut sum, mut weights) = (0.0, 0.0);
            for &other in near {
                let weight = 1.0 / points[*vertex as usize].distance(points[other as usize]);
                sum += weight * depths[other as usize];
                weights += weight;
            }
            let mean = sum / weights;
            change = change.max((mean - depths[*vertex as usize]).abs() / mean.abs().max(1.0));
            depths[*vertex as usize] = mean;
        }
        if change < STILL {
            break;
        }
    }
    depths
}
