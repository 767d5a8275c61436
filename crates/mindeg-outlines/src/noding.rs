//! Lines and points inside polygons that meet each other or a ring get a vertex there, and so does the ring.

use std::collections::{BTreeSet, HashSet};

use glam::DVec2;
use mindeg_mesh::sorted;

use super::curve::{PieceCurve, Segment};
use super::nesting::{Loop, is_in, loops};
use super::outline::{Border, DrawnInside, Feature, Outlines, Piece, key};
use super::overlay::ROUNDING;
use super::overlay::crossings::{Meetings, parted, with_vertices};
use super::overlay::edge::Edge;
use super::overlay::near::near_vertices;
use super::text::counted;
use super::vertices::Vertices;
use crate::error::OutlineError;

/// How often edges are led through near vertices, which may bring them near to others.
const ROUNDS: usize = 10;

/// The chords of pieces of rings, then of lines, as edges between vertices.
struct Chords {
    vertices: Vertices,
    edges: Vec<Edge>,
    /// The piece of each chord, by its index among all.
    piece_of: Vec<usize>,
    pieces: usize,
}

impl Chords {
    /// The vertices of straight lines may be `near` others; curves keep theirs.
    fn push(&mut self, segment: Segment, near: bool) {
        let count = segment.intervals_by_turning();
        let at = |i: u32| segment.point(f64::from(i) / f64::from(count));
        let near = near && segment.curve == PieceCurve::Line;
        let mut index =
            |at| if near { self.vertices.index_near(at) } else { self.vertices.index(at) };
        let own: Vec<u32> = (0..=count).map(|i| index(at(i))).collect();
        for pair in own.windows(2) {
            self.edges.push(Edge { ends: [pair[0], pair[1]], chord: self.piece_of.len() as u32 });
            self.piece_of.push(self.pieces);
        }
        self.pieces += 1;
    }
}

impl DrawnInside {
    /// Keeps what lies within some polygons; edges and points along their rings do not, but points at vertices do. Time: edges and
    /// points times vertices of the polygons around them.
    pub fn keep_within<'a>(&mut self, polygons: impl IntoIterator<Item = &'a Feature> + Clone) {
        let rings = || polygons.clone().into_iter().map(|polygon| &polygon.rings);
        let loops: Vec<Vec<Loop>> = rings().map(|rings| loops(rings)).collect();
        let starts = rings().flatten().flat_map(|ring| &ring.pieces).map(|piece| key(piece.start));
        let vertices: HashSet<_> = starts.collect();
        let is_in = |at: DVec2| loops.iter().any(|rings| is_in(rings, at));
        self.lines.retain(|line| is_in(line.segment.point(0.5)));
        self.points.retain(|point| vertices.contains(&key(point.at)) || is_in(point.at));
    }
}

/// Edges that meet at ends only, and how many vertices were added: none passes a vertex nearer than the tolerance, of those that
/// count for it.
pub(super) fn noded(
    mut edges: Vec<Edge>,
    vertices: &mut Vertices,
    tolerance: f64,
    counts: impl Fn(&Edge, u32) -> bool,
) -> Result<(Vec<Edge>, usize), String> {
    let mut added = 0;
    for _ in 0..ROUNDS {
        let mut near = near_vertices(&edges, &vertices.points, tolerance);
        near.iter_mut().for_each(|(edge, near)| near.retain(|&it| counts(&edges[*edge], it)));
        near.retain(|_, near| !near.is_empty());
        let is_far = near.is_empty();
        let at = |vertex: u32| vertices.points[vertex as usize];
        let near = near.into_iter().map(|(edge, near)| (edge, near.into_iter().map(at).collect()));
        let near: Meetings = near.collect();
        edges = with_vertices(edges, near, vertices, &mut added);
        let (next, crossings) = parted(edges, vertices)?;
        edges = next;
        added += crossings;
        if is_far && crossings == 0 {
            break;
        }
    }
    Ok((edges, added))
}

