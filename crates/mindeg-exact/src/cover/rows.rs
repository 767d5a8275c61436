//! The candidates of a face, and the rows: lists of literals of which at least so many and at most so many hold.
//!
//! - On a boundary edge lies exactly one triangle.
//! - On either side of a chord lies exactly one triangle, or the chord is not used.
//! - A vertex has no more chords than its limit leaves.

use super::decision::{Element, Literal};
use crate::chords::Lists;
use crate::fill::LoopProblem;
use crate::measure::min_angle_tangent;
use crate::problem::Problem;
use crate::progress::Stage;
use glam::DVec2;
use mindeg_mesh::Cancelled;
use mindeg_mesh::planar::orientation;

/// A triangle that a triangulation may have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    /// Its vertices, counter-clockwise from the smallest.
    pub(super) corners: [u32; 3],
    /// The edge from each of them to the next: a chord, or the number of chords and the vertex where the
    /// boundary edge begins.
    edges: [u32; 3],
}

/// The chords and triangles that the triangulations of a face may have.
#[derive(Clone, Debug)]
pub(super) struct Candidates {
    /// For each vertex of the face that of the whole.
    vertices: Vec<u32>,
    pub(super) points: Vec<DVec2>,
    /// The smaller end first, ascending.
    chords: Vec<[u32; 2]>,
    pub(super) triangles: Vec<Candidate>,
    /// The chords of every triangulation.
    pub(super) chord_count: u64,
}

/// Some vertices of a ring, of which a triangle has not all, and the box around all of them.
struct Ring {
    some: Vec<u32>,
    low: DVec2,
    high: DVec2,
}

impl Candidates {
    /// The candidates that these chords form; none if there are more triangles than `most`.
    pub(super) fn new(
        problem: &Problem,
        vertices: &[u32],
        chords: Vec<[u32; 2]>,
        most: usize,
        stage: &Stage<'_>,
    ) -> Result<Option<Self>, Cancelled> {
        let points = problem.points();
        let n = points.len();
        let next = problem.next();
        let holes = holes(points, &next);
        let boundary = (0..).zip(&next).map(|(from, &to)| [from.min(to), from.max(to)]);
        let boundary: Vec<[u32; 2]> = boundary.collect();
        // In a convex problem boundary edges are no chords; elsewhere nothing sees its neighbours.
        let is_edge = |chord: &[u32; 2]| {
            boundary[chord[0] as usize] != *chord && boundary[chord[1] as usize] != *chord
        };
        let chords: Vec<[u32; 2]> = chords.into_iter().filter(is_edge).collect();
        let mut counts = vec![0; n];
        let edges = || chords.iter().chain(&boundary);
        edges().for_each(|&[low, _]| counts[low as usize] += 1);
        // For each vertex the larger ends of its edges, and the edges.
        let mut up = Lists::<(u32, u32)>::new(&counts);
        (0..).zip(edges()).for_each(|(edge, &[low, high])| up.push(low, (high, edge)));
        up.sort();

        let edge_to = |edge: u32, from: u32, to: u32| {
            let of_boundary = edge as usize >= chords.len();
            !of_boundary || next[from as usize] == to
        };
        let mut triangles = Vec::new();
        let mut marks = vec![u32::MAX; n];
        for i in 0..n as u32 {
            stage.report(f64::from(i) / n as f64)?;
            up.of(i).iter().for_each(|&(j, edge)| marks[j as usize] = edge);
            for &(k, edge_ik) in up.of(i) {
                for &(j, edge_kj) in up.of(k) {
                    let edge_ij = marks[j as usize];
                    if edge_ij == u32::MAX {
                        continue;
                    }
                    let turn =
                        orientation(points[i as usize], points[k as usize], points[j as usize]);
                    let (corners, edges) = if turn > 0.0 {
                        ([i, k, j], [edge_ik, edge_kj, edge_ij])
                    } else {
                        ([i, j, k], [edge_ij, edge_kj, edge_ik])
                    };
                    let is_inside = |e: usize| edge_to(edges[e], corners[e], corners[(e + 1) % 3]);
                    if turn != 0.0
                        && (0..3).all(is_inside)
                        && !holes.iter().any(|hole| hole.is_in(points, corners))
                    {
                        triangles.push(Candidate { corners, edges });
                    }
                }
                if triangles.len() > most {
                    return Ok(None);
                }
            }
            up.of(i).iter().for_each(|&(j, _)| marks[j as usize] = u32::MAX);
        }
        Ok(Some(Self {
            vertices: vertices.to_vec(),
            points: points.to_vec(),
            chord_count: (n + 3 * holes.len()) as u64 - 3,
            chords,
            triangles,
        }))
    }
}

