//! The groups of a mesh whose edges between groups are kept: told from these edges alone.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

use mindeg_domain::Domain;
use mindeg_mesh::check::CheckError;
use mindeg_mesh::planar::PlanarBoundary;
#[cfg(feature = "interior")]
use mindeg_mesh::sorted;
use mindeg_mesh::{Group, Material, edges_of};

use crate::error::MeshError;

/// The triangles by their regions, and a group for each name and material; no groups if the domain has no regions.
/// `pieces` are the edges that each segment of the boundary was divided into.
pub(crate) fn groups<'p>(
    domain: &Domain,
    boundary: &PlanarBoundary,
    pieces: impl Iterator<Item = &'p [[u32; 2]]>,
    triangles: Vec<[u32; 3]>,
) -> (Vec<[u32; 3]>, Vec<Group>) {
    let Some(faces) = domain.faces() else { return (triangles, Vec::new()) };
    let is_region = |face: &u32| !domain.is_hole(*face);
    let given = domain.inside().regions.iter().any(|region| !region.hole);
    if !given && (0..faces.count as u32).filter(is_region).count() == 1 {
        return (triangles, Vec::new());
    }
    let (on_rings, on_lines) = faces.beside.split_at(boundary.vertex_count() as usize);
    let mut known = BTreeMap::new();
    let mut know = |[a, b]: [u32; 2], [left, right]: [Option<u32>; 2]| {
        known.extend(left.map(|face| ([a, b], face as usize)));
        known.extend(right.map(|face| ([b, a], face as usize)));
    };
    boundary.edges().zip(on_rings).for_each(|(edge, beside)| know(edge, *beside));
    for (edges, beside) in pieces.zip(on_lines) {
        edges.iter().for_each(|&edge| know(edge, *beside));
    }
    // Faces of one name and material are one group.
    let mut groups: Vec<(String, Option<&str>)> = Vec::new();
    let mut indices = BTreeMap::new();
    let group_of = |face| {
        let key = (domain.region_name(face), domain.region_material(face));
        *indices.entry(key.clone()).or_insert_with(|| {
            groups.push(key);
            groups.len() - 1
        })
    };
    let group_of: Vec<usize> = (0..faces.count as u32).map(group_of).collect();
    let mut of_group: Vec<Vec<[u32; 3]>> = vec![Vec::new(); groups.len()];
    for (triangle, face) in triangles.iter().zip(spread(&triangles, &known)) {
        of_group[group_of[face]].push(*triangle);
    }
    let mut materials: BTreeMap<&str, Arc<Material>> = BTreeMap::new();
    let mut end = 0;
    let mut used = Vec::with_capacity(groups.len());
    // Holes have no triangles.
    for ((name, of), own) in groups.into_iter().zip(&of_group).filter(|(_, own)| !own.is_empty()) {
        let start = end;
        end += own.len() as u32;
        let material = of.map(|of| {
            let new = || Arc::new(Material { name: of.to_owned(), color: None });
            materials.entry(of).or_insert_with(new).clone()
        });
        used.push(Group::new(name, start..end).of_material(material));
    }
    (of_group.concat(), used)
}

/// Checks that triangles have the edges of all lines of a domain, and returns the ones without a triangle on their left,
/// at regions that are holes.
pub(crate) fn lines_of_map(
    domain: &Domain,
    boundary: &PlanarBoundary,
    triangles: &[[u32; 3]],
) -> Result<Vec<[u32; 2]>, MeshError> {
    if boundary.segments().is_empty() {
        return Ok(Vec::new());
    }
    let halves: BTreeSet<[u32; 2]> =
        triangles.iter().flat_map(|triangle| edges_of(*triangle)).collect();
    let mut open = Vec::new();
    for (edge, &[from, to]) in (boundary.vertex_count()..).zip(boundary.segments()) {
        let Some(faces) = domain.faces() else { break };
        for (half, face) in [[from, to], [to, from]].into_iter().zip(faces.beside[edge as usize]) {
            let is_hole = face.is_some_and(|face| domain.is_hole(face));
            if is_hole {
                open.push(half);
            } else if !halves.contains(&half) {
                return Err(MeshError::Triangles(CheckError::Gap { from: half[0], to: half[1] }));
            }
        }
    }
    Ok(open)
}

/// The edges between triangles of different groups, each once, in ascending order.
#[cfg(feature = "interior")]
pub(crate) fn interfaces(triangles: &[[u32; 3]], group: impl Fn(usize) -> usize) -> Vec<[u32; 2]> {
    let mut halves: Vec<([u32; 2], usize)> = triangles
        .iter()
        .enumerate()
        .flat_map(|(index, triangle)| edges_of(*triangle).map(|edge| (sorted(edge), group(index))))
        .collect();
    halves.sort_unstable();
    let mut found: Vec<[u32; 2]> = halves
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1)
        .map(|pair| pair[0].0)
        .collect();
    found.dedup();
    found
}

/// The group of each triangle, told from edges that are known to have one on their left: what can
/// be reached from such an edge without crossing another is of its group.
pub(crate) fn spread(triangles: &[[u32; 3]], known: &BTreeMap<[u32; 2], usize>) -> Vec<usize> {
    let mut left = BTreeMap::new();
    for (index, triangle) in triangles.iter().enumerate() {
        left.extend(edges_of(*triangle).map(|edge| (edge, index)));
    }
    let mut group = vec![usize::MAX; triangles.len()];
    let mut queue = VecDeque::new();
    for (edge, of) in known {
        if let Some(&index) = left.get(edge) {
            group[index] = *of;
            queue.push_back(index);
        }
    }
    while let Some(index) = queue.pop_front() {
        for [a, b] in edges_of(triangles[index]) {
            if known.contains_key(&[a, b]) {
                continue;
            }
            if let Some(&other) = left.get(&[b, a])
                && group[other] == usize::MAX
            {
                group[other] = group[index];
                queue.push_back(other);
            }
        }
    }
    group
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_spread_up_to_known_edges() {
        // A strip of four triangles; two groups of two.
        let before = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]];
        assert_eq!(interfaces(&before, |t| t / 2), [[2, 3]]);
        assert_eq!(interfaces(&before, |_| 0), [] as [[u32; 2]; 0]);
        // The same with the diagonals turned.
        let after = [[0, 1, 3], [0, 3, 2], [2, 3, 5], [2, 5, 4]];
        let known = [([3, 2], 0), ([2, 3], 1), ([0, 1], 0), ([5, 4], 1)].into();
        assert_eq!(spread(&after, &known), [0, 0, 1, 1]);
    }
}
