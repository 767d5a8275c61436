//! Triangle's .poly: vertices, segments, and points in holes.
//!
//! A segment's marker names its side: `inlet` after a comment `# marker 3: inlet`, else `marker 3`,
//! unless all segments have the same marker. The closed loops of the segments are rings, and one inside
//! another is a hole. As for Triangle, a point of the file's list of holes must lie in it; without one
//! the loop would be a line inside the mesh, and is refused. A .poly with 0 vertices has them in the
//! .node beside it; vertices that no segment names are left out.
//!
//! Limits: attributes and regional constraints are left out.

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc as Shared;

use glam::DVec2;

use super::curve::PieceCurve;
use super::loops::{self, Link};
use super::nesting::contains;
use super::outline::{Feature, Outlines};
use super::text::{at_line, counted, lines, number_at, quoted, shown, text_of, whole_at};
use crate::error::OutlineError;

/// Reads a .poly. `beside` gives the file of its name with another extension.
///
/// # Errors
///
/// A malformed line, with its number; segments that close no ring; hole
/// points that no hole contains, and rings in others that no hole point marks; a .node that is
/// needed and not there.
pub(super) fn read(
    bytes: &[u8],
    beside: impl Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<Outlines, OutlineError> {
    let text = text_of(bytes)?;
    let mut rows = Rows::new(text);
    let (points, first) = match vertices(&mut rows)? {
        Some(vertices) => vertices,
        None => vertices_beside(beside)?,
    };
    let links = segments(&mut rows, points.len(), first, &names(text))?;
    let holes = hole_points(&mut rows)?;
    let (rings, note) = loops::rings(&points, &links)?;
    let mut outlines = Outlines::of_rings(rings, note.into_iter().collect())?;
    outlines.notes.extend(check_holes(&outlines.features, &holes)?);
    Ok(outlines)
}

/// Whether a line is that of the number of vertices: three or four whole numbers, the second of
/// which is 2.
pub(super) fn begins(line: &str) -> bool {
    let numbers = line.split('#').next().unwrap_or_default().split_whitespace();
    let numbers: Vec<Option<u32>> = numbers.map(|word| word.parse().ok()).collect();
    matches!(numbers[..], [Some(_), Some(2), Some(_), Some(0 | 1)])
}

/// The lines that hold something.
struct Rows<'a> {
    rows: Box<dyn Iterator<Item = (u64, &'a str)> + 'a>,
    last: u64,
}

impl<'a> Rows<'a> {
    fn new(text: &'a str) -> Self {
        let bare =
            |(line, text): (u64, &'a str)| (line, text.split('#').next().unwrap_or_default());
        let rows = lines(text).map(bare).filter(|(_, text)| !text.trim().is_empty());
        Self { rows: Box::new(rows), last: 0 }
    }

    fn next(
        &mut self,
        what: &str,
    ) -> Result<(u64, impl Iterator<Item = &'a str> + use<'a>), OutlineError> {
        let Some((line, text)) = self.rows.next() else {
            return Err(at_line(self.last + 1, format!("the file ends where {what} should be")));
        };
        self.last = line;
        Ok((line, text.split_whitespace()))
    }
}

/// The vertices of the .node beside.
fn vertices_beside(
    beside: impl Fn(&str) -> io::Result<Vec<u8>>,
) -> Result<(Vec<DVec2>, u64), OutlineError> {
    let bad = |problem: String| OutlineError::place("the .node beside the .poly", problem);
    let bytes = beside("node").map_err(|error| {
        bad(format!(
            "the .poly has no vertices of its own, and the .node that has them cannot be read: {error}"
        ))
    })?;
    let node = text_of(&bytes).and_then(|text| vertices(&mut Rows::new(text)));
    node.map_err(|error| bad(error.to_string()))?
        .ok_or_else(|| bad("it has no vertices".to_owned()))
}

/// The names that comments such as `# marker 3: inlet` give to markers.
fn names(text: &str) -> BTreeMap<i64, Shared<str>> {
    let comments = text.lines().filter_map(|line| line.trim().strip_prefix('#'));
    let named = |comment: &str| {
        let (marker, name) = comment.trim().strip_prefix("marker ")?.split_once(':')?;
        let name = name.trim();
        (!name.is_empty()).then_some((marker.trim().parse().ok()?, Shared::from(name)))
    };
    comments.filter_map(named).collect()
}

/// The vertices, and the first index, 0 or 1; `None` if the file has 0 vertices.
fn vertices(rows: &mut Rows<'_>) -> Result<Option<(Vec<DVec2>, u64)>, OutlineError> {
    let (line, mut words) = rows.next("the number of vertices")?;
    let count = whole_at(line, words.next(), "number of vertices")?;
    let dimension = words.next().map_or(Ok(2), |word| whole_at(line, Some(word), "dimension"))?;
    if dimension != 2 {
        return Err(at_line(line, format!("the dimension is {dimension}; expected 2")));
    }
    if count == 0 {
        return Ok(None);
    }
    let mut points = Vec::new();
    let mut first = 0;
    for index in 0..count {
        let (line, mut words) = rows.next("a vertex")?;
        let number = whole_at(line, words.next(), "number of the vertex")?;
        if index == 0 {
            first = u64::try_from(number).ok().filter(|&first| first <= 1).ok_or_else(|| {
                at_line(line, format!("the first vertex has the number {number}; expected 0 or 1"))
            })?;
        }
        if number != first as i64 + index {
            let expected = first as i64 + index;
            return Err(at_line(
                line,
                format!("the vertex has the number {number}; expected {expected}"),
            ));
        }
        let mut next = |what| number_at(line, words.next(), what);
        points.push(DVec2::new(next("x coordinate")?, next("y coordinate")?));
    }
    Ok(Some((points, first)))
}

fn segments(
    rows: &mut Rows<'_>,
    vertices: usize,
    first: u64,
    names: &BTreeMap<i64, Shared<str>>,
) -> Result<Vec<Link>, OutlineError> {
    let (line, mut words) = rows.next("the number of segments")?;
    let count = whole_at(line, words.next(), "number of segments")?;
    let mut links = Vec::new();
    let mut markers = Vec::new();
    for _ in 0..count {
        let (line, mut words) = rows.next("a segment")?;
        whole_at(line, words.next(), "number of the segment")?;
        let mut end = || {
            let number = whole_at(line, words.next(), "vertex")?;
            let index =
                number.checked_sub(first as i64).and_then(|index| u32::try_from(index).ok());
            index.filter(|&index| (index as usize) < vertices).ok_or_else(|| {
                at_line(
                    line,
                    format!("the segment goes to vertex {number}, which is not in the file"),
                )
            })
        };
        let ends = [end()?, end()?];
        let marker = words.next().unwrap_or("0");
        let marker: i64 = marker
            .parse()
            .map_err(|_| at_line(line, format!("found {}, expected a marker", quoted(marker))))?;
        markers.push(marker);
        let unnamed = || (marker != 0).then(|| Shared::from(format!("marker {marker}")));
        let side = names.get(&marker).cloned().or_else(unnamed);
        links.push(Link { ends, curve: PieceCurve::Line, side, part_of: 0 });
    }
    let is_unnamed = |marker: &i64| *marker == markers[0] && !names.contains_key(marker);
    if markers.iter().all(is_unnamed) {
        links.iter_mut().for_each(|link| link.side = None);
    }
    Ok(links)
}

/// The points in holes; a file may end before it gives their number.
fn hole_points(rows: &mut Rows<'_>) -> Result<Vec<DVec2>, OutlineError> {
    let Ok((line, mut words)) = rows.next("the number of holes") else { return Ok(Vec::new()) };
    let count = whole_at(line, words.next(), "number of holes")?;
    let mut holes = Vec::new();
    for _ in 0..count {
        let (line, mut words) = rows.next("a hole")?;
        whole_at(line, words.next(), "number of the hole")?;
        let mut next = |what| number_at(line, words.next(), what);
        holes.push(DVec2::new(next("x coordinate")?, next("y coordinate")?));
    }
    Ok(holes)
}

/// Checks that each hole has a point of the file, and notes points that lie in no hole.
fn check_holes(features: &[Feature], holes: &[DVec2]) -> Result<Option<String>, OutlineError> {
    let mut used = vec![false; holes.len()];
    for ring in features.iter().flat_map(|feature| feature.rings.iter().skip(1)) {
        let points = ring.flattened();
        let mut is_marked = false;
        for (hole, used) in holes.iter().zip(&mut used) {
            if contains(&points, &[*hole]) {
                (is_marked, *used) = (true, true);
            }
        }
        if !is_marked {
            let at = shown(points.first().copied().unwrap_or_default());
            return Err(OutlineError::place(
                "the list of holes",
                format!(
                    "the closed line through {at} lies inside another one, and no hole point lies \
                     in it; give one, or drop its segments"
                ),
            ));
        }
    }
    let count = used.iter().filter(|used| !**used).count();
    Ok((count > 0).then(|| format!("left out {} in no hole", counted(count, "hole point"))))
}

#[cfg(test)]
mod tests {
    use super::super::outline::DrawnRing;
    use super::*;

    /// A square of size 4 with a triangular hole, numbered from 1.
    const FILE: &str = "\
# a plate\n7 2 0 1\n1 0 0 1\n2 4 0 1\n3 4 4 1\n4 0 4 1\n5 1.1 1 2 \n6 2 1 2\n7 1 2 2\n
7 1\n1 1 2 1\n2 2 3 9\n3 3 4 1\n4 4 1 1\n5 5 6 2 # hole\n6 6 7 2\n7 7 5 2\n1\n1 1.25 1.25\n0\n";

    fn read(text: &str) -> Result<Outlines, String> {
        let beside = |_: &str| Err(io::Error::other("not there"));
        super::read(text.as_bytes(), beside).map_err(|error| error.to_string())
    }

    #[test]
    fn vertices_may_be_in_the_file_beside() {
        let poly = "# marker 2: in let\n0 2 0 1\n3 1\n1 1 2 2\n2 2 3 2\n3 3 1 1\n0\n";
        let read = |node: &str| {
            let beside = |extension: &str| {
                assert_eq!(extension, "node");
                Ok(node.as_bytes().to_vec())
            };
            super::read(poly.as_bytes(), beside).map_err(|error| error.to_string())
        };
        // The fourth vertex is inside: no segment names it.
        let outlines = read("# x\n4 2 0 1\n1 0 0 1\n2 4 0 1\n3 0 4 1\n4 1 1 0\n").unwrap();
        let pieces = &outlines.features[0].rings[0].pieces;
        let sides: Vec<&str> = pieces.iter().map(|it| it.side.as_deref().unwrap()).collect();
        assert_eq!(sides, ["in let", "in let", "marker 1"]);
        let starts: Vec<[f64; 2]> = pieces.iter().map(|it| it.start.to_array()).collect();
        assert_eq!(starts, [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]);
        for (node, message) in [
            ("0 2 0 0\n", "the .node beside the .poly: it has no vertices"),
            ("1 2 0 0\n1 x 0\n", "the .node beside the .poly: line 2: found \"x\""),
            ("1 2 0 0\n1 0 0\n", "line 4: the segment goes to vertex 2"),
        ] {
            let error = read(node).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }

    #[test]
    fn reads_vertices_segments_markers_and_holes() {
        let outlines = read(FILE).unwrap();
        assert!(outlines.notes.is_empty());
        let [feature] = &outlines.features[..] else { panic!("one polygon: {outlines:?}") };
        assert_eq!(feature.rings[1].pieces[0].start, DVec2::new(1.1, 1.0));
        let sides = feature.rings.iter().flat_map(|ring| &ring.pieces);
        let sides: Vec<&str> = sides.map(|piece| piece.side.as_deref().unwrap()).collect();
        let markers = [1, 9, 1, 1, 2, 2, 2].map(|marker| format!("marker {marker}"));
        assert_eq!(sides, markers);
        // From 0, without markers and the end.
        let text = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n";
        let ring = DrawnRing::of_points([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from));
        assert_eq!(read(text).unwrap().features[0].rings, std::slice::from_ref(&ring));
        // One marker on all edges does not separate sides.
        let text = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 1\n1 1 2 7\n2 2 3 7\n3 3 1 7\n0\n";
        assert_eq!(read(text).unwrap().features[0].rings, [ring]);
    }

    #[test]
    fn errors_say_where_and_what() {
        for (from, to, message) in [
            ("7 2 0 1", "7 3 0 1", "line 2: the dimension is 3; expected 2"),
            (
                "7 2 0 1",
                "0 2 0 1",
                "the .node beside the .poly: the .poly has no vertices of its own, and the .node that \
                 has them cannot be read: not there",
            ),
            (
                "1 0 0 1\n",
                "2 0 0 1\n",
                "line 3: the first vertex has the number 2; expected 0 or 1",
            ),
            ("3 4 4 1\n", "5 4 4 1\n", "line 5: the vertex has the number 5; expected 3"),
            ("3 4 4 1\n", "3 4\n", "line 5: the y coordinate is missing"),
            (
                "2 2 3 9",
                "2 2 8 9",
                "line 13: the segment goes to vertex 8, which is not in the file",
            ),
            (
                "2 2 3 9",
                "2 2 0 9",
                "line 13: the segment goes to vertex 0, which is not in the file",
            ),
            ("2 2 3 9", "2 2 3 x", "line 13: found \"x\", expected a marker"),
            ("1 1.25 1.25", "", "line 21: the x coordinate is missing"),
            (
                "1.25 1.25",
                "3 3",
                "the list of holes: the closed line through (1.1, 1.0) lies inside",
            ),
            ("4 4 1 1", "4 4 2 1", "the point (4.0, 0.0): three or more lines meet"),
        ] {
            let error = read(&FILE.replacen(from, to, 1)).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
        let huge = read("9223372036854775807 2 0 0\n1 0 0\n").unwrap_err();
        assert_eq!(huge, "line 3: the file ends where a vertex should be");
        let least = read("1 2 0 0\n1 0 0\n1 1\n1 -9223372036854775808 1\n").unwrap_err();
        assert!(least.starts_with("line 4: the segment goes to vertex -9223372036854775808"));
        let unused = read(&FILE.replacen("1\n1 1.25 1.25", "2\n1 1.25 1.25\n2 9 9", 1)).unwrap();
        assert_eq!(unused.notes, ["left out 1 hole point in no hole"]);
    }
}
