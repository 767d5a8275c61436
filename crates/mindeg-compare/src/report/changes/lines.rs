//! The boundaries: their lines, what is nearest to a point, and how they are drawn.

use glam::DVec2;
use mindeg::{Bounds, Domain};
use mindeg_mesh::{BoxTree, distance};
use std::fmt::Write as _;

/// The points of a ring, with the first one again at its end, or of a line.
pub(super) type Chain = Vec<DVec2>;

/// The rings and lines of domains.
pub(super) fn chains(domains: &[Domain]) -> Vec<Chain> {
    let mut all = Vec::new();
    for domain in domains {
        for ring in 0..domain.rings().ring_count() {
            let range = domain.rings().ring(ring);
            let closed = range.clone().chain([range.start]);
            all.push(closed.map(|vertex| domain.placement().point(vertex)).collect());
        }
        let Ok(boundary) = domain.boundary() else { continue };
        for line in 0..boundary.line_count() {
            let segments = boundary.line(line);
            let ends = segments.iter().map(|ends| ends[0]);
            let ends = ends.chain(segments.last().map(|ends| ends[1]));
            all.push(ends.map(|vertex| boundary.point(vertex)).collect());
        }
    }
    all
}

/// Edges, to ask for the nearest.
pub(super) struct Nearest<'a> {
    chains: &'a [Chain],
    edges: Vec<(usize, usize)>,
    tree: BoxTree,
}

impl<'a> Nearest<'a> {
    pub(super) fn new(chains: &'a [Chain]) -> Self {
        let edges = chains.iter().enumerate();
        let edges = edges.flat_map(|(chain, it)| (1..it.len()).map(move |end| (chain, end - 1)));
        let edges: Vec<(usize, usize)> = edges.collect();
        let around = |&(chain, index): &(usize, usize)| {
            let [a, b] = [chains[chain][index], chains[chain][index + 1]];
            Bounds { min: a.min(b).extend(0.0), max: a.max(b).extend(0.0) }
        };
        let tree = BoxTree::new(edges.iter().map(around).collect());
        Self { chains, edges, tree }
    }

    /// The nearest edge to a point, as its chain and its place there, and how far it is.
    pub(super) fn of(&self, at: DVec2) -> Option<(usize, usize, f64)> {
        let ends = |edge: u32| {
            let (chain, index) = self.edges[edge as usize];
            [self.chains[chain][index], self.chains[chain][index + 1]]
        };
        let squared = |edge: u32| {
            let distance = distance_to(at, ends(edge));
            distance * distance
        };
        let (edge, squared) = self.tree.nearest(at.extend(0.0), f64::INFINITY, squared)?;
        let (chain, index) = self.edges[edge as usize];
        Some((chain, index, squared.sqrt()))
    }
}

/// The distance of a point from an edge.
pub(super) fn distance_to(at: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let [a, b] = [a, b].map(|end| end.extend(0.0));
    distance::distance_to(at.extend(0.0), &[a, b, b])
}

/// The mean length of edges.
pub(super) fn mean_edge(chains: &[Chain]) -> f64 {
    let lengths = chains.iter().flat_map(|it| it.windows(2).map(|ends| ends[0].distance(ends[1])));
    let (sum, edges) = lengths.fold((0.0, 0_u32), |(sum, edges), it| (sum + it, edges + 1));
    sum / f64::from(edges.max(1))
}

/// The outline of chains; finer than a pixel's tenth, since parts of it are magnified.
pub(super) fn path(chains: &[Chain]) -> String {
    let mut text = String::new();
    let fine = |value: f64| (value * 1e4).round() / 1e4;
    for chain in chains {
        for (index, at) in chain.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            let _ = write!(text, "{command}{} {}", fine(at.x), fine(at.y));
        }
    }
    text
}
