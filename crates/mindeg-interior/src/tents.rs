//! The limits of the minimum angle from two edges that face each other.

use crate::breaklines::Breaklines;
use crate::edge_tree::{EdgeTree, Item};
use crate::triangle::cross;
use glam::DVec2;
use mindeg_mesh::parallel::blocks;
use mindeg_mesh::planar::PlanarBoundary;
use std::f64::consts::PI;
use std::ops::Range;

/// The limit from two boundary edges that face each other.
///
/// The triangle on a boundary edge has angles of at least a at both ends, so it contains the isosceles
/// triangle with base angles a, the tent of the edge. Two edges without a common end never
/// share a triangle (unless the domain is one triangle), so their tents must not overlap. That holds for any domain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TentLimit {
    /// No mesh has a greater minimum angle, in degrees.
    pub angle: f64,
    /// The first vertices of the two edges that decide.
    pub edges: [u32; 2],
}

/// The tent limit of an outline, if it is below `below` degrees.
#[must_use]
pub fn tent_limit(outline: &PlanarBoundary, below: f64) -> Option<TentLimit> {
    let least = std::cell::Cell::new(below.min(60.0));
    let mut found = None;
    let lines = Breaklines::default();
    let tents = Tents::new(outline, &lines);
    tents.near(0..tents.edges.len(), &mut || least.get(), &mut |pair| {
        least.set(tents.touching_angle(pair, least.get()));
        found = Some(pair.map(|edge| edge as u32));
    });
    found.map(|edges| TentLimit { angle: least.get(), edges })
}

/// The pairs of edges whose tent limit is below `below` degrees, each with one of the edges from the index `first` on: where some have
/// changed, others need not be looked at again. Each edge runs between two vertices with the domain on its left, so a line inside is two edges, one a
/// way; `at` tells where a vertex is. The edges of a [`TentLimit`] are indices of `edges`.
///
/// O(n log n + k) for n edges and k pairs where edges are short beside the domain.
#[must_use]
pub fn tents_below(
    edges: &[[u32; 2]],
    first: usize,
    at: impl Fn(u32) -> DVec2,
    below: f64,
) -> Vec<TentLimit> {
    let tents = Tents::of_edges(edges, first, at);
    let among = |edges: Range<u32>| {
        let mut found = Vec::new();
        tents.near(edges.start as usize..edges.end as usize, &mut || below, &mut |pair| {
            let angle = tents.touching_angle(pair, below);
            found.push(TentLimit { angle, edges: pair.map(|edge| edge as u32) });
        });
        found
    };
    blocks(edges.len() as u32, among).concat()
}

/// The tent limit of each vertex of an outline and of lines in degrees: that of its edges, `most` where it is more. So
/// one strait excuses nothing elsewhere.
pub(crate) fn tent_limits(outline: &PlanarBoundary, lines: &Breaklines, most: f64) -> Vec<f64> {
    let mut vertices = vec![most; outline.points().len() + lines.points.len()];
    let tents = Tents::new(outline, lines);
    tents.near(0..tents.edges.len(), &mut || most, &mut |pair| {
        let angle = tents.touching_angle(pair, most);
        for vertex in pair.into_iter().flat_map(|edge| tents.edges[edge]) {
            vertices[vertex as usize] = vertices[vertex as usize].min(angle);
        }
    });
    vertices
}

/// The frozen edges that have a tent each, on their left.
struct Tents {
    edges: Vec<[u32; 2]>,
    ends: Vec<[DVec2; 2]>,
    /// Over those that make a pair with each other and with the rest.
    trees: Vec<EdgeTree>,
}

impl Tents {
    /// The edges of an outline, then of lines both ways.
    fn new(outline: &PlanarBoundary, lines: &Breaklines) -> Self {
        let inner = lines.edges.iter().flat_map(|[a, b]| [[*a, *b], [*b, *a]]);
        let edges: Vec<[u32; 2]> = outline.edges().chain(inner).collect();
        let ends: Vec<[DVec2; 2]> =
            edges.iter().map(|edge| edge.map(|v| lines.at(outline, v))).collect();
        let on_lines = tree_of(&ends, outline.points().len());
        Self { edges, ends, trees: vec![EdgeTree::of_boundary(outline), on_lines] }
    }

