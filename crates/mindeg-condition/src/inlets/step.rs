//! A single change of a shore.

use glam::DVec2;

/// A change of an inlet or a strait.
#[derive(Clone, Copy)]
pub(super) enum Step {
    Shift { vertex: u32, to: DVec2 },
    Drop { vertex: u32 },
    Insert { edge: u32, at: DVec2 },
}

/// Whether a change takes an end of a shore, or is beyond it.
pub(super) fn is_at_end(step: Step, shores: &[Vec<u32>]) -> bool {
    let ends = |shore: &Vec<u32>| [shore.first().copied(), shore.last().copied()];
    shores.iter().map(ends).any(|[first, last]| match step {
        Step::Drop { vertex } => [first, last].contains(&Some(vertex)),
        Step::Insert { edge, .. } => last == Some(edge),
        Step::Shift { .. } => false,
    })
}
