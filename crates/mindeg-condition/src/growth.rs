//! Edges that are too long for shorter ones near them.

use crate::chains::Chains;
use glam::DVec2;

/// Edges of more wanted lengths than this are divided.
pub(crate) const LONGEST: f64 = 4.0 / 3.0;
/// Squares that cannot decide are left out where they miss by more than this share: rounding is far less.
const ROUNDING: f64 = 1e-9;

/// The edges by the squares of their middles, with the length of the shortest in each square, in four squares together, and so on.
pub(crate) struct Shortest<'a> {
    chains: &'a Chains,
    min: DVec2,
    extent: f64,
    /// For each square of the finest level, its first edge in `edges`; then their number.
    starts: Vec<u32>,
    edges: Vec<u32>,
    /// The least lengths, from one square of all to the finest level, each with twice as many across.
    levels: Vec<Vec<f64>>,
}

impl<'a> Shortest<'a> {
    /// About two edges to a square of the finest level.
    pub(crate) fn new(chains: &'a Chains) -> Self {
        let mut edges: Vec<u32> = chains.edges().collect();
        let middles = || edges.iter().map(|edge| chains.middle(*edge));
        let min = middles().fold(DVec2::INFINITY, DVec2::min);
        let extent = (middles().fold(DVec2::NEG_INFINITY, DVec2::max) - min).max_element();
        let mut finest = 0;
        while 2 << (2 * finest) < edges.len() {
            finest += 1;
        }
        let across = 1_usize << finest;
        let index = |at: f64| ((at / extent * across as f64) as usize).min(across - 1);
        let square = |edge: u32| {
            let at = chains.middle(edge) - min;
            index(at.y) * across + index(at.x)
        };
        let mut starts = vec![0; across * across + 1];
        let mut shortest = vec![f64::INFINITY; across * across];
        for edge in &edges {
            let square = square(*edge);
            starts[square + 1] += 1;
            shortest[square] = chains.length(*edge).min(shortest[square]);
        }
        (0..across * across).for_each(|square| starts[square + 1] += starts[square]);
        edges.sort_by_key(|edge| square(*edge));
        let mut levels = vec![shortest];
        for level in (0..finest).rev() {
            let (across, below) = (1_usize << level, &levels[levels.len() - 1]);
            let of_four = |square: usize| {
                let [x, y] = [square % across, square / across];
                let part = |i: usize| below[(2 * y + i / 2) * 2 * across + 2 * x + i % 2];
                (0..4).map(part).fold(f64::INFINITY, f64::min)
            };
            levels.push((0..across * across).map(of_four).collect());
        }
        levels.reverse();
        Self { chains, min, extent, starts, edges, levels }
    }

    /// True if an edge is too long for one near it and `growth` times their distance. O(log n) where lengths change gradually.
    pub(crate) fn grows_fast(&self, edge: u32, growth: f64) -> bool {
        let (own, length) = (self.chains.middle(edge), self.chains.length(edge));
        let is_short = |other: f64, distance: f64| LONGEST * (other + growth * distance) < length;
        let mut squares = vec![(0, 0, 0)];
        while let Some((level, x, y)) = squares.pop() {
            let across = 1_usize << level;
            let side = self.extent / across as f64;
            let low = self.min + DVec2::new(x as f64, y as f64) * side;
            let off = (low - own).max(own - low - side).max(DVec2::ZERO).length();
            let shortest = self.levels[level][y * across + x];
            if !is_short(shortest * (1.0 - ROUNDING), off * (1.0 - ROUNDING)) {
                continue;
            }
            if level + 1 < self.levels.len() {
                let parts = [[0, 0], [1, 0], [0, 1], [1, 1]];
                squares.extend(parts.map(|[i, j]| (level + 1, 2 * x + i, 2 * y + j)));
                continue;
            }
            let square = y * across + x;
            let inside = self.starts[square] as usize..self.starts[square + 1] as usize;
            let is_near = |other: &u32| {
                is_short(self.chains.length(*other), own.distance(self.chains.middle(*other)))
            };
            if self.edges[inside].iter().any(is_near) {
                return true;
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::demands::{Given, Hold};
    use mindeg_mesh::planar::PlanarBoundary;

    #[test]
    fn an_edge_is_too_long_for_one_of_all_others() {
        let mut found = [0; 2];
        for count in [3, 5, 40, 700] {
            // A star whose points crowd on one side.
            let at = |i: u32| {
                let share = f64::from(i) / f64::from(count);
                let angle = std::f64::consts::TAU * share.powi(4);
                let out = 2.0 + libm::fmod(f64::from(i) * 0.618, 1.0);
                DVec2::new(out * libm::cos(angle), out * libm::sin(angle))
            };
            let ring: Vec<DVec2> = (0..count).map(at).collect();
            let boundary = PlanarBoundary::new(&[ring]).unwrap();
            let (hold, has_domain, is_straight) = (|_| Hold::Free, |_| [true, false], |_| false);
            let chains =
                Chains::new(&boundary, &Given { hold, has_domain, is_straight, marks: &[] }, 1);
            let shortest = Shortest::new(&chains);
            for growth in [0.35, 0.4, 1.0, 1.9] {
                for edge in chains.edges() {
                    let (own, length) = (chains.middle(edge), chains.length(edge));
                    let is_near = |other: u32| {
                        let distance = own.distance(chains.middle(other));
                        LONGEST * (chains.length(other) + growth * distance) < length
                    };
                    let any = chains.edges().any(is_near);
                    assert_eq!(shortest.grows_fast(edge, growth), any, "{count} {growth} {edge}");
                    found[usize::from(any)] += 1;
                }
            }
        }
        assert!(found[0] > 100 && found[1] > 100, "{found:?}");
    }
}
