//! Round several holes the domain is cut along bridges until one hole is left.
//!
//! The vertex of a hole that is farthest in some direction has a *bridge* to another ring in every triangulation: of the
//! triangle there that looks out in this direction one corner at least is beyond all of the hole. Cut along one of these
//! bridges, the two rings are one:
//!
//! ```text
//!     o' <---- o <---- o"            o' <---- o  o <---- o"       the outer ring
//!              |                              |  |
//!     i' ----> i ----> i"            i' ----> i  i ----> i"       the ring of the hole
//! ```
//!
//! Both ends are there twice and share their chords. That each copy has the room of both is tried first: it nearly
//! always refutes, and what it finds nearly always keeps the limits.

use super::candidates::{Candidate, Candidates};
use super::caps::{NONE, Rings};
use crate::progress::Stage;
use glam::DVec2;
use mindeg_mesh::Cancelled;
use mindeg_mesh::planar::orientation;

/// A triangulation, if there is one, where that is known.
pub(super) type Decided = Option<Option<Vec<[u32; 3]>>>;

impl Candidates {
    /// A triangulation that keeps the numbers of chords, if there is one; none without holes, and if the steps are too few to know.
    pub(super) fn decide(
        &self,
        next: &[u32],
        most: &[u32],
        left: &mut u64,
        stage: &Stage<'_>,
    ) -> Result<Decided, Cancelled> {
        let Some(rings) = Rings::new(self, next, most) else { return Ok(None) };
        let work = self.triangles.len() * rings.stride;
        let Some(rest) = left.checked_sub(work as u64) else { return Ok(None) };
        *left = rest;
        match rings.lengths.len() {
            0 | 1 => Ok(None),
            2 => rings.decide_around(left, stage),
            _ => rings.decide_cut(left, stage),
        }
    }

    /// The face cut along a chord between two rings, with the triangles that may be left. Each end is there twice: under its own
    /// number with what is on the right of the chord that leaves it, and under one of the two numbers after all others with what
    /// is on the left.
    fn cut(&self, next: &[u32], chord: u32) -> (Self, Vec<u32>) {
        let n = self.points.len() as u32;
        let ends = self.chords[chord as usize];
        let at = |vertex: u32| self.points[vertex as usize];
        let is_right = |end: usize, to: u32| {
            let [own, other] = [ends[end], ends[1 - end]];
            let first = next[own as usize];
            to == first || to != other && is_between(at(own), [first, to, other].map(at))
        };
        let side = |vertex: u32, to: u32| match ends.iter().position(|&end| end == vertex) {
            Some(end) if !is_right(end, to) => n + end as u32,
            _ => vertex,
        };
        let line = ends.map(at);
        let is_apart = |[from, to]: [DVec2; 2], points: [DVec2; 2]| {
            let [a, b] = points.map(|point| orientation(from, to, point));
            a > 0.0 && b < 0.0 || a < 0.0 && b > 0.0
        };
        let crosses = |other: &[u32; 2]| {
            let other = other.map(at);
            is_apart(line, other) && is_apart(other, line)
        };
        let is_crossed: Vec<bool> = self.chords.iter().map(crosses).collect();
        let count = self.chords.len();
        let triangle = |triangle: &Candidate| {
            let ([a, b, c], mut edges) = (triangle.corners, triangle.edges);
            let corners = [side(a, b), side(b, c), side(c, a)];
            for (edge, corner) in edges.iter_mut().zip(corners) {
                if *edge == chord || *edge as usize >= count {
                    *edge = count as u32 + corner;
                } else if is_crossed[*edge as usize] {
                    return None;
                }
            }
            Some(Candidate { corners, edges })
        };
        let chords = self.chords.iter().map(|&[a, b]| {
            let mut ends = [side(a, b), side(b, a)];
            ends.sort_unstable();
            ends
        });
        let with_ends = |list: &[u32]| [list, &ends.map(|end| list[end as usize])].concat();
        let mut after = next.to_vec();
        for (copy, end) in (n..).zip(ends) {
            next.iter()
                .zip(&mut after)
                .filter(|(to, _)| **to == end)
                .for_each(|(_, to)| *to = copy);
        }
        after.extend([ends[1], ends[0]]);
        let face = Self {
            vertices: with_ends(&self.vertices),
            points: [&self.points[..], &line].concat(),
            chords: chords.collect(),
            triangles: self.triangles.iter().filter_map(triangle).collect(),
            chord_count: self.chord_count - 1,
        };
        (face.pruned(), after)
    }
}

