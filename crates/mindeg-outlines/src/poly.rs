//! Triangle's .poly: vertices, segments, and points in holes.
//!
//! A segment's marker names its side: `inlet` after a comment `# marker 3: inlet`, else `marker 3`,
//! unless all segments have the same marker. As for Triangle, the faces between segments are regions, but those with a
//! point of the file's list of holes. A region's attribute names it, `region 7`, and its maximum area stays. Segments
//! with one face on both sides are lines inside, and vertices that no segment names points. A .poly with 0 vertices
//! has them in the .node beside it; of these, vertices that no segment names are left out.
//!
//! Limits: attributes of vertices are left out.

use std::io;

use glam::{DVec2, DVec3};
use mindeg_domain::InnerPoint;
use mindeg_formats::triangle::{self, PolyFaces};

use super::faces::{Faces, faces};
use super::mesh_lines::{links, outlines};
use super::nesting::{Loop, contains, is_in, loops};
use super::outline::{DrawnRing, Feature, Outlines};
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
    let (lines, PolyFaces { holes, regions }) = triangle::read_lines(bytes, || beside("node"))?;
    let points: Vec<DVec2> = lines.positions.iter().map(|point| point.truncate()).collect();
    let between = faces(&points, &links(&lines, false))?;
    let is_no_hole = |face: &&Vec<DrawnRing>| {
        let rings = loops(face);
        !holes.iter().any(|hole| is_in(&rings, hole.truncate()))
    };
    let is_plain = |found: &Faces| {
        regions.is_empty()
            && found.lines.is_empty()
            && lines.points.is_empty()
            && found.faces.iter().filter(is_no_hole).count() == 1
    };
    let between = match between {
        Ok(found) if !is_plain(&found) => found,
        // Rings that cross may be repaired.
        plain => {
            let crossing = plain.err();
            let told = |error: OutlineError| match crossing {
                Some(at) => {
                    let problem =
                        "segments meet there, and one of them has no vertex there; give both one";
                    OutlineError { is_touch: true, ..OutlineError::place(shown(at), problem) }
                }
                None => error,
            };
            let mut outlines = outlines(lines, false).map_err(told)?;
            outlines.notes.extend(check_holes(&outlines.features, &holes)?);
            return Ok(outlines);
        }
    };
    let mut outlines = Outlines::default();
    let mut used = vec![false; holes.len()];
    let mut region_of: Vec<Option<usize>> = vec![None; between.faces.len()];
    let rings_of: Vec<Vec<Loop>> = between.faces.iter().map(|face| loops(face)).collect();
    for (index, region) in regions.iter().enumerate() {
        let at = region.at.truncate();
        let place = || OutlineError::place(format!("region {} at {}", index + 1, shown(at)), "");
        let found = rings_of.iter().position(|rings| is_in(rings, at));
        let Some(face) = found else {
            let problem = "it lies outside all closed lines; move it inside, or drop it".to_owned();
            return Err(OutlineError { problem, ..place() });
        };
        if let Some(other) = region_of[face] {
            let problem = format!(
                "it lies in the same face as region {}; drop one of them, or draw a line between them",
                other + 1
            );
            return Err(OutlineError { problem, ..place() });
        }
        region_of[face] = Some(index);
    }
    for ((face, rings), region) in between.faces.into_iter().zip(&rings_of).zip(region_of) {
        let in_face = holes.iter().enumerate().filter(|(_, hole)| is_in(rings, hole.truncate()));
        let in_face: Vec<usize> = in_face.map(|(index, _)| index).collect();
        in_face.iter().for_each(|&index| used[index] = true);
        match (in_face.first(), region.map(|region| &regions[region])) {
            (Some(_), Some(region)) => {
                let place = format!("{} at {}", region.name, shown(region.at.truncate()));
                return Err(OutlineError::place(
                    place,
                    "it lies in a hole; drop one of the two points",
                ));
            }
            (Some(_), None) => {}
            (None, region) => outlines.features.push(Feature {
                name: region.map(|region| region.name.clone()),
                rings: face,
                max_area: region.and_then(|region| region.max_area),
            }),
        }
    }
    if outlines.features.is_empty() {
        return Err(OutlineError::place(
            "",
            "all closed lines are holes; drop a hole point, or close the outline",
        ));
    }
    outlines.end_shape();
    outlines.inside.lines = between.lines;
    let at = lines.points.iter().map(|point| points[point.vertex as usize]);
    outlines.inside.points = at.map(|at| InnerPoint { at, name: None, size: None }).collect();
    outlines.notes.extend(unused(&used));
    Ok(outlines)
}

