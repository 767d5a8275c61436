//! Rings that touch themselves or each other, parted into simple ones.
//!
//! Where a ring crosses itself, or a vertex lies on another edge, both edges get a vertex. A ring that
//! comes back to a point it has been at is parted there; what then runs to and fro along one line is
//! dropped, and so are repeated points. The parts are sorted anew: a part beside
//! the others is a polygon of its own, a part inside another is a hole. A hole that still touches
//! another ring at a vertex is parted from it by moving that vertex a little into the hole.
//!
//! Limits: only straight pieces are parted where they cross; two rings that cross each other stay as
//! they are, and are refused when the domain is made.

mod crossings;

use std::collections::BTreeMap;

use glam::DVec2;

use super::curve::{Curve, norm};
use super::nesting::{FillRule, contains, polygons};
use super::orientation::orientation;
use super::outline::{Feature, Outlines, Piece, Ring, key};
use super::text::counted;
use crate::error::ReadError;

/// What repairing did.
#[derive(Default)]
struct Repairs {
    crossings: usize,
    repeated: usize,
    spikes: usize,
    split: usize,
    flat: usize,
    moved: usize,
    farthest: f64,
}

/// The share of the shorter neighbouring edge by which a vertex moves at most.
const SHARE_MOVED: f64 = 0.25;

/// How often parts of a ring are looked at again. Files made to be slow need more.
const ROUNDS: usize = 100;

/// The most points that are looked at to move vertices of one polygon.
const MOST_LOOKED_AT: usize = 100_000_000;

impl Outlines {
    /// The same polygons with rings that do not touch themselves or each other, and notes on what
    /// was done.
    ///
    /// # Errors
    ///
    /// More parts inside each other than can be sorted in some seconds.
    pub fn repaired(self) -> Result<Self, ReadError> {
        let mut features = Vec::new();
        let mut notes = self.notes;
        for (index, feature) in self.features.into_iter().enumerate() {
            let mut repairs = Repairs::default();
            let name = feature.name.clone();
            let whose = name.clone().unwrap_or_else(|| format!("polygon {}", index + 1));
            let repaired = repairs.feature(feature)?;
            notes.extend(repairs.note(&whose, repaired.len()));
            features.extend(repaired);
        }
        Ok(Self { features, notes })
    }
}

impl Repairs {
    fn feature(&mut self, feature: Feature) -> Result<Vec<Feature>, ReadError> {
        let mut rings = Vec::new();
        for ring in feature.rings {
            // A tip of a spike would meet the edges beside it.
            let (pieces, spikes) = without_spikes(ring.pieces);
            self.spikes += spikes;
            let (ring, crossings) = crossings::with_vertices(Ring { pieces });
            self.crossings += crossings;
            let parts = self.simple_rings(ring);
            self.split += parts.len().saturating_sub(1);
            rings.extend(parts);
        }
        let (mut features, _) = polygons(rings, FillRule::EvenOdd, feature.name.as_deref())?;
        for feature in &mut features {
            self.part_holes(feature);
        }
        Ok(features)
    }

    /// The parts of a ring that come back to no point before their end.
    fn simple_rings(&mut self, ring: Ring) -> Vec<Ring> {
        let mut open = vec![(ring.pieces, 0)];
        let mut parts = Vec::new();
        while let Some((pieces, round)) = open.pop() {
            let (pieces, spikes) = without_spikes(pieces);
            self.spikes += spikes;
            let mut split = self.split_at_repeated_points(pieces);
            if spikes == 0 && split.len() <= 1 || round == ROUNDS {
                parts.append(&mut split);
            } else {
                // Parts may have spikes where they were joined.
                open.extend(split.into_iter().rev().map(|part| (part, round + 1)));
            }
        }
        let rings = parts.into_iter().map(|pieces| Ring { pieces });
        let (flat, rings): (Vec<Ring>, Vec<Ring>) =
            rings.partition(|ring| ring.doubled_area() == 0.0);
        self.flat += flat.len();
        rings
    }

    /// The closed runs between two visits of the same point.
    fn split_at_repeated_points(&mut self, pieces: Vec<Piece>) -> Vec<Vec<Piece>> {
        let mut parts = Vec::new();
        let mut run: Vec<Piece> = Vec::new();
        let mut position_of = BTreeMap::new();
        for piece in pieces {
            let start = key(piece.start);
            if let Some(&position) = position_of.get(&start) {
                let part = run.split_off(position);
                part.iter().for_each(|piece| _ = position_of.remove(&key(piece.start)));
                parts.extend(self.worth_keeping(part));
            }
            position_of.insert(start, run.len());
            run.push(piece);
        }
        parts.extend(self.worth_keeping(run));
        parts
    }

