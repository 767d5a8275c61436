//! From lines in any order to closed rings, by the points that they share.

use std::sync::Arc as Shared;

use glam::DVec2;

use super::curve::PieceCurve;
use super::outline::{DrawnRing, Piece};
use super::text::{counted, shown};
use crate::error::OutlineError;

/// A line of a file between two of its points, given by their indices.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub(super) ends: [u32; 2],
    /// How it runs from the first to the second.
    pub(super) curve: PieceCurve,
    pub(super) side: Option<Shared<str>>,
    /// The curve of the file that it belongs to: sides begin where it changes.
    pub(super) part_of: u64,
}

/// Links joined end to end.
pub(super) struct Chains {
    pub(super) rings: Vec<DrawnRing>,
    /// The pieces of each line that closes no ring, and the points where it starts and ends.
    pub(super) open: Vec<(Vec<Piece>, [DVec2; 2])>,
}

/// Rings of links, and a note on lines that close no ring.
///
/// # Errors
///
/// Three or more lines at a point, or no ring at all.
pub(super) fn rings(
    points: &[DVec2],
    links: &[Link],
) -> Result<(Vec<DrawnRing>, Option<String>), OutlineError> {
    let Chains { rings, open } = chains(points, links)?;
    let note = open.first().map(|(pieces, [start, _])| {
        let (lines, at) = (counted(pieces.len(), "piece"), shown(*start));
        match open.len() {
            1 => format!("left out an open line of {lines} that ends at {at}"),
            others => {
                format!("left out {others} open lines; the first has {lines} and ends at {at}")
            }
        }
    });
    match (rings.is_empty(), open.first()) {
        (true, Some((_, [start, _]))) => Err(OutlineError::place(
            format!("the point {}", shown(*start)),
            "no line closes: the first one ends there; close the boundary",
        )),
        _ => Ok((rings, note)),
    }
}

/// The fault of lines that bound several regions.
pub(super) const BRANCHES: &str = "three or more lines meet there; rings must not touch or branch; export the boundary of \
                                   one region, without lines inside it";

/// Rings of links, and lines that close no ring.
///
/// A ring starts where its first line in the file does, and runs the same way. O(points + links).
///
/// # Errors
///
/// Three or more lines at a point.
pub(super) fn chains(points: &[DVec2], links: &[Link]) -> Result<Chains, OutlineError> {
    /// No link.
    const NONE: u32 = u32::MAX;
    let mut at_point = vec![[NONE; 2]; points.len()];
    for (index, link) in (0..).zip(links) {
        // A closed curve takes both entries of its only point.
        for point in link.ends {
            let slots = &mut at_point[point as usize];
            let Some(slot) = slots.iter_mut().find(|slot| **slot == NONE) else {
                return Err(OutlineError::place(
                    format!("the point {}", shown(points[point as usize])),
                    BRANCHES,
                ));
            };
            *slot = index;
        }
    }
    let mut used = vec![false; links.len()];
    let mut rings = Vec::new();
    let mut open = Vec::new();
    // From the loose ends first, so that what is left closes.
    let loose =
        at_point.iter().enumerate().filter(|(_, slots)| slots[0] != NONE && slots[1] == NONE);
    for (point, slots) in loose {
        if !used[slots[0] as usize] {
            let (pieces, end) = walk(points, links, &at_point, &mut used, point as u32, slots[0]);
            open.push((pieces, [points[point], points[end as usize]]));
        }
    }
    for index in 0..links.len() {
        if !used[index] {
            let start = links[index].ends[0];
            let (pieces, _) = walk(points, links, &at_point, &mut used, start, index as u32);
            rings.push(DrawnRing { pieces });
        }
    }
    Ok(Chains { rings, open })
}

