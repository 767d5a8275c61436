//! The surface of a bridge before it is meshed: curves instead of the edges of the strip, which leave both rims in the direction of the
//! mesh there. A surface that bends least would be drawn in between rims that are far apart.

use std::collections::BTreeMap;

use glam::DVec3;
use mindeg_mesh::edges_of;

/// A curve has at most so many pieces.
const MOST_PIECES: f64 = 256.0;

/// The points and triangles of a tube over a strip between two rims, given with the triangles around them: its points are the given
/// ones and others after them. `leaving` is how much the curves follow the mesh at their ends: 0 for straight ones. Pieces are about
/// as long as `size`.
pub(super) fn tube(
    points: &[DVec3],
    around: &[[u32; 3]],
    strip: &[[u32; 3]],
    is_first: impl Fn(u32) -> bool,
    leaving: f64,
    size: f64,
) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let at = |v: u32| points[v as usize];
    // The edges of the strip from rim to rim, from the first.
    let across = |triangle: &[u32; 3]| {
        let ordered = edges_of(*triangle).map(|[a, b]| if is_first(a) { [a, b] } else { [b, a] });
        ordered.into_iter().filter(|&[a, b]| is_first(a) && !is_first(b))
    };
    let mut curves: BTreeMap<[u32; 2], Vec<u32>> =
        strip.iter().flat_map(across).map(|edge| (edge, Vec::new())).collect();
    let longest = curves.keys().map(|&[a, b]| at(a).distance(at(b))).fold(0.0, f64::max);
    let pieces = (longest / size).ceil().clamp(1.0, MOST_PIECES) as u32;
    let leaves = leaving_directions(points, around, strip);
    let mut all = points.to_vec();
    for (&[a, b], curve) in &mut curves {
        let chord = at(b) - at(a);
        let slope = |v: u32, sign: f64| {
            let along = leaves.get(&v).map(|way| sign * chord.length() * *way);
            along.map_or(chord, |along| chord.lerp(along, leaving))
        };
        let (start, end) = (slope(a, 1.0), slope(b, -1.0));
        curve.push(a);
        for piece in 1..pieces {
            let t = f64::from(piece) / f64::from(pieces);
            // Hermite's cubic.
            let bend = t * (1.0 - t);
            let straight = at(a) + t * t * (3.0 - 2.0 * t) * chord;
            curve.push(all.len() as u32);
            all.push(straight + bend * ((1.0 - t) * start - t * end));
        }
        curve.push(b);
    }
    let mut triangles = Vec::with_capacity(2 * pieces as usize * strip.len());
    for triangle in strip {
        // Turned so that the corner alone on its rim is the last.
        let alone = (0..3).find(|&i| {
            let [one, other] = [triangle[(i + 1) % 3], triangle[(i + 2) % 3]];
            is_first(one) == is_first(other)
        });
        let Some(alone) = alone else { continue };
        let [tip, a, b] = [0, 1, 2].map(|i| triangle[(alone + i) % 3]);
        let curve = |v: u32| {
            let edge = if is_first(v) { [v, tip] } else { [tip, v] };
            let mut curve = curves.get(&edge).cloned().unwrap_or_default();
            if !is_first(v) {
                curve.reverse();
            }
            curve
        };
        let (left, right) = (curve(a), curve(b));
        for (l, r) in left.windows(2).zip(right.windows(2)) {
            triangles.push([l[0], r[0], r[1]]);
            if l[1] != r[1] {
                triangles.push([l[0], r[1], l[1]]);
            }
        }
    }
    (all, triangles)
}

/// For vertices of the rims: the direction in which the faces around end there, of length 1.
fn leaving_directions(
    points: &[DVec3],
    around: &[[u32; 3]],
    strip: &[[u32; 3]],
) -> BTreeMap<u32, DVec3> {
    let at = |v: u32| points[v as usize];
    let mut beside: Vec<[u32; 2]> = strip.iter().copied().flat_map(edges_of).collect();
    beside.sort_unstable();
    let mut ways: BTreeMap<u32, DVec3> = BTreeMap::new();
    for triangle in around {
        let [a, b, c] = triangle.map(at);
        let normal = (b - a).cross(c - a);
        for [from, to] in edges_of(*triangle) {
            // The strip runs against the faces.
            if beside.binary_search(&[to, from]).is_ok() {
                let way = (at(to) - at(from)).cross(normal).normalize_or_zero();
                for end in [from, to] {
                    *ways.entry(end).or_default() += way;
                }
            }
        }
    }
    ways.into_iter().map(|(v, way)| (v, way.normalize_or_zero())).collect()
}
