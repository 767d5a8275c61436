//! How the triangles of a surface hang together: welded points, neighbours, and one vertex for each fan.

use glam::DVec3;
use mindeg_mesh::parallel::sort_all;
use mindeg_mesh::{DisjointSets, listed, sorted, weld};

use crate::NONE;
use crate::fault::{SurfaceError, SurfaceFault};

/// Triangles of which at most two meet at an edge, in opposite directions, and whose triangles at each vertex form
/// one fan.
#[derive(Clone, Debug, Default)]
pub(crate) struct Links {
    pub(crate) points: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Neighbour i of a triangle lies across the edge opposite its corner i; [`NONE`] on the boundary.
    pub(crate) neighbours: Vec<[u32; 3]>,
    /// The point of the input that each vertex is.
    pub(crate) inputs: Vec<u32>,
    /// The number of vertices that were added because several fans met at a point.
    pub(crate) split_vertices: usize,
}

/// A triangle is flat if it is lower than this share of its longest edge: its normal has no sure digit.
const FLAT: f64 = 1e-12;

impl Links {
    /// Points with equal coordinates become one vertex. O(n log n).
    pub(crate) fn new(points: &[DVec3], triangles: &[[u32; 3]]) -> Result<Self, SurfaceError> {
        let mut faults = Vec::new();
        check_numbers(points, triangles, &mut faults);
        if !faults.is_empty() {
            return Err(SurfaceError { faults });
        }
        let first = weld(points, 0.0);
        let welded: Vec<[u32; 3]> =
            triangles.iter().map(|corners| corners.map(|v| first[v as usize])).collect();
        check_shapes(points, &welded, &mut faults);
        let neighbours = neighbours(points, &welded, &mut faults);
        if !faults.is_empty() {
            return Err(SurfaceError { faults });
        }
        Ok(Self::of_fans(points, welded, neighbours))
    }

    /// Numbers the vertices anew, in the order of their points: each fan has a vertex of its own.
    fn of_fans(points: &[DVec3], welded: Vec<[u32; 3]>, neighbours: Vec<[u32; 3]>) -> Self {
        let mut fans = DisjointSets::new(3 * welded.len());
        join_across(&welded, &neighbours, |_, _| true, &mut fans);
        // By point and then by fan, so that the first fan of a point comes first.
        let mut corners: Vec<[u32; 3]> = (0_u32..)
            .zip(welded.iter().flatten())
            .map(|(corner, &point)| [point, fans.least(corner), corner])
            .collect();
        sort_all(&mut corners);
        let mut links = Self { triangles: welded, neighbours, ..Self::default() };
        let mut last = [NONE; 2];
        for [point, fan, corner] in corners {
            if [point, fan] != last {
                links.split_vertices += usize::from(last[0] == point);
                last = [point, fan];
                links.points.push(points[point as usize]);
                links.inputs.push(point);
            }
            let vertex = (links.points.len() - 1) as u32;
            links.triangles[corner as usize / 3][corner as usize % 3] = vertex;
        }
        links
    }
}

/// Joins the corners of triangles at a vertex across those edges (triangle, edge) that `passes` allows.
pub(crate) fn join_across(
    triangles: &[[u32; 3]],
    neighbours: &[[u32; 3]],
    mut passes: impl FnMut(u32, usize) -> bool,
    corners: &mut DisjointSets,
) {
    for (t, around) in (0_u32..).zip(neighbours) {
        for (i, &u) in around.iter().enumerate() {
            if u == NONE || u < t || !passes(t, i) {
                continue;
            }
            let j = edge_of(triangles[u as usize], triangles[t as usize], i);
            // The edge runs the other way in the neighbour.
            for (own, other) in [(i + 1, j + 2), (i + 2, j + 1)] {
                corners.join(3 * t + (own % 3) as u32, 3 * u + (other % 3) as u32);
            }
        }
    }
}

/// The edge of triangle `u` that is edge `i` of its neighbour `t`, both given by their vertices.
pub(crate) fn edge_of(u: [u32; 3], t: [u32; 3], i: usize) -> usize {
    let (from, to) = (t[(i + 1) % 3], t[(i + 2) % 3]);
    (0..3).find(|&j| u[(j + 1) % 3] == to && u[(j + 2) % 3] == from).unwrap_or(0)
}

