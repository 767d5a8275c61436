//! The borders of polygons, each once.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_mesh::listed;

use super::Border;
use crate::choice::Polygon;
use crate::curve::{PieceCurve, Segment, norm};
use crate::error::OutlineError;
use crate::outline::{DrawnRing, key};
use crate::text::{counted, shown};

/// Curves between the same points are one if their middles are nearer than this share of their length.
const SAME: f64 = 1e-6;

/// How many rings a note names.
const NAMED: usize = 5;

/// A point as a key.
type Key = (u64, u64);

/// The borders of polygons, with the polygons beside them, and notes on what bounds nothing.
pub(super) fn of_polygons(
    polygons: &[Polygon],
    names: &[String],
) -> Result<(Vec<Border>, Vec<String>), OutlineError> {
    let mut borders: Vec<Border> = Vec::new();
    let mut between: BTreeMap<[Key; 2], Vec<usize>> = BTreeMap::new();
    let (mut repeated, mut empty) = (0, Vec::new());
    for (region, polygon) in (0..).zip(polygons) {
        for (index, ring) in polygon.feature.rings.iter().enumerate() {
            if let Some(at) = empty_at(ring) {
                empty.push(format!("{} at {}", names[region as usize], shown(at)));
                if index == 0 {
                    break;
                }
                continue;
            }
            // The outer ring has the region on its left if it runs counter-clockwise, a hole if it runs clockwise.
            let own = usize::from((ring.doubled_area() > 0.0) != (index == 0));
            for (segment, piece) in ring.segments().zip(&ring.pieces) {
                let Segment { start, end, curve } = segment;
                if start == end && curve == PieceCurve::Line {
                    repeated += 1;
                    continue;
                }
                let mut ends = [key(start), key(end)];
                ends.sort_unstable();
                let known = between.entry(ends).or_default();
                let found = known.iter().find(|&&at| is_same(borders[at].segment, segment));
                let at = found.copied().unwrap_or(borders.len());
                if at == borders.len() {
                    known.push(at);
                    let (side, begins_side) = (piece.side.clone(), piece.begins_side);
                    borders.push(Border { segment, side, begins_side, beside: [None; 2] });
                }
                let border = &mut borders[at];
                border.begins_side |= piece.begins_side;
                let is_reversed = match start == end {
                    true => {
                        near(border.segment, segment, 0.25) > near(border.segment, segment, 0.75)
                    }
                    false => border.segment.start != start,
                };
                let place = || format!("the edge from {} to {}", shown(start), shown(end));
                let slot = &mut border.beside[own ^ usize::from(is_reversed)];
                let other = slot.replace(region);
                let name = |region: u32| &names[region as usize];
                let is_both = border.beside == [Some(region); 2];
                if other == Some(region) || is_both {
                    let problem = format!("{} runs along it twice", name(region));
                    let error = OutlineError::place(place(), problem).telling([start, end]);
                    return Err(OutlineError { is_touch: true, ..error });
                }
                if let Some(other) = other {
                    return Err(overlap(place(), name(other), name(region)).telling([start, end]));
                }
            }
        }
    }
    let mut notes = Vec::new();
    if repeated > 0 {
        let points = counted(repeated, "point");
        notes.push(format!("left out {points} that repeat the one before"));
    }
    if !empty.is_empty() {
        let rings = counted(empty.len(), "ring");
        let places = listed(empty, NAMED, ", ");
        notes.push(format!("left out {rings} that bound no area: {places}"));
    }
    Ok((borders, notes))
}

/// The first point of a straight ring that runs back along each of its edges, and so bounds no area.
fn empty_at(ring: &DrawnRing) -> Option<DVec2> {
    if ring.is_curved() {
        return None;
    }
    let mut runs: BTreeMap<[Key; 2], i64> = BTreeMap::new();
    for Segment { start, end, .. } in ring.segments() {
        let (one, other) = (key(start), key(end));
        *runs.entry([one.min(other), one.max(other)]).or_default() += one.cmp(&other) as i64;
    }
    let first = ring.pieces.first()?.start;
    runs.into_values().all(|runs| runs == 0).then_some(first)
}

/// The fault of regions that overlap.
pub(super) fn overlap(place: String, one: &str, other: &str) -> OutlineError {
    let problem = format!("{one} and {other} overlap there; each place must be in one polygon");
    OutlineError { is_touch: true, ..OutlineError::place(place, problem) }
}

/// Whether two pieces between the same points, of either direction, are one.
fn is_same(one: Segment, other: Segment) -> bool {
    match (one.curve, other.curve) {
        (PieceCurve::Line, PieceCurve::Line) => true,
        (PieceCurve::Line, _) | (_, PieceCurve::Line) => false,
        _ => near(one, other, 0.5) <= SAME * one.length(),
    }
}

/// How far the point at a quarter or half of the way along a piece is from a point of another.
fn near(one: Segment, other: Segment, along: f64) -> f64 {
    norm(one.point(along.min(1.0 - along)) - other.point(along))
}