impl Rings<'_> {
    /// A triangulation that keeps the numbers of chords round several holes.
    fn decide_cut(&self, left: &mut u64, stage: &Stage<'_>) -> Result<Decided, Cancelled> {
        let face = self.possible();
        let n = face.points.len();
        let bridges = self.first_bridges(&face);
        for (index, &bridge) in bridges.iter().enumerate() {
            let stage = stage.part(index, bridges.len());
            let ends = face.chords[bridge as usize];
            // The cut is a chord at both ends.
            let [Some(room), Some(other_room)] =
                ends.map(|end| self.most[end as usize].checked_sub(1))
            else {
                continue;
            };
            let (cut, next) = face.cut(self.next, bridge);
            let tries = (0..=room).flat_map(|own| {
                (0..=other_room).map(move |other| [[own, room - own], [other, other_room - other]])
            });
            let all = [[room, room], [other_room, other_room]];
            let tries: Vec<[[u32; 2]; 2]> = std::iter::once(all).chain(tries).collect();
            for (index, &shares) in tries.iter().enumerate() {
                let stage = stage.part(index, tries.len());
                let mut most = self.most.to_vec();
                most.extend(shares.map(|[_, copy]| copy));
                for (end, [own, _]) in ends.iter().zip(shares) {
                    most[*end as usize] = own;
                }
                let found = match cut.decide(&next, &most, left, &stage)? {
                    None => return Ok(None),
                    Some(None) if index == 0 => break,
                    Some(None) => continue,
                    Some(Some(found)) => found,
                };
                let whole = |v: u32| ends.get((v as usize).wrapping_sub(n)).copied().unwrap_or(v);
                let found: Vec<[u32; 3]> = found.iter().map(|corners| corners.map(whole)).collect();
                let chords =
                    |end: u32| found.iter().filter(|corners| corners.contains(&end)).count() - 1;
                if ends.iter().all(|&end| chords(end) <= self.most[end as usize] as usize) {
                    return Ok(Some(Some(found)));
                }
            }
        }
        Ok(Some(None))
    }

    /// The bridges of a vertex that has one in every triangulation: of the farthest vertices of the holes that which has the fewest.
    pub(super) fn first_bridges(&self, face: &Candidates) -> Vec<u32> {
        let n = face.points.len();
        let mut is_used = vec![false; face.chords.len() + n];
        let edges = face.triangles.iter().flat_map(|triangle| triangle.edges);
        edges.for_each(|edge| is_used[edge as usize] = true);
        let ring_of = |vertex: u32| self.ring_of[vertex as usize];
        let mut of = vec![Vec::new(); n];
        for (index, &[a, b]) in (0..).zip(&face.chords) {
            if is_used[index as usize] && ring_of(a) != ring_of(b) {
                [a, b].iter().for_each(|&end| of[end as usize].push(index));
            }
        }
        // A product with an axis is a coordinate.
        let along = |v: &usize, axis: DVec2| face.points[*v].dot(axis);
        let farthest = (1..self.lengths.len() as u32).flat_map(|ring| {
            [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|axis| {
                let own = (0..n).filter(|&v| self.ring_of[v] == ring);
                own.max_by(|a, b| along(a, axis).total_cmp(&along(b, axis)))
            })
        });
        let fewest = farthest.flatten().min_by_key(|&vertex| of[vertex].len());
        fewest.map_or(Vec::new(), |vertex| std::mem::take(&mut of[vertex]))
    }

    /// The face without the triangles at chords whose caps have triangulations but none that keeps the numbers of chords.
    fn possible(&self) -> Candidates {
        let mut is_cap = vec![false; 2 * self.face.chords.len()];
        for root in &self.roots {
            let ([a, _, c], [_, bc, ca]) = self.corners(root);
            let is_whole = [(ca, a), (bc, c)].iter().all(|&(edge, from)| {
                !self.is_chord(edge) || is_cap[self.directed(edge, from) as usize]
            });
            is_cap[root.chord as usize] |= is_whole;
        }
        let is_empty = |chord: usize| self.caps[(chord + 1) * self.stride - 1] == NONE;
        let is_possible = |edge: u32| {
            !self.is_chord(edge)
                || [0, 1].iter().all(|side| {
                    let chord = 2 * edge as usize + side;
                    !is_cap[chord] || !is_empty(chord)
                })
        };
        self.face.among(|triangle| triangle.edges.iter().all(|&edge| is_possible(edge)))
    }
}

/// Whether the second of three directions from a point comes before the third on the way round from the first,
/// counter-clockwise.
fn is_between(at: DVec2, [from, to, until]: [DVec2; 3]) -> bool {
    if orientation(at, from, until) > 0.0 {
        orientation(at, from, to) >= 0.0 && orientation(at, to, until) > 0.0
    } else {
        !(orientation(at, until, to) >= 0.0 && orientation(at, to, from) > 0.0)
    }
}