/// The indices of the edges at each vertex, vertex by vertex in ascending order, and where each vertex's start.
pub(crate) fn by_vertex(
    vertices: usize,
    edges: impl Iterator<Item = [u32; 2]> + Clone,
) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; vertices + 1];
    edges.clone().flatten().for_each(|v| starts[v as usize + 1] += 1);
    for v in 0..vertices {
        starts[v + 1] += starts[v];
    }
    let mut next = starts.clone();
    let mut at = vec![0; starts[vertices]];
    for (edge, ends) in (0_u32..).zip(edges) {
        for v in ends {
            at[next[v as usize]] = edge;
            next[v as usize] += 1;
        }
    }
    (starts, at)
}

fn check_numbers(points: &[DVec3], triangles: &[[u32; 3]], faults: &mut Vec<SurfaceFault>) {
    let mut fault = |place, what| faults.push(SurfaceFault { place, what });
    if triangles.is_empty() {
        fault(DVec3::ZERO, "the surface has no triangle".to_owned());
    }
    // Corners of triangles have indices of 32 bits.
    let most = u32::MAX as usize / 3 - 1;
    if points.len() > most || triangles.len() > most {
        fault(DVec3::ZERO, format!("the surface has more than {most} points or triangles"));
    }
    for (index, point) in points.iter().enumerate() {
        if !point.is_finite() || point.abs().max_element() >= LARGEST {
            fault(*point, format!("point {index} has a coordinate that is not below {LARGEST:e}"));
        }
    }
    for (index, corners) in triangles.iter().enumerate() {
        if let Some(corner) = corners.iter().find(|&&corner| corner as usize >= points.len()) {
            let what =
                format!("triangle {index} names point {corner}, and there are {}", points.len());
            fault(DVec3::ZERO, what);
        }
    }
}

/// Coordinates are below this, so that products of four of them are finite.
const LARGEST: f64 = 1e60;

fn check_shapes(points: &[DVec3], triangles: &[[u32; 3]], faults: &mut Vec<SurfaceFault>) {
    for (t, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| points[v as usize]);
        let longest =
            [b - a, c - b, a - c].map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
        let area = (b - a).cross(c - a).length();
        if area <= FLAT * longest {
            let place = (a + b + c) / 3.0;
            faults.push(SurfaceFault { place, what: format!("triangle {t} has no area") });
        }
    }
}

/// The neighbours of all triangles, and the edges at which there is more than one or that turns.
fn neighbours(
    points: &[DVec3],
    triangles: &[[u32; 3]],
    faults: &mut Vec<SurfaceFault>,
) -> Vec<[u32; 3]> {
    let ends = |half: u32| {
        let corners = triangles[half as usize / 3];
        [corners[(half as usize + 1) % 3], corners[(half as usize + 2) % 3]]
    };
    let mut halves: Vec<([u32; 2], u32)> =
        (0..3 * triangles.len() as u32).map(|half| (sorted(ends(half)), half)).collect();
    sort_all(&mut halves);
    let mut neighbours = vec![[NONE; 3]; triangles.len()];
    for same in halves.chunk_by(|a, b| a.0 == b.0) {
        let [a, b] = same[0].0.map(|v| points[v as usize]);
        let mut fault = |what| faults.push(SurfaceFault { place: a.midpoint(b), what });
        match *same {
            [_] => {}
            [(_, one), (_, other)] if ends(one) != ends(other) => {
                let [t, u] = [one, other].map(|half| half / 3);
                let apex = triangles[t as usize][one as usize % 3];
                // Of the three edges of such a pair, one says it.
                if triangles[u as usize].contains(&apex) && one % 3 == 0 {
                    fault(format!("triangles {t} and {u} cover each other"));
                }
                neighbours[t as usize][one as usize % 3] = u;
                neighbours[u as usize][other as usize % 3] = t;
            }
            [(_, one), (_, other)] => fault(format!(
                "triangles {} and {} share an edge and face opposite ways",
                one / 3,
                other / 3
            )),
            _ => {
                let all = listed(same.iter().map(|(_, half)| (half / 3).to_string()), 4, ", ");
                fault(format!("{} triangles share an edge ({all})", same.len()));
            }
        }
    }
    neighbours
}
