//! Edges: the input and the output of a planar subdivision.

use glam::DVec2;

use super::super::outline::{DrawnRing, FillRule};

/// Rings that one fill rule counts.
pub(in super::super) struct Layer<'a> {
    pub(in super::super) rings: Vec<&'a DrawnRing>,
    pub(in super::super) rule: FillRule,
}

/// A straight edge: a chord, or a piece of one.
#[derive(Clone, Copy)]
pub(in super::super) struct Edge {
    pub(in super::super) ends: [u32; 2],
    pub(in super::super) chord: u32,
}

/// An edge of a boundary, on the way round it.
#[derive(Clone, Copy)]
pub(in super::super) struct Step {
    pub(in super::super) from: u32,
    pub(in super::super) chord: u32,
    /// Whether it runs as its chord does.
    pub(in super::super) forward: bool,
}

/// The points where steps start.
pub(in super::super) fn points_of(steps: &[Step], points: &[DVec2]) -> Vec<DVec2> {
    steps.iter().map(|step| points[step.from as usize]).collect()
}
