//! Sides that stay straight, such as those of a box: their points go nowhere but along them.

use crate::chains::{Chains, NONE};

impl Chains<'_> {
    /// Whether a vertex is on a side that stays straight.
    pub(crate) fn is_on_straight(&self, vertex: u32) -> bool {
        let is_straight = |v: u32| v != NONE && self.vertices[v as usize].is_straight;
        is_straight(vertex) || is_straight(self.previous(vertex))
    }

    /// Makes the edge from a vertex one that is of no straight side: of two sides that met there, that of the other one.
    pub(crate) fn leave_straight(&mut self, vertex: u32, after: u32) {
        let (is_straight, edge) =
            (self.vertices[after as usize].is_straight, self.vertices[after as usize].point.edge);
        let own = &mut self.vertices[vertex as usize];
        if own.is_straight && !is_straight {
            own.point.edge = edge;
            own.is_straight = false;
        }
    }
}
