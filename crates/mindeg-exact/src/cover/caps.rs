//! The rings of a domain: the caps that chords of one ring cut off, and with two rings the steps between bridges.

use super::candidates::{Candidate, Candidates, rings};

/// No number of chords.
pub(super) const NONE: u8 = u8::MAX;

/// A chord from one of its ends to the other: twice its index, and one more from the larger end.
pub(super) type Directed = u32;

/// A step of the strip from a bridge to the next.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) to: u32,
    /// Along the ring of the hole, or else along the outer one.
    pub(super) is_inner: bool,
    /// The edges of the ring that are passed.
    pub(super) passed: u32,
    /// The chord that cuts them off; none for a boundary edge.
    pub(super) cap: Option<Directed>,
    pub(super) triangle: u32,
}

/// A triangle on the inner side of a cap's chord, a to b, with the corner where it has a.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Root {
    /// The edges of the ring in the cap.
    pub(super) length: u32,
    pub(super) chord: Directed,
    pub(super) triangle: u32,
    pub(super) turn: u32,
}

pub(super) struct Rings<'a> {
    pub(super) face: &'a Candidates,
    /// For each vertex the one after it on its ring.
    pub(super) next: &'a [u32],
    pub(super) most: &'a [u32],
    /// The ring of each vertex; the first is the outer one.
    pub(super) ring_of: Vec<u32>,
    /// The index of each vertex on its ring, in the direction of the boundary.
    at: Vec<u32>,
    pub(super) lengths: Vec<u32>,
    /// One more than the largest number of chords.
    pub(super) stride: usize,
    /// The ways to divide the caps, those of the smallest first.
    pub(super) roots: Vec<Root>,
    /// For each directed chord a to b and each number of chords at a the least number at b, within the cap on the left.
    pub(super) caps: Vec<u8>,
    /// With two rings the steps from each chord that is a bridge.
    pub(super) steps: Vec<Vec<Step>>,
}

impl<'a> Rings<'a> {
    /// None if a vertex may have too many chords.
    pub(super) fn new(face: &'a Candidates, next: &'a [u32], most: &'a [u32]) -> Option<Self> {
        let stride = most.iter().max().map_or(0, |&most| most as usize) + 1;
        if stride >= usize::from(NONE) {
            return None;
        }
        let n = face.points.len();
        let (mut ring_of, mut at) = (vec![0; n], vec![0; n]);
        let rings = rings(&face.points, next);
        for (index, ring) in (0..).zip(&rings) {
            for (along, &vertex) in (0..).zip(ring) {
                (ring_of[vertex as usize], at[vertex as usize]) = (index, along);
            }
        }
        let lengths = rings.iter().map(|ring| ring.len() as u32).collect();
        let caps = vec![NONE; 2 * face.chords.len() * stride];
        let steps = vec![Vec::new(); face.chords.len()];
        let roots = Vec::new();
        let mut rings = Self { face, next, most, ring_of, at, lengths, stride, roots, caps, steps };
        rings.roots = rings.find_roots();
        rings.fill_caps();
        if rings.lengths.len() == 2 {
            rings.find_steps();
        }
        Some(rings)
    }

    pub(super) fn is_outer(&self, vertex: u32) -> bool {
        self.ring_of[vertex as usize] == 0
    }

    pub(super) fn is_chord(&self, edge: u32) -> bool {
        (edge as usize) < self.face.chords.len()
    }

    pub(super) fn directed(&self, edge: u32, from: u32) -> Directed {
        2 * edge + u32::from(self.face.chords[edge as usize][0] != from)
    }

    /// How far along its ring it is from one vertex to another.
    pub(super) fn along(&self, from: u32, to: u32) -> u32 {
        let length = self.lengths[self.ring_of[from as usize] as usize];
        (self.at[to as usize] + length - self.at[from as usize]) % length
    }

    /// The cap of a directed chord, or of a boundary edge, which has nothing in it.
    fn cap(&self, edge: u32, from: u32) -> Option<&[u8]> {
        self.is_chord(edge).then(|| {
            let at = self.directed(edge, from) as usize * self.stride;
            &self.caps[at..at + self.stride]
        })
    }

