//! The mesh that the optimiser works on: arrays of triangles and neighbours, with an undo log.
//!
//! # Invariants
//!
//! 1. Triangles are counter-clockwise; a dead one has [`NONE`] as its first vertex.
//! 2. `neighbours[i]` lies across the edge opposite `vertices[i]`, and knows this triangle in turn; [`NONE`]
//!    marks a boundary edge.
//! 3. `locked` has bit i if the edge opposite vertex i is fixed; both triangles agree.
//! 4. `anchor` of a vertex is one of its triangles, or [`NONE`] if it is dead;
//!    `triangles` is their number.
//! 5. The triangles at a vertex form one fan: closed inside, open at the boundary.
//!
//! [`check`](ArrayMesh::check) tests them all; [`replace`](ArrayMesh::replace) tests what it touched in debug builds.

use crate::goal::Goal;
use glam::DVec2;

/// No triangle, no vertex.
pub(crate) const NONE: u32 = u32::MAX;

/// The operations that a vertex allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// On the boundary: stays.
    Boundary,
    /// Inside, but wanted by the user: stays.
    Fixed,
    /// Inside: may move and go.
    Free,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vertex {
    pub(crate) at: DVec2,
    /// The wanted edge length here.
    pub(crate) size: f64,
    pub(crate) anchor: u32,
    /// The index of a boundary vertex's goal.
    pub(crate) goal: u32,
    pub(crate) triangles: u32,
    pub(crate) kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Triangle {
    pub(crate) vertices: [u32; 3],
    pub(crate) neighbours: [u32; 3],
    pub(crate) locked: u8,
}

impl Triangle {
    pub(crate) fn is_alive(&self) -> bool {
        self.vertices[0] != NONE
    }

    /// Where `vertex` is among the three.
    pub(crate) fn corner(&self, vertex: u32) -> usize {
        if self.vertices[0] == vertex {
            0
        } else if self.vertices[1] == vertex {
            1
        } else {
            2
        }
    }
}

/// One write, with what was there before.
#[derive(Debug, Clone, Copy)]
enum Change {
    Triangle(u32, Triangle),
    Vertex(u32, Vertex),
    NewTriangle,
    NewVertex,
}

/// The triangles, the vertices, and the way back.
#[derive(Debug, Clone, Default)]
pub(crate) struct ArrayMesh {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) triangles: Vec<Triangle>,
    pub(crate) goals: Vec<Goal>,
    log: Vec<Change>,
    is_recording: bool,
}

/// An edge of a cavity's rim, seen from inside the cavity.
#[derive(Debug, Clone, Copy)]
struct Rim {
    from: u32,
    to: u32,
    neighbour: u32,
    is_locked: bool,
}

impl ArrayMesh {
    /// Links triangles into a mesh.
    ///
    /// `locked` are edges that must stay. Fails with a vertex where the triangles do not
    /// form one fan, or with an edge that two triangles use in one direction.
    pub(crate) fn new(
        vertices: Vec<Vertex>,
        triangles: &[[u32; 3]],
        goals: Vec<Goal>,
        locked: &[[u32; 2]],
    ) -> Result<Self, String> {
        let triangles = triangles
            .iter()
            .map(|t| Triangle { vertices: *t, neighbours: [NONE; 3], locked: 0 })
            .collect();
        let mut mesh = Self { vertices, triangles, goals, log: Vec::new(), is_recording: false };
        mesh.link()?;
        mesh.anchor()?;
        for [a, b] in locked {
            mesh.lock(*a, *b)?;
        }
        Ok(mesh)
    }

    fn link(&mut self) -> Result<(), String> {
        // Half-edges by their lower vertex, in lists: no hash map, no sorting.
        let count = self.vertices.len();
        let mut heads = vec![NONE; count];
        let mut nexts = vec![NONE; 3 * self.triangles.len()];
        for half in 0..nexts.len() as u32 {
            let (from, to) = self.ends(half);
            let mut other = heads[from.min(to) as usize];
            while other != NONE {
                let ends = self.ends(other);
                if ends == (from, to) {
                    return Err(format!("two triangles use edge {from}-{to} in one direction"));
                }
                if ends == (to, from) {
                    let (t, i) = (half as usize / 3, half as usize % 3);
                    let (u, j) = (other as usize / 3, other as usize % 3);
                    self.triangles[t].neighbours[i] = u as u32;
                    self.triangles[u].neighbours[j] = t as u32;
                }
                other = nexts[other as usize];
            }
            nexts[half as usize] = heads[from.min(to) as usize];
            heads[from.min(to) as usize] = half;
        }
        Ok(())
    }

