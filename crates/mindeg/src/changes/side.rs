//! A side with another number of intervals.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec2;
use mindeg_domain::{Curve, Intervals, Side};

/// The points of a side that keeps them, without its ends.
pub(super) fn own_points(side: &Side) -> Option<&[DVec2]> {
    (side.intervals == Intervals::Points).then(|| side.curve.points())
}

/// The side between two ends with `count` intervals. One with points of its own gets more of them, never fewer.
pub(super) fn with_intervals(side: &Side, ends: [DVec2; 2], count: u64) -> Side {
    match own_points(side) {
        Some(points) => {
            let more = count.saturating_sub(points.len() as u64 + 1);
            let curve = Curve::Polyline(divided(points, ends, more));
            Side { curve, ..side.clone() }
        }
        None => Side { intervals: Intervals::Count(count), ..side.clone() },
    }
}

/// The points with `more` points between them: each on the edge whose parts are longest, parts of an edge even.
fn divided(points: &[DVec2], [start, end]: [DVec2; 2], more: u64) -> Vec<DVec2> {
    let all: Vec<DVec2> = [start].into_iter().chain(points.iter().copied()).chain([end]).collect();
    let lengths: Vec<f64> = all.windows(2).map(|edge| edge[0].distance(edge[1])).collect();
    let mut parts = vec![1_u64; lengths.len()];
    // Lengths are positive numbers: their bits have their order.
    let longest =
        |edge: usize, parts: u64| ((lengths[edge] / parts as f64).to_bits(), Reverse(edge));
    let mut heap: BinaryHeap<_> = (0..lengths.len()).map(|edge| longest(edge, 1)).collect();
    for _ in 0..more {
        let Some(mut top) = heap.peek_mut() else { break };
        let Reverse(edge) = top.1;
        parts[edge] += 1;
        *top = longest(edge, parts[edge]);
    }
    let mut divided = Vec::new();
    for (edge, &parts) in all.windows(2).zip(&parts) {
        divided.extend((1..parts).map(|part| edge[0].lerp(edge[1], part as f64 / parts as f64)));
        divided.push(edge[1]);
    }
    divided.pop();
    divided
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_points_divide_the_longest_edges_and_keep_the_rest() {
        let own = [DVec2::new(1.0, 0.0), DVec2::new(4.0, 0.0)];
        let side = Side::points(own.to_vec());
        let ends = [DVec2::ZERO, DVec2::new(4.0, 2.0)];
        let xs = |count| {
            let side = with_intervals(&side, ends, count);
            own_points(&side).map(|points| points.iter().map(|p| (p.x, p.y)).collect::<Vec<_>>())
        };
        assert_eq!(xs(2), Some(vec![(1.0, 0.0), (4.0, 0.0)]), "points are never taken away");
        assert_eq!(xs(4), Some(vec![(1.0, 0.0), (2.5, 0.0), (4.0, 0.0)]));
        let both = vec![(1.0, 0.0), (2.5, 0.0), (4.0, 0.0), (4.0, 1.0)];
        assert_eq!(xs(5), Some(both));
        let counted = with_intervals(&Side::size(0.1), ends, 7);
        assert_eq!(counted.intervals, Intervals::Count(7));
    }
}