/// The pieces from a point along a link and on, as far as they go, and the point where they end.
fn walk(
    points: &[DVec2],
    links: &[Link],
    at_point: &[[u32; 2]],
    used: &mut [bool],
    start: u32,
    first: u32,
) -> (Vec<Piece>, u32) {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut last_part = None;
    let (mut point, mut index) = (start, first);
    while let Some(link) = links.get(index as usize).filter(|_| !used[index as usize]) {
        used[index as usize] = true;
        let forward = link.ends[0] == point;
        pieces.push(Piece {
            start: points[point as usize],
            curve: if forward { link.curve } else { reversed(link.curve) },
            side: link.side.clone(),
            begins_side: last_part.is_some_and(|part| part != link.part_of),
        });
        last_part = Some(link.part_of);
        point = link.ends[usize::from(forward)];
        let [one, other] = at_point[point as usize];
        index = if one == index { other } else { one };
    }
    if let (Some(first_link), Some(piece)) = (links.get(first as usize), pieces.first_mut()) {
        piece.begins_side = last_part != Some(first_link.part_of);
    }
    (pieces, point)
}

/// The same curve from its end to its start.
pub(super) fn reversed(curve: PieceCurve) -> PieceCurve {
    match curve {
        PieceCurve::Line => PieceCurve::Line,
        PieceCurve::Cubic([a, b]) => PieceCurve::Cubic([b, a]),
        PieceCurve::Arc(arc) => {
            let mut reversed = arc;
            reversed.start = arc.start + arc.sweep;
            reversed.sweep = -arc.sweep;
            PieceCurve::Arc(reversed)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn link(a: u32, b: u32) -> Link {
        Link { ends: [a, b], curve: PieceCurve::Line, side: None, part_of: 0 }
    }

    /// Points on a line, the x coordinates of the rings, and the note.
    fn joined(links: &[[u32; 2]]) -> Result<(Vec<Vec<f64>>, Option<String>), String> {
        let points: Vec<DVec2> = (0..10).map(|x| DVec2::new(f64::from(x), 0.0)).collect();
        let links: Vec<Link> = links.iter().map(|&[a, b]| link(a, b)).collect();
        let (rings, note) = rings(&points, &links).map_err(|e| e.to_string())?;
        let xs = |ring: &DrawnRing| ring.pieces.iter().map(|piece| piece.start.x).collect();
        Ok((rings.iter().map(xs).collect(), note))
    }

    #[test]
    fn lines_in_any_order_become_rings() {
        for (links, expected) in [
            (&[[0, 1], [1, 2], [2, 0]][..], &[&[0.0, 1.0, 2.0][..]][..]),
            (&[[3, 1], [2, 3], [2, 1]], &[&[3.0, 1.0, 2.0]]),
            (
                &[[0, 1], [5, 6], [1, 2], [6, 7], [2, 0], [7, 5]],
                &[&[0.0, 1.0, 2.0], &[5.0, 6.0, 7.0]],
            ),
            (&[[4, 4]], &[&[4.0]]),
            (&[[0, 1], [1, 0]], &[&[0.0, 1.0]]),
        ] {
            let (rings, note) = joined(links).unwrap();
            assert_eq!((rings, note), (expected.iter().map(|ring| ring.to_vec()).collect(), None));
        }
    }

    #[test]
    fn open_lines_are_left_out_and_branches_refused() {
        let (rings, note) = joined(&[[7, 8], [0, 1], [8, 9], [1, 2], [2, 0]]).unwrap();
        assert_eq!(rings, [[0.0, 1.0, 2.0]]);
        assert_eq!(note.unwrap(), "left out an open line of 2 pieces that ends at (7, 0)");
        let error = joined(&[[0, 1], [1, 2]]).unwrap_err();
        assert_eq!(
            error,
            "the point (0, 0): no line closes: the first one ends there; close the boundary"
        );
        let error = joined(&[[0, 1], [1, 2], [2, 0], [2, 3]]).unwrap_err();
        assert!(error.starts_with("the point (2, 0): three or more lines meet there"), "{error}");
        assert!(joined(&[[0, 1], [1, 2], [2, 0], [2, 2]]).is_err());
    }

    #[test]
    fn sides_begin_where_the_curve_of_the_file_changes() {
        let points: Vec<DVec2> = (0..4).map(|x| DVec2::new(f64::from(x), 0.0)).collect();
        let link = |a, b, part_of| Link { part_of, ..link(a, b) };
        let links = [link(0, 1, 7), link(1, 2, 8), link(2, 3, 8), link(3, 0, 7)];
        let (rings, _) = rings(&points, &links).unwrap();
        let begins: Vec<bool> = rings[0].pieces.iter().map(|piece| piece.begins_side).collect();
        assert_eq!(begins, [false, true, false, true]);
    }
}
