//! The places where the boundary moved most, magnified.

use super::super::svg;
use super::marks::{Drawn, KINDS, Mark, Number, contains, drawn, numbers};
use glam::DVec2;
use mindeg::Bounds;

/// The most places.
const MOST_PANES: usize = 8;
/// The least radius of their marks.
const RADIUS: f64 = 3.0;
/// The width of the magnified part: so many times the way that the boundary moved there, or so many edges.
const WAYS: f64 = 6.0;
const EDGES: f64 = 4.0;
/// Less than that is not worth a magnified picture.
const LEAST_MAGNIFIED: f64 = 2.0;

/// A magnified place.
pub(super) struct Pane {
    /// The part of the large picture.
    pub(super) part: Bounds,
    pub(super) at: DVec2,
    pub(super) side: f64,
    pub(super) scale: f64,
    pub(super) by: DVec2,
    pub(super) marks: Vec<Drawn>,
    pub(super) numbers: Vec<Number>,
    pub(super) title: String,
    pub(super) below: String,
}

/// The places that are magnified, each with its mark and its square of the picture: those where the boundary moved most, of each kind one
/// before there are two.
pub(super) fn parts(marks: &[Mark], edge: f64, map: Bounds, side: f64) -> Vec<(&Mark, Bounds)> {
    let mut order: Vec<(usize, &Mark)> = Vec::new();
    for same in marks.chunk_by(|a, b| a.kind == b.kind) {
        let mut same: Vec<&Mark> = same.iter().collect();
        same.sort_by(|a, b| b.way[0].total_cmp(&a.way[0]).then(a.number.cmp(&b.number)));
        // Changes that moved nothing come last.
        let rank = |index: usize, mark: &Mark| match mark.note.is_empty() {
            true => MOST_PANES + index,
            false => index,
        };
        order.extend((0..).zip(same).map(|(index, mark)| (rank(index, mark), mark)));
    }
    order.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.way[0].total_cmp(&a.1.way[0])));
    let mut parts: Vec<(&Mark, Bounds)> = Vec::new();
    for (_, mark) in order {
        let wide = (WAYS * mark.way[1]).max(EDGES * edge).min(map.size().max_element() / 6.0);
        let half = DVec2::splat(wide / 2.0);
        let part = Bounds { min: mark.at - half, max: mark.at + half };
        let is_seen = parts.iter().any(|(_, other)| contains(*other, mark.at));
        if !is_seen && side / wide >= LEAST_MAGNIFIED {
            parts.push((mark, part));
        }
        if parts.len() == MOST_PANES {
            break;
        }
    }
    parts
}

/// A magnified place.
pub(super) fn pane(own: &Mark, part: Bounds, at: DVec2, side: f64, marks: &[Mark]) -> Pane {
    let scale = side / part.size().x;
    let inside = |place: DVec2| (place - part.min) * scale;
    let seen: Vec<&Mark> = marks.iter().filter(|mark| contains(part, mark.at)).collect();
    let mut first = vec![own];
    first.extend(seen.iter().filter(|mark| mark.number != own.number));
    let number = own.number.map_or_else(String::new, |number| format!("{number}: "));
    let note = if own.note.is_empty() { String::new() } else { own.note.clone() + " · " };
    Pane {
        part,
        at,
        side,
        scale,
        by: -part.min * scale,
        marks: drawn(&seen, RADIUS, inside),
        numbers: numbers(&first, inside, svg::space(DVec2::splat(side))),
        title: number + KINDS[own.kind].2,
        below: format!("{note}× {scale:.0}"),
    }
}
