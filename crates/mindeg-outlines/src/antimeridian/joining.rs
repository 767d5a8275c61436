//! Polygons that were cut at the antimeridian, made one again.
//!
//! RFC 7946 asks for the cut. In a plane of metres there is none, and its edges would be a border inside the polygon.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::convert::Infallible;

use super::{NEAR, is_on, ring_running_on, told};
use crate::outline::{DrawnRing, Feature, Outlines, Piece};

/// The part of a ring between two edges along the antimeridian.
struct Run {
    /// The polygon and its ring.
    of: [usize; 2],
    /// The pieces, of which the last ends on the antimeridian.
    pieces: Vec<Piece>,
    /// Where it starts and ends: whether at longitudes just below 180°, and the latitude.
    ends: [(bool, f64); 2],
}

impl Outlines {
    /// Joins the parts of polygons of several parts that have edges along the antimeridian on either side of it, if coordinates are
    /// longitudes and latitudes, and notes which polygons. Rings run across it then. Parts whose edges there do not match stay.
    ///
    /// O(n) for n points, and the square of the number of edges along the antimeridian in a polygon.
    pub fn join_at_antimeridian(&mut self) {
        if !self.is_geographic {
            return;
        }
        let (mut count, mut names) = (0, BTreeSet::new());
        let Ok(()) = self.each_shape(|parts| {
            let Some(whole) = joined(&parts) else { return Ok::<_, Infallible>(parts) };
            count += 1;
            names.extend(parts.into_iter().find_map(|part| part.name));
            Ok(whole)
        });
        if count > 0 {
            self.notes.push(format!("joined {} across 180° of longitude", told(count, names)));
        }
    }
}

/// The polygons of a shape with those joined whose edges along the antimeridian match; `None` if there are no such.
fn joined(parts: &[Feature]) -> Option<Vec<Feature>> {
    let mut runs: Vec<Run> = Vec::new();
    for (part, feature) in parts.iter().enumerate() {
        for (ring, drawn) in feature.rings.iter().enumerate() {
            runs.extend(runs_of([part, ring], drawn));
        }
    }
    // Each run goes on in the one that starts where it ends, beyond the antimeridian.
    let next: Option<Vec<usize>> = runs
        .iter()
        .map(|run| {
            let (is_below, latitude) = run.ends[1];
            let is_next = |other: &Run| {
                let start = other.ends[0];
                start.0 != is_below && (start.1 - latitude).abs() < NEAR
            };
            let mut found = (0..runs.len()).filter(|other| is_next(&runs[*other]));
            found.next().filter(|_| found.next().is_none())
        })
        .collect();
    let next = next.filter(|next| !next.is_empty())?;
    if next.iter().collect::<BTreeSet<_>>().len() < runs.len() {
        return None;
    }
    // The parts that hang together, each with the least of them.
    let mut whole: Vec<usize> = (0..parts.len()).collect();
    for (run, next) in runs.iter().zip(&next) {
        let mut both = [run.of[0], runs[*next].of[0]].map(|part| whole[part]);
        both.sort_unstable();
        whole.iter_mut().filter(|it| **it == both[1]).for_each(|it| *it = both[0]);
    }
    let cut: BTreeSet<[usize; 2]> = runs.iter().map(|run| run.of).collect();
    let mut features: Vec<Feature> =
        parts.iter().map(|part| Feature { rings: Vec::new(), ..part.clone() }).collect();
    let mut is_used = vec![false; runs.len()];
    for first in 0..runs.len() {
        let mut pieces = Vec::new();
        let mut at = first;
        while !std::mem::replace(&mut is_used[at], true) {
            pieces.extend(runs[at].pieces.iter().cloned());
            at = next[at];
        }
        if pieces.len() > 2 {
            features[whole[runs[first].of[0]]].rings.push(DrawnRing { pieces });
        }
    }
    for (part, feature) in parts.iter().enumerate() {
        let own = feature.rings.iter().enumerate();
        let uncut = own.filter(|(ring, _)| !cut.contains(&[part, *ring])).map(|(_, ring)| ring);
        features[whole[part]].rings.extend(uncut.cloned());
    }
    features.retain(|feature| !feature.rings.is_empty());
    for feature in &mut features {
        // What was one side of a hole, or of the outer ring, may have become the other.
        let areas: Vec<f64> = feature.rings.iter().map(area_running_on).collect();
        let outer = (0..areas.len()).max_by(|a, b| areas[*a].total_cmp(&areas[*b]));
        feature.rings.swap(0, outer.unwrap_or(0));
    }
    Some(features)
}

/// The runs of a ring that has edges along the antimeridian, and off it, each with the polygon on its left; a ring to a pole, or with
/// curves, is left as it is.
fn runs_of(of: [usize; 2], ring: &DrawnRing) -> Vec<Run> {
    let count = ring.pieces.len();
    let start = |ring: &DrawnRing, at: usize| ring.pieces[at % count].start;
    let is_along = |ring: &DrawnRing, at: usize| {
        let ends = [start(ring, at), start(ring, at + 1)];
        ends.iter().all(is_on) && (ends[0].x > 0.0) == (ends[1].x > 0.0)
    };
    let is_at_pole = |piece: &Piece| piece.start.y.abs() > 90.0 - NEAR;
    if !(0..count).any(|at| is_along(ring, at))
        || ring.pieces.iter().any(is_at_pole)
        || ring.is_curved()
    {
        return Vec::new();
    }
    // Rings may run either way round in a file; only with the polygon on the same side do parts of one go on in each other.
    let is_left = (ring.doubled_area() > 0.0) == (of[1] == 0);
    let ring = if is_left { Cow::Borrowed(ring) } else { Cow::Owned(turned_round(ring)) };
    let is_last = |at: &usize| is_along(&ring, *at) && !is_along(&ring, at + 1);
    let Some(first) = (0..count).find(is_last) else { return Vec::new() };
    let edges: Vec<usize> = (first + 1..=first + count).collect();
    let runs = edges.chunk_by(|a, b| is_along(&ring, *a) == is_along(&ring, *b));
    let end = |at: usize| (start(&ring, at).x > 0.0, start(&ring, at).y);
    runs.filter(|run| !is_along(&ring, run[0]))
        .map(|run| Run {
            of,
            pieces: run.iter().map(|at| ring.pieces[at % count].clone()).collect(),
            ends: [end(run[0]), end(run[run.len() - 1] + 1)],
        })
        .collect()
}