impl Outlines {
    /// Gives lines and points inside, and rings that they meet, a vertex there, and drops what lies outside all polygons. Lines nearer
    /// than the tolerance meet, and points as near as rounding brings them.
    ///
    /// # Errors
    ///
    /// The errors of [`Self::node_inside`].
    pub(super) fn clip_inside(&mut self, tolerance: f64) -> Result<(), OutlineError> {
        if self.inside.is_empty() {
            return Ok(());
        }
        let again = self.node_inside(tolerance)?;
        let before = [self.inside.lines.len() + again, self.inside.points.len()];
        self.inside.keep_within(&self.features);
        let DrawnInside { lines, points } = &self.inside;
        let dropped = [before[0] - lines.len(), before[1] - points.len()];
        let [edges, points] = [counted(dropped[0], "edge"), counted(dropped[1], "point")];
        let dropped = match dropped {
            [0, 0] => return Ok(()),
            [0, _] => points,
            [_, 0] => format!("{edges} of lines"),
            _ => format!("{edges} of lines and {points}"),
        };
        self.notes.push(format!(
            "dropped {dropped} outside the polygons, along their rings or there twice"
        ));
        Ok(())
    }

    /// Gives lines and points inside, and rings that they meet, a vertex there. Edges that are there twice, or along a ring, stay once: the
    /// number of those that go.
    ///
    /// # Errors
    ///
    /// Edges too many or too near each other to be told apart in some seconds.
    fn node_inside(&mut self, tolerance: f64) -> Result<usize, OutlineError> {
        let rings = || self.features.iter().flat_map(|feature| &feature.rings);
        let of_rings = || rings().flat_map(|ring| ring.segments());
        let of_lines = || self.inside.lines.iter().map(|line| line.segment);
        let ends = of_rings().chain(of_lines()).map(|segment| segment.start.abs().max_element());
        let rounding = ROUNDING * ends.fold(0.0, f64::max);
        let tolerance = tolerance.max(rounding);
        let wrong = |problem| OutlineError::place("", problem);
        let mut chords = Chords {
            vertices: Vertices::new(DVec2::ZERO, tolerance),
            edges: Vec::new(),
            piece_of: Vec::new(),
            pieces: 0,
        };
        of_rings().for_each(|segment| chords.push(segment, false));
        let (ring_vertices, ring_chords) = (chords.vertices.points.len(), chords.piece_of.len());
        of_lines().for_each(|segment| chords.push(segment, true));
        let Chords { mut vertices, edges, piece_of, pieces } = chords;
        // Rings stay as they are to each other.
        let counts = |edge: &Edge, vertex: u32| {
            edge.chord as usize >= ring_chords || vertex as usize >= ring_vertices
        };
        let edges: Vec<Edge> =
            edges.into_iter().filter(|edge| edge.ends[0] != edge.ends[1]).collect();
        let (mut edges, mut added) =
            noded(edges, &mut vertices, tolerance, counts).map_err(wrong)?;
        // Points stay where they are, and bend no edge: those alone count that lie on one.
        if !self.inside.points.is_empty() {
            let mut with_points = Vertices::new(DVec2::ZERO, rounding);
            for &vertex in &vertices.points {
                with_points.index(vertex);
            }
            let before = with_points.points.len() as u32;
            for point in &mut self.inside.points {
                let vertex = with_points.index_near(point.at);
                point.at = with_points.points[vertex as usize];
            }
            let is_point = |_: &Edge, vertex: u32| vertex >= before;
            let (next, more) = noded(edges, &mut with_points, rounding, is_point).map_err(wrong)?;
            (edges, added, vertices) = (next, added + more, with_points);
        }
        let mut parts: Vec<Vec<[u32; 2]>> = vec![Vec::new(); pieces];
        edges.iter().for_each(|edge| parts[piece_of[edge.chord as usize]].push(edge.ends));
        let mut whole = vec![0; pieces];
        piece_of.iter().for_each(|&piece| whole[piece] += 1);
        let at = |vertex: u32| vertices.points[vertex as usize];
        let mut known = BTreeSet::new();
        let mut next = parts.iter().zip(whole);
        for ring in self.features.iter_mut().flat_map(|feature| &mut feature.rings) {
            let mut pieces = Vec::with_capacity(ring.pieces.len());
            for (piece, (own, whole)) in ring.pieces.drain(..).zip(next.by_ref()) {
                known.extend(own.iter().map(|&ends| sorted(ends)));
                if own.len() == whole {
                    pieces.push(piece);
                    continue;
                }
                pieces.extend(own.iter().enumerate().map(|(index, ends)| Piece {
                    start: if index == 0 { piece.start } else { at(ends[0]) },
                    curve: PieceCurve::Line,
                    begins_side: piece.begins_side && index == 0,
                    ..piece.clone()
                }));
            }
            ring.pieces = pieces;
        }
        let mut lines = Vec::with_capacity(self.inside.lines.len());
        let mut again = 0;
        for (line, (own, whole)) in self.inside.lines.drain(..).zip(next) {
            if own.len() == whole && line.segment.curve != PieceCurve::Line {
                let before = known.len();
                known.extend(own.iter().map(|&ends| sorted(ends)));
                again += usize::from(known.len() == before);
                lines.extend((known.len() > before).then_some(line));
                continue;
            }
            for (index, &ends) in own.iter().enumerate() {
                if !known.insert(sorted(ends)) {
                    again += 1;
                    continue;
                }
                let [start, end] = ends.map(at);
                lines.push(Border {
                    segment: Segment { start, end, curve: PieceCurve::Line },
                    begins_side: line.begins_side && index == 0,
                    ..line.clone()
                });
            }
        }
        self.inside.lines = lines;
        if added > 0 {
            self.notes.push(format!(
                "added {} where lines or points inside meet others or a ring",
                counted(added, "point")
            ));
        }
        Ok(again)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OutlineFormat, ProjectionChoice, read};

