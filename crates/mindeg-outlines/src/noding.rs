//! Lines inside polygons that cross each other or a ring get a point there, and so does the ring.

use std::collections::{BTreeSet, HashSet};

use glam::DVec2;
use mindeg_mesh::sorted;

use super::curve::{PieceCurve, Segment};
use super::nesting::{Loop, is_in, loops};
use super::outline::{Border, DrawnInside, Feature, Outlines, Piece, key};
use super::overlay::crossings::parted;
use super::overlay::edge::Edge;
use super::text::counted;
use super::vertices::Vertices;
use crate::error::OutlineError;

/// The chords of pieces of rings, then of lines, as edges between vertices.
struct Chords {
    vertices: Vertices,
    edges: Vec<Edge>,
    /// The piece of each chord, by its index among all.
    piece_of: Vec<usize>,
    pieces: usize,
}

impl Chords {
    fn push(&mut self, segment: Segment) {
        let count = segment.intervals_by_turning();
        let at = |i: u32| segment.point(f64::from(i) / f64::from(count));
        let own: Vec<u32> = (0..=count).map(|i| self.vertices.index(at(i))).collect();
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

impl Outlines {
    /// Gives lines inside, and rings that they cross, a point where they meet, and drops what lies outside all polygons.
    ///
    /// # Errors
    ///
    /// The errors of [`Self::node_inside`].
    pub(super) fn clip_inside(&mut self) -> Result<(), OutlineError> {
        if self.inside.is_empty() {
            return Ok(());
        }
        self.node_inside()?;
        let before = [self.inside.lines.len(), self.inside.points.len()];
        self.inside.keep_within(&self.features);
        let mut edges = HashSet::new();
        self.inside.lines.retain(|line| {
            let Segment { start, end, curve } = line.segment;
            curve != PieceCurve::Line || edges.insert(sorted([key(start), key(end)]))
        });
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

    /// Gives lines inside, and rings that they cross, a point where they meet. Edges that are there twice stay once.
    ///
    /// # Errors
    ///
    /// Edges too many or too near each other to be told apart in some seconds.
    fn node_inside(&mut self) -> Result<(), OutlineError> {
        if self.inside.lines.is_empty() {
            return Ok(());
        }
        let rings = || self.features.iter().flat_map(|feature| &feature.rings);
        let segments = || {
            rings()
                .flat_map(|ring| ring.segments())
                .chain(self.inside.lines.iter().map(|line| line.segment))
        };
        let greatest = segments().map(|it| it.start.abs().max_element()).fold(0.0, f64::max);
        let mut chords = Chords {
            vertices: Vertices::new(DVec2::ZERO, f64::EPSILON * greatest),
            edges: Vec::new(),
            piece_of: Vec::new(),
            pieces: 0,
        };
        segments().for_each(|segment| chords.push(segment));
        let Chords { mut vertices, edges, piece_of, pieces } = chords;
        let (edges, added) =
            parted(edges, &mut vertices).map_err(|problem| OutlineError::place("", problem))?;
        if added == 0 {
            return Ok(());
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
        for (line, (own, whole)) in self.inside.lines.drain(..).zip(next) {
            if own.len() == whole {
                let before = known.len();
                known.extend(own.iter().map(|&ends| sorted(ends)));
                lines.extend((known.len() > before).then_some(line));
                continue;
            }
            for (index, &ends) in
                own.iter().enumerate().filter(|(_, ends)| known.insert(sorted(**ends)))
            {
                let [start, end] = ends.map(at);
                lines.push(Border {
                    segment: Segment { start, end, curve: PieceCurve::Line },
                    begins_side: line.begins_side && index == 0,
                    ..line.clone()
                });
            }
        }
        self.inside.lines = lines;
        self.notes.push(format!(
            "added {} where lines inside meet others or a ring",
            counted(added, "point")
        ));
        Ok(())
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
            assert_eq!(points, [[2.0, 2.0], [4.0, 4.0]]);
            let note = "dropped 1 edge of lines and 2 points outside the polygons, along their rings or there twice";
            assert!(repaired.notes.iter().any(|said| said == note), "{:?}", repaired.notes);
            // Both squares have the point where the line crosses their border.
            let has_point = |feature: &Feature| {
                feature.rings[0].pieces.iter().any(|piece| piece.start == DVec2::new(4.0, 1.0))
            };
            assert!(repaired.features.iter().all(has_point));
        }
    }

    #[test]
    fn a_polygon_has_its_own_lines_and_points() {
        let Outlines { features, mut inside, .. } = given().repaired(None).unwrap();
        inside.keep_within(&features[1..]);
        assert_eq!(places(&inside), (vec![[[4.0, 1.0], [8.0, 1.0]]], vec![[4.0, 4.0]]));
    }

    #[test]
    fn lines_and_points_are_projected_as_rings_are() {
        let (plane, _) = given().projected(ProjectionChoice::Auto).unwrap();
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