    /// The directed edge opposite corner `half % 3` of triangle `half / 3`.
    fn ends(&self, half: u32) -> (u32, u32) {
        let vertices = self.triangles[half as usize / 3].vertices;
        let corner = half as usize % 3;
        (vertices[(corner + 1) % 3], vertices[(corner + 2) % 3])
    }

    fn anchor(&mut self) -> Result<(), String> {
        for (t, triangle) in (0..).zip(&self.triangles) {
            for v in triangle.vertices {
                self.vertices[v as usize].anchor = t;
                self.vertices[v as usize].triangles += 1;
            }
        }
        let mut star = Vec::new();
        for v in 0..self.vertices.len() as u32 {
            let vertex = self.vertices[v as usize];
            if vertex.anchor == NONE {
                continue;
            }
            self.star(v, &mut star);
            if star.len() as u32 != vertex.triangles {
                return Err(format!("the triangles at vertex {v} form more than one fan"));
            }
        }
        Ok(())
    }

    /// Makes an edge stay; an error if it is not there.
    pub(crate) fn lock(&mut self, a: u32, b: u32) -> Result<(), String> {
        let mut star = Vec::new();
        self.star(a, &mut star);
        let mut found = false;
        for t in star {
            let triangle = &mut self.triangles[t as usize];
            if triangle.vertices.contains(&b) {
                let corner = (0..3).find(|i| ![a, b].contains(&triangle.vertices[*i]));
                triangle.locked |= 1 << corner.unwrap_or(0);
                found = true;
            }
        }
        if found { Ok(()) } else { Err(format!("edge {a}-{b} is missing")) }
    }

    pub(crate) fn at(&self, vertex: u32) -> DVec2 {
        self.vertices[vertex as usize].at
    }

    pub(crate) fn corners(&self, triangle: u32) -> [DVec2; 3] {
        self.triangles[triangle as usize].vertices.map(|v| self.at(v))
    }

    /// The triangles at a vertex, counter-clockwise, from the boundary if it has one. True if closed.
    pub(crate) fn star(&self, vertex: u32, out: &mut Vec<u32>) -> bool {
        out.clear();
        let start = self.vertices[vertex as usize].anchor;
        let mut at = start;
        loop {
            out.push(at);
            let triangle = &self.triangles[at as usize];
            at = triangle.neighbours[(triangle.corner(vertex) + 1) % 3];
            if at == start {
                return true;
            }
            if at == NONE {
                break;
            }
        }
        // The rest of an open fan, from the start backwards.
        let forward = out.len();
        at = start;
        loop {
            let triangle = &self.triangles[at as usize];
            at = triangle.neighbours[(triangle.corner(vertex) + 2) % 3];
            if at == NONE {
                break;
            }
            out.push(at);
        }
        out[forward..].reverse();
        out.rotate_left(forward);
        false
    }

    /// From now on writes are kept, to be undone.
    pub(crate) fn record(&mut self) {
        self.is_recording = true;
    }

    /// A place in the log to go back to.
    pub(crate) fn mark(&self) -> usize {
        self.log.len()
    }

    /// Takes back all writes since `mark`, the last first.
    pub(crate) fn undo(&mut self, mark: usize) {
        while self.log.len() > mark {
            match self.log.pop() {
                Some(Change::Triangle(t, before)) => self.triangles[t as usize] = before,
                Some(Change::Vertex(v, before)) => self.vertices[v as usize] = before,
                Some(Change::NewTriangle) => drop(self.triangles.pop()),
                Some(Change::NewVertex) => drop(self.vertices.pop()),
                None => {}
            }
        }
    }

    /// Keeps all writes for good and stops recording.
    pub(crate) fn commit(&mut self) {
        self.log.clear();
        self.is_recording = false;
    }

    fn keep_triangle(&mut self, triangle: u32) {
        if self.is_recording {
            self.log.push(Change::Triangle(triangle, self.triangles[triangle as usize]));
        }
    }