    /// Two squares side by side, a line through both and beyond, and points within, at a vertex, on an edge and outside.
    fn given() -> Outlines {
        let wkt = "POLYGON((0 0,4 0,4 4,0 4)) POLYGON((4 0,8 0,8 4,4 4)) LINESTRING(1 1,9 1) \
                   MULTIPOINT(2 2, 4 4, 4 2, 9 9)";
        read(wkt.as_bytes(), OutlineFormat::Wkt, |_| Err(std::io::ErrorKind::NotFound.into()))
            .unwrap()
    }

    fn places(inside: &DrawnInside) -> (Vec<[[f64; 2]; 2]>, Vec<[f64; 2]>) {
        let ends = |line: &Border| [line.segment.start, line.segment.end].map(|at| at.to_array());
        let lines = inside.lines.iter().map(ends).collect();
        (lines, inside.points.iter().map(|point| point.at.to_array()).collect())
    }

    #[test]
    fn a_repair_keeps_what_lies_within_the_polygons() {
        for repaired in
            [given().repaired(None).unwrap(), given().repaired_together(None, None).unwrap()]
        {
            let (lines, points) = places(&repaired.inside);
            assert_eq!(lines, [[[1.0, 1.0], [4.0, 1.0]], [[4.0, 1.0], [8.0, 1.0]]]);
            assert_eq!(points, [[2.0, 2.0], [4.0, 4.0], [4.0, 2.0]]);
            let note = "dropped 1 edge of lines and 1 point outside the polygons, along their rings or there twice";
            assert!(repaired.notes.iter().any(|said| said == note), "{:?}", repaired.notes);
            // Both squares have the points where the line crosses their border, and where a point lies on it.
            let has = |feature: &Feature, at: [f64; 2]| {
                feature.rings[0].pieces.iter().any(|piece| piece.start == DVec2::from(at))
            };
            assert!(repaired.features.iter().all(|it| has(it, [4.0, 1.0]) && has(it, [4.0, 2.0])));
        }
    }

    #[test]
    fn a_polygon_has_its_own_lines_and_points() {
        let Outlines { features, mut inside, .. } = given().repaired(None).unwrap();
        inside.keep_within(&features[1..]);
        assert_eq!(places(&inside), (vec![[[4.0, 1.0], [8.0, 1.0]]], vec![[4.0, 4.0], [4.0, 2.0]]));
    }

