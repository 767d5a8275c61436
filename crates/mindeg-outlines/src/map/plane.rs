//! Borders as edges between vertices: where they meet, and what is on their sides.

use std::collections::BTreeSet;

use glam::DVec2;
use mindeg_domain::InnerPoint;
use mindeg_mesh::planar::orientation;

use super::Border;
use crate::curve::PieceCurve;
use crate::error::OutlineError;
use crate::loops::reversed;
use crate::outline::{DrawnRing, Piece};
use crate::overlay::ROUNDING;
use crate::overlay::crossings::{MOST_COMPARISONS, meeting, meetings};
use crate::overlay::edge::{Edge, Step};
use crate::overlay::faces::{Graph, Link, links};
use crate::overlay::near::near_vertices;
use crate::text::shown;
use crate::vertices::Vertices;

/// Borders as straight edges between vertices. As a half-edge, `2 * link` runs from the first end of a link to the
/// second and `2 * link + 1` back.
pub(super) struct Plane<'a> {
    pub(super) borders: &'a [Border],
    names: &'a [String],
    pub(super) points: Vec<DVec2>,
    pub(super) chords: Vec<Chord>,
    pub(super) links: Vec<Link>,
    /// Whether the file begins a side at a vertex, or other than two edges meet there.
    begins_side: Vec<bool>,
    pub(super) is_node: Vec<bool>,
}

/// A straight border, or a piece of a curved one.
pub(super) struct Chord {
    pub(super) border: u32,
    /// Which of how many of the border it is.
    part: (usize, usize),
    pub(super) ends: [u32; 2],
}

/// A run of chords from vertex to vertex.
pub(super) struct Run {
    pub(super) steps: Vec<Step>,
    /// The vertex where it ends; of a closed one, the one where it starts.
    pub(super) end: u32,
}

impl Run {
    pub(super) fn is_closed(&self) -> bool {
        self.steps.first().is_some_and(|step| step.from == self.end)
    }
}

impl<'a> Plane<'a> {
    /// Borders that meet at their ends alone, between regions with these names.
    pub(super) fn new(borders: &'a [Border], names: &'a [String]) -> Result<Self, OutlineError> {
        let ends = borders.iter().map(|border| border.segment.start.abs().max_element());
        // Points are compared bit for bit; the tolerance only decides how many are looked at.
        let mut vertices = Vertices::new(DVec2::ZERO, f64::EPSILON * ends.fold(0.0, f64::max));
        let (mut chords, mut edges, mut begins) = (Vec::new(), Vec::new(), Vec::new());
        for (index, Border { segment, begins_side, .. }) in (0..).zip(borders) {
            let count = segment.intervals_by_turning();
            let at = |i: u32| segment.point(f64::from(i) / f64::from(count));
            let own: Vec<u32> = (0..=count).map(|i| vertices.index(at(i))).collect();
            begins.extend(begins_side.then_some(own[0]));
            for (part, pair) in own.windows(2).enumerate() {
                let ends = [pair[0], pair[1]];
                edges.push(Edge { ends, chord: chords.len() as u32 });
                chords.push(Chord { border: index, part: (part, count as usize), ends });
            }
        }
        let points = vertices.points;
        let mut degree = vec![0_u32; points.len()];
        edges.iter().flat_map(|edge| edge.ends).for_each(|end| degree[end as usize] += 1);
        let is_node: Vec<bool> = degree.into_iter().map(|degree| degree != 2).collect();
        let mut begins_side = is_node.clone();
        begins.into_iter().for_each(|vertex| begins_side[vertex as usize] = true);
        let (links, _) = links(&edges, |_| 0);
        let plane = Self { borders, names, points, chords, links, begins_side, is_node };
        plane.check_meetings(&edges)?;
        Ok(plane)
    }

    /// The region on the left of a half-edge.
    pub(super) fn left(&self, half: usize) -> Option<u32> {
        let link = &self.links[half / 2];
        let is_forward = link.forward == half.is_multiple_of(2);
        self.border(link.edge.chord).beside[usize::from(!is_forward)]
    }

    /// The region on the left of a step.
    pub(super) fn left_of(&self, step: &Step) -> Option<u32> {
        self.border(step.chord).beside[usize::from(!step.forward)]
    }

    /// The region on the right of a step.
    pub(super) fn right_of(&self, step: &Step) -> Option<u32> {
        self.border(step.chord).beside[usize::from(step.forward)]
    }

