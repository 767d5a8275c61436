//! The runs of edges that the tree is made of, and what a search asks them.

use super::Item;
use glam::DVec2;
use mindeg_mesh::Bounds;

/// A run of edges: the first end of the first, the last end of the last, and sums. Edges that do not hang together have
/// the middle line of their box instead of these ends.
///
/// The fields that searches look at come first, on one line of a cache.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub(crate) struct Node {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    /// No point of the run is farther from the chord.
    pub(crate) spread: f64,
    pub(crate) least: f64,
    pub(crate) greatest: f64,
    /// The two halves; 0 at a leaf.
    pub(super) halves: [u32; 2],
    pub(crate) is_straight: bool,
    /// The sum of the edges' lengths.
    pub(crate) length: f64,
    /// The sum of length times size.
    pub(crate) moment: f64,
    /// The sum of length times n n^T, with n the unit normal: xx, xy, yy.
    pub(crate) normals: [f64; 3],
    /// The edge of a leaf.
    pub(super) id: u32,
}

impl Node {
    pub(super) fn leaf(item: &Item) -> Self {
        let chord = item.to - item.from;
        let length = chord.length();
        let normals = if length > 0.0 {
            [chord.y * chord.y, -chord.x * chord.y, chord.x * chord.x].map(|n| n / length)
        } else {
            [0.0; 3]
        };
        Self {
            from: item.from,
            to: item.to,
            spread: item.reach,
            least: item.size,
            greatest: item.size,
            length,
            moment: length * item.size,
            normals,
            is_straight: true,
            id: item.id,
            halves: [0; 2],
        }
    }

    /// `bounds`: of the edges of both.
    pub(super) fn join(a: &Self, b: &Self, bounds: &Bounds) -> Self {
        let (from, to, spread) = if a.to == b.from { chord(a, b) } else { middle_line(bounds) };
        let normals = [0, 1, 2].map(|i| a.normals[i] + b.normals[i]);
        Self {
            from,
            to,
            spread,
            least: a.least.min(b.least),
            greatest: a.greatest.max(b.greatest),
            length: a.length + b.length,
            moment: a.moment + b.moment,
            normals,
            is_straight: false,
            id: 0,
            halves: [0; 2],
        }
    }

    /// No edge of the run is nearer to `x`; exact for one edge.
    pub(crate) fn distance(&self, x: DVec2) -> f64 {
        (distance_to_segment(x, self.from, self.to) - self.spread).max(0.0)
    }
}

/// The chord of two runs, the second of which begins where the first ends, and how far they stray from it.
fn chord(a: &Node, b: &Node) -> (DVec2, DVec2, f64) {
    let (from, to) = (a.from, b.to);
    // Distance to a segment is convex: along a child's chord it is greatest at an end.
    let stray = |child: &Node| {
        let ends = [child.from, child.to].map(|end| distance_to_segment(end, from, to));
        ends[0].max(ends[1]) + child.spread
    };
    (from, to, stray(a).max(stray(b)))
}

/// The middle line of a box along its longer sides, and half of the shorter ones.
fn middle_line(bounds: &Bounds) -> (DVec2, DVec2, f64) {
    let (size, middle) = (bounds.size(), bounds.center());
    let half =
        if size.x < size.y { DVec2::new(0.0, size.y) } else { DVec2::new(size.x, 0.0) } / 2.0;
    (middle - half, middle + half, size.min_element() / 2.0)
}

/// True if all edges of the run are of one length and on one line.
pub(crate) fn is_uniform(node: &Node) -> bool {
    node.is_straight && node.greatest <= node.least * (1.0 + 1e-6)
}

/// The distance from `x` to the segment `a`-`b`.
pub(crate) fn distance_to_segment(x: DVec2, a: DVec2, b: DVec2) -> f64 {
    let chord = b - a;
    let squared = chord.length_squared();
    if squared == 0.0 {
        return x.distance(a);
    }
    let t = ((x - a).dot(chord) / squared).clamp(0.0, 1.0);
    x.distance(a + chord * t)
}
