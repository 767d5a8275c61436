//! Deep pockets of a shallow run of narrow triangles, such as a creek in a bay.

use super::pieces::to_segment;
use super::plane::Plane;
use crate::chains::NONE;
use std::collections::BTreeSet;

/// A part behind less than this share of a mouth is another pocket, and makes this one no deeper.
const THROAT: f64 = 0.5;

/// Whether the part of a run behind a side of one of its triangles, on the triangle's side, is deeper than that side is long.
/// `of` tells the run of each triangle.
pub(super) fn is_deep(plane: &Plane<'_>, triangle: u32, side: usize, of: &[u32]) -> bool {
    let Some(ends) = plane.ends(triangle, side) else { return false };
    let mouth = ends.map(|node| plane.at(node));
    let width = mouth[0].distance(mouth[1]);
    let outside = plane.triangles[triangle as usize].beside[side];
    let mut known: BTreeSet<u32> = [triangle, outside].into();
    let mut stack = vec![triangle];
    while let Some(at) = stack.pop() {
        let own = &plane.triangles[at as usize];
        let mut corners = own.corners.into_iter().flatten();
        if corners.any(|node| to_segment(plane.at(node), mouth) > width) {
            return true;
        }
        for side in (0..3).filter(|side| own.is_open(*side)) {
            let other = own.beside[side];
            let is_own = other != NONE && of[other as usize] == of[triangle as usize];
            if is_own && plane.length(at, side) >= THROAT * width && known.insert(other) {
                stack.push(other);
            }
        }
    }
    false
}

/// The triangles of each deep pocket of a run that lies in no other one. `of` tells the run of each triangle.
pub(super) fn pockets(plane: &Plane<'_>, triangles: &[u32], of: &[u32]) -> Vec<Vec<u32>> {
    let mut sorted = triangles.to_vec();
    sorted.sort_unstable();
    let own = |triangle: u32| sorted.binary_search(&triangle).ok();
    // The open sides of a triangle, with the place of the triangle behind in the run, if it is in it.
    let ways = |index: usize| {
        let triangle = &plane.triangles[sorted[index] as usize];
        let run = of[sorted[index] as usize];
        (0..3).filter(|side| triangle.is_open(*side)).map(move |side| {
            let other = triangle.beside[side];
            (side, Some(other).filter(|it| *it != NONE && of[*it as usize] == run))
        })
    };
    // Triangles that have one way out left, each with its side, after those behind it.
    let mut left: Vec<usize> = (0..sorted.len()).map(|index| ways(index).count()).collect();
    let mut is_leaf = vec![false; sorted.len()];
    let mut leaves: Vec<(usize, usize, usize)> = Vec::new();
    let mut next: Vec<usize> = (0..sorted.len()).filter(|index| left[*index] == 1).collect();
    while let Some(index) = next.pop() {
        let way = ways(index).find(|way| way.1.and_then(own).is_none_or(|other| !is_leaf[other]));
        let Some((side, other)) = way else { continue };
        let Some(other) = other.and_then(own) else { continue };
        is_leaf[index] = true;
        leaves.push((index, side, other));
        left[other] -= 1;
        if left[other] == 1 {
            next.push(other);
        }
    }
    // From the outermost on: what is in a pocket goes with it.
    let mut pocket = vec![NONE; sorted.len()];
    let mut found: Vec<Vec<u32>> = Vec::new();
    for &(index, side, behind) in leaves.iter().rev() {
        let (triangle, outer) = (sorted[index], pocket[behind]);
        if outer != NONE {
            pocket[index] = outer;
            found[outer as usize].push(triangle);
        } else if is_deep(plane, triangle, side, of) {
            pocket[index] = found.len() as u32;
            found.push(vec![triangle]);
        }
    }
    found
}
