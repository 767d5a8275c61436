//! The gap between meshes: the rings of an area without the meshes in it.
//!
//! Where the border of the area enters a mesh, a ring goes on along the mesh's boundary, from the last boundary vertex that lies in the
//! area: so no edge of a mesh is divided.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_mesh::planar::{PlanarBoundary, orientation};

use crate::error::MeshError;

/// A point of a ring of the gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// A boundary vertex of a mesh.
    Mesh(u32),
    /// A vertex of the area's border.
    Area(u32),
}

/// A corner of a ring, and the edge of the area's border on which the ring runs on from there; none along a mesh.
pub(super) type Step = (Corner, Option<u32>);

/// Where a boundary edge of a mesh crosses the border of the area.
#[derive(Clone, Copy)]
struct Crossing {
    /// The end of the edge that lies in the area.
    vertex: u32,
    /// The edge of the border, and the share of its length.
    edge: u32,
    share: f64,
}

/// A point in words.
pub(super) fn shown(at: DVec2) -> String {
    mindeg_mesh::place(at)
}

/// The rings around the gap, each with the gap on its left.
///
/// `next` leads from each boundary vertex of the meshes to the one after it, with the mesh on the left.
pub(super) fn rings(
    points: &[DVec2],
    next: &BTreeMap<u32, u32>,
    area: &PlanarBoundary,
) -> Result<Vec<Vec<Step>>, MeshError> {
    let at = |vertex: u32| points[vertex as usize];
    let is_in: BTreeMap<u32, bool> =
        next.keys().map(|&vertex| (vertex, winds(area, at(vertex)))).collect();
    let (mut enters, mut leaves): (Vec<Crossing>, BTreeMap<u32, Crossing>) = Default::default();
    // The gap is on the other side of the boundary, so its rings run from `to` to `from`.
    for (&from, &to) in next {
        if is_in[&from] == is_in[&to] {
            continue;
        }
        let vertex = if is_in[&from] { from } else { to };
        let (edge, share) = crossing(area, [at(from), at(to)])?;
        let crossing = Crossing { vertex, edge, share };
        if is_in[&from] {
            enters.push(crossing);
        } else {
            leaves.insert(vertex, crossing);
        }
    }
    let before: BTreeMap<u32, u32> = next.iter().map(|(from, to)| (*to, *from)).collect();
    let mut rings = Vec::new();
    let mut is_used = vec![false; enters.len()];
    let is_border_free = |ring: std::ops::Range<u32>| {
        !enters.iter().chain(leaves.values()).any(|crossing| ring.contains(&crossing.edge))
    };
    for start in 0..enters.len() {
        let (mut ring, mut entry) = (Vec::new(), start);
        while !is_used[entry] {
            is_used[entry] = true;
            let mut vertex = enters[entry].vertex;
            // The new mesh would touch that mesh at this vertex alone.
            if leaves.contains_key(&vertex) {
                return Err(MeshError::Refused(format!(
                    "the area has the boundary vertex at {} and no edge of that mesh: make it wider there, so that it has a whole edge \
                     of each mesh that it joins",
                    shown(at(vertex))
                )));
            }
            // Chains end where an edge leaves the area.
            while !leaves.contains_key(&vertex) {
                ring.push((Corner::Mesh(vertex), None));
                vertex = before[&vertex];
            }
            let exit = leaves[&vertex];
            ring.push((Corner::Mesh(vertex), Some(exit.edge)));
            let (on_border, following) = along_border(area, exit, &enters)?;
            ring.extend(on_border.into_iter().map(|vertex| (Corner::Area(vertex), Some(vertex))));
            entry = following;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    let covers = |at: DVec2| {
        let crosses = next.iter().filter(|(from, to)| {
            let [from, to] = [points[**from as usize], points[**to as usize]];
            is_right_of(at, [from, to])
        });
        crosses.count() % 2 == 1
    };
    let is_covered: Vec<bool> = area
        .rings()
        .map(|ring| is_border_free(ring.clone()) && covers(area.point(ring.start)))
        .collect();
    let free = area.rings().zip(&is_covered);
    for (ring, _) in free.filter(|(ring, is_covered)| is_border_free(ring.clone()) && !**is_covered)
    {
        rings.push(ring.map(|vertex| (Corner::Area(vertex), Some(vertex))).collect());
    }
    // Boundaries within the area: meshes there are holes of the gap. Holes of a mesh are islands, unless the border of the
    // area is in the mesh all around.
    let mut is_done: BTreeMap<u32, bool> = is_in.iter().map(|(v, is_in)| (*v, !is_in)).collect();
    for ring in &rings {
        for corner in ring {
            if let (Corner::Mesh(vertex), _) = *corner {
                is_done.insert(vertex, true);
            }
        }
    }
    for &start in next.keys() {
        let mut ring = Vec::new();
        let mut vertex = start;
        while !std::mem::replace(is_done.entry(vertex).or_insert(true), true) {
            ring.push(vertex);
            vertex = before[&vertex];
        }
        let place = |index: usize| at(ring[index % ring.len()]);
        let doubled: f64 = (0..ring.len()).map(|i| place(i).perp_dot(place(i + 1))).sum();
        // Seen from the gap, a mesh is clockwise.
        if !ring.is_empty() && (doubled < 0.0 || is_covered[0]) {
            rings.push(ring.into_iter().map(|vertex| (Corner::Mesh(vertex), None)).collect());
        }
    }
    Ok(rings)
}

/// The vertices of the border from where a mesh ends to where the next one begins, and the index of the latter.
fn along_border(
    area: &PlanarBoundary,
    exit: Crossing,
    enters: &[Crossing],
) -> Result<(Vec<u32>, usize), MeshError> {
    let mut on_border = Vec::new();
    let (mut edge, mut after) = (exit.edge, exit.share);
    for _ in 0..=area.ring(area.in_ring(edge).ring).len() {
        let own = enters.iter().enumerate().filter(|(_, it)| it.edge == edge && it.share > after);
        if let Some((index, _)) = own.min_by(|a, b| a.1.share.total_cmp(&b.1.share)) {
            return Ok((on_border, index));
        }
        edge = area.next(edge);
        on_border.push(edge);
        after = -1.0;
    }
    let place = shown(area.point(exit.edge));
    Err(MeshError::Refused(format!(
        "the border of the area leaves a mesh near {place} and comes to none: move the border there"
    )))
}

/// Where an edge crosses the border of the area: once.
fn crossing(area: &PlanarBoundary, [a, b]: [DVec2; 2]) -> Result<(u32, f64), MeshError> {
    let mut found = None;
    for [from, to] in area.edges() {
        let [p, q] = [from, to].map(|vertex| area.point(vertex));
        let crosses =
            is_left(p, [a, b]) != is_left(q, [a, b]) && is_left(a, [p, q]) != is_left(b, [p, q]);
        if crosses {
            let normal = (b - a).perp();
            let share = (a - p).dot(normal) / (q - p).dot(normal);
            if found.replace((from, share)).is_some() {
                return Err(MeshError::Refused(format!(
                    "the border of the area crosses the boundary edge at {} several times: give the border fewer bends there",
                    shown(a)
                )));
            }
        }
    }
    let is_on_border = |x: &DVec2| {
        let mut edges = area.edges().map(|ends| ends.map(|vertex| area.point(vertex)));
        edges.any(|[p, q]| orientation(p, q, *x) == 0.0 && (p - *x).dot(q - *x) <= 0.0)
    };
    found.ok_or_else(|| {
        MeshError::Refused(format!(
            "the border of the area passes through the boundary vertex at {}: move it a little",
            shown([a, b].into_iter().find(is_on_border).unwrap_or(a))
        ))
    })
}

fn is_left(at: DVec2, [from, to]: [DVec2; 2]) -> bool {
    orientation(from, to, at) >= 0.0
}

/// Whether a ray to the right of a point crosses an edge.
pub(super) fn is_right_of(at: DVec2, [from, to]: [DVec2; 2]) -> bool {
    let (low, high) = if from.y <= to.y { (from, to) } else { (to, from) };
    low.y <= at.y && at.y < high.y && orientation(low, high, at) > 0.0
}

/// Whether a point lies in the area.
pub(super) fn winds(area: &PlanarBoundary, at: DVec2) -> bool {
    let crosses = area.edges().filter(|ends| is_right_of(at, ends.map(|v| area.point(v))));
    crosses.count() % 2 == 1
}
