//! The rows: lists of literals of which at least so many and at most so many hold.
//!
//! - On a boundary edge lies exactly one triangle.
//! - On either side of a chord lies exactly one triangle, or the chord is not used.
//! - A vertex has no more chords than its limit leaves.

use super::candidates::{Candidate, Candidates};
use super::decision::{Element, Literal};
use crate::chords::Lists;
use crate::measure::min_angle_tangent;
use mindeg_mesh::planar::orientation;

/// A literal as an integer: twice its variable, and one more if it is negated.
pub(super) type Code = u32;

/// Variables, of chords and then of triangles, and the rows that they keep.
pub(super) struct Rows<'a> {
    faces: &'a [Candidates],
    /// The first chord and the first triangle of each face.
    first_chords: Vec<u32>,
    first_triangles: Vec<u32>,
    /// The number of variables of chords.
    pub(super) chords: u32,
    /// The triangles with variables: their face and index.
    triangles: Vec<[u32; 2]>,
    /// Where the literals of each row begin.
    starts: Vec<u32>,
    literals: Vec<Code>,
    /// How many literals of each row hold, at least and at most.
    bounds: Vec<[u32; 2]>,
}

impl<'a> Rows<'a> {
    pub(super) fn new(
        faces: &'a [Candidates],
        most_chords: &[u32],
        least_tangents: &[f64],
    ) -> Self {
        let mut first_chords = vec![0];
        let mut first_triangles = Vec::new();
        for face in faces {
            first_chords.push(first_chords[first_chords.len() - 1] + face.chords.len() as u32);
        }
        let chords = first_chords[faces.len()];
        let mut triangles = Vec::new();
        for (index, (face, &least)) in (0..).zip(faces.iter().zip(least_tangents)) {
            first_triangles.push(chords + triangles.len() as u32);
            let is_wide = |triangle: &Candidate| {
                least <= 0.0
                    || min_angle_tangent(triangle.corners.map(|v| face.points[v as usize])) >= least
            };
            let wide = (0..).zip(&face.triangles).filter(|(_, triangle)| is_wide(triangle));
            triangles.extend(wide.map(|(triangle, _)| [index, triangle]));
        }
        first_triangles.push(chords + triangles.len() as u32);
        let mut rows = Self {
            faces,
            first_chords,
            first_triangles,
            chords,
            triangles,
            starts: vec![0],
            literals: Vec::new(),
            bounds: Vec::new(),
        };
        (0..faces.len()).for_each(|face| rows.add_edges(face));
        rows.add_vertices(most_chords);
        rows
    }

    /// The rows of the edges of a face.
    fn add_edges(&mut self, face: usize) {
        let Candidates { points, chords, triangles, .. } = &self.faces[face];
        let row_of = |triangle: &Candidate, edge: usize| {
            let index = triangle.edges[edge] as usize;
            let is_upward = triangle.corners[edge] < triangle.corners[(edge + 1) % 3];
            if index < chords.len() {
                2 * index + usize::from(is_upward)
            } else {
                2 * chords.len() + index - chords.len()
            }
        };
        let own =
            self.first_triangles[face] - self.chords..self.first_triangles[face + 1] - self.chords;
        let own = &self.triangles[own.start as usize..own.end as usize];
        // First the number of triangles of every row, then the triangles.
        let rows = 2 * chords.len() + points.len();
        let mut counts = vec![0; rows];
        for &[_, triangle] in own {
            (0..3).for_each(|edge| counts[row_of(&triangles[triangle as usize], edge)] += 1);
        }
        let mut lists = Lists::<Code>::new(&counts);
        for (variable, &[_, triangle]) in (self.first_triangles[face]..).zip(own) {
            for edge in 0..3 {
                lists.push(row_of(&triangles[triangle as usize], edge) as u32, 2 * variable);
            }
        }
        for row in 0..rows as u32 {
            self.literals.extend(lists.of(row));
            if (row as usize) < 2 * chords.len() {
                self.literals.push(2 * (self.first_chords[face] + row / 2) + 1);
            }
            self.end_row([1, 1]);
        }
    }

    /// The rows of vertices that may have more chords than their limit leaves.
    fn add_vertices(&mut self, most_chords: &[u32]) {
        let mut counts = vec![0; most_chords.len()];
        let chords = || {
            (0_u32..).zip(self.faces.iter().flat_map(|face| {
                face.chords.iter().map(|chord| chord.map(|end| face.vertices[end as usize]))
            }))
        };
        for (_, ends) in chords() {
            ends.iter().for_each(|&end| counts[end as usize] += 1);
        }
        let mut lists = Lists::<Code>::new(&counts);
        for (variable, ends) in chords() {
            ends.iter().for_each(|&end| lists.push(end, 2 * variable));
        }
        for (vertex, (&count, &most)) in (0..).zip(counts.iter().zip(most_chords)) {
            if count > most {
                self.literals.extend(lists.of(vertex));
                self.end_row([0, most]);
            }
        }
    }

