//! Rings laid over each other: the polygons of all points that fill rules count as inside.
//!
//! The rings become a planar subdivision: edges that meet at their ends alone, each with the change of
//! the winding numbers across it. Edges with inside on one side and outside on the other bound the
//! polygons, so that these neither overlap nor cross. All decisions are exact; only points where edges
//! cross are rounded. A ring that crosses nothing keeps its points bit for bit, and its curves.
//!
//! Limits: curves meet as their chords do, by turns of 15 degrees, and become chords where they meet
//! something.

pub(super) mod crossings;
pub(super) mod edge;
pub(super) mod faces;
pub(super) mod near;

use glam::DVec2;
use mindeg_mesh::planar::orientation;

pub(super) use self::edge::Layer;
use self::edge::{Edge, Step, points_of};

use super::curve::PieceCurve;
use super::loops::reversed;
use super::nesting::{Loop, smallest_around};
use super::outline::{DrawnRing, Piece};
use super::vertices::Vertices;

/// The result of laying rings over each other.
#[derive(Debug, Default)]
pub(super) struct Overlay {
    /// For each polygon its rings, the outer one first, and the ring of the first layer, by its index,
    /// that the outer one follows; in the order of the rings given.
    pub(super) polygons: Vec<(Vec<DrawnRing>, Option<usize>)>,
    /// How many vertices were added to edges.
    pub(super) added: usize,
    /// How many points repeat the one before.
    pub(super) repeated: usize,
    /// How many edges have inside or outside on both sides.
    pub(super) dropped: usize,
}

/// A straight piece of a ring, or one of the chords of a curved piece.
pub(super) struct Chord<'a> {
    pub(super) layer: usize,
    /// The index of the ring in its layer.
    index: usize,
    ring: &'a DrawnRing,
    piece: usize,
    /// Which of how many chords of the piece it is.
    pub(super) part: (usize, usize),
    pub(super) ends: [u32; 2],
}

/// The greatest and the least size of a coordinate with which no decision overflows or vanishes.
const SIZES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// How near to a vertex a crossing is that vertex, as a share of the greatest coordinate: rounding.
pub(super) const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// How near to a vertex a crossing of these layers is that vertex.
///
/// # Errors
///
/// Coordinates beyond the limits of decisions.
pub(super) fn rounding(layers: &[Layer<'_>]) -> Result<f64, String> {
    let points = || layers.iter().flat_map(|it| &it.rings).flat_map(|ring| ring.flattened());
    let is_usable = |x: f64| x == 0.0 || SIZES.contains(&x.abs());
    if !points().all(|point| is_usable(point.x) && is_usable(point.y)) {
        return Err(
            "coordinates must be 0 or from 1e-100 to 1e100 in size; scale the outline".into()
        );
    }
    Ok(ROUNDING * points().map(|point| point.abs().max_element()).fold(0.0, f64::max))
}

/// The polygons of the points that `is_inside` holds for, given for each layer whether its rule counts
/// the point.
///
/// # Errors
///
/// Coordinates beyond the limits of decisions; more edges above each other than can be compared in some
/// seconds.
pub(super) fn overlay(
    layers: &[Layer<'_>],
    is_inside: impl Fn(&[bool]) -> bool,
) -> Result<Overlay, String> {
    let mut vertices = Vertices::new(DVec2::ZERO, rounding(layers)?);
    let (chords, repeated) = chords(layers, &mut vertices);
    let edges = (0..).zip(&chords).map(|(chord, it)| Edge { ends: it.ends, chord }).collect();
    let (edges, added) = crossings::parted(edges, &mut vertices)?;
    let layer_of = |edge: &Edge| chords[edge.chord as usize].layer;
    let (bounds, dropped) = faces::boundary(&edges, &vertices.points, layers, layer_of, is_inside)?;
    let mut outers = Vec::new();
    let mut holes = Vec::new();
    let mut visits = vec![0_u32; vertices.points.len()];
    bounds.iter().flatten().for_each(|step| visits[step.from as usize] += 1);
    for mut steps in bounds {
        let is_outer = turns_left(&points_of(&steps, &vertices.points));
        joined(&mut steps, &vertices.points, &chords, &visits);
        // A ring begins where the first of its pieces does in the file, and runs the same way.
        let begin = |at: &usize| {
            let Step { chord, forward, .. } = steps[*at];
            (chord, if forward { *at } else { steps.len() - at })
        };
        let first = (0..steps.len()).min_by_key(begin).unwrap_or_default();
        if steps[first].forward {
            steps.rotate_left(first);
        } else {
            steps = turned_back(&steps, first);
        }
        let points = points_of(&steps, &vertices.points);
        let found = (steps[0].chord, ring(&steps, &vertices.points, &chords), points);
        if is_outer { outers.push(found) } else { holes.push(found) }
    }
    outers.sort_by_key(|&(chord, ..)| chord);
    holes.sort_by_key(|&(chord, ..)| chord);
    let mut polygons: Vec<(Vec<DrawnRing>, Option<usize>)> = Vec::new();
    let mut loops = Vec::new();
    for (chord, ring, points) in outers {
        let Chord { layer, index, .. } = chords[chord as usize];
        polygons.push((vec![ring], (layer == 0).then_some(index)));
        loops.push(Loop::new(points));
    }
    for (_, ring, points) in holes {
        if let Some(outer) = smallest_around(loops.iter().enumerate(), &points) {
            polygons[outer].0.push(ring);
        }
    }
    Ok(Overlay { polygons, added, repeated, dropped })
}

/// The chords of all rings, and how many straight pieces have no length.
pub(super) fn chords<'a>(layers: &[Layer<'a>], vertices: &mut Vertices) -> (Vec<Chord<'a>>, usize) {
    let mut chords = Vec::new();
    let mut repeated = 0;
    let rings = layers.iter().enumerate().flat_map(|(layer, it)| {
        it.rings.iter().enumerate().map(move |(index, &ring)| (layer, index, ring))
    });
    for (layer, index, ring) in rings {
        for (piece, segment) in ring.segments().enumerate() {
            let count = segment.intervals_by_turning();
            let at = |i: u32| segment.point(f64::from(i) / f64::from(count));
            let corners: Vec<u32> = (0..=count).map(|i| vertices.index(at(i))).collect();
            let is_chord = |pair: &&[u32]| pair[0] != pair[1];
            let parts = corners.windows(2).filter(is_chord).count();
            repeated += usize::from(parts == 0);
            chords.extend(corners.windows(2).filter(is_chord).enumerate().map(|(part, pair)| {
                let ends = [pair[0], pair[1]];
                Chord { layer, index, ring, piece, part: (part, parts), ends }
            }));
        }
    }
    (chords, repeated)
}

