//! Lines inside polygons that cross each other or a ring get a point there, and so does the ring.

use std::collections::BTreeSet;

use glam::DVec2;
use mindeg_mesh::sorted;

use super::curve::{PieceCurve, Segment};
use super::outline::{Border, Outlines, Piece};
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

impl Outlines {
    /// Gives lines inside, and rings that they cross, a point where they meet. Edges that are there twice stay once.
    ///
    /// # Errors
    ///
    /// Edges too many or too near each other to be told apart in some seconds.
    pub(super) fn node_inside(&mut self) -> Result<(), OutlineError> {
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