    pub(super) fn border(&self, chord: u32) -> &'a Border {
        &self.borders[self.chords[chord as usize].border as usize]
    }

    /// The step of a half-edge.
    pub(super) fn step(&self, half: usize) -> Step {
        let Link { ends, edge, forward } = self.links[half / 2];
        let forward = forward == half.is_multiple_of(2);
        Step { from: ends[half % 2], chord: edge.chord, forward }
    }

    pub(super) fn ends(&self, chord: u32) -> [DVec2; 2] {
        self.chords[chord as usize].ends.map(|end| self.points[end as usize])
    }

    /// Refuses edges that meet elsewhere than at ends of both.
    fn check_meetings(&self, edges: &[Edge]) -> Result<(), OutlineError> {
        let mut budget = MOST_COMPARISONS;
        let meetings = meetings(edges, &self.points, &mut budget);
        let meetings = meetings.map_err(|problem| OutlineError::place("", problem))?;
        if let Some((&one, points)) = meetings.first_key_value() {
            let others = (0..edges.len()).filter(|&other| other != one);
            let mut ends = others.map(|other| (other, self.ends(other as u32)));
            let own = self.ends(one as u32);
            let other = ends.find(|&(_, ends)| !meeting(own, ends).is_empty());
            let at = points.first().copied().unwrap_or(own[0]);
            let other = other.map_or(one, |(other, _)| other);
            return Err(self.crossing(at, one as u32, other as u32));
        }
        if self.links.len() < edges.len() {
            let mut kept = vec![false; edges.len()];
            self.links.iter().for_each(|link| kept[link.edge.chord as usize] = true);
            let twice = kept.iter().position(|kept| !kept).unwrap_or_default() as u32;
            if self.border(twice).beside == [None; 2] {
                let [from, to] = self.ends(twice).map(shown);
                let place = format!("the edge from {from} to {to}");
                let problem = "a line runs along another one, or along a border";
                let error = OutlineError::place(place, problem).telling(self.ends(twice));
                return Err(OutlineError { is_touch: true, ..error });
            }
            return Err(self.crossing(self.ends(twice)[0], twice, twice));
        }
        Ok(())
    }

    /// Refuses lines and points that lie on an edge, as near as rounding brings them, without a vertex there: no triangle beside it would
    /// have an area.
    pub(super) fn check_near(&self, points: &[InnerPoint]) -> Result<(), OutlineError> {
        let is_line = |chord: u32| self.border(chord).beside == [None; 2];
        let chords = 0..self.chords.len() as u32;
        let ends = |chord: u32| self.chords[chord as usize].ends;
        let of_lines: BTreeSet<u32> =
            chords.clone().filter(|chord| is_line(*chord)).flat_map(ends).collect();
        if of_lines.is_empty() && points.is_empty() {
            return Ok(());
        }
        let edges: Vec<Edge> = chords.map(|chord| Edge { ends: ends(chord), chord }).collect();
        let inner = points.iter().map(|point| point.at);
        let all: Vec<DVec2> = self.points.iter().copied().chain(inner).collect();
        let greatest = all.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
        for (edge, near) in near_vertices(&edges, &all, ROUNDING * greatest) {
            let ends = self.ends(edges[edge].chord);
            let counts = |vertex: &u32| {
                let is_point = *vertex as usize >= self.points.len();
                (is_point || of_lines.contains(vertex) || is_line(edges[edge].chord))
                    && !ends.contains(&all[*vertex as usize])
            };
            if let Some(vertex) = near.into_iter().find(counts) {
                let [from, to] = ends.map(shown);
                let problem =
                    format!("it lies on the edge from {from} to {to}, which has no vertex there");
                let at = all[vertex as usize];
                let error = OutlineError::place(shown(at), problem).telling([at, ends[0], ends[1]]);
                return Err(OutlineError { is_touch: true, ..error });
            }
        }
        Ok(())
    }

    fn crossing(&self, at: DVec2, one: u32, other: u32) -> OutlineError {
        let whose = |chord: u32| {
            let beside = self.border(chord).beside;
            let names: Vec<&str> =
                beside.iter().flatten().map(|&region| &*self.names[region as usize]).collect();
            (!names.is_empty()).then(|| names.join(" and "))
        };
        let meets = match (whose(one), whose(other)) {
            (Some(one), Some(other)) => format!("a border of {one} meets one of {other}"),
            (Some(whose), None) | (None, Some(whose)) => {
                format!("a line meets a border of {whose}")
            }
            (None, None) => "a line meets another".to_owned(),
        };
        let problem = format!("{meets} there, and one of them has no point there");
        OutlineError { is_touch: true, ..OutlineError::place(shown(at), problem).telling([at]) }
    }

    /// Refuses regions that overlap, and lines outside all regions.
    pub(super) fn check_sides(&self, graph: &Graph<'_>) -> Result<(), OutlineError> {
        let has = |half: usize| i64::from(self.left(half).is_some());
        // All regions are one layer: where it winds twice, two overlap.
        let change = |link: usize| match has(2 * link) - has(2 * link + 1) {
            0 => Vec::new(),
            change => vec![(0, change)],
        };
        let changes: Vec<_> = (0..self.links.len()).map(change).collect();
        let windings = graph.windings(&changes);
        let windings = windings.map_err(|problem| OutlineError::place("", problem))?;
        for (half, &winding) in windings.left.iter().enumerate() {
            let winding = windings.all[winding as usize].first().map_or(0, |layer| layer.1);
            let own = [half, half ^ 1].map(|half| self.left(half));
            let [from, to] = self.ends(self.links[half / 2].edge.chord);
            let is_line = own == [None; 2];
            if winding == 1 && is_line || winding == has(half) && !is_line {
                continue;
            }
            let middle = from + (to - from) / 2.0;
            let place = format!("the edge from {} to {}", shown(from), shown(to));
            let name = |region: u32| &*self.names[region as usize];
            let others = self.regions_around(middle);
            let mut others = others.into_iter().filter(|&other| !own.contains(&Some(other)));
            let error = match (own[0].or(own[1]), others.next()) {
                (None, Some(_)) | (None, None) if is_line && winding < 1 => OutlineError::place(
                    place,
                    "this line lies outside all regions; drop it, or draw a region around it",
                ),
                (Some(one), Some(other)) => super::borders::overlap(place, name(one), name(other)),
                (Some(one), None) => {
                    let problem = format!("a hole of {} lies outside it", name(one));
                    OutlineError { is_touch: true, ..OutlineError::place(place, problem) }
                }
                (None, _) => OutlineError::place(place, "regions overlap there"),
            };
            return Err(error.telling([from, to]));
        }
        Ok(())
    }

    /// The regions whose borders a ray from a point to the right crosses an odd number of times.
    pub(super) fn regions_around(&self, point: DVec2) -> Vec<u32> {
        let mut is_inside = vec![false; self.names.len()];
        for chord in 0..self.chords.len() as u32 {
            let [a, b] = self.ends(chord);
            if (a.y > point.y) != (b.y > point.y) && (orientation(a, b, point) > 0.0) == (b.y > a.y)
            {
                let beside = self.border(chord).beside.into_iter().flatten();
                beside.for_each(|region| is_inside[region as usize] ^= true);
            }
        }
        (0..).zip(is_inside).filter(|(_, inside)| *inside).map(|(region, _)| region).collect()
    }

    /// The pieces of a run; those of an open one and one more, which starts where it ends. `name` gives names of sides.
    pub(super) fn drawn<N>(&self, run: &Run, mut name: N) -> DrawnRing
    where
        N: FnMut(&Border) -> Option<std::sync::Arc<str>>,
    {
        let mut pieces = Vec::with_capacity(run.steps.len() + 1);
        let mut rest = &run.steps[..];
        while let [step, ..] = rest {
            let border = self.border(step.chord);
            let whole = self.whole(rest);
            let curve = match (border.segment.curve, step.forward) {
                (_, _) if whole.is_none() => PieceCurve::Line,
                (curve, true) => curve,
                (curve, false) => reversed(curve),
            };
            pieces.push(Piece {
                start: self.points[step.from as usize],
                curve,
                side: name(border),
                begins_side: self.begins_side[step.from as usize],
            });
            rest = &rest[whole.unwrap_or(1)..];
        }
        if !run.is_closed() {
            pieces.push(Piece::line(self.points[run.end as usize]));
        }
        DrawnRing { pieces }
    }

    /// The number of chords of a border, if steps begin with all of them in order.
    fn whole(&self, steps: &[Step]) -> Option<usize> {
        let first = steps.first()?;
        let Chord { border, part: (_, count), .. } = self.chords[first.chord as usize];
        let is_next = |(index, step): (usize, &Step)| {
            let chord = &self.chords[step.chord as usize];
            let part = if first.forward { index } else { count - 1 - index };
            chord.border == border && chord.part.0 == part && step.forward == first.forward
        };
        let own = steps.get(..count)?;
        own.iter().enumerate().all(is_next).then_some(count)
    }
}