    /// A closed run, unless it is a repeated point or runs to and fro.
    fn worth_keeping(&mut self, part: Vec<Piece>) -> Option<Vec<Piece>> {
        let is_straight = part.iter().all(|piece| piece.curve == Curve::Line);
        match part.len() {
            1 if is_straight => self.repeated += 1,
            2 if is_straight => self.spikes += 1,
            0 => {}
            _ => return Some(part),
        }
        None
    }

    /// Moves the vertices of holes that other rings have, too.
    fn part_holes(&mut self, feature: &mut Feature) {
        let mut taken = BTreeMap::new();
        let mut looked_at = 0;
        for ring in &mut feature.rings {
            for index in 0..ring.pieces.len() {
                let point = ring.pieces[index].start;
                if !taken.contains_key(&key(point)) || looked_at > MOST_LOOKED_AT {
                    continue;
                }
                looked_at += ring.pieces.len();
                if let Some(moved) = moved_inside(ring, index) {
                    self.moved += 1;
                    self.farthest = self.farthest.max(norm(moved - point));
                    ring.pieces[index].start = moved;
                }
            }
            taken.extend(ring.pieces.iter().map(|piece| (key(piece.start), ())));
        }
    }

    fn note(&self, whose: &str, polygons: usize) -> Option<String> {
        let mut done = Vec::new();
        if self.crossings > 0 {
            done.push(format!("added {} where edges meet", counted(self.crossings, "point")));
        }
        if self.repeated > 0 {
            done.push(format!("dropped {}", counted(self.repeated, "repeated point")));
        }
        if self.spikes > 0 {
            done.push(format!("dropped {}", counted(self.spikes, "spike")));
        }
        if self.flat > 0 {
            done.push(format!("dropped {} without area", counted(self.flat, "ring")));
        }
        if self.split > 0 {
            let places = counted(self.split, "place");
            done.push(format!("parted rings at {places}, into {}", counted(polygons, "polygon")));
        }
        if self.moved > 0 {
            let (vertices, farthest) = (counted(self.moved, "vertex"), self.farthest);
            let vertices = vertices.replace("vertexs", "vertices");
            done.push(format!("moved {vertices} of touching holes by {farthest:.2e} at most"));
        }
        (!done.is_empty()).then(|| format!("repaired {whose}: {}", done.join("; ")))
    }
}

/// The pieces without points where two straight ones run back on each other, and how many there
/// were.
fn without_spikes(pieces: Vec<Piece>) -> (Vec<Piece>, usize) {
    let mut kept: Vec<Piece> = Vec::with_capacity(pieces.len());
    let count = pieces.len();
    for piece in pieces {
        while let [.., before, tip] = &kept[..]
            && is_spike(before, tip, piece.start)
        {
            kept.pop();
        }
        kept.push(piece);
    }
    // Where the end meets the start.
    let mut first = 0;
    loop {
        match &kept[first..] {
            [start, .., before, tip] if is_spike(before, tip, start.start) => _ = kept.pop(),
            [tip, after, .., before] if is_spike(before, tip, after.start) => first += 1,
            _ => break,
        }
    }
    kept.drain(..first);
    let spikes = count - kept.len();
    (kept, spikes)
}

/// Whether the ring runs straight to the start of `tip` and straight back towards `after`.
fn is_spike(before: &Piece, tip: &Piece, after: DVec2) -> bool {
    before.curve == Curve::Line
        && tip.curve == Curve::Line
        && before.start != after
        && before.start != tip.start
        && tip.start != after
        && orientation(before.start, tip.start, after) == 0.0
        && (tip.start - before.start).dot(after - tip.start) < 0.0
}