/// The ring of straight pieces, the other way round.
fn turned_round(ring: &DrawnRing) -> DrawnRing {
    let pieces = &ring.pieces;
    let piece = |at: usize| {
        let before = &pieces[(at + pieces.len() - 1) % pieces.len()];
        Piece { side: before.side.clone(), ..pieces[at].clone() }
    };
    DrawnRing { pieces: (0..pieces.len()).rev().map(piece).collect() }
}

/// Twice the area of a ring whose longitudes run on across the antimeridian, without a sign.
fn area_running_on(ring: &DrawnRing) -> f64 {
    ring_running_on(ring).map_or(0.0, |(ring, _)| ring.doubled_area().abs())
}

#[cfg(test)]
mod tests {
    use super::super::{TURN, cut};
    use super::*;
    use crate::{OutlineFormat, read};
    use glam::DVec2;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn joined(coordinates: &str) -> Outlines {
        let text = format!(r#"{{"type": "MultiPolygon", "coordinates": {coordinates}}}"#);
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let mut outlines = read(text.as_bytes(), OutlineFormat::GeoJson, alone).unwrap();
        outlines.join_at_antimeridian();
        outlines
    }

    fn points(ring: &DrawnRing) -> Vec<[f64; 2]> {
        ring.pieces.iter().map(|piece| piece.start.to_array()).collect()
    }

    proptest! {
        #[test]
        fn what_was_cut_is_joined_again(
            radii in vec(1.0_f64..20.0, 3..24),
            middle in 162.0_f64..198.0,
            latitude in -60.0_f64..60.0,
            has_lake in any::<bool>(),
        ) {
            let count = radii.len();
            let star = |share: f64| {
                let at = |(index, radius): (usize, &f64)| {
                    let turn = std::f64::consts::TAU * index as f64 / count as f64;
                    let off = DVec2::new(libm::cos(turn), libm::sin(turn)) * radius * share;
                    let x = middle + off.x;
                    DVec2::new(if x > 180.0 { x - TURN } else { x }, latitude + off.y)
                };
                DrawnRing::of_points(radii.iter().enumerate().map(at))
            };
            let rings = if has_lake { vec![star(1.0), star(0.5)] } else { vec![star(1.0)] };
            let whole = Feature { rings, ..Feature::default() };
            let area = |feature: &Feature| -> f64 {
                let areas: Vec<f64> = feature.rings.iter().map(area_running_on).collect();
                2.0 * areas[0] - areas.iter().sum::<f64>()
            };
            let Some(parts) = cut(&whole).unwrap() else { return Ok(()) };
            let found = super::joined(&parts).expect("all edges match");
            prop_assert_eq!(found.len(), 1);
            prop_assert_eq!(found[0].rings.len(), whole.rings.len());
            let (found, expected) = (area(&found[0]), area(&whole));
            prop_assert!((found - expected).abs() < 1e-6 * expected, "{} {}", found, expected);
        }
    }

    #[test]
    fn halves_of_a_square_are_one_ring() {
        let found = joined(
            "[[[[170,0],[180,0],[180,9],[170,9],[170,0]]], [[[-180,0],[-170,0],[-170,9],[-180,9],[-180,4],[-180,0]]]]",
        );
        assert_eq!(found.notes, ["joined 1 polygon across 180° of longitude"]);
        assert_eq!(found.features.len(), 1);
        let square =
            [[180.0, 9.0], [170.0, 9.0], [170.0, 0.0], [-180.0, 0.0], [-170.0, 0.0], [-170.0, 9.0]];
        assert_eq!(points(&found.features[0].rings[0]), square);
    }

    #[test]
    fn a_lake_across_is_a_hole_and_those_beside_it_stay() {
        // A square whose lake was cut, too, so that each half goes round it, with an island's hole in the west.
        let found = joined(
            "[[[[170,0],[180,0],[180,3],[177,4],[180,6],[180,9],[170,9],[170,0]], [[172,2],[172,3],[173,3],[172,2]]], \
              [[[-180,0],[-170,0],[-170,9],[-180,9],[-180,6],[-178,4],[-180,3],[-180,0]]]]",
        );
        assert_eq!(found.features.len(), 1);
        let rings = &found.features[0].rings;
        assert_eq!(rings.iter().map(|ring| ring.pieces.len()).collect::<Vec<_>>(), [6, 4, 3]);
        assert_eq!(points(&rings[1]), [[180.0, 3.0], [177.0, 4.0], [-180.0, 6.0], [-178.0, 4.0]]);
    }

    #[test]
    fn what_does_not_match_stays() {
        // One half alone, halves of other latitudes, and polygons that are no parts of one.
        for text in [
            "[[[[170,0],[180,0],[180,9],[170,9],[170,0]]]]",
            "[[[[170,0],[180,0],[180,9],[170,9],[170,0]]], [[[-180,0],[-170,0],[-170,8],[-180,8],[-180,0]]]]",
        ] {
            let found = joined(text);
            assert!(found.notes.is_empty());
            assert_eq!(found.features.len(), text.matches("[[[").count());
        }
    }
}