    fn of_edges(edges: &[[u32; 2]], first: usize, at: impl Fn(u32) -> DVec2) -> Self {
        let ends: Vec<[DVec2; 2]> = edges.iter().map(|edge| edge.map(&at)).collect();
        let trees = vec![tree_of(&ends, first)];
        Self { edges: edges.to_vec(), ends, trees }
    }

    /// Calls `found` with each of some edges and a later one whose tents of the angle `angle()`, in degrees, overlap.
    fn near(
        &self,
        edges: Range<usize>,
        angle: &mut dyn FnMut() -> f64,
        found: &mut dyn FnMut([usize; 2]),
    ) {
        let mut near = Vec::new();
        for edge in edges {
            let tangent = libm::tan(angle() * (PI / 180.0));
            let ends = self.ends[edge];
            let (middle, half) = (ends[0].midpoint(ends[1]), ends[0].distance(ends[1]) / 2.0);
            let reach = half * (1.0 + tangent * tangent).sqrt();
            near.clear();
            for tree in &self.trees {
                tree.visit(
                    |node| node.distance(middle) <= reach + node.greatest / 2.0 * tangent,
                    |other| near.push(other as usize),
                );
            }
            for &other in &near {
                let is_joined = self.edges[other].iter().any(|v| self.edges[edge].contains(v));
                if other <= edge || is_joined {
                    continue;
                }
                let tangent = libm::tan(angle() * (PI / 180.0));
                if overlap(tent(ends, tangent), tent(self.ends[other], tangent)) {
                    found([edge, other]);
                }
            }
        }
    }

    /// The angle in degrees up to which the tents of two edges do not overlap, at most `most`.
    fn touching_angle(&self, pair: [usize; 2], most: f64) -> f64 {
        let tangent = libm::tan(most * (PI / 180.0));
        libm::atan(touching(self.ends[pair[0]], self.ends[pair[1]], tangent)) * (180.0 / PI)
    }
}

/// The tree over the edges from the index `first` on.
fn tree_of(ends: &[[DVec2; 2]], first: usize) -> EdgeTree {
    let item = |(id, &[from, to]): (usize, &[DVec2; 2])| Item {
        id: id as u32,
        from,
        to,
        size: from.distance(to),
        reach: 0.0,
    };
    EdgeTree::of_items(ends.iter().enumerate().skip(first).map(item).collect())
}

/// The isosceles triangle on an edge, to its left, with base angles of this tangent.
fn tent([a, b]: [DVec2; 2], tangent: f64) -> [DVec2; 3] {
    [a, b, a.midpoint(b) + (b - a).perp() * (tangent / 2.0)]
}