    fn end_row(&mut self, bounds: [u32; 2]) {
        self.starts.push(self.literals.len() as u32);
        self.bounds.push(bounds);
    }

    pub(super) fn variable_count(&self) -> usize {
        self.chords as usize + self.triangles.len()
    }

    pub(super) fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    pub(super) fn row_count(&self) -> usize {
        self.bounds.len()
    }

    pub(super) fn literals(&self, row: u32) -> &[Code] {
        let row = row as usize;
        &self.literals[self.starts[row] as usize..self.starts[row + 1] as usize]
    }

    /// How many literals of a row hold, at least and at most.
    pub(super) fn bounds(&self, row: u32) -> [u32; 2] {
        self.bounds[row as usize]
    }

    /// A literal in words of the face.
    pub(super) fn literal(&self, code: Code) -> Literal {
        let variable = code / 2;
        let is_used = code.is_multiple_of(2);
        if variable < self.chords {
            let face = self.first_chords.partition_point(|&first| first <= variable) - 1;
            let chord = self.faces[face].chords[(variable - self.first_chords[face]) as usize];
            return Literal { face: face as u32, element: Element::Chord(chord), is_used };
        }
        let [face, triangle] = self.triangles[(variable - self.chords) as usize];
        let corners = self.faces[face as usize].triangles[triangle as usize].corners;
        Literal { face, element: Element::Triangle(corners), is_used }
    }

    /// The chords that cross one.
    pub(super) fn crossing(&self, variable: u32) -> Vec<u32> {
        let face = self.first_chords.partition_point(|&first| first <= variable) - 1;
        let Candidates { points, chords, .. } = &self.faces[face];
        let first = self.first_chords[face];
        let [a, b] = chords[(variable - first) as usize];
        let [p, q] = [a, b].map(|v| points[v as usize]);
        let (low, high) = (p.min(q), p.max(q));
        let side = |v: u32| orientation(p, q, points[v as usize]) > 0.0;
        let crosses = |&[c, d]: &[u32; 2]| {
            if c == a || c == b || d == a || d == b {
                return false;
            }
            let [r, s] = [c, d].map(|v| points[v as usize]);
            if r.min(s).cmpgt(high).any() || r.max(s).cmplt(low).any() {
                return false;
            }
            side(c) != side(d) && (orientation(r, s, p) > 0.0) != (orientation(r, s, q) > 0.0)
        };
        (first..).zip(chords).filter(|(_, chord)| crosses(chord)).map(|(it, _)| it).collect()
    }

    /// The variables of the chords and triangles that given triangles of each face have.
    pub(super) fn variables_of(&self, start: &[Vec<[u32; 3]>]) -> Vec<u32> {
        let mut variables = Vec::new();
        for (face, triangles) in start.iter().enumerate().take(self.faces.len()) {
            let Candidates { chords, triangles: candidates, .. } = &self.faces[face];
            for corners in triangles {
                let least = (0..3).min_by_key(|&corner| corners[corner]).unwrap_or(0);
                let corners: [u32; 3] = std::array::from_fn(|corner| corners[(corner + least) % 3]);
                for edge in 0..3 {
                    let [a, b] = [corners[edge], corners[(edge + 1) % 3]];
                    if let Ok(chord) = chords.binary_search(&[a.min(b), a.max(b)]) {
                        variables.push(self.first_chords[face] + chord as u32);
                    }
                }
                let own = self.first_triangles[face]..self.first_triangles[face + 1];
                let with = &self.triangles
                    [(own.start - self.chords) as usize..(own.end - self.chords) as usize];
                // Candidates ascend by their first corner.
                let from = with
                    .partition_point(|&[_, it]| candidates[it as usize].corners[0] < corners[0]);
                let at = with[from..]
                    .iter()
                    .take_while(|[_, it]| candidates[*it as usize].corners[0] == corners[0])
                    .position(|&[_, it]| candidates[it as usize].corners == corners);
                variables.extend(at.map(|at| own.start + (from + at) as u32));
            }
        }
        variables
    }

    /// The triangles of each face whose variables hold.
    pub(super) fn mesh(&self, holds: impl Fn(u32) -> bool) -> Vec<Vec<[u32; 3]>> {
        let mut mesh = vec![Vec::new(); self.faces.len()];
        for (variable, &[face, triangle]) in (self.chords..).zip(&self.triangles) {
            if holds(variable) {
                mesh[face as usize]
                    .push(self.faces[face as usize].triangles[triangle as usize].corners);
            }
        }
        mesh
    }
}