/// Whether a simple ring runs counter-clockwise, exactly.
pub(super) fn turns_left(points: &[DVec2]) -> bool {
    let count = points.len();
    let lower = |a: &DVec2, b: &DVec2| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
    let lowest = (0..count).min_by(|&a, &b| lower(&points[a], &points[b])).unwrap_or_default();
    let [before, after] = [lowest + count - 1, lowest + 1].map(|at| points[at % count]);
    orientation(before, points[lowest], after) > 0.0
}

/// Joins parts of a chord that lie on one line exactly, where nothing is left that they met.
fn joined(steps: &mut Vec<Step>, points: &[DVec2], chords: &[Chord<'_>], visits: &[u32]) {
    let is_end =
        |step: &Step| chords[step.chord as usize].ends[usize::from(!step.forward)] == step.from;
    // The first step must not be one that joins the last.
    let Some(start) = steps.iter().position(is_end) else { return };
    steps.rotate_left(start);
    let mut kept: Vec<Step> = Vec::with_capacity(steps.len());
    for (at, &step) in steps.iter().enumerate() {
        let end = steps[(at + 1) % steps.len()].from;
        let is_one_line = kept.last().is_some_and(|last| {
            let [a, b, c] = [last.from, step.from, end].map(|at| points[at as usize]);
            visits[step.from as usize] == 1
                && (last.chord, last.forward) == (step.chord, step.forward)
                && orientation(a, b, c) == 0.0
        });
        if !is_one_line {
            kept.push(step);
        }
    }
    *steps = kept;
}

/// The steps the other way round, from the end of one of them on.
fn turned_back(steps: &[Step], first: usize) -> Vec<Step> {
    let count = steps.len();
    let back = (0..count).map(|i| (first + count - i) % count);
    back.map(|at| {
        let from = steps[(at + 1) % count].from;
        Step { from, forward: !steps[at].forward, ..steps[at] }
    })
    .collect()
}

/// A ring of pieces: whole chords of a curve are the curve.
pub(super) fn ring(steps: &[Step], points: &[DVec2], chords: &[Chord<'_>]) -> DrawnRing {
    let mut pieces = Vec::with_capacity(steps.len());
    let mut rest = steps;
    while let [step, ..] = rest {
        let chord = &chords[step.chord as usize];
        let Piece { start, curve, ref side, .. } = chord.ring.pieces[chord.piece];
        let is_whole = curve != PieceCurve::Line && is_whole(rest, steps[0].from, chords);
        let at_start = chord.ends[usize::from(!step.forward)] == step.from;
        let begins = if step.forward { chord.piece } else { chord.piece + 1 };
        let begins = &chord.ring.pieces[begins % chord.ring.pieces.len()];
        let is_first = chord.part.0 == if step.forward { 0 } else { chord.part.1 - 1 };
        // The file's own point: 0 may be -0.
        let is_own = step.forward && at_start && is_first;
        pieces.push(Piece {
            start: if is_own && start == points[step.from as usize] {
                start
            } else {
                points[step.from as usize]
            },
            curve: match (is_whole, step.forward) {
                (true, true) => curve,
                (true, false) => reversed(curve),
                (false, _) => PieceCurve::Line,
            },
            side: side.clone(),
            begins_side: at_start && is_first && begins.begins_side,
        });
        rest = &rest[if is_whole { chord.part.1 } else { 1 }..];
    }
    DrawnRing { pieces }
}

/// Whether steps begin with all chords of a piece, in order and undivided.
fn is_whole(steps: &[Step], end: u32, chords: &[Chord<'_>]) -> bool {
    let Step { chord, forward, .. } = steps[0];
    let (part, count) = chords[chord as usize].part;
    let is_first = part == if forward { 0 } else { count - 1 };
    let follows = |at: usize| {
        let offset = at as u32;
        let wanted = if forward { Some(chord + offset) } else { chord.checked_sub(offset) };
        let next = steps.get(at + 1).map_or(end, |step| step.from);
        steps.get(at).is_some_and(|step| {
            let ends = chords[step.chord as usize].ends;
            let own = if forward { [step.from, next] } else { [next, step.from] };
            Some(step.chord) == wanted && step.forward == forward && own == ends
        })
    };
    is_first && (0..count).all(follows)
}

#[cfg(test)]
mod tests;
