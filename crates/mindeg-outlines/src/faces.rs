//! The faces between lines that meet at their ends alone.

use std::collections::BTreeSet;

use glam::DVec2;

use super::curve::{PieceCurve, Segment};
use super::loops::Link;
use super::nesting::{Loop, smallest_around};
use super::outline::{Border, DrawnRing, Piece};
use super::overlay::crossings::{MOST_COMPARISONS, meetings};
use super::overlay::edge::{Edge, Step, points_of};
use super::overlay::faces::{Graph, links};
use super::overlay::turns_left;
use crate::error::OutlineError;

/// The bounded faces between lines, and the lines that end in them.
pub(super) struct Faces {
    /// The rings of each: the outer one first, then those of what lies inside.
    pub(super) faces: Vec<Vec<DrawnRing>>,
    pub(super) lines: Vec<Border>,
}

/// The faces between straight lines, or a place where they meet that is no end of both.
///
/// # Errors
///
/// Lines that take too long to compare.
pub(super) fn faces(
    points: &[DVec2],
    lines: &[Link],
) -> Result<Result<Faces, DVec2>, OutlineError> {
    let is_edge = |link: &&Link| points[link.ends[0] as usize] != points[link.ends[1] as usize];
    let given: Vec<&Link> = lines.iter().filter(is_edge).collect();
    let edges: Vec<Edge> =
        (0..).zip(&given).map(|(chord, link)| Edge { ends: link.ends, chord }).collect();
    let mut budget = MOST_COMPARISONS;
    let meetings = meetings(&edges, points, &mut budget);
    let meetings = meetings.map_err(|problem| OutlineError::place("", problem))?;
    if let Some(at) = meetings.values().flatten().next() {
        return Ok(Err(*at));
    }
    let (links, _) = links(&edges, |_| 0);
    let graph = Graph::new(&links, points);
    let rings: Vec<Vec<Step>> = graph.rings(|_| Some(())).into_iter().map(|it| it.1).collect();
    let drawn = |steps: &[Step]| DrawnRing {
        pieces: steps
            .iter()
            .map(|step| Piece {
                side: given[step.chord as usize].side.clone(),
                ..Piece::line(points[step.from as usize])
            })
            .collect(),
    };
    // A line with one face on both sides gives rings of two steps, there and back.
    let is_ring = |steps: &&Vec<Step>| steps.len() > 2;
    let in_rings = rings.iter().filter(is_ring).flatten();
    let in_rings: BTreeSet<u32> = in_rings.map(|step| step.chord).collect();
    let (mut outer, mut faces, mut inner) = (Vec::new(), Vec::new(), Vec::new());
    for steps in rings.iter().filter(is_ring) {
        let points = points_of(steps, points);
        let ring = drawn(steps);
        if turns_left(&points) {
            outer.push(Loop::new(points));
            faces.push(vec![ring]);
        } else {
            inner.push((points, ring));
        }
    }
    for (points, ring) in inner {
        if let Some(face) = smallest_around(outer.iter().enumerate(), &points) {
            faces[face].push(ring);
        }
    }
    let lines = (0..).zip(&given).filter(|(chord, _)| !in_rings.contains(chord));
    let lines = lines.map(|(_, link)| {
        let [start, end] = link.ends.map(|end| points[end as usize]);
        let segment = Segment { start, end, curve: PieceCurve::Line };
        Border { segment, side: link.side.clone(), begins_side: false, beside: [None; 2] }
    });
    Ok(Ok(Faces { lines: lines.collect(), faces }))
}
