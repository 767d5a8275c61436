//! Lines and names of points: edges and corners that a surface keeps, and what they are in its mesh.

use std::collections::BTreeMap;

use glam::DVec3;
use mindeg_interior::RemeshedCurve;
use mindeg_mesh::{Line, NamedVertex, TriMesh, TriMeshError, Triangles, sorted, weld};
use mindeg_surfaces::Surface;

/// Whether all lines, and all names, are in the mesh.
pub(super) struct CarriedOver {
    pub(super) lines: bool,
    pub(super) names: bool,
}

/// The segments of lines, and the points that are corners: those with names, and those where lines end or cross.
pub(super) fn given(part: &TriMesh) -> (Vec<[u32; 2]>, Vec<u32>) {
    let mut corners: Vec<u32> = part.named_vertices().iter().map(|named| named.vertex).collect();
    if !part.segments().is_empty() {
        let first = weld(part.positions(), 0.0);
        for line in part.lines().iter() {
            let own = line.segments.start as usize..line.segments.end as usize;
            let mut edges: Vec<[u32; 2]> = part.segments()[own]
                .iter()
                .map(|ends| sorted(ends.map(|v| first[v as usize])))
                .collect();
            edges.sort_unstable();
            edges.dedup();
            let mut ends: Vec<u32> = edges.into_iter().flatten().collect();
            ends.sort_unstable();
            corners
                .extend(ends.chunk_by(|a, b| a == b).filter(|same| same.len() != 2).map(|s| s[0]));
        }
    }
    (part.segments().to_vec(), corners)
}

/// The mesh with the lines and names of its part.
pub(super) fn carried_over(
    part: &TriMesh,
    surface: &Surface,
    found: &[RemeshedCurve],
    mesh: TriMesh,
) -> Result<(TriMesh, CarriedOver), TriMeshError> {
    let (lines, named) = (part.lines(), part.named_vertices());
    if lines.is_empty() && named.is_empty() {
        return Ok((mesh, CarriedOver { lines: true, names: true }));
    }
    let first = weld(part.positions(), 0.0);
    let input = |v: u32| surface.inputs()[v as usize];
    // The curve along an edge of the part, and whether it runs from the lesser end to the greater.
    let curve_of: BTreeMap<[u32; 2], (u32, bool)> = surface
        .spans()
        .iter()
        .map(|span| {
            let ends @ [a, b] = span.vertices.map(input);
            (sorted(ends), (span.curve, a < b))
        })
        .collect();
    let mut kept = CarriedOver { lines: true, names: true };
    let (mut own, mut segments) = (Vec::new(), Vec::new());
    for line in lines.iter() {
        let start = segments.len() as u32;
        let mut curves: Vec<u32> = Vec::new();
        for ends in &part.segments()[line.segments.start as usize..line.segments.end as usize] {
            let [a, b] = ends.map(|v| first[v as usize]);
            let Some(&(curve, is_upward)) = curve_of.get(&sorted([a, b])) else {
                kept.lines = false;
                continue;
            };
            if !curves.contains(&curve) {
                curves.push(curve);
                let mut chain = chain(surface, &found[curve as usize], &mesh);
                if is_upward != (a < b) {
                    chain.reverse();
                    chain.iter_mut().for_each(|edge| edge.reverse());
                }
                segments.append(&mut chain);
            }
        }
        let range = start..segments.len() as u32;
        if !range.is_empty() {
            own.push(Line { name: line.name.clone(), segments: range, is_straight: false });
        }
    }
    let mut at: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    for (v, point) in (0_u32..).zip(mesh.positions()) {
        at.entry(bits(*point)).or_insert(v);
    }
    let mut names = Vec::new();
    for NamedVertex { name, vertex } in named.iter() {
        match at.get(&bits(part.positions()[*vertex as usize])) {
            Some(v) => names.push(NamedVertex { name: name.clone(), vertex: *v }),
            None => kept.names = false,
        }
    }
    Ok((mesh.with_lines(own, segments)?.with_named_vertices(names)?, kept))
}

/// The edges of a curve in its direction.
fn chain(surface: &Surface, found: &RemeshedCurve, mesh: &TriMesh) -> Vec<[u32; 2]> {
    let curve = surface.curve(found.curve);
    let mut at: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &[a, b] in &found.edges {
        at.entry(a).or_default().push(b);
        at.entry(b).or_default().push(a);
    }
    let place = |v: u32| mesh.positions()[v as usize];
    // An open curve starts at its first corner; of a closed one, that comes back to its corner, too, the direction at the
    // start tells the first edge.
    let start = curve.points()[0];
    let first = at.keys().copied().min_by(|a, b| {
        let [a, b] = [a, b].map(|v| place(*v).distance_squared(start));
        a.total_cmp(&b)
    });
    let Some(first) = first else { return Vec::new() };
    let ahead = curve.direction(0.0);
    let along = |v: &u32| (place(*v) - place(first)).normalize_or_zero().dot(ahead);
    let second = at[&first].iter().copied().max_by(|a, b| along(a).total_cmp(&along(b)));
    let Some(mut to) = second else { return Vec::new() };
    let mut from = first;
    let mut edges = vec![[from, to]];
    while edges.len() < found.edges.len() {
        let next = at[&to].iter().copied().find(|v| *v != from);
        let Some(next) = next else { break };
        (from, to) = (to, next);
        edges.push([from, to]);
    }
    edges
}

/// A point by the bits of its coordinates.
fn bits(point: DVec3) -> [u64; 3] {
    // Adding zero turns -0 into 0.
    (point + DVec3::ZERO).to_array().map(f64::to_bits)
}
