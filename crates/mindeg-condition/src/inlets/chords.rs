//! Where shores face each other about one edge apart: inlets that an edge of the triangulation closes.

use super::around::Whole;
use crate::chains::Chains;
use std::collections::BTreeSet;

/// The most edges of an inlet's shore.
const MOST_EDGES: usize = 16;
/// No edge across an inlet is longer than so many edges of its shore,
const WIDTH: f64 = 1.5;
/// and where each triangle has a corner inside.
const WIDTH_OF_CORNERS_INSIDE: f64 = 2.5;

impl Chains<'_> {
    /// How many edges of their shores inlets and straits are wide at most.
    pub(super) fn narrow_width(&self) -> f64 {
        if self.least_triangles > 1 { WIDTH_OF_CORNERS_INSIDE } else { WIDTH }
    }
}

/// The inlets of a boundary, whose vertices are the chains' in order: the shore of each, from one end of its mouth to the other, with the domain
/// on the left. None lies in another one.
pub(super) fn inlets(chains: &Chains<'_>, whole: &Whole<'_>) -> Vec<Vec<u32>> {
    let Whole { boundary, triangles, left, vertices, .. } = whole;
    let on_rings = vertices.len() as u32;
    let is_shore = |edge| whole.is_shore(edge);
    // How many edges of its ring lie behind an edge across, if all that is there are their triangles.
    let behind = |edge: [u32; 2]| -> Option<usize> {
        let (mut stack, mut shore, mut seen) = (vec![edge], 0, 0);
        while let Some([a, b]) = stack.pop() {
            let &triangle = left.get(&[a, b])?;
            seen += 1;
            let corners = triangles[triangle];
            let at = corners.iter().position(|corner| *corner == a)?;
            let third = corners[(at + 2) % 3];
            for side in [[b, third], [third, a]] {
                if is_shore(side) {
                    shore += 1;
                } else {
                    stack.push([side[1], side[0]]);
                }
            }
            if seen > MOST_EDGES {
                return None;
            }
        }
        (shore == seen + 1 && shore <= MOST_EDGES).then_some(shore)
    };
    let at = |v: u32| boundary.point(v);
    let has_domain = |v: u32| chains.vertices[vertices[v as usize] as usize].has_domain;
    let mut chords: Vec<(usize, Vec<u32>, f64)> = Vec::new();
    for &edge @ [a, b] in left.keys() {
        if a >= on_rings || b >= on_rings || is_shore(edge) {
            continue;
        }
        let Some(count) = behind(edge) else { continue };
        // Not most of a ring.
        if boundary.ring(boundary.in_ring(a).ring).len() < 2 * count + 2 {
            continue;
        }
        // From the end of the edge along the shore to its start.
        let shore: Vec<u32> =
            std::iter::successors(Some(b), |v| Some(boundary.next(*v))).take(count + 1).collect();
        if shore.last() != Some(&a)
            || shore[..count].iter().any(|v| has_domain(*v) != [true, false])
        {
            continue;
        }
        let length: f64 = shore.windows(2).map(|ends| at(ends[0]).distance(at(ends[1]))).sum();
        chords.push((count, shore, at(a).distance(at(b)) * count as f64 / length));
    }
    chords.sort_by(|a, b| b.0.cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
    let wide: BTreeSet<[u32; 2]> = chords
        .iter()
        .filter(|chord| chord.2 > chains.narrow_width())
        .map(|(count, shore, _)| [shore[0], shore[*count]])
        .collect();
    let mut used: BTreeSet<u32> = BTreeSet::new();
    let mut found = Vec::new();
    for (_, shore, _) in &chords {
        if shore.iter().all(|v| used.contains(v)) {
            continue;
        }
        let pairs = || {
            let from = |at: usize| shore[at + 2..].iter().map(move |to| [shore[at], *to]);
            (0..shore.len().saturating_sub(2)).flat_map(from)
        };
        if pairs().any(|pair| wide.contains(&pair)) {
            continue;
        }
        used.extend(shore);
        found.push(shore.iter().map(|v| vertices[*v as usize]).collect());
    }
    found
}
