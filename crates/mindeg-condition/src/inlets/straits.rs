//! Straits about one edge wide: runs of triangles between shores that face each other, with mouths at both ends or more.
//!
//! A long one, or an inlet with more shore than is searched at once, is looked at in pieces that overlap.

use super::around::Whole;
use crate::chains::Chains;
use mindeg_mesh::edges_of;
use std::collections::{BTreeMap, BTreeSet};

/// A piece has the triangles up to so many edges across from its middle.
const REACH: usize = 6;
/// Triangles at least so many edges from where it ends need no piece of their own.
const INSIDE: usize = 4;
/// The most mouths of a piece.
const MOST_MOUTHS: usize = 4;

/// The shores of each piece of a strait, with the domain on the left, in their order around it. `inlets` are left out.
pub(super) fn straits(
    chains: &Chains<'_>,
    whole: &Whole<'_>,
    inlets: &[Vec<u32>],
) -> Vec<Vec<Vec<u32>>> {
    let Whole { boundary, triangles, vertices, .. } = whole;
    let on_rings = vertices.len() as u32;
    let at = |v: u32| boundary.point(v);
    let is_shore = |edge| whole.is_shore(edge);
    // Twice the mean length of the edges at each vertex.
    let mut beside = vec![0.0; vertices.len()];
    for v in 0..on_rings {
        let length = at(v).distance(at(boundary.next(v)));
        beside[v as usize] += length;
        beside[boundary.next(v) as usize] += length;
    }
    let has_one_side = |v: u32| {
        v < on_rings && chains.vertices[vertices[v as usize] as usize].has_domain == [true, false]
    };
    let width = chains.narrow_width();
    let is_narrow = |[a, b]: [u32; 2]| {
        has_one_side(a)
            && has_one_side(b)
            && at(a).distance(at(b)) <= width * (beside[a as usize] + beside[b as usize]) / 4.0
    };
    let edges = |triangle: usize| edges_of(triangles[triangle]);
    let mut left: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for triangle in 0..triangles.len() {
        if edges(triangle).into_iter().all(|edge| is_shore(edge) || is_narrow(edge)) {
            left.extend(edges(triangle).map(|edge| (edge, triangle)));
        }
    }
    // The triangles of a piece, from its middle outwards, each with its distance.
    let around = |middle: usize, reach: usize| {
        let mut found = vec![(middle, 0)];
        let mut seen = BTreeSet::from([middle]);
        let mut next = 0;
        while let Some(&(triangle, distance)) = found.get(next) {
            next += 1;
            if distance == reach {
                continue;
            }
            for [a, b] in edges(triangle).into_iter().filter(|edge| !is_shore(*edge)) {
                if let Some(other) = left.get(&[b, a]).filter(|other| seen.insert(**other)) {
                    found.push((*other, distance + 1));
                }
            }
        }
        found
    };
    let of_inlets: Vec<BTreeSet<u32>> =
        inlets.iter().map(|inlet| inlet.iter().copied().collect()).collect();
    let middles: BTreeSet<usize> = left.values().copied().collect();
    let mut covered: BTreeSet<usize> = BTreeSet::new();
    // From several middles pieces may be the same.
    let mut known: BTreeSet<BTreeSet<usize>> = BTreeSet::new();
    let mut found = Vec::new();
    for middle in middles {
        if covered.contains(&middle) {
            continue;
        }
        // As far as it is one polygon.
        let piece = (1..=REACH).rev().find_map(|reach| {
            let own = around(middle, reach);
            let inside: BTreeSet<usize> = own.iter().map(|one| one.0).collect();
            let rim = inside.iter().flat_map(|triangle| edges(*triangle)).filter(|[a, b]| {
                is_shore([*a, *b]) || left.get(&[*b, *a]).is_none_or(|it| !inside.contains(it))
            });
            let rim: BTreeMap<u32, u32> = rim.map(|[a, b]| (a, b)).collect();
            let shores = shores(&rim, inside.len() + 2, is_shore)?;
            Some((own, reach, shores))
        });
        let Some((own, reach, shores)) = piece else { continue };
        let triangles: BTreeSet<usize> = own.iter().map(|one| one.0).collect();
        covered.extend(own.iter().filter(|one| one.1 + INSIDE <= reach).map(|one| one.0));
        let shores: Vec<Vec<u32>> = shores
            .into_iter()
            .map(|shore| shore.into_iter().map(|v| vertices[v as usize]).collect())
            .collect();
        let is_inlet = |inlet: &BTreeSet<u32>| shores.iter().flatten().all(|v| inlet.contains(v));
        if shores.len() > 1
            && own.len() > 1
            && !of_inlets.iter().any(is_inlet)
            && known.insert(triangles)
        {
            found.push(shores);
        }
    }
    found
}

/// The runs of shore of a rim with `count` vertices, parted by its mouths; none if it is not one ring, or has no mouth or too many.
fn shores(
    rim: &BTreeMap<u32, u32>,
    count: usize,
    is_shore: impl Fn([u32; 2]) -> bool,
) -> Option<Vec<Vec<u32>>> {
    if rim.len() != count {
        return None;
    }
    // Behind a mouth.
    let (_, &start) = rim.iter().find(|(a, b)| !is_shore([**a, **b]))?;
    let (mut shores, mut own, mut vertex) = (Vec::new(), vec![start], start);
    for _ in 1..count {
        let next = *rim.get(&vertex)?;
        if next == start {
            return None;
        }
        if !is_shore([vertex, next]) {
            shores.push(std::mem::take(&mut own));
        }
        own.push(next);
        vertex = next;
    }
    shores.push(own);
    (shores.len() <= MOST_MOUTHS && rim.get(&vertex) == Some(&start)).then_some(shores)
}