/// The tangent up to which the tents of two edges do not overlap, by bisection.
fn touching(first: [DVec2; 2], second: [DVec2; 2], above: f64) -> f64 {
    let (mut low, mut high) = (0.0, above);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if overlap(tent(first, middle), tent(second, middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    // The upper end: the bound must be on the safe side.
    high
}

/// True if two counter-clockwise triangles have interior points in common: no edge of either
/// has all of the other on its right.
fn overlap(first: [DVec2; 3], second: [DVec2; 3]) -> bool {
    let separates = |edges: &[DVec2; 3], points: &[DVec2; 3]| {
        (0..3).any(|i| {
            let (from, to) = (edges[i], edges[(i + 1) % 3]);
            points.iter().all(|p| cross(to - from, *p - from) <= 0.0)
        })
    };
    !separates(&first, &second) && !separates(&second, &first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn the_least_tent_limit_is_that_of_the_outline() {
        for outline in [
            samples::rectangle(40.0, 0.2, [100, 1, 100, 1]),
            samples::rectangle(9.0, 0.7, [9, 1, 14, 1]),
        ] {
            let limits = tent_limits(&outline, &Breaklines::default(), 60.0);
            let least = limits.iter().copied().fold(60.0, f64::min);
            assert_eq!(least, tent_limit(&outline, 60.0).unwrap().angle);
        }
        // Far from the strait there is no limit.
        let hole = samples::ring(&[[1.0, 0.1], [1.0, 2.0], [2.0, 2.0], [2.0, 0.1]], &[1; 4]);
        let outer = samples::ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[4; 4]);
        let outline = PlanarBoundary::new(&[outer, hole]).unwrap();
        let limits = tent_limits(&outline, &Breaklines::default(), 35.0);
        let strait = libm::atan(0.1).to_degrees();
        for vertex in [1, 2, 16, 19] {
            assert!((limits[vertex] - strait).abs() < 1e-6, "{vertex}: {limits:?}");
        }
        assert_eq!(limits[10], 35.0);
    }

    #[test]
    fn tent_limits_are_those_of_all_pairs_of_edges() {
        let hole = samples::ring(&[[1.0, 0.1], [1.0, 2.0], [2.0, 1.9], [2.0, 0.2]], &[1, 3, 2, 1]);
        let outer = samples::ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[9, 1, 5, 2]);
        for (outline, most) in [
            (samples::rectangle(9.0, 0.7, [9, 1, 14, 1]), 60.0),
            (samples::rectangle(40.0, 0.2, [100, 1, 30, 1]), 35.0),
            (PlanarBoundary::new(&[outer, hole]).unwrap(), 50.0),
        ] {
            let lines = Breaklines::default();
            let tents = Tents::new(&outline, &lines);
            let mut expected = vec![most; outline.points().len()];
            for second in 0..tents.edges.len() {
                for first in 0..second {
                    let [a, b] = [first, second].map(|edge| tents.edges[edge]);
                    if a.iter().any(|vertex| b.contains(vertex)) {
                        continue;
                    }
                    let angle = tents.touching_angle([first, second], most);
                    for vertex in [a, b].concat() {
                        expected[vertex as usize] = angle.min(expected[vertex as usize]);
                    }
                }
            }
            let found = tent_limits(&outline, &lines, most);
            for (vertex, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!((found - expected).abs() < 1e-9, "{vertex}: {found} {expected}");
            }
            assert!(expected.iter().any(|&limit| limit < most));
        }
    }

    #[test]
    fn the_tent_of_a_long_edge_reaches_to_its_ends() {
        // Below, one edge of 8; above its right end, a hole with edges of a half.
        let outer = samples::ring(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]], &[1, 8, 8, 8]);
        let hole = samples::ring(&[[6.0, 0.1], [6.0, 2.1], [7.0, 2.1], [7.0, 0.1]], &[4, 2, 4, 2]);
        let outline = PlanarBoundary::new(&[outer, hole]).unwrap();
        let edges: Vec<[u32; 2]> = outline.edges().collect();
        let ends = |edge: [u32; 2]| edge.map(|v| outline.point(v));
        let mut tangent = libm::tan(PI / 3.0);
        for (i, &first) in edges.iter().enumerate() {
            for &second in &edges[i + 1..] {
                if !first.iter().any(|v| second.contains(v)) {
                    tangent = tangent.min(touching(ends(first), ends(second), tangent));
                }
            }
        }
        let found = tent_limit(&outline, 60.0).unwrap();
        assert!((found.angle - libm::atan(tangent).to_degrees()).abs() < 1e-9, "{found:?}");
        assert_eq!(found.edges[0], 0);
    }

    /// Where some edges have changed, the pairs without one of them are as they were.
    #[test]
    fn pairs_of_changed_edges_are_found_alone() {
        let hole = samples::ring(&[[1.0, 0.1], [1.0, 2.0], [2.0, 1.9], [2.0, 0.2]], &[4, 3, 2, 5]);
        let outer = samples::ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[9, 1, 5, 2]);
        let outline = PlanarBoundary::new(&[outer, hole]).unwrap();
        let edges: Vec<[u32; 2]> = outline.edges().collect();
        let pairs = |first| {
            let tents = tents_below(&edges, first, |v| outline.point(v), 50.0).into_iter();
            let mut pairs: Vec<[u32; 2]> = tents.map(|tent| tent.edges).collect();
            pairs.sort_unstable();
            pairs
        };
        let all = pairs(0);
        let mut counts = Vec::new();
        for first in [edges.len(), 30, 28, 0] {
            let mut of_last = all.clone();
            of_last.retain(|pair| pair.iter().any(|edge| *edge >= first as u32));
            assert_eq!(pairs(first), of_last, "{first}");
            counts.push(of_last.len());
        }
        assert!(counts.is_sorted_by(|a, b| a < b), "{counts:?}");
    }
}
