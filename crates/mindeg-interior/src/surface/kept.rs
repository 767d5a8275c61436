//! Curves whose samples stay bit for bit: the sizes near them follow the lengths of their edges.

use mindeg_surfaces::Surface;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// By how much sizes change per unit of length on the way from a kept curve.
const GROWTH: f64 = 0.4;

/// The wanted edge length at each vertex of a refined surface: its own, and near the curves that are kept as long as their
/// edges. O(n log n).
pub(crate) fn sizes_beside(surface: &Surface, is_kept: &[bool]) -> Vec<f64> {
    let count = surface.points().len();
    let mut lengths = vec![(0.0, 0.0); count];
    let ends: Vec<Vec<f64>> = surface
        .curves()
        .iter()
        .map(|curve| sums(curve.points().windows(2).map(|p| p[0].distance(p[1]))))
        .collect();
    for span in surface.spans().iter().filter(|span| is_kept[span.curve as usize]) {
        let ends = &ends[span.curve as usize];
        let middle = 0.5 * (span.range[0] + span.range[1]);
        let at = ends.partition_point(|end| *end <= middle).clamp(1, ends.len() - 1);
        for v in span.vertices {
            let (sum, of) = &mut lengths[v as usize];
            (*sum, *of) = (*sum + ends[at] - ends[at - 1], *of + 1.0);
        }
    }
    let start = |none: f64| -> Vec<f64> {
        lengths.iter().map(|(sum, of)| if *of > 0.0 { sum / of } else { none }).collect()
    };
    let mut upper = start(f64::INFINITY);
    spread(surface, &mut upper);
    // From long edges sizes fall as they grow from short ones.
    let mut lower: Vec<f64> = start(0.0).into_iter().map(|length| -length).collect();
    spread(surface, &mut lower);
    let size = |v: usize| surface.size(v as u32).max(-lower[v]).min(upper[v]);
    (0..count).map(size).collect()
}

/// The sums of the first numbers, from none to all.
fn sums(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = 0.0;
    let rest = numbers.map(|number| {
        sum += number;
        sum
    });
    let mut sums = vec![0.0];
    sums.extend(rest);
    sums
}

/// Lowers values so that they grow by at most [`GROWTH`] per unit of length along edges.
fn spread(surface: &Surface, values: &mut [f64]) {
    let mut edges: Vec<[u32; 2]> = Vec::new();
    for &[a, b, c] in surface.triangles() {
        edges.extend([[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]]);
    }
    edges.sort_unstable();
    edges.dedup();
    let first = |v: u32| edges.partition_point(|edge| edge[0] < v);
    // The order of the bits is that of the values if the sign is taken into account.
    let key = |value: f64| {
        let bits = value.to_bits() as i64;
        bits ^ (((bits >> 63) as u64) >> 1) as i64
    };
    let known = (0_u32..).zip(values.iter()).filter(|(_, value)| value.is_finite());
    let mut heap: BinaryHeap<Reverse<(i64, u32)>> =
        known.map(|(v, value)| Reverse((key(*value), v))).collect();
    while let Some(Reverse((bits, v))) = heap.pop() {
        let value = values[v as usize];
        if key(value) != bits {
            continue;
        }
        for [_, other] in edges[first(v)..].iter().take_while(|edge| edge[0] == v) {
            let [p, q] = [v, *other].map(|v| surface.points()[v as usize]);
            let most = value + GROWTH * p.distance(q);
            if most < values[*other as usize] {
                values[*other as usize] = most;
                heap.push(Reverse((key(most), *other)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::work::tests::reference;

    #[test]
    fn sizes_follow_the_edges_of_kept_curves() {
        let surface = reference("saddle", 2.0).surface;
        let curves = surface.curves().len();
        let sizes = |kept: bool| sizes_beside(&surface, &vec![kept; curves]);
        for (v, size) in (0_u32..).zip(sizes(false)) {
            assert_eq!(size, surface.size(v));
        }
        // The boundary has 30 edges on each side, a third of the size; inside it grows back.
        let short = 2.0 / 30.0;
        let kept = sizes(true);
        for (v, p) in surface.points().iter().enumerate() {
            let inside = 1.0 - p.x.abs().max(p.y.abs());
            let size = kept[v];
            assert!(size < surface.size(v as u32) + 1e-12);
            if inside == 0.0 {
                assert!((0.9 * short..1.5 * short).contains(&size), "{p} {size}");
            } else {
                // Along edges the way is longer.
                let straight = 0.4 * inside * 1.7 + 1.5 * short;
                let least = (0.4 * inside + 0.9 * short).min(surface.size(v as u32));
                assert!(size > least - 1e-9, "{p} {size} {least}");
                assert!(size < straight, "{p} {size}");
            }
        }
    }

    #[test]
    fn sizes_fall_from_kept_long_edges() {
        // One edge on each side of a cube.
        let surface = reference("cube", 1.0).surface;
        let kept = sizes_beside(&surface, &vec![true; surface.curves().len()]);
        for (v, p) in surface.points().iter().enumerate() {
            let away = p.to_array().map(|x| x.min(1.0 - x));
            let mut away = away.to_vec();
            away.sort_by(f64::total_cmp);
            let expected = 1.0 - 0.4 * away[1];
            assert!(kept[v] < expected + 0.05 && kept[v] > expected - 0.2, "{p} {}", kept[v]);
        }
    }
}
