//! Checks a mesh by its points and triangles alone, sharing no code with the library.

use glam::DVec2;
use robust::{Coord, orient2d};
use std::collections::BTreeMap;

/// Fails unless the triangles fill what `boundary` edges bound: exactly oriented, edge to edge,
/// with the boundary's edges and no others, and with the boundary's area.
pub(crate) fn assert_valid(points: &[DVec2], triangles: &[[u32; 3]], boundary: &[[u32; 2]]) {
    let coord = |v: u32| Coord { x: points[v as usize].x, y: points[v as usize].y };
    let mut halves: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for [a, b, c] in triangles {
        assert!(orient2d(coord(*a), coord(*b), coord(*c)) > 0.0, "triangle {a} {b} {c}");
        for half in [(*a, *b), (*b, *c), (*c, *a)] {
            *halves.entry(half).or_default() += 1;
        }
    }
    assert!(halves.values().all(|count| *count == 1), "a half-edge occurs twice");
    let mut single: Vec<[u32; 2]> = halves
        .keys()
        .filter(|(a, b)| !halves.contains_key(&(*b, *a)))
        .map(|(a, b)| [*a, *b])
        .collect();
    let mut expected = boundary.to_vec();
    single.sort_unstable();
    expected.sort_unstable();
    assert_eq!(single, expected, "boundary edges");
    let origin = points[0];
    let area = |a: DVec2, b: DVec2| (a - origin).perp_dot(b - origin) / 2.0;
    let at = |v: u32| points[v as usize];
    let whole: f64 = boundary.iter().map(|[a, b]| area(at(*a), at(*b))).sum();
    let sum: f64 =
        triangles.iter().map(|[a, b, c]| (at(*b) - at(*a)).perp_dot(at(*c) - at(*a)) / 2.0).sum();
    assert!((sum / whole - 1.0).abs() < 1e-9, "area {sum} of {whole}");
    // One fan at each vertex: as many triangles as edges, or one edge more at the boundary.
    let mut fans: BTreeMap<u32, (i64, i64)> = BTreeMap::new();
    for (a, b) in halves.keys() {
        fans.entry(*a).or_default().0 += 1;
        if !halves.contains_key(&(*b, *a)) {
            fans.entry(*a).or_default().1 += 1;
        }
    }
    assert!(fans.values().all(|(_, open)| *open <= 1), "two fans at a vertex");
    let (v, e, f) = (fans.len(), (halves.len() + single.len()) / 2, triangles.len());
    let rings = {
        let next: BTreeMap<u32, u32> = single.iter().map(|[a, b]| (*a, *b)).collect();
        let mut left: Vec<u32> = next.keys().copied().collect();
        let mut rings = 0;
        while let Some(start) = left.first().copied() {
            let mut at = start;
            loop {
                left.retain(|v| *v != at);
                at = next[&at];
                if at == start {
                    break;
                }
            }
            rings += 1;
        }
        rings
    };
    assert_eq!(v as i64 - e as i64 + f as i64, 2 - rings, "Euler");
}

/// The degree of every vertex, counted afresh.
pub(crate) fn degrees(points: usize, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut edges: Vec<[u32; 2]> = triangles
        .iter()
        .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; points];
    edges.iter().flatten().for_each(|v| degrees[*v as usize] += 1);
    degrees
}

/// The minimum angle in degrees, by the law of cosines.
pub(crate) fn min_angle(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let angle = |a: DVec2, b: DVec2, c: DVec2| {
        ((b - a).dot(c - a) / (b.distance(a) * c.distance(a))).clamp(-1.0, 1.0).acos().to_degrees()
    };
    triangles
        .iter()
        .map(|t| t.map(|v| points[v as usize]))
        .flat_map(|[a, b, c]| [angle(a, b, c), angle(b, c, a), angle(c, a, b)])
        .fold(180.0, f64::min)
}
