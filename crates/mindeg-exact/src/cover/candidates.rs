//! The candidates of a face: the chords and triangles that its triangulations may have.

use crate::chords::Lists;
use crate::fill::LoopProblem;
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
    pub(super) edges: [u32; 3],
}

/// The chords and triangles that the triangulations of a face may have.
#[derive(Clone, Debug)]
pub(super) struct Candidates {
    /// For each vertex of the face that of the whole.
    pub(super) vertices: Vec<u32>,
    pub(super) points: Vec<DVec2>,
    /// The smaller end first, ascending.
    pub(super) chords: Vec<[u32; 2]>,
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
        let rings = rings(points, &next);
        let holes: Vec<Ring> = rings.iter().skip(1).map(|ring| Ring::new(points, ring)).collect();
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
    /// The face with some of its triangles alone, as far as these may be in a triangulation.
    pub(super) fn among(&self, is_taken: impl Fn(&Candidate) -> bool) -> Self {
        let triangles = self.triangles.iter().filter(|triangle| is_taken(triangle)).copied();
        let face = Self {
            vertices: self.vertices.clone(),
            points: self.points.clone(),
            chords: self.chords.clone(),
            triangles: triangles.collect(),
            chord_count: self.chord_count,
        };
        face.pruned()
    }

    /// Without the triangles at a chord that has none on its other side, until there is none.
    pub(super) fn pruned(mut self) -> Self {
        let (chords, count) = (&self.chords, self.chords.len());
        let sides = |triangle: &Candidate| {
            let sides = triangle.edges.into_iter().zip(triangle.corners);
            sides.filter(|(edge, _)| (*edge as usize) < count)
        };
        loop {
            let mut is_beside = vec![[false; 2]; count];
            for (edge, from) in self.triangles.iter().flat_map(sides) {
                let [low, _] = chords[edge as usize];
                is_beside[edge as usize][usize::from(from != low)] = true;
            }
            let before = self.triangles.len();
            self.triangles.retain(|triangle| {
                sides(triangle).all(|(edge, _)| is_beside[edge as usize] == [true; 2])
            });
            if self.triangles.len() == before {
                return self;
            }
        }
    }

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

/// The vertices of each ring in the direction of the boundary: the outer one first, which has the leftmost vertex.
pub(super) fn rings(points: &[DVec2], next: &[u32]) -> Vec<Vec<u32>> {
    let order = |a: &usize, b: &usize| {
        let [a, b] = [a, b].map(|&v| points[v]);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    };
    let leftmost = (0..points.len()).min_by(order);
    let mut is_seen = vec![false; points.len()];
    let mut rings = Vec::new();
    for start in leftmost.into_iter().chain(0..points.len()) {
        let mut ring = Vec::new();
        let mut vertex = start;
        while !is_seen[vertex] {
            is_seen[vertex] = true;
            ring.push(vertex as u32);
            vertex = next[vertex] as usize;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    rings
}

impl Ring {
    fn new(points: &[DVec2], ring: &[u32]) -> Self {
        let all = || ring.iter().map(|&vertex| points[vertex as usize]);
        Self {
            some: ring.iter().take(4).copied().collect(),
            low: all().fold(DVec2::INFINITY, DVec2::min),
            high: all().fold(DVec2::NEG_INFINITY, DVec2::max),
        }
    }

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
