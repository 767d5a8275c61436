//! A lower bound on the maximum degree: too many boundary edges for the vertices that see them.
//!
//! Let R be the boundary edges that are not sides of an ear. Each has a triangle, and its apex sees
//! both of its ends. A vertex of degree D has D-1 triangles, of which the first and the last have a
//! boundary edge at the vertex itself; if their opposite side were a boundary edge too, they would
//! be ears. So a vertex is apex to at most D-3 edges of R. If only the vertices A can be apexes of
//! the edges S of R, then D >= 3 + |S|/|A|, rounded up. For a convex polygon with one long side
//! this is Liu's bound.
//!
//! The best S comes from a matching of edges to apexes: if a further edge finds no place, the edges
//! and apexes that alternating paths reach from it are S and A (Hall).

use crate::chords::Lists;
use std::cmp::Ordering;
use std::collections::VecDeque;

/// Boundary edges and all vertices that can be their apexes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ApexBound {
    /// The edges, from vertex `e` to the next one of its ring; no edge is a side of an ear.
    pub edges: Vec<u32>,
    /// The vertices that see both ends of one of them.
    pub apexes: Vec<u32>,
}

impl ApexBound {
    /// The maximum degree that this proves to be necessary.
    #[must_use]
    pub fn max_degree(&self) -> u32 {
        3 + self.edges.len().div_ceil(self.apexes.len().max(1)) as u32
    }
}

const UNSEEN: u32 = u32::MAX;

struct Matching {
    /// The boundary edges that are not sides of an ear.
    edges: Vec<u32>,
    /// For each of them, the start of its apexes in `apexes`.
    offsets: Vec<u32>,
    apexes: Vec<u32>,
    /// For each vertex the indices of the edges that it is apex to.
    taken: Vec<Vec<u32>>,
    is_placed: Vec<bool>,
    edge_level: Vec<u32>,
    apex_level: Vec<u32>,
}

/// The best bound of this kind above degree 4, from the next vertex of each on its ring and all edges
/// that a triangulation may have. At most O(edges * sqrt(vertices)) times the bound, by Hopcroft and
/// Karp's phases.
pub(crate) fn apex_bound(
    next: &[u32],
    edges: impl Iterator<Item = [u32; 2]> + Clone,
) -> Option<ApexBound> {
    let mut matching = Matching::new(next, edges);
    let mut best = None;
    let mut capacity = 1;
    loop {
        if matching.levels(capacity) {
            matching.augment(capacity);
        } else if matching.is_placed.iter().all(|&is_placed| is_placed) {
            return best;
        } else {
            let witness = matching.witness();
            if witness.apexes.is_empty() {
                return best;
            }
            capacity = witness.max_degree() as usize - 3;
            best = Some(witness);
        }
    }
}

impl Matching {
    fn new(next: &[u32], edges: impl Iterator<Item = [u32; 2]> + Clone) -> Self {
        let n = next.len() as u32;
        let mut counts = vec![0; next.len()];
        edges.clone().flatten().for_each(|vertex| counts[vertex as usize] += 1);
        let mut neighbours = Lists::new(&counts);
        for [i, j] in edges {
            neighbours.push(i, j);
            neighbours.push(j, i);
        }
        neighbours.sort();
        let mut previous = vec![0; next.len()];
        (0..n).zip(next).for_each(|(from, &to)| previous[to as usize] = from);
        let joins = |a: u32, b: u32| neighbours.of(a).binary_search(&b).is_ok();
        let mut matching = Self {
            edges: Vec::new(),
            offsets: vec![0],
            apexes: Vec::new(),
            taken: vec![Vec::new(); n as usize],
            is_placed: Vec::new(),
            edge_level: Vec::new(),
            apex_level: vec![UNSEEN; n as usize],
        };
        for from in 0..n {
            let to = next[from as usize];
            if joins(previous[from as usize], to) || joins(from, next[to as usize]) {
                continue;
            }
            matching.edges.push(from);
            let (a, b) = (neighbours.of(from), neighbours.of(to));
            let (mut x, mut y) = (0, 0);
            while x < a.len() && y < b.len() {
                match a[x].cmp(&b[y]) {
                    Ordering::Less => x += 1,
                    Ordering::Greater => y += 1,
                    Ordering::Equal => {
                        matching.apexes.push(a[x]);
                        x += 1;
                        y += 1;
                    }
                }
            }
            matching.offsets.push(matching.apexes.len() as u32);
        }
        matching.is_placed = vec![false; matching.edges.len()];
        matching.edge_level = vec![UNSEEN; matching.edges.len()];
        matching
    }

    /// Numbers edges and apexes by their distance from the edges without a place. Returns whether
    /// it reaches an apex with free space.
    fn levels(&mut self, capacity: usize) -> bool {
        self.edge_level.fill(UNSEEN);
        self.apex_level.fill(UNSEEN);
        let mut open = VecDeque::new();
        for (edge, _) in self.is_placed.iter().enumerate().filter(|&(_, &is_placed)| !is_placed) {
            self.edge_level[edge] = 0;
            open.push_back(edge as u32);
        }
        let mut has_space = false;
        while let Some(edge) = open.pop_front() {
            let level = self.edge_level[edge as usize];
            for index in self.offsets[edge as usize]..self.offsets[edge as usize + 1] {
                let apex = self.apexes[index as usize] as usize;
                if self.apex_level[apex] != UNSEEN {
                    continue;
                }
                self.apex_level[apex] = level + 1;
                has_space |= self.taken[apex].len() < capacity;
                for &next in &self.taken[apex] {
                    if self.edge_level[next as usize] == UNSEEN {
                        self.edge_level[next as usize] = level + 2;
                        open.push_back(next);
                    }
                }
            }
        }
        has_space
    }