    /// The least number at the other end with at most so many at this one.
    pub(super) fn least(&self, edge: u32, from: u32, at_most: u32) -> Option<u32> {
        let Some(cap) = self.cap(edge, from) else { return Some(0) };
        let least = cap[(at_most as usize).min(self.stride - 1)];
        (least != NONE).then_some(u32::from(least))
    }

    /// The corners and edges of a triangle from its corner `turn` on.
    fn turned(triangle: &Candidate, turn: u32) -> ([u32; 3], [u32; 3]) {
        let of = |list: [u32; 3]| [0, 1, 2].map(|i| list[(turn as usize + i) % 3]);
        (of(triangle.corners), of(triangle.edges))
    }

    fn find_roots(&self) -> Vec<Root> {
        let mut roots = Vec::new();
        for (index, triangle) in (0..).zip(&self.face.triangles) {
            let [a, b, c] = triangle.corners;
            let [ring, of_b, of_c] = triangle.corners.map(|v| self.ring_of[v as usize]);
            if of_b != ring || of_c != ring {
                continue;
            }
            if self.along(a, b) + self.along(b, c) + self.along(c, a) != self.lengths[ring as usize]
            {
                continue;
            }
            for turn in 0..3 {
                let ([a, b, _], [ab, ..]) = Self::turned(triangle, turn);
                if self.is_chord(ab) {
                    let (length, chord) = (self.along(b, a), self.directed(ab, a));
                    roots.push(Root { length, chord, triangle: index, turn });
                }
            }
        }
        roots.sort_unstable();
        roots
    }

    /// The number of chords at a and at b that a triangle a, b, c leaves within the cap of a to b, for each number at a in the cap
    /// of a to c.
    pub(super) fn divided(&self, root: &Root) -> impl Iterator<Item = [u32; 4]> + '_ {
        let ([a, b, c], [_, bc, ca]) = self.corners(root);
        let [is_bc, is_ca] = [bc, ca].map(|edge| u32::from(self.is_chord(edge)));
        (0..self.stride as u32).filter_map(move |x| {
            let y = self.least(ca, a, x)?;
            let left = self.most[c as usize].checked_sub(y + is_ca + is_bc)?;
            let end = self.least(bc, c, left)?;
            let (at_a, at_b) = (x + is_ca, end + is_bc);
            // The root is a chord, too.
            let fits = at_a < self.most[a as usize] && at_b < self.most[b as usize];
            fits.then_some([at_a, at_b, x, left])
        })
    }

    pub(super) fn corners(&self, root: &Root) -> ([u32; 3], [u32; 3]) {
        Self::turned(&self.face.triangles[root.triangle as usize], root.turn)
    }

    fn fill_caps(&mut self) {
        let roots = std::mem::take(&mut self.roots);
        for same in roots.chunk_by(|a, b| a.chord == b.chord) {
            let mut cap = vec![NONE; self.stride];
            for [at_a, at_b, ..] in same.iter().flat_map(|root| self.divided(root)) {
                let least = &mut cap[at_a as usize];
                *least = (*least).min(at_b as u8);
            }
            for x in 1..cap.len() {
                cap[x] = cap[x].min(cap[x - 1]);
            }
            let at = same[0].chord as usize * self.stride;
            self.caps[at..at + self.stride].copy_from_slice(&cap);
        }
        self.roots = roots;
    }

    fn find_steps(&mut self) {
        for (index, triangle) in (0..).zip(&self.face.triangles) {
            let outer = triangle.corners.map(|v| self.is_outer(v));
            let count = outer.iter().filter(|outer| **outer).count();
            if count == 0 || count == 3 {
                continue;
            }
            // The first corner is on the outer ring and the second on that of the hole.
            let turn = (0..3).find(|&turn| outer[turn] && !outer[(turn + 1) % 3]);
            let Some(turn) = turn else { continue };
            let ([o, i, third], [oi, beside_i, beside_o]) = Self::turned(triangle, turn as u32);
            let is_inner = count == 1;
            let (to, edge, passed, from) = if is_inner {
                (beside_o, beside_i, self.along(i, third), third)
            } else {
                (beside_i, beside_o, self.along(third, o), o)
            };
            let cap = self.is_chord(edge).then(|| self.directed(edge, from));
            if cap.is_some_and(|cap| self.caps[(cap as usize + 1) * self.stride - 1] == NONE) {
                continue;
            }
            self.steps[oi as usize].push(Step { to, is_inner, passed, cap, triangle: index });
        }
    }
}