    fn keep_vertex(&mut self, vertex: u32) {
        if self.is_recording {
            self.log.push(Change::Vertex(vertex, self.vertices[vertex as usize]));
        }
    }

    pub(crate) fn move_to(&mut self, vertex: u32, at: DVec2) {
        self.keep_vertex(vertex);
        self.vertices[vertex as usize].at = at;
    }

    /// A new free vertex, to be used by the next [`replace`](Self::replace).
    pub(crate) fn push_vertex(&mut self, at: DVec2, size: f64) -> u32 {
        self.vertices.push(Vertex {
            at,
            size,
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind: Kind::Free,
        });
        if self.is_recording {
            self.log.push(Change::NewVertex);
        }
        self.vertices.len() as u32 - 1
    }

    /// Replaces connected triangles by others that fill the same cavity.
    ///
    /// The caller has made sure that `added` has the rim of `removed`, and that no locked edge lies between removed
    /// triangles ([`has_lock`](Self::has_lock)). New triangles get indices at the end.
    pub(crate) fn replace(&mut self, removed: &[u32], added: &[[u32; 3]]) {
        let mut rim = Vec::with_capacity(removed.len() + 2);
        for t in removed {
            let triangle = self.triangles[*t as usize];
            for i in 0..3 {
                let neighbour = triangle.neighbours[i];
                if neighbour == NONE || !removed.contains(&neighbour) {
                    rim.push(Rim {
                        from: triangle.vertices[(i + 1) % 3],
                        to: triangle.vertices[(i + 2) % 3],
                        neighbour,
                        is_locked: triangle.locked >> i & 1 == 1,
                    });
                }
            }
        }
        for t in removed {
            self.keep_triangle(*t);
            for v in self.triangles[*t as usize].vertices {
                self.keep_vertex(v);
                let vertex = &mut self.vertices[v as usize];
                vertex.triangles -= 1;
                vertex.anchor = NONE;
            }
            self.triangles[*t as usize] =
                Triangle { vertices: [NONE; 3], neighbours: [NONE; 3], locked: 0 };
        }
        let first = self.triangles.len() as u32;
        for (t, vertices) in (first..).zip(added) {
            let mut triangle = Triangle { vertices: *vertices, neighbours: [NONE; 3], locked: 0 };
            for i in 0..3 {
                let (from, to) = (vertices[(i + 1) % 3], vertices[(i + 2) % 3]);
                if let Some(edge) = rim.iter().find(|edge| (edge.from, edge.to) == (from, to)) {
                    triangle.neighbours[i] = edge.neighbour;
                    triangle.locked |= u8::from(edge.is_locked) << i;
                    if edge.neighbour != NONE {
                        self.keep_triangle(edge.neighbour);
                        let other = &mut self.triangles[edge.neighbour as usize];
                        let corner = (0..3).find(|j| {
                            (other.vertices[(j + 1) % 3], other.vertices[(j + 2) % 3]) == (to, from)
                        });
                        debug_assert!(corner.is_some());
                        other.neighbours[corner.unwrap_or(0)] = t;
                    }
                } else {
                    let opposite = added.iter().position(|other| {
                        (0..3).any(|j| (other[(j + 1) % 3], other[(j + 2) % 3]) == (to, from))
                    });
                    debug_assert!(opposite.is_some(), "a new edge needs two triangles");
                    triangle.neighbours[i] = opposite.map_or(NONE, |u| first + u as u32);
                }
            }
            self.triangles.push(triangle);
            if self.is_recording {
                self.log.push(Change::NewTriangle);
            }
            for v in *vertices {
                self.keep_vertex(v);
                self.vertices[v as usize].anchor = t;
                self.vertices[v as usize].triangles += 1;
            }
        }
        // A vertex of the rim that lost its anchor has one again; others are gone.
        #[cfg(debug_assertions)]
        self.check_near(&rim.iter().map(|edge| edge.from).collect::<Vec<_>>());
    }