    /// Places edges along shortest paths, each of which moves other edges to their next apex.
    fn augment(&mut self, capacity: usize) {
        let mut next_apex: Vec<u32> = self.offsets[..self.edges.len()].to_vec();
        for first in 0..self.edges.len() as u32 {
            if self.is_placed[first as usize] {
                continue;
            }
            // Edges, each with its index in the list of the apex that the edge before it takes.
            let mut path: Vec<(u32, usize)> = vec![(first, 0)];
            while let Some(&(edge, _)) = path.last() {
                let index = next_apex[edge as usize];
                if index == self.offsets[edge as usize + 1] {
                    self.edge_level[edge as usize] = UNSEEN;
                    path.pop();
                    continue;
                }
                let apex = self.apexes[index as usize] as usize;
                let level = self.edge_level[edge as usize];
                if self.apex_level[apex] != level + 1 {
                    next_apex[edge as usize] += 1;
                } else if self.taken[apex].len() < capacity {
                    self.taken[apex].push(edge);
                    for pair in path.windows(2) {
                        let [(before, _), (_, place)] = [pair[0], pair[1]];
                        let apex = self.apexes[next_apex[before as usize] as usize] as usize;
                        self.taken[apex][place] = before;
                    }
                    self.is_placed[first as usize] = true;
                    break;
                } else {
                    let beyond = self.taken[apex].iter().enumerate();
                    let mut beyond =
                        beyond.filter(|&(_, &next)| self.edge_level[next as usize] == level + 2);
                    match beyond.next() {
                        Some((place, &next)) => path.push((next, place)),
                        None => next_apex[edge as usize] += 1,
                    }
                }
            }
            // No other path of this phase may have the edges of this one.
            if self.is_placed[first as usize] {
                for (edge, _) in path {
                    self.edge_level[edge as usize] = UNSEEN;
                }
            }
        }
    }

    /// The edges and apexes of the last levels, if no apex had free space.
    fn witness(&self) -> ApexBound {
        let seen = |levels: &[u32]| -> Vec<u32> {
            let seen = levels.iter().enumerate().filter(|&(_, &level)| level != UNSEEN);
            seen.map(|(index, _)| index as u32).collect()
        };
        let edges = seen(&self.edge_level).into_iter();
        ApexBound {
            edges: edges.map(|edge| self.edges[edge as usize]).collect(),
            apexes: seen(&self.apex_level),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chords::Chords;
    use crate::sides::Sides;
    use mindeg_core::{Boundary, least_max_degree};

    fn of_chords(chords: &Chords) -> Option<ApexBound> {
        let n = chords.vertex_count() as u32;
        let next: Vec<u32> = (0..n).map(|vertex| (vertex + 1) % n).collect();
        apex_bound(&next, chords.ends())
    }

    /// Every apex of the edges is in the bound.
    fn check(chords: &Chords, bound: &ApexBound) {
        let n = chords.vertex_count() as u32;
        let joins = |a: u32, b: u32| a != b && chords.has(a.min(b), a.max(b));
        for &from in &bound.edges {
            let to = (from + 1) % n;
            assert!(!joins((from + n - 1) % n, to) && !joins(from, (to + 1) % n));
            for apex in (0..n).filter(|&apex| joins(apex, from) && joins(apex, to)) {
                assert!(bound.apexes.contains(&apex));
            }
        }
    }

    #[test]
    fn it_is_lius_bound_where_one_side_dominates() {
        for (sides, least) in [
            (&[30, 2, 4, 2][..], 7),
            (&[100, 3, 3, 3], 16),
            (&[20, 1, 1, 1], 12),
            (&[40, 3, 3], 11),
        ] {
            let boundary = Boundary::new(sides).unwrap();
            let n = boundary.vertex_count() as usize;
            let chords = Chords::all(n, &Sides::of_boundary(&boundary));
            let bound = of_chords(&chords).unwrap();
            check(&chords, &bound);
            assert_eq!(least_max_degree(&boundary), least, "{sides:?}");
            assert_eq!(bound.max_degree(), least, "{sides:?}");
        }
    }

    #[test]
    fn it_never_exceeds_the_least() {
        for a in 1..9 {
            for b in 1..6 {
                for c in 1..6 {
                    let boundary = Boundary::new(&[a, b, c, 2]).unwrap();
                    let n = boundary.vertex_count() as usize;
                    let chords = Chords::all(n, &Sides::of_boundary(&boundary));
                    if let Some(bound) = of_chords(&chords) {
                        check(&chords, &bound);
                        assert!(bound.max_degree() > 4);
                        assert!(bound.max_degree() <= least_max_degree(&boundary));
                    }
                }
            }
        }
    }
}