/// A note on hole points in no hole.
fn unused(used: &[bool]) -> Option<String> {
    let count = used.iter().filter(|used| !**used).count();
    (count > 0).then(|| format!("left out {} in no hole", counted(count, "hole point")))
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
    Ok(unused(&used))
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
            ("2 4 0 1\n", "1 4 0 1\n", "two vertices, 0 and 1 (counted from 0), have the number 1"),
            ("3 4 4 1\n", "3 4\n", "line 5: y is missing"),
            ("2 2 3 9", "2 2 8 9", "line 13: vertex 8 does not exist; the file has 1 to 7"),
            ("2 2 3 9", "2 2 0 9", "line 13: vertex 0 does not exist; the file has 1 to 7"),
            ("2 2 3 9", "2 2 3 x", "line 13: the marker is \"x\", which is not a whole number"),
            ("1 1.25 1.25", "", "line 21: x is missing"),
        ] {
            let error = read(&FILE.replacen(from, to, 1)).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
        let alone = read("0 2 0 1\n1 1\n1 1 2 1\n0\n").unwrap_err();
        let message = "the .node beside the .poly: the .poly has no vertices of its own, and the .node that has them \
                       cannot be read: not there";
        assert_eq!(alone, message);
        let huge = read("9223372036854775807 2 0 0\n1 0 0\n").unwrap_err();
        assert_eq!(huge, "line 3: the file ends before its last vertex");
        let least = read("1 2 0 0\n1 0 0\n1 1\n1 -9223372036854775808 1\n").unwrap_err();
        assert!(least.starts_with("line 4: the number of a vertex is \"-9223372036854775808\""));
        let unused = read(&FILE.replacen("1\n1 1.25 1.25", "2\n1 1.25 1.25\n2 9 9", 1)).unwrap();
        assert_eq!(unused.notes, ["left out 1 hole point in no hole"]);
    }

    /// Two rooms with a pillar in the left one, a step in the right one and a lamp.
    const ROOMS: &str = "\
12 2 0 1\n1 0 0 0\n2 2 0 0\n3 4 0 0\n4 4 2 0\n5 2 2 0\n6 0 2 0\n7 0.5 0.5 0\n8 1 0.5 0\n9 1 1 0\n10 3 1 0\n11 3.5 1 0\n12 1.5 1.5 0\n
11 1\n1 1 2 4\n2 2 3 4\n3 3 4 4\n4 4 5 4\n5 5 6 4\n6 6 1 4\n7 2 5 7\n8 7 8 9\n9 8 9 9\n10 9 7 9\n11 10 11 3\n
1\n1 0.9 0.6\n2\n1 0.1 0.1 70 0.02\n2 3.9 1.9 2.5\n";

    fn map(text: &str) -> Result<mindeg_domain::Domain, String> {
        let outlines = read(text)?;
        let polygons = crate::labelled(outlines.features);
        let found = crate::maps(&polygons, &outlines.inside, &crate::Division::default(), false);
        let (maps, _) = found.map_err(|error| error.to_string())?;
        let [map] = &maps[..] else { panic!("one map") };
        Ok(map.clone())
    }

    #[test]
    fn faces_are_regions_with_attributes_and_areas() {
        let domain = map(ROOMS).unwrap();
        assert_eq!(domain.rings().ring_count(), 2);
        let regions = &domain.inside().regions;
        let regions: Vec<_> =
            regions.iter().map(|region| (region.name.as_deref(), region.max_area)).collect();
        assert_eq!(regions, [(Some("region 70"), Some(0.02)), (Some("region 2.5"), None)]);
        let lines: Vec<_> = domain.inner_lines().into_iter().map(|(line, _)| line.name).collect();
        assert_eq!(lines, ["marker 7", "marker 3"]);
        assert_eq!(domain.side_name(0), "marker 4");
        assert_eq!(domain.inside().points[0].at, DVec2::new(1.5, 1.5));
        // Without a point, the pillar is a region, too.
        let filled = map(&ROOMS.replace("1\n1 0.9 0.6\n2\n", "0\n2\n")).unwrap();
        assert_eq!((filled.rings().ring_count(), filled.faces().unwrap().count), (1, 3));
    }

    #[test]
    fn a_point_in_the_middle_of_a_region_leaves_the_region_a_place() {
        let text = "7 2 0 0\n1 0 0\n2 2 0\n3 4 0\n4 4 2\n5 2 2\n6 0 2\n7 1 1\n7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n\
                    5 5 6\n6 6 1\n7 2 5\n0\n";
        let domain = map(text).unwrap();
        assert_eq!((domain.faces().unwrap().count, domain.inside().points.len()), (2, 1));
    }

    #[test]
    fn faults_of_regions_are_told_with_their_place() {
        for (from, to, message) in [
            (
                "2 3.9 1.9 2.5",
                "2 0.2 0.1 2.5",
                "region 2 at (0.2, 0.1): it lies in the same face as region 1; drop",
            ),
            (
                "2 3.9 1.9 2.5",
                "2 9 9 2.5",
                "region 2 at (9, 9): it lies outside all closed lines; move",
            ),
            ("2 3.9 1.9 2.5", "2 0.9 0.7 2.5", "region 2.5 at (0.9, 0.7): it lies in a hole; drop"),
            ("2 3.9 1.9 2.5", "2 3.9 1.9", "line 32: the attribute of a region is missing"),
            ("2 3.9 1.9 2.5", "", "line 32: the file ends before its last region"),
            ("12 1.5 1.5", "12 9 9", "(9, 9): this point lies outside all regions"),
            (
                "11 3.5 1 0",
                "11 9 1 0",
                "(4, 1): segments meet there, and one of them has no vertex there; give",
            ),
        ] {
            let error = map(&ROOMS.replacen(from, to, 1)).unwrap_err();
            assert!(error.contains(message), "{error}");
        }
    }
}