    /// True if a locked edge lies between two of the triangles.
    pub(crate) fn has_lock(&self, triangles: &[u32]) -> bool {
        triangles.iter().any(|t| {
            let triangle = &self.triangles[*t as usize];
            triangle.locked != 0
                && (0..3).any(|i| {
                    triangle.locked >> i & 1 == 1 && triangles.contains(&triangle.neighbours[i])
                })
        })
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::operations::{Cavity, operations};
    use crate::samples;
    use proptest::prelude::*;

    /// A square of 2 by 2 cells on each side, each cell cut in two, with a locked edge inside.
    pub(crate) fn grid(cells: u32) -> ArrayMesh {
        let across = cells + 1;
        let on_rim = |i: u32| i == 0 || i == cells;
        let vertex = |v: u32| Vertex {
            at: DVec2::new(f64::from(v % across), f64::from(v / across)),
            size: 1.0,
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind: match (
                on_rim(v % across) || on_rim(v / across),
                v == across + 1 || v == across + 2,
            ) {
                (true, _) => Kind::Boundary,
                (false, true) => Kind::Fixed,
                (false, false) => Kind::Free,
            },
        };
        let vertices = (0..across * across).map(vertex).collect();
        let triangles: Vec<[u32; 3]> = (0..cells * cells)
            .map(|cell| cell / cells * across + cell % cells)
            .flat_map(|v| [[v, v + 1, v + across + 1], [v, v + across + 1, v + across]])
            .collect();
        ArrayMesh::new(vertices, &triangles, Vec::new(), &[[across + 1, across + 2]]).unwrap()
    }

    proptest! {
        /// Whatever operations are done, the invariants hold, the locked edge stays, and undoing restores
        /// the mesh bit for bit.
        #[test]
        fn random_operations_keep_the_invariants(
            steps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..60),
        ) {
            let mut mesh = grid(5);
            let start = mesh.clone();
            mesh.record();
            let mut cavity = Cavity::default();
            let mut list = Vec::new();
            for (place, choice) in steps {
                let alive: Vec<u32> = (0..mesh.vertices.len() as u32)
                    .filter(|v| mesh.vertices[*v as usize].triangles > 0)
                    .collect();
                operations(&mesh, *place.get(&alive), true, &mut list);
                if list.is_empty() {
                    continue;
                }
                let operation = *choice.get(&list);
                let mark = mesh.mark();
                let before = mesh.clone();
                let is_done = cavity.open(&mesh, operation) && cavity.plan(&mut mesh, operation);
                if is_done {
                    cavity.carry_out(&mut mesh);
                }
                mesh.check().map_err(TestCaseError::fail)?;
                if !is_done {
                    mesh.undo(mark);
                    prop_assert_eq!(&mesh.triangles, &before.triangles);
                    prop_assert_eq!(&mesh.vertices, &before.vertices);
                }
                let area: f64 = (0..mesh.triangles.len() as u32)
                    .filter(|t| mesh.triangles[*t as usize].is_alive())
                    .map(|t| crate::triangle::doubled_area(mesh.corners(t)))
                    .sum();
                prop_assert!((area - 50.0).abs() < 1e-9);
                let locked = mesh.triangles.iter().filter(|t| t.is_alive() && t.locked != 0).count();
                prop_assert_eq!(locked, 2);
            }
            mesh.undo(0);
            prop_assert_eq!(&mesh.triangles, &start.triangles);
            prop_assert_eq!(&mesh.vertices, &start.vertices);
        }
    }

    #[test]
    fn stars_are_counter_clockwise_and_begin_at_the_boundary() {
        let mesh = grid(3);
        let mut star = Vec::new();
        for v in 0..16 {
            let is_closed = mesh.star(v, &mut star);
            assert_eq!(is_closed, mesh.vertices[v as usize].kind != Kind::Boundary);
            for pair in star.windows(2) {
                let triangle = mesh.triangles[pair[0] as usize];
                assert_eq!(triangle.neighbours[(triangle.corner(v) + 1) % 3], pair[1]);
            }
        }
    }

    #[test]
    fn the_sample_outline_has_boundary_angles() {
        let outline = samples::plate_with_hole();
        let total: f64 = (0..outline.vertex_count()).map(|v| outline.angle(v)).sum();
        // Rings of n and m vertices: (n - 2) pi inside the outer one, (m + 2) pi round the hole.
        assert!((total / std::f64::consts::PI - 92.0).abs() < 1e-9);
    }
}
