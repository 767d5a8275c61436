//! The edges that cross the sweep line, and their order.

use std::cmp::Ordering;

use glam::DVec2;

use super::super::orientation;

/// The order in which the sweep passes points.
pub(super) fn from_left(a: DVec2, b: DVec2) -> Ordering {
    let order = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    order(a.x, b.x).then(order(a.y, b.y))
}

/// An edge that crosses the sweep line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) left: DVec2,
    pub(super) right: DVec2,
    /// The index of the edge; [`POINT`] of a point.
    pub(super) index: u32,
    /// Whether the edge begins at its left end.
    pub(super) is_rightward: bool,
}

/// The index of a point that is looked up among the edges.
pub(super) const POINT: u32 = u32::MAX;

/// From below, where both edges cross the sweep line. Edges that overlap are in any order.
impl Ord for Edge {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.index == other.index {
            return Ordering::Equal;
        }
        if from_left(self.left, other.left) == Ordering::Greater {
            return other.cmp(self).reverse();
        }
        let above = |point| orientation(self.left, self.right, point);
        let mut side = 0.0;
        if self.left != other.left {
            side = above(other.left);
        }
        if side == 0.0 {
            side = above(other.right);
        }
        // An edge is below another edge that lies to its left.
        0.0.partial_cmp(&side).unwrap_or(Ordering::Equal).then(self.index.cmp(&other.index))
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.index == other.index
    }
}

impl Eq for Edge {}

impl Edge {
    /// Whether a point on the line through the edge lies on the edge.
    pub(super) fn spans(&self, point: DVec2) -> bool {
        from_left(self.left, point) != Ordering::Greater
            && from_left(point, self.right) != Ordering::Greater
    }

    /// The side above the edge.
    pub(super) fn above(&self) -> u32 {
        side_of(self.index, self.is_rightward)
    }

    /// The side below the edge.
    pub(super) fn below(&self) -> u32 {
        side_of(self.index, !self.is_rightward)
    }
}

/// The side of an edge: on its left or on its right.
pub(in super::super) fn side_of(edge: u32, is_left: bool) -> u32 {
    2 * edge + u32::from(!is_left)
}