/// A point a little inside the ring, beside one of its vertices; none if its pieces there are
/// curved or nothing is free.
fn moved_inside(ring: &Ring, index: usize) -> Option<DVec2> {
    let count = ring.pieces.len();
    let [before, after] = [index + count - 1, index + 1].map(|at| &ring.pieces[at % count]);
    let here = &ring.pieces[index];
    if before.curve != Curve::Line || here.curve != Curve::Line || count < 3 {
        return None;
    }
    let point = here.start;
    let [back, forth] = [before.start, after.start].map(|end| end - point);
    let shorter = norm(back).min(norm(forth));
    let [back_unit, forth_unit] = [back / norm(back), forth / norm(forth)];
    // Inside is left of the ring if it runs counter-clockwise.
    let left = if ring.doubled_area() > 0.0 { 1.0 } else { -1.0 };
    let turn = left * (-back).perp_dot(forth);
    let middle = back_unit + forth_unit;
    let straight = left * forth_unit.perp();
    let direction = match middle.length() {
        0.0 => straight,
        length if turn < 0.0 => -middle / length,
        length => middle / length,
    };
    let points = ring.flattened();
    let others: Vec<DVec2> = points
        .iter()
        .copied()
        .filter(|&other| ![point, before.start, after.start].contains(&other))
        .collect();
    let mut step = SHARE_MOVED * shorter;
    for _ in 0..30 {
        let moved = point + direction * step;
        let is_free = |end: DVec2| {
            let triangle = [point, end, moved];
            !others.iter().any(|&other| contains(&triangle, &[other]))
        };
        if moved != point
            && contains(&points, &[moved])
            && is_free(before.start)
            && is_free(after.start)
        {
            return Some(moved);
        }
        step /= 2.0;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    type Points = Vec<[f64; 2]>;

    /// The rings of each polygon after the repair of one ring or more, and the notes.
    fn repaired(rings: &[&[[f64; 2]]]) -> (Vec<Vec<Points>>, Vec<String>) {
        let ring = |points: &&[[f64; 2]]| Ring {
            pieces: points.iter().map(|&point| Piece::line(point.into())).collect(),
        };
        let feature = Feature { name: None, rings: rings.iter().map(ring).collect() };
        let outlines = Outlines { features: vec![feature], notes: vec![] }.repaired().unwrap();
        let points = |ring: &Ring| ring.pieces.iter().map(|piece| piece.start.to_array()).collect();
        let rings = |feature: &Feature| feature.rings.iter().map(points).collect();
        (outlines.features.iter().map(rings).collect(), outlines.notes)
    }

    #[test]
    fn simple_rings_stay_as_they_are() {
        let square: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let hole: &[[f64; 2]] = &[[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
        let (features, notes) = repaired(&[square, hole]);
        assert_eq!(features, [[square.to_vec(), hole.to_vec()]]);
        assert!(notes.is_empty());
    }

    #[test]
    fn repeated_points_and_spikes_are_dropped() {
        let triangle = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        for (points, note) in [
            (
                &[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]][..],
                "dropped 3 repeated points",
            ),
            // There and back along the same line, along a bent one, and farther than one came.
            (&[[0.0, 0.0], [4.0, 0.0], [9.0, 1.0], [4.0, 0.0], [0.0, 3.0]], "dropped 1 spike"),
            (
                &[
                    [0.0, 0.0],
                    [4.0, 0.0],
                    [9.0, 1.0],
                    [9.0, 2.0],
                    [9.0, 1.0],
                    [4.0, 0.0],
                    [0.0, 3.0],
                ],
                "dropped 2 spikes",
            ),
            (&[[0.0, 0.0], [9.0, 0.0], [4.0, 0.0], [0.0, 3.0]], "dropped 1 spike"),
            (&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 7.0]], "dropped 1 spike"),
        ] {
            let (features, notes) = repaired(&[points]);
            assert_eq!(features, [[triangle.clone()]], "{points:?}");
            assert_eq!(notes, [format!("repaired polygon 1: {note}")]);
        }
        // The tip is the first point.
        let (features, _) = repaired(&[&[[-2.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]]]);
        assert_eq!(features, [[vec![[4.0, 0.0], [0.0, 3.0], [0.0, 0.0]]]]);
        let (features, notes) = repaired(&[&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]]);
        assert!(features.is_empty(), "{features:?}, {notes:?}");
    }

    #[test]
    fn a_ring_that_touches_itself_from_outside_becomes_two_polygons() {
        let ring: &[[f64; 2]] =
            &[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [4.0, 2.0], [2.0, 1.0], [0.0, 2.0]];
        let (features, notes) = repaired(&[ring]);
        let left = vec![[0.0, 0.0], [2.0, 1.0], [0.0, 2.0]];
        let right = vec![[2.0, 1.0], [4.0, 0.0], [4.0, 2.0]];
        assert_eq!(features, [[right], [left]]);
        assert_eq!(notes, ["repaired polygon 1: parted rings at 1 place, into 2 polygons"]);
    }

    #[test]
    fn a_ring_that_touches_itself_from_inside_gets_a_hole_moved_away() {
        // A square with a triangular bay that closes at (2, 0).
        let ring: &[[f64; 2]] = &[
            [0.0, 0.0],
            [2.0, 0.0],
            [1.0, 2.0],
            [3.0, 2.0],
            [2.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
        ];
        let (features, notes) = repaired(&[ring]);
        let [rings] = &features[..] else { panic!("{features:?}") };
        let [outer, hole] = &rings[..] else { panic!("{rings:?}") };
        assert_eq!(*outer, [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        assert_eq!(hole[1..], [[1.0, 2.0], [3.0, 2.0]]);
        assert_eq!(hole[0][0], 2.0);
        assert!(hole[0][1] > 0.5 && hole[0][1] < 0.6, "{hole:?}");
        assert_eq!(
            notes,
            [
                "repaired polygon 1: parted rings at 1 place, into 1 polygon; moved 1 vertex of touching holes by 5.59e-1 at most"
            ]
        );
    }

    #[test]
    fn a_ring_that_crosses_itself_is_parted_there() {
        let ring: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
        let (features, notes) = repaired(&[ring]);
        let right = vec![[2.0, 2.0], [4.0, 4.0], [4.0, 0.0]];
        assert_eq!(features, [[right], [vec![[0.0, 0.0], [2.0, 2.0], [0.0, 4.0]]]]);
        assert_eq!(
            notes,
            [
                "repaired polygon 1: added 2 points where edges meet; parted rings at 1 place, into 2 polygons"
            ]
        );
    }

    #[test]
    fn a_ring_joined_to_its_hole_by_a_cut_is_parted() {
        let ring: &[[f64; 2]] = &[
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [3.0, 3.0],
            [4.0, 4.0],
            [0.0, 4.0],
        ];
        let (features, _) = repaired(&[ring]);
        let outer = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        assert_eq!(features, [[outer, vec![[3.0, 3.0], [3.0, 1.0], [1.0, 1.0]]]]);
    }

    #[test]
    fn holes_that_touch_from_a_reflex_vertex_move_inside() {
        let outer: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 2.0], [0.0, 4.0]];
        let hole: &[[f64; 2]] = &[[1.0, 2.5], [1.5, 0.5], [2.5, 0.5], [3.0, 2.5], [2.0, 2.0]];
        let (features, _) = repaired(&[outer, hole]);
        let moved = features[0][1][4];
        assert!(moved[0] == 2.0 && moved[1] < 2.0 && moved[1] > 1.5, "{moved:?}");
    }

    #[test]
    fn a_vertex_moves_along_the_middle_of_its_angle() {
        let ring = |points: &[[f64; 2]]| Ring::of_points(points.iter().copied().map(DVec2::from));
        // A square, a straight vertex, a reflex one: the vertex 1, and where it goes.
        let half = 0.5_f64.sqrt();
        for (points, shorter, direction) in [
            (&[[0.0, 0.0], [4.0, 0.0], [4.0, 8.0], [0.0, 8.0]][..], 4.0, [-half, half]),
            (&[[0.0, 0.0], [6.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]], 2.0, [0.0, 1.0]),
            (&[[0.0, 4.0], [4.0, 4.0], [4.0, 0.0], [8.0, 8.0], [0.0, 8.0]], 4.0, [half, half]),
        ] {
            let expected = DVec2::from(points[1]) + DVec2::from(direction) * SHARE_MOVED * shorter;
            let moved = moved_inside(&ring(points), 1).unwrap();
            assert!(moved.distance(expected) < 1e-12, "{points:?}: {moved}, {expected}");
            let mut back = points.to_vec();
            back.reverse();
            let turned = moved_inside(&ring(&back), points.len() - 2).unwrap();
            assert!(turned.distance(expected) < 1e-12, "{back:?}: {turned}");
        }
        // Something in the way: the step is halved until the way is free.
        let crowded = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.6, 0.3], [0.0, 4.0]];
        let moved = moved_inside(&ring(&crowded), 1).unwrap();
        assert!(moved.distance(DVec2::new(4.0, 0.0)) < 0.5, "{moved}");
        assert!(contains(&ring(&crowded).flattened(), &[moved]));
    }

    #[test]
    fn two_arcs_that_touch_a_ring_are_no_spike() {
        use crate::curve::{Arc, Curve};
        let turn = std::f64::consts::PI;
        let arc = |start: f64| {
            let axes = [DVec2::X, DVec2::Y];
            let arc = Arc { center: DVec2::new(-1.0, 0.0), axes, start, sweep: turn };
            Piece { curve: Curve::Arc(arc), ..Piece::line(arc.point(start)) }
        };
        // A triangle from (0, 0), and a circle of two arcs that begins there, too.
        let mut pieces = vec![Piece::line(DVec2::ZERO)];
        pieces.extend([[4.0, 0.0], [4.0, 3.0]].map(|point| Piece::line(point.into())));
        pieces.extend([arc(0.0), arc(turn)]);
        pieces[3].start = DVec2::ZERO;
        let feature = Feature { name: None, rings: vec![Ring { pieces }] };
        let outlines = Outlines { features: vec![feature], notes: vec![] }.repaired().unwrap();
        let counts: Vec<usize> =
            outlines.features.iter().map(|feature| feature.rings[0].pieces.len()).collect();
        assert_eq!(counts, [3, 2], "{outlines:?}");
    }
}