    /// Rounding parted what lay on a border from it: triangles without an angle, or refusals.
    #[test]
    fn what_lies_on_an_oblique_border_becomes_its_vertex() {
        let squares = "POLYGON((0 0,1 0.1,1.4 1.4,0 2)) POLYGON((1 0.1,3 0,3 2,1.4 1.4))";
        // A point, an end, a whole edge, a part of one, and a line to a point.
        let inside = "POINT(1.12 0.49) LINESTRING(1.24 0.88,0.5 0.5) LINESTRING(1 0.1,1.4 1.4) \
                      LINESTRING(1.4 1.4,1.2 0.75) LINESTRING(0.3 0.3,0.7 0.6) POINT(0.5 0.45)";
        let read = |wkt: &str| {
            let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
            read(wkt.as_bytes(), OutlineFormat::Wkt, alone).unwrap()
        };
        let given = read(&format!("{squares} {inside}"));
        for repaired in [
            given.clone().repaired(None).unwrap(),
            given.clone().repaired_together(None, None).unwrap(),
        ] {
            let (lines, points) = places(&repaired.inside);
            assert_eq!(points.len(), 2, "{points:?}");
            assert_eq!(lines.len(), 3, "{lines:?}");
            let starts = |ring: &crate::outline::DrawnRing| {
                ring.pieces.iter().map(|piece| piece.start.to_array()).collect::<Vec<_>>()
            };
            let [one, other] = [0, 1].map(|at| starts(&repaired.features[at].rings[0]));
            let shared = one.iter().filter(|at| other.contains(at)).count();
            assert_eq!((shared, one.len(), other.len()), (5, 7, 7));
            let ends = lines.iter().flatten().filter(|at| one.contains(at)).count();
            assert!(one.contains(&points[0]) && ends == 1, "{lines:?} {one:?}");
            assert!(lines.iter().flatten().filter(|at| **at == points[1]).count() == 2);
            let note =
                "dropped 6 edges of lines outside the polygons, along their rings or there twice";
            assert!(repaired.notes.iter().any(|said| said == note), "{:?}", repaired.notes);
        }
    }

    #[test]
    fn a_tolerance_joins_ends_of_lines_and_moves_no_point() {
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let wkt = "POLYGON((0 0,4 0,4 4,0 4)) POLYGON((4 0,8 0,8 4,4 4)) \
                   LINESTRING(1 1,3.95 1.5) POINT(3.95 3)";
        let given = read(wkt.as_bytes(), OutlineFormat::Wkt, alone).unwrap();
        let repaired = given.repaired_together(None, Some(0.1)).unwrap();
        let (lines, points) = places(&repaired.inside);
        assert_eq!(
            (&lines[..], &points[..]),
            (&[[[1.0, 1.0], [3.95, 1.5]]][..], &[[3.95, 3.0]][..])
        );
        // Both borders go through the end of the line.
        for feature in &repaired.features {
            let mut starts = feature.rings[0].pieces.iter().map(|piece| piece.start);
            assert!(starts.clone().any(|at| at == DVec2::new(3.95, 1.5)));
            assert!(!starts.any(|at| at == DVec2::new(3.95, 3.0)));
        }
    }

    #[test]
    fn lines_and_points_are_projected_as_rings_are() {
        let plane = given().projected(ProjectionChoice::Auto).unwrap();
        let start =
            |feature: usize, piece: usize| plane.features[feature].rings[0].pieces[piece].start;
        let corner = plane.inside.points[1].at;
        assert!(
            plane
                .features
                .iter()
                .all(|it| it.rings[0].pieces.iter().any(|piece| piece.start == corner))
        );
        // A line in degrees bends in the plane.
        let lines = &plane.inside.lines;
        assert!(
            lines.len() > 2
                && lines.windows(2).all(|pair| pair[0].segment.end == pair[1].segment.start)
        );
        let length: f64 = lines.iter().map(|line| line.segment.length()).sum();
        let twice = start(0, 0).distance(start(1, 0)) * 2.0;
        assert!((length / twice - 1.0).abs() < 0.01, "{length} {twice}");
        assert_eq!(lines.iter().filter(|line| line.begins_side).count(), 1);
    }
}