impl Candidates {
    /// The candidates of a loop in space, where every two vertices may be joined that are not excluded.
    pub(super) fn of_loop(problem: &LoopProblem, vertices: &[u32]) -> Self {
        let n = vertices.len() as u32;
        let is_chord = |i: u32, j: u32| {
            j - i > 1 && (i, j) != (0, n - 1) && !problem.is_excluded(i as usize, j as usize)
        };
        let ends = |i: u32| (i + 1..n).map(move |j| [i, j]);
        let chords: Vec<[u32; 2]> =
            (0..n).flat_map(ends).filter(|&[i, j]| is_chord(i, j)).collect();
        let edge = |i: u32, j: u32| match chords.binary_search(&[i, j]) {
            Ok(chord) => Some(chord as u32),
            Err(_) if j - i == 1 => Some(chords.len() as u32 + i),
            Err(_) => ((i, j) == (0, n - 1)).then_some(chords.len() as u32 + j),
        };
        let mut triangles = Vec::new();
        for [i, k] in (0..n).flat_map(ends) {
            let Some(first) = edge(i, k) else { continue };
            triangles.extend((k + 1..n).filter_map(|j| {
                Some(Candidate { corners: [i, k, j], edges: [first, edge(k, j)?, edge(i, j)?] })
            }));
        }
        Self {
            vertices: vertices.to_vec(),
            points: vec![DVec2::ZERO; vertices.len()],
            chord_count: u64::from(n) - 3,
            chords,
            triangles,
        }
    }
}

/// The rings around holes: all but the one with the leftmost vertex.
fn holes(points: &[DVec2], next: &[u32]) -> Vec<Ring> {
    let order = |a: &usize, b: &usize| {
        let [a, b] = [a, b].map(|&v| points[v]);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    };
    let leftmost = (0..points.len()).min_by(order);
    let mut is_seen = vec![false; points.len()];
    let mut rings = Vec::new();
    for start in leftmost.into_iter().chain(0..points.len()) {
        let mut ring = Ring { some: Vec::new(), low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        let mut vertex = start;
        while !is_seen[vertex] {
            is_seen[vertex] = true;
            ring.low = ring.low.min(points[vertex]);
            ring.high = ring.high.max(points[vertex]);
            if ring.some.len() < 4 {
                ring.some.push(vertex as u32);
            }
            vertex = next[vertex] as usize;
        }
        if !ring.some.is_empty() {
            rings.push(ring);
        }
    }
    rings.split_off(1)
}

impl Ring {
    /// Whether a triangle that no edge of the ring crosses contains it.
    fn is_in(&self, points: &[DVec2], corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| points[corner as usize]);
        if self.low.cmplt(a.min(b).min(c)).any() || self.high.cmpgt(a.max(b).max(c)).any() {
            return false;
        }
        let other = self.some.iter().find(|vertex| !corners.contains(vertex));
        other.is_some_and(|&vertex| {
            let point = points[vertex as usize];
            [[a, b], [b, c], [c, a]].iter().all(|&[from, to]| orientation(from, to, point) > 0.0)
        })
    }
}

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
