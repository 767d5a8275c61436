//! The mean of edge lengths as a place sees it: each edge is weighted by the integral of dtheta / r over the angle under
//! which it is seen.

use crate::edge_tree::{EdgeTree, Node, is_uniform};
use glam::DVec2;

/// A run of edges counts as one when it is this much shorter than its distance.
const FAR: f64 = 0.3;

/// Sums over edges that are seen from a place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Seen {
    weights: f64,
    /// Of weights times lengths.
    sum: f64,
}

impl Seen {
    /// The weighted mean of the lengths. On an edge itself its weight is infinite, and there is none.
    pub(crate) fn mean(self) -> Option<f64> {
        (self.sum.is_finite() && self.weights > 0.0).then(|| self.sum / self.weights)
    }

    /// The sums of several places, by weights.
    pub(crate) fn mixed(each: [(Self, f64); 4]) -> Self {
        let sum =
            |part: fn(&Self) -> f64| each.iter().map(|(seen, share)| share * part(seen)).sum();
        Self { weights: sum(|seen| seen.weights), sum: sum(|seen| seen.sum) }
    }

    /// Adds all edges below a node of a tree.
    pub(crate) fn add(&mut self, tree: &EdgeTree, at: u32, x: DVec2) {
        let node = &tree.nodes()[at as usize];
        match tree.children(at) {
            Some(children) if !is_one(tree, at) && !is_far(node, node.distance(x)) => {
                children.into_iter().for_each(|child| self.add(tree, child, x));
            }
            _ => self.add_whole(tree, at, x),
        }
    }

    /// Adds the run of a node as a whole.
    pub(crate) fn add_whole(&mut self, tree: &EdgeTree, at: u32, x: DVec2) {
        let node = &tree.nodes()[at as usize];
        // Weights of one line add up exactly.
        let weight =
            if node.is_straight { sight(node.from - x, node.to - x) } else { distant(node, x) };
        self.weights += weight;
        self.sum += weight * (node.moment / node.length);
    }
}

/// True if a node is an edge, or edges of one length on one line.
pub(crate) fn is_one(tree: &EdgeTree, at: u32) -> bool {
    tree.children(at).is_none() || is_uniform(&tree.nodes()[at as usize])
}

/// True if the run of a node counts as a whole at this distance.
pub(crate) fn is_far(node: &Node, distance: f64) -> bool {
    extent(node) < FAR * distance
}

/// No two points of a run are farther from each other.
pub(crate) fn extent(node: &Node) -> f64 {
    node.from.distance(node.to) + 2.0 * node.spread
}

/// The integral of dtheta / r over a segment, given from the eye to its ends:
/// tan(theta / 2) (1/|a| + 1/|b|).
pub(crate) fn sight(a: DVec2, b: DVec2) -> f64 {
    let (from, to) = (a.length(), b.length());
    a.perp_dot(b).abs() * (from + to) / (from * to * (from * to + a.dot(b)))
}

/// The same for a run that is far away: the edges' lengths, foreshortened, over r squared.
fn distant(node: &Node, x: DVec2) -> f64 {
    let to = node.from.midpoint(node.to) - x;
    let squared = to.length_squared();
    let [xx, xy, yy] = node.normals;
    // Sum of l |n.u|, by Cauchy and Schwarz at most this, and this exactly on one line.
    let projected = xx * to.x * to.x + 2.0 * xy * to.x * to.y + yy * to.y * to.y;
    (node.length * projected.max(0.0) / squared).sqrt() / squared
}
