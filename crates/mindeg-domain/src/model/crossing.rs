//! Whether the loops of a face bound an area: simple, apart from each other, holes inside.

use glam::{DVec2, DVec3};
use robust::{Coord, orient2d};

use super::{ModelError, ModelFace, Plane};

/// The loops of a face, holes opposite to the outer loop; or why they bound no area.
///
/// Decided exactly for the coordinates in the plane of the face.
pub(super) fn oriented(
    corners: &[DVec3],
    face: usize,
    given: &ModelFace,
    plane: &Plane,
) -> Result<Vec<Vec<u32>>, ModelError> {
    check_repeated(face, &given.loops)?;
    let point = |corner: u32| plane.project(corners[corner as usize]);
    let edges_of = |corners: &Vec<u32>| -> Vec<[u32; 2]> {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(&from, &to)| [from, to]).collect()
    };
    for corners in &given.loops {
        for pair in corners.iter().zip(corners.iter().cycle().skip(1)).zip(corners.iter().cycle().skip(2)) {
            let ((&a, &b), &c) = pair;
            let (back, on) = (point(b) - point(a), point(c) - point(b));
            if back == DVec2::ZERO {
                return Err(ModelError::CoincidentCorners { corners: [a, b] });
            }
            if orientation(point(a), point(b), point(c)) == 0.0 && back.dot(on) < 0.0 {
                return Err(ModelError::Spike { face, from: a, to: b });
            }
        }
    }
    let mut edges: Vec<[u32; 2]> = given.loops.iter().flat_map(edges_of).collect();
    if let Some(edges) = find_crossing(&mut edges, point) {
        return Err(ModelError::Crossing { face, edges });
    }
    let outer = &given.loops[0];
    let mut loops = vec![outer.clone()];
    for (hole, corners) in given.loops.iter().enumerate().skip(1) {
        if !is_inside(point(corners[0]), outer.iter().map(|&corner| point(corner))) {
            return Err(ModelError::HoleOutside { face, hole: hole - 1 });
        }
        let mut corners = corners.clone();
        if doubled_area(corners.iter().map(|&corner| point(corner))) > 0.0 {
            corners.reverse();
        }
        loops.push(corners);
    }
    Ok(loops)
}

fn check_repeated(face: usize, loops: &[Vec<u32>]) -> Result<(), ModelError> {
    let mut corners: Vec<u32> = loops.iter().flatten().copied().collect();
    for corners in loops {
        let n = corners.len();
        // A spike has a better message.
        if let Some(i) = (0..n).find(|&i| corners[i] == corners[(i + 2) % n] && n > 3) {
            return Err(ModelError::Spike { face, from: corners[i], to: corners[(i + 1) % n] });
        }
    }
    corners.sort_unstable();
    match corners.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(ModelError::RepeatedCorner { face, corner: pair[0] }),
        None => Ok(()),
    }
}

fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
    orient2d(a, b, c)
}

/// Two edges that meet other than at a common corner. Edges in the order of their least x are
/// compared with those that begin before they end.
fn find_crossing(edges: &mut [[u32; 2]], point: impl Fn(u32) -> DVec2) -> Option<[[u32; 2]; 2]> {
    let span = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|corner| point(corner).x);
        (a.min(b), a.max(b))
    };
    edges.sort_by(|a, b| span(a).0.total_cmp(&span(b).0));
    for (index, one) in edges.iter().enumerate() {
        let end = span(one).1;
        for other in edges[index + 1..].iter().take_while(|other| span(other).0 <= end) {
            let is_joined = one.iter().any(|corner| other.contains(corner));
            if !is_joined && meet(one.map(&point), other.map(&point)) {
                return Some([*one, *other]);
            }
        }
    }
    None
}

/// Whether two closed segments have a point in common.
fn meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let is_apart = |axis: usize| {
        a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis])
    };
    if is_apart(0) || is_apart(1) {
        return false;
    }
    let split = |a, b, c, d| {
        let (x, y) = (orientation(a, b, c), orientation(a, b, d));
        (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0)
    };
    !split(a, b, c, d) && !split(c, d, a, b)
}

fn doubled_area(points: impl Iterator<Item = DVec2> + Clone) -> f64 {
    let Some(first) = points.clone().next() else { return 0.0 };
    let next = points.clone().cycle().skip(1);
    points.zip(next).map(|(a, b)| (a - first).perp_dot(b - first)).sum()
}

/// Whether a point is inside a loop, by the crossings of a ray towards greater x.
fn is_inside(point: DVec2, points: impl Iterator<Item = DVec2> + Clone) -> bool {
    let next = points.clone().cycle().skip(1);
    let is_crossed = |(a, b): (DVec2, DVec2)| {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        low.y <= point.y && point.y < high.y && orientation(low, high, point) > 0.0
    };
    points.zip(next).filter(|&pair| is_crossed(pair)).count() % 2 == 1
}
