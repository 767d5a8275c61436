//! Triangle's .poly: vertices, segments, and points in holes.
//!
//! A segment's marker names its side: `inlet` after a comment `# marker 3: inlet`, else `marker 3`,
//! unless all segments have the same marker. The closed loops of the segments are rings, and one inside
//! another is a hole. As for Triangle, a point of the file's list of holes must lie in it; without one
//! the loop would be a line inside the mesh, and is refused. A .poly with 0 vertices has them in the
//! .node beside it; vertices that no segment names are left out.
//!
//! Limits: attributes and regional constraints are left out.

use std::io;

use glam::DVec3;
use mindeg_formats::triangle;

use super::mesh_lines::outlines;
use super::nesting::contains;
use super::outline::{Feature, Outlines};
use super::text::{counted, shown};
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
    let (lines, holes) = triangle::read_lines(bytes, || beside("node"))?;
    let mut outlines = outlines(lines, false)?;
    outlines.notes.extend(check_holes(&outlines.features, &holes)?);
    Ok(outlines)
}

/// Checks that each hole has a point of the file, and notes points that lie in no hole.
fn check_holes(features: &[Feature], holes: &[DVec3]) -> Result<Option<String>, OutlineError> {
    let mut used = vec![false; holes.len()];
    for ring in features.iter().flat_map(|feature| feature.rings.iter().skip(1)) {
        let points = ring.flattened();
        let mut is_marked = false;
        for (hole, used) in holes.iter().zip(&mut used) {
            if contains(&points, &[hole.truncate()]) {
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
    use glam::DVec2;

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
            ("0 2 0 0\n", "line 4: vertex 1 does not exist"),
            ("1 2 0 0\n1 x 0\n", "the .node beside the .poly, line 2: x is \"x\", which is not"),
            ("1 2 0 0\n1 0 0\n", "line 4: vertex 2 does not exist; the file has 1 to 1"),
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
            ("7 2 0 1", "7 3 0 1", "line 2: the file has 3 dimensions"),
            (
                "7 2 0 1",
                "0 2 0 1",
                "the .node beside the .poly: the .poly has no vertices of its own, and the .node that \
                 has them cannot be read: not there",
            ),
            ("2 4 0 1\n", "1 4 0 1\n", "two vertices, 0 and 1 (counted from 0), have the number 1"),
            ("3 4 4 1\n", "3 4\n", "line 5: y is missing"),
            ("2 2 3 9", "2 2 8 9", "line 13: vertex 8 does not exist; the file has 1 to 7"),
            ("2 2 3 9", "2 2 0 9", "line 13: vertex 0 does not exist; the file has 1 to 7"),
            ("2 2 3 9", "2 2 3 x", "line 13: the marker is \"x\", which is not a whole number"),
            ("1 1.25 1.25", "", "line 21: x is missing"),
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
        assert_eq!(huge, "line 3: the file ends before its last vertex");
        let least = read("1 2 0 0\n1 0 0\n1 1\n1 -9223372036854775808 1\n").unwrap_err();
        assert!(least.starts_with("line 4: the number of a vertex is \"-9223372036854775808\""));
        let unused = read(&FILE.replacen("1\n1 1.25 1.25", "2\n1 1.25 1.25\n2 9 9", 1)).unwrap();
        assert_eq!(unused.notes, ["left out 1 hole point in no hole"]);
    }
}
