//! The past of the vertices of chains: what earlier rounds did there.

use crate::chains::{Chains, Vertex};
use glam::DVec2;

/// The past of a vertex, so that all rounds together move a boundary no farther than one may.
#[derive(Clone, Default)]
pub(crate) struct Past {
    /// The dropped points that the edge from there stands for.
    pub(crate) dropped: Vec<DVec2>,
    /// How far it was from the old boundary when it was put on an edge.
    off: f64,
    /// Where it was before it was moved.
    home: Option<DVec2>,
}

impl Chains<'_> {
    /// Takes over what vertices have of an earlier round, in the order of all.
    pub(crate) fn begin_with(&mut self, past: &[Past]) {
        for (vertex, own) in self.vertices.iter_mut().zip(past) {
            vertex.dropped.clone_from(&own.dropped);
            (vertex.off, vertex.home) = (own.off, own.home);
        }
    }

    /// The past of the vertices that are left, for a later round, in the order of [`points`](Self::points).
    pub(crate) fn past(&self) -> Vec<Past> {
        let past = |v: u32| {
            let Vertex { dropped, off, home, .. } = &self.vertices[v as usize];
            Past { dropped: dropped.clone(), off: *off, home: *home }
        };
        self.order().into_iter().flatten().map(past).collect()
    }
}
